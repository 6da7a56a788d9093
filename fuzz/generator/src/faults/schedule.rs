//! Faults of schedules: their blocks, PSELECT with its files, and how main programs end.

use turnspec_oracle::vocabulary::Feature;

use super::Fault;
use crate::builder::Builder;
use crate::program::Line;

/// A file of the library and its lines.
type File = (&'static str, &'static [&'static str]);

/// A main program that is selected without fault.
const MAIN: File = ("FLT.MIN", &["M02"]);

/// Main programs in which something stays in force.
const MODAL: File = ("FLT.MIN", &["MODIN O3", "M02", "O3", "RTS"]);
const LEFT: File = ("FLT.MIN", &["G40 G41 G01 X50 Z100 F0.2", "Z80", "M02"]);
const RIGHT: File = ("FLT.MIN", &["G40 G42 G01 X50 Z100 F0.2", "Z80", "M30"]);
const CALLER: File = ("FLT.MIN", &["GOTO N2", "CALL O3", "N2 M02"]);

/// Blocks with the files that they need.
#[rustfmt::skip]
const BLOCKS: &[(Fault, &[File], &[&str])] = &[
    (Fault::ScheduleBlock, &[], &[
        "M08", "V2=1", "O100", "READ 0", "N701", "CALL O1", "G00 VSET V1=1", "RTS", "X5", "N702 G00 X5", "NOEX AB=1",
        "VSETV1=1", "PSELECTA", "ENDE", "$", "?",
    ]),
    (Fault::ScheduleBlock, &[], &["/VSET V1=1", "N703 /VSET V1=1", "/END", "/PSELECT", "/", "/GOTO N1"]),
    (Fault::ScheduleLeftSide, &[], &[
        "VSET V1=1 X=10", "VSET ABC=1", "VSET VDIN[1]=1", "VSET X5", "VSET SB=5", "VSET V1=1/0 DIA=2", "VSET VDIN=1",
    ]),
    (Fault::ScheduleRightSide, &[], &[
        "VSET V1=VDOUT[1]", "VSET V1=1 V2=VTOFX[VDOUT[1]]", "VSET VTOFX[VDOUT[2]]=1", "VSET VDOUT[VDOUT[1]]=0",
        "VSET VUACM[VDOUT[1]]='A'", "VSET V1=[1+VDOUT[9]]",
    ]),
    (Fault::FileWildcard, &[], &["PSELECT A*.MIN", "PSELECT ?", "PSELECT *,O1,,Q0", "PSELECT MD?:A", "PSELECT 1*"]),
    (Fault::FileNameMalformed, &[], &[
        "PSELECT ABCDEFGHIJKLMNOPQ.MIN", "PSELECT 1A.MIN", "PSELECT A.MI", "PSELECT M1:A", "PSELECT A.MINX", "PSELECT A_B",
        "PSELECT .", "PSELECT MD1:-A", "PSELECT A.B.C", "PSELECT A:B:C",
    ]),
    (Fault::FileNameMalformed, &[MAIN], &[
        "PSELECT FLT,,.SUB", "PSELECT ,,*", "PSELECT FLT,,1S.SUB", "PSELECT FLT,,S.SU", "PSELECT FLT,,MD1:",
        "PSELECT NONE,,S?", "PSELECT FLT,,A:S",
    ]),
    (Fault::FileMissing, &[], &["PSELECT NONE", "PSELECT FD0:A.MIN", "PSELECT ABCDEFGHIJKLMNOP.XYZ", "PSELECT NONE,O1,,Q=1/0"]),
    (Fault::FileMissing, &[MAIN], &["PSELECT FLT,,NONE", "PSELECT FLT.MIN,,FD1:FLT.MIN", "PSELECT FLT,,FLT,Q0"]),
    (Fault::ProgramMissing, &[("FLT.MIN", &["O0100", "M02"])], &["PSELECT FLT,O100", "PSELECT FLT,OX", "PSELECT FLT,O00100"]),
    (Fault::ProgramMissing, &[("FLT.MIN", &["(NOTHING YET)"])], &["PSELECT FLT", "PSELECT FLT,O1"]),
    (Fault::ProgramMissing, &[("FLT.MIN", &[])], &["PSELECT FLT.MIN,,,Q0"]),
    (Fault::ProgramMissing, &[("FLT.MIN", &["$FLT.MIN%", "%"])], &["PSELECT FLT"]),
    (Fault::ProgramDuplicate, &[("FLT.MIN", &["O1", "M02", "O1", "M30"])], &["PSELECT FLT,O1"]),
    (Fault::ProgramDuplicate, &[CALLER, ("FL2.SUB", &["O3", "RTS"]), ("FL3.SSB", &["O3", "RTS"])], &["PSELECT FLT,,FL2"]),
    (Fault::ProgramDuplicate, &[CALLER, ("FL2.MSB", &["O3", "RTS", "O3"])], &["PSELECT FLT"]),
    (Fault::MainEndMissing, &[("FLT.MIN", &["G00 X1 (M02)"])], &["PSELECT FLT", "PSELECT FLT,,NONE"]),
    (Fault::MainEndMissing, &[("FLT.MIN", &["O1", "G00 X1", "O2", "M02"])], &["PSELECT FLT,O1"]),
    (Fault::MainEndMissing, &[("FLT.MIN", &["M02 X1.2.3", "M=1+1", "OX 2", "M30"])], &["PSELECT FLT"]),
    (Fault::SubprogramRtsMissing, &[CALLER, ("FL2.SUB", &["O3", "CALL O4", "RTS", "O4", "G00 X5"])], &["PSELECT FLT,,FL2"]),
    (Fault::SubprogramRtsMissing, &[CALLER, ("FL2.MSB", &["O3", "M08 RTS", "RTS 5"])], &["PSELECT FLT", "PSELECT FLT,,,Q0"]),
    (Fault::SubprogramRtsMissing, &[("FLT.MIN", &["/MODIN O3", "M02", "O3", "M65"])], &["PSELECT FLT"]),
    (Fault::ProgramUnknown, &[("FLT.MIN", &["CALL O3", "M02"]), ("FL2.SUB", &["O3", "RTS"])], &["PSELECT FLT", "PSELECT FLT,,,Q2"]),
    (Fault::RepetitionsRange, &[MAIN], &[
        "PSELECT FLT,,,Q0", "PSELECT FLT,,,Q0.4", "PSELECT FLT,,,Q=9999.5", "PSELECT FLT,,,Q -1", "PSELECT FLT,,,Q=-1",
        "PSELECT FLT,,,Q10000", "PSELECT FLT,,,Q=99999999*999", "PSELECT FLT,,,Q [0]",
    ]),
    (Fault::DivisionByZero, &[MAIN], &["PSELECT FLT,,,Q=1/0", "VSET V1=1/0", "IF[1/0] N1"]),
    (Fault::EqualSignMissing, &[MAIN], &[
        "PSELECT FLT,,,Q[V1]", "PSELECT FLT,,,QV1", "PSELECT FLT,,,Q-1", "PSELECT FLT,,,Q+1", "PSELECT FLT,,,Q,",
        "PSELECT NONE,,,Q*", "PSELECT FLT,,,Q",
    ]),
    (Fault::Format, &[MAIN], &[
        "PSELECT FLT,,,Q1,", "PSELECT FLT V1=1", "PSELECT FLT,X", "PSELECT ,,,5", "PSELECT FLT,,,Q1 Q2", "PSELECT FLT FLT",
        "PSELECT FLT,100", "PSELECT FLT,O1 5", "PSELECT FLT,,,Q1.2.3 A", "PSELECT FLT,,,X1", "PSELECT FLT,,,Q=", "PSELECT FLT/",
    ]),
    (Fault::Format, &[], &["VSET", "VSET (A)", "VSET VUACM[1]=5", "VSET V1=", "VSET 5"]),
    (Fault::Format, &[], &["END V1=1", "END 5", "END X", "END (A) /"]),
    (Fault::StatementDelimiterMissing, &[], &["PSELECT,O100", "END=5", "PSELECT.MIN", "VSET[1]", "VSET=1", "END/", "PSELECT/A"]),
    (Fault::ProgramNameMalformed, &[MAIN], &["PSELECT FLT,O12345", "PSELECT FLT,O1A", "PSELECT NONE,O", "PSELECT FLT,O-1,,Q0"]),
    (Fault::ProgramNameReserved, &[MAIN], &["PSELECT FLT,OO1", "PSELECT NONE,OO,,Q"]),
    (Fault::Unspecified, &[("DAY2.SDF", &["END"])], &["PSELECT DAY2.SDF", "PSELECT DAY2.SDF,O1"]),
    (Fault::Unspecified, &[MODAL], &["PSELECT FLT"]),
    (Fault::Unspecified, &[LEFT], &["PSELECT FLT", "PSELECT FLT,,,Q2"]),
    (Fault::Unspecified, &[RIGHT], &["PSELECT FLT"]),
    (Fault::Unspecified, &[], &["IF [VDOUT[1] EQ 1] N1"]),
    (Fault::SequenceNameUnknown, &[], &["GOTO NX90", "IF[1] NX91", "N704 GOTO N"]),
    (Fault::NoProgramEnd, &[("FLT.MIN", &["GOTO N2", "M02", "N2 M65"])], &["PSELECT FLT"]),
    (Fault::ProgramNameMisplaced, &[("FLT.MIN", &["GOTO N2", "M02", "N2 M65", "O7", "M02"])], &["PSELECT FLT"]),
    (Fault::VariableReadOnly, &[], &["VSET VSIOX=1", "VSET VIRD[1]=1", "VSET VORD[2]=0"]),
    (Fault::UserAlarmB, &[], &["VSET VUACM[1]='BAR' VDOUT[992]=5", "VSET VDOUT[992]=1 V1=1"]),
    (Fault::LocalUndefined, &[], &["VSET V1=UND", "IF [UND] N1"]),
    (Fault::ScheduleEndMissing, &[], &["", "(A)", "VSET V1=1", "%"]),
];

impl Builder<'_, '_, '_> {
    /// Adds a block of a schedule with a fault; false when the set-up does not let it happen.
    pub(crate) fn schedule_fault(&mut self) -> bool {
        let mut names: Vec<Fault> = BLOCKS.iter().map(|(fault, ..)| *fault).collect();
        names.dedup();
        let fault = self.choices.pick(&names);
        let entries: Vec<_> = BLOCKS.iter().filter(|(name, ..)| *name == fault).collect();
        let (_, files, texts) = entries[self.choices.below(entries.len())];
        let text = self.choices.pick(texts);
        let of_file = |(_, lines): &File| lines.iter().all(|line| self.permits(line));
        if !self.permits(text) || !files.iter().all(of_file) {
            return false;
        }
        let mode = self.state.mode;
        if !self.profile.permits_text(text.as_bytes(), mode) || !self.allows(Feature::Alarm) {
            return false;
        }
        if !self.blocks(&[text]) {
            return false;
        }
        for (name, lines) in *files {
            let lines = lines.iter().map(|line| Line::Raw(line.as_bytes().to_vec())).collect();
            self.state.schedule.files.insert(name, lines);
        }
        self.state.schedule.endless = fault == Fault::ScheduleEndMissing;
        true
    }

    /// Whether tape code and profile have what a line is made of.
    fn permits(&self, line: &str) -> bool {
        !(self.state.is_eia() && super::lacks_codes(line))
            && self.profile.permits_text(line.as_bytes(), self.state.mode)
    }
}

//! Faults that need no particular state: texts against the grammar, the tables and the ranges.

use turnspec_oracle::vocabulary::TapeCode;

use super::Fault;
use super::statement::{STATEMENTS, is_statement};
use crate::builder::Builder;
use crate::codes;
use crate::tape::WRONG_PARITY;

/// Blocks that raise an alarm wherever they stand.
#[rustfmt::skip]
const TEXTS: &[(Fault, &[&str])] = &[
    (Fault::IllegalCharacter, &[
        "G00 x5", "G00 X5 &", "X5 ; REMARK", "X5 % Z3", "X5)", "X=5?", "V1='A'", "X=^1", "@", "M08 ~", "X5 \u{1}",
        "X5 \0", "M08 \"", "{", "X1 # 2", "%%",
    ]),
    (Fault::HeaderMalformed, &["$SHAFT.MIN", "$A%B", "$", "$SHAFT.MIN% X"]),
    (Fault::CommentUnclosed, &["G00 X5 (OPEN", "(", "M08 (A) (B", "N7(", "/ (OPEN"]),
    (Fault::ProgramNameMalformed, &["O", "OABCDE", "O12345", "O1A", ":", "O-1", "O 1"]),
    (Fault::ProgramNameReserved, &["OO12", "OO", ":O1"]),
    (Fault::ProgramNameNotAlone, &["O12 G00", "O1 X5", "N1 O5", "/O12", "OA/", "G00 O5"]),
    (Fault::ProgramNameMisplaced, &["O99", ":7", "OA (SECOND)"]),
    (Fault::SequenceNameMalformed, &["N", "N-5 G00", "N(1) X5", "N /X5", "N.5"]),
    (Fault::SequenceDelimiterMissing, &["N10G01", "N1234567", "NABCDEFG X1", "N1A G00", "N10-5", "N5=7"]),
    (Fault::SlashMisplaced, &["G00 / X5", "//G00", "/N7 / X5", "X5/2", "X5 /", "N8 //", "/N7/", "/ NA1 /M08"]),
    (Fault::Format, &[
        "X=", "5", "G00 +5", "X5(A)5", "X5\t5", "SIN[5]", "X=1 LT 2 LT 3", "G00 [5]", "X=G1", "X=SB", "EQ 5",
        "V5=GOTO", "X=5+", "V1=*5", "X=[]", "=5", "V1=", "X5 , Z3", "V1=1 AND", "X=2*", "NOT 5", "X=X",
    ]),
    (Fault::NumberMalformed, &[
        "G00 X", "X- Z5", "X1.2.3", "X.", "G0001", "G1.", "G-1", "G+1", "X=$", "X=$123456789", "X+-5", "X(A)5", "S",
        "F ", "X=.", "X= -", "M", "T\t5",
    ]),
    (Fault::TooManyDigits, &["X123456789", "F1.23456789", "X=1.23456789+1", "X000000001", "V1=123456789", "G000000001"]),
    (Fault::EqualSignMissing, &["X[5]", "SB100", "V5 X3", "X$FF", "PZ5", "QA 5", "VZOFX 5", "S[1+1]"]),
    (Fault::AddressUnknown, &["R5", "R10", "Y-3", "G02 X5 R5", "M08 Y"]),
    (Fault::OperatorBlankMissing, &[
        "V1=[1]EQ[1]", "V1=1 AND[2]", "V1=[1]OR 2", "X=1+NOT 5", "V2=NOT[5]", "X=5EQ 5", "V1=[1]EQ 1",
    ]),
    (Fault::FunctionBracketMissing, &["V1=SIN 30", "X=ABS", "V1=SQRT+4", "V1=MOD(A)5"]),
    (Fault::BracketUnbalanced, &[
        "V1=SIN[30", "V1=ATAN2[1]", "V1=[1+2", "V1=SIN[1,2]", "V1=MOD[5]", "V1=MOD[5,2,1]", "X=[[1]", "V1=SIN[]",
    ]),
    (Fault::VariableNumber, &["V0=1", "V201=1", "X=V0", "V1234=5", "V000=1", "X=V999"]),
    (Fault::SystemVariableUnknown, &["VABC=1", "V=5", "X=VNONE", "V5A=1", "V", "X=V", "VZOF=1"]),
    (Fault::VariableSuffix, &[
        "VTOFX=1", "VZOFX[1]=1", "VTOFX[97]=1", "X=VTOFX[-1]", "VPFVX[121]=0", "VPFVX[0]=0", "X=VPAI[1]",
        "VNSRZ[99999999*99999999]=1",
    ]),
    (Fault::VariableReadOnly, &["VSIOX=1", "VPAI=3", "VETON=1", "VRSTT=0", "VRUND=1", "VAPAZ=V1"]),
    (Fault::VariableRange, &[
        "VZOFX=99999999*100", "VTOFX[1]=99999999", "VTOFX[0]=1", "VPCHX=0", "VINPX=10001", "VCHKL=-1",
        "VPFVX[1]=99999", "VZSHZ=-99999999*100", "VPVLX=99999999*99999999", "VNSRX[0]=9", "VINPC=-1",
    ]),
    (Fault::DuplicateAddress, &["X1 X2", "G02 X1 Z2 CALRG L5 CALRG", "S5 M03 S6", "SB=1 SB=2", "F1 F1", "T1 T2"]),
    (Fault::TooManyM, &["M08 M15 M20 M22 M24 M26 M41 M48 M55", "M65 M66 M67 M68 M69 M70 M88 M89 M90 M91"]),
    (Fault::AddressRange, &[
        "C99999999", "C-99999999", "S65536", "M512", "QA=0", "QA=2000", "G29 PZ=101", "SA=0", "SB=65536", "H-1",
        "D-5", "X=99999999*999", "Z=-99999999*999", "F0", "F-1", "G04 F0", "G04 F1000000", "S-1", "M-1",
        "A=99999999*999", "E=99999999*999", "U-1", "G91 G22 Z50 D5 L-5 F1 PZ=5", "SA=99999999", "PW=0", "F=99999999*999",
        "G=-1", "G=1000",
    ]),
    (Fault::ToolNumber, &["T1000000", "T99", "T970101", "T-1", "T0198", "T=99999999*9"]),
    (Fault::AbsoluteAndIncremental, &["G90 G91", "G91 X1 G90"]),
    (Fault::GCodesConflict, &["G00 G01", "G04 G50 F1", "G01 X1 G01", "G94 G95", "G96 G97 S1", "G75 G76", "G64 G65", "G90 G90", "G22 G28"]),
    (Fault::MCodesConflict, &["M03 M04", "M08 M08", "M00 M02", "M41 M42", "M12 M13", "M65 M65", "M02 M30"]),
    (Fault::NotAlone, &["M110 G00", "M193 X5", "M195 S5", "M110 M08", "M196 M09", "V1=5 M110"]),
    (Fault::CuttingSpeedMissing, &["G96", "G97 M03", "G96 SB=5"]),
    (Fault::WordMissing, &[
        "G04", "G50", "G29", "G50 T0101", "G22 Z1 D1 F1 PZ=5", "G22 Z1 L1 F1 PZ=5", "G22 D1 L1 F1 PZ=5",
        "G22 Z5 D1 L1 F1", "G22 Z5 D1 L1 F1 PW=5",
    ]),
    (Fault::WordWithoutFunction, &[
        "D5", "H5", "B5", "E5", "U1", "G04 F1 X5", "G00 K5", "G28 X5", "G01 X1 L5 F1", "G00 CALRG", "G29 PZ=1 Z3",
        "G28 QA=5", "PZ=5", "G50 X1 K2",
    ]),
    (Fault::OffsetWithG50, &["G50 X5 T0101", "G50 Z1 S5 T01", "T2 G50 C1"]),
    (Fault::ChamferNotLinear, &["G00 G75 X5 L1", "G02 G76 X5 L1", "G03 X1 Z1 L5 G75"]),
    (Fault::AngleOverdetermined, &["G01 X1 Z2 A45 F1", "G00 Z1 A5 X2"]),
    (Fault::ArcRadiusAndCentre, &["G02 X5 Z5 L5 I1", "G03 X5 L5 K2"]),
    (Fault::ArcRadiusNotPositive, &["G03 X5 Z5 L0", "G02 X5 Z5 L-5"]),
    (Fault::ArcRadiusNeedsBoth, &["G02 X5 L5", "G03 Z5 L5 CALRG", "G02 L5"]),
    (Fault::ArcWithoutCentre, &["G02 X5 Z5", "G03 X1 Z1 I0 K0", "G02 Z5 K=0"]),
    (Fault::DivisionByZero, &["V1=1/0", "V1=MOD[5,0]", "X=1/[2-2]", "V1=V2/-0", "Z=5/0.0"]),
    (Fault::IntegerOverflow, &[
        "V1=$7FFFFFFF+1", "V1=-$80000000", "V1=ROUND[99999999*999]", "V1=99999999*99999 AND 1", "X=$80000000-1",
        "V1=NOT [99999999*99999999]", "V1=FUP[-99999999*99]",
    ]),
    (Fault::FunctionDomain, &["V1=SQRT[-1]", "V1=ATAN2[0,0]", "V1=BIN[$A]", "V1=BCD[-1]", "V1=BCD[99999999+1]", "X=SQRT[0-5]"]),
    (Fault::Unspecified, &[
        "G02 I5 F1", "G02 X5 Z5 I5 CALRG F1", "V1=VUNIT", "G91 G02 X0 Z0 I5 F1", "G91 G22 Z5 D10 L5 F1 PZ=5",
        "G91 G22 Z0 D1 L5 F1 PZ=5", "G94 G91 G22 Z50 D1 L5 F99999 PZ=5", "G95 G91 G22 Z50 D1 L5 F1 PZ=5",
    ]),
    (Fault::NotModelled, &[
        "P5", "Q5 X1", "G00 N5", "VZOFY=1", "V1=VTLCN[1]", "VMDT[1]=5", "BC=1",
    ]),
];

impl Builder<'_, '_, '_> {
    /// Adds a text with this fault.
    pub(super) fn text_fault(&mut self, fault: Fault) -> bool {
        match fault {
            Fault::ParityError => self.parity_fault(),
            Fault::BlockTooLong => self.long_block(),
            Fault::GCodeUnassigned => self.code_fault("G", codes::G_UNASSIGNED),
            Fault::MCodeUnassigned => self.code_fault("M", codes::M_UNASSIGNED),
            Fault::Unspecified if self.choices.chance(50) => self.code_fault("G", codes::G_UNSPECIFIED),
            Fault::NotModelled if self.choices.chance(60) => self.later(),
            _ => self.listed(fault),
        }
    }

    fn listed(&mut self, fault: Fault) -> bool {
        let list = |list: &[(Fault, &'static [&'static str])]| {
            list.iter().find(|(name, _)| *name == fault).map(|(_, texts)| *texts)
        };
        let (others, statements) = (list(TEXTS), list(STATEMENTS));
        let preferred = if self.choices.chance(60) { statements.or(others) } else { others.or(statements) };
        let Some(texts) = preferred else { return false };
        let text = self.choices.pick(texts);
        let before = !super::is_first(fault)
            && !text.starts_with(['N', '/', 'O', ':', '$'])
            && !is_statement(text)
            && self.choices.chance(20);
        let prefix = if before { self.choices.pick(&["M65 ", "(A) ", "H=1 "]) } else { "" };
        self.blocks(&[&format!("{prefix}{text}")])
    }

    /// A byte of wrong parity, in a comment, at the end or in a word.
    fn parity_fault(&mut self) -> bool {
        if self.state.setup.tape.code == TapeCode::Ascii {
            return false;
        }
        let text = self.choices.pick(&[b"G00 X#5".as_slice(), b"(A#)", b"#", b"M08 #", b"NA# /X5", b"/ #"]);
        let bytes: Vec<u8> =
            text.iter().map(|byte| if *byte == b'#' { WRONG_PARITY } else { *byte }).collect();
        self.raw(&bytes);
        true
    }

    /// A block of more than 158 characters: by a comment, by blanks, by words.
    fn long_block(&mut self) -> bool {
        // Often by one character.
        let more = if self.choices.chance(30) { 0 } else { self.choices.within(0, 60) as usize };
        let text = match self.choices.below(4) {
            0 => format!("M08 ({})", "A".repeat(153 + more)),
            1 => format!("X5{}", " ".repeat(157 + more)),
            2 => format!("({})", "LONG ".repeat(32 + more)),
            _ => format!("/M65{}Z5", "(REMARK)".repeat(20)),
        };
        self.blocks(&[&text])
    }

    fn code_fault(&mut self, letter: &str, codes: &[i64]) -> bool {
        let code = self.choices.pick(codes);
        self.blocks(&[&format!("{letter}{code:02}")])
    }

    /// An assigned code that is not modelled.
    fn later(&mut self) -> bool {
        self.code_fault("G", codes::G_LATER)
    }
}

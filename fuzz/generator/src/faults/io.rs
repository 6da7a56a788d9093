//! Faults of data communication, of inputs and outputs, of strings and user alarms.

use turnspec_oracle::vocabulary::{Feature, ProgramText, UserAlarmC};

use super::Fault;
use crate::builder::Builder;
use crate::io::{AREA, number_at};

/// Blocks that raise an alarm wherever they stand, those of one rule together.
#[rustfmt::skip]
const BLOCKS: &[(Fault, &[&str])] = &[
    (Fault::DeviceUnknown, &["READ 10", "N801 READ 99", "READ 00010"]),
    (Fault::DeviceUnknown, &["WRITE 10", "N802 WRITE 123456789", "WRITE 11 X"]),
    (Fault::FieldLength, &["GET V1,0", "GET ,161", "GET V1,", "GET V1,X", "GET ,0000", "GET ,(A)", "GET V1,99999999999"]),
    (Fault::FieldLength, &["PUT V1,0", "PUT ,161", "PUT V1,", "PUT ,", "PUT VPAI,000", "PUT V1,-5"]),
    (Fault::Format, &["READ", "READ X", "READ V1", "READ 0 G00", "READ -1", "READ 0,", "READ 1.", "READ 0/", "READ(A)"]),
    (Fault::Format, &["WRITE", "WRITE V1", "WRITE 0 V1=1", "WRITE 1.5", "WRITE 'A'", "WRITE $1"]),
    (Fault::Format, &["GET", "GET X,4", "GET 5", "GET SB,2", "GET V1,2 X5", "GET SIN[1],2", "GET V1 5", "GET V1+1", "GET 'A'"]),
    (Fault::Format, &["PUT V1", "PUT V1+1,4", "PUT X,3", "PUT 5", "PUT V1,2,", "PUT", "PUT CALRG,1", "PUT V1 (A)", "PUT ,5 5"]),
    (Fault::Format, &["PUT 'AB',2", "PUT 'AB", "PUT ''", "PUT '^'", "PUT ^$41", "PUT ^ 'A'", "PUT 'A' 'B'", "PUT ^''", "PUT 'A\n$B'"]),
    (Fault::Format, &["PUT $0D0A,2", "PUT $41 X5", "PUT $41 42", "PUT $41G"]),
    (Fault::Format, &[
        "VUACM[1]=5", "VUACM[1]='ABC", "VUACM[1]=''", "VUACM[1]=V1", "VUACM[1]=^5", "VUACM[1]=", "VUACM[1]='^'", "VUACM[1]=^ 'A'",
    ]),
    (Fault::VariableReadOnly, &["GET VSIOX,4", "GET VPAI", "GET VETON,99"]),
    (Fault::VariableReadOnly, &["GET VDIN[1],1", "VDIN[1]=1", "V2=5 VDIN[1]=1", "VDIN[99]=1/0"]),
    (Fault::VariableReadOnly, &["GET VIRD[1],1", "VORD[100]=1", "VIRD[0]=0", "GET VORD[1/0]"]),
    (Fault::Unspecified, &["V1=VDOUT[1]", "PUT VDOUT[1],1", "X=VDOUT[9]", "V1=VTOFX[VDOUT[1]]", "IF[VDOUT[1] EQ 1] N1"]),
    (Fault::Unspecified, &["GET VUACM[1],2", "PUT VUACM[1],4", "V2=1 V1=VUACM[1]", "IF[VUACM[1]] N1"]),
    (Fault::Unspecified, &["VUACM[1]='-L^K]'", "VUACM[99]='-'", "V1=1/0 VUACM[1]='-A'"]),
    (Fault::NumberMalformed, &["PUT $0D0", "PUT $", "PUT $4", "PUT $41414141414141414141414141414141414", "PUT $00000"]),
    (Fault::NumberMalformed, &["VUACM[1]='$414'", "VUACM[1]='$4142434445'", "VUACM[1]='$4G'", "VUACM[1]='$'", "VUACM[99]='$ 41'"]),
    (Fault::StringTooLong, &["PUT $4141414141414141414141414141414141", "PUT $0041414141414141414141414141414141"]),
    (Fault::StringTooLong, &["PUT 'TOOL OFFSET DATA '", "PUT ^'ABCDEFGHIJKLMNOPQ'", "PUT '^ABCDEFGHIJKLMNOPQ',3"]),
    (Fault::StringTooLong, &["VUACM[2]='(TOOL 12/B WORN)'", "VUACM[16]='AB'", "VUACM[1]='ABCDEFGHIJKLMNOPQ'", "VUACM[14]='$41424344'"]),
    (Fault::ForbiddenCode, &["PUT $4100", "PUT $25", "PUT $00", "PUT $252525"]),
    (Fault::IllegalCharacter, &["PUT 'Ab'", "PUT '100%'", "VUACM[1]='abc'", "PUT 'A\u{1}'", "PUT 'A\tB'", "VUACM[1]='A`'"]),
    (Fault::ScheduleStatement, &[
        "PSELECT A.MIN", "VSET V1=1", "END", "N803 END", "PSELECT,?", "VSET", "END 5", "/PSELECT", "CALL O1 END",
    ]),
    (Fault::VariableSuffix, &["V1=VDIN[20]", "V1=VDIN", "V1=VDIN[1251]", "X=VDIN[0]", "PUT VDIN[40],2", "V2=5 V1=VDIN+1"]),
    (Fault::VariableSuffix, &["VDOUT[10]=1/0", "VDOUT=1", "VDOUT[0]=1", "VDOUT[994]=1", "GET VDOUT[50],1", "VDOUT[-1]=0"]),
    (Fault::VariableSuffix, &["V1=VIRD[10000]", "V1=VORD", "V1=VORD[-1]", "PUT VIRD,1", "V1=VIRD[9999.5]"]),
    (Fault::VariableSuffix, &["VUACM[17]='A'", "VUACM[0.4]='A'", "VUACM='A'", "VUACM[-1]='$41'"]),
    (Fault::VariableSuffix, &["VTLD[97]=16", "VGRD[25]=1", "V1=VTLL[0]", "VTLIN=1", "PUT VTIZN[97],9", "GET VGRL[99],9"]),
    (Fault::VariableRange, &["VDOUT[1]=1.5", "VDOUT[1]=-0.5", "VDOUT[48]=99999999*99"]),
    (Fault::VariableRange, &["VDOUT[9]=256", "VDOUT[19]=-1", "VDOUT[49]=255.5"]),
    (Fault::VariableRange, &["VDOUT[993]=0", "VDOUT[992]=9999.5", "VDOUT[991]=-1", "VDOUT[993]=0.4"]),
    (Fault::VariableRange, &["VTLIN[1]=0", "VTLA2[1]=-99999999", "VTIPN[1]=3", "VGRFN[1]=-1", "VTLL[1]=99999999", "VGRIN[1]=38.5"]),
    (Fault::UserAlarmA, &["VDOUT[993]=12", "VUACM[1]='WORN' VDOUT[993]=1 V1=1/0", "VUACM[2]='A' VDOUT[992.5]=9999", "X5 VDOUT[993]=1"]),
    (Fault::UserAlarmB, &["VDOUT[992]=1", "VUACM[1]='$B65C' VDOUT[992]=7", "VUACM[1]=^'LOW -' VDOUT[992]=0.5"]),
    (Fault::UserTaskLevel, &["READ 0", "WRITE 1", "GET ,1", "PUT 'A'", "GET VTOFX[99],1", "PUT V1,1", "N804 PUT $41"]),
    (Fault::UserTaskLevel, &["V1=VDIN[1/0]", "X=VDIN[1]", "V1=0*VDIN[99]", "IF[VDIN[1]] N1"]),
    (Fault::UserTaskLevel, &["VDOUT[1/0]=1/0", "VDOUT[1]=1", "V1=1 VDOUT[992]=1"]),
];

/// Characters that form no number.
const NO_NUMBERS: &[&str] = &[
    "1.2.3",
    "1 ",
    "- 1",
    "123456789",
    "   ",
    "",
    "+-5",
    ".",
    "1E5",
    "A",
    "5-",
    "--5",
    "0.12345678",
    "1,5",
    "\t5",
    " . 5",
    "5\r",
    "\u{B6}",
];

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn io_fault(&mut self, fault: Fault) -> bool {
        if !crate::io::is_within(&self.profile) {
            return false;
        }
        let level_2 = self.state.setup.options.user_task == 2;
        let talks = level_2 && self.allows(Feature::Communication) && !self.state.control.is_shared();
        let stops = self.state.setup.readings.user_alarm_c == UserAlarmC::Stops;
        match fault {
            Fault::DeviceNoData if talks => self.silent_device(),
            Fault::ReadTooLong if talks => self.long_transmission(),
            Fault::ReadPointer if talks => self.short_transmission(),
            Fault::ReceivedNumber if talks => self.no_number(),
            Fault::WriteAreaFull if talks => self.full_area(),
            Fault::FieldTooSmall if talks => self.small_field(),
            Fault::UserAlarmC if stops && level_2 => {
                let text = self.choices.pick(&["VDOUT[991]=3", "VUACM[1]='SPARE' VDOUT[991]=9999.4 V1=1"]);
                self.blocks(&[text])
            }
            Fault::UserTaskLevel if level_2 || self.choices.chance(20) => false,
            // Most of these faults have other kinds too.
            Fault::Format if self.choices.chance(50) => false,
            Fault::Unspecified if self.choices.chance(75) => false,
            Fault::NumberMalformed
            | Fault::VariableSuffix
            | Fault::IllegalCharacter
            | Fault::VariableReadOnly
            | Fault::VariableRange
                if self.choices.chance(50) =>
            {
                false
            }
            _ => self.listed_io(fault),
        }
    }

    fn listed_io(&mut self, fault: Fault) -> bool {
        let lists: Vec<_> = BLOCKS.iter().filter(|(name, _)| *name == fault).collect();
        if lists.is_empty() {
            return false;
        }
        let (_, texts) = lists[self.choices.below(lists.len())];
        let text = self.choices.pick(texts);
        self.blocks(&[text])
    }

    /// A device, and how many texts it has left.
    fn some_device(&mut self) -> (usize, usize) {
        let channel = self.choices.below(10);
        let texts = self.state.setup.devices.get(&format!("CN{channel}")).map_or(0, Vec::len);
        (channel, texts.saturating_sub(self.state.io.taken[channel]))
    }

    /// READ of more texts than a device has.
    fn silent_device(&mut self) -> bool {
        let (channel, left) = self.some_device();
        let line = format!("READ {channel}");
        let lines = vec![line.as_str(); left.min(8) + 1];
        self.blocks(&lines)
    }

    /// READ of a text, which becomes the next one of a device.
    fn transmitted(&mut self, text: &[u8]) -> String {
        let channel = self.choices.below(10);
        let texts = self.state.setup.devices.entry(format!("CN{channel}")).or_default();
        let place = self.state.io.taken[channel].min(texts.len());
        texts.insert(place, ProgramText(text.to_vec()));
        format!("READ {channel}")
    }

    fn long_transmission(&mut self) -> bool {
        let more = 1 + self.choices.below(3);
        let mut text = vec![b'.'; AREA + more];
        if self.choices.chance(30) {
            text.push(b'%');
        }
        let read = self.transmitted(&text);
        self.blocks(&[&read])
    }

    /// A field that goes beyond what was read.
    fn short_transmission(&mut self) -> bool {
        let length = self.choices.below(AREA);
        let read = self.transmitted(&vec![b'7'; length]);
        let beyond =
            if self.choices.chance(60) { length + 1 } else { length + 1 + self.choices.below(AREA - length) };
        let target = if self.choices.chance(50) && self.allows(Feature::Variable) { "V9" } else { "" };
        let last = format!("GET {target},{beyond}");
        if length > 1 && self.choices.chance(30) {
            return self.blocks(&[&read, "GET ,1", &last]);
        }
        self.blocks(&[&read, &last])
    }

    /// A field that is no number.
    fn no_number(&mut self) -> bool {
        let text = self.choices.pick(NO_NUMBERS);
        let bytes: Vec<u8> = text.chars().map(|character| u8::try_from(character).unwrap_or(b'?')).collect();
        debug_assert!(number_at(&bytes).is_none_or(|(length, _)| length < bytes.len()));
        let read = self.transmitted(&bytes);
        let whole = bytes.is_empty() || self.choices.chance(60);
        let last = if whole { "GET V9".to_owned() } else { format!("GET V9,{}", bytes.len()) };
        if self.choices.chance(15) {
            return self.blocks(&[&read, &last, &last]);
        }
        self.blocks(&[&read, &last])
    }

    fn full_area(&mut self) -> bool {
        let lists: [&[&str]; 5] = [
            &["PUT ,160", "PUT ,1"],
            &["WRITE 0", "PUT ,160", "PUT 'A'"],
            &["WRITE 3", "PUT ,159", "PUT $4142"],
            &["WRITE 0", "PUT ,100", "PUT V199,61"],
            &["PUT ,160", "WRITE 0", "PUT ,160", "PUT ,160"],
        ];
        let lines = self.choices.pick(&lists);
        self.blocks(lines)
    }

    fn small_field(&mut self) -> bool {
        let lists: [&[&str]; 6] = [
            &["V9=12.25", "PUT V9,4"],
            &["WRITE 0", "PUT ,160", "V9=10", "PUT V9,1"],
            &["PUT VPAI,16"],
            &["V9=-1", "PUT V9,1"],
            &["VTOFX[1]=-99.9", "PUT VTOFX[1],1"],
            &["PUT VRUND,2"],
        ];
        let lines = self.choices.pick(&lists);
        self.blocks(lines)
    }
}

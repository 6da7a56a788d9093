//! What a text needs of an implementation.
//!
//! A scan of letters and digits that knows no grammar: it may ask for a feature too many in a faulty text,
//! never for one too few.

use turnspec_oracle::vocabulary::{Feature, MachineType};

use crate::needs;
use crate::profile::Features;
use crate::state::Mode;

/// Two-letter addresses.
const EXTENDED: [(&[u8], Feature); 5] = [
    (b"SB", Feature::MTool),
    (b"SA", Feature::CAxis),
    (b"QA", Feature::CAxis),
    (b"PZ", Feature::Torque),
    (b"PW", Feature::Torque),
];
const COMPARISONS: [&[u8]; 6] = [b"LT", b"LE", b"EQ", b"NE", b"GT", b"GE"];
const BOOLEAN: [&[u8]; 4] = [b"AND", b"OR", b"EOR", b"NOT"];
const FUNCTIONS: [&[u8]; 16] = [
    b"SIN", b"COS", b"TAN", b"ATAN", b"ATAN2", b"SQRT", b"ABS", b"BIN", b"BCD", b"ROUND", b"FIX", b"FUP",
    b"DROUND", b"DFIX", b"DFUP", b"MOD",
];

/// Statements, with what else they need where they name a block or a program.
const STATEMENTS: [(&[u8], Feature); 13] = [
    (b"GOTO", Feature::ControlStatement),
    (b"IF", Feature::ControlStatement),
    (b"NOEX", Feature::ControlStatement),
    (b"CALL", Feature::Subprogram),
    (b"RTS", Feature::Subprogram),
    (b"MODIN", Feature::ModalCall),
    (b"MODOUT", Feature::ModalCall),
    (b"READ", Feature::Communication),
    (b"WRITE", Feature::Communication),
    (b"GET", Feature::Communication),
    (b"PUT", Feature::Communication),
    (b"VSET", Feature::Schedule),
    (b"END", Feature::Schedule),
];
/// Statements and addresses that are not modelled.
const LATER: [&[u8]; 25] = [
    b"AA", b"AB", b"BC", b"DA", b"DB", b"FA", b"FB", b"IA", b"IB", b"KA", b"KB", b"LA", b"LB", b"RA", b"RB",
    b"TA", b"TB", b"UA", b"UB", b"WA", b"WB", b"XA", b"XB", b"ZA", b"ZB",
];

/// What a text needs on a machine that begins in a motion mode.
pub(crate) fn needs_of(text: &[u8], mode: Mode, machine: MachineType) -> Features {
    let mut scan = Scan {
        text,
        at: 0,
        needs: Features::default(),
        mode,
        side: 13,
        cycle: false,
        slot: false,
        definition: None,
        other_mode: mode,
        machine,
        block: Words::default(),
    };
    if text.first() == Some(&b'$') {
        scan.needs.add(&[Feature::ProgramName]);
        let header = text.split(|byte| *byte == b'\n').next().unwrap_or_default();
        if header.windows(4).any(|extension| extension == b".SDF") {
            scan.needs.add(&[Feature::Schedule]);
        }
        scan.at = text.iter().position(|byte| *byte == b'\n').unwrap_or(text.len());
        if text.iter().take(scan.at).any(|byte| !(0x20..=0x7E).contains(byte)) {
            scan.needs.add(&[Feature::TapeCode]);
        }
    }
    while let Some(byte) = text.get(scan.at).copied() {
        scan.token(byte);
    }
    scan.end_of_block();
    scan.needs
}

/// Words of a block that mean something together only.
#[derive(Default)]
struct Words {
    begun: bool,
    statement: bool,
    /// Whether `'`, `^`, a comma and codes have a function: in PUT, GET and behind VUACM.
    texts: bool,
    equal: bool,
    dwell: bool,
    shift: bool,
    speed: bool,
    one_shot: bool,
    feed: bool,
    axis: bool,
    /// A whole thread in one block.
    compound: bool,
    /// A groove or a tap, and E, which is a dwell of most cycles.
    groove: bool,
    /// A LAP call, or a block of a definition.
    lap: bool,
    dwells: bool,
    /// I and K, D, and words that only threads have.
    centre: bool,
    depth: bool,
    cycle: bool,
}

/// Whether a run of letters and digits can name a local variable.
fn is_local(run: &[u8]) -> bool {
    let first = run.first().copied().unwrap_or_default();
    run.len() <= 4 && !matches!(first, b'N' | b'O' | b'V') && !LATER.contains(&run)
}

struct Scan<'t> {
    text: &'t [u8],
    at: usize,
    needs: Features,
    mode: Mode,
    /// G13 or G14, and on two saddles the mode of the other side.
    side: i64,
    other_mode: Mode,
    /// Whether a cycle of driven tools is in force, and whether it is that of key ways.
    cycle: bool,
    slot: bool,
    /// The mode before the definition of LAP in which the text is, and on two saddles that of the other side.
    definition: Option<Mode>,
    machine: MachineType,
    block: Words,
}

impl Scan<'_> {
    fn peek(&self) -> u8 {
        self.text.get(self.at).copied().unwrap_or_default()
    }

    /// One character, or a run of letters with what belongs to it.
    fn token(&mut self, byte: u8) {
        if byte.is_ascii_uppercase() {
            return self.letters();
        }
        self.at += 1;
        match byte {
            b'\'' if self.block.texts => self.string(),
            b'$' if self.block.texts => self.pass(|byte| byte.is_ascii_hexdigit()),
            b'^' | b',' if self.block.texts => {}
            b'\n' => self.line_end(),
            b' ' => {}
            b'\t' | b'\r' | 0x08 | 0x7F => self.needs.add(&[Feature::TapeCode]),
            b'(' => self.comment(),
            b'/' if self.block.equal => self.needs.add(&[Feature::Expression]),
            b'/' => self.needs.add(&[Feature::BlockDelete]),
            b'%' => self.needs.add(&[Feature::ProgramName]),
            b':' => {
                self.needs.add(&[Feature::ProgramName]);
                self.pass(|byte| byte.is_ascii_alphanumeric());
            }
            b'[' | b']' | b'*' | b'$' | b',' | b'=' => self.needs.add(&[Feature::Expression]),
            b'+' | b'-' if self.after_operand() => self.needs.add(&[Feature::Expression]),
            b'+' | b'-' | b'.' | b'0'..=b'9' => {}
            b'!'..=b'~' => self.needs.add(&[Feature::Alarm]),
            _ => self.needs.add(&[Feature::TapeCode, Feature::Alarm]),
        }
        self.block.equal |= matches!(byte, b'=' | b'[');
    }

    /// Whether what stands before the character just read can end an operand.
    fn after_operand(&self) -> bool {
        let before = self.text.get(..self.at - 1).unwrap_or_default();
        let last = before.iter().rev().find(|byte| **byte != b' ');
        last.is_some_and(|last| last.is_ascii_digit() || matches!(last, b']' | b'.'))
    }

    /// The rest of a string.
    fn string(&mut self) {
        let all = self.text;
        let rest = all.get(self.at..).unwrap_or_default();
        let length = rest.iter().position(|byte| matches!(byte, b'\'' | b'\n')).unwrap_or(rest.len());
        let text = rest.get(..length).unwrap_or_default();
        let passed = |byte: &u8| matches!(byte, b'\r' | 0x08 | 0x7F);
        if text.iter().any(passed) {
            self.needs.add(&[Feature::TapeCode]);
        }
        if text.iter().any(|byte| !(0x20..=0x5F).contains(byte) && !passed(byte)) {
            self.needs.add(&[Feature::TapeCode, Feature::Alarm]);
        }
        self.at += length;
        if self.peek() == b'\'' {
            self.at += 1;
        } else {
            self.needs.add(&[Feature::Alarm]);
        }
    }

    /// The items of PSELECT but for the last one: names of files and of a program.
    fn selection(&mut self) {
        let mut commas = 0;
        while commas < 3 && self.at < self.text.len() {
            let byte = self.peek();
            if byte == b'\n' && self.rest().get(1) != Some(&b'$') {
                return;
            }
            self.at += 1;
            match byte {
                b',' => commas += 1,
                b'(' => self.comment(),
                b'\n' => {
                    self.needs.add(&[Feature::ProgramName]);
                    self.at += 1;
                }
                b'O' => self.needs.add(&[Feature::ProgramName]),
                b'\t' | b'\r' | 0x08 | 0x7F => self.needs.add(&[Feature::TapeCode]),
                b'A'..=b'Z' | b'0'..=b'9' | b' ' | b'.' | b'-' | b':' => {}
                _ => self.needs.add(&[Feature::Alarm]),
            }
        }
        while matches!(self.peek(), b' ' | b'\t' | b'\r' | 0x08 | 0x7F | b'(') {
            let byte = self.peek();
            self.at += 1;
            match byte {
                b'(' => self.comment(),
                b' ' => {}
                _ => self.needs.add(&[Feature::TapeCode]),
            }
        }
        if self.peek() == b'Q' {
            self.at += 1;
            self.block.equal = true;
            self.block.begun = true;
        }
    }

    /// What an output may need more: user alarms.
    fn output(&mut self) {
        let suffix = self.rest().iter().skip_while(|byte| **byte == b' ').skip_while(|byte| **byte == b'[');
        let digits: Vec<u8> = suffix.take_while(|byte| !matches!(byte, b']' | b'\n')).copied().collect();
        let number = std::str::from_utf8(&digits).ok().and_then(|digits| digits.trim().parse::<f64>().ok());
        if number.is_none_or(|number| number > 990.0) {
            self.needs.add(&[Feature::UserAlarm]);
        }
    }

    fn comment(&mut self) {
        self.needs.add(&[Feature::Comment]);
        let rest = self.text.get(self.at..).unwrap_or_default();
        let length = rest.iter().position(|byte| matches!(byte, b')' | b'\n')).unwrap_or(rest.len());
        let remark = rest.get(..length).unwrap_or_default();
        if remark.iter().any(|byte| !(0x20..=0x7E).contains(byte)) {
            self.needs.add(&[Feature::TapeCode]);
        }
        self.at += length;
        if self.peek() == b')' {
            self.at += 1;
        } else {
            self.needs.add(&[Feature::Alarm]);
        }
    }

    /// The end of a line, of a block too unless the next line continues it.
    fn line_end(&mut self) {
        if self.peek() == b'$' {
            self.needs.add(&[Feature::ProgramName]);
            self.at += 1;
        } else {
            self.end_of_block();
        }
    }

    fn end_of_block(&mut self) {
        let block = std::mem::take(&mut self.block);
        if block.feed && !block.dwell {
            self.needs.add(&[Feature::Feed]);
        }
        if block.shift && (block.axis || !block.speed) {
            self.needs.add(&[Feature::ZeroShift]);
        } else if block.axis && !block.shift && !block.one_shot && !self.cycle {
            self.needs.add(match self.mode {
                Mode::Rapid => &[Feature::Rapid],
                Mode::Linear => &[Feature::Linear],
                Mode::Clockwise | Mode::CounterClockwise => &[Feature::Arc],
                Mode::GrowingThread | Mode::ShrinkingThread => &[Feature::Thread],
                Mode::ThreadAlong | Mode::ThreadAlongToo | Mode::ThreadAcross => needs::PASSES,
                _ => &[Feature::ContourGeneration],
            });
        }
        let threads = matches!(
            self.mode,
            Mode::GrowingThread
                | Mode::ShrinkingThread
                | Mode::ThreadAlong
                | Mode::ThreadAlongToo
                | Mode::ThreadAcross
        );
        let lap = block.lap || self.definition.is_some();
        let cycle = self.cycle || block.groove || lap;
        if cycle && !lap && block.dwells && !self.slot {
            self.needs.add(&[Feature::Dwell]);
        }
        if !threads && !block.compound && !cycle {
            for (written, feature) in
                [(block.centre, Feature::Arc), (block.depth, Feature::Torque), (block.cycle, Feature::Alarm)]
            {
                if written {
                    self.needs.add(&[feature]);
                }
            }
        }
    }

    /// A name, a keyword or an address.
    fn letters(&mut self) {
        let first = !std::mem::replace(&mut self.block.begun, true);
        let start = self.at;
        if first && self.rest().starts_with(b"NOEX") {
            self.at += 4;
            return self.keyword(b"NOEX");
        }
        let named = matches!(self.peek(), b'N' | b'O') && !self.is_not();
        if (first || self.block.statement) && named {
            let name = if self.peek() == b'N' { Feature::SequenceName } else { Feature::ProgramName };
            self.needs.add(&[name]);
            self.pass(|byte| byte.is_ascii_alphanumeric());
            return;
        }
        self.pass(|byte| byte.is_ascii_uppercase());
        // A name goes on with digits; a variable is told by its letters, and an address by its letter.
        if self.at > start + 1 && self.text.get(start) != Some(&b'V') {
            self.pass(|byte| byte.is_ascii_alphanumeric());
        }
        let text = self.text;
        let run = text.get(start..self.at).unwrap_or_default();
        match run {
            [letter] => self.word(*letter),
            b"VSET" => self.keyword(run),
            [b'V', ..] => {
                self.block.texts |= run == b"VUACM";
                if run == b"VDOUT" {
                    self.output();
                }
                self.needs = self.needs.and(needs::of_system_variable(run));
            }
            b"CALRG" => self.needs.add(&[Feature::Arc]),
            _ => self.keyword(run),
        }
    }

    fn keyword(&mut self, run: &[u8]) {
        if let Some((_, feature)) = EXTENDED.iter().find(|(address, _)| *address == run) {
            self.needs.add(&[*feature]);
            if run == b"PW" {
                self.needs.add(&[Feature::WAxis]);
            }
            self.block.axis |= run == b"QA";
            self.equal_sign();
        } else if self.block.lap && run.len() == 2 && b"XZDF".contains(&run[0]) && b"AB".contains(&run[1]) {
            self.equal_sign();
        } else if run == b"DA" {
            self.block.cycle = true;
            self.equal_sign();
        } else if COMPARISONS.contains(&run) {
            self.needs.add(&[Feature::Expression]);
        } else if BOOLEAN.contains(&run) {
            self.needs.add(&[Feature::Expression, Feature::Boolean]);
        } else if FUNCTIONS.contains(&run) {
            self.needs.add(&[Feature::Expression, Feature::Function]);
        } else if run == b"PSELECT" {
            self.needs.add(&[Feature::Schedule]);
            self.selection();
        } else if let Some((_, feature)) = STATEMENTS.iter().find(|(keyword, _)| *keyword == run) {
            self.needs.add(&[*feature]);
            self.block.statement = true;
            self.block.texts |= *feature == Feature::Communication;
            self.block.equal |= *feature == Feature::Communication;
        } else if is_local(run) {
            self.needs.add(&[Feature::LocalVariable]);
            self.block.equal = true;
        } else {
            self.needs.add(&[Feature::Alarm]);
        }
    }

    /// Passes over the equal sign of an extended address, which is no expression yet.
    fn equal_sign(&mut self) {
        self.pass(|byte| byte == b' ');
        if self.peek() == b'=' {
            self.at += 1;
            self.block.equal = true;
        }
    }

    /// Whether the operator NOT stands here.
    fn is_not(&self) -> bool {
        let behind = self.rest().strip_prefix(b"NOT").map(|rest| rest.first().copied().unwrap_or_default());
        behind.is_some_and(|byte| !byte.is_ascii_alphanumeric())
    }

    /// The text from here on.
    fn rest(&self) -> &[u8] {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn pass(&mut self, belongs: impl Fn(u8) -> bool) {
        while self.at < self.text.len() && belongs(self.peek()) {
            self.at += 1;
        }
    }

    /// A word of one letter.
    fn word(&mut self, letter: u8) {
        // A variable goes on with the value of a word, another letter begins the next word.
        self.block.equal &= letter == b'V';
        let needs: &[Feature] = match letter {
            b'G' => {
                let code = self.code().unwrap_or(-1);
                self.note_g(code);
                needs::of_g_code(code, self.machine)
            }
            b'M' => match self.code() {
                Some(code) => needs::of_m_code(code, self.machine),
                None => needs::ANY_M_CODE,
            },
            b'V' if self.peek().is_ascii_digit() => self.variable(),
            b'V' => &[Feature::SystemVariable, Feature::Alarm],
            b'X' | b'Z' | b'L' | b'I' | b'K' | b'D' | b'E' | b'J' | b'Q' | b'B' | b'U' | b'H' | b'R' => &[],
            b'A' => &[Feature::AnyAngle],
            b'C' => &[Feature::CAxis],
            b'Y' => &[Feature::ContourGeneration],
            b'W' if self.block.lap => &[],
            b'W' => &[Feature::WAxis],
            b'F' => &[],
            b'S' => &[Feature::Spindle],
            b'T' => &[Feature::Tool],
            b'P' if self.machine == MachineType::TwoSaddles => &[Feature::TwoSaddles],
            _ => &[Feature::Alarm],
        };
        self.needs.add(needs);
        self.block.feed |= letter == b'F';
        self.block.speed |= letter == b'S';
        self.block.axis |=
            matches!(letter, b'X' | b'Y' | b'Z' | b'C' | b'W' | b'A' | b'I' | b'K' | b'L' | b'E' | b'J');
        self.block.centre |= matches!(letter, b'I' | b'K');
        self.block.depth |= letter == b'D';
        self.block.cycle |= matches!(letter, b'E' | b'J' | b'Q' | b'B' | b'U' | b'H' | b'R');
        self.block.dwells |= letter == b'E';
    }

    /// A common variable; digits with a letter behind them name an unknown system variable.
    fn variable(&self) -> &'static [Feature] {
        let rest = self.text.get(self.at..).unwrap_or_default();
        match rest.iter().find(|byte| !byte.is_ascii_digit()) {
            Some(b'A'..=b'Z') => &[Feature::Variable, Feature::SystemVariable, Feature::Alarm],
            _ => &[Feature::Variable],
        }
    }

    fn note_g(&mut self, code: i64) {
        self.block.dwell |= code == 4;
        self.block.shift |= code == 50;
        self.block.one_shot |= matches!(code, 4 | 28 | 29 | 71 | 72 | 73 | 74 | 77 | 78);
        self.block.compound |= matches!(code, 71 | 72);
        self.block.groove |= matches!(code, 73 | 74 | 77 | 78);
        match code {
            81..=83 => self.definition = self.definition.or(Some(self.mode)),
            80 => {
                self.mode = self.definition.take().unwrap_or(self.mode);
                self.block.lap = true;
            }
            85..=88 => (self.block.statement, self.block.lap) = (true, true),
            _ => {}
        }
        if (178..=190).contains(&code) {
            (self.cycle, self.slot) = (code != 180, code == 190);
        }
        let selects = matches!(code, 13 | 14) && self.machine == MachineType::TwoSaddles;
        if selects && self.side != code {
            self.side = code;
            std::mem::swap(&mut self.mode, &mut self.other_mode);
        }
        self.mode = match code {
            0 => Mode::Rapid,
            1 => Mode::Linear,
            2 => Mode::Clockwise,
            3 => Mode::CounterClockwise,
            101..=103 | 132 | 133 | 137 => Mode::of_contour(code),
            31..=35 => Mode::of_thread(code),
            _ => self.mode,
        };
    }

    /// The code behind G or M, blanks and brackets passed over; none where it has to be computed.
    fn code(&mut self) -> Option<i64> {
        let mut digits = String::new();
        loop {
            match self.peek() {
                b' ' => {}
                b'\t' | b'\r' | 0x08 | 0x7F => self.needs.add(&[Feature::TapeCode]),
                b'+' if digits.is_empty() => {}
                b'=' | b'[' if digits.is_empty() => self.needs.add(&[Feature::Expression]),
                b']' => self.needs.add(&[Feature::Expression]),
                digit @ b'0'..=b'9' => digits.push(char::from(digit)),
                _ => break,
            }
            self.at += 1;
            if self.at >= self.text.len() {
                break;
            }
        }
        digits.parse().ok().filter(|_| !self.operator_follows())
    }

    /// Whether the value of a word goes on behind its first number.
    fn operator_follows(&self) -> bool {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let words = COMPARISONS.iter().chain(&BOOLEAN);
        matches!(rest.first(), Some(b'+' | b'-' | b'*' | b'/' | b'.'))
            || words.into_iter().any(|word| rest.starts_with(word))
    }
}

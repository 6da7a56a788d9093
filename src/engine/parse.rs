//! The grammar of a block, from left to right (execution, sections 2 and 3): the leftmost fault decides.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, MachineType, RuleId, Setup};

use super::fault::Fault;
use super::planted::{self, Bug};
use super::text::{Class, class};
use super::words::{Operation, Parsed};

/// What of the set-up the grammar depends on.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Whether marked blocks are skipped.
    pub block_delete: bool,
    /// Whether W variables exist.
    pub w_axis: bool,
    /// Whether boolean operators, functions and calls are refused when evaluated.
    pub level_one: bool,
    /// Whether the program is for two saddles: with P, and without variables and statements (E100L-AX4-12).
    pub two_saddles: bool,
    /// Whether the block is a VSET block.
    pub setting: bool,
}

impl Options {
    /// The options of a set-up.
    pub fn new(setup: &Setup) -> Self {
        Self {
            block_delete: setup.switches.block_delete,
            w_axis: setup.options.w_axis,
            level_one: setup.options.user_task < 2,
            two_saddles: setup.machine.r#type == MachineType::TwoSaddles,
            setting: false,
        }
    }
}

/// The words that begin statements.
pub const KEYWORDS: [&[u8]; 14] = [
    b"GOTO", b"IF", b"CALL", b"RTS", b"MODIN", b"MODOUT", b"READ", b"WRITE", b"GET", b"PUT", b"NOEX",
    b"PSELECT", b"VSET", b"END",
];

/// A place in the characters of a block, and the block that comes of them.
pub struct Parser<'t> {
    pub text: &'t [u8],
    pub at: usize,
    pub options: Options,
    pub block: &'t mut Parsed,
}

impl<'t> Parser<'t> {
    /// What the manual does not tell of two saddles (E100L-AX4-12).
    pub(super) fn refuse_on_two_saddles(&self, detail: Label) -> Result<(), Fault> {
        if self.options.two_saddles {
            return Err(Fault::about(AlarmName::Unspecified, AX4_12, detail));
        }
        Ok(())
    }

    /// The character at a place; none at the end of the block.
    #[inline]
    pub fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    #[inline]
    pub(super) fn peek_class(&self) -> Option<Class> {
        self.peek().map(class)
    }

    /// Why nothing can begin with the character that stands here.
    #[cold]
    pub fn misplaced(&self) -> Fault {
        match self.peek_class() {
            Some(Class::Illegal) => Fault::new(AlarmName::IllegalCharacter, FMT_08),
            Some(Class::Close) => Fault::new(AlarmName::IllegalCharacter, CMT_01),
            Some(_) if self.peek() == Some(b'$') => Fault::new(AlarmName::IllegalCharacter, FMT_08),
            _ => Fault::new(AlarmName::Format, FMT_01),
        }
    }

    /// Skips ignored characters, TAB and comments.
    #[inline]
    pub fn skip_blanks(&mut self) -> Result<(), Fault> {
        while let Some(class) = self.peek_class() {
            match class {
                Class::Ignored | Class::Tab => self.at += 1,
                Class::Open => self.skip_comment()?,
                _ => break,
            }
        }
        Ok(())
    }

    fn skip_comment(&mut self) -> Result<(), Fault> {
        let rest = self.text.get(self.at..).unwrap_or_default();
        let find = if planted::is(Bug::GreedyComment) { memchr::memrchr } else { memchr::memchr };
        match find(b')', rest) {
            Some(length) => {
                self.at += length + 1;
                Ok(())
            }
            None => Fault::raise(AlarmName::CommentUnclosed, CMT_01),
        }
    }

    /// Skips ignored characters, which may stand between an address and its number; a TAB may not (E100L-FMT-07).
    #[inline]
    pub(super) fn skip_ignored(&mut self) {
        while self.peek_class() == Some(Class::Ignored) {
            self.at += 1;
        }
    }

    /// The longest alphanumeric run from a place.
    pub fn run(&self, start: usize) -> &'t [u8] {
        let rest = self.text.get(start..).unwrap_or_default();
        let alphanumeric = |byte: &&u8| matches!(class(**byte), Class::Letter | Class::Digit);
        // A name ends at anything that is no letter and no digit (E100L-CTL-07, E100L-FMT-07).
        let length = rest.iter().take_while(alphanumeric).count();
        rest.get(..length).unwrap_or_default()
    }

    /// Parses the whole block.
    pub fn parse(&mut self) -> Result<(), Fault> {
        self.skip_blanks()?;
        if matches!(self.peek(), Some(b'O' | b':')) {
            return self.program_name();
        }
        let mut slash = self.take_slash()?;
        if self.peek() == Some(b'N') && self.run(self.at) != b"NOEX" {
            let name = self.sequence_name(true)?;
            name_sequence(&mut self.block.sequence, name);
            if !(slash && self.options.block_delete) {
                self.skip_blanks()?;
                if slash && self.peek() == Some(b'/') && !planted::is(Bug::SecondSlash) {
                    return Fault::raise(AlarmName::SlashMisplaced, DEL_02);
                }
                slash |= self.take_slash()?;
            }
        }
        // Skipped as a whole, behind the test of its name; with the switch off the mark does nothing (E100L-DEL-01).
        if slash && self.options.block_delete {
            self.block.skipped = true;
            return Ok(());
        }
        if matches!(self.peek(), Some(b'O' | b':')) && (slash || !self.block.sequence.is_empty()) {
            let rule = if slash { DEL_03 } else { NAME_03 };
            return Fault::raise(AlarmName::ProgramNameNotAlone, rule);
        }
        // A statement begins its block, sequence name and slash aside (E100L-CTL-02).
        if self.statement()? { Ok(()) } else { self.items(None) }
    }

    /// Items up to the end of the block; words among them only without a rule that refuses them.
    pub(super) fn items(&mut self, refusal: Option<RuleId>) -> Result<(), Fault> {
        self.each_item(|parser, letter| {
            parser.item(letter)?;
            match refusal {
                Some(rule) => parser.refuse_word(rule),
                None => parser.refuse_later_word(letter),
            }
        })
    }

    /// What stands up to the end of the block: what begins with a letter is read as said.
    #[inline]
    pub(super) fn each_item(
        &mut self,
        mut read: impl FnMut(&mut Self, u8) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        while let Some(byte) = self.peek() {
            match class(byte) {
                Class::Letter => read(self, byte)?,
                Class::Ignored | Class::Tab | Class::Open => self.skip_blanks()?,
                _ if byte == b'/' => return Fault::raise(AlarmName::SlashMisplaced, DEL_02),
                _ => return Err(self.misplaced()),
            }
        }
        Ok(())
    }

    /// The block delete mark, if it stands here, and the blanks after it.
    fn take_slash(&mut self) -> Result<bool, Fault> {
        if self.peek() != Some(b'/') {
            return Ok(false);
        }
        self.at += 1;
        if self.options.block_delete {
            // What follows the mark of a skipped block is not looked at, a sequence name aside.
            while matches!(self.peek_class(), Some(Class::Ignored | Class::Tab)) {
                self.at += 1;
            }
        } else {
            self.skip_blanks()?;
        }
        Ok(true)
    }

    fn program_name(&mut self) -> Result<(), Fault> {
        let label = self.name_of_program()?;
        self.skip_blanks()?;
        if self.peek().is_some() {
            return Fault::raise(AlarmName::ProgramNameNotAlone, NAME_03);
        }
        self.block.program = Some(label);
        Ok(())
    }

    /// The program name whose `O` or `:` stands here, with `O`.
    /// `:` stands for the `O` (E100L-TAPE-03); what follows it stays text, leading zeros too (E100L-NAME-04).
    pub(super) fn name_of_program(&mut self) -> Result<Label, Fault> {
        let name = self.run(self.at + 1);
        let length = name.len();
        let mut label = Label::new("O");
        name.iter().for_each(|byte| label.push(*byte));
        let reserved = name.first() == Some(&b'O');
        let valid = is_name(name, 4);
        self.at += 1 + length;
        if !valid {
            return Fault::raise(AlarmName::ProgramNameMalformed, NAME_01);
        }
        if reserved {
            return Fault::raise(AlarmName::ProgramNameReserved, NAME_02);
        }
        Ok(label)
    }

    /// The sequence name whose `N` stands here, with `N`; a slash may delimit it or not.
    pub(super) fn sequence_label(&mut self, slash: bool) -> Result<Label, Fault> {
        let mut label = Label::default();
        name_sequence(&mut label, self.sequence_name(slash)?);
        Ok(label)
    }

    /// The same without `N`.
    pub(super) fn sequence_name(&mut self, slash: bool) -> Result<&'t [u8], Fault> {
        let start = self.at + 1;
        let run = self.run(start);
        let run_length = run.len();
        let length = (1..=run_length.min(5))
            .rev()
            .find(|length| run.get(..*length).is_some_and(|name| is_name(name, 5)))
            .unwrap_or(0);
        self.at = start + length;
        if length == 0 {
            return Fault::raise(AlarmName::SequenceNameMalformed, SEQ_01);
        }
        // Ignored characters delimit a name, as they do not inside a number (E100L-FMT-07).
        let delimited = match self.peek() {
            None => true,
            Some(b'/') => slash,
            Some(byte) => matches!(class(byte), Class::Ignored | Class::Tab | Class::Open),
        };
        if !delimited {
            return Fault::raise(AlarmName::SequenceDelimiterMissing, SEQ_02);
        }
        Ok(run.get(..length).unwrap_or_default())
    }

    /// Appends an operation.
    pub fn operation(&mut self, operation: Operation) {
        self.block.operations.push(operation);
    }
}

/// Makes a label of a sequence name without its `N`. The label is filled where it stays: copying what was written
/// character by character holds up the processor.
#[inline]
fn name_sequence(label: &mut Label, name: &[u8]) {
    *label = const { Label::new("N") };
    name.iter().for_each(|byte| label.push(*byte));
}

/// More than eight digits are refused (E100L-DEC-04, E100L-TYPE-02, E100L-TYPE-03).
pub fn check_digits(written: u32, point: bool, feed: bool) -> Result<(), Fault> {
    if written <= 8 {
        return Ok(());
    }
    let rule = match (feed, point) {
        (true, _) => DEC_04,
        (false, true) => TYPE_03,
        (false, false) => TYPE_02,
    };
    Fault::raise(AlarmName::TooManyDigits, rule)
}

/// Whether a name is a numeral or begins with a letter, and is neither empty nor too long.
pub fn is_name(name: &[u8], longest: usize) -> bool {
    let numeral = name.iter().all(u8::is_ascii_digit);
    let begins = name.first().is_some_and(|byte| byte.is_ascii_uppercase() || numeral);
    begins && name.len() <= longest
}

//! The grammar of READ, WRITE, GET and PUT (execution of input and output, chapter 3).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::expression::{has_one_letter, hexadecimal_digit, is_reserved};
use crate::engine::fault::Fault;
use crate::engine::items::{Variable, is_extended};
use crate::engine::parse::{KEYWORDS, Parser};
use crate::engine::system::SystemVariable;
use crate::engine::task::LocalName;
use crate::engine::words::Code;

use super::strings::{Quoted, codes};

/// Most characters of a string or of a row of codes behind PUT.
const MOST: usize = 16;

/// A statement that exchanges characters.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Transfer {
    /// READ, with a channel.
    Read(u8),
    /// WRITE, with a channel.
    Write(u8),
    /// GET, with a length unless it takes all that is left.
    Get(Option<Target>, Option<u8>),
    /// PUT.
    Put(Put),
}

/// What PUT writes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Put {
    Blanks(u8),
    /// The number of a variable in a field.
    Number(Target, u8),
    /// Characters of the block.
    Text(Code),
}

/// The variable of GET or PUT.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Target {
    Common(u8),
    System { variable: SystemVariable, suffix: Option<Code> },
    Local(LocalName),
}

/// What a statement does with its variable.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Purpose {
    Read,
    Write,
}

impl Transfer {
    /// Its keyword.
    pub fn word(self) -> Label {
        Label::new(match self {
            Self::Read(_) => "READ",
            Self::Write(_) => "WRITE",
            Self::Get(..) => "GET",
            Self::Put(_) => "PUT",
        })
    }
}

impl Parser<'_> {
    /// What follows READ or WRITE: a channel.
    pub(in crate::engine) fn channel(&mut self, rule: RuleId) -> Result<u8, Fault> {
        let channel = self.digits().ok_or_else(|| Fault::new(AlarmName::Format, rule))?;
        if channel > 9 {
            return Fault::raise(AlarmName::DeviceUnknown, rule);
        }
        self.nothing_more(rule)?;
        Ok(channel)
    }

    /// What follows GET.
    pub(in crate::engine) fn get(&mut self) -> Result<Transfer, Fault> {
        let target =
            if self.peek() == Some(b',') { None } else { Some(self.target_variable(Purpose::Write)?) };
        self.skip_blanks()?;
        let length = self.field_length(GPUT_01)?;
        self.nothing_more(GPUT_01)?;
        self.block.has_assignment = target.is_some();
        Ok(Transfer::Get(target, length))
    }

    /// What follows PUT.
    pub(in crate::engine) fn put(&mut self) -> Result<Transfer, Fault> {
        let (put, rule) = match self.peek() {
            Some(b'\'' | b'^') => {
                let Quoted { characters, .. } = self.string(GPUT_09)?;
                if characters.length() > MOST {
                    return Fault::raise(AlarmName::StringTooLong, GPUT_09);
                }
                (Put::Text(characters), GPUT_09)
            }
            Some(b'$') => (Put::Text(self.row_of_codes()?), GPUT_10),
            Some(b',') => (Put::Blanks(self.needed_length()?), GPUT_07),
            _ => {
                let target = self.target_variable(Purpose::Read)?;
                self.skip_blanks()?;
                (Put::Number(target, self.needed_length()?), GPUT_07)
            }
        };
        self.nothing_more(rule)?;
        Ok(Transfer::Put(put))
    }

    /// The hexadecimal number whose `$` stands here (E100L-GPUT-10).
    fn row_of_codes(&mut self) -> Result<Code, Fault> {
        self.at += 1;
        let rest = self.text.get(self.at..).unwrap_or_default();
        let length = rest.iter().take_while(|byte| hexadecimal_digit(**byte).is_some()).count();
        self.at += length;
        let codes = codes(rest.get(..length).unwrap_or_default()).filter(|codes| !codes.is_empty());
        let codes = codes.ok_or_else(|| Fault::new(AlarmName::NumberMalformed, GPUT_10))?;
        if codes.len() > MOST {
            return Fault::raise(AlarmName::StringTooLong, GPUT_10);
        }
        if codes.iter().any(|code| matches!(code, 0 | b'%')) {
            return Fault::raise(AlarmName::ForbiddenCode, GPUT_10);
        }
        Ok(self.keep(&codes))
    }

    fn needed_length(&mut self) -> Result<u8, Fault> {
        self.field_length(GPUT_07)?.ok_or_else(|| Fault::new(AlarmName::Format, GPUT_07))
    }

    /// A comma and the length behind it; none without a comma.
    fn field_length(&mut self, rule: RuleId) -> Result<Option<u8>, Fault> {
        if self.peek() != Some(b',') {
            return Ok(None);
        }
        self.at += 1;
        self.skip_blanks()?;
        match self.digits() {
            Some(length @ 1..=160) => Ok(Some(length)),
            _ => Fault::raise(AlarmName::FieldLength, rule),
        }
    }

    /// The value of the digits that stand here, 255 if it is larger; none without a digit.
    fn digits(&mut self) -> Option<u8> {
        let mut value = None;
        while let Some(byte @ b'0'..=b'9') = self.peek() {
            self.at += 1;
            value = Some(value.unwrap_or(0_u8).saturating_mul(10).saturating_add(byte - b'0'));
        }
        value
    }

    /// The variable of GET, which is written, or of PUT.
    fn target_variable(&mut self, purpose: Purpose) -> Result<Target, Fault> {
        let name = self.run(self.at);
        let length = name.len();
        if name.first() == Some(&b'V') && !KEYWORDS.contains(&name) {
            return match self.variable()? {
                Variable::Common(number) => Ok(Target::Common(number)),
                Variable::System(variable) => self.system_target(variable, purpose),
            };
        }
        let other = KEYWORDS.contains(&name) || is_reserved(name) || is_extended(name) || name == b"CALRG";
        let letter = name.first().is_some_and(|first| first.is_ascii_uppercase() && !b"NO".contains(first));
        if other || !letter || has_one_letter(name) {
            let rule = if purpose == Purpose::Write { GPUT_01 } else { GPUT_07 };
            return Fault::raise(AlarmName::Format, rule);
        }
        let name = LocalName::of(name)?;
        self.at += length;
        Ok(Target::Local(name))
    }

    fn system_target(&mut self, variable: SystemVariable, purpose: Purpose) -> Result<Target, Fault> {
        if purpose == Purpose::Read || variable == SystemVariable::Comment {
            self.check_readable(variable)?;
        }
        let suffix = self.suffix(variable)?;
        match variable.read_only().filter(|_| purpose == Purpose::Write) {
            Some(rule) => Fault::raise(AlarmName::VariableReadOnly, rule),
            None => Ok(Target::System { variable, suffix }),
        }
    }

    /// Refuses a variable that cannot stand in an expression (E100L-IOV-02, E100L-SDF-19, E100L-VUACM-01).
    pub(in crate::engine) fn check_readable(&self, variable: SystemVariable) -> Result<(), Fault> {
        match variable {
            SystemVariable::Output if self.options.setting => {
                Fault::raise(AlarmName::ScheduleRightSide, SDF_19)
            }
            SystemVariable::Output => {
                Err(Fault::about(AlarmName::Unspecified, IOV_02, const { Label::new("VDOUT") }))
            }
            SystemVariable::Comment => {
                Err(Fault::about(AlarmName::Unspecified, VUACM_01, const { Label::new("VUACM") }))
            }
            _ => Ok(()),
        }
    }
}

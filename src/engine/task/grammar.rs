//! The grammar of statements (execution, chapter 3, "Statements").

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::arithmetic::scale::TEN;
use crate::engine::codes::{is_g_macro, is_m_macro};
use crate::engine::communication::Transfer;
use crate::engine::expression::{has_one_letter, is_reserved};
use crate::engine::fault::Fault;
use crate::engine::items::is_extended;
use crate::engine::number::Number;
use crate::engine::parse::{KEYWORDS, Parser};
use crate::engine::schedule::Selecting;
use crate::engine::text::{Class, class};
use crate::engine::words::{Address, Code, Item, Source};

use super::LocalName;

/// A statement.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Control {
    /// GOTO, with a sequence name.
    Goto(Label),
    /// IF, with a sequence name.
    If(Condition, Label),
    /// CALL, with a program name.
    Call(Label),
    /// RTS.
    Return,
    /// MODIN, with a program name.
    BeginMode(Label),
    /// MODOUT.
    EndMode,
    /// READ, WRITE, GET or PUT.
    Transfer(Transfer),
    /// PSELECT.
    Select(Selecting),
    /// VSET.
    Set,
    /// END.
    End,
    /// A G code macro (E100L-MACRO-01).
    GMacro(u16),
    /// An M code macro (E100L-MACRO-02).
    MMacro(u16),
}

/// The condition of an IF.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Condition {
    Value(Code),
    Defined(LocalName),
}

impl Control {
    /// Whether it exchanges characters, and tells nothing about the next block.
    pub fn is_transfer(self) -> bool {
        matches!(self, Self::Transfer(_))
    }

    /// Its keyword or macro code.
    pub fn word(self) -> Label {
        match self {
            Self::Goto(_) => Label::new("GOTO"),
            Self::If(..) => Label::new("IF"),
            Self::Call(_) => Label::new("CALL"),
            Self::Return => Label::new("RTS"),
            Self::BeginMode(_) => Label::new("MODIN"),
            Self::EndMode => Label::new("MODOUT"),
            Self::Transfer(transfer) => transfer.word(),
            Self::Select(_) => Label::new("PSELECT"),
            Self::Set => Label::new("VSET"),
            Self::End => Label::new("END"),
            Self::GMacro(code) => Label::of_code(b'G', code),
            Self::MMacro(code) => Label::of_code(b'M', code),
        }
    }
}

impl Control {
    /// Whether it may stand in a contour; RTS in programs that the contour has called.
    pub fn is_for_contours(self, called: bool) -> bool {
        match self {
            Self::Goto(_) | Self::If(..) | Self::Call(_) | Self::MMacro(_) => true,
            Self::GMacro(code) => code > 170,
            Self::Return => called,
            _ => false,
        }
    }
}

/// The keywords that a blank must follow, or `[`; longer ones before their beginnings.
const DELIMITED: [&[u8]; 11] =
    [b"MODOUT", b"MODIN", b"WRITE", b"GOTO", b"CALL", b"READ", b"NOEX", b"RTS", b"GET", b"PUT", b"IF"];

impl Parser<'_> {
    /// A statement with all that follows it; false if none begins here, but an item that stays one.
    #[inline]
    pub fn statement(&mut self) -> Result<bool, Fault> {
        let Some(letter) = self.peek().filter(|byte| class(*byte) == Class::Letter) else { return Ok(false) };
        let next = self.text.get(self.at + 1).map_or(Class::Illegal, |byte| class(*byte));
        match letter {
            _ if next == Class::Letter => self.keyword(),
            b'G' | b'M' => self.macro_code(letter),
            _ => Ok(false),
        }
    }

    /// A block that may begin with a keyword.
    fn keyword(&mut self) -> Result<bool, Fault> {
        let name = self.run(self.at);
        if !KEYWORDS.contains(&name) {
            let beginning = DELIMITED.iter().find(|keyword| name.starts_with(keyword));
            return match beginning.filter(|_| name.len() > 4) {
                Some(keyword) => Err(delimiter_missing(CTL_03, Label::from_bytes(keyword))),
                None => Ok(false),
            };
        }
        let keyword = Label::from_bytes(name);
        self.refuse_on_two_saddles(keyword)?;
        self.block.control = match keyword.as_str() {
            "PSELECT" | "VSET" | "END" => {
                return Err(Fault::about(AlarmName::ScheduleStatement, SDF_02, keyword));
            }
            "IF" => {
                self.at += keyword.as_str().len();
                Some(self.branch()?)
            }
            _ => {
                self.pass_keyword(keyword)?;
                self.delimited(keyword)?
            }
        };
        Ok(true)
    }

    /// What follows a keyword and the blank behind it. NOEX leaves nothing but its items.
    fn delimited(&mut self, keyword: Label) -> Result<Option<Control>, Fault> {
        let control = match keyword.as_str() {
            "GOTO" => Control::Goto(self.target(GOTO_01)?),
            "CALL" => Control::Call(self.subprogram(CALL_01)?),
            "MODIN" => Control::BeginMode(self.subprogram(MODIN_01)?),
            "RTS" => {
                self.nothing_more(RTS_01)?;
                Control::Return
            }
            "MODOUT" => {
                self.nothing_more(MODIN_04)?;
                Control::EndMode
            }
            "READ" => Control::Transfer(Transfer::Read(self.channel(RDWR_01)?)),
            "WRITE" => Control::Transfer(Transfer::Write(self.channel(RDWR_02)?)),
            "GET" => Control::Transfer(self.get()?),
            "PUT" => Control::Transfer(self.put()?),
            _ => {
                self.block.noex = true;
                self.items(Some(NOEX_01))?;
                return Ok(None);
            }
        };
        Ok(Some(control))
    }

    /// A block whose first item begins with G or M; true if that is a macro code.
    fn macro_code(&mut self, letter: u8) -> Result<bool, Fault> {
        self.item(letter)?;
        let Some(Item::Word(address, Source::Plain(number))) = self.block.items.last() else {
            return Ok(false);
        };
        let Some(code) = whole(*number) else { return Ok(false) };
        let (control, rule) = match address {
            Address::G if is_g_macro(code) => (Control::GMacro(code), MACRO_01),
            Address::M if is_m_macro(code) => (Control::MMacro(code), MACRO_02),
            Address::G if matches!(code, 85..=88) => {
                self.contour_name(code)?;
                return Ok(false);
            }
            _ => return Ok(false),
        };
        self.refuse_on_two_saddles(control.word())?;
        self.block.items.clear();
        self.block.control = Some(control);
        self.items(Some(rule))?;
        Ok(true)
    }

    /// The name of the contour that a block with G85 to G88 in front calls (E100L-LAP-09).
    fn contour_name(&mut self, code: u16) -> Result<(), Fault> {
        self.refuse_on_two_saddles(Label::of_code(b'G', code))?;
        self.skip_blanks()?;
        if self.peek() != Some(b'N') || self.run(self.at) == b"NOEX" {
            return Fault::raise(AlarmName::Format, LAP_09);
        }
        self.block.contour = self.sequence_label(false)?;
        Ok(())
    }

    /// A keyword with the blank behind it, and all blanks there.
    pub(in crate::engine) fn pass_keyword(&mut self, keyword: Label) -> Result<(), Fault> {
        self.at += keyword.as_str().len();
        self.delimiter(CTL_03, keyword)
    }

    /// A blank behind a word, or the end of the block; all blanks are skipped.
    fn delimiter(&mut self, rule: RuleId, word: Label) -> Result<(), Fault> {
        match self.peek_class() {
            None | Some(Class::Ignored | Class::Tab | Class::Open) => self.skip_blanks(),
            Some(_) => Err(delimiter_missing(rule, word)),
        }
    }

    /// A sequence name and the end of the block.
    pub(in crate::engine) fn target(&mut self, rule: RuleId) -> Result<Label, Fault> {
        // NOEX is a keyword before it is a name.
        if self.peek() != Some(b'N') || self.run(self.at) == b"NOEX" {
            return Fault::raise(AlarmName::Format, rule);
        }
        let name = self.sequence_label(false)?;
        self.nothing_more(rule)?;
        Ok(name)
    }

    /// The end of the block.
    pub(in crate::engine) fn nothing_more(&mut self, rule: RuleId) -> Result<(), Fault> {
        self.skip_blanks()?;
        if self.peek().is_some() { Fault::raise(AlarmName::Format, rule) } else { Ok(()) }
    }

    /// What follows IF (E100L-IFST-01, E100L-IFST-02).
    /// No delimiter is needed between IF and `[`, nor behind `]` (E100L-CTL-04).
    pub(in crate::engine) fn branch(&mut self) -> Result<Control, Fault> {
        self.skip_blanks()?;
        let condition = if self.peek() == Some(b'[') {
            self.at += 1;
            let code = self.expression()?;
            self.close_bracket()?;
            self.skip_blanks()?;
            Condition::Value(code)
        } else {
            Condition::Defined(self.tested_name()?)
        };
        let run = self.run(self.at);
        if run == b"GOTO" {
            self.pass_keyword(const { Label::new("GOTO") })?;
        } else if run.starts_with(b"GOTO") {
            return Err(delimiter_missing(CTL_03, const { Label::new("GOTO") }));
        }
        Ok(Control::If(condition, self.target(IFST_01)?))
    }

    /// The local variable behind IF, and the blanks behind it.
    fn tested_name(&mut self) -> Result<LocalName, Fault> {
        let run = self.run(self.at);
        let length = run.len();
        let other = KEYWORDS.contains(&run) || is_reserved(run) || is_extended(run) || run == b"CALRG";
        let is_name = run.first().is_some_and(u8::is_ascii_uppercase) && !has_one_letter(run);
        if other || !is_name || run.first() == Some(&b'V') {
            return Fault::raise(AlarmName::Format, IFST_01);
        }
        let name = LocalName::of(run)?;
        self.at += length;
        self.delimiter(CTL_06, name.label())?;
        Ok(name)
    }

    /// What follows CALL and MODIN: a program name, then assignments (E100L-CALL-01, E100L-MODIN-01).
    fn subprogram(&mut self, rule: RuleId) -> Result<Label, Fault> {
        if self.peek() != Some(b'O') {
            return Fault::raise(AlarmName::Format, rule);
        }
        let name = self.name_of_program()?;
        self.delimiter(CTL_06, name)?;
        self.items(Some(rule))?;
        Ok(name)
    }

    /// Refuses the item read last if it is a word.
    pub fn refuse_word(&self, rule: RuleId) -> Result<(), Fault> {
        match self.block.items.last().and_then(Item::address) {
            Some(address) => {
                Err(Fault::about(AlarmName::WordWithoutFunction, rule, Label::new(address.text())))
            }
            None => Ok(()),
        }
    }
}

#[cold]
fn delimiter_missing(rule: RuleId, word: Label) -> Fault {
    Fault::about(AlarmName::StatementDelimiterMissing, rule, word)
}

/// The value of a plain number that is a code.
#[inline(always)]
pub fn whole(number: Number) -> Option<u16> {
    let Number::Decimal { digits, scale, .. } = number else { return None };
    if scale == 0 {
        return u16::try_from(digits).ok();
    }
    let unit = TEN.get(usize::from(scale)).copied().filter(|unit| digits % unit == 0)?;
    u16::try_from(digits / unit).ok()
}

//! The structure of a part program: lines, blocks, words.

use crate::expression::{Expression, Variable};
use crate::number::Number;

/// A part program.
#[derive(Clone, Default, Debug)]
pub struct Program {
    /// Its lines, in order. A block is one line here; the printer may break it.
    pub lines: Vec<Line>,
    /// Files with programs that can be called: name and lines.
    pub library: Vec<(String, Vec<Line>)>,
}

/// A line of the text, or several that make one block.
#[derive(Clone, Debug)]
pub enum Line {
    /// Text that is printed as it stands: file header, program name, `%`, an empty line, a fault.
    Raw(Vec<u8>),
    /// A block.
    Block(Block),
}

/// A block of words.
#[derive(Clone, Default, Debug)]
pub struct Block {
    /// Whether it carries the block delete mark.
    pub delete: bool,
    /// Its sequence name, without the `N`.
    pub sequence: Option<String>,
    /// The statement that it begins with; assignments may follow one that calls, and `NOEX`.
    pub statement: Option<Statement>,
    /// Its items in written order.
    pub items: Vec<Item>,
}

/// A control statement.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// `GOTO` with a sequence name, without the `N`.
    Goto(String),
    /// `IF` with a sequence name, `GOTO` written before it or not.
    If(Condition, String),
    /// `CALL` with a program name, without the `O`.
    Call(String),
    /// `MODIN` likewise.
    Modin(String),
    /// `RTS`
    Rts,
    /// `MODOUT`
    Modout,
    /// A LAP call: its code, and the name of the definition without the `N`.
    Lap(i64, String),
    /// `NOEX`
    Noex,
    /// A macro code.
    Macro(char, i64),
    /// `READ` of a channel.
    Read(i64),
    /// `WRITE` to a channel.
    Write(i64),
    /// `GET` with a variable, a length or both.
    Get(Option<Variable>, Option<i64>),
    /// `PUT`
    Put(Sent),
    /// `VSET`; assignments follow.
    Vset,
    /// `PSELECT`
    Select(Selection),
    /// `END`
    End,
}

/// What `PUT` appends.
#[derive(Clone, PartialEq, Debug)]
pub enum Sent {
    /// The number of a variable in a field of this length.
    Field(Variable, i64),
    /// Blanks.
    Blanks(i64),
    /// A string.
    Text(Text),
    /// Characters by their codes.
    Codes(Vec<u8>),
}

/// A string.
#[derive(Clone, PartialEq, Debug)]
pub struct Text {
    /// Where a `^` stands.
    pub caret: Caret,
    /// What stands between the marks, a `^` behind the first one left out.
    pub characters: String,
}

/// Where the `^` of a string stands, which makes it lower case.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Caret {
    /// Nowhere.
    None,
    /// Before the first mark.
    Before,
    /// Behind it.
    Behind,
}

/// The items of `PSELECT`; an empty text is an item left out.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Selection {
    /// The main program file.
    pub file: String,
    /// The name of the program, without the `O`.
    pub program: Option<String>,
    /// The subprogram file.
    pub subprograms: String,
    /// How often.
    pub repetitions: Repetitions,
}

/// How `PSELECT` writes a number of repetitions.
#[derive(Clone, Default, PartialEq, Debug)]
pub enum Repetitions {
    /// Not at all.
    #[default]
    Once,
    /// A number behind `Q`.
    Plain(Number),
    /// An expression behind `Q=`.
    Equal(Expression),
    /// An expression behind `Q` and a blank.
    Blank(Expression),
}

/// What `IF` asks.
#[derive(Clone, PartialEq, Debug)]
pub enum Condition {
    /// An expression in brackets.
    Holds(Expression),
    /// Whether a local variable has an entry.
    Defined(&'static str),
}

impl Statement {
    /// The sequence name that it looks for.
    #[must_use]
    pub fn target(&self) -> Option<&str> {
        match self {
            Self::Goto(name) | Self::If(_, name) | Self::Lap(_, name) => Some(name),
            _ => None,
        }
    }

    /// Whether it is one of READ, WRITE, GET and PUT.
    #[must_use]
    pub fn is_communication(&self) -> bool {
        matches!(self, Self::Read(_) | Self::Write(_) | Self::Get(..) | Self::Put(_))
    }
}

/// What stands in a block.
#[derive(Clone, Debug)]
pub enum Item {
    /// A word.
    Word(Word),
    /// An assignment to a variable.
    Assignment(Variable, Expression),
    /// A string given to a position of the comment of user alarms.
    Comment(Expression, Text),
    /// `CALRG` (E100L-CIRC-18).
    Calrg,
    /// Text that is printed as it stands.
    Raw(&'static str),
}

/// An address and its value.
#[derive(Clone, Debug)]
pub struct Word {
    /// One letter, or two for an extended address.
    pub address: &'static str,
    /// Its value.
    pub value: Value,
}

/// The value of a word.
#[derive(Clone, Debug)]
pub enum Value {
    /// A plain number.
    Plain(Number),
    /// An expression after an equal sign.
    Expression(Expression),
}

impl Word {
    /// Whether it is a G word of one of these codes, as a plain number.
    #[must_use]
    pub fn is_g(&self, codes: &[i64]) -> bool {
        let is_code = |number: &Number| codes.iter().any(|code| *number == Number::whole(*code));
        self.address == "G" && matches!(&self.value, Value::Plain(number) if is_code(number))
    }
}

impl Item {
    /// A word with a plain number.
    #[must_use]
    pub fn plain(address: &'static str, number: Number) -> Self {
        Self::Word(Word { address, value: Value::Plain(number) })
    }

    /// A word with a whole number.
    #[must_use]
    pub fn whole(address: &'static str, value: i64) -> Self {
        Self::plain(address, Number::whole(value))
    }

    /// A G word.
    #[must_use]
    pub fn g(code: i64) -> Self {
        Self::whole("G", code)
    }

    /// An M word.
    #[must_use]
    pub fn m(code: i64) -> Self {
        Self::whole("M", code)
    }
}

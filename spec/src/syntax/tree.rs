//! The syntax tree of a block.

use std::ops::Range;

use super::communication::Communication;
use crate::controls::e100l::system_variables::SystemVariable;
use crate::vocabulary::Label;

/// A block as it is written.
#[derive(Clone, PartialEq, Debug)]
pub struct Block {
    /// Sequence name with its `N`, empty if there is none.
    pub sequence: Label,
    /// What it holds.
    pub body: Body,
}

/// What a block holds.
#[derive(Clone, PartialEq, Debug)]
pub enum Body {
    /// Nothing but blanks and comments: it is no block.
    Empty,
    /// A program name with its `O`.
    ProgramName(Label),
    /// It carries a block delete mark and the switch is on.
    Skipped,
    /// Words, assignments and mnemonics; none in a block of a sequence name alone.
    Items(Vec<Item>),
    /// `NOEX` and assignments, or alone (E100L-NOEX-01).
    Noex(Vec<Item>),
    /// A statement (E100L-CTL-01).
    Statement(Statement),
    /// A statement of data communication (E100L-RDWR-01, E100L-GPUT-01).
    Communication(Communication),
    /// A call of LAP: the sequence name of its contour, and its items, the code first (E100L-LAP-09).
    ContourCall(Label, Vec<Item>),
}

/// A statement that tells which block comes next; the items behind it are all assignments.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    /// `GOTO` and the sequence name of a block (E100L-GOTO-01).
    Goto(Label),
    /// `IF`, what decides, and the sequence name of a block (E100L-IFST-01, E100L-IFST-02).
    If(Condition, Label),
    /// `CALL`, or a macro code that calls (E100L-CALL-01, E100L-MACRO-01, E100L-MACRO-02).
    Call(Callee, Vec<Item>),
    /// `RTS` (E100L-RTS-01).
    Return,
    /// `MODIN`, or a macro code that acts as it (E100L-MODIN-01, E100L-MACRO-01).
    Modin(Callee, Vec<Item>),
    /// `MODOUT` (E100L-MODIN-04).
    Modout,
}

/// The program that a statement names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Callee {
    /// Its name, with its `O`.
    Program(Label),
    /// The macro code that the set-up gives it to.
    Code(Label),
}

/// What an IF statement depends on.
#[derive(Clone, PartialEq, Debug)]
pub enum Condition {
    /// An expression in brackets (E100L-IFST-01).
    Value(Expression),
    /// Whether a local variable is registered (E100L-IFST-02).
    Registered(Label),
}

impl Statement {
    /// Its keyword, or its macro code.
    pub fn label(&self) -> Label {
        match self {
            Self::Goto(_) => Label::new("GOTO"),
            Self::If(..) => Label::new("IF"),
            Self::Call(Callee::Code(code), _) | Self::Modin(Callee::Code(code), _) => *code,
            Self::Call(..) => Label::new("CALL"),
            Self::Return => Label::new("RTS"),
            Self::Modin(..) => Label::new("MODIN"),
            Self::Modout => Label::new("MODOUT"),
        }
    }
}

/// One item of a block.
#[derive(Clone, PartialEq, Debug)]
pub struct Item {
    /// What it is.
    pub kind: ItemKind,
    /// Byte span.
    pub span: Range<u32>,
}

/// The kinds of items.
#[derive(Clone, PartialEq, Debug)]
pub enum ItemKind {
    /// A word (E100L-FMT-01).
    Word(Address, Value),
    /// A variable setting (E100L-AEXP-01).
    Assignment(Variable, Expression),
    /// Characters for the comment of user alarms, from a position on (E100L-VUACM-01).
    Comment(Expression, Characters),
    /// The mnemonic CALRG (E100L-CIRC-18).
    MajorArc,
}

impl ItemKind {
    /// Whether it sets a variable.
    pub fn is_assignment(&self) -> bool {
        matches!(self, Self::Assignment(..) | Self::Comment(..))
    }

    /// The code of a G word that is written as a plain number.
    pub fn plain_g(&self) -> Option<u16> {
        let Self::Word(Address::Letter(b'G'), Value::Number(number)) = self else { return None };
        number.whole().and_then(|value| u16::try_from(value).ok())
    }
}

/// The characters that a string stands for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Characters {
    /// Their codes.
    pub codes: Vec<u8>,
    /// How they were written.
    pub form: StringForm,
}

/// How a string is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StringForm {
    /// As it is.
    Plain,
    /// Behind `^`, which makes its letters lower case (E100L-GPUT-13, E100L-VUACM-05).
    LowerCase,
    /// As codes (E100L-VUACM-04).
    Codes,
}

/// The address of a word.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Address {
    /// One letter.
    Letter(u8),
    /// Two letters (E100L-FMT-03).
    Extended(&'static str),
}

impl Address {
    /// The address as text.
    pub fn label(self) -> Label {
        match self {
            Self::Letter(letter) => Label::from_bytes(&[letter]),
            Self::Extended(name) => Label::new(name),
        }
    }
}

/// The value of a word.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// A plain number.
    Number(Decimal),
    /// An expression (E100L-FMT-02).
    Expression(Expression),
}

/// A number as it is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Decimal {
    /// The digits as one whole number, with the sign.
    pub digits: i64,
    /// How many of them stand behind the point.
    pub scale: u32,
    /// Whether there is a point.
    pub point: bool,
}

impl Decimal {
    /// Its value, if it is a whole number.
    pub fn whole(self) -> Option<i64> {
        let unit = 10_i64.checked_pow(self.scale)?;
        (self.digits % unit == 0).then_some(self.digits / unit)
    }
}

/// An expression (E100L-AEXP-01).
#[derive(Clone, PartialEq, Debug)]
pub enum Expression {
    /// An integer constant (E100L-TYPE-02, E100L-MATH-18).
    Integer(i32),
    /// A real constant (E100L-TYPE-03).
    Real(Decimal),
    /// A variable.
    Variable(Box<Variable>),
    /// A sign in front (E100L-AEXP-06).
    Sign {
        /// Whether it is a minus.
        minus: bool,
        /// What it stands in front of.
        operand: Box<Expression>,
    },
    /// Bitwise complement (E100L-MATH-05).
    Not(Box<Expression>),
    /// Two operands.
    Binary(BinaryOperator, Box<[Expression; 2]>),
    /// A function of one argument, or of two.
    Call(Function, Vec<Expression>),
}

/// A variable.
#[derive(Clone, PartialEq, Debug)]
pub enum Variable {
    /// `V1` to `V200`, by number (E100L-CVAR-01).
    Common(u8),
    /// A system variable with its suffix (E100L-SVAR-01).
    System(&'static SystemVariable, Option<Expression>),
    /// A local variable, by name (E100L-LVAR-01).
    Local(Label),
}

/// Operators between two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BinaryOperator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `LT`
    Less,
    /// `LE`
    LessOrEqual,
    /// `EQ`
    Equal,
    /// `NE`
    NotEqual,
    /// `GT`
    Greater,
    /// `GE`
    GreaterOrEqual,
    /// `AND`
    And,
    /// `OR`
    Or,
    /// `EOR`
    ExclusiveOr,
}

impl BinaryOperator {
    /// The operator of a word.
    pub fn of_word(word: &str) -> Option<Self> {
        Some(match word {
            "LT" => Self::Less,
            "LE" => Self::LessOrEqual,
            "EQ" => Self::Equal,
            "NE" => Self::NotEqual,
            "GT" => Self::Greater,
            "GE" => Self::GreaterOrEqual,
            "AND" => Self::And,
            "OR" => Self::Or,
            "EOR" => Self::ExclusiveOr,
            _ => return None,
        })
    }
}

macro_rules! functions {
    ($($name:ident $text:literal)*) => {
        /// Functions (E100L-FUNC-01).
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Function { $(#[doc = $text] $name),* }

        impl Function {
            /// The function of a name.
            pub fn of_name(name: &str) -> Option<Self> {
                match name { $($text => Some(Self::$name),)* _ => None }
            }
        }
    };
}

functions! {
    Sin "SIN" Cos "COS" Tan "TAN" Atan "ATAN" Atan2 "ATAN2" Sqrt "SQRT" Abs "ABS" Bin "BIN" Bcd "BCD"
    Round "ROUND" Fix "FIX" Fup "FUP" UnitRound "DROUND" UnitFix "DFIX" UnitFup "DFUP" Mod "MOD"
}

impl Function {
    /// How many arguments it takes.
    pub fn arity(self) -> usize {
        if matches!(self, Self::Atan2 | Self::Mod) { 2 } else { 1 }
    }
}

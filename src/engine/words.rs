//! The parts of a block after parsing, and its words after evaluation. All of it is reused from block to
//! block.

use turnspec_oracle::vocabulary::Label;

use super::codes::GGroup;
use super::communication::CommentForm;
use super::number::Number;
use super::planted::{self, Bug};
use super::system::SystemVariable;
use super::task::{Control, LocalName};

macro_rules! addresses {
    ($($name:ident $text:literal),*) => {
        /// The address of a word, or a mnemonic that stands like a word.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        #[repr(u8)]
        pub enum Address { $($name),* }

        impl Address {
            /// As written.
            pub fn text(self) -> &'static str {
                match self { $(Self::$name => $text),* }
            }
        }
    };
}

addresses! {
    A "A", B "B", C "C", D "D", E "E", F "F", G "G", H "H", I "I", J "J", K "K", L "L", M "M", P "P", Q "Q",
    R "R", S "S", T "T", U "U", W "W", X "X", Y "Y", Z "Z", SB "SB", SA "SA", QA "QA", PZ "PZ", PW "PW",
    Calrg "CALRG", DA "DA", DB "DB", FA "FA", FB "FB", XA "XA", XB "XB", ZA "ZA", ZB "ZB"
}

/// Number of addresses.
const ADDRESSES: usize = 37;

impl Address {
    /// Its bit in a set of addresses.
    pub const fn bit(self) -> u64 {
        1 << self as u64
    }

    /// The set of some addresses.
    pub const fn set(addresses: &[Self]) -> u64 {
        let (mut set, mut next) = (0, 0);
        while next < addresses.len() {
            set |= addresses[next].bit();
            next += 1;
        }
        set
    }

    /// Whether its values are lengths.
    pub const fn is_length(self) -> bool {
        const LENGTHS: u64 = Address::set(&[
            Address::X,
            Address::Y,
            Address::Z,
            Address::I,
            Address::K,
            Address::W,
            Address::D,
            Address::U,
            Address::H,
            Address::L,
            Address::R,
            Address::DA,
            Address::DB,
            Address::XA,
            Address::XB,
            Address::ZA,
            Address::ZB,
        ]);
        self.bit() & LENGTHS != 0
    }
}

/// A value in expressions.
/// A logical one is an integer, 1 or 0 (E100L-TYPE-01).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Operand {
    /// Binary64, finite.
    Real(f64),
    /// 32-bit integer; truth values count as such.
    Integer(i32),
}

impl Operand {
    /// As a real number.
    pub fn real(self) -> f64 {
        match self {
            Self::Real(value) => value,
            Self::Integer(value) => value.into(),
        }
    }

    /// As the value of a word.
    pub fn number(self) -> Number {
        match self {
            Self::Real(value) => Number::Real(value),
            Self::Integer(value) => Number::Integer(value),
        }
    }
}

/// A comparison (E100L-AEXP-03).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Comparison {
    Less,
    LessEqual,
    Equal,
    NotEqual,
    Greater,
    GreaterEqual,
}

/// A function of expressions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Atan,
    Atan2,
    Sqrt,
    Abs,
    Bin,
    Bcd,
    Round,
    Fix,
    Fup,
    Dround,
    Dfix,
    Dfup,
    Mod,
}

/// One operation of an expression in postfix order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Operation {
    Constant(Operand),
    Common(u8),
    System(SystemVariable),
    Local(LocalName),
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Compare(Comparison),
    And,
    Or,
    ExclusiveOr,
    Not,
    Call(Function),
    /// Boolean operators need User Task 2; tested before their operands.
    NeedsBoolean,
    /// Functions need User Task 2; tested before their arguments.
    NeedsFunction,
    /// VDIN needs User Task 2; tested before its suffix.
    NeedsInput,
}

/// A run of operations, or of characters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Code {
    pub start: u16,
    pub end: u16,
}

impl Code {
    /// How many there are.
    pub fn length(self) -> usize {
        usize::from(self.end.saturating_sub(self.start))
    }
}

/// Where the value of a word comes from.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Source {
    Plain(Number),
    Expression(Code),
}

/// One item of a block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Item {
    Word(Address, Source),
    Mnemonic,
    Common { number: u8, value: Code },
    System { variable: SystemVariable, suffix: Option<Code>, value: Code },
    Comment { suffix: Code, text: (Code, CommentForm) },
    Local { name: LocalName, value: Code },
}

impl Item {
    /// Its address, if it is a word or a mnemonic.
    pub fn address(&self) -> Option<Address> {
        match self {
            Self::Word(address, _) => Some(*address),
            Self::Mnemonic => Some(Address::Calrg),
            Self::Common { .. } | Self::System { .. } | Self::Comment { .. } | Self::Local { .. } => None,
        }
    }
}

/// A parsed block.
#[derive(Debug, Default)]
pub struct Parsed {
    /// Items in written order.
    pub items: Vec<Item>,
    /// The operations of all its expressions.
    pub operations: Vec<Operation>,
    /// The characters of all its strings.
    pub characters: Vec<u8>,
    /// Sequence name with its `N`, or empty.
    pub sequence: Label,
    /// Program name with its `O`, if this is a program-name block.
    pub program: Option<Label>,
    /// The contour that it calls, with its `N`; empty unless it begins with G85 to G88.
    pub contour: Label,
    /// The statement, if it is one other than NOEX.
    pub control: Option<Control>,
    /// Whether the block begins with NOEX.
    pub noex: bool,
    /// Whether block delete skips it.
    pub skipped: bool,
    /// Whether it has a length word.
    pub has_length: bool,
    /// Whether it has an assignment.
    pub has_assignment: bool,
}

impl Parsed {
    /// Makes room for the next block.
    pub fn clear(&mut self) {
        self.items.clear();
        self.operations.clear();
        self.characters.clear();
        self.sequence = Label::default();
        self.program = None;
        self.contour = Label::default();
        self.control = None;
        self.noex = false;
        self.skipped = false;
        self.has_length = false;
        self.has_assignment = false;
    }

    /// Whether it is no block: without any word, statement or name.
    /// So an empty line is none (E100L-FMT-04).
    pub fn is_empty(&self) -> bool {
        self.is_only_name() && self.sequence.is_empty() && self.control.is_none()
    }

    /// Whether nothing stands behind the sequence name, a statement that is not counted aside.
    pub fn is_only_name(&self) -> bool {
        self.items.is_empty() && !self.noex
    }

    /// The characters of one of its strings.
    pub fn text(&self, characters: Code) -> &[u8] {
        self.characters.get(usize::from(characters.start)..usize::from(characters.end)).unwrap_or_default()
    }

    /// Whether it has any item.
    pub fn has(&self, wanted: impl Fn(&Item) -> bool) -> bool {
        self.items.iter().any(wanted)
    }
}

/// The evaluated words of a block.
#[derive(Debug)]
pub struct Words {
    present: u64,
    values: [i64; ADDRESSES],
    order: [Address; ADDRESSES],
    count: u8,
    /// The value of F, which depends on the mode that uses it.
    pub feed: Number,
    /// The values of D and E before they were rounded: what they measure depends on the cycle.
    pub exact_d: Number,
    pub exact_e: Number,
    /// Whether the block has an assignment before the word that comes.
    assigned: bool,
    /// Those of E, FA and FB, where they are feeds.
    pub contour_feeds: [Number; 3],
    /// Whether the block is the call of a contour.
    pub calls_contour: bool,
    g: [u16; GROUPS],
    g_count: u8,
    g_groups: u16,
    /// The code of each group that is there.
    g_of_group: [u16; GROUPS],
    /// The bits of its G codes, and those of its M codes: most blocks are asked for codes that they do not have.
    g_bits: u64,
    m_bits: u64,
    m: [u16; MOST_M],
    m_count: u8,
    m_groups: u64,
}

/// The bit of a code, which it shares with a few others.
#[inline]
const fn bit_of(code: u16) -> u64 {
    1 << (code & 63)
}

/// Number of groups of G codes.
const GROUPS: usize = GGroup::OneShot as usize + 1;
/// Most M words in a block (E100L-FMT-06).
pub const MOST_M: usize = 8;

impl Default for Words {
    fn default() -> Self {
        Self {
            present: 0,
            values: [0; ADDRESSES],
            order: [Address::A; ADDRESSES],
            count: 0,
            feed: Number::Integer(0),
            exact_d: Number::Integer(0),
            exact_e: Number::Integer(0),
            assigned: false,
            contour_feeds: [Number::Integer(0); 3],
            calls_contour: false,
            g: [0; GROUPS],
            g_count: 0,
            g_groups: 0,
            g_of_group: [0; GROUPS],
            g_bits: 0,
            m_bits: 0,
            m: [0; MOST_M],
            m_count: 0,
            m_groups: 0,
        }
    }
}

impl Words {
    /// Forgets all words.
    pub fn clear(&mut self) {
        self.present = 0;
        self.calls_contour = false;
        self.count = 0;
        self.assigned = false;
        self.g_count = 0;
        self.g_groups = 0;
        self.g_bits = 0;
        self.m_bits = 0;
        self.m_count = 0;
        self.m_groups = 0;
    }

    /// Notes an assignment.
    pub fn note_assignment(&mut self) {
        self.assigned = true;
    }

    /// Whether there is a word.
    #[inline]
    pub fn any(&self) -> bool {
        self.count != 0 || self.g_count != 0 || self.m_count != 0
    }

    /// Whether the word that comes is the first item of its block.
    pub fn begins(&self) -> bool {
        !self.assigned && !self.any()
    }

    /// Notes that an address was met; false when it was there already.
    pub fn meet(&mut self, address: Address) -> bool {
        if self.has(address) {
            return false;
        }
        self.present |= address.bit();
        if let Some(slot) = self.order.get_mut(usize::from(self.count)) {
            *slot = address;
            self.count += 1;
        }
        true
    }

    /// Stores the value of an address.
    pub fn set(&mut self, address: Address, value: i64) {
        self.values[address as usize] = value;
    }

    /// Whether the block has the address.
    pub fn has(&self, address: Address) -> bool {
        self.present & address.bit() != 0
    }

    /// Whether the block has one of a set of addresses.
    pub fn has_any(&self, set: u64) -> bool {
        self.present & set != 0
    }

    /// The set of addresses of the block.
    pub fn present(&self) -> u64 {
        self.present
    }

    /// The value of an address, if the block has it.
    pub fn get(&self, address: Address) -> Option<i64> {
        self.has(address).then(|| self.values[address as usize])
    }

    /// The addresses other than G and M in written order.
    pub fn order(&self) -> &[Address] {
        self.order.get(..usize::from(self.count)).unwrap_or_default()
    }

    /// Adds a G code; false when its group is there already.
    pub fn add_g(&mut self, code: u16, group: GGroup) -> bool {
        let bit = 1 << group as u16;
        if self.g_groups & bit != 0 {
            return false;
        }
        self.g_groups |= bit;
        self.g_bits |= bit_of(code);
        self.g_of_group[group as usize] = code;
        if let Some(slot) = self.g.get_mut(usize::from(self.g_count)) {
            *slot = code;
            self.g_count += 1;
        }
        true
    }

    /// The G codes in written order.
    pub fn g_codes(&self) -> &[u16] {
        self.g.get(..usize::from(self.g_count)).unwrap_or_default()
    }

    /// The G code of a group, if the block has one.
    #[inline]
    pub fn code_of(&self, group: GGroup) -> Option<u16> {
        (self.g_groups & (1 << group as u16) != 0).then(|| self.g_of_group[group as usize])
    }

    /// Whether the block has an M code, or a G code that is of none of a set of groups.
    #[inline]
    pub fn has_codes_beyond(&self, groups: u16) -> bool {
        self.m_count != 0 || self.g_groups & !groups != 0
    }

    /// Whether the block has a G code.
    #[inline]
    pub fn has_g(&self, code: u16) -> bool {
        self.g_bits & bit_of(code) != 0 && self.g_codes().contains(&code)
    }

    /// Whether there is room for another M code.
    pub fn has_room_for_m(&self) -> bool {
        usize::from(self.m_count) < MOST_M
    }

    /// Adds an M code of a group; false when the code or its group is there already.
    pub fn add_m(&mut self, code: u16, group: Option<u8>) -> bool {
        let bit = group.map_or(0, |group| 1_u64 << (group & 63));
        let lost = planted::is(Bug::GroupConflictLost) && matches!(code, 40..=44);
        if self.m_groups & bit != 0 && !lost || self.has_m(code) {
            return false;
        }
        self.m_groups |= bit;
        self.m_bits |= bit_of(code);
        if let Some(slot) = self.m.get_mut(usize::from(self.m_count)) {
            *slot = code;
            self.m_count += 1;
        }
        true
    }

    /// The M codes in written order.
    pub fn m_codes(&self) -> &[u16] {
        self.m.get(..usize::from(self.m_count)).unwrap_or_default()
    }

    /// Whether the block has an M code.
    #[inline]
    pub fn has_m(&self, code: u16) -> bool {
        self.m_bits & bit_of(code) != 0 && self.m_codes().contains(&code)
    }
}

//! E100L-SVTAB-01: the system variables, and those of input and output, their ranges and suffixes.

use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Options, RuleId};

/// An axis of a system variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    /// X, as a diameter.
    X,
    /// Z.
    Z,
    /// C.
    C,
    /// W.
    W,
}

/// A barrier datum that the program can change.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BarrierDatum {
    /// L1 of the chuck.
    GripLength,
    /// D1 of the chuck.
    GripHeight,
    /// CX.
    ChuckX,
    /// CZ.
    ChuckZ,
    /// L2 of the tailstock.
    FrontLength,
    /// D2 of the tailstock.
    FrontDiameter,
    /// D3 of the tailstock.
    CentreDiameter,
    /// WR.
    WorkpieceEnd,
}

/// What the number of a variable counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Measure {
    /// Nothing: a plain number.
    Plain,
    /// A length.
    Length,
    /// An angle.
    Angle,
}

/// What a number in brackets behind tool interference data means (E100L-SVAR-14).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Numbering {
    /// A tool.
    Tool,
    /// A tool group.
    Group,
}

/// What a modelled system variable holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Quantity {
    /// Zero offset.
    ZeroOffset(Axis),
    /// Zero shift.
    ZeroShift(Axis),
    /// Tool offset, by number.
    ToolOffset(Axis),
    /// Nose radius amount, by number.
    NoseRadius(Axis),
    /// Positive variable limit.
    PositiveLimit(Axis),
    /// Negative variable limit.
    NegativeLimit(Axis),
    /// Permissible droop.
    Droop(Axis),
    /// One of the barrier data.
    Barrier(BarrierDatum),
    /// Pitch error compensation, by number (a plain store).
    PitchError(Axis),
    /// Pitch of the pitch error compensation (a plain store).
    Pitch(Axis),
    /// Present program coordinate.
    Target(Axis),
    /// Present machine coordinate.
    Actual(Axis),
    /// Active tool offset amount.
    ActiveOffset(Axis),
    /// Active tool offset number.
    ActiveOffsetNumber,
    /// Active tool number.
    ActiveTool,
    /// Sequence restart flag.
    Restart,
    /// Tool interference data, a plain store (E100L-SVAR-14).
    Interference(Numbering, Measure),
    /// An input signal (E100L-IOV-01).
    Input,
    /// An output signal (E100L-IOV-02).
    Output,
    /// An input bit of panel or EC (E100L-IORD-01).
    InputBit,
    /// An output bit, to be read (E100L-IORD-01).
    OutputBit,
    /// The constant π.
    Pi,
    /// 360 degrees in the unit of angle addresses.
    FullTurn,
}

/// A modelled system variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SystemVariable {
    /// Its name.
    pub name: &'static str,
    /// What it holds.
    pub quantity: Quantity,
    /// The rule of an assignment; none for a read-only variable.
    pub rule: Option<RuleId>,
    /// Lowest and highest value that may be assigned, in increments.
    pub range: (i64, i64),
}

impl SystemVariable {
    /// Whether a number stands in brackets behind the name.
    pub fn has_suffix(&self) -> bool {
        matches!(
            self.quantity,
            Quantity::ToolOffset(_)
                | Quantity::NoseRadius(_)
                | Quantity::PitchError(_)
                | Quantity::Interference(..)
                | Quantity::Input
                | Quantity::Output
                | Quantity::InputBit
                | Quantity::OutputBit
        )
    }

    /// Whether the variable has this number.
    pub fn has_number(&self, number: i64, options: &Options) -> bool {
        match self.quantity {
            Quantity::ToolOffset(_) | Quantity::NoseRadius(_) => {
                (0..=i64::from(options.offset_sets)).contains(&number)
            }
            Quantity::PitchError(_) => (1..=120).contains(&number),
            Quantity::Interference(Numbering::Tool, _) => (1..=i64::from(options.tools)).contains(&number),
            Quantity::Interference(Numbering::Group, _) => {
                (1..=i64::from(options.tool_groups)).contains(&number)
            }
            Quantity::Input => {
                matches!(number, 1..=19 | 21..=24 | 31..=39 | 1000..=1004 | 1235..=1250)
            }
            Quantity::Output => {
                matches!(number, 1..=9 | 11..=19 | 21..=24 | 31..=39 | 41..=49 | 991..=993)
            }
            Quantity::InputBit | Quantity::OutputBit => (0..=9999).contains(&number),
            _ => false,
        }
    }

    /// The rule that says which numbers it has, and whether it can be written.
    pub fn form(&self) -> RuleId {
        match self.quantity {
            Quantity::Input => IOV_01,
            Quantity::Output => IOV_02,
            Quantity::InputBit | Quantity::OutputBit => IORD_01,
            _ => SVTAB_01,
        }
    }

    /// What its number counts.
    pub fn measure(&self) -> Measure {
        match self.quantity {
            Quantity::Interference(_, measure) => measure,
            Quantity::Droop(_) => Measure::Plain,
            Quantity::ZeroOffset(Axis::C) | Quantity::ZeroShift(Axis::C) => Measure::Angle,
            _ => Measure::Length,
        }
    }

    /// The axis that the machine must have.
    pub fn needs_w(&self) -> bool {
        matches!(
            self.quantity,
            Quantity::ZeroOffset(Axis::W)
                | Quantity::ZeroShift(Axis::W)
                | Quantity::PositiveLimit(Axis::W)
                | Quantity::NegativeLimit(Axis::W)
        )
    }
}

const COORDINATE: (i64, i64) = (-99_999_999, 99_999_999);
const OFFSET: (i64, i64) = (-999_999, 999_999);
const SIZE: (i64, i64) = (0, 9_999_999);
const TURN: (i64, i64) = (0, 360_000);
const PLACE: (i64, i64) = (-9_999_999, 9_999_999);

const fn written(name: &'static str, quantity: Quantity, rule: RuleId, range: (i64, i64)) -> SystemVariable {
    SystemVariable { name, quantity, rule: Some(rule), range }
}

const fn read_only(name: &'static str, quantity: Quantity) -> SystemVariable {
    SystemVariable { name, quantity, rule: None, range: (0, 0) }
}

/// The modelled system variables. The range of a droop is that of the metric systems; it is ten times as
/// wide in the inch systems; that of an output is the one of a bit.
pub const MODELLED: &[SystemVariable] = &[
    written("VZOFX", Quantity::ZeroOffset(Axis::X), SVAR_03, COORDINATE),
    written("VZOFZ", Quantity::ZeroOffset(Axis::Z), SVAR_03, COORDINATE),
    written("VZOFC", Quantity::ZeroOffset(Axis::C), SVAR_03, COORDINATE),
    written("VZOFW", Quantity::ZeroOffset(Axis::W), SVAR_03, COORDINATE),
    written("VZSHX", Quantity::ZeroShift(Axis::X), SVAR_04, COORDINATE),
    written("VZSHZ", Quantity::ZeroShift(Axis::Z), SVAR_04, COORDINATE),
    written("VZSHC", Quantity::ZeroShift(Axis::C), SVAR_04, COORDINATE),
    written("VZSHW", Quantity::ZeroShift(Axis::W), SVAR_04, COORDINATE),
    written("VTOFX", Quantity::ToolOffset(Axis::X), SVAR_05, OFFSET),
    written("VTOFZ", Quantity::ToolOffset(Axis::Z), SVAR_05, OFFSET),
    written("VNSRX", Quantity::NoseRadius(Axis::X), SVAR_06, OFFSET),
    written("VNSRZ", Quantity::NoseRadius(Axis::Z), SVAR_06, OFFSET),
    written("VPVLX", Quantity::PositiveLimit(Axis::X), SVAR_07, COORDINATE),
    written("VPVLZ", Quantity::PositiveLimit(Axis::Z), SVAR_07, COORDINATE),
    written("VPVLW", Quantity::PositiveLimit(Axis::W), SVAR_07, COORDINATE),
    written("VNVLX", Quantity::NegativeLimit(Axis::X), SVAR_07, COORDINATE),
    written("VNVLZ", Quantity::NegativeLimit(Axis::Z), SVAR_07, COORDINATE),
    written("VNVLW", Quantity::NegativeLimit(Axis::W), SVAR_07, COORDINATE),
    written("VINPX", Quantity::Droop(Axis::X), SVAR_09, (0, 1000)),
    written("VINPZ", Quantity::Droop(Axis::Z), SVAR_09, (0, 1000)),
    written("VINPC", Quantity::Droop(Axis::C), SVAR_09, (0, 1000)),
    written("VCHKL", Quantity::Barrier(BarrierDatum::GripLength), SVAR_08, SIZE),
    written("VCHKD", Quantity::Barrier(BarrierDatum::GripHeight), SVAR_08, SIZE),
    written("VCHKX", Quantity::Barrier(BarrierDatum::ChuckX), SVAR_08, PLACE),
    written("VCHKZ", Quantity::Barrier(BarrierDatum::ChuckZ), SVAR_08, PLACE),
    written("VTSL", Quantity::Barrier(BarrierDatum::FrontLength), SVAR_08, SIZE),
    written("VTSDA", Quantity::Barrier(BarrierDatum::FrontDiameter), SVAR_08, SIZE),
    written("VTSDB", Quantity::Barrier(BarrierDatum::CentreDiameter), SVAR_08, SIZE),
    written("VWKR", Quantity::Barrier(BarrierDatum::WorkpieceEnd), SVAR_08, PLACE),
    written("VPFVX", Quantity::PitchError(Axis::X), SVAR_10, (-999, 999)),
    written("VPFVZ", Quantity::PitchError(Axis::Z), SVAR_10, (-999, 999)),
    written("VPCHX", Quantity::Pitch(Axis::X), SVAR_10, (2_000, 65_000)),
    written("VPCHZ", Quantity::Pitch(Axis::Z), SVAR_10, (2_000, 65_000)),
    written("VTLIN", Quantity::Interference(Numbering::Tool, Measure::Plain), SVAR_14, (1, 38)),
    written("VTLFN", Quantity::Interference(Numbering::Tool, Measure::Plain), SVAR_14, (0, 4)),
    written("VTLA1", Quantity::Interference(Numbering::Tool, Measure::Angle), SVAR_14, TURN),
    written("VTLA2", Quantity::Interference(Numbering::Tool, Measure::Angle), SVAR_14, (-360_000, 360_000)),
    written("VTLL", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VTLD", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VTLW", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VGRIN", Quantity::Interference(Numbering::Group, Measure::Plain), SVAR_14, (1, 38)),
    written("VGRFN", Quantity::Interference(Numbering::Group, Measure::Plain), SVAR_14, (0, 4)),
    written("VGRA1", Quantity::Interference(Numbering::Group, Measure::Angle), SVAR_14, TURN),
    written("VGRA2", Quantity::Interference(Numbering::Group, Measure::Angle), SVAR_14, (-360_000, 360_000)),
    written("VGRL", Quantity::Interference(Numbering::Group, Measure::Length), SVAR_14, SIZE),
    written("VGRD", Quantity::Interference(Numbering::Group, Measure::Length), SVAR_14, SIZE),
    written("VGRW", Quantity::Interference(Numbering::Group, Measure::Length), SVAR_14, SIZE),
    written("VTIZN", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VTIZP", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VTIXN", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VTIXP", Quantity::Interference(Numbering::Tool, Measure::Length), SVAR_14, SIZE),
    written("VTIPN", Quantity::Interference(Numbering::Tool, Measure::Plain), SVAR_14, (0, 2)),
    read_only("VDIN", Quantity::Input),
    written("VDOUT", Quantity::Output, IOV_02, (0, 1)),
    read_only("VIRD", Quantity::InputBit),
    read_only("VORD", Quantity::OutputBit),
    read_only("VSIOX", Quantity::Target(Axis::X)),
    read_only("VSIOZ", Quantity::Target(Axis::Z)),
    read_only("VSIOC", Quantity::Target(Axis::C)),
    read_only("VAPAX", Quantity::Actual(Axis::X)),
    read_only("VAPAZ", Quantity::Actual(Axis::Z)),
    read_only("VETFX", Quantity::ActiveOffset(Axis::X)),
    read_only("VETFZ", Quantity::ActiveOffset(Axis::Z)),
    read_only("VETON", Quantity::ActiveOffsetNumber),
    read_only("VETLN", Quantity::ActiveTool),
    read_only("VRSTT", Quantity::Restart),
    read_only("VPAI", Quantity::Pi),
    read_only("VRUND", Quantity::FullTurn),
];

/// Whether the table has a name, modelled or not.
pub fn is_known(name: &str) -> bool {
    MODELLED.iter().any(|each| each.name == name)
        || LATER.contains(&name)
        || [UNIT_SYSTEM, COMMENT].contains(&name)
}

/// E100L-SVTAB-05: the unit system, whose coding the manual does not give.
pub const UNIT_SYSTEM: &str = "VUNIT";

/// The comment of user alarms, which holds text (E100L-VUACM-01).
pub const COMMENT: &str = "VUACM";

/// The names of the table that have no data in a set-up yet.
pub const LATER: &[&str] = &[
    "VAPPX", "VAPPZ", "VBNCT", "VCEJM", "VCHIO", "VCHSW", "VCNGC", "VDIFX", "VDIFZ", "VEINT", "VETFY",
    "VEXAX", "VEXDR", "VEXFB", "VEXGF", "VEXOG", "VEXOK", "VEXPO", "VEXTO", "VEXTR", "VGRID", "VGRLF",
    "VGRSL", "VIMDX", "VIMDZ", "VINPY", "VLMON", "VLRG", "VLYV", "VLZV", "VMCN", "VMDT", "VMIRZ", "VMNA1",
    "VMNA2", "VMXA1", "VMXA2", "VPFVT", "VPFVY", "VPLOF", "VPWSP", "VPWTP", "VRBV", "VRCV", "VRNGX", "VRNGZ",
    "VRRG", "VRVW", "VRVX", "VRVY", "VRWV", "VRXV", "VRYV", "VRZV", "VSIDC", "VSIOY", "VSKFA", "VSKFB",
    "VSKPC", "VSKPX", "VSKPY", "VSKPZ", "VSNTU", "VSNWD", "VSNX", "VSNZ", "VTHRX", "VTHRZ", "VTLCA", "VTLCN",
    "VTLCT", "VTLGN", "VTLLF", "VTLMT", "VTLNG", "VTLOA", "VTLOB", "VTLOC", "VTLSA", "VTLSN", "VTLST",
    "VTLUS", "VTOAA", "VTOAB", "VTOBA", "VTOBB", "VTOCA", "VTOCB", "VTOFY", "VTOPC", "VTRTS", "VTSOY",
    "VWAP", "VWKCC", "VWKCS", "VXARP", "VXBRP", "VXMAB", "VXMBD", "VXMCD", "VXMCO", "VXMD5", "VXMDR",
    "VXMDS", "VXMMC", "VXMMD", "VXMMO", "VXMNC", "VXMOG", "VXMON", "VXMP0", "VXMPO", "VXMTG", "VXMXZ",
    "VZARP", "VZBRP", "VZCRP", "VZOFY", "VZSHY",
];

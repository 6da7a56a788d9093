//! E100L-SVTAB-01: the system variables, their ranges and suffixes.

use crate::vocabulary::RuleId;
use crate::vocabulary::rule_ids::*;

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
    /// Lowest and highest suffix, given the number of offset sets; none for a variable without suffix.
    pub fn suffix(&self, offset_sets: u8) -> Option<(i64, i64)> {
        match self.quantity {
            Quantity::ToolOffset(_) | Quantity::NoseRadius(_) => Some((0, i64::from(offset_sets))),
            Quantity::PitchError(_) => Some((1, 120)),
            _ => None,
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
const PLACE: (i64, i64) = (-9_999_999, 9_999_999);

const fn written(name: &'static str, quantity: Quantity, rule: RuleId, range: (i64, i64)) -> SystemVariable {
    SystemVariable { name, quantity, rule: Some(rule), range }
}

const fn read_only(name: &'static str, quantity: Quantity) -> SystemVariable {
    SystemVariable { name, quantity, rule: None, range: (0, 0) }
}

/// The modelled system variables. The range of a droop is that of the metric systems; it is ten times as
/// wide in the inch systems.
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

/// E100L-SVTAB-05: the unit system, whose coding the manual does not give.
pub const UNIT_SYSTEM: &str = "VUNIT";

/// The names of the table, and of the input and output variables, that have no data in a set-up yet.
pub const LATER: &[&str] = &[
    "VAPPX", "VAPPZ", "VBNCT", "VCEJM", "VCHIO", "VCHSW", "VCNGC", "VDIFX", "VDIFZ", "VDIN", "VDOUT",
    "VEINT", "VETFY", "VEXAX", "VEXDR", "VEXFB", "VEXGF", "VEXOG", "VEXOK", "VEXPO", "VEXTO", "VEXTR",
    "VGRA1", "VGRA2", "VGRD", "VGRFN", "VGRID", "VGRIN", "VGRL", "VGRLF", "VGRSL", "VGRW", "VIMDX", "VIMDZ",
    "VINPY", "VIRD", "VLMON", "VLRG", "VLYV", "VLZV", "VMCN", "VMDT", "VMIRZ", "VMNA1", "VMNA2", "VMXA1",
    "VMXA2", "VORD", "VPFVT", "VPFVY", "VPLOF", "VPWSP", "VPWTP", "VRBV", "VRCV", "VRNGX", "VRNGZ", "VRRG",
    "VRVW", "VRVX", "VRVY", "VRWV", "VRXV", "VRYV", "VRZV", "VSIDC", "VSIOY", "VSKFA", "VSKFB", "VSKPC",
    "VSKPX", "VSKPY", "VSKPZ", "VSNTU", "VSNWD", "VSNX", "VSNZ", "VTHRX", "VTHRZ", "VTIPN", "VTIXN", "VTIXP",
    "VTIZN", "VTIZP", "VTLA1", "VTLA2", "VTLCA", "VTLCN", "VTLCT", "VTLD", "VTLFN", "VTLGN", "VTLIN", "VTLL",
    "VTLLF", "VTLMT", "VTLNG", "VTLOA", "VTLOB", "VTLOC", "VTLSA", "VTLSN", "VTLST", "VTLUS", "VTLW",
    "VTOAA", "VTOAB", "VTOBA", "VTOBB", "VTOCA", "VTOCB", "VTOFY", "VTOPC", "VTRTS", "VTSOY", "VUACM",
    "VWAP", "VWKCC", "VWKCS", "VXARP", "VXBRP", "VXMAB", "VXMBD", "VXMCD", "VXMCO", "VXMD5", "VXMDR",
    "VXMDS", "VXMMC", "VXMMD", "VXMMO", "VXMNC", "VXMOG", "VXMON", "VXMP0", "VXMPO", "VXMTG", "VXMXZ",
    "VZARP", "VZBRP", "VZCRP", "VZOFY", "VZSHY",
];

//! E100L-GTAB-01: the G codes, their groups, and which of them are modelled.

/// Groups of G codes; one code a group may stand in a block, and modal groups keep theirs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum GGroup {
    /// G00 G01 G02 G03 G31 G32 G33 G34 G35 G101 G102 G103 G132 G133.
    Motion,
    /// G17 G18 G119.
    Plane,
    /// G40 G41 G42.
    Compensation,
    /// G90 G91.
    Dimension,
    /// G94 G95.
    FeedUnit,
    /// G96 G97.
    CuttingSpeed,
    /// G110 G111.
    CssTurret,
    /// G64 G65.
    Droop,
    /// G13 G14.
    Turret,
    /// G136 G137: kept, but in their block as a one-shot code.
    Conversion,
    /// G178 to G190.
    Cycle,
    /// G04 G22 G28 G29 G50 G71 to G78, G80 to G83, G85 to G88: act in their block only.
    OneShot,
    /// G84, which stands beside G85 (E100L-LAPC-02).
    ChangePoints,
}

impl GGroup {
    /// The modal groups.
    pub const MODAL: [Self; 11] = [
        Self::Motion,
        Self::Plane,
        Self::Compensation,
        Self::Dimension,
        Self::FeedUnit,
        Self::CuttingSpeed,
        Self::CssTurret,
        Self::Droop,
        Self::Turret,
        Self::Conversion,
        Self::Cycle,
    ];

    /// Name in the trace.
    pub fn name(self) -> &'static str {
        match self {
            Self::Motion => "motion",
            Self::Plane => "plane",
            Self::Compensation => "compensation",
            Self::Dimension => "dimension",
            Self::FeedUnit => "feed_unit",
            Self::CuttingSpeed => "cutting_speed",
            Self::CssTurret => "css_turret",
            Self::Droop => "droop",
            Self::Turret => "turret",
            Self::Conversion => "conversion",
            Self::Cycle => "cycle",
            Self::OneShot => "one_shot",
            Self::ChangePoints => "change_points",
        }
    }

    /// The code active at power-on.
    pub fn initial(self) -> u16 {
        match self {
            Self::Motion | Self::OneShot | Self::ChangePoints => 0,
            Self::Plane => 18,
            Self::Compensation => 40,
            Self::Dimension => 90,
            Self::FeedUnit => 95,
            Self::CuttingSpeed => 97,
            Self::CssTurret => 110,
            Self::Droop => 64,
            Self::Turret => 13,
            Self::Conversion => 136,
            Self::Cycle => 180,
        }
    }

    /// Whether its codes are one group with the one-shot codes (E100L-GCODE-04).
    pub fn is_one_shot(self) -> bool {
        matches!(self, Self::OneShot | Self::Conversion)
    }
}

/// What the model does with a G code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum GCode {
    /// It is modelled and belongs to this group.
    Modelled(GGroup),
    /// It is a macro code, and as such a statement (E100L-MACRO-01).
    Macro,
    /// It is assigned; its behaviour is not modelled yet.
    Later,
    /// It is in the table and the manual never says what it does.
    Unspecified,
    /// It is not in the table.
    Unassigned,
}

/// Looks a G code up.
pub fn g_code(code: u16) -> GCode {
    let group = match code {
        0..=3 | 31..=35 | 101..=103 | 132 | 133 => GGroup::Motion,
        4 | 22 | 28 | 29 | 50 | 71..=78 | 80..=83 | 85..=88 => GGroup::OneShot,
        84 => GGroup::ChangePoints,
        13 | 14 => GGroup::Turret,
        17 | 18 | 119 => GGroup::Plane,
        40..=42 => GGroup::Compensation,
        64 | 65 => GGroup::Droop,
        90 | 91 => GGroup::Dimension,
        94 | 95 => GGroup::FeedUnit,
        96 | 97 => GGroup::CuttingSpeed,
        110 | 111 => GGroup::CssTurret,
        136 | 137 => GGroup::Conversion,
        178..=190 => GGroup::Cycle,
        19 | 20 | 21 | 30 | 36 | 37 | 62 | 100 | 107 | 108 | 122 | 123 | 140..=143 | 152 | 191 => {
            return GCode::Unspecified;
        }
        112 | 113 | 138 => return GCode::Later,
        161..=171 | 205..=214 => return GCode::Macro,
        _ => return GCode::Unassigned,
    };
    GCode::Modelled(group)
}

//! The tables of G and M codes (E100L-GTAB-01, E100L-MTAB-01): what exists, what is modelled, which
//! codes exclude each other, which rules an M code cites.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Label, RuleId, RuleSet};

/// What the tables say about a code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Status {
    /// The code has a meaning here.
    Modelled,
    /// The manual lists the code and never says what it does.
    Unspecified,
    /// The code exists and is not modelled yet.
    NotModelled,
    /// There is no such code.
    Unassigned,
}

/// The groups of modelled G codes: two codes of one group do not share a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum GGroup {
    /// G00 to G03, G31 to G35, G101 to G103, G132, G133.
    Motion,
    /// G13, G14.
    Turret,
    /// G17, G18, G119.
    Plane,
    /// G40, G41, G42.
    Compensation,
    /// G64, G65.
    Droop,
    /// G90, G91.
    Dimension,
    /// G94, G95.
    FeedUnit,
    /// G96, G97.
    CuttingSpeed,
    /// G110, G111.
    SpeedTurret,
    /// G178 to G190.
    Cycle,
    /// G84.
    ChangePoints,
    /// G04 G22 G28 G29 G50 G71 to G78 G80 to G83 G85 to G88 G136 G137, of which a block has one.
    OneShot,
}

impl GGroup {
    /// The set of some groups.
    pub const fn set(groups: &[Self]) -> u16 {
        let (mut set, mut next) = (0, 0);
        while next < groups.len() {
            set |= 1 << groups[next] as u16;
            next += 1;
        }
        set
    }
}

/// Assigned G codes, as ranges.
const G_ASSIGNED: [(u16, u16); 24] = [
    (0, 4),
    (13, 14),
    (17, 22),
    (28, 37),
    (40, 42),
    (50, 50),
    (62, 62),
    (64, 65),
    (71, 78),
    (80, 88),
    (90, 91),
    (94, 97),
    (100, 103),
    (107, 108),
    (110, 113),
    (119, 119),
    (122, 123),
    (132, 133),
    (136, 138),
    (140, 143),
    (152, 152),
    (161, 171),
    (178, 191),
    (205, 214),
];

const G_UNSPECIFIED: [u16; 18] =
    [19, 20, 21, 30, 36, 37, 62, 100, 107, 108, 122, 123, 140, 141, 142, 143, 152, 191];

/// The status of a G code.
#[must_use]
pub fn g_code(code: u16) -> Status {
    if g_group(code).is_some() {
        Status::Modelled
    } else if G_UNSPECIFIED.contains(&code) {
        Status::Unspecified
    } else if within(&G_ASSIGNED, code) {
        Status::NotModelled
    } else {
        Status::Unassigned
    }
}

/// Whether a G code is a macro code (E100L-MACRO-01).
#[must_use]
pub fn is_g_macro(code: u16) -> bool {
    matches!(code, 161..=171 | 205..=214)
}

/// Whether an M code is a macro code (E100L-MACRO-02).
#[must_use]
pub fn is_m_macro(code: u16) -> bool {
    matches!(code, 321..=325 | 341..=360)
}

/// The group of a modelled G code; none for any other.
#[must_use]
pub fn g_group(code: u16) -> Option<GGroup> {
    Some(match code {
        0..=3 | 31..=35 | 101..=103 | 132 | 133 => GGroup::Motion,
        4 | 22 | 28 | 29 | 50 | 71..=78 | 80..=83 | 85..=88 | 136 | 137 => GGroup::OneShot,
        13 | 14 => GGroup::Turret,
        17 | 18 | 119 => GGroup::Plane,
        40..=42 => GGroup::Compensation,
        64 | 65 => GGroup::Droop,
        84 => GGroup::ChangePoints,
        90 | 91 => GGroup::Dimension,
        94 | 95 => GGroup::FeedUnit,
        96 | 97 => GGroup::CuttingSpeed,
        110 | 111 => GGroup::SpeedTurret,
        178..=190 => GGroup::Cycle,
        _ => return None,
    })
}

/// The labels of the lower G codes, of all that events name: copying one is faster than writing it.
static G_LABELS: [Label; 256] = {
    let mut labels = [Label::new(""); 256];
    let mut code = 0;
    while code < labels.len() {
        labels[code] = Label::of_code(b'G', code as u16);
        code += 1;
    }
    labels
};

/// The label of a G code.
#[inline]
#[must_use]
pub fn g_label(code: u16) -> Label {
    G_LABELS.get(usize::from(code)).copied().unwrap_or_else(|| Label::of_code(b'G', code))
}

/// Assigned M codes, as ranges.
const M_ASSIGNED: [(u16, u16); 22] = [
    (0, 6),
    (8, 9),
    (12, 30),
    (32, 44),
    (48, 51),
    (54, 56),
    (58, 70),
    (72, 81),
    (83, 120),
    (122, 169),
    (172, 185),
    (188, 197),
    (200, 209),
    (211, 216),
    (218, 244),
    (246, 254),
    (264, 265),
    (288, 291),
    (308, 309),
    (321, 325),
    (334, 335),
    (341, 362),
];

fn within(ranges: &[(u16, u16)], code: u16) -> bool {
    ranges.iter().any(|(first, last)| (*first..=*last).contains(&code))
}

/// The status of an M code.
#[must_use]
pub fn m_code(code: u16) -> Status {
    match code {
        _ if is_m_macro(code) => Status::NotModelled,
        _ if within(&M_ASSIGNED, code) => Status::Modelled,
        _ => Status::Unassigned,
    }
}

/// The modal groups of M codes, power-on code first.
const M_GROUPS: [(&str, &[u16]); 32] = [
    ("spindle", &[5, 3, 4, 19]),
    ("tool_spindle", &[12, 13, 14]),
    ("c_direction", &[15, 16]),
    ("tailstock_barrier", &[20, 21]),
    ("thread_chamfer", &[22, 23]),
    ("chuck_barrier", &[24, 25]),
    ("thread_lead", &[26, 27]),
    ("thread_infeed", &[32, 33, 34]),
    ("gear", &[40, 41, 42, 43, 44]),
    ("spindle_override", &[48, 49]),
    ("tailstock", &[55, 56]),
    ("speed_arrival", &[60, 61]),
    ("answer", &[62, 64]),
    ("thread_pattern", &[73, 74, 75]),
    ("chuck", &[83, 84]),
    ("turret_direction", &[87, 86]),
    ("c_axis", &[109, 110]),
    ("stm", &[125, 124]),
    ("c_clamp", &[146, 147]),
    ("tool_interlock", &[152, 153]),
    ("centre_interlock", &[156, 157]),
    ("feed_override", &[160, 161]),
    ("tool_override", &[162, 163]),
    ("slide_hold", &[164, 165]),
    ("tailstock_interlock", &[166, 167]),
    ("chuck_interlock", &[184, 185]),
    ("phase_matching", &[193, 194]),
    ("phase_stroke", &[195, 196]),
    ("keyway_direction", &[211, 212]),
    ("keyway_depth", &[213, 214]),
    ("tool_gear", &[240, 241, 242, 243, 244]),
    ("coolant", &[9, 8]),
];

/// The place in [`M_GROUPS`] of every M code, one more for the program group; `NO_GROUP` outside.
const M_GROUP: [u8; 512] = {
    let mut table = [NO_GROUP; 512];
    let mut group = 0;
    while group < M_GROUPS.len() {
        let codes = M_GROUPS[group].1;
        let mut next = 0;
        while next < codes.len() {
            table[codes[next] as usize] = group as u8;
            next += 1;
        }
        group += 1;
    }
    let program = M_GROUPS.len() as u8;
    table[0] = program;
    table[1] = program;
    table[2] = program;
    table[30] = program;
    table
};

const NO_GROUP: u8 = u8::MAX;

/// The number of the group of an M code, below 64, if it has one.
#[must_use]
pub fn m_group_number(code: u16) -> Option<u8> {
    M_GROUP.get(usize::from(code)).copied().filter(|group| *group != NO_GROUP)
}

/// The name of the group of an M code, if it has one; its codes exclude each other in a block.
#[must_use]
pub fn m_group(code: u16) -> Option<&'static str> {
    let number = usize::from(m_group_number(code)?);
    Some(M_GROUPS.get(number).map_or("program", |(name, _)| *name))
}

const fn one(rule: RuleId) -> RuleSet {
    RuleSet::of(&[rule])
}

/// The rules that an M code without an event of its own cites.
#[must_use]
pub fn m_rules(code: u16) -> RuleSet {
    const C_DIRECTION: RuleSet = RuleSet::of(&[MCODE_07, CAX_05]);
    const ANSWER: RuleSet = RuleSet::of(&[MCODE_18, M63_02]);
    const CHECK: RuleSet = RuleSet::of(&[MCODE_25, STM_02]);
    match code {
        15 | 16 => C_DIRECTION,
        63 => ANSWER,
        100 => const { one(M100_06) },
        124 | 125 => CHECK,
        20 | 21 => const { one(MCODE_09) },
        22 | 23 => const { one(MCODE_10) },
        24 | 25 => const { one(MCODE_11) },
        26 | 27 => const { one(MCODE_12) },
        32..=34 => const { one(MCODE_13) },
        48 | 49 => const { one(MCODE_15) },
        55 | 56 => const { one(MCODE_16) },
        60 | 61 => const { one(MCODE_17) },
        73..=75 => const { one(MCODE_20) },
        83 | 84 => const { one(MCODE_21) },
        85 => const { one(MCODE_22) },
        86 | 87 => const { one(MCODE_23) },
        109 | 110 => const { one(MCODE_24) },
        136 => const { one(MCODE_26) },
        140 => const { one(MCODE_27) },
        141 => const { one(MCODE_28) },
        146 | 147 => const { one(MCODE_29) },
        152 | 153 => const { one(CAX_04) },
        156 | 157 => const { one(MCODE_30) },
        160 | 161 => const { one(MCODE_31) },
        162 | 163 => const { one(MCODE_32) },
        164 | 165 => const { one(MCODE_33) },
        166 | 167 => const { one(MCODE_34) },
        184 | 185 => const { one(MCODE_35) },
        193 | 194 => const { one(MCODE_36) },
        195..=197 => const { one(MCODE_37) },
        211..=214 => const { one(MCODE_38) },
        _ => const { one(MTAB_01) },
    }
}

#[cfg(test)]
mod tests {
    use super::{Status, g_code, g_group, m_code, m_group};

    #[test]
    fn the_tables_have_as_many_codes_as_the_manual() {
        // 111 G codes and 270 M codes.
        let assigned = (0..=999).filter(|code| g_code(*code) != Status::Unassigned).count();
        assert_eq!(assigned, 111);
        let assigned = (0..=511).filter(|code| m_code(*code) != Status::Unassigned).count();
        assert_eq!(assigned, 270);
    }

    #[test]
    fn modelled_g_codes_have_groups() {
        for code in (0..=999).filter(|code| g_code(*code) == Status::Modelled) {
            assert!(g_group(code).is_some(), "G{code}");
        }
    }

    #[test]
    fn groups_hold_assigned_codes_only() {
        for code in (0..=511).filter(|code| m_group(*code).is_some()) {
            assert_ne!(m_code(code), Status::Unassigned, "M{code}");
        }
    }
}

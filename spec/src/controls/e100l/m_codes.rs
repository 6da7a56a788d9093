//! E100L-MTAB-01: the M codes, their groups, and the rule that names each.

use crate::vocabulary::RuleId;
use crate::vocabulary::rule_ids::*;

/// A group of M codes of which one is active, the power-on state first (none first: no state at power-on).
pub struct MGroup {
    /// Name in the trace.
    pub name: &'static str,
    /// Its codes.
    pub codes: &'static [u16],
    /// Whether a code of the group is active at power-on: then it is the first one.
    pub initial: bool,
}

const fn group(name: &'static str, codes: &'static [u16]) -> MGroup {
    MGroup { name, codes, initial: true }
}

/// The groups of M codes.
pub const GROUPS: &[MGroup] = &[
    group("spindle", &[5, 3, 4, 19]),
    group("tool_spindle", &[12, 13, 14]),
    group("c_direction", &[15, 16]),
    group("tailstock_barrier", &[20, 21]),
    group("thread_chamfer", &[22, 23]),
    group("chuck_barrier", &[24, 25]),
    group("thread_lead", &[26, 27]),
    group("thread_infeed", &[32, 33, 34]),
    MGroup { name: "gear", codes: &[40, 41, 42, 43, 44], initial: false },
    group("spindle_override", &[48, 49]),
    group("tailstock", &[55, 56]),
    group("speed_arrival", &[60, 61]),
    group("answer", &[62, 64]),
    group("thread_pattern", &[73, 74, 75]),
    group("chuck", &[83, 84]),
    group("turret_direction", &[87, 86]),
    group("c_axis", &[109, 110]),
    group("stm", &[125, 124]),
    group("c_clamp", &[146, 147]),
    group("tool_interlock", &[152, 153]),
    group("centre_interlock", &[156, 157]),
    group("feed_override", &[160, 161]),
    group("tool_override", &[162, 163]),
    group("slide_hold", &[164, 165]),
    group("tailstock_interlock", &[166, 167]),
    group("chuck_interlock", &[184, 185]),
    group("phase_matching", &[193, 194]),
    group("phase_stroke", &[195, 196]),
    group("keyway_direction", &[211, 212]),
    group("keyway_depth", &[213, 214]),
    MGroup { name: "tool_gear", codes: &[240, 241, 242, 243, 244], initial: false },
    group("coolant", &[9, 8]),
    MGroup { name: "program", codes: &[0, 1, 2, 30], initial: false },
];

/// The group of a code.
pub fn group_of(code: u16) -> Option<&'static MGroup> {
    GROUPS.iter().find(|group| group.codes.contains(&code))
}

/// What the model does with an M code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MCode {
    /// It is modelled.
    Modelled,
    /// It is a macro code, and as such a statement (E100L-MACRO-02).
    Macro,
    /// It is not in the table.
    Unassigned,
}

/// Looks an M code up.
pub fn m_code(code: u16) -> MCode {
    match code {
        321..=325 | 341..=360 => MCode::Macro,
        0..=6 | 8 | 9 | 12..=30 | 32..=44 | 48..=51 | 54..=56 | 58..=70 | 72..=81 | 83..=99 => {
            MCode::Modelled
        }
        100..=120 | 122..=169 | 172..=185 | 188..=197 | 200..=209 | 211..=216 | 218..=244 => MCode::Modelled,
        246..=254 | 264 | 265 | 288..=291 | 308 | 309 | 334 | 335 | 361 | 362 => MCode::Modelled,
        _ => MCode::Unassigned,
    }
}

/// The rules that an `aux` event of a code cites.
pub fn aux_rules(code: u16) -> &'static [RuleId] {
    match code {
        15 | 16 => &[MCODE_07, CAX_05],
        20 | 21 => &[MCODE_09],
        22 | 23 => &[MCODE_10],
        24 | 25 => &[MCODE_11],
        26 | 27 => &[MCODE_12],
        32..=34 => &[MCODE_13],
        48 | 49 => &[MCODE_15],
        55 | 56 => &[MCODE_16],
        60 | 61 => &[MCODE_17],
        63 => &[MCODE_18, M63_02],
        73..=75 => &[MCODE_20],
        83 | 84 => &[MCODE_21],
        85 => &[MCODE_22],
        86 | 87 => &[MCODE_23],
        100 => &[M100_06],
        109 | 110 => &[MCODE_24],
        124 | 125 => &[MCODE_25, STM_02],
        136 => &[MCODE_26],
        140 => &[MCODE_27],
        141 => &[MCODE_28],
        146 | 147 => &[MCODE_29],
        152 | 153 => &[CAX_04],
        156 | 157 => &[MCODE_30],
        160 | 161 => &[MCODE_31],
        162 | 163 => &[MCODE_32],
        164 | 165 => &[MCODE_33],
        166 | 167 => &[MCODE_34],
        184 | 185 => &[MCODE_35],
        193 | 194 => &[MCODE_36],
        195..=197 => &[MCODE_37],
        211..=214 => &[MCODE_38],
        _ => &[MTAB_01],
    }
}

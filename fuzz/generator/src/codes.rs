//! The G and M codes of the tables (E100L-GTAB-01, E100L-MTAB-01), sorted by what a program meets there.

/// Groups of M codes of which one may stand in a block; the codes that need care (spindle of the tools,
/// C axis, program) are elsewhere.
pub const M_GROUPS: &[&[i64]] = &[
    &[5, 3, 4, 19],
    &[15, 16],
    &[20],
    &[22, 23],
    &[24],
    &[26, 27],
    &[32, 33, 34],
    &[40, 41, 42, 43, 44],
    &[48, 49],
    &[55, 56],
    &[60, 61],
    &[62, 64],
    &[73, 74, 75],
    &[83, 84],
    &[86, 87],
    &[156, 157],
    &[160, 161],
    &[162, 163],
    &[164, 165],
    &[166, 167],
    &[184, 185],
    &[211, 212],
    &[213, 214],
    &[240, 241, 242, 243, 244],
    &[8, 9],
];

/// First and last codes of the runs of assigned M codes without a group or further meaning.
const M_SINGLE: &[(i64, i64)] = &[
    (6, 6),
    (17, 18),
    (28, 29),
    (35, 39),
    (50, 51),
    (54, 54),
    (58, 59),
    (63, 63),
    (65, 70),
    (72, 72),
    (76, 81),
    (85, 85),
    (88, 99),
    (101, 108),
    (111, 120),
    (122, 123),
    (126, 145),
    (148, 151),
    (154, 155),
    (158, 159),
    (168, 169),
    (172, 183),
    (188, 192),
    (197, 197),
    (200, 209),
    (215, 216),
    (218, 239),
    (246, 254),
    (264, 265),
    (288, 291),
    (308, 309),
    (334, 335),
    (361, 362),
];

/// M codes that must stand alone in their block.
pub const M_ALONE: &[i64] = &[193, 195, 196];

/// M codes that are not assigned: the borders of the gaps of the table.
pub const M_UNASSIGNED: &[i64] =
    &[7, 10, 11, 31, 45, 47, 52, 57, 71, 82, 121, 170, 186, 198, 210, 217, 245, 255, 340, 363, 511];

/// G codes whose behaviour the manual never describes.
pub const G_UNSPECIFIED: &[i64] =
    &[19, 20, 21, 30, 36, 37, 62, 100, 107, 108, 122, 123, 140, 141, 142, 143, 152, 191];

/// G codes that are assigned and not modelled.
pub const G_LATER: &[i64] = &[112, 113, 138];

/// G codes that are not assigned.
pub const G_UNASSIGNED: &[i64] = &[
    5, 6, 12, 15, 16, 23, 27, 38, 39, 43, 49, 51, 54, 61, 63, 66, 70, 79, 89, 92, 93, 98, 99, 104, 106, 109,
    114, 200, 215, 312, 313, 999,
];

/// An M code without group; `place` counts through all of them.
#[must_use]
pub fn single_m(place: usize) -> i64 {
    let count: i64 = M_SINGLE.iter().map(|(first, last)| last - first + 1).sum();
    let mut place = i64::try_from(place).unwrap_or_default() % count;
    for (first, last) in M_SINGLE {
        let length = last - first + 1;
        if place < length {
            return first + place;
        }
        place -= length;
    }
    M_SINGLE[0].0
}

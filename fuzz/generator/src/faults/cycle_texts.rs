//! Texts of faults of grooving, drilling and tapping cycles. `#n` is an amount of n millimetres, `@n` a coordinate n
//! millimetres beyond the present one.

use super::Fault;

/// The alarms of programs with cycles, by their weights.
pub(super) const FAULTS: &[(usize, Fault)] = &[
    (80, Fault::Unspecified),
    (34, Fault::WordMissing),
    (34, Fault::AddressRange),
    (6, Fault::CycleCancelMissing),
    (5, Fault::CycleIncremental),
    (6, Fault::CycleWord),
    (6, Fault::CycleFeedMode),
    (5, Fault::CycleApproachNegative),
    (4, Fault::CycleDepthOverdetermined),
    (4, Fault::NotAlone),
    (4, Fault::CAxisNotJoined),
    (3, Fault::CAxisClamped),
    (3, Fault::NoFeed),
    (4, Fault::StepLimit),
    (4, Fault::CompensationNotAllowed),
    (5, Fault::WordWithoutFunction),
    (3, Fault::StatementMisplaced),
    (2, Fault::GCodesConflict),
    (2, Fault::AngleLookahead),
    (2, Fault::ChamferCorner),
    (4, Fault::TravelLimitNegative),
    (4, Fault::TravelLimitPositive),
    (2, Fault::CoordinateRange),
    (3, Fault::Barrier),
];

/// Grooves.
#[rustfmt::skip]
pub(super) const GROOVES: &[(Fault, &[&str])] = &[
    (Fault::WordMissing, &["G73 Z5 D1", "G73 Z5 K1 D1 F1", "G74 X5 D1", "G74 X5 I1 D1", "G73 X5", "G74 Z5 F1", "G73 D1 I1", "G74 F1 K1"]),
    (Fault::AddressRange, &[
        "G91 G73 X#-9 D#1 L#-1", "G74 Z5 D1 L-1 F2", "G91 G74 Z#-9 D#1 DA=#-1", "G73 X5 D1 DA=-5", "G91 G73 X#-9 D#1 E0", "G74 Z5 D1 E-1",
        "G91 G73 X#-9 D#1 DA=-99999999 F1",
    ]),
    (Fault::Unspecified, &[
        // Words that may not be zero or negative.
        "G91 G73 X#-9 D0", "G91 G74 Z#-9 D0 F1", "G91 G73 X#-9 I#-1 D#2", "G91 G74 Z#-9 I#-1 D#2", "G91 G73 X#-9 K#-1 D#2",
        "G91 G74 Z#-9 K#-1 D#2", "G91 G73 X#-9 D#2 L0", "G91 G74 Z#-9 D#2 L0 F1",
        // T.
        "G91 G73 X#-9 Z#-5 K#1 D#2 T0001", "G90 G73 X@-9 D#2 T0001 F1", "G90 G74 Z@-9 D#2 T0002 F1", "G90 G73 X@-9 Z@-5 K#1 D#2 F1 T1101",
        "G90 G74 X@-9 Z@-5 I#1 D#2 F1 T1202",
        // Depth and step.
        "G91 G73 X0 D#1 F1", "G91 G73 X#-2 I#2 D#1 F1", "G91 G74 Z#-2 K#3 D#1 F1", "G91 G74 Z0 D#1 F1", "G91 G73 X#-9 Z#-5 D#1 F1",
        "G91 G74 X#-9 Z#-5 D#1 F1", "G91 G73 X#-9 Z#5 K0 D#1 F1",
    ]),
    (Fault::StepLimit, &["G91 G73 X#-9 D#0.01 F1", "G91 G74 Z#-9 D#0.01 F1", "G91 G73 X#-2 Z#-50 K#1 D#1 F1"]),
    (Fault::WordWithoutFunction, &[
        "G00 X5 R5", "G01 DA=5 X5 F1", "G73 X5 D1 R5", "G74 Z5 D1 J2 F1", "G73 X5 D1 C5", "G04 F1 R5", "R5", "G77 X5 Z5 K1 L1", "G78 X5 Z5 K1 I1",
        "G77 X5 Z5 K1 D5", "G50 X5 DA=2",
    ]),
    (Fault::GCodesConflict, &["G73 G04 X5 D1", "G73 G74 X5 Z5 D1", "G77 G04 X5", "G71 G73 X5", "G78 G77 X5 Z5 K1"]),
    (Fault::AngleLookahead, &["G01 A30 F2\nG73 X5 D1", "G01 A30 F1\nG77 X5 Z5 K1", "G01 A30 F1\nG74 Z5 D1"]),
    (Fault::ChamferCorner, &["G91 G01 G75 X50 L1 F2\nG73 X5 D1", "G91 G01 G76 X50 L1 F2\nG74 Z5 D1"]),
    (Fault::NoFeed, &["G91 G73 X#-9 D#2", "G91 G74 Z#-9 D#1 M08"]),
];

/// Taps.
#[rustfmt::skip]
pub(super) const TAPS: &[(Fault, &[&str])] = &[
    (Fault::WordMissing, &["G77 X5 Z5", "G78 X5 K1", "G77 Z5 K1 F1", "G78"]),
    (Fault::Unspecified, &[
        "G77 X5 Z5 K-1", "G78 X5 Z5 K-5 F1", "G96 S100\nG77 X5 Z5 K1 F1", "G78 G96 S100 X5 Z5 K1", "M110\nG77 G91 X0 Z#-5 K#1 F1",
        "G77 G91 X0 Z0 K0 F1 S100", "G78 G91 X0 Z#-2 K#2 F1 S100", "G77 G91 X0 Z#2 K#3 F1 S100", "G97 S0\nG77 G91 X0 Z#-9 K#1 F1",
        "G78 G91 X0 Z#-9 K#1 F1 S0",
    ]),
    (Fault::StatementMisplaced, &["X5 G77 Z5 K1", "G00 G78 X5 Z5 K1", "M08 G77 X1 Z1 K1", "F5 G78"]),
    (Fault::NoFeed, &["G77 G91 X0 Z#-9 K#1 S100"]),
];

/// Cycles of driven tools, behind blocks that allow them.
#[rustfmt::skip]
pub(super) const DRIVEN: &[(Fault, &[&str])] = &[
    (Fault::CycleCancelMissing, &[
        "G181 K#1 R#-5 Q2\nC30", "G183 K#1 R#-5 D#2 Q1\nF5", "G189 K#1 R#-5 Q0\nM141", "G190 X@5 Z@-5 K0 D#2 Q3\nX@6", "G182 I#1 R#-5 Q2\nM08",
    ]),
    (Fault::WordMissing, &[
        "G181 K#1 R#-5\nG180\nX5", "G182 K#1 R#-5\nG180\nM08", "G181 I#1 R#-5\nG180\nG00 Z5", "G181 R#-5", "G184 C5 R#-5", "G189 X@3 R#-5",  "G181 K#1", "G182 K#1 C5",
        "G189 I#1 Z@5", "G183 K#1 R#-5", "G183 I#1 R#-5 C5", "G190 K#1 X@5 D#1", "G190 K#1 Z@-5 D#1", "G190 K#1 X@5 Z@-5", "G190 I#1 X@5 D#1", "G95 G185 X@5 F1 SA=5",
        "G95 G186 Z@-5 F1 SA=5", "G95 G187 F1 SA=5", "G95 G185 X@-5 Z@-9 F1", "G95 G188 X@-5 Z@-9 F1", "G178 K#1", "G179 R#-5",
    ]),
    (Fault::Unspecified, &[
        // Other codes, and words that cannot be together.
        "G181 K#1 R#-5\nG183 R#-6 D#1", "G183 K#1 R#-5 D#2\nG181 C5", "G95 G185 X@-4 Z@-9 F1 SA=5\nG186 X@-5", "G181 G01 K#1 R#-5", "G181 K#1 R#-5\nG50 S100",
        "G00 G182 K#1 R#-5", "G181 K#1 R#-5\nG04 F1", "G181 I#1 K#1 R#-5", "G190 I#1 K#1 X@5 Z@-5 D#1", "G181 K#1 R#-5\nK#2 C5", "G181 K#1 R#-5\nI#1 C5",
        "G182 I#1 R#-5\nI#3 R#-6",
        // Zero.
        "G183 K#1 R#-5 D0", "G183 K#1 R#-5 D#2\nD0 C5", "G183 K#1 R#-5 D#2 L0", "G183 I#1 R#-5 D#2\nL0 R#-6", "G183 K#1 R#-5 D#2 L0 C5", "G190 K0 X@5 Z@-5 D0", "G190 I0 X@-5 Z@5 D0",
        // Slots.
        "G190 K#1 X@0 Z@-5 D#1", "G190 I#1 X@-8 Z@0 D#1", "G190 K#1 X@0 Z@-9 D#2 M214", "G190 K#1 X@5 Z@-5 D#1 W#4", "G190 K0 X@5 Z@-5 D#1 W#50", "G190 I#1 X@-8 Z@5 D#1 U#7",
        "G190 I0 X@-8 Z@5 D#1 U#9",
        // Taps.
        "SB=0\nG178 K#1 R#-5 F1", "G179 SB=0 K#1 R#-5 F1", "SB=100\nG178 K#1 R#-5 J1.5", "G95 G179 K#1 R#-5 J2.5 F1",
        // Depth.
        "G181 K#1 R0", "G182 K#5 Z@-4", "G189 I#5 X@-4", "G181 K#1 R#-5\nR#5", "G184 K#1 Z@0", "G183 K#1 R#-5 D#2\nZ@3", "G190 K#9 X@5 Z@-5 D#1",
        "G95 G185 X@-4 Z@0 F1 SA=5", "G95 G186 X@-4 Z@1 I#9 F1 SA=5", "G95 G187 X@-4 Z@-3 K#4 F1 SA=5",
        // Lengths that follow one another.
        "G95 G187 X@-4 Z@-9 F1 SA=5\nC5 X@-5 Z@-12", "G95 G187 X@-4 Z@-9 F1 SA=5\nK#1 Z@-12", "G95 G187 X@-4 Z@-9 F1 SA=5\nX@-5",
        "G95 G188 X@-9 Z@-1 F1 SA=5\nC5 X@-12", "G95 G188 X@-9 Z@-1 F1 SA=5\nI#1 X@-12", "G95 G188 X@-9 Z@-1 F1 SA=5\nX@-8", "G95 G188 X@-9 Z@1 F1 SA=5\nX@-9 Z@-5",
    ]),
    (Fault::AddressRange, &[
        "G183 K#1 R#-5 D#2 L#-1", "G183 I#1 R#-5 D#2\nL-4 C5", "G190 K#1 X@5 Z@-5 D#1 W#-1", "G190 I#1 X@-8 Z@5 D#1 U#-1", "G190 I0 X@-8 Z@5 D#1 U-5", "G190 K0 X@5 Z@-5 D#1 W-5", "G190 K#1 X@5 Z@-5 D#1 E0", "G190 K#1 X@5 Z@-5 D#1 E-1",
        "G178 K#1 R#-5 D-1", "G95 G179 K#1 R#-5 D-90 F1", "G181 K#1 R#-5 E0", "G182 I#1 R#-5 E-1", "G181 K#1 R-99999999999", "G178 K#1 R#-5 J0", "G181 K#1 R#-5 Q-1",
    ]),
    (Fault::CycleIncremental, &["G91 G181 K#1 R#-5", "G181 K#1 R#-5\nG91 C5", "G91\nG185 X5 Z5", "G91\nG190 X5 Z5 K1 D1", "G183 K#1 R#-5 D#2\nG91"]),
    (Fault::CycleWord, &[
        "G181 K#1 R#-5 S100", "G182 K#1 R#-5 T0101", "G181 K#1 R#-5\nM08", "G183 K#1 R#-5 D#2\nM02", "G184 K#1 R#-5 M03", "G181 I#1 R#-5\nM109",
        "G95 G185 X@-4 Z@-9 F1 SA=5\nM30", "G189 K#1 R#-5 M141 M146", "G190 X@5 Z@-5 K0 D#2 M211 S5 M08",
    ]),
    (Fault::CycleFeedMode, &[
        "G95 G181 K#1 R#-5", "G95\nG190 X@5 Z@-5 K#1 D#1", "G94 G185 X@-4 Z@-9 F1 SA=5", "G94 G187 X@-4 Z@-9 F1 SA=5", "G183 K#1 R#-5 D#2\nG95 C5",
        "G95 G182 I#1 R#-5 F1", "G94 G186 X@-4 Z@-9 SA=5",
    ]),
    (Fault::CycleApproachNegative, &[
        "G181 K#-1 R#-5", "G190 I#-1 X@-8 Z@5 D#1", "G95 G185 X@-4 Z@-9 K#-1 SA=5 F1", "G95 G188 X@-4 Z@-9 I#-1 SA=5 F1", "G181 K#1 R#-5\nK#-1 C5", "G182 I-5 K5",
    ]),
    (Fault::CycleDepthOverdetermined, &[
        "G181 K#1 R#-5 Z@-6", "G183 I#1 R#-5 X@-6 D#1", "G182 K#1 R#-5\nR#-6 Z@-9", "G178 K#1 R#-5 Z@-6 F1",
    ]),
    (Fault::NotAlone, &["G180 X5", "G181 K#1 R#-5\nG180 M08", "G180 G00", "G181 K#1 R#-5\nG180 X5 Z5", "G180 V1=5"]),
    (Fault::CAxisNotJoined, &["M109\nG181 K#1 R#-5", "M109\nG95 G185 X@-4 Z@-9 F1 SA=5", "M109 M153\nG190 X@5 Z@-5 K#1 D#1"]),
    (Fault::CAxisClamped, &["M147\nG181 K#1 R#-5", "M147\nG95 G186 X@-4 Z@-9 F1 SA=5", "M147\nG183 I#1 R#-5 D#1 M141"]),
    (Fault::StepLimit, &["G183 K0 R#-9 D#0.01", "G190 X@5 Z@-9 K0 D#0.01 M213", "G190 X@5 Z@-9 K0 D#0.01 M214", "G181 K#1 R#-5 Q9999"]),
    (Fault::WordWithoutFunction, &[
        "G181 K#1 R#-5 L#1", "G190 X@5 Z@-5 K#1 D#1 R#2", "G178 K#1 R#-5 E1", "G95 G185 X@-4 Z@-9 F1 SA=5 Q2", "G181 K#1 R#-5 D#1", "G190 X@5 Z@-5 K#1 D#1 U#1",
        "G189 K#1 R#-5 J1", "G182 I#1 R#-5 W#1", "G181 K#1 R#-5 DA=1", "G181 K#1 R#-5 QA=1",
    ]),
    (Fault::GCodesConflict, &["G181 G182 K#1 R#-5", "G181 G180 K#1"]),
    (Fault::AngleLookahead, &["G01 A30 F2\nG181 K#1 R#-5"]),
    (Fault::ChamferCorner, &["G91 G01 G75 X50 L1 F2\nG90 G181 K#1 R#-5"]),
];

/// Cycles while compensation is in force.
pub(super) const IN_COMPENSATION: &[&str] = &[
    "G73 X5 D1 F1",
    "G74 Z5 D1 F1",
    "G77 X5 Z5 K1 F1",
    "G42 G73 X5 D1",
    "G41 G74 Z5 D1 F1",
    "G90 G94 G181 K1 R-5",
];

/// The same where the block ends it, and where a displacement is left over.
pub(super) const BESIDE_COMPENSATION: &[&str] = &[
    "G40 G73 X5 D1 F1",
    "G40 G74 Z5 D1 F1",
    "G40\nG73 X5 D1 F1",
    "G40\nG77 X5 Z5 K1 F1",
    "G40\nG90 G94 G181 K1 R-5",
];

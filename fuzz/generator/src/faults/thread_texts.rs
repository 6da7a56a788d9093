//! Texts of faults of thread cutting.

use super::Fault;

/// The alarms of programs with threads, by their weights.
pub(super) const FAULTS: &[(usize, Fault)] = &[
    (34, Fault::Unspecified),
    (12, Fault::ThreadData),
    (12, Fault::WordMissing),
    (8, Fault::AddressRange),
    (9, Fault::ThreadInConstantSpeed),
    (10, Fault::ThreadLeadRange),
    (5, Fault::StepLimit),
    (4, Fault::AngleOverdetermined),
    (3, Fault::AngleUnderdetermined),
    (5, Fault::AngleNoIntersection),
    (4, Fault::CompensationNotAllowed),
    (3, Fault::WordWithoutFunction),
    (3, Fault::NoFeed),
    (2, Fault::NotModelled),
    (2, Fault::GCodesConflict),
    (2, Fault::ChamferNotLinear),
    (2, Fault::ChamferCorner),
    (4, Fault::AngleLookahead),
    (3, Fault::TravelLimitNegative),
    (3, Fault::TravelLimitPositive),
    (2, Fault::CoordinateRange),
    (3, Fault::Barrier),
];

/// Blocks that are found at their form, before any state matters.
#[rustfmt::skip]
pub(super) const FORMS: &[(Fault, &[&str])] = &[
    (Fault::WordMissing, &[
        "G33 X5", "G33 Z5", "G31 X5 I1", "G31 Z5 F2", "G32 X5", "G32 Z5 F2", "G32 K1", "G71 X5 D1 H2", "G71 Z5 D1 H2",
        "G72 X5 D1 H2", "G72 Z5 F2 D1 H2", "G71 Z9 D1 H2 F2", "G71 D1 H1", "G71 X9 U1 D1 H2 M74", "G72 M75 X5", "G71 X5 Z5 H2", "G71 X5 Z5 D1", "G72 X5 Z5 D1 F2", "G72 X5 Z5", "G34 E1",
        "G35 J2", "G34 C5 F2", "G35 E1 F2", "G33\nF2\nK1", "G91 G33 X-5 Z-9 F2\nK1", "G91 G31 X-5 Z-9 F2\nL1",
        "G91 G33 X-5 Z-9 F2\nG33 X-6", "G91 G31 X-5 Z-9 F2\nG33 X-6", "G91 G32 X-5 Z-9 F2\nI1", "G91 G32 X-5 Z-9 F2\nE0 J1",
        "G91 G33 X-5 Z-9 F2\nJ2", "G91 G33 X-5 Z-9 F2\nC5",
    ]),
    (Fault::AngleOverdetermined, &[
        "G34 X5 Z5 A5", "G35 X5 Z5 A5 F2", "G33 X5 Z5 A5 I1", "G31 X5 Z5 I0 A0 F2", "G32 X5 Z5 A90 K1", "G71 X5 Z5 A5 I1 D1 H2",
        "G72 X5 Z5 A90 K1 D1 H2", "G91 G33 X-5 Z-9 F2\nX-6 A5 I1",
    ]),
    (Fault::AngleUnderdetermined, &["G34 A5", "G35 A5 F2", "G34 A45 E1"]),
    (Fault::AddressRange, &[
        "G33 X5 Z5 F2 J0", "G34 Z5 F2 J10000", "G71 X5 Z5 D1 H2 F2 J-1", "G71 X5 Z5 D1 H2 F2 Q-1", "G72 X5 Z5 D1 H2 F2 Q10000",
        "G33 X5 Z5 F2 L-1", "G31 X5 Z5 F2 L-1", "G32 X5 Z5 F2 L-1", "G71 X5 Z5 D1 H2 F2 L-1", "G72 X5 Z5 D1 H2 F2 L-1",
        "G72 X5 Z5 D1 H2 F2 W-1", "G71 X5 Z5 D1 H2 F2 U-1", "G71 X5 Z5 D-1 H2 F2", "G34 Z5 F2 E-1", "G35 Z5 F2 E-1",
        "G33 X5 Z5 F2 C-1", "G35 Z5 F2 C-1", "G34 Z5 F2 C360.1", "G33 F0", "G94 G33 F99999999", "G34 F99999999", "G71 X5 Z5 D1 H2 F0",
        "G91 G33 X-5 Z-9 F2\nX-6 C-1", "G91 G33 X-5 Z-9 F2\nX-6 L-1", "G91 G32 X-9 Z-5 F2\nZ-6 C-1",
    ]),
    (Fault::ThreadData, &[
        "G71 X5 Z5 D0 H2", "G72 X5 Z5 D0 H2 F2", "G71 X5 Z5 D1 H0", "G72 X5 Z5 D1 H0", "G71 X5 Z5 D1 H2 B-1", "G72 X5 Z5 D1 H2 B-1 F2",
        "G71 X5 Z5 D1 H2 U2", "G71 X5 Z5 D1 H2 U3 F2", "G72 X5 Z5 D1 H2 W2", "G72 X5 Z5 D1 H2 W3 F2", "G71 X5 Z5 D3 H2 M73",
        "G72 X5 Z5 D3 H2 M73 F2", "G71 X5 Z5 D2 H2 U1 M73", "M73\nG71 X5 Z5 D3 H2", "M73\nG72 X5 Z5 D2 H2 W1", "G71 X5 Z5 D0 H0 B-1",
    ]),
    (Fault::WordWithoutFunction, &[
        "G00 X5 J2", "G01 Z5 F2 J2", "G00 X5 Q2", "G33 X5 Z5 F2 Q2", "G34 Z5 F2 I1", "G34 Z5 F2 L1", "G71 X5 Z5 D1 H2 C5",
        "G72 X5 Z5 D1 H2 I1", "G71 X5 Z5 D1 H2 K1", "G72 X5 Z5 D1 H2 U1", "G33 X5 Z5 D1 F2", "G33 X5 Z5 B5 F2", "G04 F1 J2", "G00 Q2",
        "G33 G04 F1 J2", "J2", "Q2",
    ]),
    (Fault::NotModelled, &["M194\nG91 G33 X-5 Z-9 F2", "G91 G71 X-5 Z-9 D1 H1 F2 M194 M74", "M194\nG91 G34 Z5 F2", "G33 X5 Z5 F2 P1"]),
    (Fault::GCodesConflict, &[
        "G71 G04 X5 Z5 D1 H2", "G71 G72 X5 Z5 D1 H2", "G33 G34 X5 Z5", "G33 G00 X5 Z5", "G50 G71 X5 Z5", "G31 G33 X5", "G75 G71 X5",
    ]),
    (Fault::ChamferNotLinear, &["G33 G75 X5 L1", "G34\nG76 X5 L1", "G32\nG75 Z5 L1", "G35 G76 Z5 L1 A5"]),
    (Fault::ChamferCorner, &[
        "G91 G01 G75 X50 L1 F2\nG33 X5 Z9", "G91 G01 G76 X50 L1 F2\nG71 X5 Z9 D1 H1", "G91 G01 G75 X50 L1 F2\nG34 Z9",
    ]),
    (Fault::AngleLookahead, &["G01 A30 F2\nG33 X5 Z9", "G01 A30 F2\nG71 X5 Z9 D1 H1 M74", "G01 A30 F2\nG35 Z9", "G01 A30 F2\nG32 X5"]),
    (Fault::StepLimit, &["G91 G71 X-5 Z-9 D1 H3 F2 M74", "G91 G72 X-9 Z-5 D1 H3 F2 Q3", "G91 G71 X-9 Z-5 D1 H1 Q9999 F2 M74"]),
];

/// Blocks with A alone, and what stands behind them, where chamfering is set to any angle (E100L-ANG-06).
#[rustfmt::skip]
pub(super) const BEHIND_AN_ANGLE: &[(Fault, &[&str])] = &[
    (Fault::AngleLookahead, &[
        "G34 A30 F2\nX5 Z9", "G35 A30 F2\nX5 A90", "G34 A30 F2\nG35 Z9 A10", "G34 A30 F2\nA60", "G35 A30 F2\nG00 X5 Z9",
        "G34 A30 F2\nG33 X5 Z9 A60", "G35 A30 F2\nG32 X5 Z9 A60", "G34 A30 F2\nG02 X5 Z9 L99", "G34 A30 F2\nX5 Z9 A60 T0101",
        "G35 A30 F2\nG97 S100 X5 Z9 A60", "G34 A30 F2\nV1=5 X5 Z5 A60", "G35 A30 F2\nM08", "G34 A30 F2\nG04 F1", "G34 A30 F2\nS100",
        "G34 A30 F2\nG71 X5 Z9 A60 D1 H1 M74", "G35 A30 F2\nG50 X1", "G01 A30 F2\nG34 X5 Z9", "G00 A30\nG35 X5 A60 F2",
        "G01 A30 F2\nG34 A60", "G34 A30 F2\nG01 X5 Z9 A60 T1",
    ]),
    (Fault::AngleNoIntersection, &[
        "G34 A30 F2\nX5 Z9 A30", "G35 A30 F2\nX5 Z9 A210", "G34 A30 F2\nG01 X5 Z9 A-150", "G01 A0 F2\nG34 X5 Z9 A180",
        "G00 A90\nG35 X5 Z9 A90 F2", "G34 A45 E1 F2 C90\nX5 Z9 A-135 M27", "G35 A-90 F2\nG00 X5 Z9 A270",
    ]),
    (Fault::AngleOverdetermined, &[
        "G34 A30 F2\nG01 X5 Z9 A60 C5", "G01 G91 A45 F2\nG34 X-4 Z-9 A0\nX-1 Z-1 A5", "G35 G91 A45 F2\nX-4 Z-9 A180\nG01 X-1 Z-1 A5",
    ]),
    (Fault::AddressRange, &["G34 A30 F2\nX5 Z9 A60 E-1", "G01 A30 F2\nG35 X5 Z9 A60 C-1", "G34 A30 F2 E-1\nX5 Z9 A60", "G35 A30 F2\nX5 Z9 A60 J0"]),
    (Fault::WordWithoutFunction, &["G34 A30 F2\nX5 Z9 A60 L1", "G01 A30 F2\nG34 X5 Z9 A60 I1", "G34 A30 F2 K1\nX5 Z9 A60", "G35 A30 F2\nG01 X5 Z9 A60 J2"]),
    (Fault::WordMissing, &["G34 A30 F2\nE1", "G01 A30 F2\nG34 J2", "G35 A30 F2\nG33 X5"]),
    (Fault::NoFeed, &["G94 F200\nG34 A30\nX5 Z9 A60", "G94 F200\nG95 G35 A30\nX5 Z9", "G94 G01 F200 A30\nG95 G34 X5 Z9 A30.5"]),
    (Fault::ThreadInConstantSpeed, &["G34 A30 F2\nG96 S100 X5 Z9 A60", "G96 S100\nG35 A30 F2", "G01 A30 F2\nG96 S100 G34 X5 Z9 A60"]),
    (Fault::ChamferNotLinear, &["G34 A30 F2\nG75 X5 Z9 A60 L1", "G35 G76 A30 L1 F2", "G00 A30\nG34 G75 X5 Z9 A60 L1"]),
    (Fault::ChamferCorner, &[
        "G01 G75 A30 L1 F2\nG34 X5 Z9 A60", "G91 G01 G76 X50 L1 F2\nG35 A60\nX5 Z9 A5", "G01 G76 A30 L1 F2\nG35 X5 Z9 A60 E1",
    ]),
    (Fault::Unspecified, &[
        "G34 A30 F2\nX5 Z9 A60 J1.5", "G34 A90 F2\nG91 X8 Z-9 A180", "G91 G35 A0 F2 M27\nX-4 Z-9 A90", "G34 A30 F2\nIF[1] N5",
        "G35 A30 F2\nGOTO N5", "G34 A30 F2\nG205", "G01 A30 F2\nMODOUT", "M110\nG34 A30 F2\nX5 Z9 A60",
        "G91 G01 A45 F2\nG34 X8 Z-9 A0 M27",
    ]),
];

/// Blocks that the manual does not describe, and what has to be in front of them.
#[rustfmt::skip]
pub(super) const NOT_DESCRIBED: &[&str] = &[
    // J.
    "G33 X5 Z5 F2 J1.5", "G34 Z5 F2 J11.5", "G71 X5 Z5 D1 H2 F2 J2.5", "G72 X5 Z5 D1 H2 F2 J1.1",
    // Side.
    "G91 G33 X0 Z-9 F2", "G91 G32 X-9 Z0 F2", "G91 G71 X0 Z-9 D1 H1 F2", "G91 G72 X-9 Z0 D1 H1 F2 M74", "G91 G33 X-2 Z-9 I2 F2",
    "G91 G32 X-9 Z-2 K2 F2", "G91 G71 X-1 Z-9 D1 H3 F2 M74", "G91 G72 X-9 Z-1 D1 H1 F2 M74", "G91 G31 X2 Z9 I-1 F2",
    // Length.
    "G91 G33 X-5 Z0 F2", "G91 G32 X0 Z-5 F2", "G91 G71 X-5 Z0 D1 H1 F2", "G91 G72 X0 Z-5 D1 H1 F2", "G91 G34 X5 F2", "G91 G35 Z5 F2 M27",
    "G34 X5 F2 M26", "G91 G33 X-5 Z-9 K9 F2", "G91 G31 X-5 Z9 K-12 F2", "G91 G32 X-9 Z-5 I9 F2", "G91 G33 X-5 Z-9 K-9 F2", "G91 G35 Z0 X5 F2",
    // The chamfer.
    "G91 G33 X-5 Z-9 L9.1 F2 M23", "G91 G32 X-9 Z-5 L9.1 F2 M23", "G91 G71 X-5 Z-9 D1 H1 L50 F2 M23 M74", "G91 G33 X-5 Z-9 F10 M23",
    "G91 G33 X-5 Z-9 F2 M23 M05", "G91 G32 X-9 Z-5 F2 M23 M19", "G91 G71 X-5 Z-9 D1 H1 F2 M23 M05 M74", "M03 S0\nG91 G33 X-5 Z-9 F2 M23",
    "G91 G72 X-9 Z-5 D1 H1 F2 M23 M05", "G91 G33 X-500 Z-9 I200 L2 F9 M23 M03 S65535", "G91 G32 X-9 Z-500 K200 L2 F9 M23 M03 S65535",
    "G91 G71 X-500 Z-9 I200 L2 F9 D1 H1 M74 M23 M03 S65535",
    // M75.
    "G91 G71 X-9 Z-9 D1 H5 U1 F2 M75", "G91 G72 X-9 Z-9 D1 H5 W1 F2 M75", "G91 G71 X-9 Z-9 D1 H5 F2 M75", "G91 G72 X-9 Z-9 D1 H5 F2 M75",
    // The C axis.
    "M110\nG91 G33 X-5 Z-9 F2", "M110\nG91 G34 Z-9 F2", "M110\nG91 G71 X-5 Z-9 D1 H1 F2",
];

/// Chamfers on tapers that open faster.
#[rustfmt::skip]
pub(super) const OPENING_TAPERS: &[&str] = &[
    "G91 G33 X-50 Z-9 I20 L2 F99 M23 M03 S65535", "G91 G31 X-50 Z-9 I20 L1 F99 M23 M04 S65535",
    "G91 G32 X-9 Z-50 K40 L1 F99 M23 M03 S65535", "G91 G71 X-50 Z-9 I20 L2 F99 D1 H1 M74 M23 M03 S65535",
    "G91 G72 X-9 Z-50 K40 L1 F99 D1 H1 M74 M23 M04 S65535", "G91 G33 X50 Z-9 I-20 L4 F99 M23 M03 S65535",
];

/// Threads at constant cutting speed.
#[rustfmt::skip]
pub(super) const CONSTANT_SPEED: &[&str] = &[
    "G96 S100 G33 X5 Z5", "G96 S100 G71 X5 Z5 D1 H2", "G96 S100\nG32", "G96 S100 G31 X5", "G96 S100\nG72 X5 Z5 D1 H2",
    "G33\nG96 S100\nX5 Z5", "G96 S5\nG34", "G35\nG96 S5\nZ5", "G91 G33 X-5 Z-9 F2\nG96 S100\nX-6", "G96 S100\nG72",
    "G91 G31 X-5 Z-9 F2\nG96 S9\nX-6 L1", "G91 G34 Z-5 F2\nG96 S9\nZ-6", "G91 G32 X-9 Z-5 F2\nG96 S9\nZ-6",
];

/// Threads without a lead.
#[rustfmt::skip]
pub(super) const WITHOUT_LEAD: &[&str] = &[
    "G94 G01 X5 F200\nG95 G33 X6 Z6", "G94 G01 X5 F200\nG34 Z5", "G94 F200\nG91 G71 X-5 Z-9 D1 H1",
    "G94 F200\nG95\nG91 G33 X-5 Z-9 J2",
];

/// Threads while compensation is in force.
#[rustfmt::skip]
pub(super) const IN_COMPENSATION: &[&str] = &[
    "G33 X5 Z5 F2", "G31\nX5 Z5 F2", "G32", "G71 X5 Z5 D1 H2 F2", "G72 X5 Z5 D1 H2 F2", "G42 G33 X5 Z5", "G41 G71 X5 Z5 D1 H1",
];

/// The same where the block ends it, lengths in it, and a displacement that is left over.
#[rustfmt::skip]
pub(super) const BESIDE_COMPENSATION: &[&str] = &[
    "G40 G33 X5 Z5 F2", "G40 G71 X5 Z5 D1 H2 F2", "G34 Z5 F2", "G35 X5 Z5 F2", "G40 G34 Z5 F2", "G40 G32", "G40\nG33 X5 Z5 F2",
    "G40\nG34 Z5 F2", "G40\nG72 X5 Z5 D1 H2 F2", "G34\nG42 Z5 F2",
    "G34 A5 F2\nX5 Z9 A60", "G01 A5 F2\nG35 X5 Z9 A60",
];

//! Texts of faults of cutter radius compensation.
//!
//! They stand behind a positioning to X100 Z50 C0 in G90 and G94, with the C axis joined and a cutter of radius 5. A first line `~`
//! begins compensation on the face and cuts to X80 C30, `@` on the side and cuts to Z30, `^` in conversion mode and cuts to X20 Y20;
//! the cutter is on the right, and outside of what follows mostly.

use super::Fault;

/// What the marks stand for.
pub(super) const MARKS: &[(&str, &[&str])] = &[
    ("~", &["G17 G42 G01 X80", "G101 X80 C30"]),
    ("@", &["G119 G42 G01 Z45", "Z30"]),
    ("^", &["G137 C0", "G00 X60 Y20", "G17 G42 G00 X50 Y20", "G101 X20"]),
];

/// The alarms of programs with cutter radius compensation, by their weights.
pub(super) const FAULTS: &[(usize, Fault)] = &[
    (70, Fault::Unspecified),
    (8, Fault::ContourXChanged),
    (8, Fault::ContourXNotPositive),
    (8, Fault::CAxisClamped),
    (8, Fault::NotModelled),
    (8, Fault::CompensationArcTooSmall),
    (8, Fault::CompensationNoIntersection),
    (6, Fault::CompensationNotAllowed),
    (6, Fault::PlaneChangeInCompensation),
    (6, Fault::WordWithoutFunction),
    (6, Fault::ProfileGeneration),
    (6, Fault::TravelLimitNegative),
    (6, Fault::TravelLimitPositive),
    (4, Fault::CoordinateRange),
    (4, Fault::WordMissing),
    (3, Fault::ContourArcZ),
    (4, Fault::ArcRadiusTooSmall),
    (2, Fault::NoFeed),
    (2, Fault::CAxisNotJoined),
];

#[rustfmt::skip]
pub(super) const FORMS: &[(Fault, &[&str])] = &[
    (Fault::ContourXChanged, &[
        "@\nX90 Z20", "@\nX100.001", "G119 G41 X90 Z45", "G119 G42 G01 X110", "@\nG40 X90 Z50", "@\nG91 X2", "@\nM08\nG91 X-0.001 C5", "@\nG132 X90 Z20 L60",
        "G119 G41 G00 Z45\nX90", "@\nVZSHX=7\nX100",
    ]),
    (Fault::ContourXNotPositive, &[
        "~\nG01 X-10", "G00 X-10\nG17 G41 G01 X20", "G00 X0\nG119 G41 G01 Z40", "~\nG91 G00 X-100", "G00 X-10\nG119 G42 G01 C50", "~\nG103 X0 L90",
        "~\nG101 X0\nG102 X10 L20", "G00 X-5\nG17 G42 C5", "~\nG40 G01 X-5", "G17 G41 G00 X-5", "G00 X-10\nG119\nG42 G00 Z40 C9",
    ]),
    (Fault::CAxisClamped, &[
        "~\nX70 M147", "@\nZ20 M147", "~\nM147\nX70", "G17 G41 G01 X80 M147", "@\nM147\nG40 Z40", "^\nM147\nY40", "@\nG132 Z20 L60 M147", "~\nG102 X60 L60 M147", "@\nG00 C30 M147",
    ]),
    (Fault::NotModelled, &[
        "~\nM25\nX70", "~\nM21 X70", "@\nM25 Z20", "@\nM21\nG40 Z40", "^\nY40 M25", "^\nM21\nG40 Y40", "M25\nG17 G41 G01 X80", "G119 G42 G00 Z45 M21", "~\nM21\nG103 C60 L60",
    ]),
    (Fault::CompensationArcTooSmall, &[
        "~\nG102 X80 C34 L4", "@\nG132 Z24 L4", "^\nG102 X16 Y20 L4", "^\nG102 X12 L4.5", "@\nG132 Z20.002 L4.999", "G17 G41 G01 X80\nG103 X80 C356 L3", "G119 G41 G01 Z45\nG133 Z40 L3\nM02",
    ]),
    (Fault::CompensationNoIntersection, &[
        "^\nG103 X30 Y30 L10", "^\nG102 X8 Y20 L6", "@\nG132 Z18 L6", "^\nG103 X20 Y40 L10", "@\nG132 C0 Z19 L5.5", "^\nG102 X10 Y20 L5\nG101 Y50", "@\nG132 Z19.99 L5.005\nG01 Z10",
    ]),
    (Fault::CompensationNotAllowed, &[
        "~\nG50 X5", "@\nG50 C5", "^\nG137 C5", "~\nG50 Z5 S100", "^\nG50 Z5", "G17 G41 G137 C0", "~\nG137 C0", "@\nG50 X100", "G119\nG42 G137 C5",
    ]),
    (Fault::PlaneChangeInCompensation, &["~\nG17", "@\nG18 Z5", "~\nG119 C60", "^\nG18", "@\nG119 Z20", "~\nG18 X50", "^\nG17 X5"]),
    (Fault::WordWithoutFunction, &[
        "G17 G41 G01 X80 I5", "G119 G42 G01 Z45 K5", "~\nG40 G01 X90 I5 K5", "@\nG40 Z40 K1", "~\nG01 X70 I5", "G17 G42 G00 X90 K0", "^\nG40 X5 I3", "~\nX70 A5", "^\nC5",
    ]),
    (Fault::CoordinateRange, &["^\nX50 Y20.001", "^\nX50 Y19.999\nY50", "~\nG01 X99999\nC40", "@\nZ99998\nC40\nZ99990"]),
    (Fault::WordMissing, &["~\nG102 C60", "@\nG132 Z20", "^\nG103 Y40", "@\nG133\nC60", "~\nG103 X60"]),
    (Fault::ContourArcZ, &["~\nG102 C60 Z20 L90", "^\nG103 Y40 Z5 L70"]),
    (Fault::ArcRadiusTooSmall, &["~\nG102 C120 L5", "@\nG132 Z10 L9.999", "^\nG103 X5 Y40 L9", "@\nG133 C60 L26"]),
    (Fault::CAxisNotJoined, &["M109\nG17 G42 G01 X80", "M109\nG119\nG41 G00 Z45", "M109\nG17"]),
];

/// What the manual does not describe.
#[rustfmt::skip]
pub(super) const NOT_DESCRIBED: &[&str] = &[
    // No travel in the plane.
    "~\nX80 C30", "~\nG00 C30", "~\nG91 X0", "@\nZ30", "@\nC0", "^\nX20", "^\nG00 X20 Y20", "^\nG91 G101 X0", "G17 G41 G01 X80\nC0", "G119 G41 G00 Z45\nZ45", "~\nG103 C30 L50",
    "@\nG132 L60", "@\nG133 Z30 C0 L60", "~\nG102 L50",
    // Two blocks without motion in the plane.
    "~\nM08\nM09", "~\nZ40\nZ30", "@\nG04 F1\nM08", "~\nG04 F1\nZ20", "G17 G41 G01 X80\nM08\nS100", "G119 G41 G00 Z40\nM09\nM08", "^\nZ5\nZ6", "@\nX100\nM08", "^\nG90\nG91", "@\nS100\nM12",
    "~\nM08\nN99\nM09", "~\nG01 Z40\nG00 Z50",
    // The frame changes.
    "~\nVZSHX=7\nC60", "~\nVZOFZ=3\nC60", "~\nVZSHC=5\nX70", "@\nVZSHX=1\nZ20", "@\nVZOFC=5\nC20", "^\nVZSHZ=2\nG101 X10", "~\nVZSHX=7\nG40 G01 X90", "@\nVZOFZ=9 Z20", "~\nVTOFX[1]=3 T310101\nC60",
    "^\nVZSHX=3\nG40 Y40", "@\nVZSHZ=VZSHZ+1\nG132 Z20 L60", "^\nVZOFC=VZOFC+5\nY40",
    // The C axis is taken off.
    "~\nM109", "@\nM109 Z20", "~\nG40 G01 X90 M109", "G17 G41 G01 X80 M109", "^\nM109", "@\nG40 Z40 M109", "@\nM08 M109",
    // Start-up and cancel.
    "G17 G41", "G17 G42 G01", "G119 G41 M08", "G17 G41 G01 Z40", "G119 G42 G01 X100", "G17\nG41 G04 F1", "G119\nG42", "G119 G41 G50 S100", "G137 C0\nG00 X60 Y20\nG17 G41 Z40",
    "G18 G42 G01 X90 Z45\nZ20\nG40\nG17 G41 G01 X80", "G18 G41 G01 X90 Z45\nX80\nG40\nG119 G41 G01 Z40",
    "~\nG40", "@\nG40 M08", "~\nG40 Z20", "^\nG40", "@\nG40 G04 F1", "@\nG40 X100", "~\nG40 G18", "^\nG40 Z5", "~\nG40 G50 X5", "~\nG40 G29 PZ=5",
    // In an arc.
    "G17 G41 G102 X60 L60", "G17 G42 G103 C30 L60", "G119 G41 G132 Z30 L60", "~\nG40 G102 X60 C30 L90", "@\nG40 G133 Z20 L60", "^\nG40 G103 X5 L60", "G119\nG133 Z30 L60\nG42 Z20 L60",
    "G17\nG102 C60 L60\nG41 C90 L60",
    // An end that no element comes before.
    "G17 G41 G01 X80\nG40 X90", "G119 G42 G00 Z45\nM02", "G17 G41 G01 X80\nM08\nM30", "G119 G41 G01 Z45\nG40 Z50", "G137 C0\nG00 X60 Y20\nG17 G41 X50\nG40 Y5", "G17 G42 G101 X80\nM02",
    // The other side.
    "~\nG41 C60", "@\nG41", "^\nG41 X5", "@\nG41 Z20", "~\nG41",
    // Other motion codes.
    "~\nG02 X70 Z40 L90", "@\nG101 C20", "@\nG102 C20 L90", "@\nG03 X90 Z20 L90", "^\nG102 X10 L60\nG132 C5 L60", "~\nG132 C60 L90", "~\nG133 Z20 L90", "@\nG103 C60 L60", "G17 G41 G133 Z20 L60",
    "G119 G42 G101 C20", "G119 G42 G103 C20 L60", "@\nG40 G101 C20", "~\nG40 G03 X90 Z40 L90", "G17 G41 G02 X90 Z40 L90",
    // Angles and corners.
    "~\nG01 A30 X70", "~\nG01 QA=1", "~\nG01 G75 X70 L1", "@\nG01 G76 Z20 L1", "@\nA30 Z20", "G17 G41 G01 A30 X80", "~\nG01 C60 QA=1", "@\nG00 QA=2 Z20", "G119 G41 QA=1", "@\nG40 G01 A30 Z40", "~\nG40 G01 G75 X70 L1",
    // Conversion mode and compensation.
    "G137 C0\nG00 X60 Y20\nG119 G41 X50 Y20", "^\nG136", "G137 C0\nG00 X60 Y20\nG18 G41 X50", "~\nG40 G137 C0", "@\nG40 G137 C5",
    // A torque skip, contours in another plane, feed per revolution, the motion of turning.
    "~\nG22 Z5 D1 L1 F1 PZ=5", "@\nG40 G22 Z5 D1 L1 F1 PZ=5", "^\nG22 Z5 D1 L1 F1 PZ=1", "@\nG22 Z5 D1 L1 F1 PZ=1", "~\nG95 G101 C60", "@\nG95 G132 Z20 L60", "G18 G42 G01 X90 Z45\nZ20\nG101 C60",
    "^\nG01 Y40", "^\nG02 X10 Y5 L60",
    // LAP.
    "G17\nNQ7 G81\nG00 X80 Z40\nG42 G01 Z20\nX90\nG80\nG85 NQ7 D2", "G119\nNQ7 G81\nG00 X80 Z40\nG41 G01 Z20\nX90\nG80\nG87 NQ7", "G17\nNQ7 G81\nG00 X80 Z40 G42\nG01 Z20\nX90\nG80\nG86 NQ7 D2",
    "G17\nNQ7 G82\nG00 X80 Z40\nG41 G01 X60\nZ45\nG80\nG85 NQ7 D2", "G119\nNQ7 G81\nG00 X80 Z40 G41\nG01 Z20\nX90\nG80\nG87 NQ7",
];

/// What it does not describe at the centre of the face.
#[rustfmt::skip]
pub(super) const AT_CENTRE: &[&str] = &[
    // The centre of the cutter ends there.
    "G137 C0\nG00 X60 Y-5\nG17 G42 G00 X50\nG101 X5\nY-30", "G137 C0\nG00 X60 Y-5\nG17 G42 G00 X50\nG101 X0\nM02", "G137 C0\nG00 X60 Y5\nG17 G41 X50\nG101 X5\nY30",
    "G137 C0\nG00 X60 Y5\nG17 G41 X50\nG101 X0\nG40 X-20", "G137 C0\nG00 X60 Y-5\nG17 G42 X0\nG101 X-30\nM02",
    // Past it.
    "G137 C0\nG00 X12.5 Y-20\nG17 G41 X12.5 Y-7.5\nG102 Y7.5 L7.5\nM02", "G137 C0\nG00 X12.5 Y20\nG17 G42 Y7.5\nG103 Y-7.5 L7.5\nG40 G00 X5 Y-40",
    "G137 C0\nG00 X-12.5 Y20\nG17 G41 Y7.5\nG102 Y-7.5 L7.5\nM02", "G137 C0\nG00 X15 Y-20\nG17 G41 Y-10\nG102 Y10 L10\nM02", "G137 C0\nG00 X15 Y20\nG17 G42 Y10\nG103 Y-10 L10\nG40 G00 X5 Y-40",
    // Z while C turns there.
    "G137 C0\nG00 X60 Y-5\nG17 G42 G00 X50\nG101 X-50 Z20\nM02", "G137 C0\nG00 X60 Y5\nG17 G41 G00 X50\nG101 X-50 Z20\nG40 Y40",
    "G137 C0\nG00 X60 Y-5\nG17 G42 G00 X50\nG91 G101 X-100 Z-9\nM02", "G137 C0\nG00 X-60 Y5\nG17 G42 X-50\nG101 X40 Z60\nG40 Y40",
];

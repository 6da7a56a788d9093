//! Texts of faults of contours and of coordinate conversion.

use super::Fault;

/// The alarms of programs with contours, by their weights.
pub(super) const FAULTS: &[(usize, Fault)] = &[
    (70, Fault::Unspecified),
    (8, Fault::WordMissing),
    (6, Fault::ArcRadiusNotPositive),
    (6, Fault::ArcRadiusTooSmall),
    (6, Fault::CAxisClamped),
    (6, Fault::CAxisNotJoined),
    (6, Fault::CompensationNotAllowed),
    (5, Fault::ContourArcZ),
    (6, Fault::ContourCommandUnusable),
    (5, Fault::ContourXChanged),
    (7, Fault::ContourXNotPositive),
    (5, Fault::ConversionAtLimit),
    (5, Fault::ConversionAxisMissing),
    (6, Fault::ConversionIncremental),
    (6, Fault::MotionCodeMissing),
    (5, Fault::NotAlone),
    (6, Fault::NotModelled),
    (6, Fault::ProfileGeneration),
    (4, Fault::AddressUnknown),
    (5, Fault::WordWithoutFunction),
    (3, Fault::CompensationNotLinear),
    (3, Fault::ChamferNotLinear),
    (3, Fault::ChamferCorner),
    (3, Fault::AngleLookahead),
    (3, Fault::NoFeed),
    (3, Fault::TravelLimitNegative),
    (3, Fault::TravelLimitPositive),
    (3, Fault::CoordinateRange),
    (2, Fault::GCodesConflict),
];

/// Lines behind a positioning that allows contours: G90, G00, G94 with a feed, X100 Z50 C0, C joined.
#[rustfmt::skip]
pub(super) const FORMS: &[(Fault, &[&str])] = &[
    (Fault::WordMissing, &[
        "G137 C0\nG181 X30 Y40 R-5 K1\nG180\nG136\nG00 X50", "G137 C0\nG189 X30 Y40 R-5 K1\nG180\nG136\nG00 Z50", "G137 C0\nG181 X30 Y40 R-5 K1\nG180\nG00 X5 Y5",
        "G102 C90", "G103 X50 C90", "G132 Z20 C60", "G133 C60", "G102", "G133", "G103 C90 L60\nC180", "G137", "G137 X5", "G137 F5",
        "G137 C0\nG00 X30 Y40\nG102 X40", "G137 C0\nG00 X30 Y40\nG103 X40 Y30 L70\nX30 Y40",
    ]),
    (Fault::ArcRadiusNotPositive, &[
        "G102 C90 L0", "G103 X50 L-60", "G132 Z20 L0", "G133 C60 L-200", "G102 C90 L-0", "G137 C0\nG00 X30 Y40\nG102 X40 L0",
    ]),
    (Fault::ArcRadiusTooSmall, &[
        "G102 C90 L35.355", "G103 C180 L49.999", "G132 Z20 L14.999", "G132 C60 L26.179", "G133 Z20 C60 L5", "G102 X50 L12.499",
        "G137 C0\nG00 X30 Y40\nG102 X-30 L29.999", "G137 C0\nG00 X30 Y40\nG103 X-30 Y-40 L49.999", "G103 X60 C180 L39.999",
    ]),
    (Fault::CAxisClamped, &[
        "M147\nG101 C90", "G102 C90 L50 M147", "G101 X50 M147", "G132 Z20 L60 M147", "G137 C0\nG00 X30 Y40 M147",
        "G137 C0\nG00 X30 Y40\nG101 X40 M147", "M147\nG103 X50 L60", "M147\nG133 C90 L90",
    ]),
    (Fault::CAxisNotJoined, &[
        "M109\nG101 C90", "M109\nG101 X50", "M109\nG102 X50 L60", "M109\nG132 Z20 L60", "M109\nG137 C0\nG00 X30 Y40",
        "G137 C0\nG00 X30 Y40\nG101 X50 M109", "G103 X50 L60 M109",
    ]),
    (Fault::ContourArcZ, &[
        "G102 C90 Z20 L50", "G103 Z50 L50", "G102 Z", "G102 C90 L50\nZ10 L50", "G137 C0\nG00 X30 Y40\nG103 X40 Y30 Z5 L70", "G91 G103 C90 Z0 L50",
    ]),
    (Fault::ContourXChanged, &[
        "G132 X100.001 Z20 L60", "G133 X90 C60 L60", "G91 G132 X2 Z-30 L60", "G132 X-100 Z20 L60", "G91 G133 X-0.001 Z-30 L60",
    ]),
    (Fault::ContourXNotPositive, &[
        "G101 X-10", "G103 X0 L60", "G101 X0\nG103 X10 L20", "G00 X-10\nG101 X10", "G00 X0\nG132 Z20 L60", "G00 X-5\nG133 Z20 C60 L60",
        "G91 G101 X-100.001", "G00 X-10\nG102 X10 L20", "G137 C0\nG00 X30 Y40\nG102 X0 Y0 L50", "G137 C0\nG00 X0 Y0\nG103 X5 L50",
        "G00 X0\nG132 L60", "G00 X-10\nG101 C90",
    ]),
    (Fault::ConversionAxisMissing, &["G137 C0\nG00 X30", "G137 C0\nG00 Y40", "G137 C20\nG00\nZ5\nY40", "G137 C0\nG101 X5", "G137 C0\nG102 Y5 L50", "G137 C0\nG181 X30 R-5 K1", "G137 C0\nG189 Y40 R-5 K1"]),
    (Fault::ConversionIncremental, &[
        "G91\nG137 C0", "G91 G137 C0", "G137 C0 G91", "G137 C0\nG91", "G137 C0\nG91 G00 X30 Y40", "G137 C0\nG00 Z5\nG91 Z5",
        "G137 C0\nG00 X30 Y40\nG137 C5\nG91",
    ]),
    (Fault::MotionCodeMissing, &[
        "G137 C0\nX30 Y40", "G137 C0\nZ10", "G137 C0\nG00 X30 Y40\nG137 C5\nZ2", "G137 C0\nG136\nX5", "G137 C0\nG136\nC5", "G137 C0\nL5",
        "G137 C0\nG42", "G137 C0\nY5", "G137 C0\nG136\nG41 X5",
    ]),
    (Fault::NotAlone, &["G137 C0\nG136 Z5", "G136 M12", "G136 F5", "G136 G18", "G00 G136", "G136 G136", "G136 X5 Y5", "N5 G136 S5"]),
    (Fault::AddressUnknown, &["Y5", "G00 X5 Y5", "G137 C0 Y5", "G101 Y5", "G137 C0\nG136\nG00 Y5"]),
    (Fault::WordWithoutFunction, &[
        "G101 C90 I5", "G102 C90 L50 A5", "G132 Z20 L60 I5", "G137 C0\nG00 X30 Y40 C5", "G137 C0\nG00 X30 Y40 A5", "G137 C0 X5", "G137 C0 Z5",
        "G101 X50 L50", "G101 X50 Z5 K2", "G133 Z20 L60 D5", "G137 C0\nG00 X30 Y40\nG101 X50 C5", "G137 C0\nG01 Z5 C5", "G04 F1 L50",
        "G137 C0\nG00 X30 Y40\nG102 X40 W5", "G137 C0\nI5", "G137 C0\nG181 X30 Y40 C5 R-5 K1",
    ]),
    (Fault::CompensationNotLinear, &["G102\nG42", "G103 G41", "G132\nG42", "G133 G41 Z5 L60", "G102 G42 C90 L60"]),
    (Fault::ChamferNotLinear, &["G101 G75 X50 L1", "G102\nG76 X50 L1", "G133 G75 Z5 L1", "G103 G76 C90 L50"]),
    (Fault::ChamferCorner, &["G01 G75 X50 L1\nG101 C90", "G01 G76 X50 L1\nG102 C90 L60", "G01 G75 X50 L1\nG137 C0", "G01 G75 Z20 L1\nG132 Z5 L90"]),
    (Fault::AngleLookahead, &["G01 A30\nG101 C90", "G01 A30\nG137 C0", "G01 A30\nG136", "G01 A30\nG103 C90 L60", "G01 A30\nG133 Z5 L90"]),
    (Fault::CoordinateRange, &["G137 C0\nG00 X99999 Y99999", "G137 C0\nG00 X30 Y40\nG101 X90000 Y90000", "G137 C0\nG00 X-99999 Y5\nG102 Y99999 L99999"]),
    (Fault::GCodesConflict, &["G101 G102 C90", "G132 G133 Z5", "G136 G04", "G137 G04 F1 C0", "G50 G137 C0", "G101 G00 X5", "G22 G137 C0"]),
];

/// Lines that the manual does not describe.
#[rustfmt::skip]
pub(super) const NOT_DESCRIBED: &[&str] = &[
    // Feed per revolution.
    "G95 G101 X50", "G95 G103 X50 L60",
    "G95 G101 C90 F1", "G95\nG102 C90 L60", "G95 G132 Z20 L60", "G95\nG133 C60 L60",
    // Z at the centre.
    "G101 X60 C180 Z20", "G101 X0 C90 Z20", "G101 X0\nX50 C90 Z20", "G91 G101 C180 Z-1", "G137 C0\nG00 X30 Y40\nG101 X-30 Y-40 Z5",
    // A whole circle, or nothing.
    "G102 C0 L50", "G103 L50", "G132 L60", "G133 Z50 C0 L60", "G91 G102 C0 L50", "G137 C0\nG00 X30 Y40\nG102 X30 L50",
    "G137 C0\nG00 X30 Y40\nG103 L50", "G132 C360 L90", "G91 G133 Z0 L60",
    // An arc that passes the centre of the face.
    "G00 X22.361 C63.435\nG103 C296.565 L12.5", "G137 C0\nG00 X5 Y10\nG103 Y-10 L12.5", "G137 C0\nG00 X50 Y100\nG102 X-50 Y100 L125\nG103 X50 Y100 L125\nG00 X50 Y100\nG103 Y-100 L125",
    "G137 C0\nG00 X-5 Y-10\nG103 Y10 L12.5",
    // No point.
    "G137 C0\nG101 X30 Y40", "G137 C0\nG00 X30 Y40\nT0101\nT0202\nG101 X50 Y40", "G137 C0\nG00 X30 Y40\nG50 Z5\nVZSHX=5\nG101 X50", "G137 C0\nG102 X30 Y40 L50",
    "G137 C0\nG00 X30 Y40\nVZSHX=7\nY-40", "G137 C0\nG00 X30 Y40\nVZSHX=7\nG91 X1 Y1", "G137 C0\nG101\nZ5", "G137 C0\nG00 X30 Y40\nG137 C5\nG101 X5 Y5",
    "G50 C30\nG137 C0\nG00 X30 Y40\nVZSHC=330\nY-40", "G50 C30\nG137 C0\nG00 X30 Y40\nVZSHC=330\nG101 Y-40",
    // Words in conversion mode.
    "G137 C0\nG00 X30 Y40\nG01 Y20", "G137 C0\nG01 X5 Y5", "G137 C0\nG02 X50 Z-5 L20", "G137 C0\nG00 X30 Y40\nG03 X5 Y5 L20", "G137 C0\nG00 X30 Y40\nG50 X0",
    "G137 C0\nG50 C5", "G137 C0\nG01 G75 Z-5 L1", "G137 C0\nG33 X5 Z5", "G137 C0\nG00\nG71 X5 Z5 D1 H2", "G137 C0\nG132 Z5 L60", "G137 C0\nG34 Z5", "G137 C0\nG00 G76 Z5 L1",
    "G137 C0\nG35",
    // Cycles that go in no plane, and in the mode of a cycle.
    "G137 C0\nG190 X30 Z5 K1 D1 E5", "G137 C0\nG181 X30 Z5 I1", "G137 C0\nG74 Z5 D1", "G137 C0\nG73 X5 D1", "G137 C0\nG95 G185 X5 Z5 F1 SA=5",
    "G137 C0\nG77 X5 Z5 K1", "G137 C0\nG189 X30 Y40 R-5 K1\nI1 Y30", "G181 X50 R-5 K1\nG137 C0", "G137 C0\nG181 X30 Y40 R-5 K1\nG136",
    "G137 C0\nG181 X30 Y40 R-5 K1 Q2\nG180\nG00 X5 Z50",
    // A motion code in the block of G137.
    "G137 C0 G00", "G00 G137 C90", "G01 G137 C0", "G137 C0 G101", "G132 G137 C0", "G137 G33 C5",
    // Compensation.
    "G137 C0\nG00 G42 Z5", "G137 C0\nG00\nG41",
];

/// Lines in which compensation is in force or ends, with X and Z of its start-up before them.
#[rustfmt::skip]
pub(super) const IN_COMPENSATION: &[&str] = &[
    "G101 C90", "G102 C90 L60", "G132 Z20 L60", "G133 Z20 C60 L60", "G40 G101 C90", "G40 G137 C0", "G136", "G40\nG136", "G40\nG137 C0", "G40\nG101 C90", "G40\nG132 Z20 L60",
    "G103 C9 L60", "G40\nG103 C90 L60", "G40 G101",
];

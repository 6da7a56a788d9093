//! Texts of faults of LAP: `~` is a longitudinal definition that is sound, `^` a transverse one, `@` a distance from the
//! present point and `#` an amount, both in millimetres.

use super::Fault;

/// A sound definition, which the present point lies outside of.
pub(super) const ALONG: &str = "NQ1 G81\nG00 X@-16 Z@-2\nG01 Z@-12\nX@-4\nG80";
pub(super) const ACROSS: &str = "NQ1 G82\nG00 X@-2 Z@-6\nG01 X@-20\nZ@-2\nG80";

/// The alarms of programs with LAP, by their weights.
pub(super) const FAULTS: &[(usize, Fault)] = &[
    (24, Fault::ContourMalformed),
    (18, Fault::LapData),
    (18, Fault::Unspecified),
    (7, Fault::LapStartPoint),
    (6, Fault::LapAllowance),
    (5, Fault::LapLevel),
    (5, Fault::ContourDirection),
    (4, Fault::DescendingSlopes),
    (4, Fault::BlankFirstElement),
    (6, Fault::WordMissing),
    (7, Fault::WordWithoutFunction),
    (3, Fault::StatementMisplaced),
    (3, Fault::Format),
    (3, Fault::SequenceNameUnknown),
    (3, Fault::NotAlone),
    (3, Fault::AddressRange),
    (3, Fault::CompensationNotAllowed),
    (3, Fault::ThreadInConstantSpeed),
    (3, Fault::StepLimit),
    (2, Fault::NoFeed),
    (3, Fault::TravelLimitNegative),
    (3, Fault::TravelLimitPositive),
    (1, Fault::CoordinateRange),
    (2, Fault::Barrier),
    (1, Fault::GCodesConflict),
];

/// Definitions and calls that raise an alarm.
#[rustfmt::skip]
pub(super) const TEXTS: &[(Fault, &[&str])] = &[
    (Fault::ContourMalformed, &[
        "G80", "G80 X@5", "G01 G80", "~\nG88 NQ1 D#1 H#2 M74", "NQ1 G83\nG00 X@-9 Z@-2\nG81\nG80\nG88 NQ1 D#1 H#2 M74",
        "G85 NQ1 D#1\nM02\nNQ1 X@5\nG80", "N=\nNQ1\nG85 NQ1 D#1", "G81\nM02", "G83\nG81\nX@5", "G85 NQ1 D#1\nM02\nNQ1 G81\nG00 X@-9 Z@-2",
        "G87 NQ1\nM02\nNQ1 G81\nG00 X@-9 Z@-2\nM02", "NQ1 G83\nG00 X@-9 Z@-2\nG80\nG85 NQ1 D#1", "NQ1 G83\nG00 X@-9 Z@-2\nG80\nG87 NQ1",
        "NQ1 G81\nG00 X@-9 Z@-2\nG83\nG80\nG86 NQ1 D#1", "NQ1 G83\nG00 X@-9 Z@-2\nG83\nG81\nG80\nG86 NQ1 D#1",
        "NQ1 G83\nG00 X@-9 Z@-2\nG01 Z@-5 G41\nG81\nG80\nG85 NQ1 D#1", "NQ1 G83\nG00 X@-9 Z@-2\nG01 Z@-5 G75 L#1\nG81\nG80\nG85 NQ1 D#1",
        "NQ1 G83\nG00 X@-9 Z@-2\nG00 Z@-5\nG81\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG04 F1\nG80\nG85 NQ1 D#1",
        "NQ1 G81\nG00 X@-9 Z@-2\nG34 Z@-9 F1\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9 M08\nG80\nG85 NQ1 D#1",
        "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9 T0101\nG80\nG86 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9 C5\nG80\nG85 NQ1 D#1",
        "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9 SB=5\nG80\nG87 NQ1", "NQ1 G81\nG02 X@-9 Z@-2 I#5\nG80\nG85 NQ1 D#1",
        "NQ1 G81\nG01 X@-9 Z@-2\nG34 Z@-9 F1\nG80\nG88 NQ1 D#1 H#2 M74", "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9\nG80\nG88 NQ1 D#1 H#2 M74",
        "NQ1 G81\nG00 X@-9 Z@-2\nZ@-9\nG80\nG85 NQ1 D#1", "NQ1 G81\nG90\nG00 X@-9 Z@-2\nG80\nG85 NQ1 D#1", "NQ1 G81\nG91\nG80\nG87 NQ1",
        "NQ1 G81\nG94\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG96 S100\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG64\nG80\nG87 NQ1",
        "NQ1 G81\nG00 X@-9 Z@-2\nG85 NQ1 D#1\nG80\nG85 NQ1 D#1", "NQ1 G81\nG87 NQ1\nG80\nG87 NQ1",
        "NQ1 G81\nG00 X@-9 Z@-2 G42\nG01 Z@-9\nX@-5\nG80\nG86 NQ1 D#1", "NQ1 G81\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG80\nG86 NQ1 D#1",
        "NQ1 G83\nG81\nG00 X@-9 Z@-2\nG01 Z@-9\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nM02\nG80\nG85 NQ1 D#1",
    ]),
    (Fault::LapData, &[
        "~\nG85 NQ1 D0", "~\nG86 NQ1 D0", "~\nG88 NQ1 D0 H#2", "~\nG85 NQ1 D#1 F0", "~\nG86 NQ1 D#1 F-1", "~\nG85 NQ1 D#1 G84 XA=@-4 DA=0",
        "~\nG85 NQ1 D#1 G84 XA=@-4 FA=0", "~\nG85 NQ1 D#1 G84 XB=@-4 FB=-1", "~\nG85 NQ1 D#1 G84 XA=@4 DA=#1", "~\nG85 NQ1 D#1 G84 XA=@-8 XB=@-4",
        "~\nG85 NQ1 D#1 G84 XB=@0 DB=#1", "^\nG85 NQ1 D#1 G84 ZA=@-4 ZB=@-3", "^\nG85 NQ1 D#1 G84 ZA=@0", "~\nG88 NQ1 D#1 H0", "~\nG88 NQ1 D#1 H#2 B-1",
        "~\nG88 NQ1 D#1 H#2 B180000", "~\nG88 NQ1 D#1 H#2 U#2", "~\nG88 NQ1 D#1 H#2 W#3", "~\nG88 NQ1 D#2 H#2 U#1 M73", "~\nG88 NQ1 D#3 H#2 M73",
        "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9 E0\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nG01 Z@-9 E-1\nG80\nG87 NQ1",
    ]),
    (Fault::Unspecified, &[
        "NQ1 G81\nG00 X@-9 Z@-2\nMODIN OA\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nRTS\nG80\nG85 NQ1 D#1", "NQ1 G81\nG00 X@-9 Z@-2\nVZOFX=1\nG80\nG85 NQ1 D#1",
        "NQ1 G81\nG00 X@-9 Z@-2\nREAD 1\nG80\nG87 NQ1", "NQ1 G81\nG00 X@-9 Z@-2\nG01 X@-4\nG80\nG85 NQ1 D#1", "NQ1 G82\nG00 X@-2 Z@-6\nG01 Z@-2\nG80\nG85 NQ1 D#1",
        "NQ1 G81\nG00 X@-16 Z@-2\nG01 Z@-9\nZ@-6\nZ@-20\nG80\nG85 NQ1 D#2", "NQ1 G81\nG00 X@-16 Z@-2\nG01 Z@-9\nX@-8\nX@-12\nZ@-20\nG80\nG85 NQ1 D#2",
        "NQ1 G81\nG00 X@-16 Z@-2\nG02 X@-8 Z@-2 I#2\nG01 Z@-20\nG80\nG85 NQ1 D#2",
        "NQ1 G83\nG00 X@-4 Z@-2\nG01 Z@-9\nZ@-6\nZ@-20\nG81\nG00 X@-16 Z@-2\nG01 Z@-20\nG80\nG85 NQ1 D#2",
        "NQ1 G83\nG00 X@6 Z@-2\nG01 Z@-20\nG81\nG00 X@-16 Z@-2\nG01 Z@-20\nG80\nG85 NQ1 D#1",
        "NQ1 G83\nG00 X@-16 Z@-2\nG03 X@-8 Z@-6 L#4\nG01 Z@-20\nG81\nG00 X@-16 Z@-2\nG01 Z@-20\nG80\nG86 NQ1 D#2",
        "NQ1 G81\nG00 X@0 Z@-2\nG01 Z@-9\nX@6\nG80\nG87 NQ1 U#1", "NQ1 G81\nG00 X@-9 Z@0\nG01 Z@-9\nX@6\nG80\nG87 NQ1 W#1",
        "G97 S500\nG95 F1\nNQ1 G81\nG00 X@-1 Z@-2\nG34 Z@-9 F1\nG80\nG88 NQ1 D#1 H#4 M74",
    ]),
    (Fault::LapStartPoint, &[
        "NQ1 G81\nG00 X@0 Z@-2\nG01 Z@-9\nG80\nG85 NQ1 D#1", "NQ1 G82\nG00 X@-2 Z@0\nG01 X@-9\nG80\nG86 NQ1 D#1",
        "NQ1 G81\nG00 X@-9 Z@2\nG01 Z@-9\nG80\nG85 NQ1 D#1", "NQ1 G82\nG00 X@2 Z@-5\nG01 X@-9\nG80\nG85 NQ1 D#1",
        "G97 S500\nG95 F1\nNQ1 G81\nG00 X@0 Z@-2\nG34 Z@-9 F1\nG80\nG88 NQ1 D#1 H#2 M74",
    ]),
    (Fault::LapAllowance, &[
        "~\nG85 NQ1 D#1 U#16", "~\nG86 NQ1 D#1 U#20", "^\nG85 NQ1 D#1 W#6", "^\nG86 NQ1 D#1 W#9",
        "NQ1 G83\nG00 X@-4 Z@-2\nG01 Z@-20\nG81\nG00 X@-16 Z@-2\nG01 Z@-20\nG80\nG86 NQ1 D#2 W#60",
    ]),
    (Fault::BlankFirstElement, &[
        "NQ1 G83\nG02 X@-9 Z@-2 I#5\nG81\nG80\nG85 NQ1 D#1", "NQ1 G83\nG03 X@-9 Z@-2 L#50\nG82\nG80\nG86 NQ1 D#1",
    ]),
    (Fault::ContourDirection, &[
        "NQ1 G83\nG00 X@-4 Z@-2\nG01 Z@-9\nZ@-6\nZ@-20\nG81\nG00 X@-16 Z@-2\nG01 Z@-20\nG80\nG86 NQ1 D#2",
        "NQ1 G83\nG00 X@-4 Z@-2\nG01 Z@-20\nG81\nG00 X@-16 Z@-2\nG01 Z@-9\nZ@-6\nZ@-20\nG80\nG86 NQ1 D#2",
    ]),
    (Fault::DescendingSlopes, &[
        "NQ1 G81\nG91 G00 X#-30 Z#-1\nG01 X#4 Z#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nX#2\nZ#-1\nX#-2\nZ#-1\nG90 G80\nG85 NQ1 D#5",
    ]),
    (Fault::WordMissing, &[
        "~\nG85 NQ1", "~\nG86 NQ1 F1", "~\nG88 NQ1 H#1", "~\nG88 NQ1 D#1",
    ]),
    (Fault::WordWithoutFunction, &[
        "~\nG85 NQ1 D#1 S100", "~\nG86 NQ1 D#1 T0101", "~\nG86 NQ1 D#1 M08", "~\nG85 NQ1 D#1 G90", "~\nG86 NQ1 D#1 G84", "~\nG87 NQ1 D#1", "~\nG87 NQ1 M85",
        "~\nG85 NQ1 D#1 H#1", "~\nG88 NQ1 D#1 H#2 M85", "~\nG85 NQ1 D#1 X@5", "G84", "G84 X@5", "XA=@5", "DB=#1 X@5", "FA=1", "~\nG85 NQ1 D#1 G84 ZA=@-4",
        "^\nG85 NQ1 D#1 G84 XB=@-4", "~\nG85 NQ1 D#1 SB=5", "~\nG85 NQ1 D#1 XA=@-4",
        "G97 S500\nG95 F1\nNQ1 G81\nG00 X@-9 Z@-2\nG34 Z@-9 F1\nG80\nG88 NQ1 D#1 H#2 W#0.1 M74",
        "G97 S500\nG95 F1\nNQ1 G82\nG00 X@-9 Z@-6\nG34 X@-19 Z@-7 F1\nG80\nG88 NQ1 D#1 H#2 U#0.1 M74",
    ]),
    (Fault::StatementMisplaced, &["D#1 G85 NQ1", "X@5 G86 NQ1", "G90 G87 NQ1", "G01 G88"]),
    (Fault::Format, &["G85 D#1", "G86", "G87 X@5", "G88 5"]),
    (Fault::SequenceNameUnknown, &["G85 NQ2 D#1", "G86 NQ2 D#1", "G87 NQ2", "G88 NQ2 D#1 H#2 M74"]),
    (Fault::NotAlone, &["G81 X@5", "G82 G00", "G83 M08", "NQ1 G83 F1"]),
    (Fault::AddressRange, &["~\nG85 NQ1 D#-1", "~\nG86 NQ1 D#1 U#-1", "~\nG86 NQ1 D#1 W#-1", "~\nG85 NQ1 D#1 G84 XA=@-4 DA=#-1", "~\nG88 NQ1 D#1 H#-2"]),
    (Fault::ThreadInConstantSpeed, &["G96 S100\nG88 NQ1 D#1 H#2", "~\nG96 S50\nG88 NQ1 D#1 H#2 M74"]),
    (Fault::StepLimit, &["~\nG85 NQ1 D#0.05", "~\nG86 NQ1 D#0.1", "^\nG85 NQ1 D#0.03"]),
    (Fault::NoFeed, &["~\nG85 NQ1 D#4", "~\nG86 NQ1 D#4", "^\nG85 NQ1 D#2", "~\nG87 NQ1"]),
    (Fault::TravelLimitNegative, &["VNVLX=VAPAX-!\n~\nG85 NQ1 D#3", "VNVLZ=VAPAZ-!\n~\nG86 NQ1 D#4", "VNVLX=VAPAX-!\n^\nG85 NQ1 D#2", "VNVLZ=VAPAZ-!\n~\nG87 NQ1"]),
    (Fault::TravelLimitPositive, &["VPVLZ=VAPAZ+!\nNQ1 G81\nG00 X@-9 Z@2\nG01 Z@19\nX@6\nG80\nG85 NQ1 D#2", "VPVLX=VAPAX+!\nNQ1 G81\nG00 X@9 Z@-2\nG01 Z@-9\nG80\nG86 NQ1 D#5"]),
    (Fault::CoordinateRange, &["NQ1 G81\nG91 G00 X#-99999 Z#-9\nG01 X#-99999\nG90 G80\nG85 NQ1 D#1"]),
    (Fault::Barrier, &["NQ1 G81\nG00 X@-16 Z@-2\nG01 Z@-60\nG80\nM25\nG85 NQ1 D#4", "NQ1 G81\nG00 X@-16 Z@-2\nG01 Z@-60\nG80\nM25\nG86 NQ1 D#4"]),
    (Fault::GCodesConflict, &["~\nG85 NQ1 D#1 G84 G84", "G84 G84"]),
];

/// What is refused by the level of the option.
pub(super) const WITHOUT_LEVEL: &[&str] =
    &["G80", "NQ1 G81", "G82", "G83", "G84", "G85 NQ1 D#1", "G86 NQ1 D#1", "G87 NQ1", "G88 NQ1 D#1 H#2"];

/// Calls in compensation, or behind it.
pub(super) const IN_COMPENSATION: &[&str] = &["G85 NQ1 D#1", "G86 NQ1 D#1", "G87 NQ1", "G88 NQ1 D#1 H#2 M74"];

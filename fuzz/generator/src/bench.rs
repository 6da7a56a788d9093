//! Deterministic programs for benchmarks: they run without an alarm, on the default set-up if none is named.

use std::fmt::Write;

use turnspec_oracle::vocabulary::{Length, NoseRadius, Setup};

/// A program of rapids and lines, of `blocks` blocks (at least 2) with M02.
#[must_use]
pub fn straight_line(blocks: usize) -> Vec<u8> {
    let mut numbers = Numbers(1);
    let mut text = String::from("G95 G01 F0.25\n");
    for place in 2..blocks {
        let (x, z) = (numbers.length(300_000), numbers.length(200_000));
        let code = if place % 4 == 0 { "G00 " } else { "G01 " };
        let _ = match place % 3 {
            0 => writeln!(text, "{code}X{x}"),
            1 => writeln!(text, "{code}X{x} Z{z}"),
            _ => writeln!(text, "{code}Z{z} F0.{}", 1 + place % 9),
        };
    }
    text.push_str("M02\n");
    text.into_bytes()
}

/// A program of arcs by centre and by radius, of chamfers and roundings, of `blocks` blocks (at least 2).
#[must_use]
pub fn arcs_and_chamfers(blocks: usize) -> Vec<u8> {
    const GROUP: &[&str] = &[
        "G00 X100 Z50",
        "G03 X120 Z40 K-10",
        "G02 X140 Z30 I10",
        "G01 Z20 X160",
        "G03 X180 Z0 L30",
        "G75 G01 Z-30 L2",
        "G76 X220 Z-50 L3.5",
        "G75 Z-80 A165 L1.25",
        "X300 Z-100",
    ];
    let mut numbers = Numbers(2);
    let mut text = String::from("G95 G01 F0.2\n");
    let wanted = blocks.saturating_sub(2);
    let group = GROUP.len() + 1;
    for place in 0..wanted {
        let complete = place / group < wanted / group;
        let _ = match GROUP.get(place % group) {
            Some(line) if complete => writeln!(text, "{line}"),
            None if complete => writeln!(text, "G02 X{} Z-95 L{} CALRG", 301 + place % 7, 40 + place % 50),
            _ => writeln!(text, "G01 X{} Z{}", numbers.length(90_000), numbers.length(40_000)),
        };
    }
    text.push_str("M02\n");
    text.into_bytes()
}

/// A loop with a counting variable, a local variable, a motion and IF: a run begins about `blocks` blocks (at least 8). The
/// number of blocks, and the set-up that permits them, come with it.
#[must_use]
pub fn counting_loop(blocks: usize) -> (Vec<u8>, Setup, usize) {
    let passes = (blocks.saturating_sub(4) / 4).max(1);
    let text = format!(
        "G00 X0 Z0\nV1=0 XS=0\nN10 V1=V1+1 XS=XS+0.001\nN20 G00 X=XS\nN30 IF [V1 GE {passes}] N50\nN40 GOTO N10\nN50 M02\n"
    );
    (text.into_bytes(), long_run(), 2 + 4 * passes)
}

/// Calls within calls, three deep: a run makes about `calls` calls (at least 3). The number of blocks, and the set-up that
/// permits them, come with it.
#[must_use]
pub fn nested_calls(calls: usize) -> (Vec<u8>, Setup, usize) {
    let passes = (calls / 3).max(1);
    let text = format!(
        "V1=0\nN10 CALL O1\nV1=V1+1\nIF [V1 LT {passes}] N10\nM02\nO1\nCALL O2\nRTS\nO2\nCALL O3\nRTS\nO3\nRTS\n"
    );
    (text.into_bytes(), long_run(), 2 + 11 * passes)
}

/// A set-up for runs of any length.
fn long_run() -> Setup {
    let mut setup = Setup::default();
    setup.limits.steps = u64::MAX;
    setup
}

/// A program of assignments and of words with expressions, of `blocks` blocks (at least 2) with M02.
#[must_use]
pub fn expressions(blocks: usize) -> Vec<u8> {
    let mut numbers = Numbers(3);
    let mut text = String::from("V1=12.5 V2=30 G95 G01 F0.2\n");
    for place in 2..blocks {
        let value = numbers.length(90_000);
        let _ = match place % 6 {
            0 => writeln!(text, "V1=[{value}+V2]/2"),
            1 => writeln!(text, "V2=ABS[{value}]*SIN[30]+MOD[{place},7]"),
            2 => writeln!(text, "X=V1*2+{value} Z=-V2"),
            3 => writeln!(text, "V3=SQRT[V1*V1+V2*V2] V4=ATAN2[V2,V1]"),
            4 => writeln!(text, "X=V3*COS[V4] Z=ROUND[V3]-DFIX[V4]"),
            _ => writeln!(text, "V5=[V1 GT V2]*10+[V3 LE 50] V6=FIX[V3] AND $0F"),
        };
    }
    text.push_str("M02\n");
    text.into_bytes()
}

/// A program of contours in nose radius compensation, of `blocks` blocks (at least 2): start-ups, lines and arcs that
/// meet inside and outside, cancels.
#[must_use]
pub fn compensated(blocks: usize) -> Vec<u8> {
    const GROUP: &[&str] = &[
        "G00 X100 Z10",
        "G42 X20 Z2",
        "G01 Z-",
        "X30 Z-10",
        "Z-20",
        "G03 X40 Z-25 K-5",
        "G01 Z-40",
        "G02 X60 Z-50 I10",
        "G01 X70",
        "X80 Z-55",
        "Z-6",
        "X84 Z-72",
        "Z-80",
        "X90",
        "G40 G00 X110",
    ];
    let mut numbers = Numbers(4);
    let mut text = String::from("G95 G01 F0.2 T010101\n");
    let wanted = blocks.saturating_sub(2);
    for place in 0..wanted {
        let complete = place / GROUP.len() < wanted / GROUP.len();
        let _ = match GROUP.get(place % GROUP.len()) {
            Some(line) if complete && line.ends_with(['-', '6']) => {
                writeln!(text, "{line}{}", numbers.length(9_999))
            }
            Some(line) if complete => writeln!(text, "{line}"),
            _ => writeln!(text, "G00 X{} Z{}", numbers.length(90_000), numbers.length(40_000)),
        };
    }
    text.push_str("M02\n");
    text.into_bytes()
}

/// The set-up of [`compensated`]: nose radius 0.4 mm in entry 1.
#[must_use]
pub fn with_nose() -> Setup {
    let nose = NoseRadius { number: 1, x: Length(400_000), z: Length(400_000) };
    Setup { nose_radius: vec![nose], ..Setup::default() }
}

/// A stream of pseudo-random lengths that never changes (a linear congruence of 64 bits).
struct Numbers(u64);

impl Numbers {
    /// A length in mm with three decimals, below `most` thousandths.
    fn length(&mut self, most: u64) -> String {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let value = (self.0 >> 33) % most;
        format!("{}.{:03}", value / 1_000, value % 1_000)
    }
}

//! Laws that hold whatever the program: spellings that do not matter, shifts that only translate, arcs and
//! corners that touch what they should.

#![allow(clippy::panic)]

mod support;

use proptest::prelude::*;
use support::trace;
use turnspec_oracle::vocabulary::{Action, Event, Length, Motion, Position, Setup};

fn motion(event: &Event) -> Option<Motion> {
    match event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } | Action::Arc { motion, .. } => Some(motion),
        _ => None,
    }
}

fn motions(program: &str, setup: &Setup) -> Vec<Motion> {
    let trace = trace(program, setup);
    let last = trace.last().map(|event| event.action);
    assert!(matches!(last, Some(Action::End { .. })), "{program}\n{last:?}");
    trace.iter().filter_map(motion).collect()
}

/// Micrometres as millimetres.
fn mm(value: i64) -> String {
    Length(value * 1000).to_string()
}

fn points() -> impl Strategy<Value = Vec<(i64, i64)>> {
    prop::collection::vec((0..200_000_i64, -200_000..200_000_i64), 1..12)
}

fn absolute(points: &[(i64, i64)]) -> String {
    points.iter().map(|(x, z)| format!("X{} Z{}\n", mm(*x), mm(*z))).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Travels that add up to the same points give the same path.
    ///
    /// Rules: E100L-ABS-01, E100L-ABS-02
    #[test]
    fn absolute_and_incremental_spellings_agree(points in points()) {
        let mut steps = String::new();
        let mut present = (0, 0);
        for (x, z) in &points {
            steps += &format!("X{} Z{}\n", mm(x - present.0), mm(z - present.1));
            present = (*x, *z);
        }
        let one = motions(&format!("G01 F1\n{}M02\n", absolute(&points)), &Setup::default());
        let other = motions(&format!("G01 F1 G91\n{steps}M02\n"), &Setup::default());
        prop_assert_eq!(one, other);
    }

    /// A shift translates program coordinates and does nothing else.
    ///
    /// Rules: E100L-G50-02
    #[test]
    fn a_zero_shift_only_translates(points in points(), shift in (-9_000..9_000_i64, -9_000..9_000_i64)) {
        let (dx, dz) = shift;
        let moved: Vec<_> = points.iter().map(|(x, z)| (x - dx, z - dz)).collect();
        let one = motions(&format!("G01 F1\n{}M02\n", absolute(&points)), &Setup::default());
        let shifted = format!("G50 X{} Z{}\nG01 F1\n{}M02\n", mm(-dx), mm(-dz), absolute(&moved));
        let other = motions(&shifted, &Setup::default());
        let machine = |motions: &[Motion]| motions.iter().map(|motion| motion.machine).collect::<Vec<Position>>();
        prop_assert_eq!(machine(&one), machine(&other));
    }

    /// Comments, blanks and block numbers do not matter.
    ///
    /// Rules: E100L-CMT-01, E100L-FMT-07, E100L-SEQ-01
    #[test]
    fn comments_blanks_and_block_numbers_do_not_matter(points in points(), marks in any::<u32>()) {
        let plain = absolute(&points);
        let dressed: String = plain.lines().enumerate().map(|(index, line)| match marks >> (index % 16 * 2) & 3 {
            0 => format!("N{index} {line}\r\n"),
            1 => format!("{} (REMARK)\n", line.replace(' ', "  \x7F")),
            2 => format!("\n(REMARK)\n {}\n", line.replacen("X", "X ", 1)),
            _ => format!("{}\n", line.replace(' ', "\n$ ")),
        }).collect();
        let one = motions(&format!("G01 F1\n{plain}M02\n"), &Setup::default());
        let other = motions(&format!("G01 F1\n{dressed}M02\n"), &Setup::default());
        prop_assert_eq!(one, other);
    }

    /// One path in the 1 mm, 10 µm and 1 µm systems.
    ///
    /// Rules: E100L-DEC-01
    #[test]
    fn unit_systems_agree(points in points()) {
        let one = motions(&format!("G00\n{}M02\n", absolute(&points)), &Setup::default());
        for (name, unit) in [("1um", 1), ("10um", 10)] {
            let setup = Setup::from_toml(&format!("unit_system = '{name}'")).unwrap_or_default();
            let scaled = |value: i64| Length(value * 1_000_000 / unit).to_string();
            let blocks: String = points.iter().map(|(x, z)| format!("X{} Z{}\n", scaled(*x), scaled(*z))).collect();
            prop_assert_eq!(&one, &motions(&format!("G00\n{blocks}M02\n"), &setup));
        }
    }

    /// The centre of an arc by radius is at the radius from both ends, and on the side that makes the arc
    /// the smaller or the larger one.
    ///
    /// Rules: E100L-CIRC-17, E100L-CIRC-18
    #[test]
    fn an_arc_by_radius_has_its_centre_at_the_radius(
        end in (-50_000..50_000_i64, -50_000..50_000_i64),
        excess in 0..40_000_i64,
        counter_clockwise in any::<bool>(),
        major in any::<bool>(),
    ) {
        prop_assume!(end != (0, 0));
        let (x, z) = (end.0 as f64 / 2.0, end.1 as f64);
        let radius = (x.hypot(z) / 2.0).ceil() as i64 + 1 + excess;
        let code = if counter_clockwise { "G03" } else { "G02" };
        let word = if major { "CALRG " } else { "" };
        let program = format!("{code} {word}X{} Z{} L{} F1\nM02\n", mm(end.0), mm(end.1), mm(radius));
        let trace = trace(&program, &Setup::default());
        let arc = trace.iter().find_map(|event| match event.action {
            Action::Arc { centre_x, centre_z, .. } => Some((centre_x.0 as f64 / 2e3, centre_z.0 as f64 / 1e3)),
            _ => None,
        });
        let Some((centre_x, centre_z)) = arc else { panic!("no arc: {program}") };
        prop_assert!((centre_x.hypot(centre_z) - radius as f64).abs() < 0.002);
        prop_assert!(((centre_x - x).hypot(centre_z - z) - radius as f64).abs() < 0.002);
        // The centre is left of the chord for a counter-clockwise minor arc.
        let left = z * centre_x - x * centre_z;
        let expected = if counter_clockwise != major { 1.0 } else { -1.0 };
        prop_assert!(left * expected > -100.0, "{left}");
    }

    /// A rounding touches both lines: its centre is at the radius from either.
    ///
    /// Rules: E100L-ANG-04
    #[test]
    fn a_rounding_touches_both_lines(
        corner in (20_000..60_000_i64, 20_000..60_000_i64),
        end in (20_000..60_000_i64, -60_000..-20_000_i64),
        radius in 1..4_000_i64,
    ) {
        let program = format!(
            "G01 F1 G76 X{} Z{} L{}\nX{} Z{}\nM02\n",
            mm(corner.0), mm(corner.1), mm(radius), mm(end.0), mm(end.1)
        );
        let trace = trace(&program, &Setup::default());
        let arc = trace.iter().find_map(|event| match event.action {
            Action::Arc { motion, centre_x, centre_z, .. } => Some((motion.program, centre_x, centre_z)),
            _ => None,
        });
        let Some((to, centre_x, centre_z)) = arc else { panic!("no arc: {program}") };
        let plane = |x: Length, z: Length| (z.0 as f64, x.0 as f64 / 2.0);
        let centre = plane(centre_x, centre_z);
        let corner = (corner.1 as f64 * 1e3, corner.0 as f64 * 5e2);
        let end = (end.1 as f64 * 1e3, end.0 as f64 * 5e2);
        let distance = |from: (f64, f64), to: (f64, f64)| {
            let (dz, dx) = (to.0 - from.0, to.1 - from.1);
            ((centre.0 - from.0) * dx - (centre.1 - from.1) * dz).abs() / dz.hypot(dx)
        };
        let radius = radius as f64 * 1e3;
        prop_assert!((distance((0.0, 0.0), corner) - radius).abs() < 2.0);
        prop_assert!((distance(corner, end) - radius).abs() < 2.0);
        let touch = plane(to.x, to.z);
        prop_assert!(((touch.0 - centre.0).hypot(touch.1 - centre.1) - radius).abs() < 2.0);
    }

    /// A coordinate that changes by one increment moves a chamfered corner by a bounded amount and changes the
    /// shape of the trace not at all.
    ///
    /// Rules: E100L-ANG-03
    #[test]
    fn a_small_change_moves_the_path_a_little(x in 20_000..60_000_i64, z in 20_000..60_000_i64, size in 1..8_000_i64) {
        let of = |x: i64| motions(&format!("G01 F1 G75 X{} Z{} L{}\nX70 Z-20\nM02\n", mm(x), mm(z), mm(size)), &Setup::default());
        let (one, other) = (of(x), of(x + 1));
        prop_assert_eq!(one.len(), other.len());
        for (a, b) in one.iter().zip(&other) {
            prop_assert!((a.program.x.0 - b.program.x.0).abs() < 4_000 && (a.program.z.0 - b.program.z.0).abs() < 4_000);
        }
    }
}

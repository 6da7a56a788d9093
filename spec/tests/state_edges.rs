//! What each of two saddles has for itself: torque stops (E100L-AX4-11).

mod support;

use support::{kind, texts, value};
use turnspec_oracle::vocabulary::{Length, MachineType, Setup};

/// TRQ-04: from Z100 to Z50 with D5 and L10 the axis feeds to 55 and on to its stop: 49.5 is that of B, 48 that of A. Each
/// block takes the next stop of its own side.
#[test]
fn each_saddle_has_its_own_torque_stops() {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoSaddles;
    (setup.start.z, setup.turret_b.start.z) = (Length(100_000_000), Length(100_000_000));
    setup.inputs.torque_stops = vec![Length(48_000_000), Length(47_000_000)];
    setup.turret_b.torque_stops = vec![Length(49_500_000), Length(46_000_000)];
    let skip = "G94 G22 Z50 D5 L10 F1000 PZ=25\nG00 Z100\nG22 Z50 D5 L10 PZ=25\n";
    let ends = |program: &str| -> Vec<String> {
        let events = texts(program, &setup);
        let lines = events.iter().filter(|event| kind(event) == "linear");
        lines.map(|event| format!("{} {}", value(event, "saddle"), value(event, "z"))).collect()
    };
    assert_eq!(ends(&format!("G13\n{skip}M02\n")), ["A 55", "A 48", "A 55", "A 47"]);
    assert_eq!(ends(&format!("G14\n{skip}M02\n")), ["B 55", "B 49.5", "B 55", "B 46"]);
}

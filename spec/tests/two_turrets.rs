//! Two turrets on one saddle: what the examples of the rules do not show.

mod support;

use turnspec_oracle::check;
use turnspec_oracle::vocabulary::{Length, MachineType, NoseRadius, ProgramText, Setup};

use support::{kind, texts, value};

fn setup() -> Setup {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoTurrets;
    let nose = NoseRadius { number: 1, x: Length(800_000), z: Length(800_000) };
    setup.turret_b.nose_radius = vec![nose];
    setup
}

/// E100L-MIRR-04: what M02 releases belongs to the turret that has moved, whatever the reset selects then.
#[test]
fn a_released_motion_keeps_its_turret() {
    let events = texts("G14\nG42 G00 X100 Z80 T010101\nG01 Z50 F0.2\nM02\n", &setup());
    let found: Vec<_> = events.iter().map(|event| (kind(event), value(event, "turret"))).collect();
    let expected = [
        ("mode", "B"),
        ("mode", "B"),
        ("tool", "B"),
        ("rapid", "B"),
        ("mode", "B"),
        ("linear", "B"),
        ("mode", "B"),
        ("mode", "B"),
        ("mode", "A"),
        ("end", "A"),
    ];
    assert_eq!(found, expected);
}

/// E100L-MIRR-05, E100L-NRC-46: a repetition stays at the mirrored place, the nose centre beside the end of the line.
#[test]
fn a_repetition_stays_at_the_mirrored_place() {
    let events = texts("G14\nG42 G00 X100 Z80 T010101\nG01 Z50 F0.2\nZ50\nM02\n", &setup());
    let motions: Vec<_> = events.iter().filter(|event| kind(event) == "linear").collect();
    assert_eq!(motions.len(), 2);
    for event in motions {
        let place = ["mx", "tx", "nx", "nz"].map(|key| value(event, key));
        assert_eq!(place, ["-100", "100", "101.6", "50"], "{event}");
    }
}

/// E100L-MIRR-05: a motion of W alone tells the tip in the sense of the turret. The corner of Z50 and X120 leaves the tip
/// at the programmed point.
#[test]
fn a_motion_without_x_and_z_tells_the_mirrored_tip() {
    let mut setup = setup();
    setup.options.w_axis = true;
    let program = "G14\nG42 G00 X100 Z80 T010101\nG01 Z50 F0.2\nW10\nX120\nG40 G00 X150\nM02\n";
    let events = texts(program, &setup);
    let motion = events.iter().find(|event| value(event, "line") == "4").map(String::as_str);
    let place = ["mx", "tx", "nx", "tz", "nz"].map(|key| value(motion.unwrap_or_default(), key));
    assert_eq!(place, ["-100", "100", "101.6", "50", "50.8"]);
}

/// E100L-SDF-14: the program that a schedule selects ends without a reset, so that its turret stays.
#[test]
fn a_selected_program_leaves_its_turret() {
    let library = [("A.MIN".to_owned(), ProgramText(b"G14\nM02\n".to_vec()))];
    let setup = Setup { library: library.into(), schedule: true, ..setup() };
    let events = texts("PSELECT A.MIN\nPSELECT A.MIN\nEND\n", &setup);
    let found: Vec<_> = events.iter().map(|event| (kind(event), value(event, "turret"))).collect();
    assert_eq!(
        found,
        [("select", "A"), ("mode", "B"), ("end", "B"), ("select", "B"), ("end", "B"), ("end", "B")]
    );
}

/// E100L-MIRR-03: M02 beside a turret code ends nothing, so that faults behind it are faults of the program.
#[test]
fn what_is_ignored_does_not_end_the_program() {
    let program = b"G14 M02\nG00 X123456789\nM02\nG00 X987654321\n";
    let lines = |setup| check(program, setup).iter().map(|fault| fault.block.line).collect::<Vec<_>>();
    assert_eq!(lines(&setup()), [2]);
}

/// E100L-MIRR-01: a machine with one turret tells none.
#[test]
fn one_turret_has_no_name() {
    for event in texts("G13\nG00 X1\nG14\n", &Setup::default()) {
        assert_eq!((value(&event, "turret"), value(&event, "saddle")), ("-", "-"));
    }
}

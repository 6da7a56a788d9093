//! Every fault of a program at once, on a machine with two turrets.

use turnspec_oracle::check;
use turnspec_oracle::vocabulary::{AlarmName, MachineType, Setup};

fn faults(program: &str, machine: MachineType) -> Vec<(u32, AlarmName)> {
    let mut setup = Setup::default();
    setup.machine.r#type = machine;
    let found = check(program.as_bytes(), &setup);
    found.iter().map(|fault| (fault.block.line, fault.alarm.name)).collect()
}

/// MCODE-04: M02 alone ends the program, and what stands behind it is none of it, with two turrets too.
#[test]
fn the_end_of_the_program_ends_it_with_two_turrets() {
    let program = "G01 X1\nM02\nG00 X123456789\n";
    assert_eq!(faults(program, MachineType::TwoTurrets), [(1, AlarmName::NoFeed)]);
    assert_eq!(faults(program, MachineType::OneTurret), [(1, AlarmName::NoFeed)]);
}

/// MIRR-03: commands in the block of a turret code are ignored, M02 too; the program goes on behind it.
#[test]
fn an_end_beside_a_turret_code_is_ignored() {
    let program = "G14 M02\nG00 X123456789\nG01 X1\nM02\nG00 Z123456789\n";
    assert_eq!(faults(program, MachineType::TwoTurrets), [(2, AlarmName::TooManyDigits)]);
    let program = "G01 X1\nG14 M02\nG00 X123456789\nM02\nG00 Z123456789\n";
    let expected = [(3, AlarmName::TooManyDigits), (1, AlarmName::NoFeed)];
    assert_eq!(faults(program, MachineType::TwoTurrets), expected);
}

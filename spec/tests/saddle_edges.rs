//! Two saddles at their edges: a text without selection, a program without end, and the spindle as the other side has left
//! it. All values follow by hand from two-saddles.md.

mod support;

use turnspec_oracle::Run;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Ending, Event, MachineType, Setup};

fn setup() -> Setup {
    let mut setup = Setup::default();
    setup.machine.r#type = MachineType::TwoSaddles;
    setup
}

fn trace(program: &str) -> Vec<Event> {
    support::trace(program, &setup())
}

fn holds(program: &str, expected: &str) {
    support::holds(program, expected, &setup());
}

/// E100L-PROG-02, E100L-AX4-02: without a selection there are no sides, and behind the last block there is nothing to be
/// carried out: each block is a step, and the next step is the alarm.
#[test]
fn a_text_without_selection_ends_behind_its_last_block() {
    for (program, blocks) in [("", 0), ("O1\n", 1), ("O1\n(NOTHING)\nN1\n", 3)] {
        let setup = setup();
        let mut run = Run::new(program.as_bytes(), &setup);
        let mut alarm = String::new();
        for _ in 0..blocks {
            assert_eq!(run.step(&mut |event: &Event| alarm = render(event)), None, "{program}");
        }
        assert_eq!(run.step(&mut |event: &Event| alarm = render(event)), Some(Ending::Alarm), "{program}");
        assert!(alarm.starts_with("alarm name=no_program_end "), "{alarm}");
    }
}

/// E100L-AX4-03, E100L-AX4-05: both sides belong to the program whose name stands in front of them, and so does the alarm
/// of its missing end.
#[test]
fn a_missing_end_is_one_of_the_program() {
    let events = trace("O1\nG13\nG00 X1\nG14\nG00 X2\n");
    assert_eq!(events.len(), 5);
    assert!(events.iter().all(|event| event.block.program.as_str() == "O1"), "{events:?}");
}

/// E100L-AX4-11: state, direction and S of the spindle are those that the block of side A has commanded for both
/// (E100L-AX4-06). Side A has ended, so that side B needs no fellow (E100L-AX4-07).
#[test]
fn side_b_goes_on_with_the_spindle_of_side_a() {
    let with = |commands: &str| format!("G13\nS1000 M03 P10\nG14\nS1000 M03 P10\n{commands}\nM02\n");
    for (commands, expected) in [
        ("S500 P20", "spindle state=cw speed=500 saddle=B"),
        ("M05 P20\nM03", "spindle state=stop speed=0 saddle=B\nspindle state=cw speed=1000 saddle=B"),
        // The spindle is reversed where it is commanded as ever.
        ("M04 P20", "spindle state=ccw speed=1000 saddle=B"),
    ] {
        let expected = format!(
            "...\nrelease p=20 cause=other_ended saddle=B\n{expected}\nside_end saddle=B\nend code=M02"
        );
        holds(&with(commands), &expected);
    }
}

/// E100L-AX4-08, E100L-CSS-01: with G110 the X of turret A counts, wherever turret B stands: 1000·100/(π·100) = 318.310.
#[test]
fn the_reference_turret_takes_its_own_x() {
    let side = |code: &str, x: u32| format!("{code}\nG00 X{x}\nG96 S100 M03 P10\n");
    holds(
        &format!("{}{}M02\n", side("G13", 100), side("G14", 50)),
        "...\nspindle state=stop speed=0 surface=100 saddle=A\nspindle state=cw speed=318.31 surface=100 saddle=A\n...\nend code=M02",
    );
}

/// E100L-AX4-12: variables, the detail the name; any name of the table of system variables, also one that is not modelled
/// (SVTAB-01), the unit system (SVTAB-05) and the comment (VUACM-01). What the table does not have is no variable (SVAR-01).
#[test]
fn no_variable_of_the_table_is_described() {
    for name in ["VETLN", "VAPPX", "VUNIT", "VUACM"] {
        holds(
            &format!("G13\nG00 X={name}\nM02\n"),
            &format!("...\nalarm name=unspecified detail={name} line=2 rules=E100L-AX4-12"),
        );
    }
    holds("G13\nG00 X=VNONE\nM02\n", "...\nalarm name=system_variable_unknown line=2 rules=E100L-SVAR-01");
}

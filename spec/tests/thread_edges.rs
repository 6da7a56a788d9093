//! Threads at their edges: chamfers inside and on a taper, angles, what is refused beside compensation, what the events of
//! a thread with one start cite. All values follow by hand from the texts of the threads.

mod support;

use support::{holds, trace};
use turnspec_oracle::vocabulary::{Chamfering, Event, Length, NoseRadius, Setup};

/// E100L-TCHM-03, E100L-TCHM-04: inside, away from the work is toward X20. 3000·1.5/(1000·1.5) = 3 of radius from Ø29 to
/// Ø23; at 500 rpm 6, of which 4.5 are left to Ø20, which it has at 4.5/6 of the length: Z51.5 − 1.125.
#[test]
fn a_chamfer_of_an_inside_thread_goes_toward_the_centre() {
    let program = |speed: u32| format!("G00 X20 Z80 S{speed} M03 M23\nG33 X29 Z50 F1.5\nM02\n");
    holds(
        &program(1000),
        "...
rapid x=29 z=80 pass=1 part=approach
thread x=29 z=51.5 part=cut
thread x=23 z=50 part=exit rules=E100L-TCHM-04
linear x=20 z=50 path=1.5 part=retract
rapid x=20 z=80 part=return
...
end code=M02",
        &Setup::default(),
    );
    holds(
        &program(500),
        "...
thread x=29 z=51.5 part=cut
thread x=20 z=50.375 part=exit rules=E100L-TCHM-04
thread x=20 z=50 part=exit
rapid x=20 z=80 part=return
...
end code=M02",
        &Setup::default(),
    );
}

/// E100L-TCHM-04: from Ø29 the chamfer rises by 3 of radius to Ø35, the level of the cycle start, just at the end of the
/// thread: not before it, so that it is one motion; nothing is left to withdraw.
#[test]
fn a_chamfer_may_reach_the_cycle_start_at_the_end() {
    holds(
        "G00 X35 Z80 S1000 M03 M23\nG33 X29 Z50 F1.5\nM02\n",
        "...
thread x=29 z=51.5 part=cut
thread x=35 z=50 part=exit rules=E100L-TCHM-04
rapid x=35 z=80 part=return
...
end code=M02",
        &Setup::default(),
    );
}

/// E100L-TCHM-04 with the taper of its example, which rises by 0.75 on the last 1.5: at 4000 rpm the chamfer makes just that
/// of it, so that the tool is not deeper at the end than without it: Ø45.5 to Ø47.
#[test]
fn a_chamfer_may_open_as_fast_as_the_taper() {
    let program = "G00 X60 Z80 S4000 M03 M23\nG33 X17 Z50 I15 F1.5\nM02\n";
    let expected = "...\nthread x=45.5 z=51.5 part=cut\nthread x=47 z=50 part=exit\n...\nend code=M02";
    holds(program, expected, &Setup::default());
    let faster = program.replace("S4000", "S4001");
    let expected = "...\nalarm name=unspecified detail=taper rules=E100L-TCHM-04";
    holds(&faster, expected, &Setup::default());
}

/// E100L-G34-01: A with one of X and Z gives the other, however chamfering is set: 10 under 135 degrees. Alone it needs the
/// any-angle form.
#[test]
fn an_angle_of_a_leg_needs_one_coordinate() {
    for chamfering in [Chamfering::Off, Chamfering::Basic, Chamfering::AnyAngle] {
        let mut setup = Setup::default();
        setup.parameters.chamfering = chamfering;
        for word in ["Z70", "X49"] {
            let program = format!("G00 X29 Z80\nG34 {word} A135 F1.5\nM02\n");
            holds(
                &program,
                "...\nthread x=49 z=70 rules=E100L-G34-01+E100L-DTAP-03\n...\nend code=M02",
                &setup,
            );
        }
    }
}

/// E100L-THRD-10, E100L-NRC-81: G34 and G35 in compensation, in the block that begins it, in the one that ends it, and as
/// long as a displacement is left over.
#[test]
fn a_leg_does_not_go_with_compensation() {
    let nose_radius = vec![NoseRadius { number: 1, x: Length(800_000), z: Length(800_000) }];
    let setup = Setup { nose_radius, ..Setup::default() };
    for (blocks, line) in [
        ("G41 CODE Z60", 2),
        ("G42 G01 Z90\nCODE Z60", 3),
        ("G42 G01 Z90\nZ80\nG40 CODE Z60", 4),
        ("G42 G01 Z90\nZ80\nG40\nCODE Z60", 5),
    ] {
        for code in ["G34", "G35"] {
            let program = format!("G00 X100 Z100 F0.2 T010101\n{blocks}\nM02\n").replace("CODE", code);
            let expected =
                format!("...\nalarm name=unspecified detail={code} line={line} rules=E100L-NRC-81");
            holds(&program, &expected, &setup);
        }
    }
}

/// E100L-TMUL-02 is about several starts.
#[test]
fn a_thread_of_one_start_is_none_of_several() {
    for (starts, cited) in [("", false), ("Q1", false), ("Q2", true)] {
        let program = format!("G00 X30 Z40\nG71 X20 Z10 D1 H2 F3 {starts} M74\nM02\n");
        let events = trace(&program, &Setup::default());
        assert!(events.len() > 8, "{program}");
        let cites =
            |event: &Event| event.rules.as_slice().iter().any(|rule| rule.as_str() == "E100L-TMUL-02");
        assert_eq!(events.iter().any(cites), cited, "{starts}");
    }
}

//! The user task at its edges: the rules that an assignment cites, and what system variables read as. All values follow by
//! hand from local-variables.md and expressions.md.

mod support;

use support::trace;
use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Angle, Setup, UnitSystem};

fn in_system(unit_system: UnitSystem) -> Setup {
    Setup { unit_system, ..Setup::default() }
}

/// E100L-LVAR-10 and E100L-LVAR-11 are about subprograms: the main program cites neither, when it registers and when it
/// changes an entry.
#[test]
fn a_local_variable_of_the_main_program_is_none_of_a_subprogram() {
    let events = trace("EF=1\nEF=2\nM02\n", &Setup::default());
    let cites = |index: usize, rule: &str| events.get(index).is_some_and(|event| support::cites(event, rule));
    assert!(cites(0, "E100L-LVAR-04") && cites(1, "E100L-LVAR-06"), "{events:?}");
    for index in 0..2 {
        assert!(!cites(index, "E100L-LVAR-10") && !cites(index, "E100L-LVAR-11"), "{events:?}");
    }
}

/// E100L-TYPE-13: C in thousandths of a degree is an integer, whose sum with the greatest one overflows (E100L-TYPE-08);
/// in degrees, and in hundredths, it is a real.
#[test]
fn thousandths_of_a_degree_are_integers() {
    for (unit_system, overflows) in [
        (UnitSystem::Micrometre, true),
        (UnitSystem::TenThousandthInch, true),
        (UnitSystem::TenMicrometre, false),
        (UnitSystem::Millimetre, false),
        (UnitSystem::Inch, false),
    ] {
        let mut setup = in_system(unit_system);
        setup.zero_offset.c = Angle(30_000_000);
        let events = trace("V1=$7FFFFFFF+VZOFC\nM02\n", &setup);
        let first = events.first().map(render).unwrap_or_default();
        assert_eq!(first.starts_with("alarm name=integer_overflow"), overflows, "{unit_system:?}: {first}");
    }
}

/// E100L-SVAR-10: corrections of X and of Z are 0 to ±0.999. E100L-SVAR-14: the cutting edge angle of a tool and of a group is
/// ±360. A step beyond either end is `variable_range`.
#[test]
fn a_range_on_both_sides_of_zero_holds_for_each_variable() {
    let ranges = [("VPFVX[1]", "0.999", "1"), ("VPFVZ[1]", "0.999", "1")];
    let angles = [("VTLA2[1]", "360", "360.001"), ("VGRA2[1]", "360", "360.001")];
    for (name, last, beyond) in ranges.into_iter().chain(angles) {
        for sign in ["", "-"] {
            let end = |value: &str| {
                let events = trace(&format!("{name}={sign}{value}\nM02\n"), &Setup::default());
                events.last().map(render).unwrap_or_default()
            };
            assert!(end(last).starts_with("end code=M02"), "{name}={sign}{last}: {}", end(last));
            assert!(
                end(beyond).starts_with("alarm name=variable_range"),
                "{name}={sign}{beyond}: {}",
                end(beyond)
            );
        }
    }
}

//! Mode IV, cuts through stock and air (E100L-AP4-05; execution-lap.md, section 11). Values follow by hand.

#![allow(clippy::panic)]

mod support;

use turnspec_oracle::vocabulary::notation::{Expectation, render};
use turnspec_oracle::vocabulary::{Event, Setup};

fn trace(program: &str) -> Vec<Event> {
    support::trace(program, &Setup::default())
}

/// W20 brings the start of the rough contour, and the wall there, to Z20, before S at Z0. At Ø26 the line from S (40, 0)
/// to A' (20, 20) is at Z14, behind the wall, so that the cut runs back to it, over no stock: that begins at Z0. Of its 6 mm
/// the first and the last 2 are cut.
#[test]
fn a_cut_that_runs_back_to_the_contour_is_parted_too() {
    let program = "NA G83\nG01 X30 Z0\nZ-30\nG81\nG00 X20 Z0\nG01 X30\nZ-30\nG80\nG00 X40 Z0\n\
                   G85 NA D4 F0.3 W20\nM02\n";
    let expected = "rapid x=40 z=0
rapid x=26 z=14 pass=1 part=infeed rules=E100L-AP4-03
linear x=26 z=16 pass=1 part=cut rules=E100L-AP4-05
rapid x=26 z=18 pass=1 part=air rules=E100L-AP4-05
linear x=26 z=20 pass=1 part=cut rules=E100L-AP4-05
linear x=30 z=20 pass=1 part=contour
linear x=30 z=-10 pass=1 part=contour
...";
    let trace = trace(program);
    if let Err(divergence) = Expectation::parse(expected).matches(&trace) {
        let found: Vec<String> = trace.iter().map(render).collect();
        panic!("{divergence}\n{program}\n{}", found.join("\n"));
    }
}

/// Section 14: a `cut` cites E100L-AP4-05 with more than one stretch. With a groove of the blank Ø24 is cut in two, without
/// it in one.
#[test]
fn a_cut_of_one_stretch_does_not_cite_the_air() {
    let program = |groove: &str| {
        format!(
            "NA G83\nG01 X16 Z50\nX32\n{groove}Z10\nG81\nG00 X16 Z50\nG01 Z10\nX32\nG80\nG00 X40 Z60\n\
             G85 NA D8 F0.3\nM02\n"
        )
    };
    for (groove, cuts, parted) in [("", 1, false), ("Z44\nX24\nZ24\nX32\n", 2, true)] {
        let trace = trace(&program(groove));
        let is_cut = |event: &&Event| render(event).contains(" part=cut");
        let found: Vec<&Event> = trace.iter().filter(is_cut).collect();
        assert_eq!(found.len(), cuts, "{groove}");
        for event in found {
            let cites = event.rules.as_slice().iter().any(|rule| rule.as_str() == "E100L-AP4-05");
            assert_eq!(cites, parted, "{}", render(event));
        }
    }
}

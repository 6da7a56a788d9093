//! Threads at the ends of what they may be: the last lead, the last depth, limits, areas and the range of coordinates. All
//! values follow by hand from the texts of the threads.

mod support;

use turnspec_oracle::vocabulary::Event;
use turnspec_oracle::vocabulary::notation::render;

fn trace(program: &str, setup: &str) -> Vec<Event> {
    support::trace(program, &support::set_up(setup))
}

fn holds(program: &str, setup: &str, expected: &str) {
    support::holds(program, expected, &support::set_up(setup));
}

/// E100L-G33-09, E100L-G34-02: at the distance d the lead is √(F² ± 2·E·d), and both ends of the range are leads. 600² +
/// 2·100·3200 = 1000²; 0.005² − 2·0.001·0.012 = 0.001².
#[test]
fn a_changing_lead_may_end_at_the_end_of_its_range() {
    let grows = |end: &str| format!("G00 X30 Z3200\nG34 Z{end} F600 E100\nM02\n");
    holds(&grows("0"), "", "...\nthread z=0 lead=600 change=100\n...\nend code=M02");
    for beyond in ["-0.001", "-100"] {
        holds(&grows(beyond), "", "...\nalarm name=thread_lead_range line=2 rules=E100L-G33-09");
    }
    let shrinks = |start: &str| format!("G00 X30 Z{start}\nG35 Z0 F0.005 E0.001\nM02\n");
    holds(&shrinks("0.012"), "", "...\nthread z=0 lead=0.005 change=-0.001\n...\nend code=M02");
    holds(&shrinks("0.013"), "", "...\nalarm name=thread_lead_range line=2 rules=E100L-G33-09");
}

/// E100L-TINF-04: √n·D as long as it is less than T, then T. D1, T2: 1, √2, √3, then 2, which √4·D is not less than; H2.1.
/// X is 20 + 2.1 less the depth.
#[test]
fn an_area_that_ends_at_the_last_depth_gives_no_pass_of_its_own() {
    holds(
        "G00 X30 Z40\nG71 X20 Z10 D1 U0.1 H2.1 F1.5 M75\nM02\n",
        "",
        "...
thread x=21.1 z=10 pass=1 part=cut
...
thread x=20.685786 z=10 pass=2 part=cut
...
thread x=20.367949 z=10 pass=3 part=cut
...
thread x=20.1 z=10 pass=4 part=cut
...
thread x=20 z=10 pass=5 part=cut
...
end code=M02",
    );
}

/// E100L-LIM-01: a length of thread obeys the limits of the axes that it moves, each alone.
#[test]
fn a_length_of_thread_obeys_the_limit_of_its_axis() {
    let program = "G00 X30 Z80\nG34 Z5 F1\nM02\n";
    holds(program, "[limits.z]\nnegative = 5\n", "...\nthread z=5\n...\nend code=M02");
    let trace = trace(program, "[limits.z]\nnegative = 10\n");
    let last = trace.last().map(render).unwrap_or_default();
    assert!(last.starts_with("alarm name=") && last.contains("line=2"), "{last}");
}

/// E100L-BARR-08: the reading of positionings is about `rapid` alone; the path of a thread is tested whole. The line of the
/// rule's example, from (Z−20, X150) to (Z−60, X60) in the bore, leads through the gripping part.
#[test]
fn the_path_of_a_thread_is_tested_whole() {
    let setup = "[barriers]
jaw_length = 60
jaw_height = 50
grip_length = 20
grip_height = 15
chuck_x = 80
chuck_z = -30
[readings]
barrier_path = \"ends\"
";
    let to = |motion: &str| format!("G00 X150 Z-20\nM25\n{motion} X60 Z-60 F1\nM02\n");
    holds(&to("G00"), setup, "...\nrapid x=60 z=-60\n...\nend code=M02");
    holds(&to("G34"), setup, "...\nalarm name=barrier detail=chuck line=3 rules=E100L-BARR-01");
}

/// E100L-ADDR-01: a target computed from a travel has the range of X: Z-99999 less 10 is beyond it.
#[test]
fn a_length_of_thread_ends_in_the_range_of_coordinates() {
    let program = |way: &str| format!("G00 X30 Z-99999\nG91 G34 Z{way} F1\nM02\n");
    holds(&program("-0.999"), "", "...\nthread z=-99999.999\n...\nend code=M02");
    holds(&program("-10"), "", "...\nalarm name=coordinate_range line=2 rules=E100L-ADDR-01");
}

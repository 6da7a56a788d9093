//! The end of nose radius compensation at its edges: barriers and limits of the motion of the G40 block.

mod support;

/// The chuck of the chapter on barriers: Z −90 to −30 with X 80 to 110, Z −90 to −50 with X 80 to 180.
const CHUCK: &str = "
[[nose_radius]]
number = 1
x = 0.8
z = 0.8
[barriers]
jaw_length = 60
jaw_height = 50
grip_length = 20
grip_height = 15
chuck_x = 80
chuck_z = -30
";

fn holds(program: &str, expected: &str, setup: &str) {
    support::holds(program, expected, &support::set_up(&format!("{setup}{CHUCK}")));
}

/// BARR-01: every element is tested by itself, and the earlier ones of its block have been shown. CHAM-03: from (X200, Z−20)
/// to the corner X100 with L−15: B = X130 Z−20 in front of the chuck, D = X100 Z−35 in its gripping part. With L15 D is
/// Z−5, and nothing is refused.
#[test]
fn the_chamfer_of_the_block_that_ends_compensation_is_tested_too() {
    let program = |size| format!("M25\nG42 G01 X200 Z50 F0.2 T010101\nZ-20\nG40 G75 X100 L{size}\nM02\n");
    let setup = "parameters.chamfering = \"basic\"";
    holds(
        &program("-15"),
        "...\nlinear x=200 z=-20\nmode code=G40\nlinear x=130 z=-20\nalarm name=barrier detail=chuck line=4 rules=E100L-BARR-01",
        setup,
    );
    holds(
        &program("15"),
        "...\nlinear x=200 z=-20\nmode code=G40\nlinear x=130 z=-20\nlinear x=100 z=-5\n...\nend code=M02",
        setup,
    );
}

/// Execution, "Barriers": in a block that ends compensation E is cut back by the positive limits of X and Z. From (X70, Z0)
/// to X200 Z−60 the way would lead into the jaw; to X75 Z−60, where X may go, it stays within the gripping diameter 80.
#[test]
fn the_way_that_a_limit_of_x_cuts_back_ends_compensation_beside_the_chuck() {
    let program = "M25\nG42 G01 X70 Z50 F0.2 T010101\nZ0\nG40 X200 Z-60\nM02\n";
    holds(
        program,
        "...\nlinear x=70 z=0\nmode code=G40\nlinear x=75 z=-60 mx=75 rules=E100L-LIM-01+E100L-BARR-01\n...\nend code=M02",
        "limits.x.positive = 75",
    );
    holds(program, "...\nalarm name=barrier detail=chuck line=4 rules=E100L-BARR-01", "");
}

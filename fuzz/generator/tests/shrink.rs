//! Shrinking keeps what makes a case fail, the programs that it calls included.

use turnspec_generator::{Case, shrink};
use turnspec_oracle::vocabulary::{Action, Event, ProgramText, Setup};

#[test]
fn programs_of_the_library_come_into_the_text() {
    let program = b"M08\nCALL O1 AB=1\nM02\n".to_vec();
    let mut setup = Setup::default();
    setup.limits.steps = 50;
    setup.library.insert("B.SUB".to_owned(), ProgramText(b"$B.SUB%\nO2\nRTS".to_vec()));
    setup.library.insert("A.SUB".to_owned(), ProgramText(b"O1\nM65\nX5\nRTS".to_vec()));
    let fails = |case: &Case| {
        let mut calls = 0;
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            calls += usize::from(matches!(event.action, Action::Call { .. }));
        });
        calls > 0
    };
    let small = shrink(Case { setup, program }, fails);
    assert_eq!(String::from_utf8_lossy(&small.program), "CALL O1\nO1");
    assert_eq!((small.setup.library.len(), small.setup.limits.steps), (0, 50));
}

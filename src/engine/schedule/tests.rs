//! What schedule and selected programs leave to each other.

use turnspec_oracle::vocabulary::notation::{Expectation, render};
use turnspec_oracle::vocabulary::{Event, ProgramText, Setup};

use crate::engine::{count_blocks, run};

fn expect(schedule: &str, files: &[(&str, &str)], expected: &str) {
    let mut setup = Setup { schedule: true, ..Setup::default() };
    for (name, text) in files {
        setup.library.insert((*name).to_owned(), ProgramText(text.as_bytes().to_vec()));
    }
    let mut events = Vec::new();
    run(schedule.as_bytes(), &setup, &mut |event: &Event| events.push(*event));
    if let Err(reason) = Expectation::parse(expected).matches(&events) {
        let text: Vec<String> = events.iter().map(render).collect();
        panic!("{schedule}\n{reason}\n{}", text.join("\n"));
    }
}

#[test]
fn local_variables_outlive_the_subprogram_that_ended_the_program() {
    let main = "CALL O1 ABC=1\nM02\nO1\nM02\nRTS\n";
    let next = "CALL O2\nV1=ABC\nM02\nO2\nRTS\n";
    expect(
        "PSELECT A\nPSELECT B\nEND\n",
        &[("A.MIN", main), ("B.MIN", next)],
        "select\nvariable name=ABC\ncall name=O1\nend code=M02\n\
         select\ncall\nreturn\nvariable name=V1 value=1\nend\nend code=END",
    );
}

#[test]
fn repetitions_begin_anew() {
    let main = "O1\nN1 V1=V1+1\nIF [V1 LT 2] N1\nM02\nN9 V2=1\n";
    expect(
        "PSELECT A,O1,,Q3\nEND\n",
        &[("A.MIN", main)],
        "select repetition=1\nvariable value=1 block=N1 program=O1\nvariable value=2\nend line=4\n\
         select repetition=2 line=1\nvariable value=3 block=N1 program=O1 line=2\nend line=4\n\
         select repetition=3 line=1\nvariable value=4\nend line=4\nend code=END line=2",
    );
}

#[test]
fn what_was_looked_at_beyond_the_end_does_not_come() {
    let main = "G01 G75 X20 L2 F0.2 M02\nZ-10\n";
    expect(
        "PSELECT\nVSET V1=1\nEND\n",
        &[("A.MIN", main)],
        "select\nmode\nlinear x=16\nlinear x=20 z=-2\nend code=M02\nvariable name=V1\nend code=END",
    );
}

#[test]
fn a_selected_program_ends_before_the_next_name() {
    expect(
        "PSELECT\nEND\n",
        &[("A.MIN", "GOTO N1\nM02\nN1 G00 X1\nO1\nM02\n")],
        "select\nrapid x=1\nalarm name=no_program_end line=4 rules=E100L-PROG-02",
    );
}

#[test]
fn compensation_that_is_left_over_stays() {
    let main = "G42 G01 X50 Z100 F0.2 T010101\nZ80\nG40 M02\n";
    let next = "G01 Z50\nM02\n";
    let mut setup = Setup { schedule: true, ..Setup::default() };
    for (name, text) in [("A.MIN", main), ("B.MIN", next)] {
        setup.library.insert(name.to_owned(), ProgramText(text.as_bytes().to_vec()));
    }
    let mut rules = Vec::new();
    let mut last = |event: &Event| rules.extend(event.rules.as_slice().iter().map(|rule| rule.as_str()));
    run(b"PSELECT A\nPSELECT B\nEND\n", &setup, &mut last);
    assert!(rules.contains(&"E100L-NRC-71"));
    assert_eq!(rules.last(), Some(&"E100L-SDF-20"));
}

#[test]
fn a_schedule_is_counted_up_to_its_end() {
    let setup = Setup { schedule: true, ..Setup::default() };
    assert_eq!(count_blocks(b"VSET V1=1\n\nN1 END\nX??\n", &setup), 2);
    assert_eq!(count_blocks(b"$A.SDF%\nVSET V1=1\n\nN1 END\nX??\n", &Setup::default()), 2);
}

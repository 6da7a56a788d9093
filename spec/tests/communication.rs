//! Data communication, inputs, outputs and user alarms seen from outside.

use turnspec_oracle::vocabulary::notation::render;
use turnspec_oracle::vocabulary::{Event, NoseRadius, ProgramText, Setup};
use turnspec_oracle::vocabulary::{Length, UserAlarmC};

/// The trace without rules, one line an event.
fn trace(program: &[u8], setup: &Setup) -> Vec<String> {
    let mut trace = Vec::new();
    turnspec_oracle::run(program, setup, &mut |event: &Event| {
        let text = render(event);
        let words: Vec<_> = text.split(' ').filter(|word| !word.starts_with("rules=")).collect();
        trace.push(words.join(" "));
    });
    trace
}

fn last(program: &str, setup: &Setup) -> String {
    trace(program.as_bytes(), setup).pop().unwrap_or_default()
}

fn sending(texts: &[&str]) -> Setup {
    let mut setup = Setup::default();
    let texts = texts.iter().map(|text| ProgramText(text.as_bytes().to_vec())).collect();
    setup.devices.insert("CN0".to_owned(), texts);
    setup
}

/// E100L-RDWR-01, E100L-GPUT-01, E100L-GPUT-07 to -10.
#[test]
fn the_leftmost_fault_of_a_statement_decides() {
    for (block, alarm) in [
        ("READ 1 0", "format"),
        ("READ 99999999999999999999999", "device_unknown"),
        ("WRITE +1", "format"),
        ("GET VDIN[1],?", "variable_read_only"),
        ("GET VUACM[1],1", "unspecified detail=VUACM"),
        ("GET VDOUT,1", "variable_suffix"),
        ("GET V1,-1", "field_length"),
        ("GET ABCDE,1", "local_name_malformed detail=ABCDE"),
        ("GET NAB,1", "format"),
        ("GET SIN,1", "format"),
        ("GET 5", "format"),
        ("GET V1 V2", "format"),
        ("GET,1", "statement_delimiter_missing detail=GET"),
        ("PUT VUACM[1],1", "unspecified detail=VUACM"),
        ("PUT VTOFX,1", "variable_suffix"),
        ("PUT ,", "field_length"),
        ("PUT $", "number_malformed"),
        ("PUT $41424344454647484950515253545556570", "number_malformed"),
        ("PUT $0041424344454647484950515253545556", "string_too_long"),
        ("PUT $41 42", "format"),
        ("PUT 'A' 'B'", "format"),
        ("PUT 'A", "format"),
        ("PUT ^", "format"),
        ("PUT 'a", "illegal_character"),
        ("VUACM='A'", "variable_suffix"),
        ("VUACM[1] 'A'", "equal_sign_missing"),
        ("VUACM[1]='$'", "number_malformed"),
        ("VUACM[1]='$4G'", "number_malformed"),
        ("VUACM[1]=^", "format"),
        ("VDIN=1", "variable_suffix"),
        ("VTIPN[1]=2.5", "variable_range"),
        ("VTLA2[1]=360.001", "variable_range"),
        ("VGRW[13]=0", "variable_suffix"),
    ] {
        assert_eq!(
            last(&format!("{block}\nM02\n"), &Setup::default()),
            format!("alarm name={alarm} line=1"),
            "{block}"
        );
    }
}

/// E100L-GPUT-09, E100L-VUACM-01: characters that are skipped, comments between the parts, the end of a line.
#[test]
fn strings_are_read_to_their_quotation_mark() {
    let setup = Setup::default();
    let program = b"PUT(A)'A\x7F\x08B' (C)\nVUACM [ 1 ] =(D) ^'A(1'V1=1\nPUT '$41'\nWRITE 0\nM02\n";
    assert_eq!(
        trace(program, &setup)[..3],
        [
            "variable name=VUACM[1] value=a(1 line=2",
            "variable name=V1 value=1 line=2",
            "output device=CN0 text=AB$41 end_code=% line=4",
        ]
    );
    assert_eq!(last("VUACM[1]='A\n$B'\nM02\n", &setup), "alarm name=format line=1");
    assert_eq!(
        last("VUACM[1]='A'\n$ VDOUT[992]=1\nM02\n", &setup),
        "alarm name=user_alarm_b number=2288 detail=1:A line=1"
    );
    assert_eq!(last("VUACM[1]='-A'\nM02\n", &setup), "alarm name=unspecified detail=kana line=1");
    assert_eq!(last("VUACM[1]=^'-$A'\nM02\n", &setup), "end code=M02 line=2");
}

/// E100L-UT-03, E100L-IOV-01, E100L-IOV-02: a block of User Task 2 does no harm until it is carried out.
#[test]
fn the_level_is_asked_for_when_a_block_is_carried_out() {
    let mut setup = Setup::default();
    setup.options.user_task = 1;
    for (block, detail) in
        [("READ 0", " detail=READ"), ("PUT 'A'", " detail=PUT"), ("V1=VDIN[99]", ""), ("VDOUT[99]=1/0", "")]
    {
        let alarm = format!("alarm name=user_task_level{detail} line=1");
        assert_eq!(last(&format!("{block}\nM02\n"), &setup), alarm);
        assert_eq!(last(&format!("GOTO N2\n{block}\nN2 M02\n"), &setup), "end code=M02 line=3");
    }
    assert_eq!(last("VUACM[1]='A'\nM02\n", &setup), "end code=M02 line=2");
}

/// E100L-GPUT-01: an assignment by GET is one like others, its message and its alarm too.
#[test]
fn get_assigns() {
    let setup = sending(&["7", "1.5", "2"]);
    assert_eq!(
        trace(b"READ 0\nGET VDOUT[991],1\nREAD 0\nGET VDOUT[1]\nM02\n", &setup),
        [
            "variable name=VDOUT[991] value=7 line=2",
            "message number=3202 code=7 text= line=2 readings=user_alarm_c=continues",
            "alarm name=variable_range line=4",
        ]
    );
    let mut stops = sending(&["7"]);
    stops.readings.user_alarm_c = UserAlarmC::Stops;
    assert_eq!(
        last("READ 0\nGET VDOUT[991]\nM02\n", &stops),
        "alarm name=user_alarm_c number=3202 detail=7 line=2 readings=user_alarm_c=stops"
    );
    assert_eq!(last("READ 0\nGET VTOFX[1/0],9\nM02\n", &setup), "alarm name=division_by_zero line=2");
}

/// E100L-GPUT-07: only an output with a dimensional number depends on the reading.
#[test]
fn an_output_depends_on_the_reading_of_its_own_numbers() {
    let program = b"PUT VSIOX,5\nWRITE 0\nPUT V1,1\nPUT VETLN,1\nWRITE 0\nPUT VTLA1[1],5\nPUT VTLIN[1],1\nWRITE 0\nM02\n";
    assert_eq!(
        trace(program, &Setup::default())[..3],
        [
            "output device=CN0 text=0.000 end_code=% line=2 readings=put_real=fixed",
            "output device=CN0 text=00 end_code=% line=5",
            "output device=CN0 text=0.0000 end_code=% line=8 readings=put_real=fixed",
        ]
    );
}

/// E100L-NRC-44: statements of communication are blocks without motion, and what they emit waits with the others.
#[test]
fn communication_counts_in_compensation() {
    let mut setup = Setup::default();
    setup.nose_radius.push(NoseRadius { number: 1, x: Length(400_000), z: Length(400_000) });
    let begin = "G42 G01 X50 Z100 F0.2 T010101\nZ80\nX60\n";
    let ends = |middle: &str| trace(format!("{begin}{middle}Z60\nG40 X80\nM02\n").as_bytes(), &setup);
    let place = |line: &str| ends(line).iter().position(|event| event.starts_with("output"));
    assert_eq!(place("WRITE 0\n"), place("V1=1\nWRITE 0\n").map(|place| place - 1));
    assert_eq!(ends("PUT 'A'\nPUT 'B'\n").len(), ends("V1=1\nV1=2\n").len() - 2);
    let moves = |middle: &str| -> Vec<String> {
        let blocks = ends(middle);
        blocks
            .iter()
            .filter_map(|event| {
                event
                    .strip_prefix("linear")
                    .map(|rest| rest.split(" line").next().unwrap_or_default().to_owned())
            })
            .collect()
    };
    assert_eq!(moves("PUT 'A'\n"), moves("M08\n"));
    assert_eq!(moves("PUT 'A'\nPUT 'B'\n"), moves("M08\nM09\n"));
    assert_ne!(moves("PUT 'A'\n"), moves("PUT 'A'\nPUT 'B'\n"));
}

/// E100L-ANG-05: a statement is no line that a corner could be computed from, even one that would be refused later.
#[test]
fn a_corner_sees_no_line_in_a_statement() {
    for user_task in [1, 2] {
        let mut setup = Setup::default();
        setup.options.user_task = user_task;
        for block in ["READ 0", "GET V1/0", "WRITE 1", "VUACM[1/0]='A' Z-10"] {
            let line = last(&format!("G01 G75 X20 L2 F0.2\n{block}\nZ-10\nM02\n"), &setup);
            let alarm = if block == "GET V1/0" {
                "alarm name=format line=2"
            } else {
                "alarm name=angle_lookahead line=1"
            };
            assert_eq!(line, alarm, "{block}");
        }
    }
}

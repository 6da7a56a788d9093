//! The command line from outside: what it prints where, and its exit status.
//!
//! The expected coordinates follow from the programs in `tests/cli/` by hand: zero offset Z150, no tool
//! offset, so machine Z is program Z + 150.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::io::Write;
use std::process::{Command, Output, Stdio};

use turnspec_oracle::vocabulary::{Action, Event, Length, notation};

const TURN: &str = "tests/cli/turn.min";
const FAULTS: &str = "tests/cli/faults.min";
const SHAFT: &str = "examples/shaft.min";

/// What a run of `turnspec` printed, and its exit status.
struct Outcome {
    status: i32,
    stdout: String,
    stderr: String,
}

impl From<Output> for Outcome {
    fn from(output: Output) -> Self {
        Self {
            status: output.status.code().expect("not ended by a signal"),
            stdout: String::from_utf8(output.stdout).expect("standard output is UTF-8"),
            stderr: String::from_utf8(output.stderr).expect("standard error is UTF-8"),
        }
    }
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_turnspec"));
    command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR"));
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn turnspec(arguments: &[&str]) -> Outcome {
    turnspec_reading(b"", arguments)
}

fn turnspec_reading(input: &[u8], arguments: &[&str]) -> Outcome {
    let mut child = command(arguments).spawn().expect("turnspec starts");
    // A command that does not read its input may have closed it.
    let _ = child.stdin.take().expect("piped").write_all(input);
    child.wait_with_output().expect("turnspec ends").into()
}

fn events(jsonl: &str) -> Vec<Event> {
    jsonl.lines().map(|line| serde_json::from_str(line).expect("an event a line")).collect()
}

fn kinds(events: &[Event]) -> Vec<String> {
    events.iter().map(|event| notation::fields(event)[0].1.clone()).collect()
}

/// A file that lives as long as the test.
struct Scratch(std::path::PathBuf);

impl Scratch {
    fn new(name: &str, text: &[u8]) -> Self {
        let path = std::env::temp_dir().join(format!("turnspec-{}-{name}", std::process::id()));
        std::fs::write(&path, text).expect("a scratch file");
        Self(path)
    }

    fn path(&self) -> &str {
        self.0.to_str().expect("a path of UTF-8")
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

#[test]
fn run_prints_one_json_event_a_line() {
    let outcome = turnspec(&["run", "--format", "jsonl", TURN]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    let events = events(&outcome.stdout);
    assert_eq!(kinds(&events), ["rapid", "spindle", "spindle", "mode", "linear", "mode", "end"]);
    assert!((1..).zip(&events).all(|(n, event)| event.n == n));
    assert!(events.iter().all(|event| event.block.program.as_str() == "O12"));
    let Action::Linear { motion, .. } = &events[4].action else { panic!("{:?}", events[4]) };
    assert_eq!((motion.program.x, motion.program.z), (Length(50_000_000), Length(-20_000_000)));
    assert_eq!(motion.machine.z, Length(130_000_000));
    assert_eq!((events[4].block.sequence.as_str(), events[4].block.line), ("N030", 4));
}

#[test]
fn the_table_reads_like_a_person() {
    let outcome = turnspec(&["run", TURN]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = outcome.stdout.lines().collect();
    let has = |row: usize, words: &str| assert!(lines[row].contains(words), "{words}: {}", lines[row]);
    has(0, "event");
    has(1, " 2  N010   rapid to X50 Z2 ");
    has(3, " 3  N020   spindle clockwise at 800 rpm ");
    has(5, " 4  N030   linear to X50 Z-20 at 0.2 mm/rev ");
    has(5, "[feed_length=radius]");
    has(7, "end of the program (M02)");
    let column = lines[0].find("rules").unwrap();
    for line in &lines[1..] {
        assert!(line.as_bytes()[column].is_ascii_uppercase(), "{line}");
    }
}

#[test]
fn csv_has_a_fixed_header_and_as_many_columns_in_every_line() {
    let outcome = turnspec(&["run", "--format", "csv", TURN]);
    assert_eq!(outcome.status, 0);
    let lines: Vec<Vec<&str>> = outcome.stdout.lines().map(|line| line.split(',').collect()).collect();
    assert!(lines.iter().all(|line| line.len() == 70));
    assert_eq!(&lines[0][..7], ["n", "line", "sequence", "program", "kind", "x", "z"]);
    let column = |name: &str| lines[0].iter().position(|each| *each == name).unwrap();
    let linear = &lines[5];
    for (name, value) in
        [("kind", "linear"), ("z", "-20"), ("mz", "130"), ("feed", "0.2"), ("feed_unit", "mm/rev")]
    {
        assert_eq!(linear[column(name)], value, "{name}");
    }
}

#[test]
fn in_radius_compensation_the_tip_is_shown() {
    let setup = Scratch::new("nose.toml", b"[[nose_radius]]\nnumber = 1\nx = 0.8\nz = 0.8\n");
    let program = Scratch::new("nose.min", b"G42 G01 X100 Z100 F0.2 T010101\nZ60\nX150\nG40 X160\nM02\n");
    let run = |format| turnspec(&["run", "--format", format, "--setup", setup.path(), program.path()]).stdout;
    // The corner of E100L-NRC-26: the nose touches both lines, 0.8 from either.
    let table = run("table");
    assert!(table.contains("linear to X100 Z60 (tip X100 Z60) at 0.2 mm/rev"), "{table}");
    assert!(table.contains("linear to X160 Z60 at 0.2 mm/rev"), "{table}");
    let csv = run("csv");
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| lines[0].iter().position(|each| *each == name).unwrap();
    for (name, value) in [("z", "60"), ("tx", "100"), ("tz", "60"), ("nx", "101.6"), ("nz", "60.8")] {
        assert_eq!(lines[5][column(name)], value, "{name}");
    }
}

#[test]
fn a_program_comes_from_standard_input() {
    let text = std::fs::read(TURN).unwrap();
    let setup = "tests/cli/turn.setup.toml";
    let file = turnspec(&["run", "--format", "jsonl", TURN]);
    for arguments in [
        &["run", "--format", "jsonl", "--setup", setup][..],
        &["run", "-", "--format", "jsonl", "--setup", setup],
    ] {
        assert_eq!(turnspec_reading(&text, arguments).stdout, file.stdout);
    }
    // Without a path there is no set-up beside the program: the zero offset is zero.
    let plain = turnspec_reading(&text, &["run", "--format", "jsonl"]);
    let Action::Rapid { motion } = &events(&plain.stdout)[0].action else { panic!("{}", plain.stdout) };
    assert_eq!(motion.program, motion.machine);
}

#[test]
fn both_implementations_agree_on_the_example() {
    for format in ["table", "jsonl", "csv"] {
        let engine = turnspec(&["run", "--format", format, SHAFT]);
        assert_eq!((engine.status, engine.stderr.as_str()), (0, ""), "{}", engine.stdout);
        let oracle = turnspec(&["run", "--with", "oracle", "--format", format, SHAFT]);
        let both = turnspec(&["run", "--with", "both", "--format", format, SHAFT]);
        assert_eq!((both.status, both.stderr.as_str()), (0, ""));
        assert!(engine.stdout == oracle.stdout && oracle.stdout == both.stdout);
    }
}

#[test]
fn the_example_ends_with_m02_and_has_the_corners_of_its_drawing() {
    let outcome = turnspec(&["run", "--format", "jsonl", SHAFT]);
    let events = events(&outcome.stdout);
    assert!(matches!(events.last().unwrap().action, Action::End { code } if code.as_str() == "M02"));
    let texts: Vec<String> = events.iter().map(notation::render).collect();
    // Chamfer 1.5 at X30 Z0: from X27 Z0 to X30 Z-1.5. Rounding 1 at X30 Z-25: to X32 Z-25 about X32 Z-24.
    // Taper: Z = -50 + 4 / tan 165 degrees = -64.928203230...
    for corner in [
        "linear x=27 z=0 ",
        "linear x=30 z=-1.5 ",
        "linear x=30 z=-24 ",
        "arc x=32 z=-25 ",
        "sense=cw cx=32 cz=-24 ",
        "arc x=40 z=-28 ",
        "sense=ccw cx=34 cz=-28 ",
        "sense=cw cx=50 cz=-45 ",
        "linear x=58 z=-64.928203 ",
        "dwell time=0.2 ",
    ] {
        assert!(texts.iter().any(|text| text.contains(corner)), "{corner}");
    }
}

#[test]
fn an_alarm_is_the_last_event_and_a_diagnostic() {
    for with in ["engine", "oracle", "both"] {
        let program = b"N010 G00 X10\nN020 G01 X20\nM02\n";
        let outcome = turnspec_reading(program, &["run", "--format", "jsonl", "--with", with]);
        assert_eq!(outcome.status, 1);
        let events = events(&outcome.stdout);
        assert_eq!(kinds(&events), ["rapid", "mode", "alarm"]);
        for words in [
            "no_feed: cutting motion without feed",
            "standard input:2:1",
            "N020 G01 X20",
            "──",
            "E100L-G01-03",
        ] {
            assert!(outcome.stderr.contains(words), "{words}: {}", outcome.stderr);
        }
        assert!(!outcome.stderr.contains('\x1b'), "no colour outside a terminal");
    }
}

#[test]
fn a_missing_end_is_shown_after_the_last_block() {
    for program in [&b""[..], b"G00 X1", b"G00 X1\n", b"\n\n"] {
        let outcome = turnspec_reading(program, &["run"]);
        assert_eq!(outcome.status, 1);
        assert!(outcome.stderr.contains("no_program_end"), "{}", outcome.stderr);
        assert!(outcome.stderr.contains("here"), "{}", outcome.stderr);
    }
}

#[test]
fn bytes_that_are_no_utf_8_do_not_break_the_excerpt() {
    let outcome = turnspec_reading(b"(caf\xe9 \x1b[31m)\nG00 X\xff\nM02\n", &["run"]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stderr.contains("G00 X\u{FFFD}"), "{}", outcome.stderr);
    assert!(!outcome.stderr.contains('\x1b'));
}

#[test]
fn colour_can_be_forced_and_forbidden() {
    let colored = turnspec_reading(b"G01 X1\n", &["run", "--color", "always"]);
    assert!(colored.stdout.contains('\x1b') && colored.stderr.contains('\x1b'));
    let plain = turnspec_reading(b"G01 X1\n", &["--color", "never", "run"]);
    assert!(!plain.stdout.contains('\x1b') && !plain.stderr.contains('\x1b'));
}

#[test]
fn a_broken_set_up_shows_its_place() {
    let setup = Scratch::new("broken.toml", b"[options]\nw_axsi = true\n");
    let outcome = turnspec(&["run", TURN, "--setup", setup.path()]);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""));
    assert!(outcome.stderr.contains(setup.path()) && outcome.stderr.contains("line 2"), "{}", outcome.stderr);
    let setup = Scratch::new("impossible.toml", b"[options]\nuser_task = 3\n");
    let outcome = turnspec(&["check", TURN, "--setup", setup.path()]);
    assert_eq!(outcome.status, 2);
    assert!(outcome.stderr.contains("options.user_task"), "{}", outcome.stderr);
}

#[test]
fn an_unreadable_file_is_one_line() {
    for subcommand in ["run", "check", "explain"] {
        let outcome = turnspec(&[subcommand, "tests/cli/absent.min"]);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""));
        assert_eq!(outcome.stderr.lines().count(), 1);
        assert!(outcome.stderr.contains("tests/cli/absent.min"));
    }
    let outcome = turnspec(&["run", TURN, "--setup", "tests/cli/absent.toml"]);
    assert_eq!(outcome.status, 2);
    assert!(outcome.stderr.contains("tests/cli/absent.toml"));
}

#[test]
fn wrong_usage_is_status_2() {
    let wrong: [&[&str]; 6] = [
        &[],
        &["run", "--format", "xml", TURN],
        &["check"],
        &["explain", TURN, "--block", "X9"],
        &["rules", "NOTHING-01"],
        &["rules", "G50-02", "--coverage", TURN],
    ];
    for arguments in wrong {
        let outcome = turnspec(arguments);
        assert_eq!((outcome.status, outcome.stdout.as_str()), (2, ""), "{arguments:?}");
        assert!(!outcome.stderr.is_empty());
    }
}

#[test]
fn every_help_shows_examples_and_exit_statuses() {
    for subcommand in ["run", "check", "explain", "rules", "completions"] {
        let outcome = turnspec(&[subcommand, "--help"]);
        assert_eq!(outcome.status, 0);
        assert!(outcome.stdout.contains("Examples:") && outcome.stdout.contains("Exit status:"));
    }
    let version = turnspec(&["--version"]);
    assert_eq!(version.stdout, concat!("turnspec ", env!("CARGO_PKG_VERSION"), "\n"));
}

#[test]
fn a_closed_standard_output_ends_quietly() {
    let mut program = b"G01 F0.2\n".to_vec();
    for _ in 0..20_000 {
        program.extend_from_slice(b"X10 Z10\nX20 Z20\n");
    }
    program.extend_from_slice(b"M02\n");
    let program = Scratch::new("long.min", &program);
    for format in ["table", "jsonl", "csv"] {
        let mut child = command(&["run", "--format", format, program.path()]).spawn().unwrap();
        drop(child.stdout.take());
        let outcome: Outcome = child.wait_with_output().unwrap().into();
        assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    }
}

#[test]
fn check_finds_several_faults_of_a_program() {
    let outcome = turnspec(&["check", FAULTS]);
    assert_eq!((outcome.status, outcome.stdout.as_str()), (1, ""));
    for words in ["faults.min:2:", "N010 G00 X1..5", "faults.min:3:", "N020 G00 X20 Q", "number_malformed"] {
        assert!(outcome.stderr.contains(words), "{words}: {}", outcome.stderr);
    }
    let clean = turnspec(&["check", TURN]);
    assert_eq!((clean.status, clean.stdout.as_str(), clean.stderr.as_str()), (0, "", ""));
}

#[test]
fn check_prints_json() {
    let outcome = turnspec(&["check", "--format", "json", TURN, FAULTS]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (1, ""));
    let faults: serde_json::Value = serde_json::from_str(&outcome.stdout).unwrap();
    let faults = faults.as_array().unwrap();
    assert!(faults.len() >= 2);
    assert_eq!(faults[0]["file"], FAULTS);
    assert_eq!(faults[0]["alarm"]["name"], "number_malformed");
    assert_eq!(faults[0]["alarm"]["text"], "malformed number");
    assert_eq!((&faults[0]["block"]["line"], &faults[0]["block"]["sequence"]), (&2.into(), &"N010".into()));
    assert_eq!(faults[0]["rules"][0], "E100L-FMT-01");
    let clean = turnspec(&["check", "--format", "json", TURN]);
    assert_eq!((clean.status, clean.stdout.as_str()), (0, "[]\n"));
}

#[test]
fn explain_tells_each_rule_once() {
    let outcome = turnspec(&["explain", TURN]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    assert!(outcome.stdout.starts_with("line 2: N010 G00 X50 Z2\n  1. rapid to X50 Z2\n"));
    let all = turnspec(&["rules", "--format", "json", "COORD-03"]);
    let rule: serde_json::Value = serde_json::from_str(&all.stdout).unwrap();
    let title = rule["title"].as_str().unwrap();
    let first = rule["statement"].as_str().unwrap().trim().lines().next().unwrap();
    assert_eq!(outcome.stdout.matches(&format!("E100L-COORD-03 · {title}")).count(), 2, "both motions");
    assert_eq!(outcome.stdout.matches(&format!("         {first}\n")).count(), 1, "{first}");
}

/// A folder that lives as long as the test, with files.
struct Folder(std::path::PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &str)]) -> Self {
        let path = std::env::temp_dir().join(format!("turnspec-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a scratch folder");
        for (file, text) in files {
            std::fs::write(path.join(file), text).expect("a scratch file");
        }
        Self(path)
    }

    fn path(&self, file: &str) -> String {
        self.0.join(file).to_str().expect("a path of UTF-8").to_owned()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_library_is_a_folder_of_files() {
    let folder = Folder::new(
        "library",
        &[
            ("main.min", "O100\nCALL O1 DX=V1\nM02\n"),
            ("pull.sub", "O1\nG00 X=DX\nRTS\n"),
            ("notes.txt", "O1\n"),
        ],
    );
    let (main, library) = (folder.path("main.min"), folder.path(""));
    let arguments =
        ["run", "--with", "both", "--format", "jsonl", "--library", &library, "--set", "v1=12.5", &main];
    let outcome = turnspec(&arguments);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    let events = events(&outcome.stdout);
    assert_eq!(kinds(&events), ["variable", "call", "rapid", "return", "end"]);
    let Action::Rapid { motion } = &events[2].action else { panic!("{:?}", events[2]) };
    assert_eq!(motion.program.x, Length(12_500_000));
    assert_eq!((events[2].block.program.as_str(), events[2].block.line), ("O1", 2));

    let missing = turnspec(&["run", &main]);
    assert_eq!(missing.status, 1);
    assert!(missing.stderr.contains("no program with the name"), "{}", missing.stderr);
}

#[test]
fn an_alarm_in_a_library_file_shows_its_line_and_how_the_run_came_there() {
    let folder = Folder::new(
        "situation",
        &[("main.min", "O100\nV7=1\nN5 CALL O1 DX=2\nM02\n"), ("pull.sub", "O1\nN9 G00 X=DY\nRTS\n")],
    );
    let (main, library) = (folder.path("main.min"), folder.path(""));
    let outcome = turnspec(&["explain", "--library", &library, &main]);
    assert_eq!(outcome.status, 1);
    for part in [
        "PULL.SUB:2",
        "N9 G00 X=DY",
        "calls     O1 of PULL.SUB, called at line 3 of O100 (N5)",
        "DX=2 (O1)",
        "V7=1",
    ] {
        assert!(outcome.stderr.contains(part), "{part}: {}", outcome.stderr);
    }
}

#[test]
fn a_schedule_selects_main_programs_of_the_library() {
    let folder =
        Folder::new("schedule", &[("day.sdf", "PSELECT A.MIN,,,Q2\nEND\n"), ("a.min", "G00 X10\nM02\n")]);
    let (main, library) = (folder.path("day.sdf"), folder.path(""));
    let outcome = turnspec(&["run", "--with", "both", "--format", "jsonl", "--library", &library, &main]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    let kinds = kinds(&events(&outcome.stdout));
    assert_eq!(kinds, ["select", "rapid", "end", "select", "rapid", "end", "end"]);
}

#[test]
fn plot_draws_what_the_run_does() {
    let folder = Folder::new("plot", &[("a.min", "G00 X20 Z5\nG01 Z-10 F0.2\nG02 X30 Z-15 I5\nM02\n")]);
    let (program, page) = (folder.path("a.min"), folder.path("a.html"));
    let outcome = turnspec(&["plot", &program]);
    assert_eq!((outcome.status, outcome.stderr.as_str()), (0, ""));
    let svg = outcome.stdout;
    assert!(svg.starts_with("<svg xmlns=") && svg.ends_with("</svg>\n"), "{svg}");
    for class in ["rapid", "linear", "arc"] {
        assert_eq!(svg.matches(&format!("<path class=\"{class}\" data-n=")).count(), 1, "{class}: {svg}");
    }
    assert_eq!(turnspec(&["plot", &program, "--html", "--output", &page]).status, 0);
    let page = std::fs::read_to_string(page).unwrap();
    for part in
        ["G01 Z-10 F0.2", "linear to X20 Z-10 at 0.2 mm/rev", "E100L-G01-01 \u{b7} Linear interpolation"]
    {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("http://") || page.matches("http://").count() == 1, "nothing from elsewhere");
}

/// Contour and blank of a LAP call, also where the call is refused: here for want of room for the allowance.
#[test]
fn plot_draws_what_lap_was_told_to_cut() {
    let program = "NAT1 G83\nG01 X40 Z22\nX62\nZ0\nG81\nG00 X40 Z22\nG01 Z10 F0.2\nG02 X60 Z0 I10\nG80\nG00 X62 Z22\n\
                   G85 NAT1 D8 U0.2 F0.3\nG85 NAT1 D8 U30 F0.3\nM02\n";
    let folder = Folder::new("plot_lap", &[("a.min", program), ("a.toml", "[options]\nlap = 4\n")]);
    let outcome = turnspec(&["plot", &folder.path("a.min"), "--setup", &folder.path("a.toml")]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stderr.contains("lap_allowance"), "{}", outcome.stderr);
    let drawn = |class: &str| outcome.stdout.matches(&format!("<path class=\"{class}\" d=\"M")).count();
    // One of each, and the sample in the legend.
    assert_eq!((drawn("contour"), drawn("blank")), (2, 2), "{}", outcome.stdout);
    assert!(outcome.stdout.contains("class=\"linear pass p1\""), "{}", outcome.stdout);
}

/// The path up to the alarm, the alarm on standard error, status 1; files that cannot be written, status 2.
#[test]
fn plot_draws_up_to_an_alarm() {
    let program = Scratch::new("alarm.min", b"G00 X20\nG05\nM02\n");
    let outcome = turnspec(&["plot", program.path()]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stdout.contains("class=\"alarm\"") && outcome.stderr.contains("g_code_unassigned"));
    let outcome = turnspec(&["plot", program.path(), "-o", "/no/such/folder/a.svg"]);
    assert_eq!(outcome.status, 2);
    assert!(outcome.stderr.contains("/no/such/folder/a.svg"), "{}", outcome.stderr);
}

/// Past its most motions the program is not run on: here it would go on for longer than its limit of steps.
#[test]
fn plot_stops_at_its_most_motions() {
    let program =
        Scratch::new("motions.min", format!("N1 X1\n{}GOTO N1\n", "X2\nX1\n".repeat(500)).as_bytes());
    let setup = Scratch::new("motions.toml", b"[limits]\nsteps = 110000\n");
    let outcome = turnspec(&["plot", "--setup", setup.path(), program.path()]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    assert!(
        outcome.stderr.contains("more than 100000 motions; the run was stopped there"),
        "{}",
        outcome.stderr
    );
}

#[test]
fn explain_shows_where_the_saddles_wait() {
    let program = Scratch::new("saddles.min", b"G13\nG00 X10 P20\nG14\nG01 X20\nM02\n");
    let setup = Scratch::new("saddles.toml", b"[machine]\ntype = \"2S\"\n");
    let outcome = turnspec(&["explain", "--setup", setup.path(), program.path()]);
    assert_eq!(outcome.status, 1);
    let part = "saddles   A waits at P20, line 2; B at line 4";
    assert!(outcome.stderr.contains("no_feed") && outcome.stderr.contains(part), "{}", outcome.stderr);
}

/// A program without a name is known by the file that was selected.
#[test]
fn an_alarm_of_a_selected_program_shows_its_file() {
    let folder =
        Folder::new("selected", &[("day.sdf", "PSELECT A.MIN\nEND\n"), ("a.min", "G00 X10\nG05\nM02\n")]);
    let (main, library) = (folder.path("day.sdf"), folder.path(""));
    for command in ["run", "explain"] {
        let outcome = turnspec(&[command, "--library", &library, &main]);
        assert_eq!(outcome.status, 1);
        for part in ["A.MIN:2", "G05"] {
            assert!(outcome.stderr.contains(part), "{command}: {part}: {}", outcome.stderr);
        }
    }
}

#[test]
fn a_runaway_program_ends_at_the_limit() {
    let program = Scratch::new("endless.min", b"N1 V1=V1+1\nGOTO N1\n");
    let setup = Scratch::new("endless.toml", b"[limits]\nsteps = 5\n");
    let outcome = turnspec(&["run", "--with", "both", "--setup", setup.path(), program.path()]);
    assert_eq!(outcome.status, 1);
    assert!(outcome.stderr.contains("step limit reached"), "{}", outcome.stderr);
    // That a program goes on is no fault of its text.
    assert_eq!(turnspec(&["check", program.path()]).status, 0);
}

#[test]
fn values_and_libraries_that_are_wrong_are_refused() {
    let folder = Folder::new("wrong", &[("main.min", "M02\n"), ("no name.sub", "O1\nRTS\n")]);
    let (main, library) = (folder.path("main.min"), folder.path(""));
    for (arguments, reason) in [
        (["--set", "V1"], "not of the form V1=10"),
        (["--set", "V201=1"], "is not one of V1 to V200"),
        (["--set", "V1=inf"], "is not finite"),
        (["--library", "/no/such/folder"], "/no/such/folder"),
        (["--library", library.as_str()], "NO NAME.SUB"),
    ] {
        let outcome = turnspec(&["run", arguments[0], arguments[1], &main]);
        assert_eq!(outcome.status, 2, "{arguments:?}");
        assert!(outcome.stderr.contains(reason), "{reason}: {}", outcome.stderr);
    }
}

#[test]
fn explain_selects_a_block_by_name_or_line() {
    let name = turnspec(&["explain", TURN, "--block", "N030"]);
    let line = turnspec(&["explain", TURN, "--block", "4"]);
    assert_eq!(name.stdout, line.stdout);
    assert!(name.stdout.starts_with("line 4: N030 G01 Z-20 F0.2\n"));
    assert!(!name.stdout.contains("N010"));
    let none = turnspec(&["explain", TURN, "--block", "N999"]);
    assert_eq!((none.status, none.stdout.as_str()), (2, ""));
}

#[test]
fn rules_are_listed_filtered_and_shown() {
    let all = turnspec(&["rules"]);
    let area = turnspec(&["rules", "--area", "G50"]);
    assert_eq!((all.status, area.status), (0, 0));
    assert!(
        area.stdout.lines().count() > 1 && area.stdout.lines().all(|line| line.starts_with("E100L-G50-"))
    );
    assert!(area.stdout.lines().all(|line| all.stdout.contains(line)));
    let count = |arguments: &[&str]| turnspec(arguments).stdout.lines().count();
    let by_basis =
        ["manual", "interpretation", "unspecified"].map(|basis| count(&["rules", "--basis", basis]));
    let by_level = ["core", "option", "listed"].map(|level| count(&["rules", "--level", level]));
    assert_eq!(by_basis.iter().sum::<usize>(), all.stdout.lines().count());
    assert_eq!(by_level.iter().sum::<usize>(), all.stdout.lines().count());
    let one = turnspec(&["rules", "CIRC-01"]);
    assert_eq!(one.stdout, turnspec(&["rules", "e100l-circ-01"]).stdout);
    for words in ["E100L-CIRC-01 · ", "source", "basis", "program", "trace"] {
        assert!(one.stdout.contains(words), "{words}: {}", one.stdout);
    }
}

#[test]
fn coverage_adds_up() {
    let outcome = turnspec(&["rules", "--coverage", TURN, FAULTS, "--format", "json"]);
    assert_eq!(outcome.status, 0);
    let coverage: serde_json::Value = serde_json::from_str(&outcome.stdout).unwrap();
    let ids = |key: &str| -> Vec<String> {
        coverage[key].as_array().unwrap().iter().map(|rule| rule["id"].as_str().unwrap().to_owned()).collect()
    };
    let (cited, not_cited) = (ids("cited"), ids("not_cited"));
    assert_eq!(coverage["rules"], cited.len() + not_cited.len());
    for id in ["E100L-G00-01", "E100L-G01-01", "E100L-COORD-03", "E100L-MCODE-04", "E100L-FMT-01"] {
        assert!(cited.contains(&id.to_owned()), "{id}");
    }
    assert!(not_cited.contains(&"E100L-CIRC-01".to_owned()));
    let text = turnspec(&["rules", "--area", "CIRC", "--coverage", TURN]);
    assert!(text.stdout.lines().last().unwrap().starts_with("0 of "), "{}", text.stdout);
}

/// By its file name, as `run` does.
#[test]
fn coverage_knows_a_schedule_program() {
    let folder = Folder::new("schedule", &[("day.SDF", "PSELECT A.MIN\nEND\n")]);
    let outcome = turnspec(&["rules", "--area", "SDF", "--coverage", &folder.path("day.SDF")]);
    assert_eq!(outcome.status, 0, "{}", outcome.stderr);
    assert!(outcome.stdout.starts_with("cited\n  E100L-SDF-07 "), "{}", outcome.stdout);
}

#[test]
fn completions_name_the_subcommands() {
    for shell in ["bash", "zsh", "fish"] {
        let outcome = turnspec(&["completions", shell]);
        assert_eq!(outcome.status, 0);
        assert!(["run", "check", "explain", "rules"].iter().all(|name| outcome.stdout.contains(name)));
    }
}

//! Implementations that behave badly never bring the runner down, and leave nothing behind.

#![allow(clippy::panic)]

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use turnspec_conformance::{Exit, Implementation, Outcome, RunError, Task};
use turnspec_oracle::vocabulary::Setup;

/// An implementation that is a few lines of shell.
fn shell(script: &str) -> Implementation {
    let command = ["sh", "-c", script].map(|word| format!("'{}'", word.replace('\'', "'\\''"))).join(" ");
    Implementation::new(&command).unwrap_or_else(|error| panic!("{error}"))
}

fn run(implementation: &Implementation) -> Outcome {
    run_on(implementation, b"M02\n")
}

fn run_on(implementation: &Implementation, program: &[u8]) -> Outcome {
    let task = Task::new("test", program, &Setup::default());
    implementation.run(&task).unwrap_or_else(|error| panic!("{error}"))
}

fn output(outcome: &Outcome) -> String {
    String::from_utf8_lossy(&outcome.output).into_owned()
}

#[test]
fn input_output_error_and_status_pass_through() {
    let outcome = run(&shell("cat; echo oops >&2; exit 1"));
    assert_eq!(outcome.exit, Exit::Status(1));
    assert_eq!(outcome.stderr, "oops\n");
    let task: Task = serde_json::from_str(&output(&outcome)).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(task, Task::new("test", b"M02\n", &Setup::default()));
}

#[test]
fn a_signal_is_told_from_a_status() {
    assert_eq!(run(&shell("kill -SEGV $$")).exit, Exit::Signal(11));
    assert_eq!(run(&shell("exit 139")).exit, Exit::Status(139));
}

#[test]
fn a_large_input_that_nobody_reads_is_no_obstacle() {
    let program = vec![b'M'; 3 << 20];
    assert_eq!(run_on(&shell("exec 0<&-; sleep 0.1; echo done"), &program).exit, Exit::Status(0));
    let unread = run_on(&shell("echo done; sleep 0.1"), &program);
    assert_eq!((unread.exit, output(&unread).as_str()), (Exit::Status(0), "done\n"));
}

#[test]
fn a_large_input_is_read_while_output_is_written() {
    let program = vec![b'M'; 1 << 20];
    let echoed = run_on(&shell("cat"), &program);
    assert_eq!(echoed.exit, Exit::Status(0));
    assert!(echoed.output.len() > program.len());
}

#[test]
fn a_hang_ends_with_its_time() {
    let hanging =
        shell("cat > /dev/null; echo partial; sleep 1000").with_time_out(Duration::from_millis(300));
    let start = Instant::now();
    let outcome = run(&hanging);
    assert_eq!((outcome.exit, output(&outcome).as_str()), (Exit::TimeOut, "partial\n"));
    assert!(start.elapsed() < Duration::from_secs(20));
    let silent = shell("exec 0<&- 1>&- 2>&-; sleep 1000").with_time_out(Duration::from_millis(300));
    assert_eq!(run(&silent).exit, Exit::TimeOut);
}

#[test]
fn a_flood_ends_at_its_limit() {
    for script in ["yes", "yes >&2", "tr '\\0' x < /dev/zero"] {
        let outcome = run(&shell(script).with_output_limit(100_000));
        assert_eq!(outcome.exit, Exit::Flood, "{script}");
        assert!(outcome.output.len() <= 200_000 && outcome.stderr.len() <= 100_000);
    }
    let exact = shell("head -c 1000 /dev/zero").with_output_limit(1000);
    assert_eq!(run(&exact).exit, Exit::Status(0));
}

#[test]
fn the_end_of_standard_error_is_kept() {
    let outcome = run(&shell("i=0; while [ $i -lt 2000 ]; do echo line $i >&2; i=$((i+1)); done"));
    assert!(outcome.stderr.ends_with("line 1999\n"));
    assert!(outcome.stderr.len() <= 4096);
}

/// A file that a process of the test writes its id to.
struct Note(PathBuf);

impl Note {
    fn new(name: &str) -> Self {
        Self(std::env::temp_dir().join(format!("turnspec-{}-{name}", std::process::id())))
    }

    fn path(&self) -> String {
        self.0.display().to_string()
    }

    /// Whether the process that noted its id is alive; a process that nobody collects counts as dead.
    fn is_alive(&self) -> bool {
        let id = fs::read_to_string(&self.0).unwrap_or_default();
        assert!(!id.trim().is_empty(), "the process noted no id");
        let state = fs::read_to_string(format!("/proc/{}/stat", id.trim())).unwrap_or_default();
        !matches!(state.rsplit(") ").next().and_then(|rest| rest.chars().next()), None | Some('Z' | 'X'))
    }

    fn is_dead_soon(&self) -> bool {
        (0..100).any(|_| {
            thread::sleep(Duration::from_millis(20));
            !self.is_alive()
        })
    }
}

impl Drop for Note {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

#[test]
fn a_grandchild_that_keeps_the_pipes_open_is_not_waited_for_and_killed() {
    let note = Note::new("grandchild");
    let start = Instant::now();
    let outcome = run(&shell(&format!("(sleep 1000 & echo $! > {}); echo done", note.path())));
    assert_eq!((outcome.exit, output(&outcome).as_str()), (Exit::Status(0), "done\n"));
    assert!(start.elapsed() < Duration::from_secs(8), "{:?}", start.elapsed());
    assert!(note.is_dead_soon());
}

#[test]
fn a_grandchild_that_left_the_group_is_not_waited_for() {
    let note = Note::new("session");
    let start = Instant::now();
    let script = format!("setsid sh -c 'echo $$ > {}; exec sleep 12' & sleep 0.3; echo done", note.path());
    let outcome = run(&shell(&script));
    assert_eq!((outcome.exit, output(&outcome).as_str()), (Exit::Status(0), "done\n"));
    assert!(start.elapsed() < Duration::from_secs(8), "{:?}", start.elapsed());
}

#[test]
fn the_children_of_a_hang_are_killed() {
    let note = Note::new("hang");
    let script = format!("sleep 1000 & echo $! > {}; wait", note.path());
    assert_eq!(run(&shell(&script).with_time_out(Duration::from_millis(400))).exit, Exit::TimeOut);
    assert!(note.is_dead_soon());
}

#[test]
fn an_interrupt_ends_a_run_and_its_children() {
    let note = Note::new("interrupt");
    let flag = Arc::new(AtomicBool::new(false));
    let script = format!("echo $$ > {}; exec sleep 1000", note.path());
    let implementation = shell(&script).with_interrupt(Arc::clone(&flag));
    let raise = thread::spawn(move || {
        thread::sleep(Duration::from_millis(400));
        flag.store(true, Ordering::Relaxed);
    });
    let result = implementation.run(&Task::new("test", b"", &Setup::default()));
    assert!(matches!(result, Err(RunError::Interrupted)), "{result:?}");
    assert!(raise.join().is_ok());
    assert!(note.is_dead_soon());
}

#[test]
fn what_does_not_start_is_an_error_at_once() {
    for command in ["/nonexistent/implementation", "'no such command' -x", "/etc/passwd"] {
        let implementation = Implementation::new(command).unwrap_or_else(|error| panic!("{error}"));
        let result = implementation.run(&Task::new("test", b"", &Setup::default()));
        assert!(matches!(result, Err(RunError::Start(_))), "{command}: {result:?}");
    }
    for command in ["", "  ", "'' x", "sh -c 'no end"] {
        assert!(matches!(Implementation::new(command), Err(RunError::Start(_))), "{command}");
    }
}

//! Trying the mutants: which tests pass by a mutant, and whether one of them fails when it is on.

use std::collections::BTreeSet;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::build::Workshop;
use crate::fault::Fault;

/// Seconds of the processor that a test has, and at least ten times what it takes without a mutant.
const PATIENCE: u64 = 10;
/// What a process dies of that has had them all.
const OUT_OF_TIME: i32 = 24;
/// Kilobytes of memory that a test may take.
const MEMORY: &str = "4000000";

/// What the tests said about a mutant.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Judged<'a> {
    /// This test failed.
    Caught(&'a str),
    /// This test did not come to an end.
    Timeout(&'a str),
    /// Every test passed, and at least one passed by it.
    Missed,
    /// No test passed by it.
    NotReached,
}

/// A test, and which mutants it passes by.
struct Test {
    binary: PathBuf,
    /// The package, where cargo runs it.
    folder: PathBuf,
    name: String,
    takes: Duration,
    reaches: BTreeSet<usize>,
}

/// The tests of a package, built with its mutants.
pub struct Tests {
    tests: Vec<Test>,
}

impl Tests {
    /// Builds the tests and runs each of them once without a mutant.
    ///
    /// # Errors
    /// When they cannot be built, or one fails.
    pub fn build(shop: &Workshop) -> Result<Self, Fault> {
        let output = shop.tests().output().map_err(|error| Fault::about("cargo test", error))?;
        if !output.status.success() {
            return Err(Fault::about("cargo test", String::from_utf8_lossy(&output.stderr)));
        }
        let mut tests = Vec::new();
        for line in String::from_utf8_lossy(&output.stdout).lines() {
            let Ok(message) = serde_json::from_str::<Value>(line) else { continue };
            let (Some(binary), Some(manifest)) =
                (message["executable"].as_str(), message["manifest_path"].as_str())
            else {
                continue;
            };
            let listed = Command::new(binary).args(["--list", "--format", "terse"]).output();
            let listed = listed.map_err(|error| Fault::about(binary, error))?;
            for line in String::from_utf8_lossy(&listed.stdout).lines() {
                if let Some(name) = line.strip_suffix(": test") {
                    tests.push(Test {
                        binary: binary.into(),
                        folder: Path::new(manifest).parent().unwrap_or(&shop.root).to_owned(),
                        name: name.to_owned(),
                        takes: Duration::ZERO,
                        reaches: BTreeSet::new(),
                    });
                }
            }
        }
        let reached = shop.root.join("reached.txt");
        for test in &mut tests {
            let _ = fs::remove_file(&reached);
            let begun = Instant::now();
            let passed = run(test, ("TURNSPEC_REACHED", &reached.to_string_lossy()), PATIENCE * 30);
            if passed != Some(true) {
                return Err(Fault::about(&test.name, "fails without a mutant"));
            }
            test.takes = begun.elapsed();
            let text = fs::read_to_string(&reached).unwrap_or_default();
            test.reaches = text.lines().filter_map(|line| line.parse().ok()).collect();
        }
        tests.sort_by_key(|test| test.takes);
        Ok(Self { tests })
    }

    /// How many there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.tests.len()
    }

    /// Tries the mutants, some at once, and tells `done` of each.
    pub fn attempt(&self, mutants: &[usize], jobs: usize, done: &(impl Fn(usize, Judged<'_>) + Sync)) {
        let next = AtomicUsize::new(0);
        let work = || {
            // A test that has just caught one is likely to catch the next.
            let mut order: Vec<&Test> = self.tests.iter().collect();
            while let Some(mutant) = mutants.get(next.fetch_add(1, Ordering::Relaxed)) {
                done(*mutant, self.judge(*mutant, &mut order));
            }
        };
        thread::scope(|scope| {
            for _ in 0..jobs.max(1) {
                scope.spawn(work);
            }
        });
    }

    fn judge<'a>(&self, mutant: usize, order: &mut [&'a Test]) -> Judged<'a> {
        let mut reached = false;
        for place in 0..order.len() {
            let test = order[place];
            if !test.reaches.contains(&mutant) {
                continue;
            }
            reached = true;
            let patience = PATIENCE.max((test.takes * 10).as_secs());
            let passed = run(test, ("TURNSPEC_MUTANT", &mutant.to_string()), patience);
            if passed == Some(true) {
                continue;
            }
            order[..=place].rotate_right(1);
            return if passed.is_some() { Judged::Caught(&test.name) } else { Judged::Timeout(&test.name) };
        }
        if reached { Judged::Missed } else { Judged::NotReached }
    }
}

/// Whether the test passes; nothing if it does not come to an end. The time is that of the processor, whatever else it does.
fn run(test: &Test, variable: (&str, &str), seconds: u64) -> Option<bool> {
    let mut command = Command::new("sh");
    let limits = format!("ulimit -v {MEMORY}; ulimit -St {seconds}; exec \"$@\"");
    command.args(["-c", &limits, "sh"]).arg(&test.binary);
    command.args(["--exact", &test.name, "--test-threads", "1"]).current_dir(&test.folder);
    command.env(variable.0, variable.1).env("PROPTEST_FAILURE_PERSISTENCE", "off");
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    match command.status() {
        Ok(status) if status.signal() == Some(OUT_OF_TIME) => None,
        Ok(status) => Some(status.success()),
        Err(_) => Some(false),
    }
}

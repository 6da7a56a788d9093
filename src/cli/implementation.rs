//! The implementation under test: what `conform` and `fuzz` ask about it.

use std::fs;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::thread;
use std::time::Duration;

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
use turnspec_conformance::{Declaration, Implementation};

use super::Failure;

/// The options about the implementation.
#[derive(clap::Args)]
pub struct UnderTest {
    /// The command of the implementation, split as a shell does; no shell is started.
    #[arg(long = "impl", value_name = "COMMAND")]
    pub command: String,
    /// What the implementation declares; without it everything, exactly.
    #[arg(long, value_name = "FILE")]
    declare: Option<PathBuf>,
    /// How many programs run at once; as many as there are processors if it is missing.
    #[arg(long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
    /// The longest time of a program, in seconds.
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = seconds)]
    timeout: Duration,
}

impl UnderTest {
    /// The declaration and its text, or the declaration of everything under the name of the command.
    pub fn declaration(&self) -> Result<(Declaration, String), Failure> {
        let Some(path) = &self.declare else {
            return Ok((Declaration::of_everything(&self.command), String::new()));
        };
        let text = fs::read_to_string(path).map_err(|error| Failure::about(path.display(), error))?;
        let declaration = Declaration::from_toml(&text).map_err(|error| {
            let separator = if error.to_string().contains('\n') { "\n" } else { " " };
            Failure::Usage(format!("{}: broken declaration:{separator}{error}", path.display()))
        })?;
        Ok((declaration, text))
    }

    /// How it is run; Ctrl-C, a request to end and the end of the terminal end every run.
    pub fn implementation(&self) -> Result<Implementation, Failure> {
        let implementation =
            Implementation::new(&self.command).map_err(|error| Failure::about("--impl", error))?;
        Ok(implementation.with_time_out(self.timeout).with_interrupt(interrupt()?))
    }

    /// How many programs run at once.
    pub fn jobs(&self) -> usize {
        self.jobs.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get)
    }
}

/// Reads a time; at least a millisecond, at most a day.
fn seconds(text: &str) -> Result<Duration, String> {
    let time = text.parse().ok().and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    let sensible = Duration::from_millis(1)..=Duration::from_secs(86_400);
    time.filter(|time| sensible.contains(time)).ok_or_else(|| "not a time from 0.001 to 86400 s".to_owned())
}

/// A flag that Ctrl-C, a request to end and the end of the terminal raise: every run ends and its processes are
/// killed. Who was started by `nohup` outlives the terminal.
fn interrupt() -> Result<Arc<AtomicBool>, Failure> {
    let flag = Arc::new(AtomicBool::new(false));
    let hang_up = (!is_ignored(SIGHUP)).then_some(SIGHUP);
    for signal in [SIGINT, SIGTERM].into_iter().chain(hang_up) {
        signal_hook::flag::register(signal, Arc::clone(&flag))
            .map_err(|error| Failure::about("Ctrl-C cannot be watched", error))?;
    }
    Ok(flag)
}

/// Whether this process was started with a signal ignored, where the system tells.
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    (mask >> (signal - 1)) & 1 == 1
}

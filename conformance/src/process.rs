//! Runs an implementation on one task: a process of its own, in a process group of its own, that may do
//! anything.
//!
//! One loop feeds standard input and reads both outputs without ever blocking on any of them. When the
//! program has ended, or has used up its time or its output, its whole group is killed, so that nothing that
//! it started stays behind unless it left the group on purpose. What such a process still writes is not
//! waited for.

use std::fmt;
use std::io;
use std::os::unix::process::{CommandExt, ExitStatusExt};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, WaitId, WaitIdOptions, kill_process_group, waitid};

use crate::Task;
use crate::pipes::Pipes;

/// The longest time without a look at the clock, at the process and at the interrupt.
const TICK: Duration = Duration::from_millis(20);

/// How to run an implementation under test.
#[derive(Clone, Debug)]
pub struct Implementation {
    program: String,
    arguments: Vec<String>,
    time_out: Duration,
    output_limit: usize,
    interrupt: Arc<AtomicBool>,
}

/// What came of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How the run ended.
    pub exit: Exit,
    /// What it wrote to standard output.
    pub output: Vec<u8>,
    /// The end of what it wrote to standard error.
    pub stderr: String,
    /// How long it took.
    pub duration: Duration,
}

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Exit {
    /// With an exit status.
    Status(i32),
    /// By a signal.
    Signal(i32),
    /// It was not finished in time.
    TimeOut,
    /// It wrote more than the limit.
    Flood,
}

/// Why a run did not take place.
#[derive(Debug)]
pub enum RunError {
    /// The program does not start.
    Start(String),
    /// The system refused a pipe or a wait.
    System(io::Error),
    /// The interrupt flag was raised.
    Interrupted,
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start(reason) => f.write_str(reason),
            Self::System(error) => write!(f, "the implementation cannot be watched: {error}"),
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl std::error::Error for RunError {}

impl From<io::Error> for RunError {
    fn from(error: io::Error) -> Self {
        Self::System(error)
    }
}

impl From<rustix::io::Errno> for RunError {
    fn from(error: rustix::io::Errno) -> Self {
        Self::System(error.into())
    }
}

impl Implementation {
    /// Time that a run may take unless another is chosen.
    pub const TIME_OUT: Duration = Duration::from_secs(10);
    /// Bytes that a run may write to either output unless another limit is chosen.
    pub const OUTPUT_LIMIT: usize = 4 << 20;

    /// The implementation that a command starts. The command is split by the quoting rules of a shell; no
    /// shell is started.
    ///
    /// # Errors
    /// When the command is empty or a quotation does not end.
    pub fn new(command: &str) -> Result<Self, RunError> {
        let words = shlex::split(command)
            .ok_or_else(|| RunError::Start(format!("{command:?}: a quotation does not end")))?;
        let mut words = words.into_iter();
        let program = words.next().filter(|program| !program.is_empty());
        let program = program.ok_or_else(|| RunError::Start("the command is empty".to_owned()))?;
        Ok(Self {
            program,
            arguments: words.collect(),
            time_out: Self::TIME_OUT,
            output_limit: Self::OUTPUT_LIMIT,
            interrupt: Arc::default(),
        })
    }

    /// With another time-out.
    #[must_use]
    pub fn with_time_out(self, time_out: Duration) -> Self {
        Self { time_out, ..self }
    }

    /// With another limit of output, in bytes; standard output and standard error have it each.
    #[must_use]
    pub fn with_output_limit(self, output_limit: usize) -> Self {
        Self { output_limit, ..self }
    }

    /// With a flag that, once raised, ends every run.
    #[must_use]
    pub fn with_interrupt(self, interrupt: Arc<AtomicBool>) -> Self {
        Self { interrupt, ..self }
    }

    /// Runs it on a task.
    ///
    /// # Errors
    /// When it does not start, when the system refuses to watch it, or when the interrupt flag is raised. What
    /// it does after its start is an [`Outcome`], never an error.
    pub fn run(&self, task: &Task) -> Result<Outcome, RunError> {
        let mut input = serde_json::to_vec(task).map_err(io::Error::from)?;
        input.push(b'\n');
        let start = Instant::now();
        let mut group = self.start()?;
        let mut pipes = Pipes::of(&mut group.child, input, self.output_limit)?;
        let exit = self.watch(&mut group, &mut pipes, start)?;
        Ok(Outcome { exit, duration: start.elapsed(), stderr: pipes.stderr(), output: pipes.into_output() })
    }

    fn start(&self) -> Result<Group, RunError> {
        let mut command = Command::new(&self.program);
        command.args(&self.arguments).process_group(0);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let child = command.spawn().map_err(|error| RunError::Start(format!("{}: {error}", self.program)))?;
        let leader = Pid::from_child(&child);
        Ok(Group { child, leader, collected: false })
    }

    fn watch(&self, group: &mut Group, pipes: &mut Pipes, start: Instant) -> Result<Exit, RunError> {
        let mut pause = Duration::from_micros(200);
        loop {
            if self.interrupt.load(Ordering::Relaxed) {
                return Err(RunError::Interrupted);
            }
            let elapsed = start.elapsed();
            if elapsed >= self.time_out {
                return Ok(Exit::TimeOut);
            }
            let longest = TICK.min(self.time_out - elapsed);
            // Once both outputs are closed the end is near: look again soon, then less and less often.
            if pipes.outputs_closed() {
                pause = (pause * 2).min(longest);
                pipes.wait(pause)?;
            } else {
                pipes.wait(longest)?;
            }
            let ended = group.has_ended()?;
            pipes.transfer();
            if pipes.flooded() {
                return Ok(Exit::Flood);
            }
            if ended {
                let status = group.end()?;
                return Ok(status.code().map_or(Exit::Signal(status.signal().unwrap_or(0)), Exit::Status));
            }
        }
    }
}

/// A process and whatever it starts; killed and collected at the latest when it is dropped.
struct Group {
    child: Child,
    leader: Pid,
    /// Whether the first process has been collected: its id may belong to somebody else by now.
    collected: bool,
}

impl Group {
    /// Whether the first process has ended. It is not collected, so that its id stays taken.
    fn has_ended(&self) -> Result<bool, RunError> {
        let options = WaitIdOptions::EXITED | WaitIdOptions::NOHANG | WaitIdOptions::NOWAIT;
        Ok(waitid(WaitId::Pid(self.leader), options)?.is_some())
    }

    /// Kills what is left of the group and collects the first process.
    fn end(&mut self) -> io::Result<ExitStatus> {
        // The group is gone when nobody is left in it.
        let _ = kill_process_group(self.leader, Signal::KILL);
        self.collected = true;
        self.child.wait()
    }
}

impl Drop for Group {
    fn drop(&mut self) {
        // Also when the first process has ended by itself: those that it started may be alive.
        if !self.collected {
            let _ = self.end();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::thread;
    use std::time::Duration;

    use super::Implementation;

    /// Whether a process is alive; one that nobody collects counts as dead.
    fn is_alive(id: &str) -> bool {
        let state = fs::read_to_string(format!("/proc/{id}/stat")).unwrap_or_default();
        !matches!(state.rsplit(") ").next().and_then(|rest| rest.chars().next()), None | Some('Z' | 'X'))
    }

    /// Waits some seconds for a condition.
    fn soon(condition: impl Fn() -> bool) -> bool {
        (0..500).any(|_| {
            thread::sleep(Duration::from_millis(10));
            condition()
        })
    }

    /// What happens after a flood, at the end of the time and at an interrupt, when the program has just ended.
    #[test]
    fn a_group_whose_first_process_has_ended_is_killed() -> Result<(), Box<dyn std::error::Error>> {
        let note = std::env::temp_dir().join(format!("turnspec-{}-left-behind", std::process::id()));
        let script = format!("sleep 1000 & echo $! > {}", note.display());
        let group = Implementation::new(&format!("sh -c '{script}'"))?.start()?;
        assert!(soon(|| group.has_ended().unwrap_or(false)), "the program ends");
        let id = fs::read_to_string(&note)?;
        fs::remove_file(&note)?;
        assert!(is_alive(id.trim()), "what it started runs on");
        drop(group);
        assert!(soon(|| !is_alive(id.trim())), "process {id} is alive");
        Ok(())
    }
}

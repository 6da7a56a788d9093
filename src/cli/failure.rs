//! What a subcommand comes to: a verdict on the program, or a reason why there is none.

use std::fmt::Display;
use std::io;

/// The verdict of a subcommand that did its work.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Verdict {
    /// Nothing to object to.
    Clean,
    /// An alarm, a fault or a mismatch.
    Fault,
}

impl Verdict {
    /// `Fault` if there is one.
    pub fn fault_if(fault: bool) -> Self {
        if fault { Self::Fault } else { Self::Clean }
    }
}

/// Why a subcommand could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// The caller has to change something; the message says what.
    Usage(String),
    /// Nobody reads standard output any more.
    OutputClosed,
}

impl Failure {
    /// A failure that concerns a file or another named thing.
    pub fn about(subject: impl Display, reason: impl Display) -> Self {
        Self::Usage(format!("{subject}: {reason}"))
    }
}

/// Writing is the only input or output whose errors are converted; reading names its file.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::OutputClosed,
            _ => Self::about("standard output", error),
        }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        io::Error::from(error).into()
    }
}

//! When output is coloured.

use std::io::{IsTerminal, stderr, stdout};

/// The value of `--color`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum ColorChoice {
    /// On a terminal, unless `NO_COLOR` is set.
    Auto,
    /// In any case.
    Always,
    /// Not at all.
    Never,
}

impl ColorChoice {
    /// Whether data on standard output is coloured.
    pub fn on_stdout(self) -> bool {
        self.decide(stdout().is_terminal())
    }

    /// Whether diagnostics on standard error are coloured.
    pub fn on_stderr(self) -> bool {
        self.decide(stderr().is_terminal())
    }

    fn decide(self, terminal: bool) -> bool {
        match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto => terminal && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()),
        }
    }
}

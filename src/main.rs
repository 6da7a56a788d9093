//! The command line: parses the arguments, calls the subcommand, maps its verdict to the exit status.

mod cli;

use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

use cli::{Cli, Failure, Verdict};

fn main() -> ExitCode {
    match Cli::parse().carry_out() {
        Ok(Verdict::Clean) | Err(Failure::OutputClosed) => ExitCode::SUCCESS,
        Ok(Verdict::Fault) => ExitCode::from(1),
        Err(Failure::Usage(message)) => {
            let _ = writeln!(std::io::stderr(), "turnspec: {message}");
            ExitCode::from(2)
        }
    }
}

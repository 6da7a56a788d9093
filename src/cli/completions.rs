//! `completions`: the completion script of a shell.

use std::io::{Write, stdout};

use clap::CommandFactory;
use clap_complete::Shell;

use super::{Cli, Failure, Verdict, exit_status};

/// Print the completion script of a shell.
#[derive(clap::Args)]
#[command(after_help = concat!(
    "Examples:\n  turnspec completions bash > ~/.local/share/bash-completion/completions/turnspec\n  \
     turnspec completions zsh > ~/.zfunc/_turnspec\n\n",
    exit_status!()
))]
pub struct Arguments {
    /// The shell.
    shell: Shell,
}

/// Prints the script.
pub fn carry_out(arguments: &Arguments) -> Result<Verdict, Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut Cli::command(), "turnspec", &mut script);
    stdout().write_all(&script)?;
    Ok(Verdict::Clean)
}

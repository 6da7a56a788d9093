//! The subcommands, and what each of them can come to.

mod answer;
mod audit;
mod book;
mod check;
mod color;
mod completions;
mod conform;
mod csv;
mod excerpt;
mod explain;
mod failure;
mod format;
mod fuzz;
mod implementation;
mod input;
mod lockstep;
mod machine;
mod options;
mod plot;
mod report;
mod rules;
mod run;
mod situation;
mod sources;
mod trace;
mod words;
mod wrap;

use clap::{Parser, Subcommand};

pub use color::ColorChoice;
pub use failure::{Failure, Verdict};

/// The exit statuses, shown below the help of every subcommand.
macro_rules! exit_status {
    () => {
        "Exit status:\n  0  done, nothing to object to\n  1  an alarm, a fault or a mismatch\n  2  wrong usage, \
         unreadable file or broken set-up"
    };
}
/// Where a set-up comes from, shown below the help of the subcommands that need one.
macro_rules! setup_help {
    () => {
        "Set-up:\n  Without --setup, the file beside the program with the extension .setup.toml is used \
         (shaft.setup.toml\n  for shaft.min); if there is none, every key has its default."
    };
}
pub(crate) use {exit_status, setup_help};

/// Executable reference semantics of CNC lathe controls: what must the control do?
///
/// Data goes to standard output, diagnostics go to standard error.
#[derive(Parser)]
#[command(name = "turnspec", version, after_help = exit_status!(), disable_help_subcommand = true)]
pub struct Cli {
    /// When to use colour; auto means on a terminal, unless NO_COLOR is set.
    #[arg(long, global = true, value_enum, default_value_t = ColorChoice::Auto, value_name = "WHEN")]
    color: ColorChoice,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Run(run::Arguments),
    Check(check::Arguments),
    Explain(explain::Arguments),
    Plot(plot::Arguments),
    Rules(rules::Arguments),
    Conform(conform::Arguments),
    Answer(answer::Arguments),
    Fuzz(fuzz::Arguments),
    Audit(audit::Arguments),
    Completions(completions::Arguments),
}

impl Cli {
    /// Carries out the subcommand.
    ///
    /// # Errors
    /// [`Failure`] when it could not do its work.
    pub fn carry_out(self) -> Result<Verdict, Failure> {
        match self.command {
            Command::Run(arguments) => run::carry_out(&arguments, self.color),
            Command::Check(arguments) => check::carry_out(&arguments, self.color),
            Command::Explain(arguments) => explain::carry_out(&arguments, self.color),
            Command::Plot(arguments) => plot::carry_out(&arguments, self.color),
            Command::Rules(arguments) => rules::carry_out(&arguments),
            Command::Conform(arguments) => conform::carry_out(&arguments, self.color),
            Command::Answer(arguments) => answer::carry_out(&arguments),
            Command::Fuzz(arguments) => fuzz::carry_out(&arguments),
            Command::Audit(arguments) => audit::carry_out(&arguments),
            Command::Completions(arguments) => completions::carry_out(&arguments),
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        super::Cli::command().debug_assert();
    }
}

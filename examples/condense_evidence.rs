//! Condenses what other tools measured into the files of `evidence/`, which `turnspec audit` reads. The
//! scripts in `scripts/` call it; the result goes to standard output.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use serde::Serialize;
use turnspec::audit::evidence::State;
use turnspec::audit::{Fault, Tree, coverage, mutants, packages};

/// Condenses what other tools measured.
#[derive(Parser)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// The present state of the sources on which the evidence depends; to be taken before measuring.
    State {
        /// Which evidence.
        #[arg(value_parser = ["coverage", "mutants"])]
        of: String,
    },
    /// A report of `cargo llvm-cov --json`.
    Coverage {
        /// The report.
        report: PathBuf,
        /// The state that was taken before.
        #[arg(long)]
        state: PathBuf,
        /// Name and version of a tool that took part.
        #[arg(long)]
        tool: Vec<String>,
    },
    /// The sources of which not every mutant has been tried in their present state.
    Untried,
    /// The `outcomes.json` of one run of cargo-mutants, or of its shards, added to what is kept.
    Mutants {
        /// The files.
        #[arg(required = true)]
        outcomes: Vec<PathBuf>,
        /// The state that was taken before.
        #[arg(long)]
        state: PathBuf,
        /// What `cargo mutants --list --json` says of each package.
        #[arg(long)]
        list: Vec<PathBuf>,
    },
    /// The output of `cargo metadata --format-version 1`.
    Licences {
        /// The output.
        metadata: PathBuf,
    },
}

fn main() -> ExitCode {
    match condense(&Cli::parse().command) {
        Ok(text) => {
            println!("{text}");
            ExitCode::SUCCESS
        }
        Err(fault) => {
            eprintln!("condense_evidence: {fault}");
            ExitCode::from(2)
        }
    }
}

fn condense(command: &Command) -> Result<String, Fault> {
    match command {
        Command::State { of } => json(&present(of)?),
        Command::Coverage { report, state, tool } => {
            let state = unchanged(state)?;
            json(&coverage::condense(&read(report)?, &tree()?.root, state, tool.clone())?)
        }
        Command::Untried => {
            let tree = tree()?;
            let untried = match mutants::kept(&tree)? {
                Some(run) => run.unfinished(&tree)?,
                None => mutants::sources(&tree)?,
            };
            Ok(untried.join("\n"))
        }
        Command::Mutants { outcomes, state, list } => {
            let texts = outcomes.iter().map(|file| read(file)).collect::<Result<Vec<_>, _>>()?;
            let lists = list.iter().map(|file| read(file)).collect::<Result<Vec<_>, _>>()?;
            let run = mutants::condense(mutants::kept(&tree()?)?, &texts, &lists, unchanged(state)?)?;
            run.json().map_err(|error| Fault::about("output", error))
        }
        Command::Licences { metadata } => json(&packages::condense_licences(&read(metadata)?)?),
    }
}

fn tree() -> Result<Tree, Fault> {
    let here = std::env::current_dir().map_err(|error| Fault::about("current folder", error))?;
    Tree::open(&Tree::around(&here)?, Path::new("audit"))
}

fn present(evidence: &str) -> Result<State, Fault> {
    let tree = tree()?;
    if evidence == "coverage" {
        State::of(&tree, &coverage::DEPENDS_ON)
    } else {
        State::of(&tree, &mutants::sources(&tree)?)
    }
}

/// The state in a file, if the sources still have it.
fn unchanged(file: &Path) -> Result<State, Fault> {
    let state: State =
        serde_json::from_str(&read(file)?).map_err(|error| Fault::about(file.display(), error))?;
    match state.freshness(&tree()?).remark() {
        None => Ok(state),
        Some(remark) => Err(Fault::about(file.display(), remark)),
    }
}

fn read(file: &Path) -> Result<String, Fault> {
    std::fs::read_to_string(file).map_err(|error| Fault::about(file.display(), error))
}

fn json(value: &impl Serialize) -> Result<String, Fault> {
    serde_json::to_string_pretty(value).map_err(|error| Fault::about("output", error))
}

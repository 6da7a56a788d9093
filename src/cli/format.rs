//! How the findings of a subcommand are printed.

/// For people, or for machines.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    Text,
    Json,
}

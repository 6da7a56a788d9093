//! What is mutated, and by which tests it is judged.

use clap::ValueEnum;

/// A package with mutants.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Package {
    /// The oracle.
    TurnspecOracle,
    /// The engine: its arithmetic.
    Turnspec,
}

/// How it is built and tested.
pub struct Subject {
    /// Its root module, which gets the switch.
    pub root: &'static str,
    /// What cargo is to check.
    pub check: &'static [&'static str],
    /// What cargo is to test.
    pub tests: &'static [&'static str],
}

const ORACLE: Subject = Subject {
    root: "spec/src/lib.rs",
    check: &["--package", "turnspec-oracle"],
    tests: &["--package", "turnspec-oracle", "--lib", "--tests"],
};

/// The theorems about the arithmetic are tests of it too.
const ENGINE: Subject = Subject {
    root: "src/lib.rs",
    check: &["--package", "turnspec", "--lib", "--no-default-features"],
    tests: &[
        "--package",
        "turnspec",
        "--package",
        "turnspec-proofs",
        "--no-default-features",
        "--lib",
        "--test",
        "rules",
        "--test",
        "differential",
        "--test",
        "tables",
    ],
};

impl Package {
    /// How it is built and tested.
    #[must_use]
    pub fn subject(self) -> &'static Subject {
        match self {
            Self::TurnspecOracle => &ORACLE,
            Self::Turnspec => &ENGINE,
        }
    }
}

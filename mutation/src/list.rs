//! The list of mutants, as `cargo mutants --list --json` writes it.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::fault::Fault;

/// A change of one place of a source.
#[derive(Clone, Debug, Deserialize)]
pub struct Mutant {
    /// File, line, column, change, function.
    pub name: String,
    /// The file, from the root of the workspace.
    pub file: String,
    /// What is changed.
    pub genre: Genre,
    /// What stands there instead.
    pub replacement: String,
    /// The place that is replaced.
    pub span: Span,
    /// The function that it stands in.
    pub function: Option<Function>,
}

/// What a mutant changes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Deserialize)]
pub enum Genre {
    /// The body of a function: another value comes at once.
    FnValue,
    /// The operator of an expression with two operands.
    BinaryOperator,
    /// An operator in front of an expression is left out.
    UnaryOperator,
    /// An arm of a `match` is left out.
    MatchArm,
    /// The guard of an arm is always or never met.
    MatchArmGuard,
    /// A field of a structure keeps the value of the base.
    StructField,
}

/// Where something begins and ends.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct Span {
    /// Its first character.
    pub start: Place,
}

/// Line and column, both from 1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Deserialize)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

/// The function around a mutant.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Function {
    /// Its name, with its type.
    pub function_name: String,
}

/// The mutants of the list in the file.
///
/// # Errors
/// When it cannot be read, or is no such list.
pub fn read(file: &Path) -> Result<Vec<Mutant>, Fault> {
    let text = std::fs::read_to_string(file).map_err(|error| Fault::about(file.display(), error))?;
    serde_json::from_str(&text).map_err(|error| Fault::about(file.display(), error))
}

/// The numbers of the mutants (their places in the list) by file, and by where they begin.
#[must_use]
pub fn by_file(list: &[Mutant]) -> BTreeMap<&str, BTreeMap<Place, Vec<usize>>> {
    let mut files: BTreeMap<&str, BTreeMap<Place, Vec<usize>>> = BTreeMap::new();
    for (number, mutant) in list.iter().enumerate() {
        files.entry(&mutant.file).or_default().entry(mutant.span.start).or_default().push(number);
    }
    files
}

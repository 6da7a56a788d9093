//! The audit bundle: for every rule its text, its functions, its examples, cases, properties, proofs and
//! mutants, in one folder that anyone can make again from the same commit, byte for byte.
//!
//! The audit runs every example and every conformance case on both implementations. What takes longer is
//! measured by scripts and kept in `evidence/`, with the digests of the sources that it speaks of; when they
//! have changed since, the bundle says so. Nothing is fetched, and no clock is read.

mod bundle;
mod citations;
pub mod coverage;
mod csv;
mod digest;
pub mod evidence;
mod fault;
mod files;
mod gather;
mod matrix;
mod measure;
pub mod mutants;
pub mod packages;
mod page;
pub mod planted;
mod sbom;
mod source;
mod statements;
mod summary;
mod tools;
mod tree;

use std::path::Path;

use serde::Serialize;

pub use fault::Fault;
pub use summary::{Finding, Verdict};
pub use tree::{Revision, Tree};

use bundle::Files;
use gather::Gathered;
use matrix::Matrix;

/// Writes the audit bundle of a source tree into a folder, and returns its findings.
///
/// # Errors
/// When the folder holds something else or is the current one, the tree is none or broken, or the program was built
/// from another one; then nothing is written.
pub fn write(root: &Path, out: &Path) -> Result<Vec<Finding>, Fault> {
    let out = &bundle::place(out)?;
    bundle::may_be_written(out)?;
    let tree = Tree::open(root, out)?;
    digest::built_from(root)?;
    let gathered = Gathered::from(&tree)?;
    let matrix = Matrix::of(&tree, &gathered);
    bundle::write(out, &files(&tree, &gathered, &matrix)?)?;
    Ok(matrix.findings)
}

fn files(tree: &Tree, gathered: &Gathered, matrix: &Matrix) -> Result<Files, Fault> {
    let tools = tools::tools(tree, gathered)?;
    let schema = matrix::schema().map_err(|error| Fault::about("matrix.schema.json", error))?;
    Ok(Files::from([
        ("index.html", page::page(tree, gathered, matrix, &tools)),
        ("matrix.csv", csv::table(matrix)),
        ("matrix.json", json("matrix.json", matrix)?),
        ("matrix.schema.json", schema + "\n"),
        ("sbom.cdx.json", json("sbom.cdx.json", &sbom::bill(&gathered.packages))?),
        ("tools.json", json("tools.json", &tools)?),
        (bundle::SOURCES, bundle::sources(tree)?),
    ]))
}

fn json(name: &str, value: &impl Serialize) -> Result<String, Fault> {
    let text = serde_json::to_string_pretty(value).map_err(|error| Fault::about(name, error))?;
    Ok(text + "\n")
}

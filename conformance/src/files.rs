//! Finds and reads the case files beside this crate.

use std::fs;
use std::path::{Path, PathBuf};

use crate::Case;

/// Every case, in the order of the ids.
///
/// # Errors
/// Names the file that cannot be read, is no case, or bears another name than its id.
pub fn cases() -> Result<Vec<Case>, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let mut cases = Vec::new();
    for control in entries(&root)? {
        for file in entries(&control)? {
            cases.push(read(&root, &file)?);
        }
    }
    Ok(cases)
}

/// The entries of a directory, sorted.
fn entries(directory: &Path) -> Result<Vec<PathBuf>, String> {
    let list = fs::read_dir(directory).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let list = list.map_err(|error| format!("{}: {error}", directory.display()))?;
    let mut paths: Vec<PathBuf> = list.into_iter().map(|entry| entry.path()).collect();
    paths.sort();
    Ok(paths)
}

fn read(root: &Path, file: &Path) -> Result<Case, String> {
    let fault = |error: &dyn std::fmt::Display| format!("{}: {error}", file.display());
    let text = fs::read_to_string(file).map_err(|error| fault(&error))?;
    let case: Case = serde_json::from_str(&text).map_err(|error| fault(&error))?;
    if root.join(&case.id).with_extension("json") != file {
        return Err(fault(&format!("the id {:?} is not the name of the file", case.id)));
    }
    Ok(case)
}

//! Regressions: `NAME.min`, the program byte by byte, and beside it `NAME.setup.toml`, the set-up.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use turnspec_generator::Case;
use turnspec_oracle::vocabulary::Setup;

/// The folder of the regressions.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/regressions")
}

/// Every regression with its name, in the order of the names.
///
/// # Errors
/// When a file cannot be read or a set-up is not valid; the message names the file.
pub fn all() -> Result<Vec<(String, Case)>, String> {
    let entries = fs::read_dir(folder()).map_err(|error| format!("{}: {error}", folder().display()))?;
    let mut programs = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| error.to_string())?.path();
        if path.extension().is_some_and(|extension| extension == "min") {
            programs.push(path);
        }
    }
    programs.sort();
    programs.iter().map(|path| read(path)).collect()
}

fn read(path: &Path) -> Result<(String, Case), String> {
    let fault = |path: &Path, message: String| format!("{}: {message}", path.display());
    let program = fs::read(path).map_err(|error| fault(path, error.to_string()))?;
    let beside = path.with_extension("setup.toml");
    let text = fs::read_to_string(&beside).map_err(|error| fault(&beside, error.to_string()))?;
    let setup = Setup::from_toml(&text).map_err(|error| fault(&beside, error.to_string()))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Ok((name, Case { setup, program }))
}

/// The text of a set-up file: what differs from the default set-up.
///
/// # Errors
/// When the set-up cannot be written as TOML.
pub fn setup_text(setup: &Setup) -> Result<String, String> {
    let table = |setup: &Setup| toml::Table::try_from(setup).map_err(|error| error.to_string());
    let plain = table(&Setup::default())?;
    let unusual = unlike(table(setup)?, &plain);
    toml::to_string(&unusual).map_err(|error| error.to_string())
}

/// The entries of a table that are not the same in another one.
fn unlike(table: toml::Table, plain: &toml::Table) -> toml::Table {
    let mut rest = toml::Table::new();
    for (key, value) in table {
        match (value, plain.get(&key)) {
            (value, Some(usual)) if value == *usual => {}
            (toml::Value::Table(inner), Some(toml::Value::Table(usual))) => {
                rest.insert(key, toml::Value::Table(unlike(inner, usual)));
            }
            (value, _) => drop(rest.insert(key, value)),
        }
    }
    rest
}

/// Writes a regression; the path of its program.
///
/// # Errors
/// When a file cannot be written.
pub fn write(name: &str, case: &Case, note: &str) -> io::Result<PathBuf> {
    let path = folder().join(format!("{name}.min"));
    let remark: String = note.lines().map(|line| format!("# {line}\n")).collect();
    let setup = setup_text(&case.setup).map_err(io::Error::other)?;
    fs::create_dir_all(folder())?;
    fs::write(&path, &case.program)?;
    fs::write(path.with_extension("setup.toml"), remark + &setup)?;
    Ok(path)
}

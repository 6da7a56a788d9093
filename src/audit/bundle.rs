//! The folder of the bundle: whether it may be written, its files, its manifests, and that it appears whole
//! or not at all.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::{Fault, Tree, digest};

/// The manifest of the bundle, by which a former bundle is known.
const MANIFEST: &str = "MANIFEST.sha256";
/// The manifest of the sources.
pub const SOURCES: &str = "SOURCES.sha256";

/// The files of a bundle by their names.
pub type Files = BTreeMap<&'static str, String>;

/// Refuses a place where something else than a former bundle stands.
///
/// # Errors
/// Names the place.
pub fn may_be_written(out: &Path) -> Result<(), Fault> {
    if !out.exists() || is_bundle(out) {
        return Ok(());
    }
    let empty = fs::read_dir(out).map(|mut entries| entries.next().is_none());
    match empty {
        Ok(true) => Ok(()),
        Ok(false) => Err(Fault::about(out.display(), "not empty and no former bundle; nothing was written")),
        Err(error) => Err(Fault::about(out.display(), error)),
    }
}

/// Whether a folder holds a bundle and nothing else: the files of its manifest and the manifest.
fn is_bundle(folder: &Path) -> bool {
    let Ok(manifest) = fs::read_to_string(folder.join(MANIFEST)) else { return false };
    let Ok(entries) = fs::read_dir(folder) else { return false };
    let listed: Vec<&str> =
        manifest.lines().filter_map(|line| line.split_once("  ")).map(|(_, name)| name).collect();
    entries.flatten().all(|entry| {
        let name = entry.file_name();
        entry.path().is_file() && (name == MANIFEST || listed.iter().any(|listed| name == *listed))
    })
}

/// Writes the files and their manifest beside the place, then puts them there in one step.
///
/// # Errors
/// Names the file or folder that cannot be written; the place is left as it was.
pub fn write(out: &Path, files: &Files) -> Result<(), Fault> {
    let fresh = sibling(out, "new");
    let written = write_into(&fresh, files).and_then(|()| replace(&fresh, out));
    if written.is_err() {
        let _ = fs::remove_dir_all(&fresh);
    }
    written
}

fn write_into(folder: &Path, files: &Files) -> Result<(), Fault> {
    let at = |path: &Path| {
        let path = path.to_owned();
        move |error: std::io::Error| Fault::about(path.display(), error)
    };
    fs::create_dir_all(folder).map_err(at(folder))?;
    let mut manifest = String::new();
    for (name, text) in files {
        let path = folder.join(name);
        fs::write(&path, text).map_err(at(&path))?;
        manifest += &format!("{}  {name}\n", digest::sha256(text.as_bytes()));
    }
    let path = folder.join(MANIFEST);
    fs::write(&path, manifest).map_err(at(&path))
}

/// Puts a folder in the place of another, which may be missing, empty or a former bundle.
fn replace(fresh: &Path, out: &Path) -> Result<(), Fault> {
    let fault = |error| Fault::about(out.display(), error);
    let former = sibling(out, "old");
    let there = out.exists();
    if there {
        fs::rename(out, &former).map_err(fault)?;
    }
    if let Err(error) = fs::rename(fresh, out) {
        if there {
            fs::rename(&former, out).map_err(fault)?;
        }
        return Err(fault(error));
    }
    if there { fs::remove_dir_all(&former).map_err(fault) } else { Ok(()) }
}

/// A name beside the place that nobody else uses.
fn sibling(out: &Path, suffix: &str) -> PathBuf {
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    out.with_file_name(format!(".{name}.{suffix}-{}", std::process::id()))
}

/// The manifest of the files of the tree: `cd TREE && sha256sum -c SOURCES.sha256`.
///
/// # Errors
/// Names the file that cannot be read.
pub fn sources(tree: &Tree) -> Result<String, Fault> {
    let line = |file: &String| {
        let bytes = fs::read(tree.root.join(file)).map_err(|error| Fault::about(file, error))?;
        Ok(format!("{}  {file}\n", digest::sha256(&bytes)))
    };
    tree.files.iter().map(line).collect()
}

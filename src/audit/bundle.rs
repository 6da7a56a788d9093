//! The folder of the bundle: whether it may be written, its files, its manifests, and that it appears whole
//! or not at all.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::{Fault, Tree, digest};

/// The manifest of the bundle, by which a former bundle is known.
const MANIFEST: &str = "MANIFEST.sha256";
/// The manifest of the sources.
pub const SOURCES: &str = "SOURCES.sha256";
/// Every file of a bundle but its manifest.
pub const NAMES: [&str; 7] = [
    "SOURCES.sha256",
    "index.html",
    "matrix.csv",
    "matrix.json",
    "matrix.schema.json",
    "sbom.cdx.json",
    "tools.json",
];

/// The files of a bundle by their names.
pub type Files = BTreeMap<&'static str, String>;

/// The folder that is meant: that of a link where there is one, and never the current one.
///
/// # Errors
/// Names the place where no folder can stand.
pub fn place(out: &Path) -> Result<PathBuf, Fault> {
    let fault = |reason: &str| Err(Fault::about(out.display(), reason));
    match out.canonicalize() {
        Ok(place) if is_current(&place) => {
            fault("the current folder, which cannot be replaced; name another one, or one in it")
        }
        Ok(place) => Ok(place),
        Err(_) if out.is_symlink() => fault("a link that leads nowhere"),
        Err(_) if out.ancestors().skip(1).any(is_no_folder) => {
            fault("it would lie in something that is no folder")
        }
        Err(_) if out.file_name().is_none() => fault("no name for a folder"),
        Err(_) => Ok(out.to_owned()),
    }
}

/// Whether it is the current folder: who stands in it would find nothing there afterwards.
fn is_current(place: &Path) -> bool {
    let here = std::env::current_dir().and_then(|here| here.canonicalize());
    here.is_ok_and(|here| here == place)
}

/// Whether something else than a folder is there.
fn is_no_folder(place: &Path) -> bool {
    place.symlink_metadata().is_ok() && !place.is_dir()
}

/// Refuses a place where something else than a former bundle stands.
///
/// # Errors
/// Names the place.
pub fn may_be_written(out: &Path) -> Result<(), Fault> {
    if !out.exists() {
        return Ok(());
    }
    let fault = |error: io::Error| Fault::about(out.display(), error);
    let entries = fs::read_dir(out).and_then(Iterator::collect::<io::Result<Vec<_>>>).map_err(fault)?;
    if entries.is_empty() {
        return Ok(());
    }
    if !entries.iter().all(is_named_like_ours) {
        return Err(Fault::about(out.display(), "not empty and no former bundle; nothing was written"));
    }
    if is_whole(out).map_err(fault)? {
        return Ok(());
    }
    let reason =
        "no former bundle as it was written: its files are not those of its manifest; nothing was written";
    Err(Fault::about(out.display(), reason))
}

/// Whether a file could be one of a bundle by its name.
fn is_named_like_ours(entry: &fs::DirEntry) -> bool {
    let name = entry.file_name();
    let known = NAMES.iter().chain([&MANIFEST]).any(|known| name == *known);
    known && entry.file_type().is_ok_and(|kind| kind.is_file())
}

/// Whether a folder has every file of a bundle as its manifest says.
fn is_whole(folder: &Path) -> io::Result<bool> {
    if !NAMES.iter().chain([&MANIFEST]).all(|name| folder.join(name).is_file()) {
        return Ok(false);
    }
    let mut manifest = String::new();
    for name in NAMES {
        manifest += &line(name, &fs::read(folder.join(name))?);
    }
    Ok(fs::read(folder.join(MANIFEST))? == manifest.as_bytes())
}

/// The line of a file in a manifest, as `sha256sum` writes it.
fn line(name: &str, bytes: &[u8]) -> String {
    format!("{}  {name}\n", digest::sha256(bytes))
}

/// Writes the files and their manifest beside the place, then puts them there in one step.
///
/// # Errors
/// Names the file or folder that cannot be written, or that has changed meanwhile; the place is left as it was.
pub fn write(out: &Path, files: &Files) -> Result<(), Fault> {
    let fresh = sibling(out, "new");
    let written =
        write_into(&fresh, files).and_then(|()| may_be_written(out)).and_then(|()| replace(&fresh, out));
    if written.is_err() {
        let _ = fs::remove_dir_all(&fresh);
    }
    written
}

fn write_into(folder: &Path, files: &Files) -> Result<(), Fault> {
    let at = |path: &Path| {
        let path = path.to_owned();
        move |error: io::Error| Fault::about(path.display(), error)
    };
    fs::create_dir_all(folder).map_err(at(folder))?;
    let mut manifest = String::new();
    for (name, text) in files {
        let path = folder.join(name);
        fs::write(&path, text).map_err(at(&path))?;
        manifest += &line(name, text.as_bytes());
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
        Ok(line(file, &bytes))
    };
    tree.files.iter().map(line).collect()
}

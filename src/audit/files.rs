//! The files of a folder, and the order they are listed in: shared with the build script.

use std::io;
use std::path::Path;

/// The folders whose state decides what the program does; the build notes their digests.
pub const SOURCES: [&str; 4] = ["conformance/src", "spec/rules", "spec/src", "src"];

/// The files below a folder of the tree, relative to the tree, separated by `/`, in the order of their bytes.
///
/// # Errors
/// When a folder cannot be read.
pub fn below(root: &Path, folder: &str) -> io::Result<Vec<String>> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(root.join(&folder))? {
            let entry = entry?;
            let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.file_type()?.is_dir() {
                folders.push(path);
            } else {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// What is hashed for a folder: a line `<SHA-256>  <path>` a file, as `sha256sum` writes it.
///
/// # Errors
/// When a folder or file cannot be read.
pub fn listing(root: &Path, folder: &str, sha256: impl Fn(&[u8]) -> String) -> io::Result<String> {
    let mut listing = String::new();
    for file in below(root, folder)? {
        listing += &format!("{}  {file}\n", sha256(&std::fs::read(root.join(&file))?));
    }
    Ok(listing)
}

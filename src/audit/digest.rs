//! SHA-256 of bytes and of folders, and whether the program was built from the tree that it speaks of.

use std::io;
use std::path::Path;

use sha2::{Digest, Sha256};

use super::Fault;
use super::files::{SOURCES, listing};

/// The digests of [`SOURCES`] that the build noted.
const BUILT_FROM: &str = env!("TURNSPEC_SOURCES");

/// SHA-256 in hexadecimal digits.
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The state of a folder of the tree: `find FOLDER -type f | LC_ALL=C sort | xargs sha256sum | sha256sum`.
///
/// # Errors
/// When a folder or file cannot be read.
pub fn of_folder(root: &Path, folder: &str) -> io::Result<String> {
    Ok(sha256(listing(root, folder, sha256)?.as_bytes()))
}

/// The state of a folder, as [`of_folder`] has it, or of a file: `sha256sum FILE`.
///
/// # Errors
/// When a folder or file cannot be read.
pub fn of_path(root: &Path, path: &str) -> io::Result<String> {
    let full = root.join(path);
    if full.is_dir() { of_folder(root, path) } else { Ok(sha256(&std::fs::read(full)?)) }
}

/// Refuses a tree whose sources are not those that this program was built from: what it measured would be
/// said of another text.
///
/// # Errors
/// Names the first folder that differs.
pub fn built_from(root: &Path) -> Result<(), Fault> {
    for folder in SOURCES {
        let actual = of_folder(root, folder).map_err(|error| Fault::about(folder, error))?;
        if !BUILT_FROM.split(' ').any(|built| built == format!("{folder}={actual}")) {
            return Err(Fault::about(
                root.join(folder).display(),
                "not the sources that this program was built from; run `cargo run --release -- audit` there",
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::sha256;

    #[test]
    fn the_digest_is_that_of_the_standard() {
        // FIPS 180-2, appendix B.1.
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), expected);
    }
}

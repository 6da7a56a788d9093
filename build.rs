//! Notes the state of the sources that the program is built from: the digest of each folder of `SOURCES`, as
//! `turnspec audit` computes it again for the tree that it is asked about.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "cli")]
    digests::note();
}

#[cfg(feature = "cli")]
#[path = "src/audit/files.rs"]
mod files;

#[cfg(feature = "cli")]
mod digests {
    use std::path::Path;

    use sha2::{Digest, Sha256};

    use super::files::{SOURCES, listing};

    /// A package without the rest of the tree has no digests, and cannot be audited.
    pub fn note() {
        let root = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
        let mut digests = Vec::new();
        for folder in SOURCES {
            let path = Path::new(&root).join(folder);
            if path.is_dir() {
                println!("cargo::rerun-if-changed={folder}");
            }
            if let Ok(listing) = listing(Path::new(&root), folder, sha256) {
                digests.push(format!("{folder}={}", sha256(listing.as_bytes())));
            }
        }
        println!("cargo::rustc-env=TURNSPEC_SOURCES={}", digests.join(" "));
    }

    fn sha256(bytes: &[u8]) -> String {
        Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

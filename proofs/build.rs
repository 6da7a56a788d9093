//! Sets `cfg(stand_in)` unless the Kani compiler is at work: only that one brings a crate `kani` along.

use std::env;
use std::path::PathBuf;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(stand_in)");
    println!("cargo::rerun-if-env-changed=RUSTC");
    println!("cargo::rerun-if-changed=build.rs");
    let compiler = env::var_os("RUSTC").map(PathBuf::from).unwrap_or_default();
    let name = compiler.file_name().unwrap_or_default().to_string_lossy();
    if !name.contains("kani") {
        println!("cargo::rustc-cfg=stand_in");
    }
}

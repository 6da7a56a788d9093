//! The engine and the generator know nothing of the oracle but the vocabulary.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Name of the oracle's crate, and of the only module of it that may be named.
const ORACLE: &str = "turnspec_oracle";
const VOCABULARY: &str = "::vocabulary";

#[test]
fn the_engine_imports_the_vocabulary_only() -> io::Result<()> {
    let files = sources(Path::new("src/engine"))?;
    assert!(files.len() > 1, "no sources under src/engine");
    check(&files)
}

#[test]
fn the_generator_imports_the_vocabulary_only() -> io::Result<()> {
    let files = sources(Path::new("fuzz/generator/src"))?;
    assert!(files.len() > 1, "no sources under fuzz/generator/src");
    check(&files)?;
    let manifest = fs::read_to_string(root().join("fuzz/generator/Cargo.toml"))?;
    assert!(!manifest.contains("turnspec ="), "the generator depends on the engine");
    Ok(())
}

#[test]
fn the_oracle_does_not_know_the_engine() -> io::Result<()> {
    for file in sources(Path::new("spec/src"))? {
        let text = fs::read_to_string(&file)?;
        for name in ["turnspec::", "turnspec_generator"] {
            assert!(!code(&text).contains(name), "{} mentions {name}", file.display());
        }
    }
    Ok(())
}

#[test]
fn a_forbidden_mention_is_found() {
    for text in [
        "use turnspec_oracle::Run;",
        "use turnspec_oracle::{vocabulary::Setup, run};",
        "use turnspec_oracle as reference;",
        "let trace = turnspec_oracle :: run(program);",
        "use turnspec_oracle::vocabulary_of_mine::X;",
        "extern crate turnspec_oracle;",
    ] {
        assert!(!forbidden(text).is_empty(), "{text}");
    }
    assert!(forbidden("use turnspec_oracle::vocabulary::{Event, rule_ids::*};").is_empty());
    assert!(forbidden("use turnspec_oracle::vocabulary;\n// turnspec_oracle::Run decides").is_empty());
}

fn check(files: &[PathBuf]) -> io::Result<()> {
    for file in files {
        let found = forbidden(&fs::read_to_string(file)?);
        assert!(found.is_empty(), "{} reaches into the oracle: {found:?}", file.display());
    }
    Ok(())
}

/// The mentions of the oracle that go beyond its vocabulary.
fn forbidden(text: &str) -> Vec<String> {
    let code = code(text);
    let rest = |place: usize| code.get(place + ORACLE.len()..).unwrap_or_default();
    let allowed = |after: &str| {
        let tail = after.strip_prefix(VOCABULARY);
        tail.is_some_and(|tail| !tail.starts_with(|next: char| next.is_alphanumeric() || next == '_'))
    };
    let mentions = code.match_indices(ORACLE).map(|(place, _)| rest(place));
    mentions.filter(|after| !allowed(after)).map(|after| after.chars().take(40).collect()).collect()
}

/// A source text without line comments.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every Rust source below a folder of the repository.
fn sources(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

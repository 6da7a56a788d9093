//! Writes the first inputs of the fuzz targets into `fuzz/corpus/`: for `raw` the programs of the rule
//! examples, the conformance cases and the regressions, on the default set-up; for `structured` streams of
//! bytes from seeds.
//!
//! `cargo run --manifest-path fuzz/Cargo.toml --example seed_corpus`

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use turnspec_generator::{Case, case_from_seed};

/// How many programs of the generator, and how many streams of bytes, are written.
const SEEDS: u64 = 64;
/// Length of a stream in bytes.
const STREAM: usize = 4096;

fn main() -> Result<(), Box<dyn Error>> {
    let fuzz = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (raw, structured) = (fuzz.join("corpus/raw"), fuzz.join("corpus/structured"));
    fs::create_dir_all(&raw)?;
    fs::create_dir_all(&structured)?;
    let mut programs = rule_examples()?;
    programs.extend(conformance_cases(&fuzz.join("../conformance/cases"))?);
    programs.extend(regressions(&fuzz.join("regressions"))?);
    programs.extend((0..SEEDS).map(|seed| (format!("seed-{seed}"), case_from_seed(seed).program)));
    for (name, program) in &programs {
        let mut bytes = vec![0; Case::SETUP_BYTES];
        bytes.extend(program);
        fs::write(raw.join(name), bytes)?;
    }
    for seed in 1..=SEEDS {
        fs::write(structured.join(format!("stream-{seed}")), stream(seed))?;
    }
    println!("{} inputs for raw, {SEEDS} for structured", programs.len());
    Ok(())
}

/// Programs with names.
type Programs = Vec<(String, Vec<u8>)>;

/// The examples of the rule texts.
fn rule_examples() -> Result<Programs, Box<dyn Error>> {
    let mut programs = Programs::new();
    for rule in turnspec_oracle::book::e100l()? {
        for example in rule.examples {
            programs.push((format!("{}-{}", rule.id, example.line), example.program));
        }
    }
    Ok(programs)
}

/// The programs of the conformance cases.
fn conformance_cases(folder: &Path) -> Result<Programs, Box<dyn Error>> {
    let mut programs = Programs::new();
    for path in files(folder, "json")? {
        let case: serde_json::Value = serde_json::from_str(&fs::read_to_string(&path)?)?;
        if let Some(program) = case.get("program").and_then(serde_json::Value::as_str) {
            programs.push((stem(&path), program.as_bytes().to_vec()));
        }
    }
    Ok(programs)
}

fn regressions(folder: &Path) -> Result<Programs, Box<dyn Error>> {
    let read = |path: PathBuf| Ok((stem(&path), fs::read(&path)?));
    files(folder, "min")?.into_iter().map(read).collect()
}

/// The files below a folder with this extension; none when there is no such folder.
fn files(folder: &Path, extension: &str) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        if !folder.is_dir() {
            continue;
        }
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Pseudo-random bytes of a seed (xorshift).
fn stream(seed: u64) -> Vec<u8> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 24) as u8
    };
    (0..STREAM).map(|_| next()).collect()
}

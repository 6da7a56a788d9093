//! Writes the first inputs of the fuzz targets into `fuzz/corpus/`, a folder a target.
//!
//! Targets that read a program as it stands (`raw`, `parse`, `round_trip`, `termination`) begin with the
//! programs of the rule examples, of the conformance cases, of the regressions and of the generator; `setup`
//! with the set-ups of the same cases; `trace` with the traces of the same cases; `expression`
//! with the right sides of their assignments; the others, which read choices of the generator, with streams
//! of bytes, as do all of them besides.
//!
//! `cargo run -p turnspec-properties --example seed_corpus`

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::{Event, Setup};
use turnspec_properties::{PROPERTIES, bytes_of_seed};

/// How many programs of the generator, and how many streams of bytes, are written.
const SEEDS: u64 = 64;
/// Length of a stream in bytes.
const STREAM: usize = 4096;
/// Targets that read a program as it stands, behind the bytes that choose the set-up.
const OF_PROGRAMS: [&str; 4] = ["raw", "parse", "round_trip", "termination"];

fn main() -> Result<(), Box<dyn Error>> {
    let fuzz = &Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut inputs = BTreeMap::<&str, Inputs>::new();
    let texts = texts(fuzz)?;
    for target in OF_PROGRAMS {
        let with_setup = |program: &[u8]| [&[0; Case::SETUP_BYTES], program].concat();
        let programs = texts.iter().map(|text| (text.name.clone(), with_setup(&text.program)));
        inputs.entry(target).or_default().extend(programs);
    }
    inputs.insert("setup", setups(&texts)?);
    inputs.insert("trace", traces(&texts)?);
    inputs.insert("expression", expressions(&texts));
    for property in PROPERTIES {
        let streams = (1..=SEEDS).map(|seed| (format!("stream-{seed}"), bytes_of_seed(seed, STREAM)));
        inputs.entry(property.name).or_default().extend(streams);
    }
    for (target, inputs) in inputs {
        let folder = fuzz.join("corpus").join(target);
        fs::create_dir_all(&folder)?;
        for (name, bytes) in &inputs {
            fs::write(folder.join(name), bytes)?;
        }
        println!("{:>5} inputs for {target}", inputs.len());
    }
    Ok(())
}

/// Inputs with names.
type Inputs = Vec<(String, Vec<u8>)>;

/// A program, and the set-up that it was written for.
struct Text {
    name: String,
    program: Vec<u8>,
    setup: Setup,
}

/// Every program that there is.
fn texts(fuzz: &Path) -> Result<Vec<Text>, Box<dyn Error>> {
    let mut texts = rule_examples()?;
    texts.extend(conformance_cases(&fuzz.join("../conformance/cases"))?);
    texts.extend(regressions(&fuzz.join("regressions"))?);
    texts.extend((0..SEEDS).map(|seed| {
        let Case { setup, program } = case_from_seed(seed);
        Text { name: format!("seed-{seed}"), program, setup }
    }));
    Ok(texts)
}

/// The examples of the rule texts.
fn rule_examples() -> Result<Vec<Text>, Box<dyn Error>> {
    let mut texts = Vec::new();
    for rule in turnspec_oracle::book::e100l()? {
        for example in rule.examples {
            let name = format!("{}-{}", rule.id, example.line);
            let setup = example.setup()?;
            texts.push(Text { name, program: example.program, setup });
        }
    }
    Ok(texts)
}

/// The programs of the conformance cases.
fn conformance_cases(folder: &Path) -> Result<Vec<Text>, Box<dyn Error>> {
    let mut texts = Vec::new();
    for path in files(folder, "json")? {
        let case: serde_json::Value = serde_json::from_str(&fs::read_to_string(&path)?)?;
        let setup = case.get("setup").cloned().map_or(Ok(Setup::default()), serde_json::from_value)?;
        if let Some(program) = case.get("program").and_then(serde_json::Value::as_str) {
            texts.push(Text { name: stem(&path), program: program.as_bytes().to_vec(), setup });
        }
    }
    Ok(texts)
}

fn regressions(folder: &Path) -> Result<Vec<Text>, Box<dyn Error>> {
    let read = |path: PathBuf| -> Result<Text, Box<dyn Error>> {
        let setup = Setup::from_toml(&fs::read_to_string(path.with_extension("setup.toml"))?)?;
        Ok(Text { name: stem(&path), program: fs::read(&path)?, setup })
    };
    files(folder, "min")?.into_iter().map(read).collect()
}

/// Set-ups as text.
fn setups(texts: &[Text]) -> Result<Inputs, Box<dyn Error>> {
    let mut inputs = Inputs::new();
    for text in texts {
        let written = toml::to_string(&text.setup)?.into_bytes();
        if !inputs.iter().any(|(_, known)| *known == written) {
            inputs.push((text.name.clone(), written));
        }
    }
    Ok(inputs)
}

/// Traces as JSON Lines.
fn traces(texts: &[Text]) -> Result<Inputs, Box<dyn Error>> {
    let mut inputs = Inputs::new();
    for text in texts {
        let mut trace = Vec::new();
        turnspec_oracle::run(&text.program, &text.setup, &mut |event: &Event| trace.push(*event));
        let lines: Result<Vec<String>, _> = trace.iter().map(serde_json::to_string).collect();
        inputs.push((text.name.clone(), lines?.join("\n").into_bytes()));
    }
    Ok(inputs)
}

/// The right sides of assignments and of words with an equal sign.
fn expressions(texts: &[Text]) -> Inputs {
    let mut inputs = Inputs::new();
    for text in texts {
        for (line, block) in text.program.split(|byte| *byte == b'\n').enumerate() {
            if let Some(sign) = block.iter().position(|byte| *byte == b'=') {
                inputs.push((format!("{}-line-{line}", text.name), block[sign + 1..].to_vec()));
            }
        }
    }
    inputs
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

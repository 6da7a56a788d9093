//! The corpus: files of cases, an index that says which files belong to it, and how they are read.
//!
//! A folder with an `index.json` is read as the index says, so that one that was copied or written in part is
//! noticed. In any other folder every file must be a file of cases.

use std::collections::BTreeMap;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use serde::de::{DeserializeOwned, IgnoredAny};
use serde::{Deserialize, Serialize};

use crate::{Case, Exercise};

/// Version of the files of cases and of their schemas. A change that old files or old readers do not survive
/// raises the first number (before 1.0 the second), an addition the second, a better description the third.
pub const FORMAT: &str = "0.2.0";
/// Name of the index of a folder.
pub const INDEX: &str = "index.json";
/// How deep folders lie in each other at most.
const DEPTH: usize = 8;

/// A file of cases.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CorpusFile {
    /// Version of the format.
    pub format: String,
    /// The cases.
    pub cases: Vec<Case>,
}

/// The index of a folder.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CorpusIndex {
    /// Version of the format.
    pub format: String,
    /// The files.
    pub files: Vec<IndexEntry>,
}

/// One file of an index.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct IndexEntry {
    /// Its path from the index, with `/`.
    pub path: String,
    /// How many cases it has.
    pub cases: usize,
}

/// Why a corpus cannot be read: which file, and why.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CorpusError {
    place: String,
    reason: String,
}

impl CorpusError {
    fn new(place: impl fmt::Display, reason: impl fmt::Display) -> Self {
        Self { place: place.to_string(), reason: reason.to_string() }
    }
}

impl fmt::Display for CorpusError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.reason)
    }
}

impl std::error::Error for CorpusError {}

macro_rules! embedded {
    ($($path:literal)*) => {
        /// The files of the corpus in this program: path and text.
        const EMBEDDED: &[(&str, &str)] = &[$(($path, include_str!(concat!("../corpus/", $path)))),*];
    };
}

embedded! {
    "e100l/manual.json"
    "e100l/programs.json"
    "e100l/blocks.json"
    "e100l/expressions.json"
    "e100l/functions.json"
    "e100l/variables.json"
    "e100l/control-statements.json"
    "e100l/local-variables.json"
    "e100l/coordinates.json"
    "e100l/motion.json"
    "e100l/arcs.json"
    "e100l/chamfers.json"
    "e100l/angles.json"
    "e100l/compensation.json"
    "e100l/compensation-waiting.json"
    "e100l/compensation-entry.json"
    "e100l/compensation-corners.json"
    "e100l/compensation-arcs.json"
    "e100l/cutter-compensation.json"
    "e100l/torque.json"
    "e100l/threads.json"
    "e100l/threads-continuous.json"
    "e100l/thread-common.json"
    "e100l/thread-cycles.json"
    "e100l/thread-infeed.json"
    "e100l/grooving.json"
    "e100l/tapping.json"
    "e100l/driven-cycles.json"
    "e100l/driven-return.json"
    "e100l/driven-drilling.json"
    "e100l/synchronised-tapping.json"
    "e100l/driven-threads.json"
    "e100l/key-ways.json"
    "e100l/contour-generation.json"
    "e100l/contour-centre.json"
    "e100l/contour-side.json"
    "e100l/coordinate-conversion.json"
    "e100l/lap-contours.json"
    "e100l/lap-common.json"
    "e100l/lap-calls.json"
    "e100l/lap-bar-turning.json"
    "e100l/lap-copying.json"
    "e100l/lap-high-speed.json"
    "e100l/lap-bar-copying.json"
    "e100l/preparatory.json"
    "e100l/spindle.json"
    "e100l/tools.json"
    "e100l/miscellaneous.json"
    "e100l/c-axis.json"
    "e100l/barriers.json"
    "e100l/subprograms.json"
    "e100l/modal-calls.json"
    "e100l/macros.json"
    "e100l/communication.json"
    "e100l/communication-put.json"
    "e100l/io-variables.json"
    "e100l/user-alarms.json"
    "e100l/schedules.json"
    "e100l/schedules-select.json"
    "e100l/two-turrets.json"
    "e100l/two-saddles.json"
    "e100l/synchronisation.json"
    "e100l/acceleration.json"
}

/// The paths of the files of the corpus in this program.
pub fn embedded_paths() -> impl Iterator<Item = &'static str> {
    EMBEDDED.iter().map(|(path, _)| *path)
}

/// The corpus in this program.
///
/// # Errors
/// When a file of it is malformed.
pub fn embedded() -> Result<Vec<Exercise>, CorpusError> {
    let mut files = Vec::new();
    for (path, text) in EMBEDDED {
        files.push(((*path).to_owned(), cases_of(path, text)?));
    }
    distinct(files)
}

/// The corpus in a file or a folder.
///
/// # Errors
/// The first file that is missing, surplus, cut off, of another format or malformed, with the place.
pub fn read(path: &Path) -> Result<Vec<Exercise>, CorpusError> {
    let files = if !path.is_dir() {
        vec![(path.to_owned(), None)]
    } else if path.join(INDEX).exists() {
        indexed(path)?
    } else {
        files_below(path, 0)?.into_iter().map(|file| (file, None)).collect()
    };
    let mut exercises = Vec::new();
    for (file, count) in files {
        let place = file.display().to_string();
        let found = cases_of(&place, &text_of(&file)?)?;
        if let Some(count) = count.filter(|count| *count != found.len()) {
            let reason = format!("{} cases, but the index says {count}", found.len());
            return Err(CorpusError::new(file.display(), reason));
        }
        exercises.push((place, found));
    }
    if exercises.iter().all(|(_, found)| found.is_empty()) {
        return Err(CorpusError::new(path.display(), "no cases"));
    }
    distinct(exercises)
}

/// The files that an index names; there must be no other.
fn indexed(folder: &Path) -> Result<Vec<(PathBuf, Option<usize>)>, CorpusError> {
    let path = folder.join(INDEX);
    let place = path.display().to_string();
    let text = text_of(&path)?;
    check_object(&place, &text, "an index: a JSON object with `format` and `files`")?;
    check_format(&place, parse::<Head>(&place, &text)?.format.as_deref())?;
    let index: CorpusIndex = parse(&place, &text)?;
    let named: Vec<(PathBuf, Option<usize>)> =
        index.files.iter().map(|entry| (folder.join(&entry.path), Some(entry.cases))).collect();
    if let Some((missing, _)) = named.iter().find(|(file, _)| !file.is_file()) {
        return Err(CorpusError::new(missing.display(), "missing, though the index names it"));
    }
    let there = files_below(folder, 0)?;
    let known = |file: &PathBuf| *file == path || named.iter().any(|(named, _)| named == file);
    match there.iter().find(|file| !known(file)) {
        Some(surplus) => Err(CorpusError::new(surplus.display(), "not in the index of the corpus")),
        None => Ok(named),
    }
}

/// The files of a folder and of the folders in it, sorted.
fn files_below(folder: &Path, depth: usize) -> Result<Vec<PathBuf>, CorpusError> {
    if depth > DEPTH {
        return Err(CorpusError::new(folder.display(), "folders lie too deep in each other"));
    }
    let list = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let list = list.map_err(|error| CorpusError::new(folder.display(), error))?;
    let mut paths: Vec<PathBuf> = list.into_iter().map(|entry| entry.path()).collect();
    paths.sort();
    let mut files = Vec::new();
    for path in paths {
        if path.is_dir() {
            files.append(&mut files_below(&path, depth + 1)?);
        } else if path.extension().is_some_and(|extension| extension == "json") {
            files.push(path);
        } else {
            return Err(CorpusError::new(path.display(), "no file of cases: it does not end in .json"));
        }
    }
    Ok(files)
}

fn text_of(path: &Path) -> Result<String, CorpusError> {
    fs::read_to_string(path).map_err(|error| CorpusError::new(path.display(), error))
}

/// What tells the two forms of a file apart.
#[derive(Deserialize)]
struct Head {
    format: Option<String>,
    cases: Option<IgnoredAny>,
}

/// The cases of a file: many with a format, or a single one.
fn cases_of(place: &str, text: &str) -> Result<Vec<Exercise>, CorpusError> {
    check_object(place, text, "a case, or a JSON object with `format` and `cases`")?;
    let head: Head = parse(place, text)?;
    let cases = if head.format.is_none() && head.cases.is_none() {
        vec![parse::<Case>(place, text)?]
    } else {
        check_format(place, head.format.as_deref())?;
        parse::<CorpusFile>(place, text)?.cases
    };
    let ready = |case: Case| {
        let id = case.id.clone();
        Exercise::new(case).map_err(|reason| CorpusError::new(place, format!("case {id}: {reason}")))
    };
    cases.into_iter().map(ready).collect()
}

/// Whether a text begins as an object does; an empty one is left to the parser.
fn check_object(place: &str, text: &str, expected: &str) -> Result<(), CorpusError> {
    match text.trim_start().chars().next() {
        None | Some('{') => Ok(()),
        Some(_) => Err(CorpusError::new(place, format!("this is not {expected}"))),
    }
}

fn parse<T: DeserializeOwned>(place: &str, text: &str) -> Result<T, CorpusError> {
    serde_json::from_str(text).map_err(|error| {
        let place = format!("{place}:{}:{}", error.line(), error.column());
        let cut_off = if error.is_eof() { ", the file is cut off" } else { "" };
        CorpusError::new(place, format!("{error}{cut_off}"))
    })
}

/// Before 1.0, files of one second number are read.
fn check_format(place: &str, format: Option<&str>) -> Result<(), CorpusError> {
    let fault = |reason: &str| Err(CorpusError::new(place, reason));
    let Some(format) = format else { return fault("no `format`") };
    let Some(version) = version(format) else { return fault(&format!("format {format:?} is no version")) };
    match version.cmp(&version_read()) {
        std::cmp::Ordering::Equal => Ok(()),
        std::cmp::Ordering::Less => fault(&format!("format {format} is no longer read, only {FORMAT}")),
        std::cmp::Ordering::Greater => {
            fault(&format!("format {format} is newer than {FORMAT}, which is read"))
        }
    }
}

fn version_read() -> (u64, u64) {
    version(FORMAT).unwrap_or_default()
}

/// The first two of three numbers.
fn version(text: &str) -> Option<(u64, u64)> {
    let numbers: Vec<u64> = text.split('.').map(|each| each.parse().ok()).collect::<Option<_>>()?;
    match numbers.as_slice() {
        [first, second, _] => Some((*first, *second)),
        _ => None,
    }
}

/// The cases of some files, each of which has an id of its own.
fn distinct(files: Vec<(String, Vec<Exercise>)>) -> Result<Vec<Exercise>, CorpusError> {
    let mut places: BTreeMap<&str, &str> = BTreeMap::new();
    let cases = files.iter().flat_map(|(place, exercises)| exercises.iter().map(move |each| (place, each)));
    for (place, exercise) in cases {
        let id = exercise.case.id.as_str();
        if let Some(first) = places.insert(id, place) {
            let reason = if first == place {
                format!("two cases with the id {id}")
            } else {
                format!("case {id}: {first} has a case with this id, too")
            };
            return Err(CorpusError::new(place, reason));
        }
    }
    Ok(files.into_iter().flat_map(|(_, exercises)| exercises).collect())
}

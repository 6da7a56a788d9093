//! A package with all of its mutants, in a folder of its own; what does not compile is taken out again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::fault::Fault;
use crate::list::{self, Mutant};
use crate::rewrite::{Rewritten, rewrite};
use crate::subject::Subject;

/// Each check takes out at least one mutant; errors of later stages of the compiler show when those of earlier ones are gone.
const CHECKS: usize = 60;

/// The switch: which mutant is on, and which of them were passed while none is.
const SWITCH: &str = r#"
#[doc(hidden)]
#[allow(missing_docs, clippy::all)]
pub mod mutant {
    use std::io::Write as _;
    use std::sync::LazyLock;
    use std::sync::atomic::{AtomicBool, Ordering};

    static ON: LazyLock<usize> = LazyLock::new(|| {
        std::env::var("TURNSPEC_MUTANT").ok().and_then(|text| text.parse().ok()).unwrap_or(usize::MAX)
    });
    static REACHED_FILE: LazyLock<Option<std::fs::File>> = LazyLock::new(|| {
        let file = std::env::var_os("TURNSPEC_REACHED")?;
        std::fs::OpenOptions::new().create(true).append(true).open(file).ok()
    });
    static REACHED: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];

    pub fn on(number: usize) -> bool {
        if let Some(mut file) = REACHED_FILE.as_ref()
            && !REACHED[number].swap(true, Ordering::Relaxed)
        {
            let _ = file.write_all(format!("{number}\n").as_bytes());
        }
        *ON == number
    }
}
"#;

/// What became of the mutants.
pub struct Built {
    /// Those that are in the build.
    pub placed: BTreeSet<usize>,
    /// Those that do not compile.
    pub unviable: BTreeSet<usize>,
}

/// A copy of the tree, to be filled with mutants.
pub struct Workshop {
    subject: &'static Subject,
    /// Its root.
    pub root: PathBuf,
}

impl Workshop {
    /// Copies what git knows of the tree to `root`, without the sources that get mutants.
    ///
    /// # Errors
    /// When something cannot be read or written.
    pub fn new(
        subject: &'static Subject,
        tree: &Path,
        root: &Path,
        mutants: &[Mutant],
    ) -> Result<Self, Fault> {
        let filled: BTreeSet<&str> = mutants.iter().map(|mutant| mutant.file.as_str()).collect();
        let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(tree).output();
        let listed = listed.map_err(|error| Fault::about("git ls-files", error))?;
        let names = String::from_utf8_lossy(&listed.stdout).into_owned();
        for name in names
            .split('\0')
            .filter(|name| !name.is_empty() && !filled.contains(name) && *name != subject.root)
        {
            let (from, to) = (tree.join(name), root.join(name));
            let Ok(bytes) = fs::read(&from) else { continue };
            // What has not changed keeps its time, and is not compiled again.
            if fs::read(&to).is_ok_and(|there| there == bytes) {
                continue;
            }
            write(&to, &bytes)?;
        }
        Ok(Self { subject, root: root.to_owned() })
    }

    /// A cargo command in the copy.
    #[must_use]
    pub fn cargo(&self, subcommand: &str, arguments: &[&str]) -> Command {
        let mut command = Command::new("cargo");
        command
            .args([subcommand, "--locked", "--profile", "mutants", "--message-format", "json"])
            .args(arguments);
        command.current_dir(&self.root).stdin(Stdio::null());
        command.env("CARGO_TARGET_DIR", self.root.join("target")).env("CARGO_PROFILE_MUTANTS_OPT_LEVEL", "2");
        command.env("CARGO_PROFILE_MUTANTS_INCREMENTAL", "false").env("RUSTFLAGS", "--cap-lints allow");
        command
    }

    /// A cargo command that builds the tests.
    #[must_use]
    pub fn tests(&self) -> Command {
        let mut command = self.cargo("test", self.subject.tests);
        command.arg("--no-run");
        command
    }

    /// Puts every mutant into the sources that compiles. What does not is remembered beside them.
    ///
    /// # Errors
    /// When a source cannot be rewritten, or an error of the compiler is not that of a mutant.
    pub fn fill(&self, tree: &Path, mutants: &[Mutant]) -> Result<Built, Fault> {
        let files = list::by_file(mutants);
        let mut sources = BTreeMap::new();
        for file in files.keys() {
            let text = fs::read_to_string(tree.join(file)).map_err(|error| Fault::about(file, error))?;
            sources.insert(*file, text);
        }
        let mut taken = Taken::kept(&self.memory(), &sources, mutants);
        for check in 1..=CHECKS {
            let mut filled = BTreeMap::new();
            for (file, places) in &files {
                let rewritten = rewrite(&sources[file], mutants, places, &taken.out)
                    .map_err(|error| Fault::about(file, error))?;
                filled.insert(*file, rewritten);
            }
            self.write(tree, &filled, mutants.len())?;
            let errors = self.errors()?;
            eprintln!("check {check}: {} errors", errors.len());
            if errors.is_empty() {
                taken.keep(&self.memory())?;
                let placed = filled.values().flat_map(|source| &source.placed).copied().collect();
                return Ok(Built { placed, unviable: taken.unviable });
            }
            let before = taken.out.len();
            for error in &errors {
                let culprits = filled.get(error.file.as_str()).map(|source| source.culprits(&error.place));
                match culprits {
                    Some(Culprits::Copy(number)) => {
                        taken.out.insert(number);
                        taken.unviable.insert(number);
                    }
                    Some(Culprits::Around(numbers)) => taken.out.extend(numbers),
                    Some(Culprits::None) | None => return Err(Fault::about(&error.file, &error.message)),
                }
            }
            if taken.out.len() == before {
                break;
            }
        }
        Err(Fault::about("cargo check", "the errors do not come to an end"))
    }

    fn memory(&self) -> PathBuf {
        self.root.join("taken-out.json")
    }

    fn write(&self, tree: &Path, sources: &BTreeMap<&str, Rewritten>, count: usize) -> Result<(), Fault> {
        let root = self.subject.root;
        let put = |file: &str, text: &str| {
            let path = self.root.join(file);
            if fs::read_to_string(&path).is_ok_and(|there| there == text) {
                return Ok(());
            }
            write(&path, text.as_bytes())
        };
        for (file, source) in sources.iter().filter(|(file, _)| **file != root) {
            put(file, &source.text)?;
        }
        let text = match sources.get(root) {
            Some(source) => source.text.clone(),
            None => fs::read_to_string(tree.join(root)).map_err(|error| Fault::about(root, error))?,
        };
        put(root, &format!("{text}{}", SWITCH.replace("COUNT", &count.max(1).to_string())))
    }

    fn errors(&self) -> Result<Vec<CompileError>, Fault> {
        let output = self
            .cargo("check", self.subject.check)
            .output()
            .map_err(|error| Fault::about("cargo check", error))?;
        let text = String::from_utf8_lossy(&output.stdout);
        let mut errors = Vec::new();
        for line in text.lines() {
            let Ok(message) = serde_json::from_str::<Value>(line) else { continue };
            errors.extend(CompileError::of(&message["message"]));
        }
        if errors.is_empty() && !output.status.success() {
            return Err(Fault::about("cargo check", String::from_utf8_lossy(&output.stderr)));
        }
        Ok(errors)
    }
}

/// Writes a file, and the folder around it.
fn write(path: &Path, bytes: &[u8]) -> Result<(), Fault> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|error| Fault::about(folder.display(), error))?;
    }
    fs::write(path, bytes).map_err(|error| Fault::about(path.display(), error))
}

/// What has been taken out of sources in this state.
#[derive(Default, Serialize, Deserialize)]
struct Taken {
    state: u64,
    out: BTreeSet<usize>,
    unviable: BTreeSet<usize>,
}

impl Taken {
    fn kept(memory: &Path, sources: &BTreeMap<&str, String>, mutants: &[Mutant]) -> Self {
        let mut hasher = DefaultHasher::new();
        sources.hash(&mut hasher);
        mutants.iter().for_each(|mutant| mutant.name.hash(&mut hasher));
        let state = hasher.finish();
        let kept = fs::read_to_string(memory).ok().and_then(|text| serde_json::from_str::<Self>(&text).ok());
        kept.filter(|kept| kept.state == state).unwrap_or(Self { state, ..Self::default() })
    }

    fn keep(&self, memory: &Path) -> Result<(), Fault> {
        let text = serde_json::to_string(self).map_err(|error| Fault::about(memory.display(), error))?;
        fs::write(memory, text).map_err(|error| Fault::about(memory.display(), error))
    }
}

struct CompileError {
    file: String,
    place: Range<usize>,
    message: String,
}

impl CompileError {
    fn of(message: &Value) -> Option<Self> {
        if message["level"] != "error" {
            return None;
        }
        let spans = message["spans"].as_array()?;
        let span = spans.iter().find(|span| span["is_primary"] == true)?;
        let byte = |key: &str| usize::try_from(span[key].as_u64()?).ok();
        Some(Self {
            file: span["file_name"].as_str()?.to_owned(),
            place: byte("byte_start")?..byte("byte_end")?,
            message: message["rendered"].as_str().unwrap_or_default().to_owned(),
        })
    }
}

/// Whose error it is.
enum Culprits {
    /// It stands in a changed copy.
    Copy(usize),
    /// It stands elsewhere in an expression with mutants.
    Around(Vec<usize>),
    None,
}

impl Rewritten {
    fn culprits(&self, place: &Range<usize>) -> Culprits {
        let holds = |range: &Range<usize>| range.start <= place.start && place.end <= range.end;
        if let Some((_, number)) = self.copies.iter().find(|(range, _)| holds(range)) {
            return Culprits::Copy(*number);
        }
        let around = self.nodes.iter().filter(|(range, _)| holds(range));
        match around.min_by_key(|(range, _)| range.len()) {
            Some((_, numbers)) => Culprits::Around(numbers.clone()),
            None => Culprits::None,
        }
    }
}

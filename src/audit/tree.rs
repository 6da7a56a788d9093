//! The source tree: where it is, which commit it is, which files belong to it.

use std::ffi::OsStr;
use std::fs;
use std::os::unix::ffi::OsStrExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::{Fault, files};

/// What a tree must have.
const PARTS: [&str; 6] =
    ["Cargo.lock", "spec/rules", "spec/src", "src", "conformance/src", "conformance/cases"];

/// A source tree of the project.
#[derive(Debug)]
pub struct Tree {
    /// Its folder.
    pub root: PathBuf,
    /// The commit, and how the files differ from it.
    pub revision: Revision,
    /// The files that belong to it, relative to it, in the order of their bytes.
    pub files: Vec<String>,
}

/// What is known about the history of a tree.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Revision {
    /// A checkout of a commit.
    Commit {
        /// Its id.
        id: String,
        /// The files that differ from it, with git's two letters in front.
        changed: Vec<String>,
    },
    /// No checkout, or nobody who could read it.
    Unknown {
        /// Why.
        reason: &'static str,
    },
}

impl Tree {
    /// Opens a tree; what stands at `out` does not belong to it.
    ///
    /// # Errors
    /// When the folder is no tree of the project, or one with parts missing.
    pub fn open(root: &Path, out: &Path) -> Result<Self, Fault> {
        if !is_tree(root) {
            return Err(Fault::about(
                root.display(),
                "no source tree of Turnspec: it has no Cargo.toml of the package `turnspec`",
            ));
        }
        if let Some(part) = PARTS.iter().find(|part| !root.join(part).exists()) {
            return Err(Fault::about(root.join(part).display(), "missing; the source tree is not complete"));
        }
        let inside = inside(root, out);
        let belongs = |file: &String| {
            inside
                .as_ref()
                .is_none_or(|out| !file.strip_prefix(out).is_some_and(|rest| rest.starts_with('/')))
        };
        let (revision, mut files) = match checkout(root) {
            Ok((id, mut changed, files)) => {
                changed.retain(|line| line.get(3..).is_none_or(|file| belongs(&file.to_owned())));
                (Revision::Commit { id, changed }, files)
            }
            Err(reason) => (Revision::Unknown { reason }, archive(root)?),
        };
        files.retain(belongs);
        if let Some(file) = files.iter().find(|file| is_lossy(file)) {
            return Err(Fault::about(file, "the name is not UTF-8, so that no manifest can name the file"));
        }
        files.sort();
        Ok(Self { root: root.to_owned(), revision, files })
    }

    /// The tree that the current folder is in.
    ///
    /// # Errors
    /// When it is in none.
    pub fn around(folder: &Path) -> Result<PathBuf, Fault> {
        let found = folder.ancestors().find(|folder| is_tree(folder));
        found.map(Path::to_owned).ok_or_else(|| {
            Fault::about(folder.display(), "not inside a source tree of Turnspec; name one with --root TREE")
        })
    }

    /// The text of a file.
    ///
    /// # Errors
    /// Names the file when it cannot be read or is no text.
    pub fn read(&self, file: &str) -> Result<String, Fault> {
        fs::read_to_string(self.root.join(file)).map_err(|error| Fault::about(file, error))
    }

    /// The text of a file that may be missing.
    ///
    /// # Errors
    /// Names the file when it is there and cannot be read.
    pub fn read_if_there(&self, file: &str) -> Result<Option<String>, Fault> {
        if self.root.join(file).exists() { self.read(file).map(Some) } else { Ok(None) }
    }

    /// The files below a folder with an extension, whether tracked or not; none if there is no such folder.
    ///
    /// # Errors
    /// Names the folder when it cannot be read.
    pub fn below(&self, folder: &str, extension: &str) -> Result<Vec<String>, Fault> {
        if !self.root.join(folder).is_dir() {
            return Ok(Vec::new());
        }
        let mut files = files::below(&self.root, folder).map_err(|error| Fault::about(folder, error))?;
        files.retain(|file| Path::new(file).extension().is_some_and(|found| found == extension));
        Ok(files)
    }
}

fn is_tree(folder: &Path) -> bool {
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap_or_default();
    let table: toml::Table = manifest.parse().unwrap_or_default();
    table.get("package").and_then(|package| package.get("name")?.as_str()) == Some("turnspec")
}

/// A path relative to the tree, if it is inside.
fn inside(root: &Path, out: &Path) -> Option<String> {
    let parent = match out.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let out = parent.canonicalize().ok()?.join(out.file_name()?);
    let relative = out.strip_prefix(root.canonicalize().ok()?).ok()?.to_str()?.replace('\\', "/");
    Some(relative)
}

/// Commit id, changed files, tracked files; or why they are not known.
fn checkout(root: &Path) -> Result<(String, Vec<String>, Vec<String>), &'static str> {
    let git = |arguments: &[&str]| git(root, arguments);
    if !root.join(".git").exists() {
        return Err("the tree is no git checkout");
    }
    let top =
        git(&["rev-parse", "--show-toplevel"]).ok_or("git is not installed or does not read the tree")?;
    if Path::new(OsStr::from_bytes(top.trim_ascii_end())).canonicalize().ok() != root.canonicalize().ok() {
        return Err("the tree is no git checkout of its own");
    }
    let id = git(&["rev-parse", "--verify", "HEAD"]).ok_or("the git repository has no commit")?;
    let changed = git(&["status", "--porcelain", "--no-renames", "--untracked-files=all", "-z"])
        .ok_or("git does not tell the state of the tree")?;
    let tracked = git(&["ls-files", "-z"]).ok_or("git does not list the files")?;
    let lines = |text: &'_ [u8]| -> Vec<Vec<u8>> {
        text.split(|byte| *byte == 0).filter(|line| !line.is_empty()).map(<[u8]>::to_vec).collect()
    };
    let shown = |line: Vec<u8>| String::from_utf8_lossy(&line).into_owned();
    let is_present = |file: &Vec<u8>| root.join(OsStr::from_bytes(file)).is_file();
    let present = lines(&tracked).into_iter().filter(is_present).map(shown).collect();
    let mut changed: Vec<String> = lines(&changed).into_iter().map(shown).collect();
    changed.sort();
    Ok((shown(id.trim_ascii().to_vec()), changed, present))
}

/// Whether a name is shown with a replacement for what is no UTF-8.
fn is_lossy(file: &str) -> bool {
    file.contains(char::REPLACEMENT_CHARACTER)
}

/// What git prints, names of files byte by byte; nothing if it is missing or refuses.
fn git(root: &Path, arguments: &[&str]) -> Option<Vec<u8>> {
    let mut command = Command::new("git");
    command.arg("-C").arg(root).args(["-c", "core.fsmonitor=false"]).args(arguments);
    for variable in ["GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_COMMON_DIR", "GIT_PREFIX"] {
        command.env_remove(variable);
    }
    command.env("GIT_OPTIONAL_LOCKS", "0").stdin(Stdio::null()).stderr(Stdio::null());
    let output = command.output().ok().filter(|output| output.status.success())?;
    Some(output.stdout)
}

/// The files of a source archive: all but what `.gitignore` leaves out from the root of the tree.
fn archive(root: &Path) -> Result<Vec<String>, Fault> {
    let ignored = fs::read_to_string(root.join(".gitignore")).unwrap_or_default();
    let ignored: Vec<&str> = ignored
        .lines()
        .filter_map(|line| line.strip_prefix('/'))
        .map(|line| line.trim_end_matches('/'))
        .collect();
    let fault = |error| Fault::about(root.display(), error);
    let mut found = Vec::new();
    for entry in fs::read_dir(root).map_err(fault)? {
        let entry = entry.map_err(fault)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if name == ".git" || name == "target" {
            continue;
        }
        if entry.path().is_dir() {
            found.append(&mut files::below(root, &name).map_err(fault)?);
        } else {
            found.push(name);
        }
    }
    let kept = |file: &String| {
        !ignored
            .iter()
            .any(|name| file.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('/')))
    };
    found.retain(|file| kept(file) && (is_lossy(file) || root.join(file).is_file()));
    Ok(found)
}

impl Revision {
    /// The id of the commit, with a remark when files differ from it; none when it is unknown.
    #[must_use]
    pub fn commit(&self) -> Option<String> {
        match self {
            Self::Commit { id, changed } if changed.is_empty() => Some(id.clone()),
            Self::Commit { id, .. } => Some(format!("{id} and changes")),
            Self::Unknown { .. } => None,
        }
    }
}

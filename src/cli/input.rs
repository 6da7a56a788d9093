//! Reads programs and set-ups, and decides which set-up belongs to a program.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use turnspec_oracle::vocabulary::Setup;

use super::Failure;

/// The largest program in bytes: places in a program are 32-bit offsets.
const LARGEST: u64 = u32::MAX as u64;

/// A program text and where it came from.
pub struct Program {
    /// The path as given, or `standard input`.
    pub name: String,
    /// The text.
    pub text: Vec<u8>,
    path: Option<PathBuf>,
}

impl Program {
    /// Reads a program from a file, or from standard input if there is no path or it is `-`.
    ///
    /// # Errors
    /// When the file cannot be read, or holds 4 GiB or more.
    pub fn read(path: Option<&Path>) -> Result<Self, Failure> {
        let path = path.filter(|path| *path != Path::new("-"));
        let name = path.map_or("standard input".to_owned(), |path| path.display().to_string());
        let text = match path {
            Some(path) => read_file(path),
            None => read_limited(io::stdin().lock()),
        };
        let text = text.map_err(|error| Failure::about(&name, error))?;
        Ok(Self { name, text, path: path.map(Path::to_owned) })
    }

    /// Whether its file name says that it is a schedule program.
    fn is_schedule(&self) -> bool {
        let extension = self.path.as_deref().and_then(Path::extension);
        extension.is_some_and(|extension| extension.eq_ignore_ascii_case("SDF"))
    }

    /// Whether it was read from this file.
    pub fn is_at(&self, path: &Path) -> bool {
        let full = |path: &Path| path.canonicalize().ok();
        self.path.as_deref().and_then(full).is_some_and(|own| Some(own) == full(path))
    }

    /// The set-up to run on: the file given, else the file beside the program, else the default; for a schedule
    /// program if the program's file name or the set-up says so.
    ///
    /// # Errors
    /// When the file cannot be read or is no valid set-up.
    pub fn setup(&self, given: Option<&Path>) -> Result<Setup, Failure> {
        let mut setup = self.setup_file(given)?;
        setup.schedule |= self.is_schedule();
        Ok(setup)
    }

    fn setup_file(&self, given: Option<&Path>) -> Result<Setup, Failure> {
        if let Some(path) = given {
            let text = std::fs::read(path).map_err(|error| Failure::about(path.display(), error))?;
            return parse_setup(path, text);
        }
        let Some(path) = self.path.as_ref().map(|path| path.with_extension("setup.toml")) else {
            return Ok(Setup::default());
        };
        match std::fs::read(&path) {
            Ok(text) => parse_setup(&path, text),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Setup::default()),
            Err(error) => Err(Failure::about(path.display(), error)),
        }
    }
}

/// Reads a file with a program text.
///
/// # Errors
/// When the file cannot be read, or holds 4 GiB or more.
pub fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let size = file.metadata().map_or(0, |metadata| metadata.len());
    if size > LARGEST { Err(too_large()) } else { read_limited(file) }
}

fn read_limited(source: impl Read) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    let size = source.take(LARGEST + 1).read_to_end(&mut text)?;
    if size as u64 > LARGEST { Err(too_large()) } else { Ok(text) }
}

fn too_large() -> io::Error {
    io::Error::other("the program holds 4 GiB or more")
}

fn parse_setup(path: &Path, text: Vec<u8>) -> Result<Setup, Failure> {
    let text = String::from_utf8(text).map_err(|error| Failure::about(path.display(), error))?;
    Setup::from_toml(&text).map_err(|error| {
        let reason = error.to_string();
        // A fault with a place comes with an excerpt of several lines.
        let separator = if error.span.is_some() { "\n" } else { " " };
        Failure::Usage(format!("{}: broken set-up:{separator}{reason}", path.display()))
    })
}

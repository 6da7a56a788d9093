//! What a program runs on, as the command line says it: the set-up file, folders of the library, values of variables.

use std::path::{Path, PathBuf};

use turnspec_oracle::vocabulary::{ProgramText, Setup};

use super::Failure;
use super::input::{Program, read_file};

/// The kinds of file that hold programs to be called.
const EXTENSIONS: [&str; 4] = ["SUB", "SSB", "MSB", "MIN"];

/// What a program runs on.
#[derive(clap::Args)]
pub struct SetupOptions {
    /// The set-up file.
    #[arg(long, value_name = "FILE")]
    setup: Option<PathBuf>,
    /// A folder with files of programs that can be called (.SUB, .SSB, .MSB, .MIN); may be given again.
    #[arg(long, value_name = "DIR")]
    library: Vec<PathBuf>,
    /// The value of a common variable at the start, such as V1=10; may be given again.
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<InitialValue>,
}

/// A common variable and its value.
#[derive(Clone, Debug)]
struct InitialValue {
    name: String,
    value: f64,
}

impl std::str::FromStr for InitialValue {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = || "not of the form V1=10".to_owned();
        let (name, value) = text.split_once('=').ok_or_else(form)?;
        let value = value.trim().parse().map_err(|_| form())?;
        Ok(Self { name: name.trim().to_ascii_uppercase(), value })
    }
}

impl SetupOptions {
    /// The set-up of a program: its file, with the library and the values of the command line.
    ///
    /// # Errors
    /// When a file or folder cannot be read, or what they say is no valid set-up.
    pub fn setup(&self, program: &Program) -> Result<Setup, Failure> {
        let mut setup = program.setup(self.setup.as_deref())?;
        for folder in &self.library {
            add_folder(&mut setup, folder, program)?;
        }
        for InitialValue { name, value } in &self.set {
            setup.variables.insert(name.clone(), *value);
        }
        setup.validate().map_err(|error| Failure::Usage(format!("broken set-up: {error}")))?;
        Ok(setup)
    }
}

/// Adds the files of a folder to the library, by their names in capitals. The program itself is left out, and so are
/// files of other kinds.
fn add_folder(setup: &mut Setup, folder: &Path, program: &Program) -> Result<(), Failure> {
    let about = |error| Failure::about(folder.display(), error);
    for entry in std::fs::read_dir(folder).map_err(about)? {
        let path = entry.map_err(about)?.path();
        let extension = path.extension().and_then(|extension| extension.to_str());
        let known = extension.is_some_and(|each| EXTENSIONS.contains(&each.to_ascii_uppercase().as_str()));
        if !known || program.is_at(&path) {
            continue;
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_uppercase();
        let text = read_file(&path).map_err(|error| Failure::about(path.display(), error))?;
        if setup.library.insert(name.clone(), ProgramText(text)).is_some() {
            return Err(Failure::about(path.display(), format!("the library has two files {name}")));
        }
    }
    Ok(())
}

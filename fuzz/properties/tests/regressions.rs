//! Replays the kept inputs of the fuzz targets: `fuzz/regressions/TARGET/NAME`, the input byte by byte; and
//! the kept programs, `fuzz/regressions/NAME.min`, as inputs of every target that reads a program as it
//! stands.

#![allow(clippy::panic)]

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use turnspec_properties::{PROPERTIES, Property, property};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../regressions")
}

fn entries(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let paths: io::Result<Vec<PathBuf>> =
        fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path())).collect();
    let mut paths = paths?;
    paths.sort();
    Ok(paths)
}

#[test]
fn kept_inputs_hold() -> io::Result<()> {
    for target in entries(&folder())?.into_iter().filter(|path| path.is_dir()) {
        let name = target.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let Some(Property { holds, .. }) = property(&name) else { panic!("no target {name}") };
        for input in entries(&target)? {
            let message = holds(&fs::read(&input)?).err();
            assert_eq!(message, None, "{}", input.display());
        }
    }
    Ok(())
}

#[test]
fn kept_programs_hold() -> io::Result<()> {
    let is_program = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "min");
    for path in entries(&folder())?.into_iter().filter(is_program) {
        let mut input = vec![0; turnspec_generator::Case::SETUP_BYTES];
        input.extend(fs::read(&path)?);
        for Property { name, holds } in PROPERTIES {
            let message = holds(&input).err();
            assert_eq!(message, None, "{name}: {}", path.display());
        }
    }
    Ok(())
}

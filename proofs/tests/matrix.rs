//! The model checker proves every family: `.github/workflows/proofs.yml` names each in its matrix, once.

#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::Path;

#[test]
fn every_family_is_in_the_matrix_once() {
    let mut listed = matrix();
    listed.sort();
    assert_eq!(listed, families());
}

/// The families of the matrix: the words of the lines `- …` behind `families:`.
fn matrix() -> Vec<String> {
    let workflow = fs::read_to_string(root().join("../.github/workflows/proofs.yml")).unwrap();
    let lines = workflow.lines().map(str::trim).skip_while(|line| *line != "families:").skip(1);
    let items = lines.map_while(|line| line.strip_prefix("- "));
    items.flat_map(str::split_whitespace).map(str::to_owned).collect()
}

/// The files of `src/` that state theorems, by name.
fn families() -> Vec<String> {
    let paths = fs::read_dir(root().join("src")).unwrap().map(|entry| entry.unwrap().path());
    let stating = paths.filter(|path| fs::read_to_string(path).unwrap().contains("\ntheorems! {\n"));
    let mut names: Vec<_> =
        stating.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    names.sort();
    assert!(names.len() > 30, "only {} families found", names.len());
    names
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

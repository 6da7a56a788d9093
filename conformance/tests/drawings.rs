//! The drawings that the rule texts ask for are checked in and current, and there are no others.

#![allow(clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use turnspec_conformance::drawings;

const COMMAND: &str = "cargo run -p turnspec-conformance --example drawings";

fn wanted() -> Vec<(String, String)> {
    drawings().unwrap_or_else(|reason| panic!("{reason}"))
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../spec/rules")
}

#[test]
fn every_drawing_is_checked_in_and_current() {
    for (path, text) in wanted() {
        let checked_in = fs::read_to_string(root().join(&path)).unwrap_or_default();
        assert!(checked_in == text, "{path} is missing or out of date: {COMMAND}");
    }
}

#[test]
fn every_file_is_the_drawing_of_an_example() {
    let wanted: BTreeSet<String> = wanted().into_iter().map(|(path, _)| path).collect();
    let folder = root().join("e100l/drawings");
    let list = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let there: BTreeSet<String> =
        list.flatten().map(|entry| format!("e100l/drawings/{}", entry.file_name().display())).collect();
    assert_eq!(
        there.difference(&wanted).collect::<Vec<_>>(),
        Vec::<&String>::new(),
        "no example asks for them"
    );
    assert!(!wanted.is_empty());
}

#[test]
fn drawings_are_small() {
    for (path, text) in wanted() {
        assert!(text.len() <= 6_000, "{path} has {} bytes", text.len());
    }
}

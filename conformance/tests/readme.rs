//! The tables of the README are those of the code.

use std::fs;
use std::path::Path;

use turnspec_conformance::{CRITERIA, Declaration, corpus};

fn text(name: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap_or_default()
}

#[test]
fn the_criterion_of_every_feature_is_in_the_readme() {
    let readme = text("README.md");
    for criterion in CRITERIA {
        let row = format!("\n| `{}` | {} |\n", criterion.feature.as_str(), criterion.text);
        assert!(readme.contains(&row), "{row}");
    }
}

#[test]
fn the_format_is_in_the_readme() {
    assert!(text("README.md").contains(&format!("\"format\": \"{}\"", corpus::FORMAT)));
}

/// The fences of a language in a markdown text.
fn fences(markdown: &str, language: &str) -> Vec<String> {
    let begin = format!("```{language}\n");
    let parts = markdown.split(&begin).skip(1);
    parts.filter_map(|part| part.split("```").next()).map(str::to_owned).collect()
}

#[test]
fn the_declarations_in_the_texts_are_declarations() {
    let mut declarations = vec![text("turnspec.toml")];
    for name in ["README.md", "PROTOCOL.md"] {
        let found = fences(&text(name).replace("\n   ", "\n"), "toml");
        assert!(!found.is_empty(), "{name}");
        declarations.extend(found);
    }
    for declaration in declarations {
        assert!(
            Declaration::from_toml(&declaration).is_ok(),
            "{declaration}: {:?}",
            Declaration::from_toml(&declaration)
        );
    }
}

//! Statements about all inputs: the properties that tests sample, and the theorems that a model checker
//! decides. Both are functions; the doc comment is the statement, its lines `Of: …`, `Assumes: …` and `Rules: …`
//! say what it is about, what it takes for granted and which rules it supports.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::Serialize;
use turnspec_oracle::vocabulary::RuleId;

use super::citations::in_comment;
use super::source::{Item, Kind, items};
use super::{Fault, Tree};

/// A statement about all inputs.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, JsonSchema)]
pub struct Statement {
    /// Name of the function.
    pub name: String,
    /// The file that it stands in, relative to the tree.
    pub file: String,
    /// Line of the function.
    pub line: usize,
    /// The statement in plain English.
    pub statement: String,
    /// The functions that it is about, where it says so.
    pub of: Vec<String>,
    /// What it takes for granted.
    pub assumes: Vec<String>,
    /// The rules that it supports.
    #[schemars(with = "Vec<String>")]
    pub rules: Vec<RuleId>,
    /// Whether it is a false statement, for which a counterexample must be found.
    pub refuted: bool,
}

/// The theorems under `proofs/src`.
///
/// # Errors
/// Names the file that cannot be read.
pub fn proofs(tree: &Tree) -> Result<Vec<Statement>, Fault> {
    collect(tree, &["proofs/src"], |item| matches!(item.within.as_deref(), Some("theorems" | "refutations")))
}

/// The properties: the functions of `proptest!` blocks, and every other function of the property tests that
/// names its rules.
///
/// # Errors
/// Names the file that cannot be read.
pub fn properties(tree: &Tree) -> Result<Vec<Statement>, Fault> {
    collect(tree, &["spec/tests", "tests", "fuzz/properties"], |item| {
        !item.docs.is_empty() && item.within.as_deref() == Some("proptest")
            || item.docs.iter().any(|line| line.starts_with("Rules:"))
    })
}

fn collect(tree: &Tree, folders: &[&str], counts: impl Fn(&Item) -> bool) -> Result<Vec<Statement>, Fault> {
    let mut found = Vec::new();
    for folder in folders {
        for file in tree.below(folder, "rs")? {
            let mut functions = items(&tree.read(&file)?);
            functions.retain(|item| item.kind == Kind::Function && counts(item));
            functions.sort_by_key(|item| item.line);
            found.extend(functions.iter().map(|item| statement(&file, item)));
        }
    }
    Ok(found)
}

/// Reads a doc comment: paragraphs, of which those that begin with a key are not part of the statement.
fn statement(file: &str, item: &Item) -> Statement {
    let (mut text, mut of, mut assumes, mut rules) = (Vec::new(), Vec::new(), Vec::new(), BTreeSet::new());
    for paragraph in paragraphs(&item.docs) {
        if let Some(list) = paragraph.strip_prefix("Rules:") {
            rules.extend(in_comment(list));
        } else if let Some(assumption) = paragraph.strip_prefix("Assumes:") {
            assumes.push(assumption.trim().to_owned());
        } else if let Some(functions) = paragraph.strip_prefix("Of:") {
            of.push(functions.trim().to_owned());
        } else {
            text.push(paragraph);
        }
    }
    Statement {
        name: item.name.clone(),
        file: file.to_owned(),
        line: item.line,
        statement: text.join("\n\n"),
        of,
        assumes,
        rules: rules.into_iter().collect(),
        refuted: item.within.as_deref() == Some("refutations"),
    }
}

/// The paragraphs of a doc comment; a key begins one too.
fn paragraphs(docs: &[String]) -> Vec<String> {
    let mut paragraphs: Vec<String> = Vec::new();
    let mut fresh = true;
    for line in docs {
        let key = ["Of:", "Assumes:", "Rules:"].iter().any(|key| line.starts_with(key));
        match paragraphs.last_mut().filter(|_| !fresh && !key && !line.is_empty()) {
            Some(paragraph) => *paragraph += &format!(" {line}"),
            None if !line.is_empty() => paragraphs.push(line.clone()),
            None => {}
        }
        fresh = line.is_empty();
    }
    paragraphs
}

#[cfg(test)]
mod tests {
    use super::{items, statement};

    #[test]
    fn keys_are_read_from_the_doc_comment() {
        let text = "theorems! {\n    /// One thing\n    /// holds.\n    /// Of: `f`\n    /// Assumes: nothing\n    /// at all.\n    ///\n    \
                    /// Rules: E100L-ABS-01, -02\n    fn it_holds() {}\n}\n";
        let items = items(text);
        let item = items.iter().find(|item| item.name == "it_holds").expect("a function");
        let read = statement("a.rs", item);
        assert_eq!(read.statement, "One thing holds.");
        assert_eq!(read.of, ["`f`"]);
        assert_eq!(read.assumes, ["nothing at all."]);
        let rules: Vec<&str> = read.rules.iter().map(|rule| rule.as_str()).collect();
        assert_eq!(rules, ["E100L-ABS-01", "E100L-ABS-02"]);
    }
}

//! The page to read: one file without any other, for a screen of any width and for paper.

mod evidence;
mod limits;
mod markdown;
mod rules;
mod summary;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::gather::Gathered;
use super::matrix::Matrix;
use super::tools::Tool;
use super::{Revision, Tree};

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("script.js");

/// The page.
#[must_use]
pub fn page(tree: &Tree, gathered: &Gathered, matrix: &Matrix, tools: &[Tool]) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "Turnspec audit" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                (masthead(tree))
                main {
                    (summary::section(gathered, matrix))
                    (rules::section(gathered, matrix))
                    (limits::section(gathered))
                    (evidence::sections(tree, gathered))
                    (evidence::tools(gathered, tools))
                    (files())
                }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    page.into_string()
}

const CONTENTS: [(&str, &str); 9] = [
    ("summary", "Summary"),
    ("rules", "Rules"),
    ("limits", "Limits and readings"),
    ("statements", "Properties and proofs"),
    ("coverage", "Coverage"),
    ("mutants", "Mutants"),
    ("planted", "Planted bugs"),
    ("tools", "Tools and packages"),
    ("files", "Files"),
];

fn masthead(tree: &Tree) -> Markup {
    html! {
        header {
            p.kicker { "Turnspec " (env!("CARGO_PKG_VERSION")) " · Okuma OSP-E100L" }
            h1 { "Audit of the reference semantics" }
            (revision(&tree.revision))
            nav aria-label="Contents" {
                @for (anchor, name) in CONTENTS { a href={ "#" (anchor) } { (name) } }
            }
        }
    }
}

fn revision(revision: &Revision) -> Markup {
    match revision {
        Revision::Commit { id, changed } if changed.is_empty() => html! { p { "Commit " code { (id) } } },
        Revision::Commit { id, changed } => html! {
            p { "Commit " code { (id) } }
            div.warning role="note" {
                strong { "The tree is dirty." }
                " " (changed.len()) " file(s) differ from the commit; nobody else can make this bundle again."
                ul { @for file in changed { li { code { (file) } } } }
            }
        },
        Revision::Unknown { reason } => html! {
            div.warning role="note" { strong { "The commit is unknown:" } " " (reason) "." }
        },
    }
}

fn files() -> Markup {
    const FILES: [(&str, &str); 8] = [
        ("index.html", "this page"),
        ("matrix.json", "the rule table and the findings for machines"),
        ("matrix.csv", "the rule table for spreadsheets, a line a rule"),
        ("matrix.schema.json", "JSON Schema of matrix.json"),
        ("sbom.cdx.json", "bill of materials, CycloneDX 1.5"),
        ("tools.json", "tools and versions"),
        ("SOURCES.sha256", "SHA-256 of every source file: cd TREE && sha256sum -c BUNDLE/SOURCES.sha256"),
        (
            "MANIFEST.sha256",
            "SHA-256 of every file of this bundle: cd BUNDLE && sha256sum -c MANIFEST.sha256",
        ),
    ];
    html! {
        section id="files" {
            h2 { "Files" }
            dl.files {
                @for (name, what) in FILES { dt { a href=(name) { (name) } } dd { (what) } }
            }
        }
    }
}

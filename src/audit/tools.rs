//! The versions of the tools that the tree demands and that its evidence was made with.

use serde::Serialize;

use super::gather::Gathered;
use super::{Fault, Tree};

/// A tool and what is known of its version.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Tool {
    /// Its name.
    pub name: String,
    /// The version.
    pub version: String,
    /// Where that is said.
    pub said_by: &'static str,
}

/// The tools, in a fixed order.
///
/// # Errors
/// When the manifest of the tree is malformed.
pub fn tools(tree: &Tree, gathered: &Gathered) -> Result<Vec<Tool>, Fault> {
    let manifest = "Cargo.toml";
    let table: toml::Table = tree.read(manifest)?.parse().map_err(|error| Fault::about(manifest, error))?;
    let workspace = table.get("workspace").and_then(|workspace| workspace.get("package"));
    let text =
        |key: &str| workspace.and_then(|package| package.get(key)?.as_str()).unwrap_or("unknown").to_owned();
    let mut tools = vec![
        tool("turnspec", env!("CARGO_PKG_VERSION").to_owned(), "the program that made this bundle"),
        tool("rustc and cargo", format!("{} or newer", text("rust-version")), "Cargo.toml, rust-version"),
        tool("Rust edition", text("edition"), "Cargo.toml, edition"),
    ];
    if let Some(coverage) = &gathered.coverage {
        tools.extend(coverage.tools.iter().map(|name| named(name, "evidence/coverage.json")));
    }
    if let Some(judged) = &gathered.mutants {
        tools.push(named(&judged.run.tool, "evidence/mutants.json"));
    }
    Ok(tools)
}

fn tool(name: &str, version: String, said_by: &'static str) -> Tool {
    Tool { name: name.to_owned(), version, said_by }
}

/// Name and version in one text.
fn named(text: &str, said_by: &'static str) -> Tool {
    let place = text.find(|letter: char| letter.is_ascii_digit()).unwrap_or(text.len());
    let (name, version) = text.split_at(place);
    tool(name.trim(), version.trim().to_owned(), said_by)
}

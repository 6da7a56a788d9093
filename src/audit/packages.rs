//! The packages that the project is built and tested from: `Cargo.lock`, and the licences that their
//! manifests state, kept in `evidence/licences.json` because the lock file has none.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;

use super::{Fault, Tree, evidence};

const LOCK: &str = "Cargo.lock";
const LICENCES: &str = "evidence/licences.json";

/// A package of the lock file.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
pub struct Package {
    /// Its name.
    pub name: String,
    /// Its version.
    pub version: String,
    /// Where it comes from; none for the packages of the tree.
    pub source: Option<String>,
    /// SHA-256 of its archive.
    pub checksum: Option<String>,
    /// What it depends on: a name, with a version where there are several.
    #[serde(default)]
    pub dependencies: Vec<String>,
    /// The licence that its manifest states, as an SPDX expression; none when it is not recorded.
    #[serde(skip)]
    pub licence: Option<String>,
}

impl Package {
    /// Name and version.
    #[must_use]
    pub fn key(&self) -> String {
        format!("{} {}", self.name, self.version)
    }
}

#[derive(Deserialize)]
struct Lock {
    package: Vec<Package>,
}

/// The packages, sorted by name and version.
///
/// # Errors
/// Names the file that has not the form that it should have.
pub fn read(tree: &Tree) -> Result<Vec<Package>, Fault> {
    let lock: Lock = toml::from_str(&tree.read(LOCK)?).map_err(|error| Fault::about(LOCK, error))?;
    let licences: BTreeMap<String, String> = evidence::read(tree, LICENCES)?.unwrap_or_default();
    let mut packages = lock.package;
    for package in &mut packages {
        package.licence = licences.get(&package.key()).cloned();
    }
    packages.sort_by_key(Package::key);
    Ok(packages)
}

/// The licences in the output of `cargo metadata`, by name and version.
///
/// # Errors
/// When it is not the output of `cargo metadata`.
pub fn condense_licences(metadata: &str) -> Result<BTreeMap<String, String>, Fault> {
    let fault = |reason: String| Fault::about("cargo metadata", reason);
    let value: Value = serde_json::from_str(metadata).map_err(|error| fault(error.to_string()))?;
    let packages = value["packages"].as_array().ok_or_else(|| fault("no `packages`".to_owned()))?;
    let licence = |package: &Value| {
        let key = format!("{} {}", package["name"].as_str()?, package["version"].as_str()?);
        // Before SPDX expressions a slash stood for a choice.
        Some((key, package["license"].as_str()?.replace('/', " OR ").replace("  ", " ")))
    };
    Ok(packages.iter().filter_map(licence).collect())
}

#[cfg(test)]
mod tests {
    use super::condense_licences;

    #[test]
    fn a_slash_is_a_choice() {
        let text = r#"{"packages":[{"name":"a","version":"1.0.0","license":"MIT/Apache-2.0"},
            {"name":"b","version":"2.0.0","license":null},{"name":"c","version":"3.0.0","license":"MIT / BSL-1.0"}]}"#;
        let licences = condense_licences(text).expect("metadata");
        assert_eq!(licences.get("a 1.0.0").map(String::as_str), Some("MIT OR Apache-2.0"));
        assert_eq!(licences.get("c 3.0.0").map(String::as_str), Some("MIT OR BSL-1.0"));
        assert_eq!(licences.len(), 2);
        assert!(condense_licences("{}").is_err());
    }
}

//! The software bill of materials: CycloneDX 1.5, as JSON. It has no serial number and no time, so that it
//! is a function of the lock file.

use serde_json::{Value, json};

use super::packages::Package;

/// The bill of materials of the packages.
#[must_use]
pub fn bill(packages: &[Package]) -> Value {
    let subject = packages.iter().find(|package| package.name == "turnspec");
    let others = packages.iter().filter(|package| package.name != "turnspec");
    json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {
            "component": subject.map(|package| component(package, "application")),
            "properties": [{
                "name": "turnspec:scope",
                "value": "Cargo.lock: normal, build and development dependencies on every platform",
            }],
        },
        "components": others.map(|package| component(package, "library")).collect::<Vec<_>>(),
        "dependencies": packages.iter().map(|package| depends(package, packages)).collect::<Vec<_>>(),
    })
}

fn component(package: &Package, kind: &str) -> Value {
    let mut component = json!({
        "type": kind,
        "bom-ref": reference(package),
        "name": package.name,
        "version": package.version,
        "purl": reference(package),
    });
    if let Some(checksum) = &package.checksum {
        component["hashes"] = json!([{ "alg": "SHA-256", "content": checksum }]);
    }
    if let Some(licence) = &package.licence {
        component["licenses"] = json!([{ "expression": licence }]);
    }
    component
}

fn depends(package: &Package, packages: &[Package]) -> Value {
    let found = package.dependencies.iter().filter_map(|dependency| {
        let (name, version) = dependency
            .split_once(' ')
            .map_or((dependency.as_str(), None), |(name, rest)| (name, rest.split(' ').next()));
        packages.iter().find(|package| package.name == name && version.is_none_or(|it| it == package.version))
    });
    let mut references: Vec<String> = found.map(reference).collect();
    references.sort();
    references.dedup();
    json!({ "ref": reference(package), "dependsOn": references })
}

/// The package URL.
fn reference(package: &Package) -> String {
    // A plus sign before build metadata is written in percent in a package URL.
    format!("pkg:cargo/{}@{}", package.name, package.version.replace('+', "%2B"))
}

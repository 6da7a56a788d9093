//! The checked-in schemas are those of the present types.

#![cfg(feature = "schema")]

use std::error::Error;
use std::fs;
use std::path::Path;

#[test]
fn checked_in_schemas_are_current() -> Result<(), Box<dyn Error>> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas");
    for (name, text) in turnspec_conformance::schemas()? {
        let checked_in = fs::read_to_string(directory.join(name))?;
        assert!(
            checked_in == text,
            "{name} is out of date: cargo run -p turnspec-conformance --example schemas"
        );
    }
    Ok(())
}

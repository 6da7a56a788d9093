//! Writes the JSON Schemas to `conformance/schemas/`.

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas");
    fs::create_dir_all(&directory)?;
    for (name, text) in turnspec_conformance::schemas()? {
        fs::write(directory.join(name), text)?;
    }
    Ok(())
}

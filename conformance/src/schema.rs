//! The JSON Schemas of the set-up, of an event and of a case, and their version.

use schemars::{JsonSchema, SchemaGenerator, generate::SchemaSettings};
use turnspec_oracle::vocabulary::{Event, Setup};

use crate::Case;

/// Version of the three schemas. A change that old files or old readers do not survive raises the first
/// number (before 1.0 the second), an addition the second, a better description the third.
const VERSION: &str = "0.1.0";

/// File name and text of each schema.
///
/// # Errors
/// When a schema cannot be written as JSON.
pub fn schemas() -> Result<[(&'static str, String); 3], serde_json::Error> {
    Ok([
        ("case.schema.json", text::<Case>("case")?),
        ("event.schema.json", text::<Event>("event")?),
        ("setup.schema.json", text::<Setup>("setup")?),
    ])
}

fn text<T: JsonSchema>(name: &str) -> Result<String, serde_json::Error> {
    let generator = SchemaGenerator::new(SchemaSettings::draft2020_12());
    let mut schema = generator.into_root_schema_for::<T>();
    schema.insert("$id".to_owned(), format!("urn:turnspec:{name}:{VERSION}").into());
    let mut text = serde_json::to_string_pretty(&schema)?;
    text.push('\n');
    Ok(text)
}

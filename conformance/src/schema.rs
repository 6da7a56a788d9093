//! The JSON Schemas of the set-up, of an event, of a case, of a file of cases, of its index, of a
//! report and of what an implementation reads.

use schemars::{JsonSchema, SchemaGenerator, generate::SchemaSettings};
use turnspec_oracle::vocabulary::{Event, Setup};

use crate::corpus::{CorpusFile, CorpusIndex, FORMAT};
use crate::report::Report;
use crate::{Case, Task};

/// File name and text of each schema.
///
/// # Errors
/// When a schema cannot be written as JSON.
pub fn schemas() -> Result<Vec<(&'static str, String)>, serde_json::Error> {
    Ok(vec![
        ("case.schema.json", text::<Case>("case")?),
        ("corpus.schema.json", text::<CorpusFile>("corpus")?),
        ("corpus-index.schema.json", text::<CorpusIndex>("corpus-index")?),
        ("event.schema.json", text::<Event>("event")?),
        ("report.schema.json", text::<Report>("report")?),
        ("setup.schema.json", text::<Setup>("setup")?),
        ("task.schema.json", text::<Task>("task")?),
    ])
}

fn text<T: JsonSchema>(name: &str) -> Result<String, serde_json::Error> {
    let generator = SchemaGenerator::new(SchemaSettings::draft2020_12());
    let mut schema = generator.into_root_schema_for::<T>();
    schema.insert("$id".to_owned(), format!("urn:turnspec:{name}:{FORMAT}").into());
    let mut text = serde_json::to_string_pretty(&schema)?;
    text.push('\n');
    Ok(text)
}

//! The report as JSON, `schemas/report.schema.json`.

use super::Report;

/// The report as JSON text.
///
/// # Errors
/// When it cannot be written as JSON.
pub fn json(report: &Report) -> Result<String, serde_json::Error> {
    Ok(serde_json::to_string_pretty(report)? + "\n")
}

//! The rule table for spreadsheets: CSV (RFC 4180), a head, then a line a rule. The parts of a cell are
//! separated by `; `.

use super::citations::Place;
use super::matrix::{Check, Matrix, MutantCounts, Row, passed};

/// The table.
#[must_use]
pub fn table(matrix: &Matrix) -> String {
    let mut csv = HEAD.join(",");
    csv.push_str("\r\n");
    for row in &matrix.rules {
        csv.push_str(&cells(row).map(|cell| quote(&cell)).join(","));
        csv.push_str("\r\n");
    }
    csv
}

/// The columns of the CSV table.
const HEAD: [&str; 20] = [
    "id",
    "title",
    "area",
    "level",
    "basis",
    "source",
    "alarms",
    "text",
    "oracle",
    "engine",
    "examples",
    "examples_passed",
    "cases",
    "cases_passed",
    "exercised",
    "properties",
    "proofs",
    "mutants_killed",
    "mutants_survived",
    "planted",
];

/// The cells of a rule.
fn cells(row: &Row) -> [String; HEAD.len()] {
    let names =
        |checks: &[Check]| checks.iter().map(|check| check.name.clone()).collect::<Vec<_>>().join("; ");
    let counted = |count: fn(&MutantCounts) -> usize| {
        row.mutants.as_ref().map_or(String::new(), |counts| count(counts).to_string())
    };
    [
        row.id.clone(),
        row.title.clone(),
        row.area.clone(),
        row.level.clone(),
        row.basis.clone(),
        row.source.clone(),
        row.alarms.join("; "),
        row.text.clone(),
        places(&row.oracle),
        places(&row.engine),
        names(&row.examples),
        passed(&row.examples).to_string(),
        names(&row.cases),
        passed(&row.cases).to_string(),
        row.exercised.to_string(),
        row.properties.join("; "),
        row.proofs.join("; "),
        counted(|counts| counts.caught + counts.timeout),
        counted(|counts| counts.missed + counts.explained),
        row.planted.iter().map(|planted| planted.bug.clone()).collect::<Vec<_>>().join("; "),
    ]
}

fn places(places: &[Place]) -> String {
    let place = |place: &Place| format!("{}:{} {}", place.file, place.line, place.item).trim_end().to_owned();
    places.iter().map(place).collect::<Vec<_>>().join("; ")
}

/// A cell of a CSV table (RFC 4180).
fn quote(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::quote;

    #[test]
    fn cells_are_quoted_where_they_must_be() {
        assert_eq!(quote("a; b"), "a; b");
        assert_eq!(quote("a,\"b\""), "\"a,\"\"b\"\"\"");
    }
}

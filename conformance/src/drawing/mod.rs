//! Drawings of rule examples: which examples have one, and what it is called.
//!
//! An image behind the trace of an example asks for its drawing, `drawings/RULE-NUMBER.svg`. It is made from
//! the trace of the oracle, so that text, example and drawing cannot say different things.

mod scene;
mod sheet;
mod view;

use turnspec_oracle::book::{self, Drawing, Example};
use turnspec_oracle::vocabulary::{Event, RuleId};

use scene::Scene;

/// Path below `spec/rules/` and SVG text of every drawing that the rule texts ask for.
///
/// # Errors
/// The first drawing whose path is not that of its example, or that cannot be made, in words.
pub fn drawings() -> Result<Vec<(String, String)>, String> {
    let mut drawings = Vec::new();
    for rule in book::e100l()? {
        let folder = rule.file.rsplit_once('/').map_or("", |(folder, _)| folder);
        for (number, example) in (1..).zip(&rule.examples) {
            let Some(drawing) = &example.drawing else { continue };
            let text = draw(rule.id, number, example, drawing);
            let text =
                text.map_err(|reason| format!("spec/rules/{}:{}: {reason}", rule.file, example.line))?;
            drawings.push((format!("{folder}/{}", drawing.path), text));
        }
    }
    Ok(drawings)
}

fn draw(rule: RuleId, number: usize, example: &Example, drawing: &Drawing) -> Result<String, String> {
    let path = format!("drawings/{rule}-{number}.svg");
    if drawing.path != path {
        return Err(format!("its drawing is {path}, not {}", drawing.path));
    }
    let setup = example.setup().map_err(|error| error.to_string())?;
    let mut trace = Vec::new();
    turnspec_oracle::run(&example.program, &setup, &mut |event: &Event| trace.push(*event));
    let scene = Scene::of(&trace)?;
    let names: Vec<&str> = drawing.caption.split(|each: char| !each.is_ascii_alphanumeric()).collect();
    sheet::svg(&drawing.caption, &scene, &names)
}

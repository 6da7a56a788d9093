//! A page with a drawing, in which each motion says its block, its event and its rules.

use maud::{PreEscaped, html};
use serde::Serialize;
use turnspec_conformance::page::page_with;

use super::path::Plan;
use super::sheet::sheet;
use super::view::Extent;

/// What is told about an event.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Told {
    /// Its number.
    pub n: u64,
    /// The line of its block.
    pub line: u32,
    /// The text of its block.
    pub block: String,
    /// What happens.
    pub event: String,
    /// Ids and titles of its rules.
    pub rules: Vec<String>,
}

/// The page: the drawing, and what is told about the motion under the pointer. It needs nothing from elsewhere.
///
/// # Errors
/// When what is told cannot be written as JSON.
pub fn page(title: &str, plan: &Plan, extent: Extent, told: &[Told]) -> serde_json::Result<String> {
    // `</script>` in a program must not end the script.
    let data = serde_json::to_string(told)?.replace('<', "\\u003c");
    let body = html! {
        main {
            div.sheet { (sheet(title, plan, extent, false)) }
            section aria-live="polite" {
                p.hint { "Point at a motion, or step through them with the arrow keys." }
                div.told hidden {
                    p { span.line {} code.block {} }
                    p.event {}
                    ul.rules {}
                }
            }
        }
        script id="told" type="application/json" { (PreEscaped(data)) }
        script { (PreEscaped(include_str!("page.js"))) }
    };
    Ok(page_with(title, concat!(include_str!("style.css"), include_str!("page.css")), &body))
}

#[cfg(test)]
mod tests {
    use super::{Extent, Plan, Told, page};

    #[test]
    fn a_program_cannot_leave_its_place() {
        let told = Told {
            n: 1,
            line: 1,
            block: "(</script><b>)".to_owned(),
            event: "rapid".to_owned(),
            rules: vec!["E100L-G00-01".to_owned()],
        };
        let text = page("t", &Plan::default(), Extent::All, &[told]).unwrap_or_default();
        assert!(!text.contains("</script><b>") && text.contains("\\u003c/script>\\u003cb>"), "{text}");
    }
}

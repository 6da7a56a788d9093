//! A figure that the manual prints, and what it says about a trace.
//!
//! A figure names a field of an event as compact notation does (`x`, `path`, `f`), or a product or quotient
//! of fields, worked from left to right: `path/f` is the time of a motion in minutes. Manuals round, so a
//! figure has a tolerance, usually half a unit of its last digit; figures and tolerances are compared in
//! binary64.

use serde::{Deserialize, Serialize};
use turnspec_oracle::vocabulary::{Event, notation};

/// A figure that the manual prints.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Figure {
    /// What it is.
    pub what: String,
    /// Ordinal of the event, from 1; `null` when a trace does not show it.
    pub event: Option<u64>,
    /// Ordinal of an earlier event: the figure is the change of the field since then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub since: Option<u64>,
    /// Field of the event in compact notation, or fields joined by `*` and `/`; empty without an event.
    pub field: String,
    /// The number as printed, with the unit that the trace shows (`0.2mm/rev`).
    pub value: String,
    /// Largest permitted difference.
    pub tolerance: String,
}

impl Figure {
    /// Compares with the event of a trace.
    ///
    /// # Errors
    /// The difference, or what is malformed or missing, in words.
    pub fn check(&self, trace: &[Event]) -> Result<(), String> {
        let Some(ordinal) = self.event else { return Ok(()) };
        let fault = |reason: String| format!("{} ({} of event {ordinal}): {reason}", self.what, self.field);
        let (mut actual, unit) = evaluate(&self.field, trace, ordinal).map_err(fault)?;
        if let Some(earlier) = self.since {
            actual -= evaluate(&self.field, trace, earlier).map_err(fault)?.0;
        }
        let (stated, stated_unit) = number(&self.value).map_err(fault)?;
        let (tolerance, _) = number(&self.tolerance).map_err(fault)?;
        if unit != stated_unit {
            return Err(fault(format!("the manual says {}, the unit of the trace is {unit:?}", self.value)));
        }
        // The tolerance is widened by the rounding of the subtraction, far below any figure's last digit.
        if (actual - stated).abs() <= tolerance + stated.abs() * 1e-12 {
            Ok(())
        } else {
            Err(fault(format!("the manual says {} within {tolerance}, the trace says {actual}", self.value)))
        }
    }
}

/// The value of a formula of fields, and the unit when it is a single field.
fn evaluate(formula: &str, trace: &[Event], ordinal: u64) -> Result<(f64, String), String> {
    let event = trace.iter().find(|event| event.n == ordinal);
    let fields = notation::fields(event.ok_or_else(|| format!("the trace has no event {ordinal}"))?);
    let value = |name: &str| match fields.iter().find(|(key, _)| *key == name && !key.is_empty()) {
        Some((_, text)) => number(text),
        None => Err(format!("event {ordinal} has no field {name:?}")),
    };
    let (first, mut rest) = formula.split_at(formula.find(['*', '/']).unwrap_or(formula.len()));
    let (mut result, mut unit) = value(first)?;
    while let Some(operator) = rest.chars().next() {
        let tail = &rest[1..];
        let (name, next) = tail.split_at(tail.find(['*', '/']).unwrap_or(tail.len()));
        let (operand, _) = value(name)?;
        result = if operator == '*' { result * operand } else { result / operand };
        unit.clear();
        rest = next;
    }
    Ok((result, unit))
}

/// A number and the unit that follows it.
fn number(text: &str) -> Result<(f64, String), String> {
    let end = text.find(|each: char| !matches!(each, '0'..='9' | '.' | '-')).unwrap_or(text.len());
    let (digits, unit) = text.split_at(end);
    match digits.parse() {
        Ok(value) => Ok((value, unit.to_owned())),
        Err(_) => Err(format!("{text:?} is no number")),
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{
        Action, Event, Feed, FeedRate, FeedUnit, Length, Motion, Place, ReadingSet, RuleSet,
    };

    use super::Figure;

    /// 131.244 mm at 117 mm/min.
    fn trace() -> [Event; 1] {
        let action = Action::Linear {
            motion: Motion::default(),
            feed: Feed { value: FeedRate(117_000_000_000), unit: FeedUnit::PerMinute },
            path: Length(131_244_047),
        };
        let (block, rules, readings) = (Place::default(), RuleSet::EMPTY, ReadingSet::default());
        [Event::new(1, block, rules, readings, action)]
    }

    fn figure(field: &str, value: &str, tolerance: &str) -> Figure {
        let (field, value, tolerance) = (field.to_owned(), value.to_owned(), tolerance.to_owned());
        Figure { what: "figure".to_owned(), event: Some(1), since: None, field, value, tolerance }
    }

    #[test]
    fn a_figure_holds_within_its_tolerance() {
        assert_eq!(figure("f", "117mm/min", "0").check(&trace()), Ok(()));
        assert_eq!(figure("path", "131.2", "0.05").check(&trace()), Ok(()));
        assert_eq!(figure("path/f", "1.12", "0.005").check(&trace()), Ok(()));
        assert_eq!(figure("path*f/f", "131.2", "0.05").check(&trace()), Ok(()));
    }

    #[test]
    fn a_wrong_or_malformed_figure_is_reported() {
        for (field, value, tolerance) in [
            ("path", "131.3", "0.05"),
            ("f", "117mm/rev", "0"),
            ("f", "117", "0"),
            ("dwell", "1", "0"),
            ("", "1", "0"),
            ("path/", "1", "0"),
            ("path", "many", "0"),
        ] {
            assert!(figure(field, value, tolerance).check(&trace()).is_err(), "{field} {value}");
        }
        assert!(Figure { event: Some(2), ..figure("f", "117mm/min", "0") }.check(&trace()).is_err());
    }

    #[test]
    fn a_figure_that_no_trace_shows_asserts_nothing() {
        assert_eq!(Figure { event: None, ..figure("", "44.7", "0.05") }.check(&trace()), Ok(()));
    }
}

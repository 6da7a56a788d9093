//! Traces survive their formats: JSON, JSON Lines, compact notation; and any bytes may be read as an event.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{Action, Event, Value, notation};

use crate::differential::show;
use crate::shape::trace;
use crate::{Verdict, require};

/// A trace that is written as JSON Lines and read back is the same, to the last bit of a real value; a line
/// holds one event. The compact notation of an event matches it, alone and as part of the whole trace, and
/// holds every number that its JSON holds; of two neighbours that match each other's notation the actions,
/// lines, rules and readings are equal. Any bytes can be offered to the reader of events: what it takes can
/// be written, reads back as the same event, and has a compact notation that matches it.
///
/// Rules: none (the form of the trace)
pub(crate) fn traces_read_back(input: &[u8]) -> Verdict {
    input.split(|byte| *byte == b'\n').try_for_each(any_line)?;
    let Ok(case) = Case::arbitrary(&mut Unstructured::new(input)) else { return Ok(()) };
    let trace = trace(&case);
    let fail = |message: String| format!("{message}\n{}", show(&case));
    lines(&trace).and_then(|()| compact(&trace)).map_err(fail)
}

fn any_line(line: &[u8]) -> Verdict {
    match serde_json::from_slice::<Event>(line) {
        Ok(event) => reads_back(&event).and_then(|()| matches_itself(&event)),
        Err(_) => Ok(()),
    }
}

fn text(event: &Event) -> Result<String, String> {
    serde_json::to_string(event).map_err(|error| format!("cannot write {event:?}: {error}"))
}

fn reads_back(event: &Event) -> Verdict {
    let line = text(event)?;
    let again: Event = serde_json::from_str(&line).map_err(|error| format!("{line}: {error}"))?;
    require(same(event, &again), || format!("{event:?} is read back as {again:?}"))
}

/// Whether two events are the same, signs of zero included.
fn same(one: &Event, other: &Event) -> bool {
    let bits = |event: &Event| match event.action {
        Action::Variable { value: Value::Real(real), .. } => real.to_bits(),
        _ => 0,
    };
    one == other && bits(one) == bits(other)
}

fn lines(trace: &[Event]) -> Verdict {
    let mut written = String::new();
    for event in trace {
        written.push_str(&text(event)?);
        written.push('\n');
    }
    let read: Result<Vec<Event>, _> = written.lines().map(serde_json::from_str::<Event>).collect();
    let read = read.map_err(|error| format!("{error}\n{written}"))?;
    require(read.len() == trace.len(), || format!("{} events in {} lines", trace.len(), read.len()))?;
    let unlike = trace.iter().zip(&read).find(|(before, after)| !same(before, after));
    unlike.map_or(Ok(()), |(before, after)| Err(format!("{before:?} is read back as {after:?}")))
}

fn compact(trace: &[Event]) -> Verdict {
    let whole: Vec<String> = trace.iter().map(notation::render).collect();
    notation::Expectation::parse(&whole.join("\n")).matches(trace)?;
    for event in trace {
        matches_itself(event)?;
        is_complete(event, &notation::fields(event))?;
    }
    for pair in trace.windows(2) {
        if let [one, other] = pair {
            tells_apart(one, other)?;
        }
    }
    Ok(())
}

fn matches_itself(event: &Event) -> Verdict {
    notation::Expectation::parse(&notation::render(event)).matches(std::slice::from_ref(event))
}

/// Every number of the event's JSON, its place, ordinal, rules and readings aside, stands in these fields.
fn is_complete(event: &Event, fields: &[(&str, String)]) -> Verdict {
    let unitless =
        |text: &str| text.trim_end_matches("mm/rev").trim_end_matches("mm/min").parse::<f64>().ok();
    let mut shown: Vec<f64> = fields.iter().filter_map(|(_, value)| unitless(value)).collect();
    let json = serde_json::to_value(event).map_err(|error| error.to_string())?;
    let mut open: Vec<&serde_json::Value> = Vec::new();
    let apart = ["n", "block", "rules", "readings"];
    let parts = json.as_object().into_iter().flatten().filter(|(key, _)| !apart.contains(&key.as_str()));
    open.extend(parts.map(|(_, value)| value));
    while let Some(value) = open.pop() {
        let number = match value {
            serde_json::Value::Object(parts) => {
                open.extend(parts.values());
                None
            }
            serde_json::Value::Number(number) => number.as_f64(),
            serde_json::Value::String(text) => text.parse().ok(),
            _ => None,
        };
        let Some(number) = number else { continue };
        let place = shown.iter().position(|shown| shown.to_bits() == f64::to_bits(number));
        let place = place.ok_or_else(|| format!("{number} is not in the notation of {event:?}"))?;
        shown.swap_remove(place);
    }
    Ok(())
}

/// Events that satisfy each other's lines say the same.
fn tells_apart(one: &Event, other: &Event) -> Verdict {
    let satisfies = |line: &Event, event: &Event| {
        notation::Expectation::parse(&notation::render(line)).matches(std::slice::from_ref(event)).is_ok()
    };
    let alike = one.action == other.action
        && one.block.line == other.block.line
        && one.rules == other.rules
        && one.readings == other.readings;
    require(alike || !satisfies(one, other) || !satisfies(other, one), || {
        format!("one notation for {one:?} and {other:?}")
    })
}

#[cfg(test)]
mod tests {
    use super::{is_complete, same, tells_apart};
    use turnspec_generator::Case;
    use turnspec_oracle::vocabulary::{Action, Event, Setup, Value, notation};

    use crate::shape::trace;

    fn one_event(program: &str) -> Event {
        trace(&Case { setup: Setup::default(), program: program.as_bytes().to_vec() })[0]
    }

    #[test]
    fn zeros_of_different_sign_are_different() {
        let plus = one_event("V1=0\nM02");
        let Action::Variable { name, .. } = plus.action else { unreachable!("{plus:?}") };
        let minus = Event { action: Action::Variable { name, value: Value::Real(-0.0) }, ..plus };
        assert!(same(&plus, &plus) && !same(&plus, &minus));
    }

    #[test]
    fn different_events_have_different_notations() {
        let (one, other) = (one_event("G00 X1\nM02"), one_event("G00 X2\nM02"));
        assert_eq!(tells_apart(&one, &other), Ok(()));
    }

    #[test]
    fn a_field_that_is_left_out_is_noticed() {
        let event = one_event("G00 X1 Z-2.5\nM02");
        let mut fields = notation::fields(&event);
        assert_eq!(is_complete(&event, &fields), Ok(()));
        fields.retain(|(key, _)| *key != "mz");
        assert!(is_complete(&event, &fields).is_err());
    }
}

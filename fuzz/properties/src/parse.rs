//! The readers of text: places lie in the text and in order, faults are found, the readers agree.

use std::collections::BTreeSet;
use std::ops::Range;

use turnspec::engine::count_blocks;
use turnspec_generator::Case;
use turnspec_oracle::syntax::{Body, Source, parse};
use turnspec_oracle::vocabulary::{Label, Place};
use turnspec_oracle::{Diagnostic, check};

use crate::differential::show;
use crate::shape::{is_alarm, trace};
use crate::{Verdict, require};

/// Any bytes through the readers of text, after a set-up that the first ones choose.
///
/// The oracle's reader cuts the text into blocks whose byte spans lie in the text, one after the other, and
/// whose line numbers rise; the spans of the items of a block lie in its span, one after the other. The
/// engine's reader accepts as many blocks, statements among them, up to the first fault. `check` finds no fault exactly
/// when the run has no alarm, else the alarm of the run is among them; its faults stand at places in the text. (A fault of something that is missing at the end of the text points at
/// the one place behind it. Where there is a library the place may be in its files.)
///
/// Rules: E100L-FMT-01, E100L-FMT-04, E100L-FMT-05, E100L-AEXP-12, E100L-CMT-01, E100L-DEL-01, E100L-NAME-01,
/// E100L-SEQ-01, E100L-SEQ-03, E100L-TAPE-01, E100L-TAPE-04
pub(crate) fn texts_are_read_in_order(input: &[u8]) -> Verdict {
    let case = Case::from_raw(input);
    blocks(&case).and_then(|()| faults(&case)).map_err(|message| format!("{message}\n{}", show(&case)))
}

/// Reads every block as one of a main program; the engine accepts as many up to the first fault, unless the text is a
/// schedule program, whose blocks have other words.
fn blocks(case: &Case) -> Verdict {
    let mut source = Source::new(&case.program, case.setup.tape.code);
    let is_schedule = source.header_of_schedule().unwrap_or(case.setup.schedule);
    let mut accepted = Some(Accepted::default());
    let (mut end, mut line) = (0, 0);
    let mut count = 0;
    loop {
        let text = match source.next_line() {
            Ok(Some(text)) => text,
            Ok(None) => break,
            // A faulty header; what follows is read all the same.
            Err(_) => {
                accepted = None;
                continue;
            }
        };
        let place = text.place;
        let in_order = end <= place.start && place.start <= place.end && line < place.line;
        require(in_order, || format!("a block at {}..{} after {end}", place.start, place.end))?;
        require(place.end as usize <= case.program.len(), || format!("a block ends at {}", place.end))?;
        (end, line) = (place.end, place.line);
        let mut sequence = Label::default();
        let body = parse(&text, &case.setup, &mut sequence).map(|block| block.body).ok();
        if let Some(Body::Items(items) | Body::Noex(items) | Body::ContourCall(_, items)) = &body {
            in_block(items.iter().map(|item| item.span.clone()), place)?;
        }
        accepted = accepted.and_then(|before| before.with(body.as_ref(), sequence));
        count = accepted.as_ref().map_or(count, |accepted| accepted.count);
    }
    if is_schedule {
        return Ok(());
    }
    let engine = count_blocks(&case.program, &case.setup);
    require(engine == count, || format!("the oracle reads {count} blocks without fault, the engine {engine}"))
}

/// The blocks before the first fault.
#[derive(Default)]
struct Accepted {
    count: u64,
    began: bool,
    names: BTreeSet<Label>,
}

impl Accepted {
    /// With one block more; none when it is at fault (E100L-SEQ-03, E100L-PROG-02).
    fn with(mut self, body: Option<&Body>, sequence: Label) -> Option<Self> {
        let body = body?;
        if !sequence.is_empty() && !self.names.insert(sequence)
            || self.began && matches!(body, Body::ProgramName(_))
        {
            return None;
        }
        self.began |= *body != Body::Empty;
        self.count += u64::from(matches!(
            body,
            Body::Items(_)
                | Body::Noex(_)
                | Body::ContourCall(..)
                | Body::Statement(_)
                | Body::Communication(_)
        ));
        Some(self)
    }
}

fn in_block(spans: impl Iterator<Item = Range<u32>>, place: Place) -> Verdict {
    let mut end = place.start;
    for span in spans {
        require(end <= span.start && span.start < span.end && span.end <= place.end, || {
            format!("an item at {span:?} after {end} in the block {}..{}", place.start, place.end)
        })?;
        end = span.end;
    }
    Ok(())
}

fn faults(case: &Case) -> Verdict {
    let found = check(&case.program, &case.setup);
    let trace = trace(case);
    let alarm = trace.last().filter(|event| is_alarm(event));
    require(found.is_empty() == alarm.is_none(), || format!("{alarm:?}, but check finds {found:?}"))?;
    if let Some(alarm) = alarm {
        let is_known = |fault: &Diagnostic| {
            turnspec_oracle::vocabulary::Action::Alarm(fault.alarm) == alarm.action
                && fault.block.start == alarm.block.start
        };
        require(found.iter().any(is_known), || format!("check does not find {alarm:?}"))?;
    }
    let length = u32::try_from(case.program.len()).unwrap_or(u32::MAX);
    for fault in &found {
        let Diagnostic { block, span, .. } = fault;
        let inside = span.end <= length || span.start == length && span.end == length + 1;
        let ordered = block.start <= block.end && block.end <= length && span.start <= span.end;
        let in_the_library = !case.setup.library.is_empty();
        require(in_the_library || inside && ordered, || format!("{fault:?} in a text of {length} bytes"))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::in_block;
    use turnspec_oracle::vocabulary::Place;

    #[test]
    fn spans_out_of_order_or_outside_are_noticed() {
        let place = Place { start: 10, end: 20, ..Place::default() };
        let verdict = |spans: &[(u32, u32)]| in_block(spans.iter().map(|(start, end)| *start..*end), place);
        assert_eq!(verdict(&[(10, 12), (12, 20)]), Ok(()));
        for wrong in [[(9, 12), (12, 20)], [(10, 13), (12, 20)], [(10, 12), (12, 21)], [(10, 10), (12, 20)]] {
            assert!(verdict(&wrong).is_err(), "{wrong:?}");
        }
    }
}

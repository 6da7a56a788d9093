//! Which event of a trace belongs to which line of an expected trace, when a line may stand for any number of
//! events.
//!
//! The gaps cut the lines into runs of lines that must match events in a row. The first run stands at the
//! beginning, the last at the end, every other one at the first place where it fits: if any placement fits,
//! this one does.

use std::ops::Range;

/// Where a trace leaves the expectation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Break {
    /// Index of the line that no event satisfies; none when an event is left over.
    pub line: Option<usize>,
    /// Index of the event that should have satisfied the line, or is left over; none when there is none.
    pub event: Option<usize>,
}

/// Pairs lines, of which the gaps are `None`, with events: the index of each other line and of its event.
///
/// # Errors
/// The first line without event, or the first event without line.
pub fn align<L>(
    lines: &[Option<L>],
    events: usize,
    fits: impl Fn(&L, usize) -> bool,
) -> Result<Vec<(usize, usize)>, Break> {
    let matched = |run: &Range<usize>, start: usize| {
        let wanted = lines.get(run.clone()).unwrap_or_default().iter().flatten();
        wanted.zip(start..events).take_while(|(line, event)| fits(line, *event)).count()
    };
    let runs = runs(lines);
    let mut pairs = Vec::new();
    let mut next = 0;
    for (number, run) in runs.iter().enumerate() {
        let count = |start: usize| matched(run, start);
        let start = if number == 0 {
            0
        } else if number + 1 == runs.len() {
            let end = events.saturating_sub(run.len()).max(next);
            if count(end) == run.len() { end } else { best_place(next..events, &count).unwrap_or(end) }
        } else {
            let first = (next..=events).find(|start| count(*start) == run.len());
            match first.or_else(|| best_place(next..events, &count)) {
                Some(start) => start,
                None => return Err(Break { line: Some(run.start), event: None }),
            }
        };
        let count = count(start);
        if count < run.len() {
            let event = Some(start + count).filter(|event| *event < events);
            return Err(Break { line: Some(run.start + count), event });
        }
        pairs.extend(run.clone().zip(start..));
        next = start + run.len();
    }
    if next < events { Err(Break { line: None, event: Some(next) }) } else { Ok(pairs) }
}

/// The runs of lines between the gaps, empty ones at the beginning and the end included.
fn runs<L>(lines: &[Option<L>]) -> Vec<Range<usize>> {
    let mut runs = Vec::new();
    let mut start = 0;
    for (index, _) in lines.iter().enumerate().filter(|(_, line)| line.is_none()) {
        if start == 0 || index > start {
            runs.push(start..index);
        }
        start = index + 1;
    }
    runs.push(start..lines.len());
    runs
}

/// The last of the places where most lines match, at least one.
fn best_place(places: Range<usize>, count: &impl Fn(usize) -> usize) -> Option<usize> {
    places.map(|start| (count(start), start)).filter(|(count, _)| *count > 0).max().map(|(_, start)| start)
}

#[cfg(test)]
mod tests {
    use super::{Break, align};

    /// Lines are letters, `.` is a gap; events are letters.
    fn outcome(lines: &str, events: &str) -> Result<Vec<(usize, usize)>, Break> {
        let lines: Vec<Option<char>> =
            lines.chars().map(|each| Some(each).filter(|each| *each != '.')).collect();
        let events: Vec<char> = events.chars().collect();
        align(&lines, events.len(), |line, event| events[event] == *line)
    }

    fn broken(line: Option<usize>, event: Option<usize>) -> Result<Vec<(usize, usize)>, Break> {
        Err(Break { line, event })
    }

    #[test]
    fn without_gaps_line_and_event_correspond() {
        assert_eq!(outcome("", ""), Ok(vec![]));
        assert_eq!(outcome("ab", "ab"), Ok(vec![(0, 0), (1, 1)]));
        assert_eq!(outcome("ab", "ac"), broken(Some(1), Some(1)));
        assert_eq!(outcome("ab", "a"), broken(Some(1), None));
        assert_eq!(outcome("a", "ab"), broken(None, Some(1)));
    }

    #[test]
    fn a_gap_is_any_number_of_events() {
        for (lines, events) in [
            (".", ""),
            (".", "xyz"),
            ("..", "xyz"),
            ("a.", "a"),
            ("a.b", "ab"),
            ("a.b", "axyb"),
            (".b.", "xbx"),
            (".ab.c", "aabac"),
            (".ab", "abxab"),
            ("a..b.", "axbx"),
            (".a.ab", "aab"),
        ] {
            assert!(outcome(lines, events).is_ok(), "{lines} {events}");
        }
        assert_eq!(outcome(".ab.c", "aabac"), Ok(vec![(1, 1), (2, 2), (4, 4)]));
    }

    #[test]
    fn the_place_of_a_break_is_where_most_lines_match() {
        assert_eq!(outcome(".ab", "xabx"), broken(None, Some(3)));
        assert_eq!(outcome(".abc.d", "aabxd"), broken(Some(3), Some(3)));
        assert_eq!(outcome(".ab", "xa"), broken(Some(2), None));
        assert_eq!(outcome(".b.", "xyz"), broken(Some(1), None));
        assert_eq!(outcome(".a.ab", "ab"), broken(Some(3), Some(1)));
    }
}

//! How a text is divided into the programs of two sides (E100L-AX4-01 to E100L-AX4-03).

use std::sync::Arc;

use turnspec_oracle::vocabulary::Side;

use crate::engine::parse::{Options, Parser};
use crate::engine::text::{Lines, Part, Reader};
use crate::engine::turrets::lone_turret_code;
use crate::engine::words::Parsed;

use super::Both;

/// The parts of a text.
#[derive(Debug, Default)]
pub struct Division {
    /// What stands before the first selection block.
    pub head: Arc<[Part]>,
    /// The portions of each side; none if the text has no selection block.
    pub sides: Option<Both<Arc<[Part]>>>,
    /// Whether a side has a block that counts.
    pub counts: Both<bool>,
    /// Whether the text begins with the header of a schedule program, whatever else is wrong with that.
    pub schedule: bool,
    /// The line of the end of the text.
    pub last_line: u32,
}

/// What a block is to the division.
enum Block {
    Selection(Side),
    /// It counts (E100L-PSYNC-04).
    Counts,
    Idle,
}

impl Division {
    /// Divides the text from where a reader stands. What is wrong with a block is not found here.
    pub fn new(mut reader: Reader, options: Options) -> Self {
        let mut division = Self::default();
        let mut sides = Both::<Vec<Part>>::default();
        let (mut parsed, mut buffer) = (Parsed::default(), Vec::new());
        let mut side = None;
        let mut start = reader.mark();
        while let Some(lines) = reader.next_lines() {
            if reader.is_no_block(lines) {
                division.schedule |= reader.names_schedule(lines);
                continue;
            }
            match (classify(&reader, lines, options, &mut parsed, &mut buffer), side) {
                (Block::Selection(selected), _) => {
                    division.add(Part { start, end: lines.start }, side, &mut sides);
                    side = Some(selected);
                    start = reader.mark();
                }
                (Block::Counts, Some(side)) => *division.counts.of_mut(side) = true,
                (Block::Counts, None) | (Block::Idle, _) => {}
            }
        }
        division.add(Part { start, end: reader.length() }, side, &mut sides);
        division.last_line = reader.last_line();
        division.sides = side.map(|_| Both { a: sides.a.into(), b: sides.b.into() });
        division
    }

    /// A part that ends.
    fn add(&mut self, part: Part, side: Option<Side>, sides: &mut Both<Vec<Part>>) {
        match side {
            None => self.head = Arc::new([part]),
            Some(side) => sides.of_mut(side).push(part),
        }
    }
}

fn classify(
    reader: &Reader,
    lines: Lines,
    options: Options,
    parsed: &mut Parsed,
    buffer: &mut Vec<u8>,
) -> Block {
    parsed.clear();
    let text = reader.characters(lines, buffer).ok().filter(|_| !lines.stray);
    let sound = text.is_some_and(|text| Parser { text, at: 0, options, block: parsed }.parse().is_ok());
    if !sound || parsed.program.is_some() {
        return Block::Counts;
    }
    match lone_turret_code(parsed) {
        _ if parsed.skipped => Block::Idle,
        Some(13) => Block::Selection(Side::A),
        Some(_) => Block::Selection(Side::B),
        None if parsed.is_only_name() => Block::Idle,
        None => Block::Counts,
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Setup, Side, TapeCode};

    use super::Division;
    use crate::engine::parse::Options;
    use crate::engine::text::Reader;

    fn division(text: &str) -> (Division, Reader<'_>) {
        let setup = Setup::from_toml("machine.type = \"2S\"").unwrap_or_default();
        let reader = Reader::new(text.as_bytes(), TapeCode::Ascii);
        (Division::new(reader.clone(), Options::new(&setup)), reader)
    }

    fn lines(text: &str, side: Side) -> Vec<u32> {
        let (division, mut reader) = division(text);
        let Some(sides) = division.sides else { return Vec::new() };
        reader.confine(sides.of(side).clone());
        std::iter::from_fn(|| reader.next_lines()).map(|lines| lines.line).collect()
    }

    #[test]
    fn portions_follow_each_other() {
        let text = "O1\nG13\nX1\n$Y1\nN1 G14 (B)\n\nX2\n/G=13\nX3\nG14\nG14\nX4";
        assert_eq!(lines(text, Side::A), [3, 9]);
        assert_eq!(lines(text, Side::B), [6, 7, 12]);
        let (division, _) = division(text);
        assert!(division.counts.a && division.counts.b);
        assert_eq!(division.last_line, 12);
    }

    #[test]
    fn other_words_select_nothing() {
        for text in ["G13 X1\nX2\n", "G=10+3\nX2\n", "G13 G13\nX2\n", "NOEX G13\nX2\n", "G13 &\nX2\n", ""] {
            assert!(division(text).0.sides.is_none(), "{text}");
        }
    }

    #[test]
    fn headers_name_schedules() {
        for (text, schedule) in [
            ("$JOB.SDF%\nEND\n", true),
            ("$JOB.SDF\nEND\n", true),
            ("$A.B.SDF1%\n", true),
            ("$JOB.SDFX%\n", false),
            ("$SDF%\n", false),
            ("$JOB.MIN%\n", false),
            ("G13\n$JOB.SDF%\n", false),
        ] {
            assert_eq!(division(text).0.schedule, schedule, "{text}");
        }
    }

    #[test]
    fn some_blocks_do_not_count() {
        let counts = |text: &str| division(&format!("G13\n{text}\nG14\n")).0.counts.a;
        for idle in ["", "(A)", "N1", "/", "N1 (A) \n%"] {
            assert!(!counts(idle), "{idle}");
        }
        for counted in ["M08", "&", "N1 G14 X1", "O1", "GOTO N1"] {
            assert!(counts(counted), "{counted}");
        }
    }
}

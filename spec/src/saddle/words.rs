//! Common words: the commands of the spindle that both sides share (E100L-AX4-06, E100L-AX4-07).

use std::collections::BTreeSet;

use crate::modal::Words;

/// Who carries the common words of a block out.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Commands {
    /// The block, for itself.
    #[default]
    Own,
    /// The block, for another one that starts together with it (E100L-AX4-06).
    ForBoth,
    /// The other one.
    ByOther,
}

/// The common words of a block.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CommonWords {
    g: BTreeSet<u16>,
    m: BTreeSet<u16>,
    /// S, and whether G50 makes it the clamp.
    speed: Option<(i64, bool)>,
}

impl CommonWords {
    /// Those of a block.
    pub fn of(words: &Words) -> Self {
        Self {
            g: words.g.iter().copied().filter(|code| is_common_g(*code)).collect(),
            m: words.m.iter().copied().filter(|code| is_common_m(*code)).collect(),
            speed: words.get('S').map(|speed| (speed, words.has_g(50))),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.g.is_empty() && self.m.is_empty() && self.speed.is_none()
    }
}

/// Whether a G code commands the common spindle.
pub fn is_common_g(code: u16) -> bool {
    matches!(code, 96 | 97 | 110 | 111)
}

/// Whether an M code commands the common spindle, or stops both sides.
pub fn is_common_m(code: u16) -> bool {
    matches!(code, 0 | 1 | 3 | 4 | 5 | 19 | 40..=44)
}

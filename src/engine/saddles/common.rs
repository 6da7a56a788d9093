//! The words that both sides command together (E100L-AX4-06).

use crate::engine::words::{Address, Words};

/// G codes of the main spindle.
const G: [u16; 4] = [96, 97, 110, 111];
/// M codes that stop both sides, and those of the main spindle.
const M: [u16; 11] = [0, 1, 3, 4, 5, 19, 40, 41, 42, 43, 44];

/// The common words of a block.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct CommonWords {
    /// Which of [`G`] and [`M`] it has, each a bit.
    g: u16,
    m: u16,
    speed: Option<i64>,
    /// Whether the S word is the clamp of G50.
    clamp: bool,
}

impl CommonWords {
    /// Those of an evaluated block.
    pub fn of(words: &Words) -> Self {
        let speed = words.get(Address::S);
        Self {
            g: set(&G, words.g_codes()),
            m: set(&M, words.m_codes()),
            speed,
            clamp: speed.is_some() && words.has_g(50),
        }
    }

    /// Whether there are none.
    pub fn is_empty(self) -> bool {
        self == Self::default()
    }
}

/// Whether a G code is a common word.
pub fn is_common_g(code: u16) -> bool {
    G.contains(&code)
}

/// Whether an M code commands the main spindle.
pub fn is_spindle_m(code: u16) -> bool {
    matches!(code, 3 | 4 | 5 | 19 | 40..=44)
}

/// Which of some codes are among others.
fn set(codes: &[u16], present: &[u16]) -> u16 {
    let has = |code: &u16| u16::from(present.contains(code));
    codes.iter().rev().fold(0, |set, code| set << 1 | has(code))
}

#[cfg(test)]
mod tests {
    use super::{CommonWords, G, M, set};
    use crate::engine::codes::{g_group, m_group_number};
    use crate::engine::words::{Address, Words};

    #[test]
    fn codes_are_a_set() {
        assert_eq!(set(&G, &[0, 111, 96]), 0b1001);
        assert_eq!(set(&G, &[96, 111]), 0b1001);
        assert_eq!(set(&M, &[44, 8]), 1 << 10);
        assert_eq!(set(&M, &[2, 30, 100]), 0);
    }

    #[test]
    fn the_order_of_words_does_not_count() {
        let words = |codes: &[u16], speed: Option<i64>| {
            let mut words = Words::default();
            for code in codes {
                words.add_m(*code, m_group_number(*code));
            }
            if let Some(speed) = speed {
                words.meet(Address::S);
                words.set(Address::S, speed);
            }
            words
        };
        let of = |codes: &[u16], speed| CommonWords::of(&words(codes, speed));
        assert_eq!(of(&[42, 3, 8], Some(100)), of(&[3, 42], Some(100)));
        assert_ne!(of(&[3], Some(100)), of(&[3], Some(101)));
        assert_ne!(of(&[3], Some(0)), of(&[3], None));
        assert!(of(&[8, 30, 100], None).is_empty());
        let mut clamp = words(&[], Some(100));
        assert!(g_group(50).is_some_and(|group| clamp.add_g(50, group)));
        assert_ne!(CommonWords::of(&clamp), of(&[], Some(100)));
    }
}

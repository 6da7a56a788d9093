//! Theorems about the numbers of sequence names.

use turnspec::engine::arithmetic::sequence_name::index;

use crate::draw::between;
#[cfg(stand_in)]
use crate::kani;

/// Most characters of a name.
const LENGTH: usize = 5;
/// How many names there are: 10 + ... + 10^5 numerals, and 26 (1 + 36 + ... + 36^4) others.
const NAMES: usize = 111_110 + 26 * 1_727_605;

/// A name; what is behind its length does not count.
#[derive(Clone, Copy)]
struct Name {
    bytes: [u8; LENGTH],
    length: usize,
}

impl Name {
    fn text(&self) -> &[u8] {
        &self.bytes[..self.length]
    }
}

/// A capital letter or a digit.
fn character() -> u8 {
    let rank = u8::try_from(between(0, 35)).unwrap_or(0);
    if rank < 10 { b'0' + rank } else { b'A' + rank - 10 }
}

/// A valid name: all digits, or a letter and letters or digits.
fn name() -> Name {
    let bytes = [character(), character(), character(), character(), character()];
    let name = Name { bytes, length: usize::try_from(between(1, 5)).unwrap_or(1) };
    let text = name.text();
    kani::assume(text[0].is_ascii_uppercase() || text.iter().all(u8::is_ascii_digit));
    name
}

theorems! {
    /// Different names have different numbers: the engine compares numbers as texts are compared.
    /// Of: `sequence_name::index`
    /// Assumes: valid names of at most five characters.
    /// Rules: E100L-SEQ-01, E100L-SEQ-03, E100L-GOTO-02
    #[unwind(7)]
    fn every_name_has_its_own_number() {
        let one = name();
        let mut other = if kani::any() { name() } else { one };
        if kani::any() {
            other.bytes[other.length - 1] = character();
            let text = other.text();
            kani::assume(text[0].is_ascii_uppercase() || text.iter().all(u8::is_ascii_digit));
        }
        let same = one.text() == other.text();
        kani::cover!(same, "the same name");
        kani::cover!(!same && one.length == other.length && one.length > 1, "names of one length");
        kani::cover!(one.bytes[0] == b'0' && one.length < other.length, "a leading zero");
        assert!((index(one.text()) == index(other.text())) == same);
    }

    /// There are no more numbers than names: none is left out, and all fit 32 bits.
    /// Of: `sequence_name::index`
    /// Assumes: valid names of at most five characters.
    /// Rules: E100L-SEQ-01
    #[unwind(7)]
    fn there_are_as_many_numbers_as_names() {
        let name = name();
        let number = index(name.text());
        kani::cover!(number + 1 == NAMES || name.length == 5, "a long name");
        kani::cover!(name.bytes[0].is_ascii_digit(), "a numeral");
        assert!(number < NAMES && u32::try_from(number).is_ok());
        assert!((number < 111_110) == name.bytes[0].is_ascii_digit());
    }

    /// No text of eight bytes overflows, be it a name or not.
    /// Of: `sequence_name::index`
    /// Assumes: any bytes, any length up to 8.
    /// Rules: E100L-SEQ-01
    #[unwind(10)]
    fn no_name_overflows() {
        let bytes: [u8; 8] = kani::any();
        let length = usize::try_from(between(0, 8)).unwrap_or(0);
        kani::cover!(length == 8 && bytes[0] == u8::MAX, "no name at all");
        assert!(index(&bytes[..length]) < 1 << 48);
    }
}

refutations! {
    /// False: a leading zero does not matter.
    #[unwind(7)]
    fn names_are_compared_as_numbers() {
        let digit = b'0' + u8::try_from(between(0, 9)).unwrap_or(0);
        assert!(index(&[b'0', digit]) == index(&[digit]));
    }
}

//! Theorems about numbers that are taken apart into decimal digits: T words, binary-coded decimals.

use turnspec::engine::arithmetic::decimal_code::{MOST, number, pattern};
use turnspec::engine::arithmetic::tool::ToolWord;
use turnspec_oracle::integer;

use crate::draw::between;
#[cfg(stand_in)]
use crate::kani;

/// Largest T word.
const LARGEST: i64 = 999_999;

fn small(most: u32) -> u32 {
    u32::try_from(between(0, most.into())).unwrap_or(0)
}

/// Whether every nibble is a decimal digit.
fn is_decimal(pattern: u32) -> bool {
    (0..8).all(|place| pattern >> (4 * place) & 15 <= 9)
}

theorems! {
    /// The three numbers of a T word have two digits each and make up the word.
    /// Of: `ToolWord::new`
    /// Assumes: words of at most 999 999.
    /// Rules: E100L-TOOL-01, E100L-TOOL-02
    #[unwind(2)]
    fn a_tool_word_is_its_three_numbers() {
        let word = between(0, LARGEST);
        let ToolWord { nose, tool, offset } = ToolWord::new(word);
        kani::cover!(nose == 0 && tool == 0 && offset > 0, "a word of two digits");
        assert!(nose < 100 && tool < 100 && offset < 100);
        assert!(10_000 * i64::from(nose) + 100 * i64::from(tool) + i64::from(offset) == word);
    }

    /// No number makes a T word overflow.
    /// Of: `ToolWord::new`
    /// Assumes: any number.
    /// Rules: E100L-TOOL-01
    #[unwind(2)]
    fn no_tool_word_overflows() {
        let word: i64 = kani::any();
        kani::cover!(word == i64::MIN, "the least number");
        let ToolWord { nose, tool, offset } = ToolWord::new(word);
        assert!(nose < 100 && tool < 100 && offset < 100);
    }

    /// Engine and oracle take a T word apart alike.
    /// Of: `ToolWord::new`, `integer::tool::parts`
    /// Assumes: words of at most 999 999.
    /// Rules: E100L-TOOL-02
    #[unwind(2)]
    fn both_take_a_tool_word_apart_alike() {
        let word = between(0, LARGEST);
        let ToolWord { nose, tool, offset } = ToolWord::new(word);
        kani::cover!(word == LARGEST, "the largest word");
        assert!((nose, tool, offset) == integer::tool::parts(word));
    }

    /// The numbers of a T word exist exactly when offset and nose radius number are within the sets; the tool
    /// number does not matter.
    /// Of: `ToolWord::exists`
    /// Assumes: any numbers, any sets.
    /// Rules: E100L-TOOL-03
    #[unwind(2)]
    fn a_tool_word_names_sets_that_exist() {
        let (nose, tool, offset, sets): (u8, u8, u8, u8) = (kani::any(), kani::any(), kani::any(), kani::any());
        let exists = ToolWord { nose, tool, offset }.exists(sets);
        kani::cover!(exists && tool > sets, "a tool number beyond the sets");
        assert!(exists == (nose.max(offset) <= sets));
    }

    /// A pattern spells a number of at most eight digits, or none: exactly when a nibble is above 9.
    /// Of: `decimal_code::number`
    /// Assumes: any pattern.
    /// Rules: E100L-FUNC-10
    #[unwind(10)]
    fn a_pattern_spells_eight_digits() {
        let pattern: u32 = kani::any();
        kani::cover!(pattern > 9 && is_decimal(pattern), "a number of two digits");
        assert!(number(pattern).is_some() == is_decimal(pattern));
        assert!(number(pattern).is_none_or(|number| number <= MOST));
    }

    /// Every number has a pattern of decimal digits.
    /// Of: `decimal_code::pattern`
    /// Assumes: any number.
    /// Rules: E100L-FUNC-11
    #[unwind(10)]
    fn every_number_has_a_pattern() {
        let number: u32 = kani::any();
        kani::cover!(number == u32::MAX, "the largest number");
        assert!(is_decimal(pattern(number)));
    }

    /// The pattern of a number spells the number.
    /// Of: `decimal_code::number`, `decimal_code::pattern`
    /// Assumes: numbers of at most 999.
    /// Rules: E100L-FUNC-10, E100L-FUNC-11
    #[unwind(10)]
    fn pattern_and_number_correspond() {
        let value = small(999);
        kani::cover!(value > 99, "three digits");
        assert!(number(pattern(value)) == Some(value));
    }

    /// Engine and oracle read the same number in every pattern, and write the same pattern of a number.
    /// Of: `decimal_code::number`, `decimal_code::pattern`, `integer::decimal_code`
    /// Assumes: any pattern; numbers of at most 99.
    /// Rules: E100L-FUNC-10, E100L-FUNC-11
    #[unwind(10)]
    fn both_code_decimals_alike() {
        let (any, value) = (kani::any::<u32>(), small(99));
        kani::cover!(is_decimal(any) && any > 0, "a number");
        assert!(integer::decimal_code::from_nibbles(any) == number(any));
        assert!(integer::decimal_code::to_nibbles(value) == pattern(value));
    }
}

refutations! {
    /// False: every pattern spells a number.
    #[unwind(10)]
    fn every_pattern_is_a_number() {
        assert!(number(kani::any()).is_some());
    }

    /// False: the tool number is the last one of a T word.
    #[unwind(2)]
    fn the_tool_number_comes_last() {
        let word = between(0, LARGEST);
        assert!(i64::from(ToolWord::new(word).tool) == word % 100);
    }
}

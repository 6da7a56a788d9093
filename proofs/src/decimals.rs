//! Theorems about decimal numbers: reading plain numbers, and the text of quantities.

use turnspec::engine::arithmetic::digits::Digits;
use turnspec::engine::arithmetic::scale::TEN;
use turnspec_oracle::integer;
use turnspec_oracle::vocabulary::decimal::{self, Parts};

use crate::draw::{between, one_of};
#[cfg(stand_in)]
use crate::kani;

/// Characters of a number in these statements: 0 to 9 are digits, 10 is the point.
const POINT: u8 = 10;

/// Decimals of the quantities.
const DECIMALS: [u32; 3] = [3, 6, 9];

fn characters() -> [u8; 10] {
    let bytes: [u8; 10] = kani::any();
    bytes.map(|byte| byte % (POINT + 1))
}

/// A number as the engine reads it, a second point left out.
fn read(characters: &[u8]) -> Digits {
    let mut digits = Digits::default();
    for character in characters {
        if *character == POINT {
            digits.push_point();
        } else {
            digits.push(*character);
        }
    }
    digits
}

/// A number as the oracle reads it, a second point left out.
fn read_by_oracle(characters: &[u8]) -> integer::Digits {
    let mut digits = integer::Digits::default();
    for character in characters {
        if *character == POINT {
            digits.point = true;
        } else {
            digits = digits.digit(*character);
        }
    }
    digits
}

theorems! {
    /// Of any ten characters of a number, the value is below ten to the power of the digits written, at most
    /// eight of which count, and no more digits stand after the point than there are.
    /// Of: `Digits::push`, `Digits::push_point`
    /// Assumes: 10 characters.
    /// Rules: E100L-DEC-02, E100L-TYPE-02, E100L-TYPE-03
    #[unwind(12)]
    fn a_number_has_eight_digits_at_most() {
        let digits = read(&characters());
        kani::cover!(digits.written == 10, "ten digits");
        kani::cover!(digits.point && digits.scale == 8, "eight decimals");
        assert!(digits.value >= 0 && digits.value < TEN[digits.written.min(8) as usize]);
        assert!(u32::from(digits.scale) <= digits.written.min(8));
        assert!(digits.point || digits.scale == 0);
    }

    /// The value of four digits is the sum of their values by place.
    /// Of: `Digits::push`
    /// Assumes: 4 digits.
    /// Rules: E100L-DEC-02
    #[unwind(12)]
    fn a_number_is_the_sum_of_its_digits() {
        let [a, b, c, d, ..] = characters();
        kani::assume(a < POINT && b < POINT && c < POINT && d < POINT);
        kani::cover!(a == 9 && d == 9, "digits of 9");
        let sum = 1000 * i64::from(a) + 100 * i64::from(b) + 10 * i64::from(c) + i64::from(d);
        assert!(read(&[a, b, c, d]).value == sum);
    }

    /// After eight digits a further one is counted and changes nothing else, however many there are.
    /// Of: `Digits::push`
    /// Assumes: eight digits or more were read.
    /// Rules: E100L-DEC-04, E100L-TYPE-02, E100L-TYPE-03
    #[unwind(2)]
    fn digits_beyond_the_eighth_change_nothing() {
        let before = Digits {
            value: between(0, 99_999_999),
            scale: u8::try_from(between(0, 8)).unwrap_or(0),
            written: u32::try_from(between(8, u32::MAX.into())).unwrap_or(0),
            point: kani::any(),
        };
        kani::cover!(before.written == u32::MAX, "the count is at its end");
        let mut after = before;
        after.push(u8::try_from(between(0, 9)).unwrap_or(0));
        assert!(after.written >= before.written && after.written > 8);
        assert!(Digits { written: before.written, ..after } == before);
    }

    /// The scale of a number is the number of digits after its only point.
    /// Of: `Digits::push`, `Digits::push_point`
    /// Assumes: 3 digits before and 3 after the point.
    /// Rules: E100L-DEC-02, E100L-FMT-01
    #[unwind(12)]
    fn the_scale_counts_the_digits_after_the_point() {
        let all = characters();
        kani::assume(all[..6].iter().all(|character| *character < POINT));
        let [a, b, c, d, e, f, ..] = all;
        let number = read(&[a, b, c, POINT, d, e, f]);
        kani::cover!(f == 0, "a trailing zero");
        assert!(number.scale == 3 && number.written == 6 && number.point);
        assert!(number.value == read(&[a, b, c, d, e, f]).value);
        let mut again = number;
        assert!(!again.push_point() && again == number);
    }

    /// Of any ten characters of a number, the oracle's value is below 10^8 and its scale at most eight.
    /// Of: `integer::Digits::digit`
    /// Assumes: 10 characters.
    /// Rules: E100L-DEC-02, E100L-TYPE-02, E100L-TYPE-03
    #[unwind(12)]
    fn a_number_of_the_oracle_has_eight_digits_at_most() {
        let digits = read_by_oracle(&characters());
        kani::cover!(digits.count == 10, "ten digits");
        assert!((0..100_000_000).contains(&digits.number));
        assert!(digits.scale <= digits.count.min(8));
    }

    /// Engine and oracle read any ten characters of a number alike.
    /// Of: `Digits::push`, `integer::Digits::digit`
    /// Assumes: 10 characters.
    /// Rules: E100L-DEC-02, E100L-DEC-04, E100L-TYPE-02, E100L-TYPE-03
    #[unwind(12)]
    fn both_read_a_number_alike() {
        let text = characters();
        let (engine, oracle) = (read(&text), read_by_oracle(&text));
        kani::cover!(engine.written > 8, "more digits than allowed");
        kani::cover!(text[0] == POINT, "a point first");
        assert!(engine.value == oracle.number && u32::from(engine.scale) == oracle.scale);
        assert!(engine.written == oracle.count && engine.point == oracle.point);
    }

    /// Any ten bytes are read as decimal text without overflow; with a byte that is no digit, no point and no
    /// leading minus they are no number, nor with two points, nor without a digit.
    /// Of: `decimal::parse`
    /// Assumes: 10 bytes; 3, 6 or 9 decimals.
    /// Rules: none (the text of quantities in traces and set-ups)
    #[unwind(12)]
    fn no_text_overflows() {
        let mut text: [u8; 10] = kani::any();
        let decimals = one_of(&DECIMALS);
        if kani::any() {
            // Text that is nearly a number, so that samples reach further than its first byte.
            text = text.map(|byte| b".0123456789-"[usize::from(byte) % 12]);
        }
        let value = decimal::parse(&text, decimals);
        let fits = |place: usize| match text[place] {
            b'0'..=b'9' | b'.' => true,
            b'-' => place == 0,
            _ => false,
        };
        let points = text.iter().filter(|byte| **byte == b'.').count();
        kani::cover!(value.is_some_and(|value| value < 0), "a negative number");
        kani::cover!(value.is_none() && (0..10).all(fits) && points == 0, "a number that does not fit");
        assert!(value.is_none() || (0..10).all(fits) && points <= 1);
        assert!(text[0] != b'-' || value.is_none_or(|value| value <= 0));
    }

    /// The text of three digits means their number, scaled; a minus in front negates it.
    /// Of: `decimal::parse`
    /// Assumes: 3 digits, 6 decimals.
    /// Rules: none (the text of quantities in traces and set-ups)
    #[unwind(12)]
    fn whole_text_means_its_number() {
        let [a, b, c, ..] = characters();
        kani::assume(a < POINT && b < POINT && c < POINT);
        let number = 100 * i64::from(a) + 10 * i64::from(b) + i64::from(c);
        let [a, b, c] = [a, b, c].map(|digit| b'0' + digit);
        kani::cover!(number == 0, "zero");
        assert!(decimal::parse(&[a, b, c], 6) == Some(number * 1_000_000));
        assert!(decimal::parse(&[b'-', a, b, c], 6) == Some(-number * 1_000_000));
        assert!(decimal::parse(&[a, b'.', b, c], 6) == Some(number * 10_000));
    }

    /// Every value of a quantity has a text: its fraction has no more digits than the quantity has decimals.
    /// Of: `decimal::Parts::new`
    /// Assumes: any value; 3, 6 or 9 decimals.
    /// Rules: none (the text of quantities in traces and set-ups)
    #[unwind(12)]
    fn every_value_has_its_parts() {
        let value: i64 = kani::any();
        kani::cover!(value == i64::MIN, "the least value");
        for decimals in DECIMALS {
            let parts = Parts::new(value, decimals);
            assert!(parts.fraction < 10_u64.pow(decimals));
            assert!(parts.whole <= value.unsigned_abs() && parts.negative == (value < 0));
        }
    }

    /// The parts of a value make up the value again.
    /// Of: `decimal::Parts::new`
    /// Assumes: values of at most 10^5 in size, 3 decimals.
    /// Rules: none (the text of quantities in traces and set-ups)
    #[unwind(12)]
    fn parts_make_up_the_value() {
        let value = between(-100_000, 100_000);
        let Parts { negative, whole, fraction } = Parts::new(value, 3);
        kani::cover!(negative && whole == 0, "between -1 and 0");
        let size = i64::try_from(1000 * whole + fraction).unwrap_or(i64::MAX);
        assert!(value == if negative { -size } else { size });
    }
}

refutations! {
    /// False: a number of eight characters is below 10^7.
    #[unwind(12)]
    fn eight_characters_make_seven_digits() {
        assert!(read(&characters()[..8]).value < 10_000_000);
    }

    /// False: text of three bytes that is a number is not negative.
    #[unwind(12)]
    fn no_text_is_negative() {
        let [_, b, c, ..] = characters();
        let text = [one_of(b"-1"), b'0' + b % 10, b'0' + c % 10];
        assert!(decimal::parse(&text, 6).is_some_and(|value| value >= 0));
    }
}

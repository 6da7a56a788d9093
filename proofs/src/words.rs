//! Theorems about the conversion of plain numbers: comparison with a range, whole increments.

use turnspec::engine::arithmetic::round::Rounding;
use turnspec::engine::arithmetic::scale::{compare, increments};
use turnspec::engine::arithmetic::units::Units;
use turnspec_oracle::vocabulary::UnitSystem;

use crate::draw::{between, one_of, within};
#[cfg(stand_in)]
use crate::kani;
use crate::units::SYSTEMS;

const RULES: [Rounding; 3] = [Rounding::HalfAway, Rounding::Cut, Rounding::Up];

/// Bound of units and ranges.
const ROOM: i64 = 1 << 60;

/// Any number of eight digits.
fn digits() -> i64 {
    within(99_999_999)
}

fn scale(most: i64) -> u8 {
    u8::try_from(between(0, most)).unwrap_or(0)
}

theorems! {
    /// The comparison of a number with its range never overflows, and zero lies where it should.
    /// Of: `scale::compare`
    /// Assumes: any digits, at most 18 decimals, unit and bound of at most 2^60 in size.
    /// Rules: E100L-ADDR-01
    #[unwind(2)]
    fn no_comparison_overflows() {
        let (digits, scale): (i64, u8) = (kani::any(), scale(18));
        let (unit, bound) = (within(ROOM), within(ROOM));
        kani::cover!(digits == i64::MIN && scale == 18, "the extremes");
        let result = compare(digits, scale, unit, bound);
        assert!(digits != 0 && unit != 0 || result == 0.cmp(&bound));
    }

    /// A number without decimals and unit compares as the whole number that it is.
    /// Of: `scale::compare`
    /// Assumes: any digits, a bound of at most 2^60 in size.
    /// Rules: E100L-ADDR-01, E100L-DEC-02
    #[unwind(2)]
    fn whole_numbers_compare_as_such() {
        let (digits, bound) = (kani::any::<i64>(), within(ROOM));
        kani::cover!(digits == bound, "the bound itself");
        assert!(compare(digits, 0, 1, bound) == digits.cmp(&bound));
    }

    /// A trailing zero after the point does not change how a number compares.
    /// Of: `scale::compare`
    /// Assumes: digits of at most 128 in size, at most 3 decimals, bounds of at most 1000 in size, the unit 1000.
    /// Rules: E100L-DEC-02, E100L-ADDR-01
    #[unwind(6)]
    fn a_trailing_zero_compares_alike() {
        let (digits, bound) = (i64::from(kani::any::<i8>()), within(1000));
        kani::cover!(digits < 0, "a negative number");
        for scale in 0..3 {
            assert!(compare(digits, scale, 1000, bound) == compare(10 * digits, scale + 1, 1000, bound));
        }
    }

    /// Every number of eight digits, at every scale and in every unit system, converts to whole increments within
    /// 64 bits.
    /// Of: `scale::increments`
    /// Assumes: at most eight digits; the increments 1, 1000 and 2540.
    /// Rules: E100L-DEC-01, E100L-DEC-03, E100L-ADDR-01, E100L-INCH-02
    #[unwind(11)]
    fn every_word_converts() {
        let (digits, rule) = (digits(), one_of(&RULES));
        let unit = Units::new(one_of(&SYSTEMS)).length;
        kani::cover!(digits == -99_999_999 && unit == 25_400_000, "the largest inch");
        for scale in 0..=8 {
            for increment in [1, 1000, 2540] {
                let count = increments(digits, scale, unit, increment, rule);
                assert!(count.is_some());
            }
        }
    }

    /// Any digits and unit either convert or are left to the wide way, never wrapped: without decimals and
    /// increment the result is the product.
    /// Of: `scale::increments`
    /// Assumes: any digits, any unit.
    /// Rules: E100L-DEC-01
    #[unwind(2)]
    fn no_conversion_wraps() {
        let (digits, unit) = (kani::any::<i64>(), kani::any::<i64>());
        let count = increments(digits, 0, unit, 1, one_of(&RULES));
        kani::cover!(count.is_none(), "beyond 64 bits");
        kani::cover!(count.is_some_and(|count| count < 0), "within 64 bits");
        assert!(count == digits.checked_mul(unit));
    }

    /// A trailing zero after the point does not change what a number converts to.
    /// Of: `scale::increments`
    /// Assumes: digits of at most 100 in size, at most 3 decimals, millimetres to micrometres.
    /// Rules: E100L-DEC-02, E100L-DEC-03
    #[unwind(6)]
    fn a_trailing_zero_converts_alike() {
        let (digits, rule) = (within(100), one_of(&RULES));
        kani::cover!(digits < 0, "a negative number");
        for scale in 0..3 {
            let unit = 1_000_000;
            assert!(
                increments(digits, scale, unit, 1000, rule) == increments(10 * digits, scale + 1, unit, 1000, rule)
            );
        }
    }

    /// The fourth decimal of a millimetre is rounded, as the last digit of a whole number is by ten.
    /// Of: `scale::increments`
    /// Assumes: digits of at most 1000 in size.
    /// Rules: E100L-DEC-03
    #[unwind(2)]
    fn the_fourth_decimal_is_rounded() {
        let (digits, rule) = (within(1000), one_of(&RULES));
        kani::cover!(digits % 10 == -5, "a negative tie");
        assert!(increments(digits, 4, 1_000_000, 1000, rule) == Some(rule.divide_narrow(digits, 10)));
    }

    /// Where the engine takes a plain length without rounding, rounding would not change it.
    /// Of: `Units::new`, `scale::increments`
    /// Assumes: digits of at most 100 in size, at most 3 decimals, the metric systems.
    /// Rules: E100L-DEC-01, E100L-DEC-03
    #[unwind(11)]
    fn an_exact_length_needs_no_rounding() {
        let digits = within(100);
        kani::cover!(digits < 0, "a negative length");
        for system in [UnitSystem::Micrometre, UnitSystem::TenMicrometre, UnitSystem::Millimetre] {
            let units = Units::new(system);
            for (scale, last) in (0..4).zip(units.last_digit) {
                let rounded = increments(digits, scale, units.length, 1000, Rounding::HalfAway);
                assert!(last == 0 || rounded.map(|count| 1000 * count) == Some(digits * last));
            }
        }
    }
}

refutations! {
    /// False: a length is as long cut as rounded.
    #[unwind(2)]
    fn a_cut_length_is_a_rounded_one() {
        let digits = within(10_000);
        let of = |rule| increments(digits, 4, 1_000_000, 1000, rule);
        assert!(of(Rounding::Cut) == of(Rounding::HalfAway));
    }

    /// False: every product of digits and unit fits 64 bits.
    #[unwind(2)]
    fn every_product_fits() {
        assert!(increments(kani::any(), 0, kani::any(), 1, Rounding::Cut).is_some());
    }
}

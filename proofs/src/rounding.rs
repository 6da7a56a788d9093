//! Theorems about rounding to whole numbers.

use turnspec::engine::arithmetic::round::Rounding;

use crate::draw::{between, one_of, within, within_wide};
#[cfg(stand_in)]
use crate::kani;

const RULES: [Rounding; 3] = [Rounding::HalfAway, Rounding::Cut, Rounding::Up];

/// Any division: a divisor, a rest below it, a quotient of the same sign.
struct Division {
    quotient: i64,
    rest: i64,
    divisor: i64,
}

fn division() -> Division {
    let divisor = between(1, i64::MAX);
    let rest = match kani::any::<u8>() % 4 {
        0 => divisor >> 1,
        1 => -(divisor >> 1),
        _ => within(i64::MAX),
    };
    kani::assume(-divisor < rest && rest < divisor);
    let quotient = within(i64::MAX - 1);
    kani::assume(rest == 0 || quotient == 0 || (rest < 0) == (quotient < 0));
    Division { quotient, rest, divisor }
}

/// A value of at most this size, often a tie of micrometres.
fn value(size: i64) -> i64 {
    if kani::any() { 500 * within(size / 500) } else { within(size) }
}

fn settle(rule: Rounding, Division { quotient, rest, divisor }: &Division) -> i64 {
    rule.settle(*quotient, *rest, *divisor)
}

theorems! {
    /// Of any division, half away from zero lies within half a divisor of the value, cutting less than a divisor
    /// toward zero, rounding up less than a divisor away from it.
    /// Of: `Rounding::settle`, `Rounding::goes_away`
    /// Assumes: a rest below the divisor, of the sign of the quotient; all 64 bits but the extreme quotients.
    /// Rules: E100L-DEC-03, E100L-TYPE-05, E100L-FUNC-12, E100L-FUNC-13, E100L-FUNC-14
    #[unwind(2)]
    fn a_rule_follows_the_rest() {
        let division = division();
        let Division { quotient, rest, divisor } = division;
        kani::cover!(divisor == i64::MAX, "the largest divisor");
        kani::cover!(rest != 0 && 2 * i128::from(rest) == -i128::from(divisor), "a negative tie");
        // What is left of the value, by how much the result differs from the quotient.
        let left = |rule| {
            let step = match i128::from(settle(rule, &division)) - i128::from(quotient) {
                0 => 0,
                1 => i128::from(divisor),
                other => {
                    assert!(other == -1);
                    -i128::from(divisor)
                }
            };
            i128::from(rest) - step
        };
        let (nearest, cut, up) = (left(Rounding::HalfAway), left(Rounding::Cut), left(Rounding::Up));
        assert!(2 * nearest.abs() <= i128::from(divisor));
        assert!(2 * nearest.abs() != i128::from(divisor) || nearest.signum() != i128::from(rest.signum()));
        assert!(cut == i128::from(rest));
        assert!(up.abs() < i128::from(divisor) && up.signum() != i128::from(rest.signum()) || rest == 0 && up == 0);
    }

    /// The cut value is at most the rounded one in size, that at most the raised one, and they lie at most one
    /// apart.
    /// Of: `Rounding::settle`
    /// Assumes: as `a_rule_follows_the_rest`.
    /// Rules: E100L-FUNC-12, E100L-FUNC-13, E100L-FUNC-14
    #[unwind(6)]
    fn the_rules_are_in_order() {
        let division = division();
        let [nearest, cut, up] = RULES.map(|rule| settle(rule, &division).unsigned_abs());
        kani::cover!(nearest != cut, "rounded away");
        kani::cover!(nearest != up, "rounded back");
        assert!(cut <= nearest && nearest <= up && up - cut <= 1);
    }

    /// Rounding treats both signs alike.
    /// Of: `Rounding::settle`
    /// Assumes: as `a_rule_follows_the_rest`.
    /// Rules: E100L-DEC-03, E100L-FUNC-12
    #[unwind(2)]
    fn rounding_is_odd() {
        let division = division();
        let mirrored = Division { quotient: -division.quotient, rest: -division.rest, ..division };
        let rule = one_of(&RULES);
        kani::cover!(division.rest != 0, "a rest");
        assert!(settle(rule, &mirrored) == -settle(rule, &division));
    }

    /// Any value is divided by an increment of the control without overflow, and never changes its sign.
    /// Of: `Rounding::divide_narrow`
    /// Assumes: any value; the divisors 1, 5, 1000, 2540.
    /// Rules: E100L-DEC-03, E100L-INCH-02, E100L-TRQ-04
    #[unwind(5)]
    fn no_value_overflows() {
        let (value, rule) = (kani::any::<i64>(), one_of(&RULES));
        kani::cover!(value == i64::MIN, "the least value");
        for divisor in [1, 5, 1000, 2540] {
            let result = rule.divide_narrow(value, divisor);
            assert!(result == 0 || (result < 0) == (value < 0));
            assert!(result.unsigned_abs() <= value.unsigned_abs());
        }
    }

    /// The same in 128 bits.
    /// Of: `Rounding::divide`
    /// Assumes: any value; the divisors 1, 1000, 2540.
    /// Rules: E100L-DEC-03, E100L-TYPE-13
    #[unwind(4)]
    fn no_wide_value_overflows() {
        let (value, rule) = (within_wide(i128::MAX), one_of(&RULES));
        kani::cover!(value == i128::MAX, "the largest value");
        for divisor in [1, 1000, 2540] {
            let result = rule.divide(value, divisor);
            assert!(result == 0 || (result < 0) == (value < 0));
        }
    }

    /// A length rounded to micrometres lies within half a micrometre.
    /// Of: `Rounding::divide_narrow`
    /// Assumes: values of at most 10^6 in size, the divisor 1000.
    /// Rules: E100L-DEC-03
    #[unwind(2)]
    fn a_micrometre_is_the_nearest() {
        let value = value(1_000_000);
        let rest = value - 1000 * Rounding::HalfAway.divide_narrow(value, 1000);
        kani::cover!(rest == -500, "a tie");
        assert!((-500..=500).contains(&rest));
        assert!(rest.abs() != 500 || (rest < 0) == (value > 0));
    }

    /// A length cut to 0.0001 inch is at most one increment shorter, never longer.
    /// Of: `Rounding::divide_narrow`
    /// Assumes: values of at most 10^5 in size, the divisor 2540.
    /// Rules: E100L-INCH-02
    #[unwind(2)]
    fn an_inch_increment_is_cut() {
        let value = within(100_000);
        let rest = value - 2540 * Rounding::Cut.divide_narrow(value, 2540);
        kani::cover!(rest < 0, "a negative rest");
        assert!(rest.abs() < 2540 && (rest == 0 || (rest < 0) == (value < 0)));
    }

    /// A larger value never rounds to a smaller one, by any rule.
    /// Of: `Rounding::divide_narrow`
    /// Assumes: values of at most 10^5 in size, the divisor 1000.
    /// Rules: E100L-DEC-03
    #[unwind(2)]
    fn rounding_keeps_the_order() {
        let (less, more, rule) = (within(100_000), within(100_000), one_of(&RULES));
        kani::assume(less <= more);
        let (low, high) = (rule.divide_narrow(less, 1000), rule.divide_narrow(more, 1000));
        kani::cover!(less < more && low == high, "the same result");
        assert!(low <= high);
    }

    /// 64 and 128 bits round alike.
    /// Of: `Rounding::divide_narrow`, `Rounding::divide`
    /// Assumes: values of at most 10^4 in size, the divisor 1000.
    /// Rules: E100L-DEC-03
    #[unwind(2)]
    fn narrow_and_wide_round_alike() {
        let (value, rule) = (value(10_000), one_of(&RULES));
        kani::cover!(value == -500, "a tie");
        assert!(i128::from(rule.divide_narrow(value, 1000)) == rule.divide(value.into(), 1000));
    }
}

refutations! {
    /// False: rounding to tens and then to hundreds is rounding to hundreds.
    #[unwind(2)]
    fn rounding_twice_is_rounding_once() {
        let value = within(10_000);
        let rule = Rounding::HalfAway;
        assert!(rule.divide_narrow(rule.divide_narrow(value, 10), 10) == rule.divide_narrow(value, 100));
    }

    /// False: a rounded value is a cut one.
    #[unwind(2)]
    fn rounding_is_cutting() {
        let division = division();
        assert!(settle(Rounding::HalfAway, &division) == settle(Rounding::Cut, &division));
    }
}

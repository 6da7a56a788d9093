//! Theorems about the unit systems: what a written 1 means, and that no word leaves its range.

use turnspec::engine::arithmetic::units::Units;
use turnspec_oracle::vocabulary::UnitSystem;

use crate::draw::{between, one_of};
#[cfg(stand_in)]
use crate::kani;

/// Every unit system.
pub(crate) const SYSTEMS: [UnitSystem; 5] = [
    UnitSystem::Micrometre,
    UnitSystem::TenMicrometre,
    UnitSystem::Millimetre,
    UnitSystem::TenThousandthInch,
    UnitSystem::Inch,
];

theorems! {
    /// A written inch, and a feed of a written inch, is 25.4 times a written millimetre; a foot of cutting speed
    /// is 12 inches.
    /// Of: `Units::new`
    /// Assumes: nothing.
    /// Rules: E100L-INCH-01, E100L-DEC-01, E100L-CSS-01
    #[unwind(11)]
    fn an_inch_is_25_4_millimetres() {
        let (inch, millimetre) = (Units::new(UnitSystem::Inch), Units::new(UnitSystem::Millimetre));
        assert!(10 * inch.length == 254 * millimetre.length);
        assert!(10 * inch.feed[0] == 254 * millimetre.feed[0] && 10 * inch.feed[1] == 254 * millimetre.feed[1]);
        assert!(10_000 * inch.surface == 12 * 254 * millimetre.surface);
        assert!(inch.angle == millimetre.angle && inch.time == millimetre.time);
    }

    /// In each of the finer systems lengths and feeds per revolution count the increment of the coarse one, which
    /// is a whole power of ten smaller; angles and times follow the metric systems.
    /// Of: `Units::new`
    /// Assumes: nothing.
    /// Rules: E100L-DEC-01
    #[unwind(11)]
    fn systems_differ_by_powers_of_ten() {
        let of = |system, factor: i64| {
            let units = Units::new(system);
            [units.length * factor, units.feed[1] * factor]
        };
        let millimetre = of(UnitSystem::Millimetre, 1);
        assert!(millimetre == of(UnitSystem::Micrometre, 1000) && millimetre == of(UnitSystem::TenMicrometre, 100));
        assert!(of(UnitSystem::Inch, 1) == of(UnitSystem::TenThousandthInch, 10_000));
        for system in SYSTEMS {
            let Units { length, angle, inch, .. } = Units::new(system);
            assert!(inch == system.is_inch());
            assert!(inch || angle == length);
        }
    }

    /// Every unit and bound is positive and below 2^60, which the comparison of words with their range needs.
    /// Of: `Units::new`
    /// Assumes: nothing.
    /// Rules: E100L-DEC-01, E100L-ADDR-01
    #[unwind(11)]
    fn units_suit_the_comparison() {
        let system = one_of(&SYSTEMS);
        kani::cover!(system.is_inch(), "inches");
        let units = Units::new(system);
        let [per_minute, per_revolution] = units.feed;
        let [least, most] = units.feeds;
        let all =
            [units.length, units.angle, per_minute, per_revolution, units.time, units.surface, units.longest, least];
        assert!(all.iter().all(|value| *value > 0 && *value < 1 << 60));
        assert!(least < most && most == 1000 * units.longest);
    }

    /// A number of eight digits, in any unit of any system, stays within 64 bits; a cutting speed does for every
    /// S word.
    /// Of: `Units::new`
    /// Assumes: numbers of at most eight digits, S of at most 65 535.
    /// Rules: E100L-DEC-01, E100L-FEED-03, E100L-DWELL-01, E100L-CSS-01
    #[unwind(11)]
    fn eight_digits_fit_every_unit() {
        let units = Units::new(one_of(&SYSTEMS));
        let digits = between(-99_999_999, 99_999_999);
        kani::cover!(digits == -99_999_999 && units.inch, "the largest inch");
        for unit in [units.length, units.angle, units.feed[0], units.feed[1], units.time] {
            assert!(digits.checked_mul(unit).is_some());
        }
        let speed = between(0, 65_535);
        assert!(speed.checked_mul(units.surface).is_some());
    }

    /// Where a plain length needs no rounding, its last digit is a whole number of increments, and so many of
    /// them as the decimals say make up the unit.
    /// Of: `Units::new`
    /// Assumes: at most eight decimals.
    /// Rules: E100L-DEC-01, E100L-DEC-03
    #[unwind(11)]
    fn the_last_digit_is_whole_increments() {
        let units = Units::new(one_of(&SYSTEMS));
        kani::cover!(units.last_digit[3] != 0, "three decimals are exact");
        for (decimals, last) in (0..).zip(units.last_digit) {
            assert!(last % 1000 == 0 && (!units.inch || last == 0));
            assert!(last == 0 || last * 10_i64.pow(decimals) == units.length);
        }
    }
}

refutations! {
    /// False: a written 1 means as long a feed per minute as per revolution.
    #[unwind(11)]
    fn feeds_have_one_unit() {
        let units = Units::new(one_of(&SYSTEMS));
        assert!(units.feed[0] == units.feed[1]);
    }
}

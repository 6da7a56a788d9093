//! What a written 1 means in each unit system, and how far the words reach (E100L-DEC-01, E100L-INCH-01,
//! E100L-ADDR-01).

use turnspec_oracle::vocabulary::{Setup, UnitSystem};

use super::scale::TEN;

/// What a written 1 means (E100L-DEC-01) and how far the words reach.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// Nanometres of a written length 1.
    pub length: i64,
    /// Nanometres of the last digit of a plain metric length with so many decimals, where that is a whole
    /// number of increments; else 0.
    pub last_digit: [i64; 9],
    /// Micro-degrees of a written angle 1.
    pub angle: i64,
    /// Picometres of a written feed 1, per minute and per revolution.
    pub feed: [i64; 2],
    /// Microseconds of a written time 1.
    pub time: i64,
    /// Micrometres per minute of a written cutting speed 1.
    pub surface: i64,
    /// Whether lengths are written in inches.
    pub inch: bool,
    /// Largest length in nanometres.
    pub longest: i64,
    /// Smallest and largest feed in picometres.
    pub feeds: [i64; 2],
}

impl Units {
    /// The units of a unit system.
    /// An angle 1, that of A among them, is 1 degree, 0.01 degree in 10 µm, 0.001 degree in 1 µm and 1/10000 inch
    /// (E100L-DTAP-02).
    #[must_use]
    pub fn new(system: UnitSystem) -> Self {
        let (length, angle, feed, time) = match system {
            UnitSystem::Micrometre => (1000, 1000, [100_000_000, 1_000_000], 10_000),
            UnitSystem::TenMicrometre => (10_000, 10_000, [1_000_000_000, 10_000_000], 100_000),
            UnitSystem::Millimetre => (1_000_000, 1_000_000, [1_000_000_000, 1_000_000_000], 1_000_000),
            UnitSystem::TenThousandthInch => (2540, 1000, [254_000_000, 2_540_000], 10_000),
            UnitSystem::Inch => (25_400_000, 1_000_000, [25_400_000_000, 25_400_000_000], 1_000_000),
        };
        let inch = system.is_inch();
        let (longest, feeds, surface) = if inch {
            (99_999_999 * 2540, [2_540_000, 99_999_999 * 2_540_000], 304_800)
        } else {
            (Setup::COORDINATE, [1_000_000, 99_999_999 * 1_000_000], 1_000_000)
        };
        let last_digit = std::array::from_fn(|decimals| {
            let exact = !inch && length % (1000 * TEN[decimals]) == 0;
            if exact { length / TEN[decimals] } else { 0 }
        });
        Self { length, last_digit, angle, feed, time, surface, inch, longest, feeds }
    }
}

//! π, and the trigonometric functions of angles in degrees.

use dashu_int::{IBig, UBig};

use super::Interval;
use crate::quantity::{Exact, ratio, whole};

/// Bits of π behind the point that are stored.
const PI_BITS: usize = 64 * (PI_WORDS.len() - 1);

/// π cut off after [`PI_BITS`] bits, its low words first.
const PI_WORDS: [u64; 20] = [
    0x718bcd5882154aee,
    0x0d95748f728eb658,
    0xa458fea3f4933d7e,
    0x636920d871574e69,
    0x0801f2e2858efc16,
    0x24a19947b3916cf7,
    0xba7c9045f12c7f99,
    0xb8e1afed6a267e96,
    0x2ffd72dbd01adfb7,
    0xd1310ba698dfb5ac,
    0x9216d5d98979fb1b,
    0x3f84d5b5b5470917,
    0xc0ac29b7c97c50dd,
    0xbe5466cf34e90c6c,
    0x452821e638d01377,
    0x082efa98ec4e6c89,
    0xa4093822299f31d0,
    0x13198a2e03707344,
    0x243f6a8885a308d3,
    0x0000000000000003,
];

/// Sum of `Σ (-1)^k x^(first + 2k) / divisor(first + 2k)` until the terms vanish; the rest of an
/// alternating series is smaller than its first term left out.
fn alternating_series(
    x: &Interval,
    first: Interval,
    next_divisor: impl Fn(u64) -> (u64, u64),
    precision: usize,
) -> Interval {
    let square = x.mul(x);
    let mut power = first;
    let mut sum = Interval::of(&Exact::ZERO, precision);
    let mut index = 0;
    while !power.vanishes() {
        let (term, carried) = next_divisor(index);
        let summand = power.over(term);
        sum = if index % 2 == 0 { sum.add(&summand) } else { sum.sub(&summand) };
        power = power.mul(&square).over(carried);
        index += 1;
    }
    sum.widen(2)
}

/// Arc tangent of a number of magnitude well below 1.
fn small_atan(x: &Interval, precision: usize) -> Interval {
    alternating_series(x, x.clone(), |index| (2 * index + 1, 1), precision)
}

/// π: from its stored bits as far as they reach, else computed.
pub fn pi(precision: usize) -> Interval {
    if precision > PI_BITS {
        return machin(precision);
    }
    let bits: UBig = PI_WORDS.iter().rev().fold(UBig::ZERO, |bits, word| bits << 64 | UBig::from(*word));
    Interval::between(IBig::from(bits >> (PI_BITS - precision)), precision)
}

/// π by Machin's formula 16 atan(1/5) - 4 atan(1/239).
fn machin(precision: usize) -> Interval {
    let atan_of_inverse = |inverse| small_atan(&Interval::of(&ratio(1, inverse), precision), precision);
    atan_of_inverse(5).times(16).sub(&atan_of_inverse(239).times(4))
}

/// Degrees as radians.
fn radians(degrees: &Exact, precision: usize) -> Interval {
    pi(precision).mul(&Interval::of(&(degrees / whole(180)), precision))
}

/// Reduces an angle to `[-45, 45]` degrees and the number (0 to 3) of quarter turns taken off.
fn reduce(degrees: &Exact) -> (Exact, u8) {
    let quarters = (degrees / whole(90) + ratio(1, 2)).floor();
    let rest = degrees - whole(90) * Exact::from(quarters.clone());
    let turns = ((quarters % IBig::from(4)) + IBig::from(4)) % IBig::from(4);
    (rest, u8::try_from(turns).unwrap_or_default())
}

fn small_sin(degrees: &Exact, precision: usize) -> Interval {
    let x = radians(degrees, precision);
    alternating_series(&x, x.clone(), |index| (1, (2 * index + 2) * (2 * index + 3)), precision)
}

fn small_cos(degrees: &Exact, precision: usize) -> Interval {
    let x = radians(degrees, precision);
    let one = Interval::of(&Exact::ONE, precision);
    alternating_series(&x, one, |index| (1, (2 * index + 1) * (2 * index + 2)), precision)
}

/// Sine of an angle in degrees.
pub fn sin_degrees(degrees: &Exact, precision: usize) -> Interval {
    match reduce(degrees) {
        (rest, 0) => small_sin(&rest, precision),
        (rest, 1) => small_cos(&rest, precision),
        (rest, 2) => small_sin(&rest, precision).neg(),
        (rest, _) => small_cos(&rest, precision).neg(),
    }
}

/// Cosine of an angle in degrees.
pub fn cos_degrees(degrees: &Exact, precision: usize) -> Interval {
    sin_degrees(&(degrees + whole(90)), precision)
}

/// Tangent of an angle in degrees that is no odd multiple of 90.
pub fn tan_degrees(degrees: &Exact, precision: usize) -> Interval {
    sin_degrees(degrees, precision).div(&cos_degrees(degrees, precision))
}

/// Arc tangent in degrees, in `(-90, 90)`.
pub fn atan_degrees(value: &Exact, precision: usize) -> Interval {
    let degrees = |angle: &Interval| angle.times(180).div(&pi(precision));
    if *value > Exact::ONE || *value < -Exact::ONE {
        let quarter = if *value > Exact::ZERO { whole(90) } else { whole(-90) };
        return Interval::of(&quarter, precision).sub(&atan_degrees(&(Exact::ONE / value), precision));
    }
    // atan x = 2 atan(x / (1 + sqrt(1 + x²))), twice: then the argument is at most 0.2.
    let one = Interval::of(&Exact::ONE, precision);
    let halve = |x: &Interval| x.div(&one.add(&one.add(&x.mul(x)).sqrt()));
    let quarter_angle = small_atan(&halve(&halve(&Interval::of(value, precision))), precision);
    degrees(&quarter_angle).times(4)
}

/// Argument in degrees, in `(-180, 180]`, of the point with this ordinate and this abscissa, not both zero.
pub fn atan2_degrees(ordinate: &Exact, abscissa: &Exact, precision: usize) -> Interval {
    let exactly = |angle: i32| Interval::of(&whole(angle), precision);
    if *abscissa > Exact::ZERO {
        return atan_degrees(&(ordinate / abscissa), precision);
    }
    let half_turn = if *ordinate < Exact::ZERO { exactly(-180) } else { exactly(180) };
    if *abscissa < Exact::ZERO {
        return half_turn.add(&atan_degrees(&(ordinate / abscissa), precision));
    }
    if *ordinate < Exact::ZERO { exactly(-90) } else { exactly(90) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::nearest_real;

    #[test]
    fn the_stored_bits_are_those_of_pi() {
        let (stored, computed) = (pi(PI_BITS), machin(PI_BITS + 64));
        assert!(stored.low() <= computed.low() && computed.high() <= stored.high());
    }

    /// A precision beyond the stored bits is computed, as narrow as it is asked for.
    #[test]
    fn pi_goes_beyond_the_stored_bits() {
        let (stored, computed) = (pi(PI_BITS), pi(PI_BITS + 64));
        assert!(stored.low() <= computed.low() && computed.high() <= stored.high());
        let width = |interval: &Interval| interval.high() - interval.low();
        assert!(width(&computed) * whole(1_000_000) < width(&stored));
    }

    #[test]
    fn angles_are_reduced_to_an_eighth_of_a_turn() {
        for (angle, rest, quarters) in [
            (44, 44, 0),
            (46, -44, 1),
            (100, 10, 1),
            (-100, -10, 3),
            (180, 0, 2),
            (260, -10, 3),
            (370, 10, 0),
        ] {
            assert_eq!(reduce(&whole(angle)), (whole(rest), quarters), "{angle}");
        }
    }

    #[test]
    fn known_values() {
        // Digits of π, tan 22.5° = √2 - 1, sin 15° = (√6 - √2) / 4: each to binary64.
        assert_eq!(nearest_real(0, pi), std::f64::consts::PI);
        let at = |function: fn(&Exact, usize) -> Interval, numerator: i32, denominator| {
            nearest_real(0, |precision| function(&ratio(numerator, denominator), precision))
        };
        assert_eq!(at(sin_degrees, 30, 1), 0.5);
        assert_eq!(at(cos_degrees, 240, 1), -0.5);
        assert_eq!(at(tan_degrees, 45, 2), 0.414_213_562_373_095_03);
        assert_eq!(at(sin_degrees, -15, 1), -0.258_819_045_102_520_74);
        assert_eq!(at(sin_degrees, 3615, 1), 0.258_819_045_102_520_74);
        assert_eq!(at(atan_degrees, 1, 1), 45.0);
        assert_eq!(at(atan_degrees, -1, 1), -45.0);
        let atan2 =
            |y: i32, x: i32| nearest_real(0, |precision| atan2_degrees(&whole(y), &whole(x), precision));
        assert_eq!([atan2(0, -1), atan2(1, -1), atan2(-1, -1), atan2(-1, 0)], [180.0, 135.0, -135.0, -90.0]);
    }
}

//! Trigonometry in fixed point, 124 binary digits after the point, without allocation.
//!
//! The series are exact to within 2^-116; a result whose binary64 neighbours this leaves in doubt is
//! computed again with wide integers.

use dashu_int::IBig;

use super::{Big, Real, SlowPaths};
use crate::engine::arithmetic::wide::product;

/// Digits after the point.
const DIGITS: u32 = 124;
const ONE: i128 = 1 << DIGITS;
/// Bound of the error of a sine or cosine, in units of the last place: 2^-116.
const ERROR: u128 = 1 << 8;

/// π/180 in units of 2^-132.
const RADIANS_PER_DEGREE: u128 = 0x477d_1a89_4a74_e457_0762_fb37_4a42_e26c;
/// π/180 000 000 in units of 2^-152.
const RADIANS_PER_MICRODEGREE: u128 = 0x4af6_191b_06fb_b572_e602_c403_e89d_8ef8;
/// 180/π in units of 2^-118.
const DEGREES_PER_RADIAN: u128 = 0x0e52_ee0d_31e0_fbdc_30a9_7537_f40d_257d;

/// `(a * b) >> shift`, cut; the result must fit.
fn product_shifted(a: u128, b: u128, shift: u32) -> u128 {
    let (high, low) = product(a, b);
    match shift {
        0 => low,
        1..=127 => (high << (128 - shift)) | (low >> shift),
        128..=255 => high >> (shift - 128),
        _ => 0,
    }
}

#[allow(clippy::cast_possible_wrap)]
fn times(a: i128, b: i128) -> i128 {
    let size = product_shifted(a.unsigned_abs(), b.unsigned_abs(), DIGITS) as i128;
    if (a < 0) == (b < 0) { size } else { -size }
}

/// 1/k! as far as it shows, each cut.
const INVERSE_FACTORIALS: [i128; 34] = {
    let mut inverse = [ONE; 34];
    let mut index = 1;
    while index < 34 {
        inverse[index] = inverse[index - 1] / index as i128;
        index += 1;
    }
    inverse
};

/// Sine and cosine of radians of at most 1 in size: the alternating series, from their last terms on. Every
/// step cuts off less than 3 units of the last place, which those after it do not enlarge.
fn series(radians: i128) -> (i128, i128) {
    let square = times(radians, radians);
    let (mut sine, mut cosine) = (0, 0);
    for pair in INVERSE_FACTORIALS.rchunks_exact(2) {
        cosine = pair[0] - times(cosine, square);
        sine = pair[1] - times(sine, square);
    }
    (times(radians, sine), cosine)
}

/// Turns sine and cosine of the rest into those of the whole angle: so many quarter turns more.
fn turned((sine, cosine): (i128, i128), quarters: i64) -> (i128, i128) {
    match quarters.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

#[allow(clippy::cast_precision_loss)]
fn to_double(value: i128) -> f64 {
    value as f64 / ONE as f64
}

/// Sine and cosine of micro-degrees, each within 2^-52 of its own size.
pub(super) fn sine_cosine_of_microdegrees(angle: i64) -> (f64, f64) {
    const QUARTER: i64 = 90_000_000;
    let angle = angle.rem_euclid(4 * QUARTER);
    let quarters = (angle + QUARTER / 2) / QUARTER;
    let rest = angle - quarters * QUARTER;
    #[allow(clippy::cast_possible_wrap)]
    let size = product_shifted(u128::from(rest.unsigned_abs()), RADIANS_PER_MICRODEGREE, 28) as i128;
    let radians = if rest < 0 { -size } else { size };
    let (sine, cosine) = turned(series(radians), quarters);
    (to_double(sine), to_double(cosine))
}

/// A binary64 number as `mantissa * 2^exponent`, exactly.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Double {
    /// With its sign; at most 53 bits.
    pub mantissa: i64,
    /// Power of two.
    pub exponent: i32,
}

impl Double {
    /// Takes a finite number apart.
    #[must_use]
    pub fn new(value: f64) -> Self {
        let bits = value.to_bits();
        #[allow(clippy::cast_possible_wrap, clippy::cast_possible_truncation)]
        let (fraction, power) = ((bits & ((1 << 52) - 1)) as i64, (bits >> 52 & 0x7ff) as i32);
        let (size, exponent) =
            if power == 0 { (fraction, -1074) } else { (fraction | 1 << 52, power - 1075) };
        Self { mantissa: if value.is_sign_negative() { -size } else { size }, exponent }
    }
}

/// An angle in degrees as quarter turns and a rest of at most 45 degrees, both exact.
fn reduced(degrees: f64) -> (i64, f64) {
    let angle = degrees % 360.0;
    #[allow(clippy::cast_possible_truncation)]
    let quarters = (angle / 90.0).round() as i64;
    #[allow(clippy::cast_precision_loss)]
    (quarters, angle - quarters as f64 * 90.0)
}

/// Sine and cosine of a rest in degrees, in fixed point.
fn fixed_sine_cosine(rest: f64, quarters: i64) -> (i128, i128) {
    let Double { mantissa, exponent } = Double::new(rest);
    // A rest of at most 45 has an exponent of at most -47.
    let shift = u32::try_from(8 - exponent).unwrap_or(255);
    #[allow(clippy::cast_possible_wrap)]
    let size = product_shifted(u128::from(mantissa.unsigned_abs()), RADIANS_PER_DEGREE, shift) as i128;
    turned(series(if mantissa < 0 { -size } else { size }), quarters)
}

/// The binary64 that both ends of `value ± error` round to.
#[allow(clippy::cast_precision_loss)]
fn certain(value: i128, error: u128, digits: i32) -> Option<f64> {
    let size = value.unsigned_abs();
    if size <= error {
        return None;
    }
    let (low, high) = ((size - error) as f64, (size + error) as f64);
    let result = low * 2.0_f64.powi(-digits);
    (low == high).then_some(if value < 0 { -result } else { result })
}

/// Wide integers until the rounding is certain.
fn certain_big(exponent: i32, formula: impl Fn(usize) -> Big) -> f64 {
    let least = usize::try_from(-exponent).unwrap_or(0);
    let mut digits = 256 + least;
    loop {
        let value = formula(digits);
        if let Some(result) = value.certain_double() {
            return result;
        }
        if digits > 16_384 {
            // Not reached: the values are irrational, and their binary digits are not that regular.
            return 0.0;
        }
        digits *= 2;
    }
}

fn big_radians(rest: f64, digits: usize) -> Big {
    let Double { mantissa, exponent } = Double::new(rest);
    let degrees =
        Big::ratio(&IBig::from(mantissa), &IBig::ONE, isize::try_from(exponent).unwrap_or(0), digits);
    degrees.times(&Big::pi(digits)).over(&Big::integer(180, digits))
}

fn big_sine_cosine(rest: f64, quarters: i64, digits: usize) -> (Big, Big) {
    let (sine, cosine) = big_radians(rest, digits).sine_cosine_of();
    let minus = |value: &Big| Big::integer(0, digits).minus(value);
    match quarters.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, minus(&sine)),
        2 => (minus(&sine), minus(&cosine)),
        _ => (minus(&cosine), sine),
    }
}

/// Sine and cosine of finite degrees, each rounded once.
pub fn sine_cosine(degrees: f64, slow: &mut SlowPaths) -> (f64, f64) {
    let (quarters, rest) = reduced(degrees);
    let (sine, cosine) = fixed_sine_cosine(rest, quarters);
    // Exact values: multiples of 90 degrees, and halves at 30 degrees beside them.
    let exact = |odd: bool| -> Option<f64> {
        let along = (quarters.rem_euclid(2) == 1) == odd;
        let sign = |negative: bool, size: f64| if negative { -size } else { size };
        let negative = if odd { sine < 0 } else { cosine < 0 };
        match (rest == 0.0, along) {
            (true, true) => Some(sign(negative, 1.0)),
            (true, false) => Some(0.0),
            (false, false) if rest.abs() == 30.0 => Some(sign(negative, 0.5)),
            _ => None,
        }
    };
    let digits = i32::try_from(DIGITS).unwrap_or(0);
    let exponent = Double::new(rest).exponent;
    let mut finish = |odd: bool, value: i128| {
        exact(odd).or_else(|| certain(value, ERROR, digits)).unwrap_or_else(|| {
            slow.functions += 1;
            certain_big(exponent, |digits| {
                let (sine, cosine) = big_sine_cosine(rest, quarters, digits);
                if odd { sine } else { cosine }
            })
        })
    };
    (finish(true, sine), finish(false, cosine))
}

/// The quotient of two sizes as a mantissa of 120 to 126 bits and the digits after its point.
fn quotient(numerator: u128, denominator: u128) -> (u128, i32) {
    let (up, down) = (numerator.leading_zeros() - 2, denominator.leading_zeros() - 2);
    let (mut rest, divisor) = (numerator << up, denominator << down);
    let mut result = rest / divisor;
    rest %= divisor;
    for _ in 0..124 {
        rest <<= 1;
        result <<= 1;
        if rest >= divisor {
            rest -= divisor;
            result |= 1;
        }
    }
    (result, 124 + up.cast_signed() - down.cast_signed())
}

/// The quotient of two mantissas of at most 53 bits, 124 digits after its point, cut.
fn mantissa_quotient(numerator: u64, denominator: u64) -> u128 {
    let (scaled, divisor) = (u128::from(numerator) << 64, u128::from(denominator));
    let rest = (scaled % divisor) << 60;
    ((scaled / divisor) << 60) | (rest / divisor)
}

/// The tangent of finite degrees, rounded once; `None` at odd multiples of 90.
pub fn tangent(degrees: f64, slow: &mut SlowPaths) -> Option<f64> {
    let (quarters, rest) = reduced(degrees);
    let odd = quarters.rem_euclid(2) == 1;
    if rest == 0.0 {
        return (!odd).then_some(0.0);
    }
    let (sine, cosine) = fixed_sine_cosine(rest, quarters);
    let negative = (rest < 0.0) != odd;
    if rest.abs() == 45.0 {
        return Some(if negative { -1.0 } else { 1.0 });
    }
    let least = sine.unsigned_abs().min(cosine.unsigned_abs());
    if least > ERROR << 64 {
        let (size, digits) = quotient(sine.unsigned_abs(), cosine.unsigned_abs());
        // The relative error of the smaller of the two, twice, and that of the larger one.
        let error = (size >> (least.ilog2() - ERROR.ilog2() - 2)) + 2;
        if let Some(result) = certain(size.cast_signed(), error, digits) {
            return Some(if negative { -result } else { result });
        }
    }
    slow.functions += 1;
    Some(certain_big(Double::new(rest).exponent, |digits| {
        let (sine, cosine) = big_sine_cosine(rest, quarters, digits);
        sine.over(&cosine)
    }))
}

/// The angle in degrees, in (-180, 180], of the direction with this ordinate and abscissa, rounded once.
/// Both finite, not both zero; a zero has no sign.
pub fn arc_tangent(ordinate: f64, abscissa: f64, slow: &mut SlowPaths) -> f64 {
    let (up, along) = (ordinate.abs(), abscissa.abs());
    let left = abscissa < 0.0;
    let exact = if up == 0.0 {
        Some(if left { 180.0 } else { 0.0 })
    } else if along == 0.0 {
        Some(90.0)
    } else if up == along {
        Some(if left { 135.0 } else { 45.0 })
    } else {
        None
    };
    let size = exact.or_else(|| fixed_arc_tangent(up, along, left)).unwrap_or_else(|| {
        slow.functions += 1;
        big_arc_tangent(up, along, left)
    });
    if ordinate < 0.0 { -size } else { size }
}

/// The angle in micro-degrees, in (-180, 180] degrees, of the direction with this ordinate and abscissa, rounded once.
/// Both at most 2^53 in size, not both zero. A tie cannot occur: rational angles of this kind are multiples of 45.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)]
pub fn arc_tangent_microdegrees(ordinate: i64, abscissa: i64, slow: &mut SlowPaths) -> i64 {
    let scaled = arc_tangent(ordinate as f64, abscissa as f64, slow) * 1.0e6;
    let nearest = scaled.round();
    // The angle is off by 2^-46 degrees at most, the product by as much again: less than 1e-7 together.
    if (scaled - nearest).abs() < 0.499_999 {
        return nearest as i64;
    }
    slow.roundings += 1;
    let parts = [ordinate, abscissa].map(|part| i128::from(part.unsigned_abs()));
    let approximation = (parts[0] as f64).atan2(parts[1] as f64);
    let rounded = [256, 512, 1024].iter().find_map(|&digits| {
        let [up, along] = parts.map(|part| Big::integer(part, digits));
        let degrees = Big::angle(&up, &along, approximation).times(&Big::integer(180, digits));
        let degrees = degrees.over(&Big::pi(digits));
        let degrees = if abscissa < 0 { Big::integer(180, digits).minus(&degrees) } else { degrees };
        degrees.times(&Big::integer(1_000_000, digits)).certain_round()
    });
    let size = rounded.unwrap_or(nearest.abs() as i64);
    if ordinate < 0 { -size } else { size }
}

/// The angle of a direction in the upper half plane, if 124 digits suffice.
fn fixed_arc_tangent(up: f64, along: f64, left: bool) -> Option<f64> {
    const DEGREE_DIGITS: i32 = 118;
    let (small, large, steep) = if up < along { (up, along, false) } else { (along, up, true) };
    let (a, b) = (Double::new(small), Double::new(large));
    let ratio = mantissa_quotient(a.mantissa.unsigned_abs(), b.mantissa.unsigned_abs());
    // The ratio is ratio * 2^-124 * 2^(a.exponent - b.exponent), at most 1.
    let shift = u32::try_from(b.exponent - a.exponent).ok()?;
    let ratio = ratio.checked_shr(shift)?.cast_signed();
    if ratio < 1 << 80 {
        return None;
    }
    let start = to_double(ratio).atan();
    let Double { mantissa, exponent } = Double::new(start);
    let angle = i128::from(mantissa) << u32::try_from(exponent + 124).ok()?;
    let (sine, cosine) = series(angle);
    let across = times(ratio, cosine) - sine;
    let whole = cosine + times(ratio, sine);
    if across.unsigned_abs() >= 1 << 74 {
        return None;
    }
    // |across| < 2^74, whole in [1, 2): the quotient to within 2^-100.
    let rest = (across << 52) / (whole >> 72);
    let radians = (angle + rest).unsigned_abs();
    let degrees = product_shifted(radians, DEGREES_PER_RADIAN, DIGITS).cast_signed();
    let degrees = if steep { (90 << DEGREE_DIGITS) - degrees } else { degrees };
    let degrees = if left { (180 << DEGREE_DIGITS) - degrees } else { degrees };
    certain(degrees, 1 << 26, DEGREE_DIGITS)
}

fn big_arc_tangent(up: f64, along: f64, left: bool) -> f64 {
    let (a, b) = (Double::new(up), Double::new(along));
    let spread = (a.exponent - b.exponent).clamp(-2200, 2200);
    certain_big(-spread.abs() - 64, |digits| {
        // Scaled so that the larger one has the larger exponent zero.
        let top = a.exponent.max(b.exponent);
        let part = |double: Double| {
            let power = isize::try_from(double.exponent - top - 53).unwrap_or(0);
            Big::ratio(&IBig::from(double.mantissa.unsigned_abs()), &IBig::ONE, power, digits)
        };
        let (up_big, along_big) = (part(a), part(b));
        let angle = Big::angle(&up_big, &along_big, up.atan2(along));
        let degrees = angle.times(&Big::integer(180, digits)).over(&Big::pi(digits));
        if left { Big::integer(180, digits).minus(&degrees) } else { degrees }
    })
}

#[cfg(test)]
mod tests {
    use super::{SlowPaths, arc_tangent, arc_tangent_microdegrees, sine_cosine, tangent};

    fn slow() -> SlowPaths {
        SlowPaths::default()
    }

    #[test]
    fn exact_values() {
        for turns in [-720.0, 0.0, 360.0, 3600.0] {
            for (angle, sine, cosine) in [
                (0.0, Some(0.0), Some(1.0)),
                (30.0, Some(0.5), None),
                (60.0, None, Some(0.5)),
                (90.0, Some(1.0), Some(0.0)),
                (120.0, None, Some(-0.5)),
                (150.0, Some(0.5), None),
                (180.0, Some(0.0), Some(-1.0)),
                (210.0, Some(-0.5), None),
                (270.0, Some(-1.0), Some(0.0)),
                (330.0, Some(-0.5), None),
            ] {
                let (found_sine, found_cosine) = sine_cosine(angle + turns, &mut slow());
                assert!(sine.is_none_or(|sine| sine == found_sine), "sin {angle}");
                assert!(cosine.is_none_or(|cosine| cosine == found_cosine), "cos {angle}");
            }
        }
        assert_eq!(tangent(45.0, &mut slow()), Some(1.0));
        assert_eq!(tangent(135.0, &mut slow()), Some(-1.0));
        assert_eq!(tangent(-45.0, &mut slow()), Some(-1.0));
        assert_eq!(tangent(225.0, &mut slow()), Some(1.0));
        assert_eq!(tangent(90.0, &mut slow()), None);
        assert_eq!(tangent(-270.0, &mut slow()), None);
        assert_eq!(tangent(540.0, &mut slow()), Some(0.0));
        assert_eq!(arc_tangent(1.0, 1.0, &mut slow()), 45.0);
        assert_eq!(arc_tangent(-1.0, -1.0, &mut slow()), -135.0);
        assert_eq!(arc_tangent(0.0, -3.0, &mut slow()), 180.0);
        assert_eq!(arc_tangent(-2.0, 0.0, &mut slow()), -90.0);
    }

    #[test]
    fn irrational_values_are_the_nearest() {
        // sin 45 = sqrt(1/2), cos 30 = sqrt(3)/2: IEEE 754 square roots round once.
        assert_eq!(sine_cosine(45.0, &mut slow()), (0.5_f64.sqrt(), 0.5_f64.sqrt()));
        assert_eq!(sine_cosine(30.0, &mut slow()).1, 0.75_f64.sqrt());
        assert_eq!(sine_cosine(60.0, &mut slow()).0, 0.75_f64.sqrt());
        assert_eq!(tangent(60.0, &mut slow()), Some(3.0_f64.sqrt()));
        assert_eq!(tangent(-120.0, &mut slow()), Some(3.0_f64.sqrt()));
        // tan 150 = -tan 30, whatever the neighbour.
        assert_eq!(tangent(150.0, &mut slow()), tangent(-30.0, &mut slow()));
    }

    #[test]
    fn small_and_large_arguments() {
        // sin x = x * π/180 for small x, up to a relative x^2 / 6.
        let tiny = 1.0e-300;
        let (sine, cosine) = sine_cosine(tiny, &mut slow());
        assert!((sine / tiny / std::f64::consts::PI * 180.0 - 1.0).abs() < 1e-15);
        assert_eq!(cosine, 1.0);
        // 10^22 mod 360 = 280, since 10^22 = 10^4 mod 360 = 280.
        let (sine, _) = sine_cosine(1.0e22, &mut slow());
        assert_eq!(sine, sine_cosine(280.0, &mut slow()).0);
        let steep = arc_tangent(1.0e300, 1.0, &mut slow());
        assert_eq!(steep, 90.0);
        let flat = arc_tangent(1.0e-300, 1.0, &mut slow());
        assert!((flat * 1.0e300 - 57.295_779_513_082_32).abs() < 1e-12);
    }

    #[test]
    fn angles_in_microdegrees() {
        let mut slow = slow();
        assert_eq!(arc_tangent_microdegrees(40, 30, &mut slow), 53_130_102);
        assert_eq!(arc_tangent_microdegrees(-40, -30, &mut slow), -126_869_898);
        assert_eq!(arc_tangent_microdegrees(0, -7, &mut slow), 180_000_000);
        assert_eq!(arc_tangent_microdegrees(-7, 7, &mut slow), -45_000_000);
        assert_eq!(slow, SlowPaths::default());
        // Half a micro-degree is 8.726646259971647884618e-9 radians: between these two the rounding changes.
        assert_eq!(arc_tangent_microdegrees(8_726_646, 1_000_000_000_000_000, &mut slow), 0);
        assert_eq!(arc_tangent_microdegrees(8_726_647, 1_000_000_000_000_000, &mut slow), 1);
        assert_eq!(arc_tangent_microdegrees(-8_726_647, -1_000_000_000_000_000, &mut slow), -179_999_999);
        assert_eq!(slow.roundings, 3);
    }

    #[test]
    fn both_ways_agree() {
        // The wide integers and the fixed point must round to the same neighbour.
        for step in 1..200 {
            let degrees = f64::from(step) * 1.737;
            let (quarters, rest) = super::reduced(degrees);
            let wide = super::big_sine_cosine(rest, quarters, 256);
            let (sine, cosine) = sine_cosine(degrees, &mut slow());
            assert_eq!(wide.0.certain_double(), Some(sine));
            assert_eq!(wide.1.certain_double(), Some(cosine));
            let quotient = super::Real::over(&wide.0, &wide.1);
            assert_eq!(quotient.certain_double(), tangent(degrees, &mut slow()));
            let (up, along) = (f64::from(step), 200.0 - 1.3 * f64::from(step));
            let wide = super::big_arc_tangent(up, along.abs(), along < 0.0);
            assert_eq!(wide, arc_tangent(up, along, &mut slow()));
        }
    }
}

//! A plain number as it is written: an exact decimal, and whether it carries a point.

/// An exact decimal, `mantissa / 10^decimals`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Number {
    /// Its digits with their sign.
    pub mantissa: i64,
    /// How many of the digits are decimals.
    pub decimals: u8,
    /// Whether it is written with a point, and so is real (E100L-TYPE-01).
    pub point: bool,
}

impl Number {
    /// A whole number, written without a point.
    #[must_use]
    pub fn whole(value: i64) -> Self {
        Self { mantissa: value, decimals: 0, point: false }
    }

    /// A decimal; superfluous zeros are dropped, and the point with them when no decimal is left.
    #[must_use]
    pub fn decimal(mantissa: i64, decimals: u8) -> Self {
        let mut number = Self { mantissa, decimals, point: decimals > 0 };
        while number.decimals > 0 && number.mantissa % 10 == 0 {
            number.mantissa /= 10;
            number.decimals -= 1;
        }
        number.point = number.decimals > 0;
        number
    }

    /// The number written with a point.
    #[must_use]
    pub fn with_point(self) -> Self {
        Self { point: true, ..self }
    }

    /// The nearest binary64 number.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        self.mantissa as f64 / 10_f64.powi(i32::from(self.decimals))
    }

    /// The digits before and after the point.
    #[must_use]
    pub fn digits(self) -> (String, String) {
        let scale = 10_u64.saturating_pow(u32::from(self.decimals));
        let (whole, fraction) = (self.mantissa.unsigned_abs() / scale, self.mantissa.unsigned_abs() % scale);
        let width = usize::from(self.decimals);
        let fraction = if width == 0 { String::new() } else { format!("{fraction:0width$}") };
        (whole.to_string(), fraction)
    }

    /// The plainest spelling.
    #[must_use]
    pub fn text(self) -> String {
        let (whole, fraction) = self.digits();
        let sign = if self.mantissa < 0 { "-" } else { "" };
        let point = if self.point { "." } else { "" };
        format!("{sign}{whole}{point}{fraction}")
    }
}

/// `numerator / denominator` rounded to a whole number, half away from zero; the denominator is positive.
#[must_use]
pub fn round_ratio(numerator: i128, denominator: i128) -> i128 {
    let magnitude = (2 * numerator.abs() + denominator) / (2 * denominator);
    if numerator < 0 { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::{Number, round_ratio};

    #[test]
    fn numbers_are_written_as_they_are() {
        assert_eq!(Number::decimal(12_500, 3).text(), "12.5");
        assert_eq!(Number::decimal(-5, 3).text(), "-0.005");
        assert_eq!(Number::decimal(7_000, 3).text(), "7");
        assert_eq!(Number::whole(7).with_point().text(), "7.");
    }

    #[test]
    fn halves_go_away_from_zero() {
        let cases = [(5, 10, 1), (-5, 10, -1), (4, 10, 0), (15, 10, 2), (-14, 10, -1)];
        for (numerator, denominator, rounded) in cases {
            assert_eq!(round_ratio(numerator, denominator), rounded);
        }
    }
}

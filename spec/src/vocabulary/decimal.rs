//! Decimal text of scaled integers: `12.345` for 12 345 000 at six decimals.

/// The parts of `value / 10^decimals`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parts {
    /// Whether it is below zero.
    pub negative: bool,
    /// What stands before the point.
    pub whole: u64,
    /// What stands behind it, as a number of `decimals` digits.
    pub fraction: u64,
}

impl Parts {
    /// Takes any value apart, at no more than 19 decimals.
    #[must_use]
    pub fn new(value: i64, decimals: u32) -> Self {
        let (scale, size) = (10_u64.pow(decimals), value.unsigned_abs());
        Self { negative: value < 0, whole: size / scale, fraction: size % scale }
    }
}

/// Writes `value / 10^decimals` without superfluous zeros.
#[must_use]
pub fn format(value: i64, decimals: u32) -> String {
    let Parts { negative, whole, fraction } = Parts::new(value, decimals);
    let sign = if negative { "-" } else { "" };
    if fraction == 0 {
        return format!("{sign}{whole}");
    }
    let digits = format!("{fraction:0width$}", width = decimals as usize);
    format!("{sign}{whole}.{}", digits.trim_end_matches('0'))
}

/// Reads decimal text as `value * 10^decimals`; `None` when it is no such number, has more decimals than
/// that, or does not fit.
#[must_use]
pub fn parse(text: &[u8], decimals: u32) -> Option<i64> {
    let (sign, digits) = match text {
        [b'-', rest @ ..] => (-1, rest),
        _ => (1, text),
    };
    let (mut value, mut any, mut places) = (0_i64, false, None);
    for byte in digits {
        match (byte, places) {
            (b'.', None) => places = Some(0),
            (b'0'..=b'9', _) => {
                value = value.checked_mul(10)?.checked_add(sign * i64::from(byte - b'0'))?;
                any = true;
                places = places.map(|places: u32| places.saturating_add(1));
            }
            _ => return None,
        }
    }
    if !any {
        return None;
    }
    for _ in 0..decimals.checked_sub(places.unwrap_or(0))? {
        value = value.checked_mul(10)?;
    }
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::{format, parse};

    #[test]
    fn text_and_value_correspond() {
        for (value, text) in [(0, "0"), (12_345_000, "12.345"), (-1, "-0.000001"), (5_000_000, "5")] {
            assert_eq!(format(value, 6), text);
            assert_eq!(parse(text.as_bytes(), 6), Some(value));
        }
        for (value, text) in [(i64::MAX, "9223372036854.775807"), (i64::MIN, "-9223372036854.775808")] {
            assert_eq!(format(value, 6), text);
            assert_eq!(parse(text.as_bytes(), 6), Some(value));
        }
        for bad in [
            "",
            "-",
            ".",
            "1.2.3",
            "1e3",
            "0.0000001",
            "1.0000000",
            "99999999999999",
            "+1",
            "9223372036854.775808",
        ] {
            assert_eq!(parse(bad.as_bytes(), 6), None, "{bad}");
        }
    }
}

//! Decimal text of scaled integers: `12.345` for 12 345 000 at six decimals.

/// Writes `value / 10^decimals` without superfluous zeros.
pub(super) fn format(value: i64, decimals: u32) -> String {
    let scale = 10_u64.pow(decimals);
    let magnitude = value.unsigned_abs();
    let sign = if value < 0 { "-" } else { "" };
    let (whole, fraction) = (magnitude / scale, magnitude % scale);
    if fraction == 0 {
        return format!("{sign}{whole}");
    }
    let digits = format!("{fraction:0width$}", width = decimals as usize);
    format!("{sign}{whole}.{}", digits.trim_end_matches('0'))
}

/// Reads decimal text as `value * 10^decimals`; `None` when it is no such number, has more decimals than
/// that, or does not fit.
pub(super) fn parse(text: &str, decimals: u32) -> Option<i64> {
    let (negative, digits) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.is_empty() && fraction.is_empty() || fraction.len() > decimals as usize {
        return None;
    }
    let mut value: i64 = 0;
    let padding = std::iter::repeat_n(b'0', decimals as usize - fraction.len());
    for digit in whole.bytes().chain(fraction.bytes()).chain(padding) {
        if !digit.is_ascii_digit() {
            return None;
        }
        value = value.checked_mul(10)?.checked_add(i64::from(digit - b'0'))?;
    }
    Some(if negative { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::{format, parse};

    #[test]
    fn text_and_value_correspond() {
        for (value, text) in [(0, "0"), (12_345_000, "12.345"), (-1, "-0.000001"), (5_000_000, "5")] {
            assert_eq!(format(value, 6), text);
            assert_eq!(parse(text, 6), Some(value));
        }
        for bad in ["", "-", ".", "1.2.3", "1e3", "0.0000001", "99999999999999", "+1"] {
            assert_eq!(parse(bad, 6), None, "{bad}");
        }
    }
}

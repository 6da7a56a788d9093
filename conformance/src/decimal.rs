//! Decimal text of any length as an exact number, so that a tolerance is judged without rounding.

use std::cmp::Ordering;
use std::fmt;

use dashu_int::IBig;
use serde::{Deserialize, Deserializer, de};

/// The longest text that is a number: more than any binary64 needs, and little enough to compute with.
const LONGEST: usize = 1200;

/// An exact decimal number.
#[derive(Clone, Debug, Default)]
pub struct Decimal {
    digits: IBig,
    /// How many of the digits stand behind the point.
    decimals: usize,
}

impl Decimal {
    /// Reads a sign, digits and a point; `None` for anything else, and for more than 1200 characters.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (sign, unsigned) = text.strip_prefix('-').map_or(("", text), |rest| ("-", rest));
        let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, ""));
        let mut digits = whole.bytes().chain(fraction.bytes()).peekable();
        if text.len() > LONGEST || digits.peek().is_none() || !digits.all(|each| each.is_ascii_digit()) {
            return None;
        }
        let digits = IBig::from_str_radix(&format!("{sign}{whole}{fraction}"), 10).ok()?;
        Some(Self { digits, decimals: fraction.len() })
    }

    /// How far two numbers are apart.
    #[must_use]
    pub fn distance(&self, other: &Self) -> Self {
        let decimals = self.decimals.max(other.decimals);
        let difference = self.digits_at(decimals) - other.digits_at(decimals);
        Self { digits: if difference < IBig::ZERO { -difference } else { difference }, decimals }
    }

    /// How far two directions are apart, in degrees: 359 and 1 by 2.
    #[must_use]
    pub fn distance_round_the_circle(&self, other: &Self) -> Self {
        let Self { digits, decimals } = self.distance(other);
        let circle = IBig::from(360) * IBig::from(10).pow(decimals);
        let one_way = digits % &circle;
        let other_way = &circle - &one_way;
        Self { digits: one_way.min(other_way), decimals }
    }

    fn digits_at(&self, decimals: usize) -> IBig {
        &self.digits * IBig::from(10).pow(decimals.saturating_sub(self.decimals))
    }
}

impl PartialEq for Decimal {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Decimal {}

impl PartialOrd for Decimal {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Decimal {
    fn cmp(&self, other: &Self) -> Ordering {
        let decimals = self.decimals.max(other.decimals);
        self.digits_at(decimals).cmp(&other.digits_at(decimals))
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.digits.to_string();
        let (sign, digits) = text.strip_prefix('-').map_or(("", text.as_str()), |rest| ("-", rest));
        let padded = format!("{digits:0>width$}", width = self.decimals + 1);
        let (whole, fraction) = padded.split_at(padded.len() - self.decimals);
        let fraction = fraction.trim_end_matches('0');
        let point = if fraction.is_empty() { "" } else { "." };
        write!(f, "{sign}{whole}{point}{fraction}")
    }
}

impl<'de> Deserialize<'de> for Decimal {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Visitor)
    }
}

/// Accepts decimal text or a number; a float stands for its shortest decimal text.
struct Visitor;

impl de::Visitor<'_> for Visitor {
    type Value = Decimal;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a decimal number, or decimal text")
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Decimal, E> {
        Decimal::parse(text).ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Decimal, E> {
        Ok(Decimal { digits: value.into(), decimals: 0 })
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Decimal, E> {
        let number = Decimal::parse(&value.to_string());
        number.ok_or_else(|| E::invalid_value(de::Unexpected::Float(value), &self))
    }
}

#[cfg(test)]
mod tests {
    use super::{Decimal, LONGEST};

    fn decimal(text: &str) -> Decimal {
        Decimal::parse(text).unwrap_or_else(|| panic!("{text} is no number"))
    }

    #[test]
    fn spellings_of_one_number_are_equal() {
        for (left, right) in [("50", "50.000"), ("-0", "0"), (".5", "0.5"), ("5.", "5"), ("-1.20", "-1.2")] {
            assert_eq!(decimal(left), decimal(right));
        }
        assert!(decimal("-1.5") < decimal("-1.49"));
    }

    #[test]
    fn text_reads_back() {
        for text in ["0", "12.345", "-0.000001", "100", "-100.5", &"9".repeat(400)] {
            assert_eq!(decimal(text).to_string(), *text);
        }
    }

    #[test]
    fn other_text_is_no_number() {
        for text in ["", "-", ".", "1.2.3", "1e3", "+1", "NaN", "٣", "1 ", &"1".repeat(LONGEST + 1)] {
            assert!(Decimal::parse(text).is_none(), "{text}");
        }
    }

    #[test]
    fn distances_are_exact() {
        assert_eq!(decimal("0.3").distance(&decimal("0.1")), decimal("0.2"));
        assert_eq!(decimal("-1").distance(&decimal("0.000000000000000001")), decimal("1.000000000000000001"));
        assert_eq!(decimal("359.9").distance_round_the_circle(&decimal("0.2")), decimal("0.3"));
        assert_eq!(decimal("-90").distance_round_the_circle(&decimal("270")), decimal("0"));
        assert_eq!(decimal("0").distance_round_the_circle(&decimal("720")), decimal("0"));
        assert_eq!(decimal("10").distance_round_the_circle(&decimal("190")), decimal("180"));
    }
}

//! One newtype a physical quantity, each a whole number of a small unit, exact everywhere.
//!
//! In JSON and in compact notation a quantity is decimal text in its usual unit (`"12.345"`); in a
//! set-up file it is a TOML number or such text.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::decimal;

macro_rules! quantity {
    ($(#[$meta:meta])* $name:ident, $decimals:literal, $usual:literal) => {
        $(#[$meta])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
        pub struct $name(pub i64);

        impl $name {
            /// Number of decimals of the text form.
            pub const DECIMALS: u32 = $decimals;

            #[doc = concat!("Reads decimal text in ", $usual, ".")]
            #[must_use]
            pub fn parse(text: &str) -> Option<Self> {
                decimal::parse(text.as_bytes(), $decimals).map(Self)
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(&decimal::format(self.0, $decimals))
            }
        }

        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(DecimalVisitor { decimals: $decimals, usual: $usual }).map(Self)
            }
        }
    };
}

quantity!(
    /// A length in nanometres. X lengths are diameters unless the name says radius.
    Length, 6, "millimetres"
);
quantity!(
    /// An angle in micro-degrees.
    Angle, 6, "degrees"
);
quantity!(
    /// A feed in picometres (1e-9 mm) per minute or per revolution.
    FeedRate, 9, "millimetres"
);
quantity!(
    /// A rotational speed in thousandths of a revolution per minute.
    Speed, 3, "revolutions per minute"
);
quantity!(
    /// A cutting speed in micrometres per minute.
    CuttingSpeed, 6, "metres per minute"
);
quantity!(
    /// A time in microseconds.
    Duration, 6, "seconds"
);

/// Accepts a decimal number, or decimal text, of a whole number of small units.
struct DecimalVisitor {
    decimals: u32,
    usual: &'static str,
}

impl de::Visitor<'_> for DecimalVisitor {
    type Value = i64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a number of {} with at most {} decimals", self.usual, self.decimals)
    }

    fn visit_i64<E: de::Error>(self, value: i64) -> Result<i64, E> {
        value
            .checked_mul(10_i64.pow(self.decimals))
            .ok_or_else(|| E::invalid_value(de::Unexpected::Signed(value), &self))
    }

    fn visit_u64<E: de::Error>(self, value: u64) -> Result<i64, E> {
        match i64::try_from(value) {
            Ok(value) => self.visit_i64(value),
            Err(_) => Err(E::invalid_value(de::Unexpected::Unsigned(value), &self)),
        }
    }

    /// A float stands for its shortest decimal text: 0.1 is one tenth.
    fn visit_f64<E: de::Error>(self, value: f64) -> Result<i64, E> {
        decimal::parse(value.to_string().as_bytes(), self.decimals)
            .ok_or_else(|| E::invalid_value(de::Unexpected::Float(value), &self))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<i64, E> {
        decimal::parse(text.as_bytes(), self.decimals)
            .ok_or_else(|| E::invalid_value(de::Unexpected::Str(text), &self))
    }
}

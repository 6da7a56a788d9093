//! How far a field may be from the expected one: which fields are what quantity, and the largest difference
//! of each quantity that an implementation declares.

use serde::Deserialize;

use crate::Decimal;

/// The largest permitted differences.
#[derive(Clone, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Tolerance {
    /// Of lengths, in millimetres.
    pub length: Decimal,
    /// Of angles, in degrees.
    pub angle: Decimal,
    /// Of the number of a feed.
    pub feed: Decimal,
    /// Of spindle speeds in revolutions per minute and of cutting speeds in metres per minute.
    pub speed: Decimal,
    /// Of times, in seconds.
    pub time: Decimal,
    /// Of the values of variables.
    pub value: Decimal,
}

/// What a field measures.
#[derive(Clone, Copy)]
enum Quantity {
    Length,
    Angle,
    /// A direction: a full turn changes nothing.
    Direction,
    Feed,
    Speed,
    Time,
    Value,
}

/// How the text of a field relates to the expected one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Relation {
    /// Equal, or within the tolerance.
    Fits,
    /// Numbers that are too far apart, and by how much.
    Apart(Decimal),
    /// Different, and not two numbers with one unit.
    Differs,
}

impl Tolerance {
    /// The quantity with a negative tolerance, if there is one.
    #[must_use]
    pub fn negative(&self) -> Option<&'static str> {
        let Self { length, angle, feed, speed, time, value } = self;
        let quantities = [
            ("length", length),
            ("angle", angle),
            ("feed", feed),
            ("speed", speed),
            ("time", time),
            ("value", value),
        ];
        let zero = Decimal::default();
        quantities.into_iter().find(|(_, tolerance)| **tolerance < zero).map(|(name, _)| name)
    }

    /// Compares the texts of one field of an event.
    #[must_use]
    pub fn relation(&self, kind: &str, field: &str, expected: &str, actual: &str) -> Relation {
        if expected == actual {
            return Relation::Fits;
        }
        let (expected, expected_unit) = number_and_unit(expected);
        let (actual, actual_unit) = number_and_unit(actual);
        let (Some(expected), Some(actual)) = (Decimal::parse(expected), Decimal::parse(actual)) else {
            return Relation::Differs;
        };
        if expected_unit != actual_unit {
            return Relation::Differs;
        }
        let quantity = quantity(kind, field);
        let distance = match quantity {
            Some(Quantity::Direction) => expected.distance_round_the_circle(&actual),
            _ => expected.distance(&actual),
        };
        let fits = match quantity {
            Some(quantity) => distance <= *self.of(quantity),
            None => distance == Decimal::default(),
        };
        if fits { Relation::Fits } else { Relation::Apart(distance) }
    }

    fn of(&self, quantity: Quantity) -> &Decimal {
        match quantity {
            Quantity::Length => &self.length,
            Quantity::Angle | Quantity::Direction => &self.angle,
            Quantity::Feed => &self.feed,
            Quantity::Speed => &self.speed,
            Quantity::Time => &self.time,
            Quantity::Value => &self.value,
        }
    }
}

fn quantity(kind: &str, field: &str) -> Option<Quantity> {
    match (kind, field) {
        // Percent of the rated torque, whole numbers.
        ("torque", _) => None,
        (_, "x" | "z" | "w" | "mx" | "mz" | "mw" | "tx" | "tz" | "nx" | "nz" | "cx" | "cz" | "path")
        | (_, "px" | "py" | "qx" | "qy" | "pcx" | "pcy" | "pu" | "pcu" | "pcz" | "lead" | "change") => {
            Some(Quantity::Length)
        }
        ("frame", "c") | (_, "c_travel") => Some(Quantity::Angle),
        (_, "c" | "mc" | "tc" | "start") => Some(Quantity::Direction),
        (_, "f") => Some(Quantity::Feed),
        (_, "speed" | "clamp" | "surface") => Some(Quantity::Speed),
        (_, "time") => Some(Quantity::Time),
        (_, "value") => Some(Quantity::Value),
        _ => None,
    }
}

/// `0.2mm/rev` is 0.2 and its unit.
fn number_and_unit(text: &str) -> (&str, &str) {
    text.split_at(text.find(|each: char| !matches!(each, '0'..='9' | '.' | '-')).unwrap_or(text.len()))
}

#[cfg(test)]
mod tests {
    use super::{Relation, Tolerance};
    use crate::Decimal;

    fn tolerance(text: &str) -> Tolerance {
        toml::from_str(text).unwrap_or_else(|error| panic!("{error}"))
    }

    fn fits(tolerance: &Tolerance, kind: &str, field: &str, expected: &str, actual: &str) -> bool {
        tolerance.relation(kind, field, expected, actual) == Relation::Fits
    }

    #[test]
    fn without_a_tolerance_numbers_are_equal_as_numbers() {
        let exact = Tolerance::default();
        assert!(fits(&exact, "rapid", "x", "50", "50.000"));
        assert!(fits(&exact, "tool", "tool", "1", "1.0"));
        assert!(fits(&exact, "linear", "f", "0.2mm/rev", "0.20mm/rev"));
        assert!(!fits(&exact, "linear", "f", "0.2mm/rev", "0.2mm/min"));
        assert!(!fits(&exact, "rapid", "x", "50", "50.000000000000000001"));
        assert!(!fits(&exact, "mode", "code", "G01", "G1"));
        assert!(!fits(&exact, "rapid", "x", "0", "zero"));
    }

    #[test]
    fn each_field_has_the_tolerance_of_its_quantity() {
        for (quantity, kind, fields) in [
            (
                "length",
                "linear",
                &["x", "z", "w", "mx", "mz", "mw", "tx", "tz", "nx", "nz", "cx", "cz", "path"][..],
            ),
            ("length", "frame", &["x", "z", "w"]),
            ("length", "linear", &["px", "py", "qx", "qy"]),
            ("length", "contour_arc", &["pcx", "pcy", "pu", "pcu", "pcz"]),
            ("length", "thread", &["lead", "change"]),
            ("angle", "thread", &["start"]),
            ("angle", "linear", &["c", "mc", "tc", "c_travel"]),
            ("angle", "frame", &["c"]),
            ("feed", "linear", &["f"]),
            ("speed", "spindle", &["speed", "clamp", "surface"]),
            ("time", "dwell", &["time"]),
            ("value", "variable", &["value"]),
        ] {
            let tolerance = tolerance(&format!("{quantity} = '0.5'"));
            for field in fields {
                assert!(fits(&tolerance, kind, field, "10", "10.5"), "{kind} {field}");
                assert!(!fits(&tolerance, kind, field, "10", "10.500001"), "{kind} {field}");
                assert!(!fits(&Tolerance::default(), kind, field, "10", "10.5"), "{kind} {field}");
            }
        }
        assert!(!fits(&tolerance("length = 1"), "torque", "z", "30", "31"));
        assert!(!fits(&tolerance("length = 1"), "tool", "offset", "3", "4"));
    }

    #[test]
    fn directions_are_compared_round_the_circle() {
        let tolerance = tolerance("angle = 0.01");
        assert!(fits(&tolerance, "rapid", "c", "0", "359.99"));
        assert!(!fits(&tolerance, "rapid", "c_travel", "0", "360"));
        assert!(!fits(&tolerance, "frame", "c", "0", "360"));
    }

    #[test]
    fn the_distance_is_told() {
        let apart = Tolerance::default().relation("linear", "f", "0.2mm/rev", "0.25mm/rev");
        assert_eq!(Decimal::parse("0.05").map(Relation::Apart), Some(apart));
    }

    #[test]
    fn a_negative_or_unknown_tolerance_is_refused() {
        assert_eq!(tolerance("speed = -1").negative(), Some("speed"));
        assert_eq!(tolerance("speed = 1").negative(), None);
        assert!(toml::from_str::<Tolerance>("sped = 1").is_err());
        assert!(toml::from_str::<Tolerance>("speed = inf").is_err());
    }
}

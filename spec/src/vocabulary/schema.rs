//! JSON Schemas of the types with a text form of their own.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use super::{
    Angle, CuttingSpeed, Duration, FeedRate, Label, Length, ProgramText, Reading, ReadingSet, RuleSet, Speed,
    Text,
};

macro_rules! decimal_schema {
    ($($type:ident $unit:literal)*) => {$(
        impl JsonSchema for $type {
            fn schema_name() -> Cow<'static, str> {
                stringify!($type).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                json_schema!({
                    "description": concat!("Exact decimal number of ", $unit),
                    "anyOf": [
                        { "type": "string", "pattern": "^-?(\\d+\\.?\\d*|\\.\\d+)$" },
                        { "type": "number" }
                    ]
                })
            }
        }
    )*};
}

decimal_schema! {
    Length "millimetres"
    Angle "degrees"
    FeedRate "millimetres per minute or revolution"
    Speed "revolutions per minute"
    CuttingSpeed "metres per minute"
    Duration "seconds"
}

impl JsonSchema for Label {
    fn schema_name() -> Cow<'static, str> {
        "Label".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "maxLength": 24 })
    }
}

impl JsonSchema for Text {
    fn schema_name() -> Cow<'static, str> {
        "Text".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Characters: the codes 21 to 7E but the backslash plain, every other code as \\xHH",
            "type": "string"
        })
    }
}

impl JsonSchema for ProgramText {
    fn schema_name() -> Cow<'static, str> {
        "ProgramText".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "The bytes of a program, one character a byte (U+0000 to U+00FF)",
            "type": "string"
        })
    }
}

impl JsonSchema for RuleSet {
    fn schema_name() -> Cow<'static, str> {
        "Rules".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "array", "items": { "type": "string", "pattern": "^[A-Z0-9]+-[A-Z0-9]+-\\d{2}$" } })
    }
}

impl JsonSchema for ReadingSet {
    fn schema_name() -> Cow<'static, str> {
        "NamedReadings".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let names: Vec<&str> = Reading::ALL.iter().map(|reading| reading.as_str()).collect();
        json_schema!({ "type": "array", "items": { "enum": names } })
    }
}

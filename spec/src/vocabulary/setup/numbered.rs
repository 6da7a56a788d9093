//! Maps by number, whose keys are text in a set-up file.

use std::collections::BTreeMap;

use serde::de::{Error, Unexpected};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Writes the numbers as text.
pub fn serialize<V: Serialize, S: Serializer>(
    map: &BTreeMap<u16, V>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(map.iter().map(|(number, value)| (number.to_string(), value)))
}

/// Reads the numbers; each has one text, without sign and leading zeros.
pub fn deserialize<'de, V: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<BTreeMap<u16, V>, D::Error> {
    let map: BTreeMap<String, V> = BTreeMap::deserialize(deserializer)?;
    let number = |(key, value): (String, V)| match key.parse::<u16>() {
        Ok(number) if number.to_string() == key => Ok((number, value)),
        _ => Err(D::Error::invalid_value(
            Unexpected::Str(&key),
            &"a number from 0 to 65535 without sign and leading zeros",
        )),
    };
    map.into_iter().map(number).collect()
}

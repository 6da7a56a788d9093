//! An event that an implementation reports, as its kind and its fields in compact notation.
//!
//! A line of JSON is foreign: anything may be missing, and keys that the vocabulary does not know are passed
//! over. What is there has to have the shape that `schemas/event.schema.json` describes.

use std::fmt;

use serde_json::{Map, Value};
use turnspec_oracle::vocabulary::{Event, notation};

/// Every kind of event.
pub const KINDS: &[&str] = &[
    "rapid",
    "linear",
    "arc",
    "contour_arc",
    "thread",
    "dwell",
    "spindle",
    "tool",
    "coolant",
    "aux",
    "torque",
    "frame",
    "mode",
    "variable",
    "call",
    "return",
    "output",
    "message",
    "select",
    "wait",
    "release",
    "side_end",
    "stop",
    "optional_stop",
    "end",
    "alarm",
];

/// Keys of an event that stand for a field by themselves, and the field.
const PLAIN: &[(&str, &str)] = &[
    ("tip_c", "tc"),
    ("c_travel", "c_travel"),
    ("path", "path"),
    ("sense", "sense"),
    ("centre_x", "cx"),
    ("centre_z", "cz"),
    ("speed", "speed"),
    ("time", "time"),
    ("spindle", "spindle"),
    ("state", "state"),
    ("surface", "surface"),
    ("limit", "limit"),
    ("gear", "gear"),
    ("clamp", "clamp"),
    ("with_motion", "with_motion"),
    ("tool", "tool"),
    ("offset", "offset"),
    ("index", "index"),
    ("on", "on"),
    ("code", "code"),
    ("group", "group"),
    ("cause", "cause"),
    ("previous", "previous"),
    ("angle", "angle"),
    ("name", "name"),
    ("number", "number"),
    ("detail", "detail"),
    ("device", "device"),
    ("text", "text"),
    ("end_code", "end_code"),
    ("file", "file"),
    ("repetition", "repetition"),
    ("lead", "lead"),
    ("axis", "axis"),
    ("change", "change"),
    ("start", "start"),
    ("pass", "pass"),
    ("part", "part"),
    ("p", "p"),
    ("turret", "turret"),
    ("saddle", "saddle"),
];
const PROGRAM: &[(&str, &str)] = &[("x", "x"), ("z", "z"), ("c", "c"), ("w", "w")];
const MACHINE: &[(&str, &str)] = &[("x", "mx"), ("z", "mz"), ("c", "mc"), ("w", "mw")];
const TIP: &[(&str, &str)] = &[("x", "tx"), ("z", "tz")];
const NOSE: &[(&str, &str)] = &[("x", "nx"), ("z", "nz")];
/// A tool event has its radius number where a motion has its nose centre.
const NOSE_NUMBER: &[(&str, &str)] = &[("nose", "nose")];
const FACE: &[(&str, &str)] = &[("x", "px"), ("y", "py")];
const FACE_TIP: &[(&str, &str)] = &[("x", "qx"), ("y", "qy")];
const FACE_CENTRE: &[(&str, &str)] = &[("x", "pcx"), ("y", "pcy")];
const SIDE_ARC: &[(&str, &str)] = &[("travel", "pu"), ("centre", "pcu"), ("centre_z", "pcz")];
const BLOCK: &[(&str, &str)] = &[("line", "line"), ("sequence", "block"), ("program", "program")];

/// Fields that tell the block: compared only when an implementation reports them.
pub const PLACE: &[&str] = &["line", "block", "program"];

/// The most characters of one event that a report shows.
const SHOWN: usize = 600;

/// Whether compact notation has such a field.
#[must_use]
pub fn is_field(name: &str) -> bool {
    let tables =
        [PLAIN, PROGRAM, MACHINE, TIP, NOSE, NOSE_NUMBER, FACE, FACE_TIP, FACE_CENTRE, SIDE_ARC, BLOCK];
    ["f", "value"].contains(&name) || tables.into_iter().flatten().any(|(_, field)| *field == name)
}

/// An event that was reported.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Observation {
    /// Its kind.
    pub kind: String,
    /// Its fields by their names in compact notation, `line`, `block` and `program` among them.
    pub fields: Vec<(&'static str, String)>,
}

impl Observation {
    /// Reads a line of JSON.
    ///
    /// # Errors
    /// Why the line is no event, in words.
    pub fn from_json(line: &str) -> Result<Self, String> {
        let value: Value = serde_json::from_str(line).map_err(|error| format!("no JSON: {error}"))?;
        let Value::Object(object) = value else { return Err("no JSON object".to_owned()) };
        let kind = match object.get("kind") {
            Some(Value::String(kind)) => kind.clone(),
            Some(_) => return Err("`kind` is no text".to_owned()),
            None => return Err("no `kind`".to_owned()),
        };
        let mut fields = Fields(Vec::new());
        fields.members("program", &object, PROGRAM)?;
        fields.members("machine", &object, MACHINE)?;
        fields.members("tip", &object, TIP)?;
        fields.members("face", &object, FACE)?;
        fields.members("face_tip", &object, FACE_TIP)?;
        fields.members("face_centre", &object, FACE_CENTRE)?;
        fields.members("side_arc", &object, SIDE_ARC)?;
        if kind == "tool" {
            fields.scalars("", &object, NOSE_NUMBER)?;
        } else {
            fields.members("nose", &object, NOSE)?;
        }
        if ["frame", "torque"].contains(&kind.as_str()) {
            fields.scalars("", &object, PROGRAM)?;
        }
        fields.scalars("", &object, PLAIN)?;
        fields.feed(&object)?;
        fields.value(&object)?;
        fields.members("block", &object, BLOCK)?;
        Ok(Self { kind, fields: fields.0 })
    }

    /// What the event of a trace of ours looks like.
    #[must_use]
    pub fn of(event: &Event) -> Self {
        let mut kind = String::new();
        let mut fields = Vec::new();
        for (name, value) in notation::fields(event) {
            if name.is_empty() {
                kind = value;
            } else {
                fields.push((name, value));
            }
        }
        let block = &event.block;
        fields.push(("line", block.line.to_string()));
        for (name, label) in [("block", block.sequence), ("program", block.program)] {
            if !label.is_empty() {
                fields.push((name, label.to_string()));
            }
        }
        Self { kind, fields }
    }

    /// The text of a field.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<&str> {
        self.fields.iter().find(|(field, _)| *field == name).map(|(_, value)| value.as_str())
    }
}

/// Compact notation, control characters escaped; cut when it is very long.
impl fmt::Display for Observation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = self.kind.clone();
        for (name, value) in &self.fields {
            text.push_str(&format!(" {name}={value}"));
        }
        f.write_str(&printable(&text, SHOWN))
    }
}

/// Foreign text for people: control characters escaped, cut after `most` characters.
#[must_use]
pub fn printable(text: &str, most: usize) -> String {
    let mut shown = String::new();
    for each in text.chars().take(most) {
        if each.is_control() {
            shown.extend(each.escape_default());
        } else {
            shown.push(each);
        }
    }
    if text.chars().nth(most).is_some() {
        shown.push('…');
    }
    shown
}

struct Fields(Vec<(&'static str, String)>);

impl Fields {
    /// The members of the object under a key.
    fn members(
        &mut self,
        key: &str,
        object: &Map<String, Value>,
        table: &'static [(&'static str, &'static str)],
    ) -> Result<(), String> {
        match object.get(key) {
            None | Some(Value::Null) => Ok(()),
            Some(Value::Object(members)) => self.scalars(key, members, table),
            Some(_) => Err(format!("`{key}` is no object")),
        }
    }

    fn scalars(
        &mut self,
        place: &str,
        object: &Map<String, Value>,
        table: &'static [(&'static str, &'static str)],
    ) -> Result<(), String> {
        for (key, field) in table {
            let dot = if place.is_empty() { "" } else { "." };
            let text = scalar(object.get(*key)).ok_or_else(|| format!("`{place}{dot}{key}` is no scalar"))?;
            self.add(field, text);
        }
        Ok(())
    }

    /// The words for a way round are shortened; a field that says nothing is left out.
    fn add(&mut self, field: &'static str, text: Option<String>) {
        // Characters that are sent may be none at all.
        let Some(text) = text.filter(|text| !text.is_empty() || field == "text") else { return };
        let text = match (field, text.as_str()) {
            ("sense" | "state", "clockwise") => "cw".to_owned(),
            ("sense" | "state", "counter_clockwise") => "ccw".to_owned(),
            ("with_motion", "false") => return,
            _ => text,
        };
        self.0.push((field, text));
    }

    fn feed(&mut self, object: &Map<String, Value>) -> Result<(), String> {
        let feed = match object.get("feed") {
            None | Some(Value::Null) => return Ok(()),
            Some(Value::Object(feed)) => feed,
            Some(_) => return Err("`feed` is no object".to_owned()),
        };
        let part = |key: &str| match scalar(feed.get(key)) {
            Some(Some(text)) => Ok(text),
            _ => Err(format!("`feed.{key}` is missing or no scalar")),
        };
        self.add("f", Some(part("value")? + &part("unit")?));
        Ok(())
    }

    /// The value of a variable, `{"real": 0.5}`; a bare number will do.
    fn value(&mut self, object: &Map<String, Value>) -> Result<(), String> {
        let inner = match object.get("value") {
            Some(Value::Object(members)) => {
                let mut known =
                    ["real", "integer", "length", "angle", "text"].iter().filter_map(|key| members.get(*key));
                match (known.next(), known.next()) {
                    (Some(value), None) => Some(value),
                    _ => return Err("`value` is not one of real, integer, length, angle, text".to_owned()),
                }
            }
            other => other,
        };
        let text = scalar(inner).ok_or("`value` is no scalar")?;
        self.add("value", text);
        Ok(())
    }
}

/// The text of a scalar, inner `None` when there is none; outer `None` for an array or an object.
fn scalar(value: Option<&Value>) -> Option<Option<String>> {
    match value {
        None | Some(Value::Null) => Some(None),
        Some(Value::String(text)) => Some(Some(text.clone())),
        Some(Value::Bool(flag)) => Some(Some(flag.to_string())),
        // A float is written without exponent.
        Some(Value::Number(number)) => Some(Some(match number.as_f64() {
            Some(real) if number.is_f64() => real.to_string(),
            _ => number.to_string(),
        })),
        Some(Value::Array(_) | Value::Object(_)) => None,
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Event, Setup, notation};

    use super::{KINDS, Observation, is_field};

    fn read(line: &str) -> String {
        Observation::from_json(line).map_or_else(|error| error, |event| event.to_string())
    }

    #[test]
    fn an_event_of_ours_survives_the_way_through_json() -> Result<(), String> {
        let program = b"O1\nN1 G50 S2000 M42\nG00 X50 Z2 T0101 M08\nM110\nG01 X40 Z-5 C90 F100 G94\nM109 M00\nM01\nV5=0.1 VTOFX[3]=1\n\
            G02 X50 Z-10 L5\nG04 F1\nG29 PZ=30\nG96 S100 M03\nG00 X1 M63 M04 S5\nM02\n";
        let toml = "[options]\nnose_radius_compensation = false\n[switches]\noptional_stop = true";
        let setup = Setup::from_toml(toml).map_err(|error| error.to_string())?;
        let mut kinds = std::collections::BTreeSet::new();
        let mut faults = Vec::new();
        turnspec_oracle::run(program, &setup, &mut |event: &Event| {
            let json = serde_json::to_string(event).unwrap_or_default();
            let sorted = |observation: Observation| {
                let Observation { kind, mut fields } = observation;
                fields.sort();
                (kind, fields)
            };
            match Observation::from_json(&json) {
                Ok(read) if sorted(read.clone()) == sorted(Observation::of(event)) => kinds.insert(read.kind),
                other => {
                    faults.push(format!("{} became {other:?}", notation::render(event)));
                    false
                }
            };
        });
        assert!(faults.is_empty(), "{}", faults.join("\n"));
        assert!(kinds.iter().all(|kind| KINDS.contains(&kind.as_str())), "{kinds:?}");
        assert!(kinds.len() > 10, "{kinds:?}");
        Ok(())
    }

    #[test]
    fn foreign_spellings_are_read() {
        for (line, expected) in [
            (r#"{"kind": "stop"}"#, "stop"),
            (
                r#"{"kind": "rapid", "program": {"x": 50, "z": "2"}, "x": 7, "unknown": [1]}"#,
                "rapid x=50 z=2",
            ),
            (
                r#"{"kind": "frame", "cause": "zero_shift", "x": 1.5, "c": null}"#,
                "frame x=1.5 cause=zero_shift",
            ),
            (r#"{"kind": "variable", "name": "V1", "value": 1e-7}"#, "variable name=V1 value=0.0000001"),
            (
                r#"{"kind": "spindle", "state": "counter_clockwise", "gear": "", "with_motion": false}"#,
                "spindle state=ccw",
            ),
            (r#"{"kind": "a\u001b[2J"}"#, "a\\u{1b}[2J"),
        ] {
            assert_eq!(read(line), expected);
        }
    }

    #[test]
    fn what_is_no_event_is_refused() {
        for line in [
            "rapid x=1",
            "[]",
            "{}",
            r#"{"kind": 1}"#,
            r#"{"kind": "rapid", "program": 5}"#,
            r#"{"kind": "rapid", "program": {"x": {}}}"#,
            r#"{"kind": "linear", "feed": {"value": 1}}"#,
            r#"{"kind": "linear", "feed": 1}"#,
            r#"{"kind": "variable", "value": {}}"#,
            r#"{"kind": "variable", "value": {"real": 1, "integer": 1}}"#,
            r#"{"kind": "variable", "value": NaN}"#,
            r#"{"kind": "dwell", "time": 1e999}"#,
            r#"{"kind": "stop"} {"kind": "stop"}"#,
            &("[".repeat(100_000)),
        ] {
            assert!(Observation::from_json(line).is_err(), "{line:.60}");
        }
    }

    #[test]
    fn fields_are_known_by_their_compact_names() {
        assert!(["x", "mw", "cx", "f", "value", "path", "line", "block"].into_iter().all(is_field));
        assert!(!["centre_x", "feed", "kind", "rules", "n"].into_iter().any(is_field));
    }
}

//! A trace as comma-separated values: one event a line, the same columns for every kind of event.

use std::io::{self, Write};

use turnspec_oracle::vocabulary::{Event, notation};

/// The columns, in order. After the place of the event, its kind, and its fields as compact notation names
/// them; the feed and its unit are apart.
pub const COLUMNS: [&str; 69] = [
    "n",
    "line",
    "sequence",
    "program",
    "kind",
    "x",
    "z",
    "c",
    "w",
    "mx",
    "mz",
    "mc",
    "mw",
    "tx",
    "tz",
    "tc",
    "nx",
    "nz",
    "px",
    "py",
    "qx",
    "qy",
    "c_travel",
    "speed",
    "feed",
    "feed_unit",
    "path",
    "sense",
    "cx",
    "cz",
    "pcx",
    "pcy",
    "pu",
    "pcu",
    "pcz",
    "lead",
    "axis",
    "change",
    "start",
    "pass",
    "part",
    "time",
    "spindle",
    "state",
    "surface",
    "limit",
    "gear",
    "clamp",
    "with_motion",
    "tool",
    "offset",
    "nose",
    "index",
    "on",
    "code",
    "group",
    "cause",
    "previous",
    "angle",
    "name",
    "value",
    "number",
    "detail",
    "device",
    "text",
    "end_code",
    "file",
    "repetition",
    "rules",
];

/// Writes the names of the columns.
pub fn write_header(out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "{},readings", COLUMNS.join(","))
}

/// Writes an event.
pub fn write_event(out: &mut impl Write, event: &Event) -> io::Result<()> {
    let fields = columns_of(event);
    for column in COLUMNS {
        let value = fields.iter().find(|(name, _)| *name == column).map_or("", |(_, value)| value);
        write_value(out, value)?;
        out.write_all(b",")?;
    }
    let readings: Vec<&str> = event.readings.iter().map(|reading| reading.as_str()).collect();
    write_value(out, &readings.join(" "))?;
    out.write_all(b"\n")
}

/// The values of an event by column.
fn columns_of(event: &Event) -> Vec<(&'static str, String)> {
    let rules: Vec<&str> = event.rules.as_slice().iter().map(|rule| rule.as_str()).collect();
    let mut columns = vec![
        ("n", event.n.to_string()),
        ("line", event.block.line.to_string()),
        ("sequence", event.block.sequence.to_string()),
        ("program", event.block.program.to_string()),
        ("rules", rules.join(" ")),
    ];
    for (name, value) in notation::fields(event) {
        match name {
            "" => columns.push(("kind", value)),
            "f" => {
                let (feed, unit) = value.split_at(value.find('m').unwrap_or(value.len()));
                columns.push(("feed", feed.to_owned()));
                columns.push(("feed_unit", unit.to_owned()));
            }
            _ => columns.push((name, value)),
        }
    }
    columns
}

fn write_value(out: &mut impl Write, value: &str) -> io::Result<()> {
    if value.contains(['"', ',', '\n', '\r']) {
        write!(out, "\"{}\"", value.replace('"', "\"\""))
    } else {
        out.write_all(value.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::Event;

    use super::{COLUMNS, columns_of, write_value};

    /// One event of every kind, with every optional field.
    const EVENTS: &str = r#"
        {"kind":"rapid","program":{"x":"1","z":"2","c":"3","w":"4"},"machine":{"x":"1","z":"2","c":"3","w":"4"},"tip":{"x":"5","z":"6"},"nose":{"x":"7","z":"8"},"c_travel":"5","speed":"6"}
        {"kind":"linear","program":{"x":"1","z":"2"},"machine":{"x":"1","z":"2"},"feed":{"value":"0.2","unit":"mm/rev"},"path":"7"}
        {"kind":"arc","program":{"x":"1","z":"2"},"machine":{"x":"1","z":"2"},"feed":{"value":"100","unit":"mm/min"},"sense":"clockwise","centre_x":"8","centre_z":"9"}
        {"kind":"dwell","time":"1"}
        {"kind":"spindle","spindle":"main","state":"clockwise","speed":"1","surface":"2","limit":"clamp","gear":"M41","clamp":"3","with_motion":true}
        {"kind":"tool","tool":1,"offset":2,"nose":3,"index":true}
        {"kind":"coolant","on":true}
        {"kind":"aux","code":"M147","group":"c_clamp"}
        {"kind":"torque","z":50,"w":60}
        {"kind":"frame","cause":"zero_shift","x":"1","z":"2","c":"3","w":"4"}
        {"kind":"mode","group":"feed_unit","code":"G94","previous":"G95"}
        {"kind":"variable","name":"V5","value":{"real":1.5}}
        {"kind":"stop"}
        {"kind":"optional_stop"}
        {"kind":"end","code":"M02"}
        {"kind":"alarm","name":"torque_not_reached","number":1220,"detail":"Z"}
    "#;

    #[test]
    fn every_field_of_every_kind_has_a_column() {
        let mut kinds = 0;
        for line in EVENTS.lines().map(str::trim).filter(|line| !line.is_empty()) {
            let head = r#"{"n":1,"block":{"line":1,"start":0,"end":0},"rules":[],"#;
            let event: Result<Event, _> = serde_json::from_str(&line.replacen('{', head, 1));
            assert!(event.is_ok(), "{line}: {event:?}");
            for (name, value) in event.iter().flat_map(columns_of) {
                assert!(COLUMNS.contains(&name), "{name} of {line}");
                assert!(name != "feed" || value == "0.2" || value == "100", "{value}");
            }
            kinds += 1;
        }
        assert_eq!(kinds, 16);
    }

    #[test]
    fn values_with_commas_and_quotes_are_quoted() {
        for (value, text) in [("plain", "plain"), ("a,b", "\"a,b\""), ("say \"x\"", "\"say \"\"x\"\"\"")] {
            let mut out = Vec::new();
            assert!(write_value(&mut out, value).is_ok());
            assert_eq!(out, text.as_bytes());
        }
    }
}

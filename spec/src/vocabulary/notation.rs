//! Compact trace notation: one event a line, for people and for the examples of the rule texts.
//!
//! A line is the kind of the event and its fields as `key=value`. [`render`] writes every field; a line
//! of an expected trace names those that matter, and [`Expectation`] matches it. `...` stands for any
//! number of events.

use super::{
    Action, ContourPlane, Event, Feed, FeedUnit, Label, LeadAxis, Motion, Part, Position, Sense, Side,
    SpeedLimit, Spindle, SpindleName, SpindleState, Value,
};

/// Writes an event in compact notation, every field of it, its line number, rules and readings last.
#[must_use]
pub fn render(event: &Event) -> String {
    let mut line = fields(event).into_iter().fold(String::new(), |mut line, (key, value)| {
        if key.is_empty() {
            line.push_str(&value);
        } else {
            line.push_str(&format!(" {key}={value}"));
        }
        line
    });
    let rules: Vec<&str> = event.rules.as_slice().iter().map(|rule| rule.as_str()).collect();
    line.push_str(&format!(" line={} rules={}", event.block.line, rules.join("+")));
    if !event.readings.is_empty() {
        let readings: Vec<&str> = event.readings.iter().map(|reading| reading.as_str()).collect();
        line.push_str(&format!(" readings={}", readings.join("+")));
    }
    line
}

/// The kind (under the empty key) and the fields of an event, in a fixed order.
#[must_use]
pub fn fields(event: &Event) -> Vec<(&'static str, String)> {
    let mut list = Fields(Vec::new());
    match &event.action {
        Action::Rapid { motion } => list.kind("rapid").motion(motion),
        Action::Linear { motion, feed, path } => {
            list.kind("linear").motion(motion).feed(feed).add("path", path)
        }
        Action::Arc { motion, feed, sense, centre_x, centre_z } => list
            .kind("arc")
            .motion(motion)
            .add("sense", &sense_text(*sense))
            .add("cx", centre_x)
            .add("cz", centre_z)
            .feed(feed),
        Action::Thread { motion, lead, axis, change, start, spindle, feed } => {
            let axis = match axis {
                LeadAxis::X => "x",
                LeadAxis::Z => "z",
            };
            list.kind("thread")
                .motion(motion)
                .add("lead", lead)
                .add("axis", &axis)
                .add_some("change", change.as_ref())
                .add_some("start", start.as_ref())
                .add_some("spindle", spindle.map(spindle_text).as_ref());
            match feed {
                Some(feed) => list.feed(feed),
                None => &mut list,
            }
        }
        Action::ContourArc { motion, feed, sense, plane } => {
            list.kind("contour_arc").motion(motion).add("sense", &sense_text(*sense));
            match plane {
                ContourPlane::FaceCentre(centre) => list.add("pcx", &centre.x).add("pcy", &centre.y),
                ContourPlane::SideArc(arc) => {
                    list.add("pu", &arc.travel).add("pcu", &arc.centre).add("pcz", &arc.centre_z)
                }
            };
            list.feed(feed)
        }
        Action::Dwell { time } => list.kind("dwell").add("time", time),
        Action::Spindle(spindle) => list.spindle(spindle),
        Action::Tool { tool, offset, nose, index } => {
            list.kind("tool").add("tool", tool).add("offset", offset).add("nose", nose).add("index", index)
        }
        Action::Coolant { on } => list.kind("coolant").add("on", on),
        Action::Aux { code, group } => {
            list.kind("aux").add("code", code).add_some("group", (!group.is_empty()).then_some(group))
        }
        Action::Torque { z, w } => list.kind("torque").add_some("z", z.as_ref()).add_some("w", w.as_ref()),
        Action::Frame { cause, x, z, c, w } => {
            let cause = match cause {
                super::FrameCause::ZeroOffset => "zero_offset",
                super::FrameCause::ZeroShift => "zero_shift",
                super::FrameCause::ToolOffset => "tool_offset",
            };
            list.kind("frame").add("cause", &cause).add("x", x).add("z", z).add("c", c).add("w", w)
        }
        Action::Mode { group, code, previous, angle } => list
            .kind("mode")
            .add("group", group)
            .add("code", code)
            .add_some("previous", (!previous.is_empty()).then_some(previous))
            .add_some("angle", angle.as_ref()),
        Action::Variable { name, value } => {
            list.kind("variable").add("name", name).add("value", &value_text(value))
        }
        Action::Call { name, cause } => {
            let cause = match cause {
                super::CallCause::Call => "call",
                super::CallCause::Macro => "macro",
                super::CallCause::Modal => "modal",
            };
            list.kind("call").add("name", name).add("cause", &cause)
        }
        Action::Return => list.kind("return"),
        Action::Output { device, text, end_code } => {
            list.kind("output").add("device", device).add("text", text).add("end_code", end_code)
        }
        Action::Message { number, code, text } => {
            list.kind("message").add("number", number).add("code", code).add("text", text)
        }
        Action::Select { file, name, repetition } => list
            .kind("select")
            .add("file", file)
            .add_some("name", (!name.is_empty()).then_some(name))
            .add("repetition", repetition),
        Action::Wait { p, code } => list.kind("wait").stop_point(*p, code),
        Action::Release { p, code, cause } => {
            let cause = match cause {
                super::ReleaseCause::Smaller => "smaller",
                super::ReleaseCause::Equal => "equal",
                super::ReleaseCause::PCode => "p_code",
                super::ReleaseCause::Counterpart => "counterpart",
                super::ReleaseCause::OtherEnded => "other_ended",
            };
            list.kind("release").stop_point(*p, code).add("cause", &cause)
        }
        Action::SideEnd { code } => {
            list.kind("side_end").add_some("code", (!code.is_empty()).then_some(code))
        }
        Action::Stop => list.kind("stop"),
        Action::OptionalStop => list.kind("optional_stop"),
        Action::End { code } => list.kind("end").add("code", code),
        Action::Alarm(alarm) => list
            .kind("alarm")
            .add("name", &alarm.name)
            .add_some("number", alarm.number.as_ref())
            .add_some("detail", (!alarm.detail.is_empty()).then_some(&alarm.detail)),
    };
    list.add_some("turret", event.turret.map(Side::as_str).as_ref());
    list.add_some("saddle", event.saddle.map(Side::as_str).as_ref());
    list.0
}

/// The value of a variable as text: a real in its shortest form that reads back.
#[must_use]
pub fn value_text(value: &Value) -> String {
    match value {
        Value::Real(real) => real.to_string(),
        Value::Integer(integer) => integer.to_string(),
        Value::Length(length) => length.to_string(),
        Value::Angle(angle) => angle.to_string(),
        Value::Text(text) => text.to_string(),
    }
}

/// The unit of a feed as text.
#[must_use]
pub fn feed_unit_text(unit: FeedUnit) -> &'static str {
    match unit {
        FeedUnit::PerRevolution => "mm/rev",
        FeedUnit::PerMinute => "mm/min",
    }
}

fn sense_text(sense: Sense) -> &'static str {
    match sense {
        Sense::Clockwise => "cw",
        Sense::CounterClockwise => "ccw",
    }
}

fn spindle_text(spindle: SpindleName) -> &'static str {
    match spindle {
        SpindleName::Main => "main",
        SpindleName::Tool => "tool",
        SpindleName::CAxis => "c_axis",
    }
}

struct Fields(Vec<(&'static str, String)>);

impl Fields {
    fn kind(&mut self, kind: &str) -> &mut Self {
        self.0.push(("", kind.to_owned()));
        self
    }

    fn add(&mut self, key: &'static str, value: &dyn std::fmt::Display) -> &mut Self {
        self.0.push((key, value.to_string()));
        self
    }

    fn add_some<T: std::fmt::Display>(&mut self, key: &'static str, value: Option<&T>) -> &mut Self {
        if let Some(value) = value {
            self.add(key, value);
        }
        self
    }

    /// Where a saddle waits: at a P or at a code.
    fn stop_point(&mut self, p: Option<u16>, code: &Label) -> &mut Self {
        self.add_some("p", p.as_ref()).add_some("code", (!code.is_empty()).then_some(code))
    }

    fn feed(&mut self, feed: &Feed) -> &mut Self {
        let text = format!("{}{}", feed.value, feed_unit_text(feed.unit));
        self.add("f", &text)
    }

    fn motion(&mut self, motion: &Motion) -> &mut Self {
        let Motion { program, machine, tip, nose, tip_c, face, face_tip, c_travel, speed, pass, part } =
            motion;
        self.position(program, ["x", "z", "c", "w"]).position(machine, ["mx", "mz", "mc", "mw"]);
        self.add_some("tx", tip.map(|tip| tip.x).as_ref()).add_some("tz", tip.map(|tip| tip.z).as_ref());
        self.add_some("tc", tip_c.as_ref());
        self.add_some("nx", nose.map(|nose| nose.x).as_ref())
            .add_some("nz", nose.map(|nose| nose.z).as_ref());
        self.add_some("px", face.map(|face| face.x).as_ref())
            .add_some("py", face.map(|face| face.y).as_ref());
        self.add_some("qx", face_tip.map(|tip| tip.x).as_ref())
            .add_some("qy", face_tip.map(|tip| tip.y).as_ref());
        self.add_some("c_travel", c_travel.as_ref()).add_some("speed", speed.as_ref());
        self.add_some("pass", pass.as_ref()).add_some("part", part.map(Part::as_str).as_ref())
    }

    fn position(&mut self, position: &Position, keys: [&'static str; 4]) -> &mut Self {
        let [x, z, c, w] = keys;
        self.add(x, &position.x)
            .add(z, &position.z)
            .add_some(c, position.c.as_ref())
            .add_some(w, position.w.as_ref())
    }

    fn spindle(&mut self, spindle: &Spindle) -> &mut Self {
        let name = spindle_text(spindle.spindle);
        let state = match spindle.state {
            SpindleState::Stop => "stop",
            SpindleState::Clockwise => "cw",
            SpindleState::CounterClockwise => "ccw",
            SpindleState::Orient => "orient",
        };
        let limit = spindle.limit.map(|limit| match limit {
            SpeedLimit::GearMaximum => "gear_maximum",
            SpeedLimit::GearMinimum => "gear_minimum",
            SpeedLimit::Clamp => "clamp",
        });
        self.kind("spindle").add("spindle", &name).add("state", &state).add("speed", &spindle.speed);
        self.add_some("surface", spindle.surface.as_ref()).add_some("limit", limit.as_ref());
        self.add_some("gear", (!spindle.gear.is_empty()).then_some(&spindle.gear))
            .add_some("clamp", spindle.clamp.as_ref());
        if spindle.with_motion {
            self.add("with_motion", &true);
        }
        self
    }
}

/// An expected trace in compact notation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expectation {
    lines: Vec<String>,
}

impl Expectation {
    /// Reads an expected trace: one event a line; empty lines and lines that begin with `#` are remarks.
    #[must_use]
    pub fn parse(text: &str) -> Self {
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        Self { lines: lines.map(str::to_owned).collect() }
    }

    /// The lines, without remarks.
    #[must_use]
    pub fn lines(&self) -> &[String] {
        &self.lines
    }

    /// Compares with a trace.
    ///
    /// # Errors
    /// The first divergence, in words.
    pub fn matches(&self, trace: &[Event]) -> Result<(), String> {
        let mut events = trace.iter().peekable();
        let mut lines = self.lines.iter().peekable();
        while let Some(line) = lines.next() {
            if line == "..." {
                let Some(next) = lines.peek() else { return Ok(()) };
                while events.peek().is_some_and(|event| mismatch(next, event).is_some()) {
                    events.next();
                }
                continue;
            }
            let Some(event) = events.next() else {
                return Err(format!("expected `{line}`, but the trace ends"));
            };
            if let Some(reason) = mismatch(line, event) {
                return Err(format!("expected `{line}`, got `{}` ({reason})", render(event)));
            }
        }
        match events.next() {
            Some(event) => Err(format!("expected the end of the trace, got `{}`", render(event))),
            None => Ok(()),
        }
    }
}

/// Why an event does not satisfy a line; `None` when it does.
fn mismatch(line: &str, event: &Event) -> Option<String> {
    let actual = fields(event);
    let mut words = line.split_whitespace();
    let kind = words.next().unwrap_or_default();
    if actual.first().is_none_or(|(_, actual)| actual != kind) {
        return Some("another kind".to_owned());
    }
    words.find_map(|word| {
        let Some((key, value)) = word.split_once('=') else {
            return Some(format!("`{word}` is not key=value"));
        };
        let fits = match key {
            "line" => event.block.line.to_string() == value,
            "block" => absent_or(event.block.sequence.as_str(), value),
            "program" => absent_or(event.block.program.as_str(), value),
            "rules" => {
                value.split('+').all(|id| event.rules.as_slice().iter().any(|rule| rule.as_str() == id))
            }
            "readings" => {
                value.split('+').all(|name| event.readings.iter().any(|reading| reading.as_str() == name))
            }
            _ => match actual.iter().find(|(name, _)| *name == key) {
                Some((_, actual)) => actual == value,
                None => value == "-",
            },
        };
        (!fits).then(|| format!("`{word}` does not hold"))
    })
}

/// Whether a name is the expected one; `-` stands for none.
fn absent_or(name: &str, value: &str) -> bool {
    name == value || name.is_empty() && value == "-"
}

#[cfg(test)]
mod tests {
    use super::{Expectation, render};
    use crate::vocabulary::{Action, Event, Label, Place, Reading, ReadingSet, RuleSet};

    #[test]
    fn readings_are_written_where_there_are_any() {
        let (block, rules, none) = (Place::default(), RuleSet::EMPTY, ReadingSet::default());
        let event = Event::new(1, block, rules, none, Action::Stop);
        assert_eq!(render(&event), "stop line=0 rules=");
        let readings = none.with(Reading::ALL[0]);
        let expected = format!("stop line=0 rules= readings={}", Reading::ALL[0].as_str());
        assert_eq!(render(&Event { readings, ..event }), expected);
    }

    #[test]
    fn a_name_that_is_not_there_is_a_dash() {
        let (block, rules, readings) = (Place::default(), RuleSet::EMPTY, ReadingSet::default());
        let event = Event::new(1, block, rules, readings, Action::Stop);
        assert!(Expectation::parse("stop block=- program=-").matches(&[event]).is_ok());
        let block = Place { sequence: Label::new("N1"), ..block };
        assert!(Expectation::parse("stop block=-").matches(&[Event { block, ..event }]).is_err());
    }

    #[test]
    fn empty_lines_and_remarks_are_no_lines() {
        let text = "rapid x=1\n\n# a remark\n  ...  \nend\n";
        assert_eq!(Expectation::parse(text).lines(), ["rapid x=1", "...", "end"]);
    }
}

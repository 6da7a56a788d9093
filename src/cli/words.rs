//! An event in words: `linear to X48 Z120 at 0.2 mm/rev`.

use std::fmt::Write;

use turnspec_oracle::vocabulary::notation::{feed_unit_text, value_text};
use turnspec_oracle::vocabulary::{
    Action, Alarm, Angle, CallCause, ContourPlane, Event, Feed, FrameCause, Label, LeadAxis, Length, Motion,
    ReleaseCause, Sense, SpeedLimit, Spindle, SpindleName, SpindleState, Value,
};

/// What happens, in program coordinates; of a motion in radius compensation also where the tip is.
pub fn describe(event: &Event) -> String {
    match &event.action {
        Action::Rapid { motion } => format!("rapid to {}{}", end_point(motion), turning(motion)),
        Action::Linear { motion, feed: rate, .. } => {
            format!("linear to {}{}{}", end_point(motion), feed(*rate), turning(motion))
        }
        Action::Arc { motion, feed: rate, sense, centre_x, centre_z } => format!(
            "arc {} to {} about X{centre_x} Z{centre_z}{}{}",
            sense_words(*sense),
            end_point(motion),
            feed(*rate),
            turning(motion)
        ),
        Action::Thread { motion, lead, axis, .. } => {
            let axis = match axis {
                LeadAxis::X => 'X',
                LeadAxis::Z => 'Z',
            };
            format!("thread to {}, lead {lead} mm along {axis}{}", end_point(motion), turning(motion))
        }
        Action::ContourArc { motion, feed: rate, sense, plane } => {
            let centre = match plane {
                ContourPlane::FaceCentre(centre) => format!("{}, {} on the face", centre.x, centre.y),
                ContourPlane::SideArc(arc) => format!("{}, Z{} on the side", arc.centre, arc.centre_z),
            };
            format!(
                "arc {} to {} about {centre}{}{}",
                sense_words(*sense),
                end_point(motion),
                feed(*rate),
                turning(motion)
            )
        }
        Action::Dwell { time } => format!("dwell {time} s"),
        Action::Spindle(spindle) => spindle_words(spindle),
        Action::Tool { tool, offset, nose, index } => tool_words(*tool, *offset, *nose, *index),
        Action::Coolant { on: true } => "coolant on".to_owned(),
        Action::Coolant { on: false } => "coolant off".to_owned(),
        Action::Aux { code, group } if group.is_empty() => code.to_string(),
        Action::Aux { code, group } => format!("{code} ({})", spaced(group.as_str())),
        Action::Torque { z, w } => torque_words(*z, *w),
        Action::Frame { cause, x, z, c, w } => {
            format!("{} is now {}", cause_words(*cause), amounts(*x, *z, *c, *w))
        }
        Action::Mode { group, code, previous, angle } => {
            let mut text = format!("{}: {code}", spaced(group.as_str()));
            if !previous.is_empty() {
                let _ = write!(text, " instead of {previous}");
            }
            if let Some(angle) = angle {
                let _ = write!(text, ", turned by {angle} degrees");
            }
            text
        }
        Action::Variable { name, value } => format!("{name} = {}{}", value_text(value), value_unit(value)),
        Action::Call { name, cause } => match cause {
            CallCause::Call => format!("call {name}"),
            CallCause::Macro => format!("call {name} by a macro code"),
            CallCause::Modal => format!("modal call {name}"),
        },
        Action::Return => "return".to_owned(),
        Action::Output { device, text, .. } => format!("send {text} to {device}"),
        Action::Message { number, code, text } => {
            format!("alarm {number} C, user reserve code {code} {text}")
        }
        Action::Select { file, name, repetition } => format!("select {file} {name}, repetition {repetition}"),
        Action::Wait { p, code } => format!("wait at {}", stop_point(*p, code)),
        Action::Release { p, code, cause } => {
            format!("go on from {}: {}", stop_point(*p, code), release_words(*cause))
        }
        Action::SideEnd { code } if code.is_empty() => "end of the side program".to_owned(),
        Action::SideEnd { code } => format!("end of the side program ({code})"),
        Action::Stop => "program stop".to_owned(),
        Action::OptionalStop => "optional stop".to_owned(),
        Action::End { code } => format!("end of the program ({code})"),
        Action::Alarm(alarm) => format!("alarm {}", alarm_words(alarm)),
    }
}

/// An alarm: number where the control has one, name, meaning, what it is about.
pub fn alarm_words(alarm: &Alarm) -> String {
    let number = alarm.number.map_or(String::new(), |number| format!("{number} "));
    let detail = if alarm.detail.is_empty() { String::new() } else { format!(" ({})", alarm.detail) };
    format!("{number}{}: {}{detail}", alarm.name, alarm.name.text())
}

/// Where a saddle waits: P with its value, or the code.
pub fn stop_point(p: Option<u16>, code: &Label) -> String {
    p.map_or_else(|| code.to_string(), |p| format!("P{p}"))
}

fn release_words(cause: ReleaseCause) -> &'static str {
    match cause {
        ReleaseCause::Smaller => "the other saddle waits at a greater P",
        ReleaseCause::Equal => "the other saddle waits at the same P",
        ReleaseCause::PCode => "the other saddle waits at a P",
        ReleaseCause::Counterpart => "the other saddle waits at M100, too",
        ReleaseCause::OtherEnded => "the program of the other saddle is at its end",
    }
}

fn end_point(motion: &Motion) -> String {
    let end = &motion.program;
    let mut text = format!("X{} Z{}", end.x, end.z);
    if let Some(c) = end.c {
        let _ = write!(text, " C{c}");
    }
    if let Some(w) = end.w {
        let _ = write!(text, " W{w}");
    }
    if let Some(tip) = motion.tip {
        let _ = write!(text, " (tip X{} Z{})", tip.x, tip.z);
    }
    text
}

fn feed(feed: Feed) -> String {
    format!(" at {} {}", feed.value, feed_unit_text(feed.unit))
}

fn turning(motion: &Motion) -> String {
    let mut text = String::new();
    if let Some(travel) = motion.c_travel {
        let _ = write!(text, ", C turns by {travel} degrees");
    }
    if let Some(speed) = motion.speed {
        let _ = write!(text, ", {speed} rpm");
    }
    match (motion.pass, motion.part) {
        (Some(pass), Some(part)) => {
            let _ = write!(text, " ({}, pass {pass})", part.as_str());
        }
        (None, Some(part)) => {
            let _ = write!(text, " ({})", part.as_str());
        }
        (_, None) => {}
    }
    text
}

fn sense_words(sense: Sense) -> &'static str {
    match sense {
        Sense::Clockwise => "clockwise",
        Sense::CounterClockwise => "counter-clockwise",
    }
}

fn spindle_words(spindle: &Spindle) -> String {
    if let Some(clamp) = spindle.clamp {
        return format!("spindle speed clamped at {clamp} rpm");
    }
    let name = match spindle.spindle {
        SpindleName::Main => "spindle",
        SpindleName::Tool => "rotary tool",
        SpindleName::CAxis => return format!("C axis speed {} rpm", spindle.speed),
    };
    let mut text = match spindle.state {
        SpindleState::Stop => format!("{name} stopped"),
        SpindleState::Orient => format!("{name} oriented"),
        SpindleState::Clockwise => format!("{name} clockwise at {} rpm", spindle.speed),
        SpindleState::CounterClockwise => format!("{name} counter-clockwise at {} rpm", spindle.speed),
    };
    if let Some(surface) = spindle.surface {
        let _ = write!(text, ", cutting speed {surface} m/min");
    }
    if let Some(limit) = spindle.limit {
        let _ = write!(text, ", {}", limit_words(limit));
    }
    if !spindle.gear.is_empty() {
        let _ = write!(text, ", gear {}", spindle.gear);
    }
    if spindle.with_motion {
        text.push_str(", together with the motion");
    }
    text
}

fn limit_words(limit: SpeedLimit) -> &'static str {
    match limit {
        SpeedLimit::GearMaximum => "held at the highest of the gear",
        SpeedLimit::GearMinimum => "raised to the lowest of the gear",
        SpeedLimit::Clamp => "held at the clamp",
    }
}

fn tool_words(tool: u8, offset: u8, nose: u8, index: bool) -> String {
    let tool = if tool == 0 { "present tool".to_owned() } else { format!("tool {tool}") };
    let nose = if nose == 0 { String::new() } else { format!(", nose radius {nose}") };
    let turret = if index { ", turret indexes" } else { "" };
    format!("{tool}, offset {offset}{nose}{turret}")
}

fn torque_words(z: Option<u8>, w: Option<u8>) -> String {
    let limits: Vec<String> = [("Z", z), ("W", w)]
        .into_iter()
        .filter_map(|(axis, limit)| limit.map(|limit| format!("{axis} {limit} %")))
        .collect();
    match limits.is_empty() {
        true => "no torque limit".to_owned(),
        false => format!("torque limited to {}", limits.join(", ")),
    }
}

fn cause_words(cause: FrameCause) -> &'static str {
    match cause {
        FrameCause::ZeroOffset => "zero offset",
        FrameCause::ZeroShift => "zero shift",
        FrameCause::ToolOffset => "tool offset",
    }
}

fn amounts(x: Length, z: Length, c: Angle, w: Length) -> String {
    let mut text = format!("X{x} Z{z}");
    if c.0 != 0 {
        let _ = write!(text, " C{c}");
    }
    if w.0 != 0 {
        let _ = write!(text, " W{w}");
    }
    text
}

fn value_unit(value: &Value) -> &'static str {
    match value {
        Value::Length(_) => " mm",
        Value::Angle(_) => " degrees",
        Value::Real(_) | Value::Integer(_) | Value::Text(_) => "",
    }
}

fn spaced(name: &str) -> String {
    name.replace('_', " ")
}

//! Taking note of the motions of a definition as their events come (execution of LAP, 5, "Steps").

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, Event, LeadAxis, Motion, ReadingSet, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;

use super::definition::{Course, Leg, Purpose, Recorded};

/// The rules of a leg that a pass of G88 cites (execution of LAP, 14).
const OF_LEG: RuleSet = RuleSet::of(&[G34_01, G34_02, G34_03, G34_04, G34_05, THRD_06, G33_09]);

impl Interpreter<'_> {
    /// An event comes in a definition, or in the block with its name.
    #[cold]
    pub(in crate::engine) fn observe(&mut self, sink: &mut impl Sink, event: Event) {
        let number = self.lap.mark_number();
        if self.take_note(&event, number) {
            return;
        }
        if self.compensation.holds() {
            return self.compensation.hold(&event);
        }
        self.ordinal = event.n;
        sink.event(&event);
    }

    /// Takes note of an event, which belongs to a block with a mark; whether it is not shown.
    pub(in crate::engine) fn take_note(&mut self, event: &Event, mark: u32) -> bool {
        let reads = self.lap.reads();
        let of_x = self.known.feed_length;
        let Some(definition) = self.lap.definition_mut() else { return reads && !is_shown(&event.action) };
        let (motion, course) = match event.action {
            Action::Rapid { motion } => (motion, Course::Rapid),
            Action::Linear { motion, .. } => (motion, Course::Line),
            Action::Arc { motion, sense, centre_x, centre_z, .. } => {
                (motion, Course::Arc { sense, centre: centre_of_tip(&motion, centre_x.0, centre_z.0) })
            }
            Action::Thread { motion, lead, axis, change, start, .. } => {
                definition.has_leg = true;
                let rules = OF_LEG.as_slice().iter().filter(|rule| event.rules.as_slice().contains(rule));
                let rules = rules.copied().collect();
                let readings = if axis == LeadAxis::X { of_x } else { ReadingSet::default() };
                (motion, Course::Leg(Leg { lead, axis, change, start, rules, readings }))
            }
            _ => return reads && !is_shown(&event.action),
        };
        let end = end_of(&motion);
        if definition.count(end) && definition.purpose != Purpose::Finish {
            let mark = definition.marks.get(mark);
            let programmed = Point { x: motion.program.x.0, z: motion.program.z.0 };
            let recorded =
                Recorded { course, end, programmed, feed: mark.feed, compensated: mark.compensated };
            let motions = match definition.blank {
                true => &mut definition.blank_motions,
                false => &mut definition.contour_motions,
            };
            motions.push(recorded);
        }
        reads
    }
}

impl super::Lap {
    /// Whether the motions of a definition are recorded, not made.
    pub fn reads(&self) -> bool {
        self.observes && self.definition().is_none_or(|definition| definition.purpose != Purpose::Finish)
    }

    /// The number of the mark of the block in progress.
    pub fn mark_number(&self) -> u32 {
        self.definition().map_or(0, |definition| definition.marks.number())
    }
}

/// Where a motion ends: the tip, in compensation.
fn end_of(motion: &Motion) -> Point {
    match motion.tip {
        Some(tip) => Point { x: tip.x.0, z: tip.z.0 },
        None => Point { x: motion.program.x.0, z: motion.program.z.0 },
    }
}

/// What the tip goes round when the nose goes round a centre.
fn centre_of_tip(motion: &Motion, x: i64, z: i64) -> Point {
    match (motion.tip, motion.nose) {
        (Some(tip), Some(nose)) => Point { x: x + tip.x.0 - nose.x.0, z: z + tip.z.0 - nose.z.0 },
        _ => Point { x, z },
    }
}

/// Whether an event comes although the definition is only read.
fn is_shown(action: &Action) -> bool {
    matches!(action, Action::Variable { .. } | Action::Call { .. } | Action::Return | Action::Alarm { .. })
}

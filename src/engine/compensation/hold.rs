//! Events that are held behind a motion whose end is not known, and their release.

use turnspec_oracle::vocabulary::{Action, Event, Length, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;
use crate::engine::planted::{self, Bug};

use super::Compensation;

impl Compensation {
    /// Keeps an event until its release, which also numbers it.
    #[cold]
    pub fn hold(&mut self, event: &Event) {
        self.held.push(*event);
    }

    /// Forgets what is held, the waiting motion too.
    pub fn drop_held(&mut self) {
        self.holding = false;
        self.held.clear();
        self.waiting = None;
    }
}

impl Interpreter<'_> {
    /// Hands over what is held, in order. A motion of C or W shows where the tip is now.
    pub(super) fn release(&mut self, sink: &mut impl Sink) {
        if self.compensation.held.is_empty() {
            return;
        }
        let displacement = match planted::is(Bug::HeldMotion) {
            true => Point { x: 0, z: 0 },
            false => self.compensation.displacement,
        };
        let mut held = std::mem::take(&mut self.compensation.held);
        for event in &mut held {
            let mirror = if planted::is(Bug::HeldNotMirrored) { 1 } else { self.state.mirror };
            match &self.compensation.cutter {
                Some(cutter) => cutter.displace(&mut event.action),
                None => displace(&mut event.action, displacement, mirror),
            }
            self.emit_at_once(sink, event);
        }
        held.clear();
        self.compensation.held = held;
    }

    /// Hands an event to the sink, whether others are held or not; it is numbered now.
    pub(super) fn emit_at_once(&mut self, sink: &mut impl Sink, event: &mut Event) {
        self.ordinal += 1;
        event.n = self.ordinal;
        sink.event(event);
    }
}

/// Moves X and Z of a motion in compensation, and its tip and nose; X of the machine may be mirrored.
fn displace(action: &mut Action, by: Point, mirror: i64) {
    let (Action::Rapid { motion } | Action::Linear { motion, .. }) = action else { return };
    let moved = |x: &mut Length, z: &mut Length, mirror: i64| {
        x.0 = x.0.saturating_add(mirror * by.x);
        z.0 = z.0.saturating_add(by.z);
    };
    moved(&mut motion.machine.x, &mut motion.machine.z, mirror);
    for point in [&mut motion.tip, &mut motion.nose].into_iter().flatten() {
        moved(&mut point.x, &mut point.z, 1);
    }
}

//! What a stage emits, before the run numbers it and gives it its place.

use crate::lap::Mark;
use crate::modal::CutterPlane;
use crate::path::Point;
use crate::vocabulary::{Action, Reading, ReadingSet, RuleId, RuleSet, Side};

/// An event without number and place.
#[derive(Clone, PartialEq, Debug)]
pub struct Emission {
    /// What happens.
    pub action: Action,
    /// The rules that produced it.
    pub rules: RuleSet,
    /// The readings it depends on.
    pub readings: ReadingSet,
    /// The turret or the saddle that it is about; without one that of its block.
    pub side: Option<Side>,
    /// Of a motion in compensation that leaves tip or cutter where the motion before it brings them: they are shown when
    /// its turn comes.
    pub at_rest: Option<AtRest>,
    /// Of a motion of a contour of LAP: what was in force in its block.
    pub mark: Option<Mark>,
}

/// What is told from the place of the axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum AtRest {
    /// Tip and nose.
    Tip {
        /// From the tip to the nose centre: X as a diameter, and Z.
        to_centre: Point,
        /// Whether X of the machine runs against X of the program (E100L-MIRR-05).
        mirrored: bool,
    },
    /// The cutter centre, in a plane of rotary tools.
    Cutter(CutterPlane),
}

impl Emission {
    /// An event that these rules produced.
    pub fn new(action: Action, rules: RuleSet) -> Self {
        Self { action, rules, readings: ReadingSet::default(), side: None, at_rest: None, mark: None }
    }

    /// The event, about a turret or a saddle.
    pub fn of(self, side: Option<Side>) -> Self {
        Self { side, ..self }
    }

    /// The event, depending on a reading.
    pub fn reading(self, reading: impl Into<Reading>) -> Self {
        Self { readings: self.readings.with(reading), ..self }
    }

    /// The event, depending on these readings.
    pub fn readings(self, readings: ReadingSet) -> Self {
        Self { readings: self.readings.union(readings), ..self }
    }

    /// The event, produced by these rules too.
    pub fn rules(self, rules: RuleSet) -> Self {
        Self { rules: self.rules.union(rules), ..self }
    }

    /// If a variable was set: by these rules too.
    pub fn set_variable_by(&mut self, rules: RuleSet) {
        if matches!(self.action, Action::Variable { .. }) {
            self.rules = self.rules.union(rules);
        }
    }

    /// The event, produced by one more rule if `holds`.
    pub fn rule_if(self, holds: bool, rule: RuleId) -> Self {
        if holds { Self { rules: self.rules.with(rule), ..self } } else { self }
    }
}

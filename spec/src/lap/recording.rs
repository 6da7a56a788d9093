//! The motions of a blank and a contour, as they would be carried out (E100L-LAP-01, E100L-LAP-02).

use super::kept::Mark;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::path::Point;
use crate::state::StoredFeed;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{
    Action, AlarmName, Angle, FeedRate, LeadAxis, Motion, Reading, ReadingSet, RuleId, RuleSet, Sense,
};

/// A motion of a blank or a contour.
#[derive(Clone, PartialEq, Debug)]
pub struct Recorded {
    /// Which way it goes.
    pub kind: Kind,
    /// Its end: X (as a diameter) and Z in program coordinates; in compensation that of the tip.
    pub end: Point,
    /// The end that is programmed: that of the tip out of compensation.
    pub programmed: Point,
    /// The E in force in its block.
    pub feed: Option<StoredFeed>,
    /// The F in force in its block.
    pub own_feed: Option<StoredFeed>,
    /// Whether G41 or G42 was in force there.
    pub compensated: bool,
}

/// Which way a motion goes.
#[derive(Clone, PartialEq, Debug)]
pub enum Kind {
    /// Positioning.
    Rapid,
    /// Straight.
    Line,
    /// Round a centre.
    Arc(Point, Sense),
    /// A leg of a thread.
    Leg(Box<Leg>),
}

/// A leg of a thread (E100L-AP3-01).
#[derive(Clone, PartialEq, Debug)]
pub struct Leg {
    /// The lead where it begins.
    pub lead: FeedRate,
    /// The axis along which it is measured.
    pub axis: LeadAxis,
    /// By how much it changes in a revolution.
    pub change: Option<FeedRate>,
    /// The angle of the spindle at which it starts.
    pub start: Option<Angle>,
    /// Its rules.
    pub rules: RuleSet,
    /// Its readings.
    pub readings: ReadingSet,
}

/// What is recorded.
#[derive(Clone, Default, Debug)]
pub struct Recording {
    /// The blank, if there is one.
    pub blank: Option<Vec<Recorded>>,
    /// The contour.
    pub contour: Vec<Recorded>,
    /// Whether the contour begins with G82.
    pub transverse: bool,
    in_blank: bool,
}

impl Recording {
    /// A part of the definition begins with this code.
    pub fn begin(&mut self, code: u16) {
        self.in_blank = code == 83;
        if self.in_blank {
            self.blank = Some(Vec::new());
        } else {
            self.transverse = code == 82;
        }
    }

    /// Takes a motion; one without travel counts only if it is the first.
    pub fn record(&mut self, event: &Emission) {
        let (Some((kind, motion)), Some(mark)) = (kind(event), event.mark) else { return };
        let programmed = (motion.program.x.0, motion.program.z.0);
        let end = motion.tip.map_or(programmed, |tip| (tip.x.0, tip.z.0));
        let motions = if self.in_blank { self.blank.get_or_insert_default() } else { &mut self.contour };
        if motions.last().is_none_or(|last| last.end != end) {
            let Mark { feed, own_feed, compensated, .. } = mark;
            motions.push(Recorded { kind, end, programmed, feed, own_feed, compensated });
        }
    }

    /// E100L-LAP-02.
    pub fn check_blank(&self) -> Outcome<()> {
        if self.blank.as_ref().is_some_and(Vec::is_empty) {
            return Err(Fault::about(AlarmName::ContourMalformed, LAP_02, "empty"));
        }
        Ok(())
    }

    /// E100L-LAP-01, E100L-AP3-01.
    pub fn check_contour(&self, thread: bool) -> Outcome<()> {
        let malformed = |rule, detail| Err(Fault::about(AlarmName::ContourMalformed, rule, detail));
        if self.contour.len() < 2 {
            return malformed(LAP_01, "empty");
        }
        if thread && !self.contour.iter().any(|motion| matches!(motion.kind, Kind::Leg(_))) {
            return malformed(AP3_01, "thread");
        }
        Ok(())
    }
}

fn kind(event: &Emission) -> Option<(Kind, Motion)> {
    Some(match event.action {
        Action::Rapid { motion } => (Kind::Rapid, motion),
        Action::Linear { motion, .. } => (Kind::Line, motion),
        Action::Arc { motion, sense, centre_x, centre_z, .. } => {
            // The nose goes round the centre of the event, the tip beside it.
            let beside = motion
                .tip
                .zip(motion.nose)
                .map_or((0, 0), |(tip, nose)| (tip.x.0 - nose.x.0, tip.z.0 - nose.z.0));
            (Kind::Arc((centre_x.0 + beside.0, centre_z.0 + beside.1), sense), motion)
        }
        Action::Thread { motion, lead, axis, change, start, .. } => {
            let along_x = event.readings.iter().filter(|reading| matches!(reading, Reading::FeedLength(_)));
            let readings = along_x.fold(ReadingSet::default(), ReadingSet::with);
            let rules = of_leg(event.rules);
            (Kind::Leg(Box::new(Leg { lead, axis, change, start, rules, readings })), motion)
        }
        _ => return None,
    })
}

/// The rules that a leg is told by, without those of the words that lead to its end.
fn of_leg(rules: RuleSet) -> RuleSet {
    let own: [RuleId; 7] = [G34_01, G34_02, G34_03, G34_04, G34_05, THRD_06, G33_09];
    own.into_iter().filter(|rule| rules.as_slice().contains(rule)).fold(RuleSet::EMPTY, RuleSet::with)
}

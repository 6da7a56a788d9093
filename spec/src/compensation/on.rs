//! Compensation in force: the motion that waits for its end, what is held behind it, and what ends it (E100L-NRC-12).

use super::back::Back;
use super::corner::corner;
use super::ending::{Ending, Pending, at_rest};
use super::leg::Leg;
use super::nose::Nose;
use super::reach::Reach;
use super::start_up;
use super::stream::Stream;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::integer::between::is_too_long;
use crate::path::{Point, Vector};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Place, RuleId, RuleSet, Setup};

/// Compensation in force.
pub struct On {
    /// Where the axes are: X (as a diameter) and Z in machine coordinates.
    pub axes: Point,
    /// The motion whose end is not known.
    pub waiting: Waiting,
    /// Whether one block without X/Z motion has come since it began to wait.
    pub one_between: bool,
    /// How many statements have come since it began to wait.
    pub statements: usize,
    /// What later blocks have emitted behind it.
    pub held: Vec<(Place, Emission)>,
}

/// E100L-CTL-01: how many statements may come behind a motion that waits.
const MOST_STATEMENTS: usize = 100;

/// The motion that waits.
pub enum Waiting {
    /// The start-up with its nose, and the imaginary element before it (E100L-NRC-23).
    StartUp(Pending, Nose, Option<Leg>),
    /// An element of the contour, as it is at its end.
    Element(Pending, Leg),
    /// A motion without travel at the end of that element.
    Repetition(Pending, Leg),
    /// None; the element that ended last, and the way back to its corner.
    Nothing(Leg, Back),
}

impl On {
    /// In force, with a start-up that waits.
    pub fn started(axes: Point, waiting: Waiting) -> Self {
        Self { axes, waiting, one_between: false, statements: 0, held: Vec::new() }
    }

    /// The element j begins; the axes are where it begins then.
    pub fn meet(self, j: &Leg, stream: &mut Stream, setup: &Setup) -> Outcome<Point> {
        let mut held = Held { axes: self.axes, events: self.held };
        // E100L-NRC-43.
        let between = if self.one_between { RuleSet::of(&[NRC_43]) } else { RuleSet::EMPTY };
        match self.waiting {
            Waiting::StartUp(motion, nose, imaginary) => {
                let met = start_up::end(imaginary.as_ref(), j, between);
                let (reach, rules) = met.map_err(|fault| fault.of_block(motion.spot.place))?;
                let ending = motion.spot.reached(&reach, nose.to_centre);
                held.end(motion, ending, rules, stream, setup)?;
            }
            Waiting::Element(motion, i) | Waiting::Repetition(motion, i) => {
                let met = corner(&i, j).map_err(|fault| fault.of_block(motion.spot.place));
                let (reach, rules) = met?;
                let ending = motion.spot.reached(&reach, i.nose.to_centre);
                held.end(motion, ending, rules.union(between), stream, setup)?;
            }
            Waiting::Nothing(i, back) => {
                // E100L-NRC-46: no motion, if the corner is where the tip is.
                let (reach, rules) = corner(&i, j).map_err(|fault| fault.of_block(back.spot.place))?;
                let ending = back.spot.reached(&reach, i.nose.to_centre);
                if ending.machine != held.axes {
                    held.end(back.motion?, ending, rules, stream, setup)?;
                }
            }
        }
        Ok(held.release(stream))
    }

    /// A motion without travel comes, and waits (E100L-NRC-45).
    pub fn repeat(self, repetition: Pending, stream: &mut Stream, setup: &Setup) -> Outcome<Self> {
        let mut held = Held { axes: self.axes, events: self.held };
        let last = match self.waiting {
            Waiting::StartUp(motion, ..) => {
                return Err(start_up::unmet(&motion.spot, NRC_21));
            }
            Waiting::Element(motion, i) => {
                held.end_in_contact(motion, &i, NRC_45, stream, setup)?;
                i
            }
            Waiting::Repetition(motion, i) => {
                held.stay(motion, &i, stream, setup)?;
                i
            }
            Waiting::Nothing(i, _) => i,
        };
        let axes = held.release(stream);
        Ok(Self::started(axes, Waiting::Repetition(repetition, last)))
    }

    /// A block without X/Z motion has ended (E100L-NRC-22, E100L-NRC-43, E100L-NRC-44).
    pub fn pass(mut self, stream: &mut Stream, state: &State) -> Outcome<Self> {
        let waits = !matches!(self.waiting, Waiting::Nothing(..));
        if !is_too_long(waits, self.one_between) {
            self.one_between = true;
            return Ok(self.hold(stream));
        }
        let setup = state.setup;
        let mut held = Held { axes: self.axes, events: self.held };
        let last = match self.waiting {
            Waiting::StartUp(motion, ..) => {
                return Err(start_up::unmet(&motion.spot, NRC_22));
            }
            Waiting::Element(motion, i) => {
                held.end_in_contact(motion, &i, NRC_44, stream, setup)?;
                i
            }
            Waiting::Repetition(motion, i) => {
                held.stay(motion, &i, stream, setup)?;
                i
            }
            Waiting::Nothing(i, _) => i,
        };
        let axes = held.release(stream);
        Ok(Self::started(axes, Waiting::Nothing(last, Back::present(stream.place, state))))
    }

    /// E100L-CTL-01: a statement comes; how many a control reads ahead behind a motion that waits the manual does not tell.
    pub fn meet_statement(&mut self) -> Outcome<()> {
        if matches!(self.waiting, Waiting::Nothing(..)) {
            return Ok(());
        }
        if self.statements == MOST_STATEMENTS {
            return Err(Fault::about(AlarmName::Unspecified, CTL_01, "statements"));
        }
        self.statements += 1;
        Ok(())
    }

    /// A statement has ended, which is no block without motion: its events wait behind the motion, if one waits.
    pub fn pass_statement(self, stream: &mut Stream) -> Self {
        if !matches!(self.waiting, Waiting::Nothing(..)) {
            return self.hold(stream);
        }
        let held = Held { axes: self.axes, events: self.held };
        let axes = held.release(stream);
        Self { axes, held: Vec::new(), ..self }
    }

    /// Compensation or the program ends; `rule` is that of the contact then. The axes are where the last motion ended.
    pub fn conclude(
        self,
        rule: RuleId,
        imaginary: Option<&Vector>,
        stream: &mut Stream,
        setup: &Setup,
    ) -> Outcome<Point> {
        let mut held = Held { axes: self.axes, events: self.held };
        match self.waiting {
            Waiting::StartUp(motion, ..) => return Err(start_up::nothing_to_touch(&motion.spot)),
            Waiting::Element(motion, i) => match imaginary {
                None => held.end_in_contact(motion, &i, rule, stream, setup)?,
                Some(direction) => {
                    // E100L-NRC-69: the imaginary line takes the place of the element j.
                    let j = Leg::line(direction.clone(), i.nose);
                    let met = corner(&i, &j).map_err(|fault| fault.of_block(motion.spot.place));
                    let (reach, rules) = met?;
                    let rules = rules.with(NRC_69);
                    let rules = if self.one_between { rules.with(NRC_43) } else { rules };
                    let ending = motion.spot.reached(&reach, i.nose.to_centre);
                    held.end(motion, ending, rules, stream, setup)?;
                }
            },
            Waiting::Repetition(motion, i) => held.stay(motion, &i, stream, setup)?,
            Waiting::Nothing(..) => {}
        }
        Ok(held.release(stream))
    }

    /// Holds what a block has emitted.
    pub fn hold(mut self, stream: &mut Stream) -> Self {
        self.held.extend(stream.take());
        self
    }
}

/// What is held behind a motion, and where the axes are.
struct Held {
    axes: Point,
    events: Vec<(Place, Emission)>,
}

impl Held {
    /// The motion ends.
    fn end(
        &mut self,
        motion: Pending,
        ending: Ending,
        rules: RuleSet,
        stream: &mut Stream,
        setup: &Setup,
    ) -> Outcome<()> {
        stream.decide(motion.end(ending, rules, self.axes, setup)?);
        self.axes = ending.machine;
        Ok(())
    }

    /// The motion ends in contact with its element alone.
    fn end_in_contact(
        &mut self,
        motion: Pending,
        element: &Leg,
        rule: RuleId,
        stream: &mut Stream,
        setup: &Setup,
    ) -> Outcome<()> {
        let ending = motion.spot.reached(&Reach::contact(element), element.nose.to_centre);
        self.end(motion, ending, RuleSet::of(&[rule]), stream, setup)
    }

    /// The repetition leaves the tip where it is (E100L-NRC-46).
    fn stay(&mut self, motion: Pending, element: &Leg, stream: &mut Stream, setup: &Setup) -> Outcome<()> {
        let ending = motion.spot.kept(self.axes, element.nose.to_centre);
        self.end(motion, ending, RuleSet::EMPTY, stream, setup)
    }

    /// Releases what is held, and what the present block has emitted; where the axes are.
    fn release(self, stream: &mut Stream) -> Point {
        let present = stream.take();
        for (place, event) in self.events.into_iter().chain(present) {
            stream.decide((place, at_rest(event, self.axes)));
        }
        self.axes
    }
}

//! Compensation in force: the motion that waits for its end, what is held behind it, and what ends it (E100L-NRC-12).
//!
//! It does not know in which plane: a [`Waits`] says where the axes go.

use super::corner::corner;
use super::leg::Leg;
use super::nose::Nose;
use super::reach::Reach;
use super::start_up;
use super::stream::Stream;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::integer::between::is_too_long;
use crate::path::Vector;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Place, RuleId, RuleSet};

/// A motion of a plane that waits for its end, and how a point of that plane becomes a place of the axes.
pub trait Waits: Sized {
    /// Where the axes are.
    type Axes: Copy;
    /// What may come behind an element that has ended, before the next one.
    type Rest;

    /// Its block.
    fn place(&self) -> Place;

    /// It ends with the centre at this way from P; where the axes are then.
    fn end(
        self,
        reach: &Reach,
        nose: Nose,
        rules: RuleSet,
        axes: Self::Axes,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<Self::Axes>;

    /// A motion of other axes alone, when its turn comes.
    fn at_rest(event: Emission, axes: Self::Axes) -> Emission;

    /// The second block without motion in the plane has come since one waits, or none waits.
    fn go_on(on: On<Self>, stream: &mut Stream, state: &mut State) -> Outcome<On<Self>>;

    /// Whether it is a motion that waits.
    fn rest_waits(rest: &Self::Rest) -> bool;

    /// The element j begins behind i and what came after it; `between` are rules of the corner.
    fn leave(
        rest: Self::Rest,
        elements: (&Leg, &Leg),
        between: RuleSet,
        held: &mut Held<Self>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()>;

    /// It stays at the end of the element i.
    fn stay(
        rest: Self::Rest,
        i: &Leg,
        held: &mut Held<Self>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()>;
}

/// Compensation in force.
pub struct On<M: Waits> {
    /// Where the axes are.
    pub axes: M::Axes,
    /// The motion whose end is not known.
    pub waiting: Waiting<M>,
    /// Whether one block without motion in the plane has come since it began to wait.
    pub one_between: bool,
    /// How many statements have come since it began to wait.
    pub statements: usize,
    /// What later blocks have emitted behind it.
    pub held: Vec<(Place, Emission)>,
}

/// E100L-CTL-01: how many statements may come behind a motion that waits.
const MOST_STATEMENTS: usize = 100;

/// The motion that waits.
pub enum Waiting<M: Waits> {
    /// The start-up with its nose, and the imaginary element before it (E100L-NRC-23).
    StartUp(M, Nose, Option<Leg>),
    /// An element of the contour, as it is at its end.
    Element(M, Leg),
    /// The element that ended last, and what has come behind it.
    Ended(Leg, M::Rest),
}

impl<M: Waits> On<M> {
    /// In force, with a motion that waits.
    pub fn started(axes: M::Axes, waiting: Waiting<M>) -> Self {
        Self { axes, waiting, one_between: false, statements: 0, held: Vec::new() }
    }

    /// Whether a motion waits.
    fn waits(&self) -> bool {
        match &self.waiting {
            Waiting::StartUp(..) | Waiting::Element(..) => true,
            Waiting::Ended(_, rest) => M::rest_waits(rest),
        }
    }

    /// The element j begins; the axes are where it begins then.
    pub fn meet(self, j: &Leg, stream: &mut Stream, state: &mut State) -> Outcome<M::Axes> {
        let mut held = Held { axes: self.axes, events: self.held };
        // E100L-NRC-43.
        let between = if self.one_between { RuleSet::of(&[NRC_43]) } else { RuleSet::EMPTY };
        match self.waiting {
            Waiting::StartUp(motion, nose, imaginary) => {
                let met = start_up::end(imaginary.as_ref(), j, between);
                let (reach, rules) = met.map_err(|fault| fault.of_block(motion.place()))?;
                held.end(motion, &reach, nose, rules, stream, state)?;
            }
            Waiting::Element(motion, i) => held.end_in_corner(motion, &i, j, between, stream, state)?,
            Waiting::Ended(i, rest) => M::leave(rest, (&i, j), between, &mut held, stream, state)?,
        }
        Ok(held.release(stream))
    }

    /// A block without motion in the plane has ended (E100L-NRC-22, E100L-NRC-43, E100L-NRC-44).
    pub fn pass(mut self, stream: &mut Stream, state: &mut State) -> Outcome<Self> {
        if is_too_long(self.waits(), self.one_between) {
            return M::go_on(self, stream, state);
        }
        self.one_between = true;
        Ok(self.hold(stream))
    }

    /// E100L-CTL-01: a statement comes; how many a control reads ahead behind a motion that waits the manual does not tell.
    pub fn meet_statement(&mut self) -> Outcome<()> {
        if !self.waits() {
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
        if self.waits() {
            return self.hold(stream);
        }
        let held = Held::<M> { axes: self.axes, events: self.held };
        let axes = held.release(stream);
        Self { axes, held: Vec::new(), ..self }
    }

    /// Compensation or the program ends; `rule` is that of the contact then. The axes are where the last motion ended.
    pub fn conclude(
        self,
        rule: RuleId,
        imaginary: Option<&Vector>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<M::Axes> {
        let mut held = Held { axes: self.axes, events: self.held };
        match self.waiting {
            Waiting::StartUp(motion, ..) => return Err(start_up::nothing_to_touch(motion.place())),
            Waiting::Element(motion, i) => match imaginary {
                None => held.end_in_contact(motion, &i, rule, stream, state)?,
                Some(direction) => {
                    // E100L-NRC-69: the imaginary line takes the place of the element j.
                    let j = Leg::line(direction.clone(), i.nose);
                    let rules = RuleSet::of(&[NRC_69]);
                    let rules = if self.one_between { rules.with(NRC_43) } else { rules };
                    held.end_in_corner(motion, &i, &j, rules, stream, state)?;
                }
            },
            Waiting::Ended(i, rest) => M::stay(rest, &i, &mut held, stream, state)?,
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
pub struct Held<M: Waits> {
    /// Where they are.
    pub axes: M::Axes,
    /// The events.
    pub events: Vec<(Place, Emission)>,
}

impl<M: Waits> Held<M> {
    /// The motion ends.
    pub fn end(
        &mut self,
        motion: M,
        reach: &Reach,
        nose: Nose,
        rules: RuleSet,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()> {
        self.axes = motion.end(reach, nose, rules, self.axes, stream, state)?;
        Ok(())
    }

    /// The motion ends in the corner of the elements i and j; these rules besides.
    pub fn end_in_corner(
        &mut self,
        motion: M,
        i: &Leg,
        j: &Leg,
        rules: RuleSet,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()> {
        let met = corner(i, j).map_err(|fault| fault.of_block(motion.place()));
        let (reach, of_corner) = met?;
        self.end(motion, &reach, i.nose, of_corner.union(rules), stream, state)
    }

    /// The motion ends in contact with its element alone.
    pub fn end_in_contact(
        &mut self,
        motion: M,
        element: &Leg,
        rule: RuleId,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()> {
        let rules = RuleSet::of(&[rule]);
        self.end(motion, &Reach::contact(element), element.nose, rules, stream, state)
    }

    /// Releases what is held, and what the present block has emitted; where the axes are.
    pub fn release(self, stream: &mut Stream) -> M::Axes {
        let present = stream.take();
        for (place, event) in self.events.into_iter().chain(present) {
            stream.decide((place, M::at_rest(event, self.axes)));
        }
        self.axes
    }
}

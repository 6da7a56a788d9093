//! What comes behind an element of turning that has ended: motions without travel, blocks without motion, and the way
//! back to the corner (E100L-NRC-44 to -46).

use super::back::Back;
use super::corner::corner;
use super::ending::{Ending, Pending, at_rest};
use super::leg::Leg;
use super::nose::Nose;
use super::on::{Held, On, Waiting, Waits};
use super::reach::Reach;
use super::start_up;
use super::stream::Stream;
use crate::emission::Emission;
use crate::fault::Outcome;
use crate::path::Point;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Place, RuleSet};

/// What has come behind an element that has ended.
pub enum Rest {
    /// A motion without travel at its end, which waits.
    Repetition(Pending),
    /// Blocks without motion; the way back to the corner.
    Nothing(Back),
}

impl Waits for Pending {
    /// X (as a diameter) and Z in machine coordinates.
    type Axes = Point;
    type Rest = Rest;

    fn place(&self) -> Place {
        self.spot.place
    }

    fn end(
        self,
        reach: &Reach,
        nose: Nose,
        rules: RuleSet,
        axes: Point,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<Point> {
        let ending = self.spot.reached(reach, nose.to_centre);
        self.end_at(ending, rules, axes, stream, state)
    }

    fn at_rest(event: Emission, axes: Point) -> Emission {
        at_rest(event, axes)
    }

    fn go_on(on: On<Self>, stream: &mut Stream, state: &mut State) -> Outcome<On<Self>> {
        let mut held = Held { axes: on.axes, events: on.held };
        let last = match on.waiting {
            Waiting::StartUp(motion, ..) => return Err(start_up::unmet(motion.place(), NRC_22)),
            Waiting::Element(motion, i) => {
                held.end_in_contact(motion, &i, NRC_44, stream, state)?;
                i
            }
            Waiting::Ended(i, rest) => {
                Self::stay(rest, &i, &mut held, stream, state)?;
                i
            }
        };
        let axes = held.release(stream);
        Ok(On::started(axes, Waiting::Ended(last, Rest::Nothing(Back::present(stream.place, state)))))
    }

    fn rest_waits(rest: &Rest) -> bool {
        matches!(rest, Rest::Repetition(_))
    }

    fn leave(
        rest: Rest,
        (i, j): (&Leg, &Leg),
        between: RuleSet,
        held: &mut Held<Self>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()> {
        match rest {
            Rest::Repetition(motion) => held.end_in_corner(motion, i, j, between, stream, state),
            Rest::Nothing(back) => {
                // E100L-NRC-46: no motion, if the corner is where the tip is.
                let (reach, rules) = corner(i, j).map_err(|fault| fault.of_block(back.spot.place))?;
                let ending = back.spot.reached(&reach, i.nose.to_centre);
                if ending.machine != held.axes {
                    held.axes = back.motion?.end_at(ending, rules, held.axes, stream, state)?;
                }
                Ok(())
            }
        }
    }

    fn stay(
        rest: Rest,
        i: &Leg,
        held: &mut Held<Self>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<()> {
        if let Rest::Repetition(motion) = rest {
            // E100L-NRC-46: the tip stays where it is.
            let ending = motion.spot.kept(held.axes, i.nose.to_centre);
            held.axes = motion.end_at(ending, RuleSet::EMPTY, held.axes, stream, state)?;
        }
        Ok(())
    }
}

impl Pending {
    /// Ends it at a place; where the axes are then.
    fn end_at(
        self,
        ending: Ending,
        rules: RuleSet,
        axes: Point,
        stream: &mut Stream,
        state: &State,
    ) -> Outcome<Point> {
        stream.decide(self.told(ending, rules, axes, state.setup)?);
        Ok(ending.machine)
    }
}

impl On<Pending> {
    /// A motion without travel comes, and waits (E100L-NRC-45).
    pub fn repeat(self, repetition: Pending, stream: &mut Stream, state: &mut State) -> Outcome<Self> {
        let mut held = Held { axes: self.axes, events: self.held };
        let last = match self.waiting {
            Waiting::StartUp(motion, ..) => return Err(start_up::unmet(motion.place(), NRC_21)),
            Waiting::Element(motion, i) => {
                held.end_in_contact(motion, &i, NRC_45, stream, state)?;
                i
            }
            Waiting::Ended(i, rest) => {
                Pending::stay(rest, &i, &mut held, stream, state)?;
                i
            }
        };
        let axes = held.release(stream);
        Ok(Self::started(axes, Waiting::Ended(last, Rest::Repetition(repetition))))
    }
}

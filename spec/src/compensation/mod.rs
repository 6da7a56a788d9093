//! Nose radius compensation: from the programmed path to the path of the tip (E100L-NRC-13).
//!
//! It stands between the path and the trace: motions come in as they are programmed, P, and leave with the end to
//! which the nose leads them. The end of an element needs the element after it (E100L-NRC-12), so that one motion
//! waits and later events are held behind it; blocks are carried out in their order all the same.
//!
//! [`nose`], [`leg`], [`circle`] and [`reach`] say what is offset and how far; [`corner`], [`lines`], [`line_and_arc`]
//! and [`arcs`] where two elements meet; [`on`] what waits for its end, [`rest`] and [`back`] what comes behind an element
//! that has ended; [`ending`] what the event of a motion tells; [`contour`], [`start_up`] and [`cancel`] what a block does.
//! [`cutter`] compensates the radius of a cutter in the planes of rotary tools, with the same corners and the same waiting.

mod arcs;
mod back;
mod cancel;
mod circle;
mod contour;
mod corner;
mod cutter;
mod ending;
mod leg;
mod line_and_arc;
mod lines;
mod nose;
mod on;
mod reach;
mod rest;
mod start_up;
mod stream;

pub use stream::Stream;

use crate::emission::Emission;
use crate::fault::Outcome;
use crate::modal::{Change, CutterPlane, Plan};
use crate::path::{Element, Point};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Place, RuleSet, Side};
use cutter::Cutter;
use ending::Pending;
use nose::Nose;
use on::On;

/// Radius compensation from one block to the next.
#[derive(Default)]
pub enum Compensation {
    /// E100L-NRC-06: the tip follows the programmed path.
    #[default]
    Off,
    /// G41 or G42 is in force.
    On(Box<On<Pending>>),
    /// G41 or G42 is in force in G17 or G119.
    Cutter(Box<Cutter>),
    /// G40 is in force again, and the axes are still where the tip was led: X (as a diameter) and Z in machine
    /// coordinates (E100L-NRC-71).
    LeftOver {
        /// Where they are.
        axes: Point,
    },
}

impl Compensation {
    /// Whether a displacement is left over.
    pub fn is_left_over(&self) -> bool {
        matches!(self, Self::LeftOver { .. })
    }

    /// The stream of a block that begins.
    pub fn stream<'a>(
        &self,
        place: Place,
        side: Option<Side>,
        decided: &'a mut Vec<(Place, Emission)>,
    ) -> Stream<'a> {
        Stream::new(place, side, matches!(self, Self::On(_) | Self::Cutter(_)), decided)
    }

    /// The motions of a block, or its dwell; whether it counts as a block with X/Z motion.
    pub fn motion(
        &mut self,
        plan: &Plan,
        elements: &[Element],
        dwell: Option<Emission>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<bool> {
        let before = std::mem::take(self);
        let begins = plan.compensation == Change::Begins;
        *self = match (before, Nose::in_force(state)) {
            (Self::On(on), None) => cancel::cancel(*on, plan, elements, dwell, stream, state)?,
            (Self::On(on), Some(nose)) => {
                stream.emissions.extend(dwell);
                Self::On(Box::new(along_contour(*on, elements, nose, plan, stream, state)?))
            }
            (before, Some(nose)) => Self::On(Box::new(begin(&before, elements, nose, plan, stream, state)?)),
            (before, None) => {
                stream.emissions.extend(dwell);
                without(before, elements, plan, stream, state)?
            }
        };
        Ok(begins || elements.iter().any(Element::in_plane))
    }

    /// The motion of a block in which G41 or G42 was or is in force in a plane of rotary tools, or its dwell; whether it counts
    /// as one with a motion in the plane (E100L-CRC-14).
    pub fn motion_of_cutter(
        &mut self,
        plane: CutterPlane,
        plan: &Plan,
        dwell: Option<Emission>,
        stream: &mut Stream,
        state: &mut State,
    ) -> Outcome<bool> {
        let before = match std::mem::take(self) {
            Self::Cutter(cutter) => Some(*cutter),
            _ => None,
        };
        let (after, moved) = cutter::block(before, plane, plan, dwell, stream, state)?;
        *self = after.map_or(Self::Off, |cutter| Self::Cutter(Box::new(cutter)));
        Ok(moved)
    }

    /// The end of a block; `moved`: it had an X/Z motion.
    pub fn end_of_block(&mut self, moved: bool, stream: &mut Stream, state: &mut State) -> Outcome<()> {
        *self = match std::mem::take(self) {
            Self::On(on) if moved => Self::On(Box::new(on.hold(stream))),
            Self::On(on) => Self::On(Box::new(on.pass(stream, state)?)),
            Self::Cutter(cutter) => {
                let Cutter { on, programmed } = *cutter;
                let on = if moved { on.hold(stream) } else { on.pass(stream, state)? };
                Self::Cutter(Box::new(Cutter { on, programmed }))
            }
            other => other,
        };
        Ok(())
    }

    /// The beginning of a statement (E100L-CTL-01).
    pub fn begin_statement(&mut self) -> Outcome<()> {
        match self {
            Self::On(on) => on.meet_statement(),
            Self::Cutter(cutter) => cutter.on.meet_statement(),
            Self::Off | Self::LeftOver { .. } => Ok(()),
        }
    }

    /// The end of a statement: it is not counted (E100L-CTL-01).
    pub fn end_of_statement(&mut self, stream: &mut Stream) {
        *self = match std::mem::take(self) {
            Self::On(on) => Self::On(Box::new(on.pass_statement(stream))),
            Self::Cutter(cutter) => {
                let Cutter { on, programmed } = *cutter;
                Self::Cutter(Box::new(Cutter { on: on.pass_statement(stream), programmed }))
            }
            other => other,
        };
    }

    /// M02 or M30: the last motion ends in contact, and the axes stay there (E100L-NRC-44).
    pub fn end_of_program(&mut self, stream: &mut Stream, state: &mut State) -> Outcome<()> {
        *self = match std::mem::take(self) {
            Self::On(on) => {
                on.conclude(NRC_44, None, stream, state)?;
                stream.holding = false;
                Self::Off
            }
            Self::Cutter(cutter) => {
                cutter.on.conclude(NRC_44, None, stream, state)?;
                stream.holding = false;
                Self::Off
            }
            other => other,
        };
        Ok(())
    }
}

fn along_contour(
    mut on: On<Pending>,
    elements: &[Element],
    nose: Nose,
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<On<Pending>> {
    for element in elements {
        on = contour::motion(on, element, nose, plan, stream, state)?;
    }
    Ok(on)
}

/// E100L-NRC-14: the first motion of the block, or one of its own, is the start-up.
fn begin(
    before: &Compensation,
    elements: &[Element],
    nose: Nose,
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<On<Pending>> {
    let axes = match before {
        Compensation::LeftOver { axes } => *axes,
        _ => (state.frame.machine.x, state.frame.machine.z),
    };
    let (own, rest) = match elements.split_first() {
        Some((first, rest)) => (first.clone(), rest),
        None => (start_up::without_words(plan, state), elements),
    };
    let on = start_up::begin(&own, nose, axes, plan, stream, state)?;
    along_contour(on, rest, nose, plan, stream, state)
}

fn without(
    mut before: Compensation,
    elements: &[Element],
    plan: &Plan,
    stream: &mut Stream,
    state: &mut State,
) -> Outcome<Compensation> {
    for element in elements {
        let rules = match before {
            Compensation::LeftOver { axes } => cancel::taken_away(axes, element, state)?,
            _ => RuleSet::EMPTY,
        };
        before = cancel::uncompensated(before, element, rules, true, plan, stream, state)?;
    }
    Ok(before)
}

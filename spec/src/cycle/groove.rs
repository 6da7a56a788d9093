//! G73 and G74: grooves side by side, each in pecks (E100L-GRV-01 to -10).

use super::act::Act;
use super::motion::{Axis, Go, Manner};
use super::peck::{Amounts, Peck, retract};
use crate::fault::{Fault, Outcome};
use crate::integer::tool::parts;
use crate::modal::{Plan, active_feed, dwell_time};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Duration, Part, ToolOffsetSign};

/// Grooves that are left, in program coordinates in nanometres.
#[derive(Clone, Debug)]
pub struct Groove {
    /// The axis of the infeed.
    axis: Axis,
    /// Where the cycle starts on it.
    start: i64,
    /// Where the cut begins.
    level: i64,
    /// All pecks of a groove.
    pecks: Peck,
    /// Where the first groove stands on the other axis, and the last.
    places: (i64, i64),
    /// From groove to groove, with its sign.
    step: i64,
    /// Where the present groove stands.
    place: i64,
    dwell: Option<Duration>,
    stage: Stage,
    cites: Cites,
}

/// What comes next.
#[derive(Clone, Copy, Debug)]
enum Stage {
    Approach,
    Cutting(Peck),
    Done,
}

/// What the events of the block name.
#[derive(Clone, Copy, Debug)]
struct Cites {
    all: Cited,
    /// Motions with a pass.
    pecks: Cited,
    /// A shift.
    shift: Cited,
}

impl Groove {
    /// The grooves of a block, before the first motion.
    pub fn begin(plan: &Plan, state: &State) -> Outcome<Self> {
        active_feed(state)?;
        let words = &plan.words;
        let word = |letter| words.get(letter).unwrap_or(0);
        let (axis, approach, step) =
            if plan.one_shot == Some(73) { (Axis::X, 'I', 'K') } else { (Axis::Z, 'K', 'I') };
        let present = state.frame.program();
        let (start, first) = (axis.of(present), axis.other().of(present));
        let base = |present| if plan.modes.incremental() { present } else { 0 };
        let bottom = base(start) + word(axis.letter());
        let last = words.get(axis.other().letter()).map_or(first, |word| base(first) + word);
        let last = last + words.get('T').map_or(0, |tool| offset_difference(tool, axis.other(), state));
        let (direction, sideways) = ((bottom - start).signum(), (last - first).signum());
        if direction * (bottom - start) <= word(approach) {
            return Err(Fault::about(AlarmName::Unspecified, GRV_03, "depth"));
        }
        if sideways != 0 && word(step) == 0 {
            return Err(Fault::about(AlarmName::Unspecified, GRV_09, "shift"));
        }
        let level = start + direction * word(approach);
        let amount = words.extended("DA").unwrap_or(state.setup.parameters.grooving_retract.0);
        let amounts = Amounts {
            infeed: word('D'),
            discharge: words.get('L'),
            retract: retract(amount, axis, state.setup),
            withdrawal: start,
        };
        let dwell = words.e.as_ref().map(|number| dwell_time(number, state.setup)).transpose()?;
        Ok(Self {
            axis,
            start,
            level,
            pecks: Peck::new(axis, level, bottom, amounts),
            places: (first, last),
            step: sideways * word(step),
            place: first,
            dwell,
            stage: Stage::Approach,
            cites: Cites::of(plan, axis, state),
        })
    }

    /// What comes next; none when all is done.
    pub fn next(&mut self) -> Option<Vec<Act>> {
        match self.stage {
            Stage::Approach => {
                self.stage = Stage::Cutting(self.pecks);
                let cited = self.cited(Part::Approach, self.place);
                Some(vec![Act::Go(Go::along(self.axis, self.level, Manner::Rapid, Part::Approach, cited))])
            }
            Stage::Cutting(mut pecks) => {
                let acts = pecks.next(|part| self.cited(part, self.place));
                self.stage = Stage::Cutting(pecks);
                Some(acts.unwrap_or_else(|| self.end_of_groove()))
            }
            Stage::Done => None,
        }
    }

    /// E100L-GRV-06, E100L-GRV-07: dwell, return, and the way to the next groove or back.
    fn end_of_groove(&mut self) -> Vec<Act> {
        let at_bottom = self.cites.all.and(Cited::rules(&[GRV_06, DWELL_02]));
        let mut acts: Vec<Act> = self.dwell.map(|time| Act::Dwell(time, at_bottom)).into_iter().collect();
        let rapid = |axis, to, part, cited| Act::Go(Go::along(axis, to, Manner::Rapid, part, cited));
        let cited = self.cited(Part::Return, self.place);
        acts.push(rapid(self.axis, self.start, Part::Return, cited));
        let (first, last) = self.places;
        if self.place == last {
            let cited = self.cites.all.and(Cited::rules(&[GRV_07]));
            acts.push(rapid(self.axis.other(), first, Part::Return, cited));
            self.stage = Stage::Done;
        } else {
            let next = self.place + self.step;
            let is_before = (last - next).signum() == self.step.signum();
            self.place = if is_before { next } else { last };
            let cited = self.cited(Part::Shift, self.place);
            acts.push(rapid(self.axis.other(), self.place, Part::Shift, cited));
            self.stage = Stage::Approach;
        }
        acts
    }

    /// What the motions of the groove at a place name.
    fn cited(&self, part: Part, place: i64) -> Cited {
        let Cites { all, pecks, shift } = self.cites;
        let (first, last) = self.places;
        let own = match part {
            Part::Approach => Cited::rules(&[GRV_03]),
            Part::Cut => {
                pecks.and(Cited::rules(&[GRV_04, GRV_10])).and_if(first == last, Cited::rules(&[GRV_09]))
            }
            Part::Retract => pecks.and(Cited::rules(&[GRV_04])),
            Part::Withdraw | Part::Reentry => pecks.and(Cited::rules(&[GRV_05])),
            Part::Shift => shift.and(Cited::rules(&[GRV_06])),
            _ => Cited::rules(&[GRV_06]),
        };
        all.and(own).and_if(place == last && first != last, Cited::rules(&[GRV_07]))
    }
}

impl Cites {
    fn of(plan: &Plan, axis: Axis, state: &State) -> Self {
        let readings = &state.setup.readings;
        let with_t = Cited::rules(&[GRV_08]).reading(readings.tool_offset);
        let on_x = Cited::default().reading(readings.peck_retract);
        Self {
            all: Cited::rules(&[if axis == Axis::X { GRV_01 } else { GRV_02 }]),
            pecks: Cited::default().and_if(axis == Axis::X, on_x),
            shift: Cited::default().and_if(plan.words.get('T').is_some(), with_t),
        }
    }
}

/// E100L-GRV-08: by how much the place of a T word is another one with the offset in force.
fn offset_difference(tool: i64, axis: Axis, state: &State) -> i64 {
    let (_, _, number) = parts(tool);
    let offset = state.frame.tool_offsets.get(usize::from(number)).copied().unwrap_or_default();
    let difference = axis.of(offset) - axis.of(state.frame.active_offset());
    match state.setup.readings.tool_offset {
        ToolOffsetSign::Added => difference,
        ToolOffsetSign::Subtracted => -difference,
    }
}

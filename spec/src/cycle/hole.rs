//! The holes of a block: place, approach, clamp, what the cycle does at the bottom, return (E100L-MCYC-07, E100L-MCYC-08,
//! E100L-MCYC-15 to -20, E100L-G181-01 to E100L-G184-02, E100L-G189-01); in conversion mode the place is a point of the face (E100L-CSC-09).

use super::act::Act;
use super::block::{CycleBlock, Role, is_synchronised};
use super::cited::{Cites, is_unclamped};
use super::kept::{KeptWords, Mode};
use super::key_way::KeyWay;
use super::levels::Levels;
use super::motion::{Axis, Go, Manner, Turn};
use super::peck::{Amounts, Peck, retract};
use super::synchronised::Tap;
use crate::contour::{self, PlanePoint};
use crate::fault::Outcome;
use crate::modal::Plan;
use crate::quantity::{round_narrow, whole};
use crate::state::State;
use crate::vocabulary::{ChipDischarge, CycleReturn, Duration, Part, Setup};

/// Holes that are left, in program coordinates in nanometres.
#[derive(Clone, Debug)]
pub struct Holes {
    block: CycleBlock,
    levels: Levels,
    /// Where the tool returns to.
    back: i64,
    /// The word of the position axis.
    place: Option<i64>,
    /// The C word, and where C stands at the start of the block.
    angle: Option<i64>,
    present_angle: i64,
    /// The point of the face that became place and angle in conversion mode (E100L-CSC-09).
    point: Option<PlanePoint>,
    /// Whether C turns in the positive direction (E100L-CAX-05).
    positive: bool,
    clamps: bool,
    dwell: Option<Duration>,
    /// The thread of a synchronised tap.
    tap: Option<Tap>,
    work: Work,
    count: i64,
    /// Which hole it is, from 0.
    number: i64,
    stage: Stage,
    cites: Cites,
}

/// What is done at the bottom.
#[derive(Clone, Debug)]
enum Work {
    /// It is reached once.
    Once,
    /// E100L-G183-01.
    Pecks(Peck),
    /// G190.
    Ways(Box<KeyWay>),
}

/// What comes next.
#[derive(Clone, Debug)]
enum Stage {
    /// A hole begins, if one is left.
    Begin,
    /// The passes that are left of it.
    Passes(Work),
}

impl Holes {
    /// The holes of a block, before the first motion; its words are kept.
    pub fn begin(block: CycleBlock, mode: &mut Mode, plan: &Plan, state: &State) -> Outcome<Self> {
        let CycleBlock { code, .. } = block;
        let converted =
            (plan.converts && plan.words.has_any("XY")).then(|| contour::place(plan, state)).transpose()?;
        let levels = Levels::of(block, mode, state)?;
        let kept = &mode.words;
        let cites = Cites::of_holes(block, levels.axis, kept.r.is_some(), plan, state);
        let work = match code {
            183 => Work::Pecks(pecks(kept, &levels, state.setup)),
            190 => Work::Ways(Box::new(KeyWay::begin(kept, &levels, cites, state)?)),
            _ => Work::Once,
        };
        let synchronised = is_synchronised(code, state.setup);
        let written = plan.words.get(levels.axis.other().letter()).filter(|_| code != 190);
        let (place, angle) = match converted {
            Some((_, (x, c))) => (Some(x), Some(c)),
            None => (written, plan.words.get('C')),
        };
        // E100L-MCYC-15.
        let by_parameter = state.setup.parameters.cycle_return == CycleReturn::CycleStart;
        let to_start = by_parameter || plan.words.m.contains(&136);
        Ok(Self {
            block,
            levels,
            back: if to_start { levels.start_level() } else { levels.cut },
            place,
            angle,
            point: converted.map(|(point, _)| point),
            present_angle: state.frame.program().c,
            positive: state.is_active(15),
            clamps: !is_unclamped(plan),
            dwell: kept.e.filter(|_| code != 190 && !synchronised).map(Duration),
            tap: if synchronised { Some(Tap::begin(block, &levels, state)?) } else { None },
            work,
            count: plan.words.get('Q').unwrap_or(1).max(1),
            number: 0,
            stage: Stage::Begin,
            cites,
        })
    }

    /// What comes next; none when all is done.
    pub fn next(&mut self) -> Option<Vec<Act>> {
        match std::mem::replace(&mut self.stage, Stage::Begin) {
            Stage::Begin if self.number >= self.count => None,
            Stage::Begin => {
                self.stage = Stage::Passes(self.work.clone());
                Some(self.beginning())
            }
            Stage::Passes(mut work) => {
                let cites = self.cites;
                let acts = match &mut work {
                    Work::Once => None,
                    Work::Pecks(pecks) => pecks.next(|part| cites.peck(part)),
                    Work::Ways(ways) => ways.next(),
                };
                if acts.is_some() {
                    self.stage = Stage::Passes(work);
                    return acts;
                }
                let acts = self.ending();
                self.number += 1;
                Some(acts)
            }
        }
    }

    /// Place, tool, approach, clamp.
    fn beginning(&self) -> Vec<Act> {
        let again = self.number > 0;
        let mut acts = vec![Act::Go(self.position(again))];
        if self.block.role == Role::First && !again {
            // E100L-MCYC-10, E100L-STAP-02.
            acts.push(self.code(if self.tap.is_some() { 12 } else { 13 }));
        }
        acts.push(self.along(self.levels.cut, Manner::Rapid, Part::Approach));
        if self.clamps {
            acts.push(self.code(147));
        }
        acts
    }

    /// E100L-MCYC-07, E100L-MCYC-08; of the holes of Q C alone turns on (E100L-MCYC-20).
    fn position(&self, again: bool) -> Go {
        let (place, angle) = if again {
            let turned = round_narrow(&(whole(self.number * 360_000_000) / whole(self.count)));
            let first = self.angle.unwrap_or(self.present_angle);
            (None, Some(if self.positive { first + turned } else { first - turned }))
        } else {
            (self.place, self.angle)
        };
        let (x, z) = match self.levels.axis {
            Axis::X => (None, place),
            Axis::Z => (place, None),
        };
        let point = self.point.filter(|_| !again);
        let cited =
            if point.is_some() { self.cites.converted() } else { self.cites.motion(Part::Position, again) };
        let c = angle.map(Turn::To);
        Go { x, z, c, point, manner: Manner::Rapid, part: Part::Position, pass: None, cited }
    }

    /// What the cycle does at the bottom but for its passes, and the return.
    fn ending(&self) -> Vec<Act> {
        let mut acts = self.at_bottom();
        acts.extend(self.way_out());
        if self.clamps {
            acts.push(self.code(146));
        }
        acts.extend(self.after_release());
        acts
    }

    /// The cut, if there were no passes, and the dwell; a tap.
    fn at_bottom(&self) -> Vec<Act> {
        if let Some(tap) = &self.tap {
            return tap.acts(&self.cites).to_vec();
        }
        let mut acts = match self.work {
            Work::Once => vec![Act::Pass, self.along(self.levels.bottom, Manner::Feed, Part::Cut)],
            Work::Pecks(_) | Work::Ways(_) => Vec::new(),
        };
        acts.extend(self.dwell.map(|time| Act::Dwell(time, self.cites.dwell())));
        acts
    }

    /// The way out, as far as C is clamped.
    fn way_out(&self) -> Vec<Act> {
        let back = self.along(self.back, Manner::Rapid, Part::Return);
        // E100L-MCYC-16.
        let at_feed = self.along(self.levels.cut, Manner::Feed, Part::Exit);
        match self.block.code {
            _ if self.tap.is_some() => Vec::new(),
            182 => vec![self.code(12), back],
            184 => vec![self.code(12), self.code(14), at_feed],
            189 => vec![at_feed],
            _ => [Some(back), self.to_slot()].into_iter().flatten().collect(),
        }
    }

    /// What comes when C is released.
    fn after_release(&self) -> Vec<Act> {
        let cited = self.cites.return_after_exit();
        let back = Act::Go(Go::along(self.levels.axis, self.back, Manner::Rapid, Part::Return, cited));
        match self.block.code {
            _ if self.tap.is_some() => vec![back],
            182 => vec![self.code(13)],
            184 => vec![self.code(12), self.code(13), back],
            189 => vec![back],
            _ => Vec::new(),
        }
    }

    /// E100L-G190-02: back to the beginning of the slot.
    fn to_slot(&self) -> Option<Act> {
        let Work::Ways(ways) = &self.work else { return None };
        let cited = self.cites.back();
        Some(Act::Go(Go::along(self.levels.axis.other(), ways.start(), Manner::Rapid, Part::Return, cited)))
    }

    fn code(&self, code: u16) -> Act {
        Act::Code(code, self.cites.code())
    }

    fn along(&self, to: i64, manner: Manner, part: Part) -> Act {
        Act::Go(Go::along(self.levels.axis, to, manner, part, self.cites.motion(part, self.number > 0)))
    }
}

/// E100L-G183-01, E100L-G183-02.
fn pecks(kept: &KeptWords, levels: &Levels, setup: &Setup) -> Peck {
    let Levels { axis, cut, bottom, .. } = *levels;
    let withdrawal = match setup.readings.chip_discharge {
        ChipDischarge::CuttingStart => cut,
        ChipDischarge::CycleStart => levels.start_level(),
    };
    let amounts = Amounts {
        // A first block has D, and it is not zero.
        infeed: kept.d.unwrap_or(levels.depth()),
        discharge: kept.l,
        retract: retract(setup.parameters.drilling_retract.0, axis, setup),
        withdrawal,
    };
    Peck::new(axis, cut, bottom, amounts)
}

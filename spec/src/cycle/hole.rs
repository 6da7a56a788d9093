//! The holes of a block: place, approach, clamp, what the cycle does at the bottom, return (E100L-MCYC-07, E100L-MCYC-08,
//! E100L-MCYC-15 to -20, E100L-G181-01 to E100L-G184-02, E100L-G189-01, E100L-STAP-01 to -04).

use super::act::Act;
use super::block::{CycleBlock, Role, is_synchronised};
use super::cited::{Cites, is_unclamped};
use super::kept::Mode;
use super::key_way::KeyWay;
use super::motion::{Axis, Go, Manner, Turn};
use super::peck::{Amounts, Peck, retract};
use crate::fault::{Fault, Outcome};
use crate::modal::{Plan, active_feed};
use crate::quantity::{round_narrow, whole};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, ChipDischarge, CycleReturn, Duration, Part};

/// Holes that are left, in program coordinates in nanometres.
#[derive(Clone, Debug)]
pub struct Holes {
    block: CycleBlock,
    synchronised: bool,
    /// The axis of the infeed.
    axis: Axis,
    /// Where the cut begins, where it ends, and where the tool returns to.
    level: i64,
    bottom: i64,
    back: i64,
    /// The word of the position axis, and the C word.
    place: Option<i64>,
    angle: Option<i64>,
    /// Where C stands at the start of the block, if there is no C word.
    present_angle: i64,
    /// Whether C turns in the positive direction (E100L-CAX-05).
    positive: bool,
    clamps: bool,
    dwell: Option<Duration>,
    /// The manner of a tap, there and back.
    tap: Manner,
    work: Work,
    count: i64,
    /// Which hole it is, from 0.
    number: i64,
    stage: Stage,
    cites: Cites,
}

/// What is done at the bottom in passes.
#[derive(Clone, Debug)]
enum Work {
    /// It goes down once.
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
    pub fn begin(block: CycleBlock, plan: &Plan, state: &mut State) -> Outcome<Self> {
        let Some(mode) = state.cycle.mode else { return Err(depth()) };
        let CycleBlock { code, role } = block;
        let kept = mode.words;
        let axis = if kept.i.is_some() { Axis::X } else { Axis::Z };
        let (bottom_word, approach) = match axis {
            Axis::X => (kept.x, kept.i),
            Axis::Z => (kept.z, kept.k),
        };
        let approach = approach.unwrap_or(0);
        let cycle_start = state.frame.to_program(mode.start);
        let start = axis.of(cycle_start);
        let direction = match role {
            // E100L-MCYC-22: the sign of R is the direction.
            Role::First => kept.r.unwrap_or_else(|| bottom_word.unwrap_or(start) - start).signum(),
            _ => mode.direction,
        };
        state.cycle.mode = Some(Mode { direction, ..mode });
        let level = start + direction * approach;
        let bottom = kept.r.map_or(bottom_word.unwrap_or(level), |depth| level + depth);
        if direction * (bottom - level) <= 0 {
            return Err(depth());
        }
        // E100L-MCYC-21.
        state.cycle.spent |= plan.words.get('Q').is_some();
        let has = |code| plan.words.m.contains(&code);
        let cites = Cites::of_holes(block, axis, kept.r.is_some(), plan, state.setup);
        let work = match code {
            183 => {
                let discharge_level = match state.setup.readings.chip_discharge {
                    ChipDischarge::CuttingStart => level,
                    ChipDischarge::CycleStart => start,
                };
                let amounts = Amounts {
                    infeed: kept.d.unwrap_or(0),
                    discharge: kept.l,
                    retract: retract(state.setup.parameters.drilling_retract.0, axis, state.setup),
                    withdrawal: discharge_level,
                };
                Work::Pecks(Peck::new(axis, level, direction, bottom, amounts))
            }
            190 => {
                let slot = axis.other().of(cycle_start);
                Work::Ways(Box::new(KeyWay::begin(
                    &mode, axis, level, direction, bottom, slot, cites, state,
                )?))
            }
            _ => Work::Once,
        };
        let synchronised = is_synchronised(code, state.setup);
        let returns_far = has(136) || state.setup.parameters.cycle_return == CycleReturn::CycleStart;
        Ok(Self {
            block,
            synchronised,
            axis,
            level,
            bottom,
            back: if returns_far { start } else { level },
            place: plan.words.get(axis.other().letter()).filter(|_| code != 190),
            angle: plan.words.get('C'),
            present_angle: state.frame.program().c,
            positive: state.is_active(15),
            clamps: !is_unclamped(plan),
            dwell: kept.e.filter(|_| code != 190 && !synchronised).map(Duration),
            tap: if synchronised { tap(axis, state)? } else { Manner::Feed },
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
        let code = self.cites.code();
        let mut acts = vec![Act::Go(self.position(again))];
        if self.block.role == Role::First && !again {
            acts.push(Act::Code(13, code));
            if self.synchronised {
                // E100L-STAP-02.
                acts.pop();
                acts.push(Act::Code(12, code));
            }
        }
        let cited = self.cites.motion(Part::Approach, again);
        acts.push(self.rapid(self.level, Part::Approach, cited));
        if self.clamps {
            acts.push(Act::Code(147, code));
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
        let (x, z) = match self.axis {
            Axis::X => (None, place),
            Axis::Z => (place, None),
        };
        let cited = self.cites.motion(Part::Position, again);
        let c = angle.map(Turn::To);
        Go { x, z, c, manner: Manner::Rapid, part: Part::Position, pass: None, cited }
    }

    /// What the cycle does at the bottom, and the return.
    fn ending(&self) -> Vec<Act> {
        let code = |code| Act::Code(code, self.cites.code());
        let unclamp = self.clamps.then(|| code(146));
        let cut = self.cites.motion(Part::Cut, false);
        let down = [Act::Pass, self.along(self.bottom, Manner::Feed, Part::Cut, cut)];
        let dwell = self.dwell.map(|time| Act::Dwell(time, self.cites.dwell()));
        let back = self.rapid(self.back, Part::Return, self.cites.motion(Part::Return, false));
        let up = self.along(self.level, Manner::Feed, Part::Exit, self.cites.motion(Part::Exit, false));
        let after_exit = self.rapid(self.back, Part::Return, self.cites.return_after_exit());
        let mut acts = Vec::new();
        match self.block.code {
            _ if self.synchronised => return self.synchronised(unclamp, after_exit),
            182 => {
                acts.extend(down);
                acts.extend(dwell);
                acts.extend([code(12), back]);
                acts.extend(unclamp);
                acts.push(code(13));
            }
            183 => {
                acts.extend(dwell);
                acts.push(back);
                acts.extend(unclamp);
            }
            184 => {
                acts.extend(down);
                acts.extend(dwell);
                acts.extend([code(12), code(14), up]);
                acts.extend(unclamp);
                acts.extend([code(12), code(13), after_exit]);
            }
            189 => {
                acts.extend(down);
                acts.extend(dwell);
                acts.push(up);
                acts.extend(unclamp);
                acts.push(after_exit);
            }
            190 => {
                acts.push(back);
                acts.extend(self.to_slot());
                acts.extend(unclamp);
            }
            _ => {
                acts.extend(down);
                acts.extend(dwell);
                acts.push(back);
                acts.extend(unclamp);
            }
        }
        acts
    }

    /// E100L-STAP-02, E100L-STAP-03, E100L-STAP-04.
    fn synchronised(&self, unclamp: Option<Act>, back: Act) -> Vec<Act> {
        let (inward, outward) = if self.block.code == 179 { (14, 13) } else { (13, 14) };
        let thread = |to, part| self.along(to, self.tap, part, self.cites.tap(part));
        let cited = self.cites.code();
        let mut acts = vec![
            Act::Code(inward, cited),
            Act::Pass,
            thread(self.bottom, Part::Cut),
            Act::Code(outward, cited),
            thread(self.level, Part::Exit),
            Act::Code(12, cited.and(Cited::rules(&[STAP_04]))),
        ];
        acts.extend(unclamp);
        acts.push(back);
        acts
    }

    /// E100L-G190-02: back to the beginning of the slot.
    fn to_slot(&self) -> Option<Act> {
        let Work::Ways(ways) = &self.work else { return None };
        let cited = self.cites.back();
        Some(Act::Go(Go::along(self.axis.other(), ways.start(), Manner::Rapid, Part::Return, cited)))
    }

    fn rapid(&self, to: i64, part: Part, cited: Cited) -> Act {
        self.along(to, Manner::Rapid, part, cited)
    }

    fn along(&self, to: i64, manner: Manner, part: Part, cited: Cited) -> Act {
        Act::Go(Go::along(self.axis, to, manner, part, cited))
    }
}

fn depth() -> Fault {
    Fault::about(AlarmName::Unspecified, MCYC_05, "depth")
}

/// E100L-STAP-01: the lead of a tap.
fn tap(axis: Axis, state: &State) -> Outcome<Manner> {
    let speed = state.spindle.tool_speed;
    if speed == 0 {
        return Err(Fault::about(AlarmName::Unspecified, STAP_01, "speed"));
    }
    let (feed, _) = active_feed(state)?;
    let leads = state.feed.map_or(1, |feed| feed.leads).max(1);
    let lead = whole(feed.value.0) / whole(leads);
    // Thousandths of a revolution per minute.
    let lead = if state.modes.per_minute() { lead * whole(1_000) / whole(speed) } else { lead };
    Ok(Manner::Tap { axis, lead: round_narrow(&lead), start: state.cycle.start_angle })
}

//! Grooving and drilling cycles: pecks make the depth and no more, and every hole ends where it has to.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, Event, Part, Position, RuleId, Side};

use crate::bores::Bore;
use crate::differential::show;
use crate::shape::{motion, trace};
use crate::{Verdict, require};

/// The rules of grooves, and of hole cycles on the face and on the side.
const GROOVES: &[RuleId] = &[GRV_01, GRV_02];
const HOLES: &[RuleId] = &[MCYC_07, MCYC_08, G190_01];

/// Of a program of the generator, and of the bores below:
///
/// 1. **Order of pecks.** The cuts of a peck are numbered from 1 without a gap; each is deeper than the one before, by
///    as much as the first one, the last by that at most. All grooves of a block have one bottom.
/// 2. **End.** A groove block ends in the point where it began. A hole block ends on the level of its cutting start or on
///    that of the cycle start.
///
/// Of a block of G73, G74 or G183 with any depth, approach, D, L, retract and readings, and of the same with one increment
/// more in the depth, in D and in L:
///
/// 3. **Number.** There are ⌈T/D⌉ pecks; their steps sum to T, and each is D at most. An increment changes their number
///    only where it crosses a multiple of D.
/// 4. **Return.** Between two pecks the tool goes back by the retract, and never above the cutting start, or out of the
///    hole: with ⌈L/D⌉ = k after every k-th peck but the last, to the level that code and reading say.
/// 5. **Bound.** A hole of n pecks has 3n + 4 motions at most.
///
/// Rules: E100L-GRV-03, E100L-GRV-04, E100L-GRV-05, E100L-GRV-06, E100L-GRV-07, E100L-GRV-10, E100L-MCYC-05, E100L-MCYC-15,
/// E100L-G183-01, E100L-G183-02
pub(crate) fn holes_are_whole(input: &[u8]) -> Verdict {
    let mut bytes = Unstructured::new(input);
    if let Ok(bore) = Bore::arbitrary(&mut bytes) {
        for bore in bore.nudged() {
            bore.holds()?;
        }
    }
    let Ok(case) = Case::arbitrary(&mut Unstructured::new(input)) else { return Ok(()) };
    blocks_are_whole(&trace(&case)).map_err(|message| format!("{message}\n{}", show(&case)))
}

fn cites(event: &Event, rules: &[RuleId]) -> bool {
    event.rules.as_slice().iter().any(|rule| rules.contains(rule))
}

/// Whether a motion feeds in along X.
fn is_along_x(event: &Event) -> bool {
    cites(event, &[GRV_01, MCYC_08])
}

pub(crate) fn infeed(along_x: bool, position: Position) -> i64 {
    if along_x { position.x.0 } else { position.z.0 }
}

/// What is known of the block whose motions are being read.
struct Block {
    start: u32,
    groove: bool,
    along_x: bool,
    /// Where it began, and where it has come.
    begin: Position,
    end: Position,
    /// The level of its cutting start, as far as the tool went there.
    level: Option<i64>,
    bottom: Option<i64>,
    pecks: Pecks,
}

/// The pecks of a hole.
#[derive(Clone, Copy, Default)]
struct Pecks {
    number: u32,
    /// Where the first one began, where the last one ended, how deep the first and the last were.
    top: i64,
    bottom: i64,
    first: i64,
    last: i64,
}

impl Pecks {
    fn cut(&mut self, number: u32, from: i64, to: i64) -> Verdict {
        if number == 1 {
            let deep = (to - from).abs();
            *self = Self { number, top: from, bottom: to, first: deep, last: deep };
            return Ok(());
        }
        require(number == self.number + 1, || format!("peck {number} behind peck {}", self.number))?;
        require(self.last == self.first, || format!("a peck of {} nm before the last one", self.last))?;
        let direction = (self.bottom - self.top).signum();
        let deeper = direction * (to - self.bottom);
        require((1..=self.first).contains(&deeper), || format!("peck {number} is {deeper} nm deeper"))?;
        (self.number, self.bottom, self.last) = (number, to, deeper);
        Ok(())
    }
}

impl Block {
    /// Takes the next motion of the block.
    fn take(&mut self, event: &Event, part: Part, pass: Option<u32>, to: Position) -> Verdict {
        let (from, depth) = (infeed(self.along_x, self.end), infeed(self.along_x, to));
        match (part, pass) {
            (Part::Approach, _) => self.level = Some(depth),
            (Part::Cut, Some(number)) if cites(event, &[GRV_04, G183_01]) => {
                if number == 1 {
                    self.level = Some(from);
                }
                self.pecks.cut(number, from, depth)?;
            }
            (Part::Return, _) if self.groove && self.bottom.is_none() => self.bottom = Some(from),
            (Part::Return, _) if self.groove && from != depth => {
                let bottom = self.bottom.unwrap_or(from);
                require(from == bottom, || format!("a groove of another depth: {event:?}"))?;
            }
            _ => {}
        }
        self.end = to;
        Ok(())
    }

    /// Statement 2.
    fn ended(&self, cycle_start: Option<Position>) -> Verdict {
        if self.groove {
            let (begin, end) = (self.begin, self.end);
            let stays = begin.x == end.x && begin.z == end.z;
            return require(stays, || format!("the groove block at {} ends in {end:?}", self.start));
        }
        // Where a cycle starts that is the first motion of a program is not told.
        let Some(cycle_start) = cycle_start else { return Ok(()) };
        let level = |point: Position| Some(infeed(self.along_x, point));
        let end = infeed(self.along_x, self.end);
        let allowed = [level(self.begin), level(cycle_start), self.level];
        require(allowed.contains(&Some(end)), || {
            format!("the hole at {} ends on {end}, not on one of {allowed:?}", self.start)
        })
    }
}

/// Statements 1 and 2.
pub(crate) fn blocks_are_whole(events: &[Event]) -> Verdict {
    // An alarm, or the limit of steps, may come in the middle of a block.
    let cut_short = events.last().is_some_and(|event| matches!(event.action, Action::Alarm(_)));
    for saddle in [None, Some(Side::A), Some(Side::B)] {
        let own = events.iter().filter(|event| event.saddle == saddle);
        let mut here: Option<Position> = None;
        let mut cycle_start = None;
        let mut unknown = None;
        let mut block: Option<Block> = None;
        for event in own {
            if let Action::Mode { group, .. } = event.action
                && group.as_str() == "cycle"
            {
                if let Some(block) = block.take() {
                    block.ended(cycle_start)?;
                }
                cycle_start = here;
            }
            let Some(motion) = motion(event) else { continue };
            let groove = cites(event, GROOVES);
            let part = motion.part.filter(|_| groove || cites(event, HOLES));
            if block.as_ref().is_some_and(|block| part.is_none() || block.start != event.block.start)
                && let Some(block) = block.take()
            {
                block.ended(cycle_start)?;
            }
            // What the first motion of a program begins from is not told.
            if part.is_some() && here.is_none() {
                unknown = Some(event.block.start);
            }
            if let (Some(part), Some(begin)) = (part, here)
                && unknown != Some(event.block.start)
            {
                let block = block.get_or_insert_with(|| Block {
                    start: event.block.start,
                    groove,
                    along_x: is_along_x(event),
                    begin,
                    end: begin,
                    level: None,
                    bottom: None,
                    pecks: Pecks::default(),
                });
                // A key way goes sideways too, and its infeed axis is told by no rule of all of its motions.
                if !cites(event, &[G190_01]) {
                    block.take(event, part, motion.pass, motion.machine)?;
                }
            }
            here = Some(motion.machine);
        }
        if let Some(block) = block.filter(|_| !cut_short) {
            block.ended(cycle_start)?;
        }
    }
    Ok(())
}

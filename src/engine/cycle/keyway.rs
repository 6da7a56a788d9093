//! G190, a key way: a slot in passes of growing depth (execution of drilling, 8, "Passes of G190"; E100L-G190-02 to
//! E100L-G190-07).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Feed, FeedRate, FeedUnit, KeywayReturn, Part, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::drilling::{at_part, equal_steps};
use crate::engine::cite;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::thread::Cited;

use super::axis::Axis;
use super::hole::Holes;
use super::motion::Drive;
use super::unspecified;

/// A key way.
#[derive(Clone, Copy, Debug)]
pub struct Keyway {
    /// Its depth from the cutting start, and that without the finishing allowance.
    depth: i64,
    rough: i64,
    /// D.
    step: i64,
    /// How many passes, the finishing pass aside.
    passes: i64,
    /// Whether their depths differ by equal steps, with M214.
    equal: bool,
    /// The beginning and the end of the slot.
    begin: i64,
    end: i64,
    /// E in picometres per minute.
    plunge: Option<i64>,
}

impl Keyway {
    fn has_finish(&self) -> bool {
        self.rough != self.depth
    }

    /// The depth of a pass, by its number from 1, as a part of one, and of how many: (depth, part, parts).
    fn depth_of(&self, number: i64) -> (i64, i64, i64) {
        match () {
            () if number > self.passes => (self.depth, 1, 1),
            () if self.equal => (self.rough, number, self.passes),
            () => (self.step.saturating_mul(number).min(self.rough), 1, 1),
        }
    }
}

/// What the motions of the passes cite.
struct KeywayCites {
    /// Those between the cuts.
    between: Cited,
    infeed: Cited,
    cut: Cited,
}

impl Interpreter<'_> {
    /// The data of a key way of a depth, and what is tested before the first pass.
    pub(super) fn keyway(&self, depth: i64) -> Result<Keyway, Fault> {
        let kept = &self.state.cycle;
        let slot = kept.axis.other();
        let (begin, end) = (self.cycle_start(slot), kept.data.coordinate(slot));
        if begin == end {
            return Err(unspecified(G190_02, "slot"));
        }
        let (allowance, letter) = match kept.axis {
            Axis::Z => (kept.data.w, "W"),
            Axis::X => (kept.data.u, "U"),
        };
        let rough = depth.saturating_sub(allowance.unwrap_or_default());
        if rough <= 0 {
            return Err(unspecified(G190_07, letter));
        }
        // D was tested: it is there, and not zero.
        let step = kept.data.d.unwrap_or_default().max(1);
        let passes = match planted::is(Bug::StepsCut) {
            true => (rough / step).max(1),
            false => equal_steps(rough, step),
        };
        Ok(Keyway { depth, rough, step, passes, equal: kept.equal, begin, end, plunge: kept.data.e })
    }

    /// The passes, and the way back.
    pub(super) fn cut_keyway(
        &mut self,
        holes: &Holes,
        keyway: &Keyway,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let slot = holes.axis.other();
        let last = keyway.passes.saturating_add(i64::from(keyway.has_finish()));
        let mut cites = self.keyway_cites(holes, keyway, false);
        for number in 1..=last {
            if number > keyway.passes {
                cites = self.keyway_cites(holes, keyway, true);
            }
            self.cut_pass(holes, keyway, number, &cites, sink)?;
            if number < last && !self.state.cycle.zigzag {
                self.return_to_begin(holes, keyway, number, cites.between, sink)?;
            }
        }
        let back = (holes.axis, holes.back);
        self.go_along(back, Drive::Rapid, (Part::Return, None), holes.cites.back, sink)?;
        let begin = (slot, keyway.begin);
        self.go_along(begin, Drive::Rapid, (Part::Return, None), holes.cites.every, sink)
    }

    /// Plunges and cuts.
    fn cut_pass(
        &mut self,
        holes: &Holes,
        keyway: &Keyway,
        number: i64,
        cites: &KeywayCites,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.begin_pass()?;
        let pass = Some(u32::try_from(number).unwrap_or(u32::MAX));
        let plunge = keyway
            .plunge
            .map_or(holes.feed, |rate| Feed { value: FeedRate(rate), unit: FeedUnit::PerMinute });
        let depth = at_part(holes.level, holes.direction, keyway.depth_of(number), 0);
        let infeed = (Part::Infeed, pass);
        self.go_along((holes.axis, depth), Drive::Feed(plunge), infeed, cites.infeed, sink)?;
        let first = i64::from(planted::is(Bug::ZigzagShifted));
        let backwards = self.state.cycle.zigzag && number % 2 == first;
        let target = if backwards { keyway.begin } else { keyway.end };
        let part = if number > keyway.passes { Part::Finish } else { Part::Cut };
        let slot = (holes.axis.other(), target);
        self.go_along(slot, Drive::Feed(holes.feed), (part, pass), cites.cut, sink)
    }

    /// M211: through the air to the beginning of the slot (E100L-G190-03).
    fn return_to_begin(
        &mut self,
        holes: &Holes,
        keyway: &Keyway,
        number: i64,
        cited: Cited,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let pass = |number: i64| Some(u32::try_from(number).unwrap_or(u32::MAX));
        let relief = self.retract(holes.axis, self.setup.parameters.drilling_retract.0);
        let relieved = (holes.axis, at_part(holes.level, holes.direction, keyway.depth_of(number), relief));
        let begin = (holes.axis.other(), keyway.begin);
        let shift = (Part::Shift, pass(number));
        if self.setup.readings.keyway_return == KeywayReturn::Relief {
            self.go_along(relieved, Drive::Rapid, (Part::Retract, pass(number)), cited, sink)?;
            return self.go_along(begin, Drive::Rapid, shift, cited, sink);
        }
        let out = (holes.axis, holes.level);
        self.go_along(out, Drive::Rapid, (Part::Withdraw, pass(number)), cited, sink)?;
        self.go_along(begin, Drive::Rapid, shift, cited, sink)?;
        let reentry = (Part::Reentry, pass(number.saturating_add(1)));
        self.go_along(relieved, Drive::Rapid, reentry, cited, sink)
    }

    fn keyway_cites(&mut self, holes: &Holes, keyway: &Keyway, finishing: bool) -> KeywayCites {
        let one_way = !self.state.cycle.zigzag;
        let depths = match finishing {
            true => const { RuleSet::of(&[G190_07]) },
            false if keyway.equal => const { RuleSet::of(&[G190_06]) },
            false => const { RuleSet::of(&[G190_05]) },
        };
        let direction = match one_way {
            true => const { RuleSet::of(&[G190_03]) },
            false => const { RuleSet::of(&[G190_04]) },
        };
        let (keyway_return, peck_retract) = (self.known.keyway_return, self.known.peck_retract);
        let pass = |cited: Cited| {
            cited
                .and(direction)
                .by_if(one_way, keyway_return)
                .by_if(one_way && holes.axis == Axis::X, peck_retract)
        };
        let feed = holes.cites.feed;
        let plunge = match keyway.plunge {
            Some(_) => self.cites.rules(cite::FEED_02.and(cite::G01_04)),
            None => feed.rules,
        };
        KeywayCites {
            between: pass(holes.cites.every),
            infeed: pass(holes.cites.every).and(depths.union(plunge)).by(feed.readings),
            cut: pass(holes.cites.cut).and(depths.union(feed.rules)).by(feed.readings),
        }
    }
}

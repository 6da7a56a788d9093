//! Rough cycles in programs of the generator: what can be told of them without their contours.

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, Event, Part, Position, Side};

use crate::shape::motion;
use crate::{Verdict, require};

/// A motion of a cycle: where it begins and ends on the machine.
struct Move {
    part: Part,
    pass: Option<u32>,
    from: Position,
    to: Position,
}

/// The motions of a call of G85 or G86.
struct Cycle {
    /// Where its block begins, and of whose turret it is.
    block: (u32, Option<Side>),
    /// G85; G82.
    bar: bool,
    across: bool,
    /// Where the tool was; none at the beginning of a program.
    start: Option<Position>,
    moves: Vec<Move>,
}

/// Of every call of G85 and G86 in a program that the generator grows from the bytes, with any set-up, modes and turrets:
///
/// 1. Passes are numbered from 1 without a gap; a cycle begins with `infeed`, and nothing but `home` is behind `home`.
/// 2. The cuts of G85 keep to their level; with G85 nothing is deeper than what is run along.
/// 3. The last `home` ends where the tool was at the call.
///
/// Rules: E100L-AP1-01, E100L-AP1-04, E100L-AP1-08, E100L-AP1-09, E100L-AP2-05, E100L-AP4-08, E100L-AP5-07
pub(crate) fn cycles_are_whole(events: &[Event]) -> Verdict {
    for saddle in [None, Some(Side::A), Some(Side::B)] {
        let (mut open, mut at): (Option<Cycle>, Option<Position>) = (None, None);
        for event in events.iter().filter(|event| event.saddle == saddle) {
            if matches!(event.action, Action::Alarm(_)) {
                open = None;
            }
            let Some(motion) = motion(event) else { continue };
            let is = |rules: &[_]| event.rules.as_slice().iter().any(|rule| rules.contains(rule));
            let block = (event.block.start, event.turret);
            let begins = motion.pass == Some(1)
                && open.as_ref().is_none_or(|cycle| {
                    cycle.block != block || cycle.moves.last().is_some_and(|last| last.pass != Some(1))
                });
            if begins || !is(&[LAPC_01, LAPC_05]) {
                open.take().map_or(Ok(()), |cycle: Cycle| cycle.holds())?;
            }
            if begins && is(&[LAPC_01, LAPC_05]) {
                let (bar, across) = (is(&[LAPC_01]), is(&[AP1_14, AP4_09]));
                open = Some(Cycle { block, bar, across, start: at, moves: Vec::new() });
            }
            if let (Some(cycle), Some(part), Some(from)) = (&mut open, motion.part, at) {
                cycle.moves.push(Move { part, pass: motion.pass, from, to: motion.machine });
            }
            at = Some(motion.machine);
        }
        open.map_or(Ok(()), |cycle| cycle.holds())?;
    }
    Ok(())
}

impl Cycle {
    /// Statements 1 to 3.
    fn holds(&self) -> Verdict {
        let level = |at: Position| if self.across { at.z.0 } else { at.x.0 };
        let (mut number, mut before) = (1, None);
        for one in &self.moves {
            let Move { part, pass, .. } = *one;
            let next = pass.is_none_or(|pass| pass == number || pass == number + 1);
            require(next, || format!("pass {pass:?} behind {number}"))?;
            require(pass.is_none() == (part == Part::Home), || format!("{part:?} in pass {pass:?}"))?;
            require(before.is_some() || part == Part::Infeed, || format!("it begins with {part:?}"))?;
            require(before != Some(Part::Home) || part == Part::Home, || format!("{part:?} behind home"))?;
            let leaves = self.bar && part == Part::Cut && level(one.from) != level(one.to);
            require(!leaves, || format!("a cut from {:?} to {:?}", one.from, one.to))?;
            (number, before) = (pass.unwrap_or(number), Some(part));
        }
        let Some(start) = self.start else { return Ok(()) };
        self.is_no_deeper(level(start), level)?;
        let home = self.moves.last().filter(|last| last.part == Part::Home);
        let back = home.is_none_or(|home| (home.to.x, home.to.z) == (start.x, start.z));
        require(back, || format!("home is {:?}, not {start:?}", home.map(|home| home.to)))
    }

    /// No motion of G85 ends below all that is run along.
    fn is_no_deeper(&self, start: i64, level: impl Fn(Position) -> i64) -> Verdict {
        let along = self.moves.iter().filter(|one| one.part == Part::Contour);
        let ends: Vec<i64> = along.flat_map(|one| [level(one.from), level(one.to)]).collect();
        let last = self.moves.iter().rev().find(|one| one.part == Part::Infeed);
        let side = last.map_or(0, |last| (start - level(last.to)).signum());
        let Some(deepest) = ends.iter().map(|end| side * end).min().filter(|_| self.bar) else {
            return Ok(());
        };
        for one in &self.moves {
            let end = side * level(one.to);
            require(end >= deepest, || format!("{:?} down to {end}, the contour to {deepest}", one.part))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use turnspec_generator::case_from_seed;
    use turnspec_oracle::vocabulary::{Action, Event, Motion, Part};

    use super::cycles_are_whole;
    use crate::lap_job::Mode;
    use crate::lap_tests::grooved;
    use crate::shape::{motion, trace};

    /// What is wrong with the trace of a call of G85 after a change of its motions of a part.
    fn verdict(part: Part, change: impl Fn(&mut Motion)) -> Result<(), String> {
        let mut events = trace(&grooved(Mode::Bar).case());
        for event in &mut events {
            if let Action::Rapid { motion } | Action::Linear { motion, .. } = &mut event.action
                && motion.part == Some(part)
            {
                change(motion);
            }
        }
        cycles_are_whole(&events)
    }

    #[test]
    fn cycles_that_are_wrong_are_noticed() {
        assert_eq!(verdict(Part::Cut, |_| ()), Ok(()));
        let wrong = |part, change: &dyn Fn(&mut Motion)| verdict(part, change).expect_err("it is noticed");
        assert!(wrong(Part::Cut, &|motion| motion.machine.x.0 += 1).contains("a cut from"));
        assert!(wrong(Part::Home, &|motion| motion.machine.z.0 += 1).contains("home is"));
        assert!(wrong(Part::Infeed, &|motion| motion.part = Some(Part::Air)).contains("begins with"));
        assert!(wrong(Part::Contour, &|motion| motion.pass = Some(9)).contains("pass Some(9) behind"));
        assert!(wrong(Part::Clear, &|motion| motion.machine.x.0 -= 90_000_000).contains("the contour to"));
    }

    #[test]
    fn programs_have_cycles() {
        let cycles = |event: &Event| motion(event).is_some_and(|motion| motion.part == Some(Part::Relief));
        let count = (0..300).filter(|seed| trace(&case_from_seed(*seed)).iter().any(cycles)).count();
        assert!(count >= 5, "{count}");
    }
}

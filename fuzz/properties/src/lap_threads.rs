//! Calls of G88 that are composed: a thread of several legs, as deep as its pattern says in every pass.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{Event, Part, Setup};

use crate::differential::show;
use crate::shape::{motion, trace};
use crate::thread_counts::{Heights, Pattern};
use crate::{Verdict, require};

/// Micrometres to nanometres.
const MICRO: i64 = 1_000;

/// How far the AP start is above the start of the thread, and before it, in micrometres.
const START: i64 = 40_000;

/// A call of G88, its amounts in micrometres, of whose contour every leg has its way along Z and on X:
///
/// 1. **Number.** The passes are as many as the thresholds of the pattern give, counted on whole micrometres; an increment more in D
///    changes that only where it crosses one of them. Where the pattern is refused there is no pass.
/// 2. **Contour.** A pass has the legs of the contour, all moved by one amount on X, the last one by none, the others less
///    from pass to pass and never toward the axis; without an angle none is moved along Z.
/// 3. **Return.** Every pass ends in the AP start.
#[derive(Clone, Debug)]
pub(crate) struct Thread {
    outside: bool,
    legs: Vec<(i64, i64)>,
    heights: Heights,
    pattern: Pattern,
    angle: i64,
}

impl<'a> Arbitrary<'a> for Thread {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let height = bytes.int_in_range(200..=9_000)?;
        let allowance = *bytes.choose(&[0, 0, height / 10, height - 1])?;
        let step = bytes.int_in_range(height / 12 + 1..=height + 100)?;
        let mut legs = Vec::new();
        for _ in 0..bytes.int_in_range(1..=4)? {
            legs.push((bytes.int_in_range(1_000..=9_000)?, *bytes.choose(&[0, 500, -300])?));
        }
        Ok(Self {
            outside: bytes.arbitrary()?,
            legs,
            heights: Heights { step, height, allowance },
            pattern: *bytes.choose(&[Pattern::Halving, Pattern::Steps, Pattern::Areas])?,
            angle: *bytes.choose(&[0, 60])?,
        })
    }
}

impl Thread {
    /// The ends of the contour: Z, and how far above its start on X.
    fn ends(&self) -> Vec<(i64, i64)> {
        let mut at = (0, 0);
        let mut ends = vec![at];
        for (along, rise) in &self.legs {
            at = (at.0 - along, at.1 + rise);
            ends.push(at);
        }
        ends
    }

    fn side(&self) -> i64 {
        if self.outside { 1 } else { -1 }
    }

    fn case(&self) -> Case {
        let number = |amount: i64| format!("{}", amount as f64 / 1_000.0);
        let point =
            |(z, rise): (i64, i64)| format!("X{} Z{}", number(100_000 + self.side() * rise), number(z));
        let Heights { step, height, allowance } = self.heights;
        let mut text = format!(
            "G00 {}\nG88 NAT1 D{} H{} U{} B{} M32 M{}\nM02\nNAT1 G81\n",
            point((START, START)),
            number(step),
            number(height),
            number(allowance),
            self.angle,
            self.pattern.code(),
        );
        for (place, end) in self.ends().into_iter().enumerate() {
            let code = if place == 0 { "G00" } else { "G34" };
            text += &format!("{code} {}{}\n", point(end), if place == 0 { "" } else { " F2" });
        }
        Case { setup: Setup::default(), program: format!("{text}G80\n").into_bytes() }
    }

    /// The statements, of the call and of one with one increment more in D.
    pub(crate) fn holds(&self) -> Verdict {
        let mut more = self.clone();
        more.heights.step += 1;
        for call in [self, &more] {
            let case = call.case();
            call.judge(&trace(&case)).map_err(|message| format!("{message}\n{}", show(&case)))?;
        }
        Ok(())
    }

    fn judge(&self, events: &[Event]) -> Verdict {
        let passes: Vec<_> =
            events.iter().filter_map(motion).filter(|motion| motion.part.is_some()).collect();
        let count = passes.last().and_then(|motion| motion.pass).map_or(0, i64::from);
        // With U the last depth of M73 that is refused is less than D already by the words (E100L-LAPC-07).
        let wanted = self.heights.passes(self.pattern, false, &Setup::default()).unwrap_or(0);
        require(count == wanted, || format!("{count} passes, not {wanted}"))?;
        let (ends, mut before) = (self.ends(), i64::MAX);
        for pass in 1..=wanted {
            let own: Vec<_> =
                passes.iter().filter(|motion| motion.pass.map(i64::from) == Some(pass)).collect();
            let cut = |part: Option<Part>| matches!(part, Some(Part::Approach | Part::Cut));
            let along = own.iter().filter(|motion| cut(motion.part));
            let moves: Vec<(i64, i64)> = along
                .zip(&ends)
                .map(|(motion, (z, rise))| {
                    let above = self.side() * (motion.program.x.0 - 100_000 * MICRO) - rise * MICRO;
                    (above, motion.program.z.0 - z * MICRO)
                })
                .collect();
            let first = moves.first().copied().unwrap_or_default();
            let whole = moves.len() == ends.len() && moves.iter().all(|one| *one == first);
            require(whole, || format!("pass {pass} is moved by {moves:?}"))?;
            let (above, along) = first;
            require((0..before).contains(&above), || format!("pass {pass} is {above} nm above the thread"))?;
            require(self.angle > 0 || along == 0, || format!("pass {pass} is moved along Z by {along}"))?;
            let back = own.last().map(|motion| (motion.program.x.0, motion.program.z.0));
            let start = ((100_000 + self.side() * START) * MICRO, START * MICRO);
            require(back == Some(start), || format!("pass {pass} ends in {back:?}"))?;
            before = above;
        }
        require(wanted == 0 || before == 0, || format!("the last pass is {before} nm above the thread"))
    }
}

#[cfg(test)]
mod tests {
    use arbitrary::{Arbitrary, Unstructured};
    use turnspec_oracle::vocabulary::{Action, Event, Motion, Part};

    use super::Thread;
    use crate::bytes_of_seed;
    use crate::shape::trace;
    use crate::thread_counts::{Heights, Pattern};

    /// What is wrong with a thread after a change of its motions of a part.
    fn verdict(part: Part, change: impl Fn(&mut Motion)) -> Result<(), String> {
        let thread = Thread {
            outside: true,
            legs: vec![(9_000, 0), (5_000, 500)],
            heights: Heights { step: 1_000, height: 3_000, allowance: 0 },
            pattern: Pattern::Steps,
            angle: 0,
        };
        let mut events: Vec<Event> = trace(&thread.case());
        for event in &mut events {
            if let Action::Rapid { motion } | Action::Thread { motion, .. } = &mut event.action
                && motion.part == Some(part)
            {
                change(motion);
            }
        }
        thread.judge(&events)
    }

    #[test]
    fn threads_that_are_wrong_are_noticed() {
        assert_eq!(verdict(Part::Cut, |_| ()), Ok(()));
        let wrong = |part, change: &dyn Fn(&mut Motion)| verdict(part, change).expect_err("it is noticed");
        assert!(wrong(Part::Cut, &|motion| motion.program.z.0 += 1).contains("is moved by"));
        assert!(wrong(Part::Approach, &|motion| motion.program.x.0 -= 1).contains("is moved by"));
        assert!(wrong(Part::Return, &|motion| motion.program.z.0 += 1).contains("ends in"));
        assert!(wrong(Part::Return, &|motion| motion.pass = Some(2)).contains("passes, not"));
    }

    #[test]
    fn most_threads_are_cut() {
        let threads = (0..200).filter_map(|seed| {
            let bytes = bytes_of_seed(seed, 64);
            Thread::arbitrary(&mut Unstructured::new(&bytes)).ok()
        });
        let threads: Vec<Thread> = threads.collect();
        threads.iter().for_each(|thread| assert_eq!(thread.holds(), Ok(())));
        let cut = |thread: &&Thread| trace(&thread.case()).len() > 3;
        assert!(threads.iter().filter(cut).count() * 2 > threads.len());
    }
}

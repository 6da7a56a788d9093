//! Where the two sides of a program wait for each other, and what lets them go on (execution of two saddles, "The order of
//! the sides").

use crate::choices::Choices;
use crate::program::Item;

/// A block at which a side waits.
#[derive(Clone, Default, Debug)]
pub(super) struct Stop {
    /// The number of its P word.
    pub p: Option<i64>,
    /// Whether it has M100.
    pub m100: bool,
    /// Common words that the block has.
    pub common: Vec<Item>,
    /// Whether it is the block of M02 or M30.
    pub at_end: bool,
    /// Whether the side is alone when it comes here.
    pub passed: bool,
    /// Whether it is alone behind the block.
    pub frees: bool,
    /// What lets the side go on from the P.
    pub release: Option<Release>,
}

/// What lets a side go on from a P.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Release {
    /// The other side waits at a greater number, or at an M100 that is passed.
    Smaller,
    /// The other side waits at this stop with the same number.
    Equal(usize),
    /// The other side has ended.
    Ended,
}

/// One side.
#[derive(Clone, Default, Debug)]
pub(super) struct SidePlan {
    pub stops: Vec<Stop>,
    /// Whether it has M02 or M30.
    pub ends: bool,
    /// Whether it has no block that counts.
    pub absent: bool,
}

/// Both sides.
#[derive(Clone, Default, Debug)]
pub(super) struct Plan {
    pub sides: [SidePlan; 2],
}

/// Where a side stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Standing {
    P(usize),
    M100(usize),
    Ended,
}

impl Plan {
    /// A plan in which both sides meet now and then.
    pub(super) fn draw(choices: &mut Choices<'_, '_>) -> Self {
        let mut plan = Self::default();
        let meetings = choices.below(4);
        let mut ranks: [i64; 2] = [0; 2];
        for meeting in 0..=meetings {
            for (side, rank) in plan.sides.iter_mut().zip(&mut ranks) {
                for _ in 0..choices.late(3).min(choices.late(3)) {
                    side.stops.push(lone_stop(choices, rank));
                }
            }
            if meeting < meetings {
                let m100 = choices.chance(32);
                let rank = ranks[0].max(ranks[1]) + choices.pick(&[10, 10, 1, 90]);
                let both = choices.chance(90);
                ranks = [rank; 2];
                for side in plan.sides.iter_mut().skip(usize::from(!both)) {
                    let p = (!m100 || choices.chance(10)).then_some(rank);
                    side.stops.push(Stop { p, m100: m100 || choices.chance(6), ..Stop::default() });
                }
            }
        }
        for side in &mut plan.sides {
            side.absent = choices.chance(5);
            side.ends = choices.chance(70);
            let together = side.ends && choices.chance(15);
            if let Some(last) = side.stops.last_mut() {
                last.at_end = together;
            }
            if side.absent {
                (side.stops, side.ends) = (Vec::new(), false);
            }
        }
        plan.end_somewhere(choices);
        plan.run();
        plan
    }

    /// One of the sides has M02 or M30.
    fn end_somewhere(&mut self, choices: &mut Choices<'_, '_>) {
        let present: Vec<usize> = (0..2).filter(|side| !self.sides[*side].absent).collect();
        if self.sides.iter().all(|side| !side.ends) && !present.is_empty() {
            let side = choices.pick(&present);
            self.sides[side].ends = true;
        }
    }

    /// Foresees how the sides let each other go on.
    pub(super) fn run(&mut self) {
        let mut alone = [self.sides[1].absent, self.sides[0].absent];
        let mut places = [(0, false); 2];
        loop {
            let [a, b] = [0, 1].map(|side| self.stand(side, &mut places[side], alone[side]));
            match (a, b) {
                (Standing::Ended, Standing::Ended) => return,
                (Standing::Ended, _) => self.set_free(1, b, &mut alone),
                (_, Standing::Ended) => self.set_free(0, a, &mut alone),
                (Standing::P(here), Standing::P(there)) => {
                    let rank = |side: usize, stop: usize| self.sides[side].stops[stop].p;
                    match rank(0, here).cmp(&rank(1, there)) {
                        std::cmp::Ordering::Less => self.release(0, here, Release::Smaller),
                        std::cmp::Ordering::Greater => self.release(1, there, Release::Smaller),
                        std::cmp::Ordering::Equal => {
                            self.release(0, here, Release::Equal(there));
                            self.release(1, there, Release::Equal(here));
                        }
                    }
                    let gone = |side: usize, stop: usize| self.sides[side].stops[stop].release.is_some();
                    places[0].1 = gone(0, here);
                    places[1].1 = gone(1, there);
                    continue;
                }
                _ => {}
            }
            for (side, standing, other) in [(0, a, b), (1, b, a)] {
                match (standing, other) {
                    (Standing::M100(stop), _) => places[side] = (stop + 1, false),
                    (Standing::P(_), Standing::Ended) => places[side].1 = true,
                    _ => {}
                }
            }
        }
    }

    /// Where a side comes to a stop from a place: a stop, and whether its P lies behind it.
    fn stand(&mut self, side: usize, place: &mut (usize, bool), alone: bool) -> Standing {
        while let Some(stop) = self.sides[side].stops.get_mut(place.0) {
            if alone {
                stop.passed |= !place.1;
            } else if stop.p.is_some() && !place.1 {
                return Standing::P(place.0);
            } else if stop.m100 {
                return Standing::M100(place.0);
            }
            *place = (place.0 + 1, false);
        }
        Standing::Ended
    }

    fn release(&mut self, side: usize, stop: usize, release: Release) {
        self.sides[side].stops[stop].release = Some(release);
    }

    /// The end of the other side lets a side go on: it is alone from then on.
    fn set_free(&mut self, side: usize, standing: Standing, alone: &mut [bool; 2]) {
        if let Standing::P(stop) | Standing::M100(stop) = standing {
            alone[side] = true;
            self.sides[side].stops[stop].frees = true;
            if matches!(standing, Standing::P(_)) {
                self.release(side, stop, Release::Ended);
            }
        }
    }
}

/// A stop of one side, with a number that mostly ascends.
fn lone_stop(choices: &mut Choices<'_, '_>, rank: &mut i64) -> Stop {
    let m100 = choices.chance(35);
    let p = (!m100 || choices.chance(10)).then(|| match choices.below(12) {
        0 => choices.within(0, *rank),
        1 => choices.pick(&[0, 9_999, 200, 5]),
        _ => {
            *rank += choices.pick(&[10, 5, 1, 20]);
            *rank
        }
    });
    Stop { p: p.map(|p| p.min(9_999)), m100, ..Stop::default() }
}

#[cfg(test)]
mod tests {
    use super::{Plan, Release, Stop};

    fn stops(list: &[(i64, bool)]) -> Vec<Stop> {
        let stop =
            |(p, m100): &(i64, bool)| Stop { p: (*p >= 0).then_some(*p), m100: *m100, ..Stop::default() };
        list.iter().map(stop).collect()
    }

    fn plan(a: &[(i64, bool)], b: &[(i64, bool)]) -> Plan {
        let mut plan = Plan::default();
        plan.sides[0].stops = stops(a);
        plan.sides[1].stops = stops(b);
        plan.run();
        plan
    }

    fn releases(plan: &Plan, side: usize) -> Vec<Option<Release>> {
        plan.sides[side].stops.iter().map(|stop| stop.release).collect()
    }

    #[test]
    fn the_smaller_number_goes_first_and_equal_ones_together() {
        // The example of E100L-PSYNC-03.
        let plan = plan(&[(10, false), (30, false)], &[(10, false), (20, false)]);
        assert_eq!(releases(&plan, 0), [Some(Release::Equal(0)), Some(Release::Ended)]);
        assert_eq!(releases(&plan, 1), [Some(Release::Equal(0)), Some(Release::Smaller)]);
        assert!(plan.sides[0].stops[1].frees && !plan.sides[1].stops[1].frees);
    }

    #[test]
    fn m100_meets_m100_and_is_passed_beside_a_number() {
        let plan = plan(&[(-1, true), (10, false), (-1, true)], &[(5, true), (20, false)]);
        // The first M100 of A is passed beside P5, that of P5 beside P10, then 10 before 20, and M100 beside P20.
        assert_eq!(releases(&plan, 0), [None, Some(Release::Smaller), None]);
        assert_eq!(releases(&plan, 1), [Some(Release::Smaller), Some(Release::Ended)]);
    }

    #[test]
    fn an_absent_side_lets_everything_pass() {
        let mut plan = Plan::default();
        plan.sides[0].stops = stops(&[(10, false), (-1, true)]);
        plan.sides[1].absent = true;
        plan.run();
        assert!(plan.sides[0].stops.iter().all(|stop| stop.passed && stop.release.is_none()));
    }
}

//! How many passes a rough cycle has: counted on the heights at which its contour turns, and bounded.

use crate::lap_job::{Job, Mode};
use crate::lap_shape::{Way, turns};

/// A quotient of positive numbers rounded up, at least zero.
fn up(numerator: i64, denominator: i64) -> i64 {
    (numerator.max(0) + denominator - 1) / denominator
}

/// The heights at which the rough contour turns, walked from level to level.
struct Walk<'a> {
    job: &'a Job,
    heights: Vec<i64>,
}

impl Walk<'_> {
    /// Passes in the recesses that a pass meets: from a place in the heights, with its level and the one above, which ends it
    /// unless there is none (E100L-AP1-10, E100L-AP1-11).
    fn recesses(&self, from: usize, level: i64, above: Option<i64>) -> i64 {
        let mut passes = 0;
        for (place, pair) in self.heights.windows(2).enumerate().skip(from) {
            let [before, behind] = pair else { continue };
            if *behind > *before && above.is_some_and(|above| *behind >= above) {
                break;
            }
            // A recess begins within the level of the pass that has met it.
            let top = if place == from { above.map_or(*before, |above| above.min(*before)) } else { *before };
            if top >= level && *behind < level {
                let deeper = level - self.job.depth_below(level);
                passes += 1 + self.recesses(place, deeper, Some(level));
            }
        }
        passes
    }

    /// All passes from the level above the first one down.
    fn passes(&self, top: i64, first_ends: bool) -> i64 {
        let start = self.heights.first().copied().unwrap_or(0);
        let (mut above, mut passes) = (top, 0);
        loop {
            let level = above - self.job.depth_below(above);
            let last = level <= start;
            let rises = |pair: &[i64]| pair[0] < level && level <= pair[1];
            let met = if last { Some(0) } else { self.heights.windows(2).position(rises) };
            let ends = (passes > 0 || first_ends).then_some(above);
            passes += 1;
            passes += met.map_or(0, |met| self.recesses_behind(met, level, ends, last));
            if last {
                return passes;
            }
            above = level;
        }
    }

    /// The recesses of a pass that comes to the contour on a rise, or in its start.
    fn recesses_behind(&self, met: usize, level: i64, ends: Option<i64>, last: bool) -> i64 {
        let reaches = |above: i64| self.heights.get(met + 1).is_some_and(|height| *height >= above);
        let rises = self.heights.get(met + 1) > self.heights.get(met);
        match ends {
            Some(above) if rises && reaches(above) => 0,
            _ if rises || !last => self.recesses(met + 1, level, ends),
            _ => self.recesses(met, level, ends),
        }
    }
}

/// The number of passes, as the levels and the heights at which the contour turns give it.
pub(crate) fn passes(job: &Job) -> i64 {
    let shift = job.shift();
    let walk = Walk { job, heights: turns(shift, &job.contour) };
    match job.mode {
        Mode::Bar => walk.passes(job.start.height, true),
        Mode::HighSpeed => walk.passes(job.highest(), false),
        Mode::Copy => up(job.start.height - shift.height, job.step),
        Mode::BarCopy => {
            let first = job.blank().first().map_or(0, |element| element.way.height.max(0));
            up(first - shift.height, job.step).max(1)
        }
    }
}

/// What the number of passes and of motions of a pass cannot exceed (how LAP runs, 13).
pub(crate) fn bounds(job: &Job) -> (i64, i64) {
    let heights = turns(job.shift(), &job.contour);
    let lowest = heights.iter().min().copied().unwrap_or(0);
    let (elements, blank) = (job.contour.len() as i64, job.blank().len() as i64);
    let levels = |top: i64| 11 * (up(top - lowest, job.depths().0) + 1);
    match job.mode {
        Mode::Bar => (levels(job.start.height), elements + 50),
        Mode::HighSpeed => (levels(job.highest()), elements + 50 + 24 * (blank + 1)),
        Mode::Copy => (up(job.start.height - job.shift().height, job.step), elements + 3),
        Mode::BarCopy => {
            let top = turns(Way::default(), &job.blank()).into_iter().max().unwrap_or(0);
            let layers = up(top - lowest, job.step).max(1);
            let cuts = layers * (1 + 4 * elements * blank);
            (layers, elements + cuts * (blank + 6) + 8)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Walk, passes};
    use crate::lap_job::{Change, Job, Mode};
    use crate::lap_shape::{Element, Way};
    use crate::lap_tests::shaft;

    /// The examples of E100L-AP1-02 and E100L-LAPC-03, in micrometres of diameter.
    #[test]
    fn the_numbers_of_passes_are_those_of_the_examples() {
        let shaft = |step: i64, below: &[(i64, i64)]| Job {
            step,
            changes: below.iter().map(|(below, step)| Change { below: *below, step: *step }).collect(),
            ..shaft(Mode::Bar)
        };
        assert_eq!(passes(&shaft(7_000, &[])), 3);
        assert_eq!(passes(&shaft(8_000, &[])), 2);
        assert_eq!(passes(&shaft(7_999, &[])), 3);
        assert_eq!(passes(&shaft(4_000, &[(7_000, 6_000)])), 4);
        assert_eq!(passes(&shaft(8_000, &[(8_000, 4_000), (11_000, 2_000)])), 4);
        assert_eq!(passes(&Job { allowance: Way { run: 0, height: 400 }, ..shaft(8_000, &[]) }), 2);
    }

    /// The grooves of E100L-AP1-06 and E100L-AP1-11.
    #[test]
    fn recesses_are_counted_each() {
        let job = Job { step: 8_000, ..shaft(Mode::Bar) };
        let passes = |heights: &[i64]| Walk { job: &job, heights: heights.to_vec() }.passes(20_000, true);
        assert_eq!(passes(&[0, 14_000, 4_000, 20_000]), 4);
        assert_eq!(passes(&[0, 16_000, 4_000, 16_000, 4_000, 20_000]), 5);
        assert_eq!(passes(&[0, 14_000, 3_999, 20_000]), 5);
        assert_eq!(passes(&[0, 12_000, 4_000, 20_000]), 4);
        assert_eq!(passes(&[0, 11_999, 4_000, 20_000]), 3);
        assert_eq!(passes(&[0, 2_000]), 3);
    }

    #[test]
    fn passes_along_the_blank_stop_above_the_contour() {
        let job = |height: i64| Job {
            step: 4_000,
            blank: (Way { run: 0, height }, vec![Element::line(40_000, 0)]),
            ..shaft(Mode::BarCopy)
        };
        assert_eq!([8_000, 8_001, 4_000, 2].map(|height| passes(&job(height))), [2, 3, 1, 1]);
    }
}

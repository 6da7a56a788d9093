//! How calls of G85 and G86 are composed from bytes, and the same with one increment more or less.

use arbitrary::{Arbitrary, Result, Unstructured};

use crate::lap_job::{Change, Job, Mode, Place};
use crate::lap_shape::{Element, Way, elements, end, turns, turns_back};

impl<'a> Arbitrary<'a> for Job {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let mode = *bytes.choose(&[Mode::Bar, Mode::Bar, Mode::Copy, Mode::HighSpeed, Mode::BarCopy])?;
        let base = |bytes: &mut Unstructured<'_>| bytes.choose(&[0, 100_000, -100_000, 333_334]).copied();
        let place = Place {
            across: bytes.arbitrary()?,
            base: Way { run: base(bytes)?, height: base(bytes)? },
            up: *bytes.choose(&[1, -1])?,
            forward: *bytes.choose(&[-1, 1])?,
        };
        let rises = bytes.ratio(1, 3)?;
        let contour = elements(bytes, 9, 0, rises)?;
        let heights = turns(Way::default(), &contour);
        let (top, bottom) =
            (heights.iter().max().copied().unwrap_or(0), heights.iter().min().copied().unwrap_or(0));
        let over = |bytes: &mut Unstructured<'_>| bytes.choose(&[0, 400, 2_000, 12_000]).copied();
        let allowed = [0, 0, 2, 400, 1_200];
        let allowance = Way { run: *bytes.choose(&allowed)?, height: *bytes.choose(&allowed)? };
        let height = match bytes.int_in_range(0..=2)? {
            0 => *bytes.choose(&heights)?,
            _ => top + over(bytes)?,
        };
        let start = Way {
            run: -*bytes.choose(&[0, 1_200, 4_000, 4_000, 30_000])?,
            height: height.max(allowance.height + *bytes.choose(&[2, 1_000])?),
        };
        let first = Way { run: *bytes.choose(&[0, 0, 500])?, height: top.max(2) + over(bytes)? };
        let mut blank = elements(bytes, 4, i64::from(first.run == 0), false)?;
        let short = end(first, &blank).run <= end(Way::default(), &contour).run;
        if short && bytes.arbitrary()? {
            blank.push(Element::line(end(Way::default(), &contour).run, 0));
        }
        let depth = start.height.max(first.height + top) - bottom;
        let step = match bytes.int_in_range(0..=3)? {
            0 => (start.height - bytes.choose(&heights)?).abs() / bytes.int_in_range(1..=4)?,
            1 => depth / bytes.int_in_range(1..=6)?,
            _ => bytes.int_in_range(1..=depth / 3 + 1)?,
        };
        let least = depth / 20 + 4;
        let mut changes = Vec::new();
        if matches!(mode, Mode::Bar | Mode::HighSpeed) && bytes.ratio(1, 3)? {
            let mut below = 0;
            for _ in 0..bytes.int_in_range(1..=2)? {
                below += bytes.int_in_range(1..=depth)? / 4 * 4 + 4;
                changes.push(Change { below, step: bytes.int_in_range(least..=least + depth)? / 4 * 4 });
            }
        }
        Ok(Self {
            mode,
            place,
            contour,
            blank: (first, blank),
            start,
            step: step.max(least) / 4 * 4,
            changes,
            allowance,
            at_feed: bytes.ratio(1, 3)?,
            stays: bytes.ratio(1, 6)?,
            relief: *bytes.choose(&[100, 100, 0, 1, 9_999])?,
            clearance: *bytes.choose(&[2_000, 2_000, 600, 0, 9_999])?,
        })
    }
}

impl Job {
    /// The call, and the same with one increment more or less in one coordinate of the contour, in the AP start, in D and in
    /// an allowance.
    pub(crate) fn nudged(&self, bytes: &mut Unstructured<'_>) -> Result<Vec<Self>> {
        let (by, mut jobs) = (self.increment(), vec![self.clone()]);
        let mut nudge = |change: &dyn Fn(&mut Self)| {
            let mut job = self.clone();
            change(&mut job);
            jobs.push(job);
        };
        let more = if bytes.arbitrary()? { 1 } else { -1 };
        nudge(&|job| job.step = (job.step + more * by.height).max(by.height));
        nudge(&|job| job.start.height += by.height);
        let place = bytes.choose_index(self.contour.len())?;
        let lines = |job: &Self| job.contour.get(place).is_some_and(|element| element.arc.is_none());
        if lines(self) {
            nudge(&|job| job.contour[place].way.run += by.run);
            nudge(&|job| job.contour[place].way.height += more * by.height);
            let whole = |job: &Self| job.contour.iter().all(|element| element.way != Way::default());
            jobs.retain(|job| whole(job) && !turns_back(&job.contour));
        }
        Ok(jobs)
    }
}

//! The motions of a rough cycle in its plane, and which of them leave the contour whole.

use turnspec_oracle::vocabulary::{Action, Event, Part, Sense};

use crate::lap_job::{Job, Mode};
use crate::lap_plane::{Bow, LATCHED, Leg, Spot, heights};
use crate::shape::motion;
use crate::{Verdict, require};

/// A motion of a rough cycle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stroke {
    pub(crate) part: Part,
    pub(crate) pass: u32,
    pub(crate) leg: Leg,
}

impl Stroke {
    /// Whether it takes what is above it: at a feed, or where there is no stock.
    pub(crate) fn takes(&self) -> bool {
        matches!(self.part, Part::Cut | Part::Contour | Part::Air)
    }
}

/// The motions of the cycle of a trace.
pub(crate) fn strokes(job: &Job, events: &[Event]) -> Vec<Stroke> {
    let mut from = Spot { run: 0.0, height: 0.0 };
    let mut strokes = Vec::new();
    for event in events {
        let Some(motion) = motion(event) else { continue };
        let to = job.spot(motion.program.x.0, motion.program.z.0);
        let bow = match event.action {
            Action::Arc { sense, centre_x, centre_z, .. } => {
                let over = (sense == Sense::Clockwise) == job.keeps_sense();
                Some(Bow { centre: job.spot(centre_x.0, centre_z.0), over })
            }
            _ => None,
        };
        if let Some(part) = motion.part {
            let pass = motion.pass.unwrap_or_default();
            strokes.push(Stroke { part, pass, leg: Leg { from, to, bow } });
        }
        from = to;
    }
    strokes
}

/// Statement 1.
pub(crate) fn spare_the_contour(job: &Job, strokes: &[Stroke]) -> Verdict {
    let rough = job.rough();
    let end = rough.last().map_or(0.0, |leg| leg.to.run);
    for stroke in strokes {
        if stroke.part == Part::Relief {
            relief(job, stroke)?;
        }
        let beyond = stroke.takes() && stroke.leg.to.run > end + LATCHED;
        let copied_forward = job.mode == Mode::Copy && job.start.run > job.shift().run;
        require(copied_forward || !beyond, || format!("behind the end of the contour: {stroke:?}"))?;
    }
    if enters(job, &rough) {
        return Ok(());
    }
    let mut led_in = false;
    for (number, stroke) in strokes.iter().enumerate() {
        let below = lowest(&rough, stroke.leg);
        if stroke.part == Part::Relief {
            led_in |= below.is_some();
        }
        let excused = led_in || starts_low(job, stroke, number);
        require(excused || below.is_none(), || format!("{below:?} is below the contour: {stroke:?}"))?;
        let back = matches!(stroke.part, Part::Return | Part::Infeed | Part::Home);
        led_in &= !back || is_below(&rough, stroke.leg.to);
    }
    Ok(())
}

/// Whether the texts let the passes of a call enter its contour.
fn enters(job: &Job, rough: &[Leg]) -> bool {
    match job.mode {
        Mode::Copy if falls(rough) => true,
        _ => job.start.run > job.shift().run,
    }
}

fn is_below(rough: &[Leg], spot: Spot) -> bool {
    heights(rough, spot.run).is_some_and(|(lowest, _)| spot.height < lowest - LATCHED)
}

/// A point of a leg that is below the contour.
fn lowest(rough: &[Leg], leg: Leg) -> Option<Spot> {
    leg.points().chain(over_ends(rough, leg)).find(|spot| is_below(rough, *spot))
}

/// Whether a contour falls anywhere.
fn falls(rough: &[Leg]) -> bool {
    rough.iter().any(|leg| {
        let points: Vec<Spot> = leg.points().collect();
        points.windows(2).any(|pair| pair[1].height < pair[0].height)
    })
}

/// Whether a motion goes to or from an AP start that may lie below the contour: straight, and nobody looks.
fn starts_low(job: &Job, stroke: &Stroke, number: usize) -> bool {
    let low = job.has_blank() && job.start.height < job.highest();
    low && (stroke.part == Part::Home || (job.mode == Mode::HighSpeed && number == 0))
}

/// The points of a leg at the runs at which the legs of a contour end, or are highest or lowest, and close beside them.
fn over_ends(rough: &[Leg], leg: Leg) -> impl Iterator<Item = Spot> {
    let (first, last) = leg.runs();
    let ends = rough.iter().flat_map(|leg| [Some(leg.to.run), leg.bow.map(|bow| bow.centre.run)]).flatten();
    let runs = ends.flat_map(|run| [-2.5, 0.0, 2.5].map(|beside| run + beside * LATCHED));
    let within: Vec<f64> = runs.filter(|run| first < *run && *run < last).collect();
    within.into_iter().map(move |run| leg.point(run))
}

/// A relief goes off by r, or by 2r on X, and back by r.
fn relief(job: &Job, stroke: &Stroke) -> Verdict {
    let (by, amount) = (job.increment(), i64::from(job.relief));
    let way = stroke.leg.to.less(stroke.leg.from);
    let is = |length: f64, amount: i64| (length - Job::nanometres(amount)).abs() < 1.0;
    // An amount on X is a diameter; twice that on X is r as a radius.
    let (up, back) = (amount * by.height, amount * by.run);
    let more = |amount: i64, on_x: bool| if on_x { 2 * amount } else { amount };
    let (up_more, back_more) = (more(up, !job.place.across), more(back, job.place.across));
    let plain = is(way.height, up) && is(-way.run, back);
    let more = is(way.height, up_more) && is(-way.run, back_more);
    require(plain || more, || format!("a relief by {way:?}: {stroke:?}"))
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::Part;

    use super::{Stroke, spare_the_contour, strokes};
    use crate::lap_job::{Job, Mode};
    use crate::lap_plane::Spot;
    use crate::lap_tests::grooved;
    use crate::shape::trace;

    /// What is wrong with the motions of a cycle when all of a part are moved, each where it ends.
    fn moved(job: &Job, part: Part, way: Spot) -> Result<(), String> {
        let change = |mut stroke: Stroke| {
            if stroke.part == part {
                stroke.leg.to = stroke.leg.to.plus(way);
            }
            stroke
        };
        let strokes: Vec<Stroke> = strokes(job, &trace(&job.case())).into_iter().map(change).collect();
        spare_the_contour(job, &strokes)
    }

    #[test]
    fn motions_that_enter_the_contour_are_noticed() {
        for mode in [Mode::Bar, Mode::HighSpeed, Mode::BarCopy] {
            let job = grooved(mode);
            let down = Spot { run: 0.0, height: -5.0 };
            assert_eq!(moved(&job, Part::Cut, Spot { run: 0.0, height: 0.0 }), Ok(()), "{mode:?}");
            for part in [Part::Contour, Part::Relief] {
                assert!(moved(&job, part, down).is_err(), "{mode:?} {part:?}");
            }
            let forward = Spot { run: 5.0, height: 0.0 };
            assert!(moved(&job, Part::Cut, forward).is_err(), "{mode:?}");
            // So deep that it goes through the collar; over a level blank nothing is cleared in mode V.
            let deep = Spot { run: 0.0, height: -9e6 };
            assert!(moved(&job, Part::Return, deep).is_err(), "{mode:?}");
            assert!(mode == Mode::BarCopy || moved(&job, Part::Clear, deep).is_err(), "{mode:?}");
        }
    }

    #[test]
    fn motions_behind_the_end_are_noticed() {
        let behind = moved(&grooved(Mode::Bar), Part::Contour, Spot { run: 5e6, height: 0.0 });
        assert!(behind.is_err_and(|message| message.contains("behind the end")));
    }
}

//! What the passes of a rough cycle take: all that the contour leaves, in layers, and no less in thinner ones.

use turnspec_oracle::vocabulary::Part;

use crate::lap_job::{Job, Mode};
use crate::lap_plane::{LATCHED, Leg, Spot, heights, runs_between};
use crate::lap_shape::{HALF, Way, legs};
use crate::lap_strokes::Stroke;
use crate::{Verdict, require};

/// The blank, in mode V with its first element moved up (E100L-AP5-01).
fn blank(job: &Job) -> Vec<Leg> {
    let mut elements = job.blank();
    let mut from = Way::default();
    if let Some(first) =
        elements.first_mut().filter(|first| job.mode == Mode::BarCopy && first.way.height > 0)
    {
        (from.height, first.way.height) = (first.way.height, 0);
    }
    legs(from, &elements)
}

/// The run at which a contour first comes within the tolerance of the height of the AP start, where there is an end of
/// mode I (E100L-AP1-02); else its end.
fn end(job: &Job, rough: &[Leg]) -> f64 {
    let last = rough.last().map_or(0.0, |leg| leg.to.run);
    let level = job.start.spot().height - LATCHED;
    if job.mode != Mode::Bar {
        return last;
    }
    let reaches = rough.iter().find(|leg| leg.top() >= level);
    let end = reaches.and_then(|leg| {
        let high = |part: &i32| leg.point(at(leg, *part)).height.max(edge(leg, *part)) >= level;
        (0..=512).find(high).map(|part| at(leg, (part - 1).max(0)))
    });
    end.or(reaches.map(|leg| leg.from.run)).unwrap_or(last)
}

fn at(leg: &Leg, part: i32) -> f64 {
    leg.from.run + f64::from(part) / 512.0 * (leg.to.run - leg.from.run)
}

/// The height of an end of a leg that is its first or last part.
fn edge(leg: &Leg, part: i32) -> f64 {
    match part {
        0 => leg.from.height,
        512 => leg.to.height,
        _ => f64::MIN,
    }
}

/// Statement 2.
pub(crate) fn leave_nothing(job: &Job, strokes: &[Stroke]) -> Verdict {
    let rough = job.rough();
    let end = end(job, &rough);
    along_the_contour(job, &rough, end, strokes)?;
    if job.mode == Mode::Copy {
        return copies(job, &rough, strokes);
    }
    let (top, own) = (job.start.spot().height, blank(job));
    let highest = Job::nanometres(job.highest());
    // Where the contour begins in front of the AP start, levels begin on the line between them.
    let reached = |run: &f64| job.start.spot().run < *run && *run < end;
    for run in runs_between(&[&rough, &own]).into_iter().filter(reached) {
        let Some((floor, ceiling)) = heights(&rough, run) else { continue };
        let (stock, slack) = match heights(&own, run).filter(|_| job.has_blank()) {
            Some((low, high)) => (Some(high), high - low + slack(&rough, run)),
            None => ((!job.has_blank()).then_some(top), slack(&rough, run)),
        };
        let Some(stock) = stock.filter(|stock| *stock > ceiling + LATCHED) else { continue };
        let mut above = if job.mode == Mode::HighSpeed { highest } else { stock };
        for height in levels(strokes, run).into_iter().filter(|height| *height < stock - LATCHED) {
            let depth = above.min(stock) - height;
            let deepest = if job.mode == Mode::Bar {
                job.depth_below((above / HALF).round() as i64)
            } else {
                job.depths().1
            };
            let deepest = Job::nanometres(deepest);
            require(depth <= deepest + slack, || {
                format!("a layer of {depth} nm, not {deepest}, above {height} at the run {run}")
            })?;
            above = height;
        }
        require(above <= floor + slack, || format!("cut to {above}, not to {floor}, at the run {run}"))?;
    }
    Ok(())
}

/// How much the height of a contour changes within the tolerance of a run.
fn slack(rough: &[Leg], run: f64) -> f64 {
    heights(rough, run).map_or(0.0, |(low, high)| high - low) + 2.0 * LATCHED
}

/// The heights at which motions take what is above them at a run, from above.
fn levels(strokes: &[Stroke], run: f64) -> Vec<f64> {
    let taking = strokes.iter().filter(|stroke| stroke.takes());
    let over = taking.filter(|stroke| {
        let (first, last) = stroke.leg.runs();
        first <= run && run <= last
    });
    let mut heights: Vec<f64> = over.map(|stroke| stroke.leg.point(run).height).collect();
    heights.sort_by(|one, other| other.total_cmp(one));
    heights
}

/// Every point of the rough contour is run along.
fn along_the_contour(job: &Job, rough: &[Leg], end: f64, strokes: &[Stroke]) -> Verdict {
    let along: Vec<Leg> =
        strokes.iter().filter(|stroke| stroke.part == Part::Contour).map(|stroke| stroke.leg).collect();
    let level = job.start.spot().height - LATCHED;
    for spot in rough.iter().flat_map(|leg| leg.points()) {
        let over = job.mode == Mode::Bar && (spot.run > end || spot.height >= level);
        require(over || along.iter().any(|leg| leg.holds(spot)), || {
            format!("nothing runs along the contour in {spot:?}")
        })?;
    }
    Ok(())
}

/// The passes of mode II are the rough contour, moved along the line to the AP start (E100L-AP2-01, E100L-AP2-03).
fn copies(job: &Job, rough: &[Leg], strokes: &[Stroke]) -> Verdict {
    let way = job.start.spot().less(job.shift().spot());
    let last = strokes.iter().map(|stroke| stroke.pass).max().unwrap_or_default();
    let legs: Vec<Leg> = rough.iter().copied().filter(|leg| leg.from != leg.to).collect();
    for pass in 1..=last {
        let left = 1.0 - f64::from(pass) * Job::nanometres(job.step) / way.height;
        let left = if pass == last { 0.0 } else { left };
        let way = Spot { run: way.run * left, height: way.height * left };
        let of_pass = |stroke: &&Stroke| stroke.part == Part::Contour && stroke.pass == pass;
        let own: Vec<Leg> = strokes.iter().filter(of_pass).map(|stroke| stroke.leg).collect();
        require(own.len() == legs.len(), || format!("pass {pass} has {} elements", own.len()))?;
        for (one, leg) in own.iter().zip(&legs) {
            let wanted = leg.moved(way);
            let close = |one: Spot, other| one.less(other).length() <= LATCHED;
            let centres = match (one.bow, wanted.bow) {
                (Some(one), Some(other)) => one.over == other.over && close(one.centre, other.centre),
                (one, other) => one == other,
            };
            require(close(one.from, wanted.from) && close(one.to, wanted.to) && centres, || {
                format!("pass {pass} has {one:?}, not {wanted:?}")
            })?;
        }
    }
    Ok(())
}

/// Statement 4: what passes with D take, passes with half of it take too.
pub(crate) fn take_no_less(job: &Job, strokes: &[Stroke], halved: &[Stroke]) -> Verdict {
    let (rough, end) = (job.rough(), end(job, &job.rough()));
    let own = if job.has_blank() { blank(job) } else { Vec::new() };
    let moved: Vec<Leg> = strokes.iter().filter(|stroke| stroke.takes()).map(|stroke| stroke.leg).collect();
    for run in runs_between(&[&rough, &own, &moved]).into_iter().filter(|run| *run < end) {
        // Change points are passed on other levels, and in front of a blank it is the first level that says how far
        // the tool comes.
        let in_front = run < job.shift().spot().run.max(job.start.spot().run);
        if in_front && (job.has_blank() || !job.changes.is_empty()) {
            continue;
        }
        let lowest = |strokes: &[Stroke]| levels(strokes, run).last().copied();
        let Some(taken) = lowest(strokes) else { continue };
        let reached = lowest(halved);
        let slack = slack(&rough, run);
        require(reached.is_some_and(|reached| reached <= taken + slack), || {
            format!("with half of D down to {reached:?}, not {taken}, at the run {run}")
        })?;
    }
    Ok(())
}

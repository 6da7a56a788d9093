//! Rough turning cycles: nothing of the finished part is cut, nothing above it stays, and the passes are as many as the
//! levels say.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{Action, AlarmName, Event};

use crate::differential::show;
use crate::lap_cuts::{leave_nothing, take_no_less};
use crate::lap_job::{Job, Mode};
use crate::lap_pairs::{finishes, mirrors};
use crate::lap_passes::{bounds, passes};
use crate::lap_programs::cycles_are_whole;
use crate::lap_strokes::{Stroke, spare_the_contour, strokes};
use crate::lap_threads::Thread;
use crate::shape::trace;
use crate::{Verdict, require};

/// Of calls of G85 and G86 with a contour, a blank, an AP start, depths, change points, allowances, relief and clearance that
/// are composed from the bytes, in modes I, II, IV and V, with G81 and G82, outside and inside, toward either side; and of each
/// with one increment more or less in D, in the AP start and in an element of the contour. Points are compared within 3 nm,
/// heights with what the contour rises or falls within 3 nm of run.
///
/// 1. **The contour is spared.** No motion is below the rough contour (the contour with its allowances), none at a feed goes
///    behind its end. A relief goes off by r, or by 2r on X, and back by r. The texts let some motions enter:
///    - a relief whose way back leads into a slope that the pass came down, since E100L-AP1-06 lifts only behind it, and what
///      follows up to the end of the next return, infeed or way home;
///    - in modes IV and V the straight ways from and to an AP start that is lower than the contour or its blank (E100L-AP4-04,
///      E100L-LAP-06);
///    - all, where an allowance has brought the contour before the AP start (E100L-LAP-20);
///    - in mode II every pass over a contour that falls (E100L-AP2-03, E100L-AP2-06).
/// 2. **Nothing is left.** Parts `contour` run along all of the rough contour, in mode I up to where it first reaches the
///    height of the AP start. Over every run the tool has come down in layers of at most the depth in force: from the AP start
///    in mode I, from the blank in modes IV and V. In front of the contour, before the line to the AP start, stock stays
///    (E100L-AP1-03), and behind its end (E100L-AP4-07). In mode II pass N is the rough contour, moved to its place on the line to the AP start.
/// 3. **Finishing.** G87 makes the motions of the contour, moved by U and W toward the AP start, to the nanometre.
/// 4. **Half of D.** With half of every depth the tool comes as low as before over every run; in front of the contour only
///    without change points, which are passed on other levels then, and without a blank.
/// 5. **Mirror.** The image along X, inside for outside, and along Z, makes the image of every event, to the nanometre, by the
///    same rules. (G82 is no image of G81: amounts on X are diameters.)
/// 6. **Number.** The number of passes is that which the levels and the heights give at which the contour turns; so an
///    increment changes it only where a level crosses one of these heights. Levels are one depth apart from the AP start down
///    (in mode IV from the highest point of blank and contour), and in a recess from the level that has met it. In mode II
///    it is ⌈L/D⌉, in mode V ⌈(X1 − A')/D⌉, at least 1. It is within the bounds of the text, and the passes
///    are whole: numbered from 1 without a gap. An alarm comes where the texts refuse the contour, and nowhere else.
///
/// Of calls of G88 that are composed: see [`Thread`]. Of programs of the generator: see [`cycles_are_whole`].
///
/// Rules: E100L-LAP-02, E100L-LAP-20, E100L-LAP-21, E100L-LAPC-03, E100L-LAPC-06, E100L-AP1-02, E100L-AP1-03, E100L-AP1-04,
/// E100L-AP1-05, E100L-AP1-06, E100L-AP1-08, E100L-AP1-10, E100L-AP1-11, E100L-AP1-12, E100L-AP1-13, E100L-AP1-14, E100L-AP2-01,
/// E100L-AP2-02, E100L-AP2-03, E100L-AP3-02, E100L-AP4-01, E100L-AP4-03, E100L-AP4-05, E100L-AP4-06, E100L-AP4-07, E100L-AP5-01,
/// E100L-AP5-02, E100L-AP5-03, E100L-AP5-05, E100L-AP5-06
pub(crate) fn rough_turning_is_true(input: &[u8]) -> Verdict {
    let mut bytes = Unstructured::new(input);
    if let Ok(job) = Job::arbitrary(&mut bytes) {
        holds(&job)?;
        for job in job.nudged(&mut bytes).unwrap_or_default() {
            judged(&job).map(drop)?;
        }
    }
    if let Ok(thread) = Thread::arbitrary(&mut bytes) {
        thread.holds()?;
    }
    let Ok(case) = Case::arbitrary(&mut Unstructured::new(input)) else { return Ok(()) };
    cycles_are_whole(&trace(&case)).map_err(|message| format!("{message}\n{}", show(&case)))
}

/// Statements 3 to 5.
fn holds(job: &Job) -> Verdict {
    let (events, shown) = (trace(&job.case()), |message| said(job, message));
    for (by_height, by_run) in [(true, false), (false, true)] {
        let image = job.mirrored(by_height, by_run);
        mirrors(job, &events, &trace(&image.case()), (by_height, by_run)).map_err(shown)?;
    }
    finishes(job, &trace(&job.finishing())).map_err(shown)?;
    if job.refusal().is_some() {
        return Ok(());
    }
    let mut halved = job.clone();
    halved.step /= 2;
    halved.changes.iter_mut().for_each(|change| change.step /= 2);
    if halved.refusal().is_some() {
        return Ok(());
    }
    let halved = judged(&halved)?;
    take_no_less(job, &strokes(job, &events), &halved).map_err(shown)
}

fn said(job: &Job, message: String) -> String {
    format!("{message}\n{job:?}\n{}", show(&job.case()))
}

/// Statements 1, 2 and 6.
fn judged(job: &Job) -> Result<Vec<Stroke>, String> {
    let events = trace(&job.case());
    let strokes = strokes(job, &events);
    let verdict = number(job, alarm(&events), &strokes).and_then(|()| match job.refusal() {
        None => spare_the_contour(job, &strokes).and_then(|()| leave_nothing(job, &strokes)),
        Some(_) => Ok(()),
    });
    verdict.map_err(|message| said(job, message))?;
    Ok(strokes)
}

/// The alarm of a trace.
pub(crate) fn alarm(events: &[Event]) -> Option<AlarmName> {
    events.iter().find_map(|event| match event.action {
        Action::Alarm(alarm) => Some(alarm.name),
        _ => None,
    })
}

/// Statement 6.
pub(crate) fn number(job: &Job, alarm: Option<AlarmName>, strokes: &[Stroke]) -> Verdict {
    let refusal = job.refusal();
    require(alarm == refusal, || format!("the alarm {alarm:?}, not {refusal:?}"))?;
    if refusal.is_some() {
        return require(strokes.is_empty(), || "motions of a contour that is refused".to_owned());
    }
    let (most, motions) = bounds(job);
    let mut counts: Vec<i64> = Vec::new();
    for pass in strokes.iter().map(|stroke| stroke.pass as usize).filter(|pass| *pass > 0) {
        if pass == counts.len() + 1 {
            counts.push(0);
        }
        require(pass == counts.len(), || format!("pass {pass} behind {}", counts.len()))?;
        counts.iter_mut().last().into_iter().for_each(|count| *count += 1);
    }
    let (count, wanted) = (counts.len() as i64, passes(job));
    require(count == wanted, || format!("{count} passes, not {wanted}"))?;
    require(count <= most, || format!("{count} passes, more than {most}"))?;
    let longest = counts.into_iter().max().unwrap_or_default();
    let cuts = if job.mode == Mode::BarCopy { 0 } else { longest };
    require(cuts <= motions, || format!("a pass of {longest} motions, more than {motions}"))
}

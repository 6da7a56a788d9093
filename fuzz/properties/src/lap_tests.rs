//! Calls that the tests of rough turning share, and tests that offer its statements what is wrong.

use arbitrary::{Arbitrary, Unstructured};
use turnspec_oracle::vocabulary::{Action, Event, Part};

use crate::bytes_of_seed;
use crate::lap::{alarm, number, rough_turning_is_true};
use crate::lap_cuts::{leave_nothing, take_no_less};
use crate::lap_job::{Job, Mode, Place};
use crate::lap_pairs::{finishes, mirrors};
use crate::lap_plane::Spot;
use crate::lap_shape::{Arc, Element, Way};
use crate::lap_strokes::{Stroke, strokes};
use crate::shape::trace;

/// The shaft of E100L-AP1-02: from Ø20 up to Ø36, with D8.
pub(crate) fn shaft(mode: Mode) -> Job {
    Job {
        mode,
        place: Place { across: false, base: Way { run: -4_000, height: 20_000 }, up: 1, forward: -1 },
        contour: vec![Element::line(24_000, 0), Element::line(0, 16_000)],
        blank: (Way { run: 0, height: 16_000 }, vec![Element::line(24_000, 0)]),
        start: Way { run: -4_000, height: 16_000 },
        step: 8_000,
        changes: Vec::new(),
        allowance: Way::default(),
        at_feed: false,
        stays: false,
        relief: 100,
        clearance: 2_000,
    }
}

/// A shaft with a collar, a groove behind it and an arc up from its bottom.
pub(crate) fn grooved(mode: Mode) -> Job {
    let arc = Arc { centre: Way { run: 0, height: 10_000 }, radius: 10_000, over: false };
    let contour = vec![
        Element::line(8_000, 0),
        Element::line(0, 14_000),
        Element::line(4_000, 0),
        Element::line(6_000, -10_000),
        Element::line(10_000, 0),
        Element { way: Way { run: 10_000, height: 10_000 }, arc: Some(arc) },
        Element::line(4_000, 0),
        Element::line(0, 6_000),
    ];
    let blank = (Way { run: 0, height: 20_000 }, vec![Element::line(42_000, 0)]);
    Job {
        contour,
        blank,
        start: Way { run: -8_000, height: 20_000 },
        step: 6_000,
        allowance: Way { run: 200, height: 400 },
        ..shaft(mode)
    }
}

const MODES: [Mode; 4] = [Mode::Bar, Mode::Copy, Mode::HighSpeed, Mode::BarCopy];

fn own(job: &Job) -> Vec<Stroke> {
    strokes(job, &trace(&job.case()))
}

/// The motions without those of one pass; the passes behind it have their numbers.
fn without(pass: u32, strokes: &[Stroke]) -> Vec<Stroke> {
    strokes.iter().copied().filter(|stroke| stroke.pass != pass).collect()
}

#[test]
fn good_cycles_hold() {
    for mode in MODES {
        for job in [shaft(mode), grooved(mode)] {
            let strokes = own(&job);
            assert_eq!(number(&job, None, &strokes), Ok(()), "{mode:?}");
            assert_eq!(leave_nothing(&job, &strokes), Ok(()), "{mode:?}");
        }
    }
}

#[test]
fn what_is_left_is_noticed() {
    for mode in MODES {
        let job = grooved(mode);
        let strokes = own(&job);
        let last = strokes.iter().map(|stroke| stroke.pass).max().unwrap_or_default();
        for pass in 1..=last {
            assert!(leave_nothing(&job, &without(pass, &strokes)).is_err(), "{mode:?} {pass}");
        }
        let higher = |mut stroke: Stroke| {
            if stroke.part == Part::Contour {
                stroke.leg = stroke.leg.moved(Spot { run: 0.0, height: 4.0 });
            }
            stroke
        };
        let higher: Vec<Stroke> = strokes.iter().copied().map(higher).collect();
        assert!(leave_nothing(&job, &higher).is_err(), "{mode:?}");
    }
}

#[test]
fn layers_that_are_too_thick_are_noticed() {
    for mode in [Mode::Bar, Mode::HighSpeed, Mode::BarCopy] {
        let job = grooved(mode);
        let thinner = Job { step: 4_000, ..job.clone() };
        assert!(leave_nothing(&thinner, &own(&job)).is_err_and(|message| message.contains("a layer")));
    }
}

#[test]
fn less_with_half_of_d_is_noticed() {
    for mode in MODES {
        let job = grooved(mode);
        let (strokes, halved) = (own(&job), own(&Job { step: job.step / 2, ..job.clone() }));
        assert_eq!(take_no_less(&job, &strokes, &halved), Ok(()), "{mode:?}");
        let last = halved.iter().map(|stroke| stroke.pass).max().unwrap_or_default();
        let less = without(last, &halved);
        assert!(take_no_less(&job, &strokes, &less).is_err(), "{mode:?}");
    }
}

#[test]
fn another_finish_pass_is_noticed() {
    let job = grooved(Mode::Bar);
    let changed = |change: &dyn Fn(&mut Event)| {
        let mut events = trace(&job.finishing());
        events.iter_mut().for_each(change);
        finishes(&job, &events)
    };
    assert_eq!(changed(&|_| ()), Ok(()));
    let end = |event: &mut Event| {
        if let Action::Linear { motion, .. } = &mut event.action {
            motion.program.x.0 += 1;
        }
    };
    let centre = |event: &mut Event| {
        if let Action::Arc { centre_z, .. } = &mut event.action {
            centre_z.0 += 1;
        }
    };
    assert!(changed(&end).is_err() && changed(&centre).is_err());
    assert!(finishes(&Job { allowance: Way::default(), ..job.clone() }, &trace(&job.finishing())).is_err());
}

#[test]
fn another_image_is_noticed() {
    for mode in MODES {
        let job = grooved(mode);
        let events = trace(&job.case());
        for axes in [(true, false), (false, true), (true, true)] {
            let image = trace(&job.mirrored(axes.0, axes.1).case());
            assert_eq!(mirrors(&job, &events, &image, axes), Ok(()));
            assert!(mirrors(&job, &events, &image[1..], axes).is_err());
            assert!(mirrors(&job, &events, &events, axes).is_err());
        }
    }
}

#[test]
fn another_number_of_passes_is_noticed() {
    for mode in MODES {
        let job = grooved(mode);
        let strokes = own(&job);
        assert!(number(&Job { step: 2_000, ..job.clone() }, None, &strokes).is_err(), "{mode:?}");
        assert!(number(&job, None, &without(1, &strokes)).is_err(), "{mode:?}");
        let last = strokes.iter().map(|stroke| stroke.pass).max().unwrap_or_default();
        assert!(number(&job, None, &without(last, &strokes)).is_err(), "{mode:?}");
    }
    let job = grooved(Mode::Bar);
    let mut longer = own(&job);
    let home = longer.pop().expect("there is a way home");
    longer.extend([*longer.last().expect("there are passes"); 60]);
    longer.push(home);
    assert!(number(&job, None, &longer).is_err_and(|message| message.contains("motions, more than")));
    let steep = Job { contour: [Element::line(2, 4), Element::line(2, -4)].repeat(11), ..shaft(Mode::Bar) };
    let events = trace(&steep.case());
    assert_eq!(number(&steep, alarm(&events), &strokes(&steep, &events)), Ok(()));
    assert!(number(&steep, None, &own(&shaft(Mode::Bar))).is_err());
}

#[test]
fn many_calls_are_tried() {
    let jobs =
        (0..300).filter_map(|seed| Job::arbitrary(&mut Unstructured::new(&bytes_of_seed(seed, 600))).ok());
    let jobs: Vec<Job> = jobs.collect();
    assert!(jobs.len() > 280);
    let cut = |mode: Mode| jobs.iter().filter(|job| job.mode == mode && job.refusal().is_none()).count();
    let recesses =
        |event: &Event| crate::shape::motion(event).is_some_and(|motion| motion.part == Some(Part::Clear));
    assert!(MODES.iter().all(|mode| cut(*mode) > 20), "{:?}", MODES.map(cut));
    assert!(jobs.iter().filter(|job| trace(&job.case()).iter().any(recesses)).count() > 60);
    for seed in 0..300 {
        assert_eq!(rough_turning_is_true(&bytes_of_seed(seed, 900)), Ok(()), "seed {seed}");
    }
}

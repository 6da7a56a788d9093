//! Pairs of a rough cycle: its finish pass, and its image in a mirror.

use turnspec_oracle::vocabulary::{Action, Event, Length, Motion, Position, Sense};

use crate::lap_job::Job;
use crate::lap_shape::Way;
use crate::shape::without_place;
use crate::{Verdict, require};

/// Nanometres of a micrometre.
const MICRO: i64 = 1_000;

/// A line, or an arc with its sense and centre; X and Z in nanometres.
type Shown = ([i64; 2], Option<(Sense, [i64; 2])>);

/// Statement 3.
pub(crate) fn finishes(job: &Job, events: &[Event]) -> Verdict {
    let shown = |event: &Event| -> Option<Shown> {
        match event.action {
            Action::Rapid { motion } | Action::Linear { motion, .. } => {
                Some(([motion.program.x.0, motion.program.z.0], None))
            }
            Action::Arc { motion, sense, centre_x, centre_z, .. } => {
                Some(([motion.program.x.0, motion.program.z.0], Some((sense, [centre_x.0, centre_z.0]))))
            }
            _ => None,
        }
    };
    let motions: Vec<Shown> = events.iter().filter_map(shown).skip(1).collect();
    let wanted = contour(job);
    require(motions == wanted, || format!("the finish pass is {motions:?}, not {wanted:?}"))
}

/// The motions of the contour, moved by the allowances toward the AP start.
fn contour(job: &Job) -> Vec<Shown> {
    let axes = |way: Way| if job.place.across { [way.run, way.height] } else { [way.height, way.run] };
    let point = |at: Way| {
        // The centre of an arc lies on half increments of Z at least, X is a diameter.
        let way = at.plus(job.place.base).plus(job.shift());
        let way = Way { run: job.place.forward * way.run, height: job.place.up * way.height };
        let [x, z] = axes(way);
        [x * MICRO, z * MICRO / 2]
    };
    let mut at = Way::default();
    let mut motions = vec![(point(at), None)];
    for element in &job.contour {
        let arc = element.arc.map(|arc| {
            let sense =
                if arc.over == job.keeps_sense() { Sense::Clockwise } else { Sense::CounterClockwise };
            (sense, point(at.plus(arc.centre)))
        });
        at = at.plus(element.way);
        motions.push((point(at), arc));
    }
    motions
}

/// Statement 5: the events of a call, and those of its image along the axes of height and run.
pub(crate) fn mirrors(job: &Job, events: &[Event], image: &[Event], axes: (bool, bool)) -> Verdict {
    let (by_x, by_z) = if job.place.across { (axes.1, axes.0) } else { axes };
    for (one, other) in events.iter().zip(image) {
        let wanted = Event { action: seen(one.action, by_x, by_z), ..without_place(one) };
        let other = without_place(other);
        require(other == wanted, || format!("in the mirror {other:?}, not {wanted:?}"))?;
    }
    let (count, other) = (events.len(), image.len());
    require(count == other, || format!("{count} events, {other} in the mirror"))
}

/// The image of an action.
fn seen(action: Action, by_x: bool, by_z: bool) -> Action {
    let turned = |length: Length, turns: bool| if turns { Length(-length.0) } else { length };
    let place = |position: Position| Position {
        x: turned(position.x, by_x),
        z: turned(position.z, by_z),
        ..position
    };
    let moved =
        |motion: Motion| Motion { program: place(motion.program), machine: place(motion.machine), ..motion };
    match action {
        Action::Rapid { motion } => Action::Rapid { motion: moved(motion) },
        Action::Linear { motion, feed, path } => Action::Linear { motion: moved(motion), feed, path },
        Action::Arc { motion, feed, sense, centre_x, centre_z } => Action::Arc {
            motion: moved(motion),
            feed,
            sense: match sense {
                _ if by_x == by_z => sense,
                Sense::Clockwise => Sense::CounterClockwise,
                Sense::CounterClockwise => Sense::Clockwise,
            },
            centre_x: turned(centre_x, by_x),
            centre_z: turned(centre_z, by_z),
        },
        other => other,
    }
}

//! Where a line of the turning plane ends: from its words, and from the block after it where it has an
//! angle alone.

use super::angle::{Inclination, meeting, x_at, z_at};
use super::plane::{Point, Vector};
use crate::fault::{Fault, Outcome};
use crate::modal::Plan;
use crate::state::{Base, State};
use crate::syntax::Address;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, IncrementalAfterChamfer, Place, ReadingSet, RuleSet};

/// A block that look-ahead has read.
#[derive(Clone, Debug)]
pub struct Ahead {
    /// What it holds.
    pub plan: Plan,
    /// Where it stands.
    pub place: Place,
}

/// The end of a line: X (as a diameter) and Z, with the rules and readings that led there.
#[derive(Clone, Debug)]
pub struct End {
    /// X and Z.
    pub point: Point,
    /// Rules of the angle and of the base point.
    pub rules: RuleSet,
    /// Readings.
    pub readings: ReadingSet,
}

/// Where the coordinates of a line come from: the point that it starts at, and the point that incremental
/// words count from.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// Start: X (as a diameter) and Z.
    pub start: Point,
    /// Base of incremental words.
    pub incremental: Point,
}

impl Origin {
    /// The present point, for both.
    pub fn present(state: &State) -> Self {
        let present = state.frame.program();
        let start = (present.x, present.z);
        Self { start, incremental: start }
    }
}

/// The origin of a block, and the reading that it depends on (E100L-CHAM-13).
pub fn origin(plan: &Plan, state: &State) -> (Origin, RuleSet, ReadingSet) {
    let here = Origin::present(state);
    let present = here.start;
    match state.base {
        None => (here, RuleSet::EMPTY, ReadingSet::default()),
        Some(Base { corner, whole: true }) => {
            (Origin { start: corner, incremental: corner }, RuleSet::EMPTY, ReadingSet::default())
        }
        Some(Base { corner, whole: false }) => {
            if !plan.modes.incremental() || !plan.words.has_any("XZ") {
                return (here, RuleSet::EMPTY, ReadingSet::default());
            }
            let reading = state.setup.readings.incremental_after_chamfer;
            let base = if reading == IncrementalAfterChamfer::Corner { corner } else { present };
            let origin = Origin { incremental: base, ..here };
            (origin, RuleSet::of(&[CHAM_13]), ReadingSet::default().with(reading))
        }
    }
}

/// Where the line of a block ends. `angle_target`: its end point, when the block before it had an angle alone.
pub fn line_end(plan: &Plan, origin: Origin, angle_target: Option<Point>, ahead: &[Ahead]) -> Outcome<End> {
    let words = &plan.words;
    let plain = |rules| End { point: (0, 0), rules, readings: ReadingSet::default() };
    if let Some(point) = angle_target {
        return Ok(End { point, ..plain(RuleSet::of(&[ANG_01, ANG_06])) });
    }
    let incremental = plan.modes.incremental();
    let coordinate =
        |word: Option<i64>, base: i64| word.map(|value| if incremental { base + value } else { value });
    let x = coordinate(words.get('X'), origin.incremental.0);
    let z = coordinate(words.get('Z'), origin.incremental.1);
    let Some(angle) = words.get('A') else {
        let point = (x.unwrap_or(origin.start.0), z.unwrap_or(origin.start.1));
        return Ok(End { point, ..plain(RuleSet::EMPTY) });
    };
    let start = Vector::at(origin.start);
    let inclination = Inclination(angle);
    let mut rules = RuleSet::of(&[DTAP_03, ANG_01, ANG_02]);
    if incremental {
        rules = rules.with(DTAP_05);
    }
    match (x, z) {
        (Some(x), _) => Ok(End { point: (x, z_at(&start, inclination, x)?), ..plain(rules) }),
        (None, Some(z)) => Ok(End { point: (x_at(&start, inclination, z)?, z), ..plain(rules) }),
        (None, None) => {
            let point = meeting_point(plan, &start, inclination, origin, ahead)?;
            let rule = if plan.is_chamfer() { ANG_05 } else { ANG_06 };
            Ok(End { point, ..plain(RuleSet::of(&[ANG_01, rule])) })
        }
    }
}

/// E100L-ANG-06: the end of an angle-only line, from the block after it.
fn meeting_point(
    plan: &Plan,
    start: &Vector,
    inclination: Inclination,
    origin: Origin,
    ahead: &[Ahead],
) -> Outcome<Point> {
    let (next, _) = next_block(plan, ahead)?;
    let second = Inclination(next.words.get('A').unwrap_or(0));
    let end = angle_end(next, origin.incremental);
    meeting(start, inclination, &Vector::at(end), second)
}

/// The end point of the block after an angle-only block; incremental words count from the start of that one.
pub fn angle_end(next: &Plan, base: Point) -> Point {
    let base = if next.modes.incremental() { base } else { (0, 0) };
    (base.0 + next.words.get('X').unwrap_or(0), base.1 + next.words.get('Z').unwrap_or(0))
}

/// The end point that an angle-only block leaves to the block after it.
pub fn target_of_next(plan: &Plan, base: Point, ahead: &[Ahead]) -> Option<Point> {
    let Ahead { plan: next, .. } = ahead.first().filter(|_| plan.is_angle_only())?;
    Some(angle_end(next, base))
}

/// E100L-ANG-05, E100L-ANG-06: the next block lacks the data of the corner.
fn lacks_data(plan: &Plan) -> Fault {
    Fault::new(AlarmName::AngleLookahead, if plan.is_chamfer() { ANG_05 } else { ANG_06 })
}

/// The block after one that needs it, if it is a line of the turning plane and nothing more.
///
/// Behind an angle alone it may be a leg of a thread too (E100L-ANG-06). G80, and E but in a leg, have passed their checks
/// in definitions of LAP alone.
pub fn next_block<'p>(plan: &Plan, ahead: &'p [Ahead]) -> Outcome<(&'p Plan, Place)> {
    let Some(Ahead { plan: next, place }) = ahead.first() else { return Err(lacks_data(plan)) };
    let chamfer = plan.is_chamfer();
    let motion = next.motion();
    if motion != 1 && chamfer {
        // E100L-ANG-07: only corners between two lines.
        return Err(Fault::new(AlarmName::ChamferCorner, ANG_07));
    }
    let leg = matches!(motion, 34 | 35);
    let g_fits =
        next.words.g.iter().all(|code| matches!(code, 0 | 1 | 34 | 35 | 75 | 76 | 80 | 90 | 91 | 94 | 95));
    let fits = |other: &crate::modal::Other| match other.address {
        Some(Address::Letter(letter)) => b"XZALSE".contains(&letter) || leg && matches!(letter, b'J' | b'C'),
        _ => false,
    };
    let others_fit = next.words.others.iter().all(fits);
    // E100L-ANG-06: an angle alone needs a whole line to meet.
    let complete = "XZA".chars().all(|letter| next.words.get(letter).is_some());
    let enough = if plan.is_angle_only() { complete } else { next.words.has_any("XZA") };
    if motion > 1 && !leg || !g_fits || !others_fit || !enough {
        return Err(lacks_data(plan));
    }
    Ok((next, *place))
}

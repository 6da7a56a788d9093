//! G02 and G03 (E100L-CIRC-01 to -20).

use super::element::{Axes, Element, Shape};
use super::plane::{Point, Vector, latch};
use super::target::Origin;
use crate::fault::{Fault, Outcome, fail};
use crate::frame::Amounts;
use crate::modal::Plan;
use crate::quantity::{Exact, narrow, ratio, whole};
use crate::real::{self, Interval};
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, ArcOneCoordinate, Length, ReadingSet, RuleSet, Sense};

/// An arc before it is carried out: end and centre (X as a diameter, Z).
struct Arc {
    end: Point,
    centre: Point,
    rules: RuleSet,
    readings: ReadingSet,
}

/// The motion along a circle; it ends at its target or not at all (E100L-LIM-01).
pub fn arc(plan: &Plan, state: &State) -> Outcome<Element> {
    let origin = Origin::present(state);
    let sense = if plan.motion() == 2 { Sense::Clockwise } else { Sense::CounterClockwise };
    let arc = match plan.words.get('L') {
        Some(radius) => by_radius(plan, origin, radius, sense)?,
        None => by_centre(plan, origin, sense, state)?,
    };
    let rules = RuleSet::of(&[CIRC_02, CIRC_09, CIRC_10]).union(arc.rules);
    Ok(Element {
        target: Amounts { x: arc.end.0, z: arc.end.1, ..Amounts::default() },
        axes: Axes::PLANE,
        shape: Shape::Arc { centre: arc.centre, sense },
        rules,
        readings: arc.readings,
    })
}

fn coordinates(plan: &Plan, origin: Origin) -> (Option<i64>, Option<i64>) {
    let incremental = plan.modes.incremental();
    let of = |word: Option<i64>, base: i64| word.map(|value| if incremental { base + value } else { value });
    (of(plan.words.get('X'), origin.incremental.0), of(plan.words.get('Z'), origin.incremental.1))
}

/// E100L-CIRC-07: an arc that ends where it starts.
fn full_circle() -> Fault {
    Fault::about(AlarmName::Unspecified, CIRC_07, "circle")
}

/// E100L-CIRC-04, E100L-CIRC-05, E100L-CIRC-06: the centre from the start in G90 and G91 alike (E100L-ABS-05), I
/// a radius value.
fn by_centre(plan: &Plan, origin: Origin, sense: Sense, state: &State) -> Outcome<Arc> {
    let (i, k) = (plan.words.get('I'), plan.words.get('K'));
    let start = origin.start;
    let centre = (start.0 + 2 * i.unwrap_or(0), start.1 + k.unwrap_or(0));
    let mut rules = RuleSet::of(&[CIRC_01, CIRC_04, CIRC_05]);
    if i.is_none() || k.is_none() {
        rules = rules.with(CIRC_06);
    }
    if !plan.modes.incremental() {
        rules = rules.with(CIRC_03);
    }
    let reading = state.setup.readings.arc_one_coordinate;
    let (end, check_radius, readings) = match coordinates(plan, origin) {
        (Some(x), Some(z)) => ((x, z), true, ReadingSet::default()),
        (x, z) => {
            rules = rules.with(CIRC_08);
            let readings = ReadingSet::default().with(reading);
            if reading == ArcOneCoordinate::Start {
                ((x.unwrap_or(start.0), z.unwrap_or(start.1)), true, readings)
            } else {
                (in_quadrant(start, centre, x, z, sense)?, false, readings)
            }
        }
    };
    if end == start {
        return Err(full_circle());
    }
    if check_radius {
        rules = rules.with(CIRC_11);
        radius_matches(start, end, centre, state.setup.parameters.circular_radius_tolerance)?;
    }
    Ok(Arc { end, centre, rules, readings })
}

/// E100L-CIRC-11: start and end radius differ by no more than the parameter.
fn radius_matches(start: Point, end: Point, centre: Point, tolerance: Length) -> Outcome<()> {
    let square = |point| Vector::at(point).minus(&Vector::at(centre)).square();
    let (at_start, at_end) = (square(start), square(end));
    let tolerance = whole(tolerance.0);
    // |√a - √b| > t exactly when a + b - t² > 2√(ab).
    let excess = &at_start + &at_end - &tolerance * &tolerance;
    if excess > Exact::ZERO && &excess * &excess > whole(4) * at_start * at_end {
        return fail(AlarmName::ArcRadiusMismatch, CIRC_11);
    }
    Ok(())
}

/// E100L-CIRC-08: where the circle meets the one coordinate that is commanded, in the quadrant in which the
/// arc starts and ahead of the start.
///
/// The plane is turned until the quadrant is the first one and the motion counter-clockwise in it; then z only
/// falls and x only rises from the start on.
fn in_quadrant(start: Point, centre: Point, x: Option<i64>, z: Option<i64>, sense: Sense) -> Outcome<Point> {
    let from = Vector::at(start).minus(&Vector::at(centre));
    let square = from.square();
    let counter_clockwise = sense == Sense::CounterClockwise;
    // Signs of the quadrant; on an axis the motion decides: its direction is ±left(from).
    let tangent =
        if counter_clockwise { from.left() } else { Vector { z: from.x.clone(), x: -from.z.clone() } };
    let sign = |coordinate: &Exact, motion: &Exact| {
        let decisive = if coordinate.is_zero() { motion } else { coordinate };
        whole(if *decisive < Exact::ZERO { -1 } else { 1 })
    };
    let (sign_z, sign_x) = (sign(&from.z, &tangent.z), sign(&from.x, &tangent.x));
    let none = || fail(AlarmName::ArcNoEndPoint, CIRC_08);
    // With the commanded coordinate positive in the quadrant, the other one is √(r² - c²).
    let (commanded, of_start, of_sign, of_motion) = match (x, z) {
        (Some(x), _) => (ratio(x - centre.0, 2), &from.x, &sign_x, &tangent.x),
        (None, z) => (whole(z.unwrap_or(centre.1) - centre.1), &from.z, &sign_z, &tangent.z),
    };
    let (inside, began) = (&commanded * of_sign, of_start * of_sign);
    let other_square = &square - &commanded * &commanded;
    if inside < Exact::ZERO || other_square < Exact::ZERO {
        return none();
    }
    // The coordinate grows or falls all the way through the quadrant. Where its motion is zero at the start
    // it is at its largest, and falls.
    let grows = of_motion * of_sign > Exact::ZERO;
    let ahead = if grows { inside > began } else { inside < began };
    if !ahead {
        return none();
    }
    let other = |centre: Exact, scale: u32, sign: &Exact| {
        let nearest = real::nearest_whole(|precision| {
            let root = Interval::of(&other_square, precision).sqrt();
            let offset = root.mul(&Interval::of(&(sign * whole(scale)), precision));
            Interval::of(&centre, precision).add(&offset)
        });
        narrow(&nearest)
    };
    Ok(match (x, z) {
        (Some(x), _) => (x, other(whole(centre.1), 1, &sign_z)),
        (None, z) => (other(whole(centre.0), 2, &sign_x), z.unwrap_or(centre.1)),
    })
}

/// E100L-CIRC-12 to -19: the centre from a radius.
fn by_radius(plan: &Plan, origin: Origin, radius: i64, sense: Sense) -> Outcome<Arc> {
    let start = origin.start;
    let end = match coordinates(plan, origin) {
        (Some(x), Some(z)) => (x, z),
        _ => return fail(AlarmName::ArcRadiusNeedsBoth, CIRC_14),
    };
    if end == start {
        return Err(full_circle());
    }
    let chord = Vector::at(end).minus(&Vector::at(start));
    let (chord_square, radius_square) = (chord.square(), whole(radius) * whole(radius));
    if chord_square > whole(4) * &radius_square {
        return fail(AlarmName::ArcRadiusTooSmall, CIRC_16);
    }
    let major = plan.words.major_arc();
    // M = m ± √(L² - q²/4) left(e), e = chord / q.
    let middle = Vector { z: ratio(start.1 + end.1, 2), x: ratio(start.0 + end.0, 4) };
    let to_left = (sense == Sense::CounterClockwise) != major;
    let direction = if to_left { chord.left() } else { chord.left().left().left() };
    let height = (radius_square - &chord_square / whole(4)) / &chord_square;
    let centre = latch(&middle, &direction, |precision| Interval::of(&height, precision).sqrt());
    let mut rules = RuleSet::of(&[CIRC_12, if major { CIRC_18 } else { CIRC_17 }]);
    rules = rules.with(if plan.modes.incremental() { CIRC_19 } else { CIRC_03 });
    Ok(Arc { end, centre, rules, readings: ReadingSet::default() })
}

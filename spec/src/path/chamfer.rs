//! Automatic chamfering G75 and rounding G76 (E100L-CHAM-01 to -13, E100L-ANG-03 to -08).
//!
//! A start, C programmed corner, B and D start and end of the chamfer, E end of the next line.

use super::element::{Axes, Element, LINEAR, Shape, check_range};
use super::plane::{Point, Vector, latch};
use super::target::{Ahead, Origin, angle_end, line_end, next_block, origin, target_of_next};
use crate::fault::{Outcome, fail};
use crate::frame::Amounts;
use crate::modal::Plan;
use crate::quantity::{Exact, whole};
use crate::real::{self, Interval};
use crate::state::{Base, State};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, ChamferLeg, Chamfering, ReadingSet, RuleId, RuleSet, Sense};

/// The two elements of a corner.
struct Corner {
    /// The axes of the line to it: one in the basic form.
    axes: Axes,
    /// B; none when the line before it has no length.
    line_to: Option<Point>,
    /// What joins the lines, and D; none for a rounding without length.
    join: Option<(Join, Point)>,
    /// The rule of the form.
    rule: RuleId,
    readings: ReadingSet,
}

enum Join {
    Face,
    Rounding { centre: Point, sense: Sense },
}

/// The motions to the corner of a block and across it.
pub fn chamfer(plan: &Plan, ahead: &[Ahead], state: &mut State) -> Outcome<Vec<Element>> {
    let (origin, base_rules, base_readings) = origin(plan, state);
    let basic = state.setup.parameters.chamfering == Chamfering::Basic;
    let end = line_end(plan, origin, state.angle_target.take(), ahead)?;
    let corner_point = end.point;
    let corner = if basic {
        basic_corner(plan, origin.start, corner_point)?
    } else {
        any_angle_corner(plan, origin, corner_point, ahead, state)?
    };
    check_range(state.lap.in_program(amounts(corner_point)), corner.axes, state.setup)?;
    state.base = Some(Base { corner: corner_point, whole: !basic });
    state.angle_target = target_of_next(plan, origin.incremental, ahead);
    let rules = RuleSet::of(&[CHAM_12, corner.rule]).union(end.rules).union(base_rules);
    let readings = end.readings.union(base_readings).union(corner.readings);
    Ok(elements(&corner, rules, readings))
}

fn amounts(point: Point) -> Amounts {
    Amounts { x: point.0, z: point.1, ..Amounts::default() }
}

fn elements(corner: &Corner, rules: RuleSet, readings: ReadingSet) -> Vec<Element> {
    let line = |point, axes| Element {
        target: amounts(point),
        axes,
        shape: Shape::Line,
        rules: rules.union(LINEAR),
        readings,
    };
    let before = corner.line_to.map(|point| line(point, corner.axes));
    let join = corner.join.as_ref().map(|(join, point)| match *join {
        Join::Face => line(*point, Axes::PLANE),
        Join::Rounding { centre, sense } => Element {
            shape: Shape::Arc { centre, sense },
            rules: rules.union(RuleSet::of(&[CIRC_02, CIRC_09])),
            ..line(*point, Axes::PLANE)
        },
    });
    before.into_iter().chain(join).collect()
}

/// The basic form (E100L-CHAM-03, E100L-CHAM-04, E100L-CHAM-11): along one axis, then along the other in the
/// direction of the sign of L.
fn basic_corner(plan: &Plan, start: Point, corner: Point) -> Outcome<Corner> {
    let size = plan.words.get('L').unwrap_or(0);
    let along_x = plan.words.get('X').is_some();
    // Travel in nanometres, of the radius for X; doubled to stay whole.
    let travel_twice = if along_x { corner.0 - start.0 } else { 2 * (corner.1 - start.1) };
    if travel_twice == 0 {
        return fail(AlarmName::ChamferAxes, CHAM_08);
    }
    if travel_twice.abs() < 2 * size.abs() {
        return fail(AlarmName::ChamferTooShort, CHAM_07);
    }
    let back = travel_twice.signum() * size.abs();
    let (before, after) = if along_x {
        ((corner.0 - 2 * back, corner.1), (corner.0, corner.1 + size))
    } else {
        ((corner.0, corner.1 - back), (corner.0 + 2 * size, corner.1))
    };
    let line_to = (travel_twice.abs() > 2 * size.abs()).then_some(before);
    let (join, rule) = if plan.one_shot == Some(75) {
        (Join::Face, CHAM_03)
    } else {
        let centre = if along_x { (before.0, before.1 + size) } else { (before.0 + 2 * size, before.1) };
        let first = Vector::at(corner).minus(&Vector::at(start));
        let second = Vector::at(after).minus(&Vector::at(corner));
        (Join::Rounding { centre, sense: turn(&first, &second) }, CHAM_11)
    };
    let axes = Axes { x: along_x, z: !along_x, ..Axes::default() };
    Ok(Corner { axes, line_to, join: Some((join, after)), rule, readings: ReadingSet::default() })
}

fn turn(first: &Vector, second: &Vector) -> Sense {
    if first.cross(second) > Exact::ZERO { Sense::CounterClockwise } else { Sense::Clockwise }
}

/// The lines that meet in a corner.
struct Lines {
    /// A to C: the direction of the line before.
    first: Vector,
    /// C to E.
    second: Vector,
    /// C.
    corner: Vector,
    /// Square of the way that is left to C.
    left_square: Exact,
}

/// The any-angle form (E100L-ANG-03, E100L-ANG-04).
fn any_angle_corner(
    plan: &Plan,
    origin: Origin,
    corner: Point,
    ahead: &[Ahead],
    state: &State,
) -> Outcome<Corner> {
    let size = whole(plan.words.get('L').unwrap_or(0).abs());
    let next_end = next_end(plan, origin, corner, ahead)?;
    let present = state.frame.program();
    let lines = Lines {
        first: Vector::at(corner).minus(&Vector::at(origin.start)),
        second: Vector::at(next_end).minus(&Vector::at(corner)),
        corner: Vector::at(corner),
        left_square: Vector::at(corner).minus(&Vector::of(present.x, present.z)).square(),
    };
    if lines.first.is_zero() || lines.second.is_zero() {
        return fail(AlarmName::ChamferAxes, CHAM_08);
    }
    if plan.one_shot == Some(75) {
        any_angle_chamfer(&lines, &size, state.setup.readings.chamfer_leg)
    } else {
        any_angle_rounding(&lines, &size, corner)
    }
}

/// Where the line of the next block ends.
fn next_end(plan: &Plan, origin: Origin, corner: Point, ahead: &[Ahead]) -> Outcome<Point> {
    let (next, place) = next_block(plan, ahead)?;
    let angle_target = plan.is_angle_only().then(|| angle_end(next, origin.incremental));
    let from_corner = Origin { start: corner, incremental: corner };
    let further = ahead.get(1..).unwrap_or_default();
    let end = line_end(next, from_corner, angle_target, further).map_err(|fault| fault.of_block(place))?;
    Ok(end.point)
}

impl Lines {
    /// √(N1 N2) and dot.
    fn product_of_lengths(&self, precision: usize) -> Interval {
        Interval::of(&(self.first.square() * self.second.square()), precision).sqrt()
    }

    fn opposite(&self) -> bool {
        self.first.cross(&self.second).is_zero() && self.first.dot(&self.second) < Exact::ZERO
    }

    /// E100L-CHAM-07: whether a leg fits on a way of this square: -1 with room, 0 just, 1 not.
    fn excess(leg: &dyn Fn(usize) -> Interval, square: &Exact) -> std::cmp::Ordering {
        real::sign(|precision| leg(precision).sub(&Interval::of(square, precision).sqrt()))
    }

    /// The ends of legs on both lines; B is none if the leg takes the whole way.
    fn legs(&self, leg: &dyn Fn(usize) -> Interval) -> Outcome<(Option<Point>, Point)> {
        let before = Self::excess(leg, &self.left_square);
        if before.is_gt() || Self::excess(leg, &self.second.square()).is_gt() {
            return fail(AlarmName::ChamferTooShort, CHAM_07);
        }
        let along = |direction: &Vector, sign: i32| {
            let length_square = direction.square();
            latch(&self.corner, direction, |precision| {
                let length = Interval::of(&length_square, precision).sqrt();
                leg(precision).div(&length).mul(&Interval::of(&whole(sign), precision))
            })
        };
        Ok((before.is_lt().then(|| along(&self.first, -1)), along(&self.second, 1)))
    }
}

/// E100L-ANG-03.
fn any_angle_chamfer(lines: &Lines, size: &Exact, reading: ChamferLeg) -> Outcome<Corner> {
    let readings = ReadingSet::default().with(reading);
    let dot = lines.first.dot(&lines.second);
    let (line_to, after) = match reading {
        ChamferLeg::Leg => lines.legs(&|precision| Interval::of(size, precision))?,
        ChamferLeg::Face if lines.opposite() => return fail(AlarmName::ChamferAxes, CHAM_08),
        // L / (2 cos(φ/2)) = L / √(2 (1 + cos φ)).
        ChamferLeg::Face => lines.legs(&|precision| {
            let of = |value: &Exact| Interval::of(value, precision);
            let cosine = of(&dot).div(&lines.product_of_lengths(precision));
            let denominator = of(&whole(2)).mul(&of(&whole(1)).add(&cosine)).sqrt();
            of(size).div(&denominator)
        })?,
    };
    Ok(Corner { axes: Axes::PLANE, line_to, join: Some((Join::Face, after)), rule: ANG_03, readings })
}

/// E100L-ANG-04: tangent length t = L tan(φ/2) = L |cross| / (n1 n2 + dot).
fn any_angle_rounding(lines: &Lines, size: &Exact, corner: Point) -> Outcome<Corner> {
    let readings = ReadingSet::default();
    let (cross, dot) = (lines.first.cross(&lines.second), lines.first.dot(&lines.second));
    if lines.opposite() {
        return fail(AlarmName::ChamferAxes, CHAM_08);
    }
    if cross.is_zero() {
        return Ok(Corner { axes: Axes::PLANE, line_to: Some(corner), join: None, rule: ANG_04, readings });
    }
    let tangent_length = |precision: usize| {
        let of = |value: &Exact| Interval::of(value, precision);
        let magnitude = if cross < Exact::ZERO { -cross.clone() } else { cross.clone() };
        of(&(size * magnitude)).div(&lines.product_of_lengths(precision).add(&of(&dot)))
    };
    let (line_to, after) = lines.legs(&tangent_length)?;
    let sense = turn(&lines.first, &lines.second);
    let centre = rounding_centre(lines, size, sense, &tangent_length);
    Ok(Corner {
        axes: Axes::PLANE,
        line_to,
        join: Some((Join::Rounding { centre, sense }, after)),
        rule: ANG_04,
        readings,
    })
}

/// The centre stands on the inner side of the exact B: C - t u1 ± L left(u1).
fn rounding_centre(
    lines: &Lines,
    size: &Exact,
    sense: Sense,
    tangent_length: &dyn Fn(usize) -> Interval,
) -> Point {
    let side = whole(if sense == Sense::CounterClockwise { 1 } else { -1 });
    let (first, left) = (&lines.first, lines.first.left());
    let length_square = first.square();
    let coordinate = |origin: &Exact, along: &Exact, across: &Exact, scale: u32| {
        let nearest = real::nearest_whole(|precision| {
            let of = |value: &Exact| Interval::of(value, precision);
            let back = tangent_length(precision).mul(&of(along));
            let aside = of(&(size * &side * across));
            let offset = aside.sub(&back).div(&of(&length_square).sqrt());
            of(&(origin * whole(scale))).add(&offset.mul(&of(&whole(scale))))
        });
        crate::quantity::narrow(&nearest)
    };
    (coordinate(&lines.corner.x, &first.x, &left.x, 2), coordinate(&lines.corner.z, &first.z, &left.z, 1))
}

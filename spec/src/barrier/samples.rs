//! Paths on small whole numbers, beside points that are sampled along them.

use super::path::Path;
use super::rectangle::Rectangle;
use crate::path::{Point, Shape};
use crate::vocabulary::{BarrierPath, Sense};

/// Z from −2 to 2, X (a radius here) from −1 to 1.
const SIZE: (f64, f64) = (2.0, 1.0);
const STEPS: u32 = 600;

fn is_inside((x, z): (f64, f64)) -> bool {
    z.abs() < SIZE.0 - 1e-9 && x.abs() < SIZE.1 - 1e-9
}

fn real((x, z): Point) -> (f64, f64) {
    let of = |value: i64| f64::from(i32::try_from(value).unwrap_or_default());
    (of(x) / 2.0, of(z))
}

/// Whether a point of the way that `at` describes from 0 to 1 is inside.
fn is_sampled(at: impl Fn(f64) -> (f64, f64)) -> bool {
    (0..=STEPS).any(|step| is_inside(at(f64::from(step) / f64::from(STEPS))))
}

fn arc_is_sampled(from: Point, to: Point, centre: Point, sense: Sense) -> bool {
    let (from, to, centre) = (real(from), real(to), real(centre));
    let angle = |point: (f64, f64)| (point.0 - centre.0).atan2(point.1 - centre.1);
    let way = if sense == Sense::CounterClockwise { 1.0 } else { -1.0 };
    let sweep = ((angle(to) - angle(from)) * way).rem_euclid(std::f64::consts::TAU);
    let sweep = if to == centre || sweep > std::f64::consts::TAU - 1e-9 { 0.0 } else { sweep };
    let radius = (from.0 - centre.0).hypot(from.1 - centre.1);
    is_inside(to)
        || is_sampled(|part| {
            let angle = angle(from) + way * sweep * part;
            (centre.0 + radius * angle.sin(), centre.1 + radius * angle.cos())
        })
}

fn enters(shape: Shape, from: Point, to: Point) -> bool {
    let path = Path::of(shape, from, to, BarrierPath::Line);
    path.enters(&Rectangle::new((-2, 2), (-2, 2)))
}

fn points(reach: i64) -> impl Iterator<Item = Point> {
    (-reach..=reach).flat_map(move |x| (-reach..=reach).map(move |z| (2 * x, z)))
}

#[test]
fn arcs_enter_where_a_point_of_them_is_inside() {
    for centre in points(3) {
        for from in points(3) {
            for to in points(2).step_by(3) {
                for sense in [Sense::Clockwise, Sense::CounterClockwise] {
                    let shape = Shape::Arc { centre, sense };
                    let expected = arc_is_sampled(from, to, centre, sense);
                    assert_eq!(enters(shape, from, to), expected, "{from:?} {to:?} {centre:?} {sense:?}");
                }
            }
        }
    }
}

#[test]
fn lines_enter_where_a_point_of_them_is_inside() {
    for (from, to) in points(4).flat_map(|from| points(4).map(move |to| (from, to))) {
        let (start, end) = (real(from), real(to));
        let at = |part: f64| (start.0 + (end.0 - start.0) * part, start.1 + (end.1 - start.1) * part);
        assert_eq!(enters(Shape::Line, from, to), is_sampled(at), "{from:?} {to:?}");
    }
}

//! A forecast of corners: whether the nose circle can touch two elements, and about where.
//!
//! Floating-point numbers, from the words of the rules (E100L-NRC-26, E100L-NRC-51, E100L-NRC-52); close to a
//! touch it may be wrong either way, and such programs are welcome.

use crate::geometry::Point;
use crate::state::Mode;

/// Directions that turn by less are taken for parallel.
const PARALLEL: f64 = 1e-11;

/// A line or an arc with what is in force in its block.
#[derive(Clone, Debug)]
pub struct Element {
    /// The way of a line; of an arc the tangent at its end, as long as its radius.
    pub direction: Point,
    /// The direction at its beginning.
    beginning: Point,
    /// Of an arc: from its ends to the centre, and 1 counter-clockwise, -1 clockwise.
    pub circle: Option<(Point, Point, f64)>,
    /// How far the nose centre lies to the left.
    offset: f64,
    /// From the tip to the nose centre.
    pub to_centre: Point,
}

/// One end of an element: its direction, and the way to its centre.
struct End {
    direction: Point,
    circle: Option<(Point, f64)>,
    offset: f64,
}

impl Element {
    /// A line, or an arc about a centre.
    pub fn new(from: Point, to: Point, centre: Option<(Point, Mode)>, offset: f64, to_centre: Point) -> Self {
        let Some((centre, mode)) = centre else { return Self::line(to.minus(from), offset, to_centre) };
        let sense = if mode == Mode::CounterClockwise { 1.0 } else { -1.0 };
        let (start, end) = (centre.minus(from), centre.minus(to));
        Self {
            direction: start_tangent(end, sense),
            beginning: start_tangent(start, sense),
            circle: Some((start, end, sense)),
            offset,
            to_centre,
        }
    }

    /// A line in this direction.
    pub fn line(direction: Point, offset: f64, to_centre: Point) -> Self {
        Self { direction, beginning: direction, circle: None, offset, to_centre }
    }

    /// The nose centre where it touches the beginning alone, from the programmed point.
    pub fn contact_at_beginning(&self) -> Point {
        contact(self.beginning, self.offset)
    }

    /// The nose centre where it touches the end alone, from the programmed point.
    pub fn contact_at_end(&self) -> Point {
        contact(self.direction, self.offset)
    }

    /// Whether it is an arc that the nose does not fit into.
    pub fn is_too_small(&self) -> bool {
        let too_small = |to_centre: Point, sense: f64| to_centre.length() < sense * self.offset;
        self.circle.is_some_and(|(start, end, sense)| too_small(start, sense) || too_small(end, sense))
    }

    /// Whether it has a corner with an imaginary line on its own side.
    pub fn meets_line(&self, direction: Point) -> bool {
        meeting(self, &Self::line(direction, self.offset, self.to_centre)).is_some()
    }

    fn end(&self) -> End {
        let circle = self.circle.map(|(_, end, sense)| (end, end.length() - sense * self.offset));
        End { direction: self.direction, circle, offset: self.offset }
    }

    fn begin(&self) -> End {
        let circle = self.circle.map(|(start, _, sense)| (start, start.length() - sense * self.offset));
        End { direction: self.beginning, circle, offset: self.offset }
    }
}

/// Where the nose centre touches an element and the next one, from their common point; none where there is no
/// such place.
pub fn meeting(before: &Element, after: &Element) -> Option<Point> {
    let (before, after) = (before.end(), after.begin());
    let (arriving, leaving) = (unit(before.direction), unit(after.direction));
    let turn = arriving.cross(leaving);
    if turn.abs() < PARALLEL {
        let same = arriving.minus(leaving).length() < 1.0;
        let offset = if same { after.offset } else { -after.offset };
        let lines = before.circle.is_none() && after.circle.is_none();
        return (lines || (before.offset - offset).abs() < 0.5).then(|| contact(arriving, before.offset));
    }
    match (before.circle, after.circle) {
        (None, None) => {
            let corner = leaving.times(before.offset).minus(arriving.times(after.offset));
            Some(corner.times(1.0 / turn))
        }
        (None, Some(circle)) => line_and_circle(arriving, before.offset, circle),
        (Some(circle), None) => line_and_circle(leaving, after.offset, circle),
        (Some(first), Some(second)) => two_circles(first, second),
    }
}

/// A line through an offset point, and a circle of the nose centre.
fn line_and_circle(direction: Point, offset: f64, (centre, radius): (Point, f64)) -> Option<Point> {
    let aside = contact(direction, offset);
    let away = aside.minus(centre);
    let across = direction.cross(away);
    let half = (radius * radius - across * across).sqrt();
    let ahead = -(centre.z * direction.z + centre.x * direction.x).signum();
    let foot = centre.plus(left(direction).times(across));
    (half.is_finite() && radius >= 0.0).then(|| foot.plus(direction.times(half * ahead)))
}

/// Two circles of the nose centre.
fn two_circles((one, first): (Point, f64), (other, second): (Point, f64)) -> Option<Point> {
    let way = other.minus(one);
    let distance = way.length();
    let along = (first * first - second * second + distance * distance) / (2.0 * distance);
    let aside = (first * first - along * along).sqrt();
    let direction = unit(way);
    let side = -direction.cross(one).signum();
    let foot = one.plus(direction.times(along));
    aside.is_finite().then(|| foot.plus(left(direction).times(aside * side)))
}

/// The tangent at a point of a circle, from the way to the centre.
fn start_tangent(to_centre: Point, sense: f64) -> Point {
    left(to_centre).times(-sense)
}

fn contact(direction: Point, offset: f64) -> Point {
    left(unit(direction)).times(offset)
}

fn unit(direction: Point) -> Point {
    direction.times(1.0 / direction.length().max(f64::MIN_POSITIVE))
}

/// A direction turned a quarter counter-clockwise.
pub fn left(direction: Point) -> Point {
    Point { z: -direction.x, x: direction.z }
}

#[cfg(test)]
mod tests {
    use super::{Element, Point, meeting};
    use crate::state::Mode;

    const MM: f64 = 1e6;

    fn point(z: f64, x: f64) -> Point {
        Point { z: z * MM, x: x * MM }
    }

    /// G42 with a nose of 0.8 mm.
    fn element(from: Point, to: Point, centre: Option<(Point, Mode)>) -> Element {
        Element::new(from, to, centre, -0.8 * MM, point(0.8, 0.8))
    }

    fn near(found: Option<Point>, z: f64, x: f64) -> bool {
        found.is_some_and(|found| found.minus(point(z, x)).length() < 2.0)
    }

    // The expected places are those of the examples of the rules.
    #[test]
    fn corners_lie_where_the_rules_say() {
        let facing = element(point(100.0, 50.0), point(60.0, 50.0), None);
        let rising = element(point(60.0, 50.0), point(60.0, 75.0), None);
        // E100L-NRC-26.
        assert!(near(meeting(&facing, &rising), 0.8, 0.8));
        // E100L-NRC-51, line to arc outside.
        let centre = (point(60.0, 50.0), Mode::CounterClockwise);
        let outside = element(point(80.0, 50.0), point(60.0, 70.0), Some(centre));
        assert!(near(meeting(&facing, &outside), 0.784_61, 0.8));
        // E100L-NRC-52.
        let quarter = |from, to, centre| element(from, to, Some((centre, Mode::CounterClockwise)));
        let first = quarter(point(80.0, 40.0), point(70.0, 50.0), point(70.0, 40.0));
        let second = quarter(point(70.0, 50.0), point(60.0, 60.0), point(60.0, 50.0));
        assert!(near(meeting(&first, &second), 0.772_348, 0.772_348));
    }

    #[test]
    fn what_cannot_be_cut_is_known() {
        // E100L-NRC-53: an inside arc of radius 1 and the line behind it.
        let arc = element(point(80.0, 50.0), point(79.0, 51.0), Some((point(80.0, 51.0), Mode::Clockwise)));
        assert!(!arc.is_too_small());
        assert!(meeting(&arc, &element(point(79.0, 51.0), point(40.0, 51.0), None)).is_none());
        // E100L-NRC-48.
        let small = Some((point(80.0, 50.7), Mode::Clockwise));
        assert!(element(point(80.0, 50.0), point(79.3, 50.7), small).is_too_small());
    }
}

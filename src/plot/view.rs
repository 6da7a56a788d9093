//! What part of the plane is drawn, at what scale, and where its points lie on the sheet.

use turnspec_conformance::geometry::{self, Point, Way};

use super::outline::Definition;
use super::path::{Kind, Plan};

/// Width of the plot in pixels.
pub const WIDTH: f64 = 960.0;
/// Greatest and smallest height of the plot in pixels.
const HEIGHTS: (f64, f64) = (240.0, 720.0);
/// Room round what is drawn, as a share of the width.
const ROOM: f64 = 0.04;
/// Decimals of a number of pixels.
const DECIMALS: usize = 2;

/// Which motions have to be on the sheet.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Extent {
    /// All.
    #[default]
    All,
    /// Those that cut, if there are any; the others run out of the sheet.
    Cutting,
}

/// A window of the plane, at one scale in Z and X.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct View {
    /// Its lower left corner.
    pub low: Point,
    /// Its upper right corner.
    pub high: Point,
    /// Pixels a millimetre.
    pub scale: f64,
}

impl View {
    /// The window round a plan.
    pub fn of(plan: &Plan, extent: Extent) -> Self {
        let (mut low, mut high) = bounds(plan, extent);
        let least = ((high.z - low.z).max(high.x - low.x)).max(1e-3);
        let scale = (WIDTH * (1.0 - 2.0 * ROOM) / (high.z - low.z).max(least / 4.0))
            .min(HEIGHTS.1 * (1.0 - 2.0 * ROOM) / (high.x - low.x).max(least / 16.0));
        let height = ((high.x - low.x) * scale / (1.0 - 2.0 * ROOM)).clamp(HEIGHTS.0, HEIGHTS.1);
        let half = Point::new(WIDTH / 2.0 / scale, height / 2.0 / scale);
        let middle = (low + high) * 0.5;
        (low, high) = (middle - half, middle + half);
        Self { low, high, scale }
    }

    /// Height of the plot in pixels.
    pub fn height(&self) -> f64 {
        (self.high.x - self.low.x) * self.scale
    }

    /// Where a point lies: pixels to the right and down.
    pub fn place(&self, point: Point) -> (f64, f64) {
        ((point.z - self.low.z) * self.scale, (self.high.x - point.x) * self.scale)
    }

    /// Path data of a way.
    pub fn data(&self, way: &Way) -> String {
        format!("M{}{}", self.pair(way.from), way.stretch(self.scale, DECIMALS, |point| self.pair(point)))
    }

    fn pair(&self, point: Point) -> String {
        let (right, down) = self.place(point);
        format!("{} {}", number(right), number(down))
    }
}

/// The corners of what has to be seen. The outmost points of an arc count, not only its ends.
fn bounds(plan: &Plan, extent: Extent) -> (Point, Point) {
    let cuts = plan.segments.iter().any(|segment| segment.kind != Kind::Rapid);
    let wanted =
        plan.segments.iter().filter(|segment| extent == Extent::All || !cuts || segment.kind != Kind::Rapid);
    let ways = wanted.flat_map(|segment| [Some(segment.way), segment.programmed]).flatten();
    let defined = plan.definitions.iter().flat_map(Definition::ways).copied();
    let points = ways.chain(defined).flat_map(|way| outline(&way)).chain(plan.alarm);
    let barriers = plan.barriers.iter().filter(|_| extent == Extent::All).flat_map(|area| [area.0, area.1]);
    let mut corners: Option<(Point, Point)> = None;
    for point in points.chain(barriers) {
        let (low, high) = corners.unwrap_or((point, point));
        corners = Some((
            Point::new(low.z.min(point.z), low.x.min(point.x)),
            Point::new(high.z.max(point.z), high.x.max(point.x)),
        ));
    }
    corners.unwrap_or((Point::new(-50.0, 0.0), Point::new(50.0, 50.0)))
}

/// The ends of a way, and where its circle is farthest out on the way.
fn outline(way: &Way) -> Vec<Point> {
    let mut points = vec![way.from, way.to];
    if let Some(arc) = way.arc {
        let radius = (way.from - arc.centre).length();
        let (start, end) = (way.from - arc.centre, way.to - arc.centre);
        for out in [Point::new(1.0, 0.0), Point::new(0.0, 1.0), Point::new(-1.0, 0.0), Point::new(0.0, -1.0)]
        {
            // Between the ends in the sense of the arc.
            let large = arc.sense * start.cross(end) < 0.0;
            let behind = arc.sense * start.cross(out) >= 0.0;
            let before = arc.sense * out.cross(end) >= 0.0;
            if if large { behind || before } else { behind && before } {
                points.push(arc.centre + out * radius);
            }
        }
    }
    points
}

/// A number of pixels, rounded to 0.01, without superfluous zeros.
pub fn number(value: f64) -> String {
    geometry::number(value, DECIMALS)
}

#[cfg(test)]
mod tests {
    use super::{Extent, HEIGHTS, Plan, View, WIDTH, number, outline};
    use turnspec_conformance::geometry::{Arc, Point, Way};

    #[test]
    fn the_outmost_points_of_an_arc_count() {
        let arc = Arc { centre: Point::default(), sense: 1.0 };
        let (right, top, left) = (Point::new(5.0, 0.0), Point::new(0.0, 5.0), Point::new(-5.0, 0.0));
        let half = Way { from: right, to: left, arc: Some(arc) };
        assert!(outline(&half).contains(&top));
        let other = Way { arc: Some(Arc { sense: -1.0, ..arc }), ..half };
        assert!(!outline(&other).contains(&top) && outline(&other).contains(&Point::new(0.0, -5.0)));
        let most = Way { from: top, to: right, arc: Some(arc) };
        assert!(outline(&most).contains(&left) && outline(&most).contains(&Point::new(0.0, -5.0)));
    }

    #[test]
    fn an_empty_plan_has_a_sheet() {
        let view = View::of(&Plan::default(), Extent::All);
        assert!(view.scale.is_finite() && view.scale > 0.0);
        assert!((HEIGHTS.0..=HEIGHTS.1).contains(&view.height()));
        assert!(((view.high.z - view.low.z) * view.scale - WIDTH).abs() < 1e-6);
    }

    #[test]
    fn numbers_are_short() {
        for (value, text) in [(1.5, "1.5"), (-0.0001, "0"), (120.0, "120"), (2.0 / 3.0, "0.67")] {
            assert_eq!(number(value), text);
        }
    }
}

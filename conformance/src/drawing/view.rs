//! What part of the plane a drawing shows, and where a point of it lies on the sheet.

use super::scene::{Scene, Stand};
use crate::geometry::{self, Point, Way};

/// Width of the plot in pixels.
pub const WIDTH: f64 = 480.0;
/// Height of the plot in pixels.
pub const HEIGHT: f64 = 300.0;
/// Room round the points that a drawing is about, in nose radii.
const ROOM: f64 = 1.4;
/// Room for names at the margin, in pixels.
const MARGIN: f64 = 36.0;
/// Decimals of a number of pixels.
const DECIMALS: usize = 3;

/// A window of the plane, at one scale in Z and X.
pub struct View {
    /// The upper left corner.
    corner: Point,
    /// Pixels a millimetre.
    pub scale: f64,
}

impl View {
    /// The window round the ends of the motions of some blocks.
    ///
    /// # Errors
    /// When no motion is among them.
    pub fn of(scene: &Scene, blocks: &[&str]) -> Result<Self, String> {
        let named = scene.steps.iter().filter(|step| blocks.contains(&step.block.as_str()));
        let stands: Vec<Stand> = named.map(|step| step.to).collect();
        let radius = stands.iter().map(Stand::radius).fold(0.0, f64::max);
        let points: Vec<Point> =
            stands.iter().flat_map(|stand| [stand.programmed, stand.tip, stand.nose]).collect();
        let span = |coordinate: fn(&Point) -> f64| {
            let low = points.iter().map(coordinate).fold(f64::INFINITY, f64::min);
            let high = points.iter().map(coordinate).fold(f64::NEG_INFINITY, f64::max);
            (low - ROOM * radius, high + ROOM * radius)
        };
        let ((left, right), (bottom, top)) = (span(|point| point.z), span(|point| point.x));
        let scale = ((WIDTH - 2.0 * MARGIN) / (right - left)).min((HEIGHT - 2.0 * MARGIN) / (top - bottom));
        if !(scale.is_finite() && scale > 0.0) {
            return Err(
                "the caption of a drawing names blocks with motions, and there is a nose radius".to_owned()
            );
        }
        let middle = Point::new((left + right) / 2.0, (bottom + top) / 2.0);
        let half = Point::new(WIDTH / 2.0 / scale, HEIGHT / 2.0 / scale);
        Ok(Self { corner: Point::new(middle.z - half.z, middle.x + half.x), scale })
    }

    /// Where a point lies: pixels to the right and down.
    pub fn place(&self, point: Point) -> (f64, f64) {
        ((point.z - self.corner.z) * self.scale, (self.corner.x - point.x) * self.scale)
    }

    /// Whether a point lies in the window.
    pub fn shows(&self, point: Point) -> bool {
        let (right, down) = self.place(point);
        (0.0..=WIDTH).contains(&right) && (0.0..=HEIGHT).contains(&down)
    }

    /// Path data of some ways; one that begins where the last one ended continues it.
    pub fn path(&self, ways: impl IntoIterator<Item = Way>) -> String {
        let mut data = String::new();
        let mut end = None;
        for way in ways.into_iter().filter(Way::has_length) {
            if end != Some(way.from) {
                data += &format!("M{}", self.pair(way.from));
            }
            data += &way.stretch(self.scale, DECIMALS, |point| self.pair(point));
            end = Some(way.to);
        }
        data
    }

    fn pair(&self, point: Point) -> String {
        let (right, down) = self.place(point);
        format!("{} {}", number(right), number(down))
    }
}

/// A number of pixels, rounded to 0.001, without superfluous zeros.
pub fn number(value: f64) -> String {
    geometry::number(value, DECIMALS)
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use super::{View, number};
    use crate::geometry::{Arc, Point, Way};

    const VIEW: View = View { corner: Point { z: 0.0, x: 10.0 }, scale: 2.0 };

    #[test]
    fn z_goes_right_and_x_up() {
        assert_eq!(VIEW.place(Point::new(3.0, 10.0)), (6.0, 0.0));
        assert_eq!(VIEW.place(Point::new(3.0, 8.0)), (6.0, 4.0));
    }

    #[test]
    fn ways_that_meet_make_one_path() {
        let corner = Point::new(5.0, 5.0);
        let line = Way { from: Point::new(10.0, 5.0), to: corner, arc: None };
        let arc = Arc { centre: Point::new(5.0, 8.0), sense: -1.0 };
        let quarter = Way { from: corner, to: Point::new(2.0, 8.0), arc: Some(arc) };
        assert_eq!(VIEW.path([line, quarter]), "M20 10L10 10A6 6 0 0 1 4 4");
        let rest = Arc { sense: 1.0, ..arc };
        assert_eq!(VIEW.path([Way { arc: Some(rest), ..quarter }]), "M10 10A6 6 0 1 0 4 4");
    }

    #[test]
    fn numbers_are_short() {
        for (value, text) in [(1.5, "1.5"), (-0.0001, "0"), (120.0, "120"), (2.0 / 3.0, "0.667")] {
            assert_eq!(number(value), text);
        }
    }
}

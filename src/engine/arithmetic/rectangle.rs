//! Open rectangles in program coordinates, the parts of an area.

use super::plane::Point;

/// The points with Z and X strictly between two bounds, the first one below the second. In nanometres, X as a
/// diameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rectangle {
    /// The bounds of Z.
    pub z: (i64, i64),
    /// The bounds of X.
    pub x: (i64, i64),
}

impl Rectangle {
    /// Whether a point is inside; the edge is not.
    #[must_use]
    pub fn contains(&self, point: Point) -> bool {
        let between = |value: i64, (low, high): (i64, i64)| low < value && value < high;
        between(point.z, self.z) && between(point.x, self.x)
    }

    /// Its corners.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        let ((low, high), (below, above)) = (self.z, self.x);
        [(low, below), (low, above), (high, below), (high, above)].map(|(z, x)| Point { x, z })
    }
}

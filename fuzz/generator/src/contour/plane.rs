//! Points of a plane of the C axis, and the arcs that the control finds between them.

/// A point, in nanometres.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Spot {
    pub p: f64,
    pub q: f64,
}

impl Spot {
    /// The point of the face with this diameter and this angle in micro-degrees (E100L-CGF-01).
    pub fn on_face(diameter: i64, angle: i64) -> Self {
        let radians = (angle as f64 / 1e6).to_radians();
        Self { p: diameter as f64 / 2.0 * radians.cos(), q: diameter as f64 / 2.0 * radians.sin() }
    }

    /// A point by its coordinates.
    pub fn of([p, q]: [i64; 2]) -> Self {
        Self { p: p as f64, q: q as f64 }
    }

    /// How far another point is away.
    pub fn distance(self, other: Self) -> f64 {
        (other.p - self.p).hypot(other.q - self.q)
    }

    /// How far the centre of the face is away.
    pub fn radius(self) -> f64 {
        self.p.hypot(self.q)
    }

    /// The centre of the arc to another point (E100L-CGF-04).
    pub fn centre(self, end: Self, radius: f64, counter_clockwise: bool) -> Self {
        let chord = self.distance(end);
        let height = (radius * radius - chord * chord / 4.0).max(0.0).sqrt();
        let side = if counter_clockwise { height } else { -height };
        let (p, q) = ((end.p - self.p) / chord, (end.q - self.q) / chord);
        Self { p: f64::midpoint(self.p, end.p) - side * q, q: f64::midpoint(self.q, end.q) + side * p }
    }
}

/// Whether an arc with this radius about this point passes the centre of the face too near (E100L-CGF-04).
pub(super) fn is_too_near(centre: Spot, radius: f64) -> bool {
    (centre.radius() - radius).abs() < 2_000.0
}

#[cfg(test)]
mod tests {
    use super::{Spot, is_too_near};

    #[test]
    fn the_manuals_arcs_are_found() {
        // E100L-CGF-04: from C330 to C30 on the diameter 100, radius 50, clockwise.
        let (start, end) = (Spot::on_face(100_000_000, 330_000_000), Spot::on_face(100_000_000, 30_000_000));
        let centre = start.centre(end, 50e6, false);
        assert!(centre.distance(Spot { p: 86_602_540.0, q: 0.0 }) < 1.0, "{centre:?}");
        // Between (5, 10) and (5, -10) the circle about (12.5, 0) passes the centre of the face.
        let centre =
            Spot::of([5_000_000, 10_000_000]).centre(Spot::of([5_000_000, -10_000_000]), 12.5e6, true);
        assert!(
            centre.distance(Spot { p: 12.5e6, q: 0.0 }) < 1.0 && is_too_near(centre, 12.5e6),
            "{centre:?}"
        );
    }
}

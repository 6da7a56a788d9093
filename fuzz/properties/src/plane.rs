//! Points of a plane of the C axis, and under which angle ways between them are seen from its centre.

/// A point in nanometres.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Spot {
    pub(crate) p: f64,
    pub(crate) q: f64,
}

/// How near to the centre of the face a way may pass for its angle to be told, in nanometres.
const NEAREST: f64 = 20_000.0;

/// Parts of an arc.
const PARTS: u32 = 720;

impl Spot {
    /// The point at a distance in a direction, in degrees.
    pub(crate) fn polar(radius: f64, angle: f64) -> Self {
        let (sine, cosine) = angle.to_radians().sin_cos();
        Self { p: radius * cosine, q: radius * sine }
    }

    /// How far another point is away.
    pub(crate) fn distance(self, other: Self) -> f64 {
        (other.p - self.p).hypot(other.q - self.q)
    }

    /// How far it is from the centre of the face.
    pub(crate) fn radius(self) -> f64 {
        self.p.hypot(self.q)
    }

    /// Its direction, in degrees.
    fn direction(self) -> f64 {
        self.q.atan2(self.p).to_degrees()
    }

    /// The way from another point.
    fn from(self, other: Self) -> Self {
        Self { p: self.p - other.p, q: self.q - other.q }
    }
}

/// A difference of directions in -180 to 180 degrees.
fn turn(from: f64, to: f64) -> f64 {
    (to - from + 180.0).rem_euclid(360.0) - 180.0
}

/// Under which angle a line is seen from the centre; none where it passes too near.
pub(crate) fn seen_along_line(start: Spot, end: Spot) -> Option<f64> {
    let way = end.from(start);
    let area = (start.p * end.q - start.q * end.p).abs();
    let clear = area > NEAREST * way.radius().max(1.0);
    clear.then(|| turn(start.direction(), end.direction()))
}

/// Under which angle an arc of at most half a turn is seen from the centre, its parts added up; none where it passes too near
/// or its parts are seen under too much.
pub(crate) fn seen_along_arc(start: Spot, end: Spot, centre: Spot, positive: bool) -> Option<f64> {
    let (spoke, last) = (start.from(centre), end.from(centre));
    let (radius, first) = (spoke.radius(), spoke.direction());
    let sweep = turn(first, last.direction());
    // Half a turn may come out on either side.
    let sweep = match (positive, sweep) {
        (true, ..-170.0) => sweep + 360.0,
        (false, 170.0..) => sweep - 360.0,
        _ => sweep,
    };
    if (sweep > 0.0) != positive || (centre.radius() - radius).abs() < NEAREST {
        return None;
    }
    let at = |part: u32| {
        let place = Spot::polar(radius, first + sweep * f64::from(part) / f64::from(PARTS));
        Spot { p: place.p + centre.p, q: place.q + centre.q }
    };
    let mut seen = 0.0;
    let mut from = start;
    for part in 1..=PARTS {
        let to = if part == PARTS { end } else { at(part) };
        let step = turn(from.direction(), to.direction());
        // The arc would pass the centre within a part.
        if step.abs() > 60.0 {
            return None;
        }
        seen += step;
        from = to;
    }
    Some(seen)
}

#[cfg(test)]
mod tests {
    use super::{Spot, seen_along_arc, seen_along_line};

    #[test]
    fn ways_are_seen_under_their_angles() {
        // E100L-CGF-06: from C80 to C280, round the centre on the far side or past it on the near one.
        let (start, end) = (Spot::polar(50e6, 80.0), Spot::polar(50e6, 280.0));
        let near = |seen: Option<f64>, angle: f64| seen.is_some_and(|seen| (seen - angle).abs() < 1e-6);
        assert!(near(seen_along_arc(start, end, Spot { p: 17.364818e6, q: 0.0 }, true), 200.0));
        assert!(near(seen_along_line(start, end), -160.0));
        assert_eq!(seen_along_line(start, Spot::polar(30e6, 260.0)), None);
        // Half a circle about the centre of the face.
        let half =
            seen_along_arc(Spot::polar(50e6, 30.0), Spot::polar(50e6, 210.0), Spot { p: 0.0, q: 0.0 }, false);
        assert!(near(half, -180.0), "{half:?}");
    }
}

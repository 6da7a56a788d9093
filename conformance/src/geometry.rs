//! For drawings: points of the plane and ways between them.
//!
//! Only sums, products, quotients and square roots are used, which every machine computes alike.

use std::ops::{Add, Mul, Sub};

use turnspec_oracle::vocabulary::{Length, Sense};

/// A point or vector in millimetres, X as a radius.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Point {
    /// Along the axis of the spindle.
    pub z: f64,
    /// Across it.
    pub x: f64,
}

impl Point {
    /// The point with these coordinates.
    #[must_use]
    pub fn new(z: f64, x: f64) -> Self {
        Self { z, x }
    }

    /// The point with these coordinates, X as a diameter.
    #[must_use]
    pub fn of(z: Length, x: Length) -> Self {
        Self { z: z.0 as f64 / 1e6, x: x.0 as f64 / 2e6 }
    }

    /// The distance from zero.
    #[must_use]
    pub fn length(self) -> f64 {
        (self.z * self.z + self.x * self.x).sqrt()
    }

    /// The vector of length 1 in this direction; none of a vector without length.
    #[must_use]
    pub fn unit(self) -> Option<Self> {
        let length = self.length();
        (length > 0.0).then(|| self * (1.0 / length))
    }

    /// The vector turned by 90 degrees to the left.
    #[must_use]
    pub fn left(self) -> Self {
        Self { z: -self.x, x: self.z }
    }

    /// Positive when `other` points to the left of this vector.
    #[must_use]
    pub fn cross(self, other: Self) -> f64 {
        self.z * other.x - self.x * other.z
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { z: self.z + other.z, x: self.x + other.x }
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + other * -1.0
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { z: self.z * factor, x: self.x * factor }
    }
}

/// A way from one point to another: straight, or round a centre.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Way {
    /// Where it begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// The circle that it follows, if it is not straight.
    pub arc: Option<Arc>,
}

/// The circle that a way follows.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Arc {
    /// Its centre.
    pub centre: Point,
    /// +1 counter-clockwise, −1 clockwise, with Z to the right and X up.
    pub sense: f64,
}

impl Arc {
    /// The arc of an event, by its centre, X as a diameter.
    #[must_use]
    pub fn of(z: Length, x: Length, sense: Sense) -> Self {
        let sense = if sense == Sense::CounterClockwise { 1.0 } else { -1.0 };
        Self { centre: Point::of(z, x), sense }
    }
}

impl Way {
    /// Its path data in SVG without the beginning, at so many pixels a millimetre; `pair` writes where a point lies.
    #[must_use]
    pub fn stretch(&self, scale: f64, decimals: usize, pair: impl Fn(Point) -> String) -> String {
        let Some(arc) = self.arc else { return format!("L{}", pair(self.to)) };
        let (start, end) = (self.from - arc.centre, self.to - arc.centre);
        let radius = number((start.length() + end.length()) / 2.0 * scale, decimals);
        let large = u8::from(arc.sense * start.cross(end) < 0.0);
        let clockwise = u8::from(arc.sense < 0.0);
        format!("A{radius} {radius} 0 {large} {clockwise} {}", pair(self.to))
    }

    /// Whether it leads anywhere else.
    #[must_use]
    pub fn has_length(&self) -> bool {
        self.from != self.to
    }

    /// The way at the distance `d` to the left; none if a circle would have no radius left.
    #[must_use]
    pub fn beside(&self, d: f64) -> Option<Self> {
        let shifted = |point: Point| match self.arc {
            None => Some(point + (self.to - self.from).unit()?.left() * d),
            Some(arc) => {
                let spoke = point - arc.centre;
                let radius = spoke.length() - arc.sense * d;
                (radius > 0.0).then_some(arc.centre + spoke.unit()? * radius)
            }
        };
        Some(Self { from: shifted(self.from)?, to: shifted(self.to)?, arc: self.arc })
    }
}

/// A number rounded to so many decimals, without superfluous zeros.
#[must_use]
pub fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::{Arc, Point, Way};

    #[test]
    fn left_of_a_way_to_minus_z_is_minus_x() {
        let way = Way { from: Point::new(10.0, 5.0), to: Point::new(0.0, 5.0), arc: None };
        let left = Way { from: Point::new(10.0, 4.0), to: Point::new(0.0, 4.0), arc: None };
        assert_eq!(way.beside(1.0), Some(left));
    }

    #[test]
    fn left_of_a_counter_clockwise_arc_is_its_inside() {
        let arc = Arc { centre: Point::default(), sense: 1.0 };
        let quarter = Way { from: Point::new(5.0, 0.0), to: Point::new(0.0, 5.0), arc: Some(arc) };
        let inside = Way { from: Point::new(4.0, 0.0), to: Point::new(0.0, 4.0), arc: Some(arc) };
        assert_eq!(quarter.beside(1.0), Some(inside));
        assert_eq!(quarter.beside(5.0), None);
    }
}

//! The centre of an arc by its radius, in a plane of the C axis (E100L-CGF-04, E100L-CGS-04).

use super::plane::PlanePoint;
use crate::fault::{Fault, Outcome, fail};
use crate::quantity::{Exact, narrow, ratio, whole};
use crate::real::{self, Interval};
use crate::vocabulary::{AlarmName, RuleId, Sense};

/// An arc of less than 180 degrees, or half a circle.
#[derive(Clone, Copy, Debug)]
pub struct Arc {
    /// Where it starts.
    pub start: PlanePoint,
    /// Where it ends.
    pub end: PlanePoint,
    /// L, positive.
    pub radius: i64,
    /// The way round.
    pub sense: Sense,
}

impl Arc {
    /// Its centre, latched. `chord_square` is the square of the exact distance of its ends, `rule` the one of its alarms.
    pub fn centre(&self, chord_square: impl Fn(usize) -> Interval, rule: RuleId) -> Outcome<PlanePoint> {
        let Self { start, end, radius, sense } = *self;
        if start == end {
            return Err(Fault::about(AlarmName::Unspecified, rule, "circle"));
        }
        let square = whole(radius) * whole(radius);
        // L² - q²/4.
        let rest = |precision: usize| Interval::of(&square, precision).sub(&chord_square(precision).over(4));
        if real::sign(rest).is_lt() {
            return fail(AlarmName::ArcRadiusTooSmall, rule);
        }
        let height = real::nearest_whole(|precision| rest(precision).sqrt());
        // left(E - S), towards the centre.
        let side = if sense == Sense::CounterClockwise { 1 } else { -1 };
        let (left_p, left_q) = (side * (start.q - end.q), side * (end.p - start.p));
        let length_square = start.distance_square(end);
        let coordinate = |start: i64, end: i64, left: i64| {
            let step = Exact::from(&height * left);
            let offset_square = &step * &step / &length_square;
            let middle = ratio(start + end, 2);
            narrow(&real::nearest_whole(|precision| {
                let offset = Interval::of(&offset_square, precision).sqrt();
                let offset = if left < 0 { offset.neg() } else { offset };
                Interval::of(&middle, precision).add(&offset)
            }))
        };
        Ok(PlanePoint { p: coordinate(start.p, end.p, left_p), q: coordinate(start.q, end.q, left_q) })
    }
}

#[cfg(test)]
mod tests {
    use super::{Arc, PlanePoint};
    use crate::quantity::whole;
    use crate::real::Interval;
    use crate::vocabulary::Sense;
    use crate::vocabulary::rule_ids::CGF_04;

    fn centre(start: (i64, i64), end: (i64, i64), radius: i64, sense: Sense) -> Option<(i64, i64)> {
        let at = |(p, q): (i64, i64)| PlanePoint { p, q };
        let arc = Arc { start: at(start), end: at(end), radius, sense };
        let (p, q) = (end.0 - start.0, end.1 - start.1);
        let square = whole(p * p + q * q);
        let found = arc.centre(|precision| Interval::of(&square, precision), CGF_04);
        found.ok().map(|centre| (centre.p, centre.q))
    }

    #[test]
    fn the_centre_lies_on_the_side_of_the_sense() {
        use Sense::{Clockwise, CounterClockwise};
        assert_eq!(centre((0, 0), (6, 0), 5, CounterClockwise), Some((3, 4)));
        assert_eq!(centre((0, 0), (6, 0), 5, Clockwise), Some((3, -4)));
        assert_eq!(centre((6, 8), (0, 0), 5, Clockwise), Some((3, 4)));
        // Half a nanometre is rounded away from zero.
        assert_eq!(centre((0, 0), (0, 1), 5, Clockwise), Some((5, 1)));
        assert_eq!(centre((0, 0), (0, -1), 5, Clockwise), Some((-5, -1)));
        // The radius is too small; no travel.
        assert_eq!(centre((0, 0), (6, 8), 4, Clockwise), None);
        assert_eq!(centre((6, 8), (6, 8), 4, Clockwise), None);
    }
}

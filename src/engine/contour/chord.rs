//! The exact distance of start and end of an arc, and how far its centre lies from the chord (execution of contours,
//! 4; E100L-CGF-04, E100L-CGS-04).

use std::cmp::Ordering;

use crate::engine::arithmetic::contour::twice_cosine;
use crate::engine::arithmetic::root::root_over;
use crate::engine::exact::{Approx, Formula, Real, SlowPaths, round, sign};

/// Four times the square of the distance, in nanometres.
#[derive(Clone, Copy, Debug)]
pub enum Chord {
    /// A whole number.
    Whole(i128),
    /// squares - product cos angle: on the face, by diameters and the angle between them.
    Angle { squares: i128, product: i128, angle: i64 },
    /// (π turned / 180 000 000)² + rise: on a cylinder, by its diameter times the turn, and the square along Z.
    Cylinder { turned: i128, rise: i128 },
}

impl Chord {
    /// Between two diameters of the face with an angle between them.
    pub fn on_face(start: i64, end: i64, angle: i64) -> Self {
        let (start, end) = (i128::from(start), i128::from(end));
        let (squares, product) = (start * start + end * end, start * end);
        match twice_cosine(angle) {
            Some(twice) => Self::Whole(squares - product * i128::from(twice)),
            None => Self::Angle { squares, product: 2 * product, angle },
        }
    }

    /// On the cylinder of a diameter, by a turn of C and a travel of Z.
    pub fn on_side(diameter: i64, turn: i64, travel: i64) -> Self {
        let travel = i128::from(travel);
        let (turned, rise) = (i128::from(diameter) * i128::from(turn), 4 * travel * travel);
        if turned == 0 { Self::Whole(rise) } else { Self::Cylinder { turned, rise } }
    }

    /// How far the centre of an arc with this chord and a radius lies from it, latched; none when the radius is less
    /// than half of it.
    pub fn height(self, radius: i64, slow: &mut SlowPaths) -> Option<i64> {
        let diameters = 16 * i128::from(radius) * i128::from(radius);
        if let Self::Whole(square) = self {
            let room = u128::try_from(diameters - square).ok()?;
            return Some(root_over(room, 4));
        }
        let room = Room { chord: self, diameters };
        let fast = room.value::<Approx>(());
        if fast.certain_sign().unwrap_or_else(|| sign(&room, slow)) == Ordering::Less {
            return None;
        }
        let height = fast.root().over(&Approx::integer(4, ()));
        Some(height.certain_round().unwrap_or_else(|| round(&Height(room), slow)))
    }
}

/// 16 L² - 4 q².
struct Room {
    chord: Chord,
    diameters: i128,
}

impl Formula for Room {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        match self.chord {
            Chord::Whole(square) => integer(self.diameters - square),
            Chord::Angle { squares, product, angle } => {
                let (_, cosine) = R::sine_cosine(angle, precision);
                integer(self.diameters - squares).plus(&integer(product).times(&cosine))
            }
            Chord::Cylinder { turned, rise } => {
                let turn = integer(turned).times(&R::pi(precision)).over(&integer(180_000_000));
                integer(self.diameters - rise).minus(&turn.times(&turn))
            }
        }
    }
}

/// root(16 L² - 4 q²) / 4.
struct Height(Room);

impl Formula for Height {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        self.0.value::<R>(precision).root().over(&R::integer(4, precision))
    }
}

#[cfg(test)]
mod tests {
    use super::{Chord, SlowPaths};

    #[test]
    fn heights() {
        let slow = &mut SlowPaths::default();
        // q = 50, L = 50; half a circle; one nanometre too little for it.
        assert_eq!(
            Chord::on_face(100_000_000, 100_000_000, 60_000_000).height(50_000_000, slow),
            Some(43_301_270)
        );
        let half = Chord::on_face(100_000_000, 100_000_000, 180_000_000);
        assert_eq!((half.height(50_000_000, slow), half.height(49_999_999, slow)), (Some(0), None));
        // q = 2 * 50 sin 20 = 34.202..., L = 20.
        let chord = Chord::on_face(100_000_000, 100_000_000, 40_000_000);
        assert_eq!(chord.height(20_000_000, slow), Some(10_370_899));
        assert_eq!((chord.height(17_101_007, slow), chord.height(17_101_008, slow)), (None, Some(5340)));
        // On Ø100, by 60 degrees and 30 mm.
        let chord = Chord::on_side(100_000_000, 60_000_000, -30_000_000);
        assert_eq!(chord.height(60_000_000, slow), Some(51_861_458));
    }
}

//! Points of a contour in the order in which it is run through, and what lies at a level (execution-lap.md, section 8).

use super::contour::{Outline, Piece};
use super::number::Number;
use super::plane::{Place, Plane};
use crate::quantity::Exact;

/// A contour by its pieces. One without pieces has none of the points.
#[derive(Clone, Debug)]
pub struct Course {
    pieces: Vec<Piece>,
}

/// A point of a contour.
#[derive(Clone, Debug)]
pub struct Stop {
    /// The piece on which it lies, by number.
    piece: usize,
    /// The point.
    pub place: Place,
}

/// A part of an element that is run along.
#[derive(Clone, Debug)]
pub struct Stretch {
    /// The element, by number.
    pub element: usize,
    /// Where it ends.
    pub to: Place,
}

impl Stop {
    /// Whether it lies behind another one.
    pub fn is_behind(&self, other: &Self) -> bool {
        (self.piece, &self.place.run) > (other.piece, &other.place.run)
    }
}

impl Course {
    /// The pieces of a contour.
    pub fn new(outline: &Outline, plane: Plane) -> Self {
        Self { pieces: outline.pieces(plane) }
    }

    /// Where it starts.
    pub fn start(&self) -> Option<Stop> {
        self.begin_of(0)
    }

    /// Where it ends.
    pub fn end(&self) -> Option<Stop> {
        let last = self.pieces.last()?;
        Some(Stop { piece: self.pieces.len() - 1, place: last.to.clone() })
    }

    fn begin_of(&self, piece: usize) -> Option<Stop> {
        self.pieces.get(piece).map(|each| Stop { piece, place: each.from.clone() })
    }

    /// The pieces from a point on, each with its number and the height where it begins then.
    fn from<'c>(&'c self, stop: &'c Stop) -> impl Iterator<Item = (usize, &'c Piece, &'c Number)> {
        let pieces = self.pieces.iter().enumerate().skip(stop.piece);
        pieces.map(|(number, piece)| {
            let begins_here = number == stop.piece;
            (number, piece, if begins_here { &stop.place.height } else { &piece.from.height })
        })
    }

    /// up(p, y): the first point at or behind p that is not below y.
    pub fn up(&self, from: &Stop, level: &Exact) -> Option<Stop> {
        let height = Number::from(level.clone());
        if from.place.height >= height {
            return Some(from.clone());
        }
        let (piece, found, _) = self.from(from).find(|(_, piece, _)| piece.to.height >= height)?;
        Some(Stop { piece, place: found.at_level(level) })
    }

    /// down(p, y): the first point at or behind p, itself not below y, behind which the contour falls below y at once.
    pub fn down(&self, from: &Stop, level: &Exact) -> Option<Stop> {
        let height = Number::from(level.clone());
        let falls = |begin: &Number, piece: &Piece| *begin >= height && piece.to.height < height;
        let (piece, found, _) = self.from(from).find(|(_, piece, begin)| falls(begin, piece))?;
        Some(Stop { piece, place: found.at_level(level) })
    }

    /// The first point not below y behind the one in which the contour has fallen below it.
    pub fn up_behind(&self, fallen: &Stop, level: &Exact) -> Option<Stop> {
        self.begin_of(fallen.piece + 1).and_then(|next| self.up(&next, level))
    }

    /// above(p, y): the first point behind p, not below y, before which, from p on, there is a point below y.
    pub fn above(&self, from: &Stop, level: &Exact) -> Option<Stop> {
        if from.place.height < Number::from(level.clone()) {
            return self.up(from, level);
        }
        self.down(from, level).and_then(|fallen| self.up_behind(&fallen, level))
    }

    /// The parts of elements from one point to another.
    pub fn along(&self, from: &Stop, to: &Stop) -> Vec<Stretch> {
        let mut stretches: Vec<Stretch> = Vec::new();
        for (number, piece, _) in self.from(from).take_while(|(number, ..)| *number <= to.piece) {
            let end = if number == to.piece { &to.place } else { &piece.to };
            match stretches.last_mut() {
                Some(last) if last.element == piece.element => last.to = end.clone(),
                _ => stretches.push(Stretch { element: piece.element, to: end.clone() }),
            }
        }
        stretches
    }

    /// The highest height from one point to another.
    pub fn highest(&self, from: &Stop, to: &Stop) -> Number {
        let highest = from.place.height.clone().max(to.place.height.clone());
        let inner = self.pieces.iter().take(to.piece).skip(from.piece);
        inner.fold(highest, |highest, piece| highest.max(piece.to.height.clone()))
    }

    /// The highest height of all.
    pub fn top(&self) -> Option<Number> {
        let (start, end) = (self.start()?, self.end()?);
        Some(self.highest(&start, &end))
    }

    /// E100L-AP1-13: how many falling slopes there are; what is level does not count.
    pub fn descents(&self) -> usize {
        let mut falling = false;
        let mut count = 0;
        for piece in &self.pieces {
            if piece.falls() && !falling {
                count += 1;
            }
            falling = !piece.rises() && (falling || piece.falls());
        }
        count
    }

    /// E100L-AP4-05: the runs from and to which it is above a level.
    pub fn above_level(&self, level: &Exact) -> Vec<(Number, Number)> {
        let height = Number::from(level.clone());
        let mut stretches = Vec::new();
        let mut begun: Option<Number> = None;
        if let Some(first) = self.pieces.first().filter(|first| first.from.height > height) {
            begun = Some(first.from.run.clone());
        }
        for piece in &self.pieces {
            let is_above = piece.to.height > height;
            match (&begun, is_above) {
                (None, true) => begun = Some(piece.at_level(level).run),
                (Some(from), false) => {
                    stretches.push((from.clone(), piece.at_level(level).run));
                    begun = None;
                }
                (None, false) | (Some(_), true) => {}
            }
        }
        if let (Some(from), Some(end)) = (begun, self.end()) {
            stretches.push((from, end.place.run));
        }
        stretches
    }
}

//! Points of an outline where levels meet it (execution of LAP, 8, "Points of the contour").
//!
//! Along a slope heights change in one sense, so that the first piece which reaches a level is found by halving.

use std::cmp::Ordering;

use crate::engine::arithmetic::plane::Point;
use crate::engine::exact::SlowPaths;

use super::outline::{Outline, Piece, Slope};
use super::value::Value;

/// A point of an outline: the start of a piece, or the point at a level on it; behind the last piece the end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Place {
    pub piece: usize,
    /// The coordinate of the level, and its height.
    pub level: Option<(i64, i128)>,
}

impl Place {
    /// The start of a piece.
    pub fn start_of(piece: usize) -> Self {
        Self { piece, level: None }
    }

    /// Whether it comes before another place that is not the same point.
    pub fn is_before(self, other: Self) -> bool {
        (self.piece, self.level.is_some()) < (other.piece, other.level.is_some())
    }
}

impl Outline {
    /// The level of a coordinate on the infeed axis.
    pub fn level(&self, coordinate: i64) -> (i64, i128) {
        (coordinate, self.axes.height(coordinate))
    }

    /// The end.
    pub fn last_place(&self) -> Place {
        Place::start_of(self.pieces.len())
    }

    /// The height of a place.
    pub fn height(&self, place: Place) -> Value {
        match (place.level, self.pieces.get(place.piece), self.pieces.last()) {
            (Some((_, height)), ..) => Value::whole(height),
            (None, Some(piece), _) => piece.start(),
            (None, None, Some(last)) => last.end(),
            (None, None, None) => Value::whole(self.axes.spot(self.start).height),
        }
    }

    /// The run of a place.
    pub fn run(&self, place: Place) -> Value {
        match (place.level, self.pieces.get(place.piece), self.pieces.last()) {
            (Some((_, height)), Some(piece), _) => piece.run_at(height),
            (_, Some(piece), _) => Value::whole(piece.from.run),
            (_, None, Some(last)) => Value::whole(last.to.run),
            (_, None, None) => Value::whole(self.axes.spot(self.start).run),
        }
    }

    /// The point of a place, latched.
    pub fn point(&self, place: Place) -> Point {
        match place.level {
            Some((coordinate, _)) => self.axes.point(coordinate, self.axes.latch_run(self.run(place))),
            None => match self.pieces.get(place.piece).and_then(|piece| self.elements.get(piece.element)) {
                Some(element) => element.from,
                None => self.end(),
            },
        }
    }

    /// The slopes from that of a piece on, with their parts behind its start.
    fn slopes_from(&self, piece: usize) -> impl Iterator<Item = Slope> + '_ {
        let first = self.slopes.partition_point(|slope| slope.end <= piece);
        let slopes = self.slopes.get(first..).unwrap_or_default();
        slopes.iter().map(move |slope| Slope { first: slope.first.max(piece), ..*slope })
    }

    fn pieces_of(&self, slope: Slope) -> &[Piece] {
        self.pieces.get(slope.first..slope.end).unwrap_or_default()
    }

    /// The first point at or behind a place that is not below a level.
    pub fn up(&self, from: Place, level: (i64, i128)) -> Option<Place> {
        if self.height(from).cmp_whole(level.1) == Ordering::Less {
            return self.rise(from.piece, level);
        }
        Some(from)
    }

    /// The first point not below a level, from a point of a piece on that is below it.
    pub fn rise(&self, piece: usize, level: (i64, i128)) -> Option<Place> {
        for slope in self.slopes_from(piece).filter(|slope| slope.rises) {
            let pieces = self.pieces_of(slope);
            let below = |piece: &Piece| piece.end().cmp_whole(level.1) == Ordering::Less;
            let place = slope.first + pieces.partition_point(below);
            let Some(found) = self.pieces.get(place).filter(|_| place < slope.end) else { continue };
            let at_end = !found.to_top && found.to.height == level.1;
            return Some(match at_end {
                true => Place::start_of(place + 1),
                false => Place { piece: place, level: Some(level) },
            });
        }
        None
    }

    /// The first point at or behind a place, itself not below a level, behind which the outline falls below it at
    /// once; the place itself is not below it.
    pub fn down(&self, from: Place, level: (i64, i128)) -> Option<Place> {
        for slope in self.slopes_from(from.piece).filter(|slope| !slope.rises) {
            let pieces = self.pieces_of(slope);
            let not_below = |piece: &Piece| piece.end().cmp_whole(level.1) != Ordering::Less;
            let place = slope.first + pieces.partition_point(not_below);
            let Some(found) = self.pieces.get(place).filter(|_| place < slope.end) else { continue };
            let at_start = !found.from_top && found.from.height == level.1;
            return Some(match at_start {
                true => Place::start_of(place),
                false => Place { piece: place, level: Some(level) },
            });
        }
        None
    }

    /// The first point behind a place, not below a level, before which there is a point below it.
    pub fn above(&self, from: Place, level: (i64, i128)) -> Option<Place> {
        if self.height(from).cmp_whole(level.1) == Ordering::Less {
            return self.rise(from.piece, level);
        }
        let fallen = self.down(from, level)?;
        self.rise(fallen.piece, level)
    }

    /// The highest height from a place on.
    pub fn highest_from(&self, from: Place, slow: &mut SlowPaths) -> Value {
        let peaks = self.slopes_from(from.piece).filter(|slope| slope.rises);
        let peaks = peaks.filter_map(|slope| self.pieces.get(slope.end.saturating_sub(1)).map(Piece::end));
        peaks.fold(self.height(from), |highest, peak| highest.max(peak, slow))
    }
}

//! A contour or a blank: its elements, and the pieces of them along which heights change in one sense (execution of
//! LAP, 8, "Direction", "Pieces" and "Descents").

use std::cmp::Ordering;

use turnspec_oracle::vocabulary::Sense;

use crate::engine::arithmetic::lap;
use crate::engine::arithmetic::plane::Point;
use crate::engine::arithmetic::surd;
use crate::engine::state::StoredFeed;

use super::definition::{Course, Recorded};
use super::plane::{Axes, Spot};
use super::value::Value;

/// A line or an arc, in program coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Element {
    pub from: Point,
    pub to: Point,
    pub arc: Option<(Sense, Point)>,
    /// E, where one was recorded.
    pub feed: Option<StoredFeed>,
    /// Whether compensation was in force in its block.
    pub compensated: bool,
}

impl Element {
    /// A line that no block has written.
    pub fn line(from: Point, to: Point) -> Self {
        Self { from, to, arc: None, feed: None, compensated: false }
    }

    /// A recorded motion from a point.
    pub fn recorded(from: Point, motion: &Recorded) -> Self {
        let arc = match motion.course {
            Course::Arc { sense, centre } => Some((sense, centre)),
            _ => None,
        };
        Self { from, to: motion.end, arc, feed: motion.feed, compensated: motion.compensated }
    }

    /// The element moved as a whole.
    pub fn moved(self, by: Point) -> Self {
        let arc = self.arc.map(|(sense, centre)| (sense, centre.plus(by)));
        Self { from: self.from.plus(by), to: self.to.plus(by), arc, ..self }
    }
}

/// The circle of an arc through its start, and the part of it on which a piece lies.
#[derive(Clone, Copy, Debug)]
pub struct Circle {
    pub centre: Spot,
    /// The square of its radius.
    pub square: i128,
    /// 1 over the centre, -1 under it.
    pub up: i8,
    /// 1 behind the centre, -1 before it.
    pub side: i8,
}

/// A part of an element along which heights change in one sense.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub element: usize,
    pub from: Spot,
    pub to: Spot,
    /// Whether it begins, or ends, over or under the centre of its arc; the height there is not that of the spot.
    pub from_top: bool,
    pub to_top: bool,
    pub circle: Option<Circle>,
}

impl Piece {
    /// The height where it begins.
    pub fn start(&self) -> Value {
        self.height_at(self.from, self.from_top)
    }

    /// The height where it ends.
    pub fn end(&self) -> Value {
        self.height_at(self.to, self.to_top)
    }

    fn height_at(&self, spot: Spot, top: bool) -> Value {
        match self.circle.filter(|_| top) {
            Some(Circle { centre, square, up, .. }) => Value::Root { whole: centre.height, side: up, square },
            None => Value::whole(spot.height),
        }
    }

    /// How the heights change along it.
    pub fn change(&self) -> Ordering {
        match (self.circle, self.from_top, self.to_top) {
            (Some(circle), true, _) => {
                surd::sign(circle.centre.height - self.to.height, circle.up.into(), circle.square).reverse()
            }
            (Some(circle), _, true) => {
                surd::sign(circle.centre.height - self.from.height, circle.up.into(), circle.square)
            }
            _ => self.to.height.cmp(&self.from.height),
        }
    }

    /// The run of its point at a level.
    pub fn run_at(&self, level: i128) -> Value {
        for (spot, top) in [(self.from, self.from_top), (self.to, self.to_top)] {
            if !top && spot.height == level {
                return Value::whole(spot.run);
            }
        }
        let Some(circle) = self.circle else {
            let rise = self.to.height - self.from.height;
            if rise == 0 {
                return Value::whole(self.from.run);
            }
            let turned = |spot: Spot| (spot.height, spot.run);
            let (over, under) = lap::across(turned(self.from), turned(self.to), level);
            return Value::ratio(over, under);
        };
        let above = level - circle.centre.height;
        let square = (circle.square - above * above).max(0);
        let run = Value::Root { whole: circle.centre.run, side: circle.side, square };
        if run.cmp_whole(self.from.run) == Ordering::Less {
            Value::whole(self.from.run)
        } else if run.cmp_whole(self.to.run) == Ordering::Greater {
            Value::whole(self.to.run)
        } else {
            run
        }
    }
}

/// Pieces in a row whose heights change in one sense, level ones among them.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    pub first: usize,
    /// Behind its last piece.
    pub end: usize,
    pub rises: bool,
}

/// A contour or a blank.
#[derive(Debug)]
pub struct Outline {
    pub axes: Axes,
    pub start: Point,
    pub elements: Vec<Element>,
    pub pieces: Vec<Piece>,
    /// The first piece of each element.
    pub first_pieces: Vec<usize>,
    pub slopes: Vec<Slope>,
}

impl Outline {
    /// The outline of elements in a row from a point on.
    pub fn new(axes: Axes, start: Point, elements: Vec<Element>) -> Self {
        let mut outline = Self {
            axes,
            start,
            elements: Vec::new(),
            pieces: Vec::with_capacity(elements.len()),
            first_pieces: Vec::with_capacity(elements.len()),
            slopes: Vec::new(),
        };
        for (number, element) in elements.iter().enumerate() {
            outline.first_pieces.push(outline.pieces.len());
            outline.add_pieces(number, element);
        }
        outline.elements = elements;
        outline.find_slopes();
        outline
    }

    /// Where it ends.
    pub fn end(&self) -> Point {
        self.elements.last().map_or(self.start, |element| element.to)
    }

    fn add_pieces(&mut self, number: usize, element: &Element) {
        let (from, to) = (self.axes.spot(element.from), self.axes.spot(element.to));
        let mut piece = Piece { element: number, from, to, from_top: false, to_top: false, circle: None };
        if let Some((sense, centre)) = element.arc {
            let centre = self.axes.spot(centre);
            let (along, across) = (from.run - centre.run, from.height - centre.height);
            let clockwise = (sense == Sense::Clockwise) == self.axes.keeps_sense();
            let circle = Circle {
                centre,
                square: along * along + across * across,
                up: if clockwise { 1 } else { -1 },
                side: if centre.run <= from.run { 1 } else { -1 },
            };
            piece.circle = Some(circle);
            if from.run < centre.run && centre.run < to.run {
                self.pieces.push(Piece { to: centre, to_top: true, ..piece });
                piece = Piece {
                    from: centre,
                    from_top: true,
                    circle: Some(Circle { side: 1, ..circle }),
                    ..piece
                };
            }
        }
        self.pieces.push(piece);
    }

    /// Groups the pieces by how they change heights.
    fn find_slopes(&mut self) {
        let mut slope: Option<Slope> = None;
        let mut known = false;
        for (place, piece) in self.pieces.iter().enumerate() {
            let change = piece.change();
            let rises = change == Ordering::Greater;
            match &mut slope {
                None => slope = Some(Slope { first: place, end: place + 1, rises }),
                Some(slope) if change == Ordering::Equal || known && slope.rises == rises => {
                    slope.end = place + 1;
                }
                Some(slope) if !known => *slope = Slope { end: place + 1, rises, ..*slope },
                Some(slope) => {
                    self.slopes.push(*slope);
                    *slope = Slope { first: place, end: place + 1, rises };
                }
            }
            known |= change != Ordering::Equal;
        }
        self.slopes.extend(slope);
    }

    /// How many falling slopes there are (E100L-AP1-13).
    pub fn descents(&self) -> usize {
        let falls = |slope: &&Slope| {
            let pieces = self.pieces.get(slope.first..slope.end).unwrap_or_default();
            !slope.rises && pieces.iter().any(|piece| piece.change() == Ordering::Less)
        };
        self.slopes.iter().filter(falls).count()
    }

    /// Whether it never runs back (E100L-AP1-02, E100L-AP5-08).
    pub fn runs_forward(&self) -> bool {
        let mut wall = Ordering::Equal;
        for element in &self.elements {
            let (from, to) = (self.axes.spot(element.from), self.axes.spot(element.to));
            if let Some((sense, centre)) = element.arc {
                let centre = self.axes.spot(centre);
                let clockwise = (sense == Sense::Clockwise) == self.axes.keeps_sense();
                let fits = |height: i128| {
                    if clockwise { height >= centre.height } else { height <= centre.height }
                };
                if to.run <= from.run || !fits(from.height) || !fits(to.height) {
                    return false;
                }
                wall = Ordering::Equal;
                continue;
            }
            if to.run < from.run {
                return false;
            }
            let along = if to.run > from.run { Ordering::Equal } else { to.height.cmp(&from.height) };
            if wall != Ordering::Equal && along == wall.reverse() {
                return false;
            }
            wall = along;
        }
        true
    }

    /// Behind the last piece of an element.
    pub fn end_of_element(&self, element: usize) -> usize {
        self.first_pieces.get(element + 1).copied().unwrap_or(self.pieces.len())
    }
}

/// The elements behind the first motion, which ends in a point.
pub fn elements(first: Point, motions: &[Recorded]) -> impl Iterator<Item = Element> + '_ {
    motions.iter().skip(1).scan(first, |from, motion| {
        let element = Element::recorded(*from, motion);
        *from = motion.end;
        Some(element)
    })
}

/// The elements of a blank between the start of the contour and its end (E100L-LAP-02).
pub fn blank_elements(axes: Axes, start: Point, end: Point, motions: &[Recorded]) -> Vec<Element> {
    let Some(first) = motions.first() else { return Vec::new() };
    let mut all = vec![Element::line(start, first.end)];
    all.extend(elements(first.end, motions));
    let last = motions.last().map_or(first.end, |motion| motion.end);
    if axes.spot(end).run >= axes.spot(last).run {
        all.push(Element::line(last, end));
    }
    all.retain(|element| element.arc.is_some() || element.from != element.to);
    all
}

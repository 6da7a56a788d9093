//! Contours and blanks of a cycle: their elements in the plane, and the pieces along which heights change in one sense
//! (execution-lap.md, sections 5 and 8).

use super::number::Number;
use super::plane::{Place, Plane, Spot};
use super::recording::{Kind, Recorded};
use crate::quantity::Exact;
use crate::state::StoredFeed;
use crate::vocabulary::Sense;

/// An element of a contour or a blank, in its place.
#[derive(Clone, Debug)]
pub struct Element {
    /// Where it ends.
    pub end: Spot,
    /// Its centre and sense, if it is an arc.
    pub arc: Option<(Spot, Sense)>,
    /// The E recorded with it.
    pub feed: Option<StoredFeed>,
    /// Whether G41 or G42 was in force in its block.
    pub compensated: bool,
}

/// A contour or a blank: where it starts, and its elements.
#[derive(Clone, Debug)]
pub struct Outline {
    /// The start.
    pub start: Spot,
    /// The elements.
    pub elements: Vec<Element>,
}

impl Outline {
    /// The contour of recorded motions: the first one leads to its start.
    pub fn of_contour(motions: &[Recorded], plane: Plane) -> Self {
        let start = motions.first().map_or((0, 0), |first| first.end);
        let elements = motions.iter().skip(1).map(|motion| element(motion, plane)).collect();
        Self { start: plane.spot(start), elements }
    }

    /// E100L-LAP-02: the blank of recorded motions in front of a contour, with the lines that are added: from where the
    /// contour is programmed to start, to where it is programmed to end.
    pub fn of_blank(motions: &[Recorded], contour: &[Recorded], plane: Plane) -> Self {
        let mut elements: Vec<Element> = motions.iter().map(|motion| element(motion, plane)).collect();
        let programmed =
            |motion: Option<&Recorded>| plane.spot(motion.map_or((0, 0), |motion| motion.programmed));
        let (start, to) = (programmed(contour.first()), programmed(contour.last()));
        let end = elements.last().map_or(start, |last| last.end);
        if plane.run(to.cutting) >= plane.run(end.cutting) {
            elements.push(Element { end: to, arc: None, feed: None, compensated: false });
        }
        Self { start, elements }.without_standing()
    }

    /// Without lines that have no travel.
    pub fn without_standing(mut self) -> Self {
        let mut present = self.start;
        self.elements.retain(|element| {
            let from = std::mem::replace(&mut present, element.end);
            element.arc.is_some() || element.end != from
        });
        self
    }

    /// Where it ends.
    pub fn end(&self) -> Spot {
        self.elements.last().map_or(self.start, |last| last.end)
    }

    /// The same elsewhere.
    pub fn moved(mut self, infeed: i64, cutting: i64) -> Self {
        let shift = |spot: &mut Spot| {
            spot.infeed += infeed;
            spot.cutting += cutting;
        };
        shift(&mut self.start);
        for element in &mut self.elements {
            shift(&mut element.end);
            if let Some((centre, _)) = &mut element.arc {
                shift(centre);
            }
        }
        self
    }

    /// Whether it runs in the direction of cutting: no element goes back, and no wall is run up and down.
    pub fn runs_onward(&self, plane: Plane) -> bool {
        let (mut from, mut wall) = (self.start, 0);
        for element in &self.elements {
            if !goes_onward(from, element, plane) {
                return false;
            }
            let rise = (plane.height(element.end.infeed) - plane.height(from.infeed)).sign_of();
            let is_wall = element.end.cutting == from.cutting;
            if is_wall && wall * rise < 0 {
                return false;
            }
            wall = if is_wall { rise } else { 0 };
            from = element.end;
        }
        true
    }

    /// Its pieces, in order.
    pub fn pieces(&self, plane: Plane) -> Vec<Piece> {
        let mut from = self.start;
        let mut pieces = Vec::new();
        for (index, element) in self.elements.iter().enumerate() {
            pieces.extend(Piece::of(index, from, element, plane));
            from = element.end;
        }
        pieces
    }
}

fn element(motion: &Recorded, plane: Plane) -> Element {
    let arc = match motion.kind {
        Kind::Arc(centre, sense) => Some((plane.spot(centre), sense)),
        _ => None,
    };
    Element { end: plane.spot(motion.end), arc, feed: motion.feed, compensated: motion.compensated }
}

/// The sign of a number as a whole one.
pub trait SignOf {
    /// -1, 0 or 1.
    fn sign_of(&self) -> i64;
}

impl SignOf for Exact {
    fn sign_of(&self) -> i64 {
        self.cmp(&Exact::ZERO) as i64
    }
}

/// Whether an arc runs over its centre, seen with runs to the right and heights up: clockwise.
pub fn is_clockwise(sense: Sense, plane: Plane) -> bool {
    let kept = plane.onward * plane.up == if plane.transverse { -1 } else { 1 };
    (sense == Sense::Clockwise) == kept
}

fn goes_onward(from: Spot, element: &Element, plane: Plane) -> bool {
    let (start, end) = (plane.run(from.cutting), plane.run(element.end.cutting));
    let Some((centre, sense)) = element.arc else { return end >= start };
    let clockwise = is_clockwise(sense, plane);
    let middle = plane.height(centre.infeed);
    let on_its_side = |spot: Spot| {
        let height = plane.height(spot.infeed);
        if clockwise { height >= middle } else { height <= middle }
    };
    on_its_side(from) && on_its_side(element.end) && end > start
}

/// A part of an element along which heights change in one sense.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Where it begins.
    pub from: Place,
    /// Where it ends.
    pub to: Place,
    /// The circle that it is a part of, if it is no line.
    pub circle: Option<Circle>,
    /// The element, by number.
    pub element: usize,
}

/// The circle through the start of an arc.
#[derive(Clone, Debug)]
pub struct Circle {
    /// The run of its centre.
    pub run: Exact,
    /// The height of its centre.
    pub height: Exact,
    /// The square of its radius.
    pub square: Exact,
    /// Whether the piece lies before the centre.
    pub before: bool,
}

impl Piece {
    fn of(element: usize, from: Spot, shape: &Element, plane: Plane) -> Vec<Self> {
        let (start, end) = (plane.place(from), plane.place(shape.end));
        let Some((centre, sense)) = shape.arc else {
            return vec![Self { from: start, to: end, circle: None, element }];
        };
        let (run, height) = (plane.run(centre.cutting), plane.height(centre.infeed));
        let (first, last) = (plane.run(from.cutting), plane.run(shape.end.cutting));
        let (aside, above) = (&first - &run, plane.height(from.infeed) - &height);
        let square = &aside * &aside + &above * &above;
        let over = is_clockwise(sense, plane);
        let circle = |before| {
            Some(Circle { run: run.clone(), height: height.clone(), square: square.clone(), before })
        };
        if first < run && run < last {
            let sign = if over { Exact::ONE } else { -Exact::ONE };
            let top = Number::new(height.clone(), sign, square.clone());
            let top = Place { run: run.clone().into(), height: top };
            let before = Self { from: start, to: top.clone(), circle: circle(true), element };
            return vec![before, Self { from: top, to: end, circle: circle(false), element }];
        }
        vec![Self { from: start, to: end, circle: circle(last <= run), element }]
    }

    /// Whether it falls.
    pub fn falls(&self) -> bool {
        self.to.height < self.from.height
    }

    /// Whether it rises.
    pub fn rises(&self) -> bool {
        self.to.height > self.from.height
    }

    /// The point at a level, which lies between the heights of the ends or is one of them.
    pub fn at_level(&self, level: &Exact) -> Place {
        let height = Number::from(level.clone());
        if self.from.height == height {
            return self.from.clone();
        }
        if self.to.height == height {
            return self.to.clone();
        }
        let run = match &self.circle {
            None => self.on_line(level),
            Some(circle) => {
                let above = level - &circle.height;
                let side = if circle.before { -Exact::ONE } else { Exact::ONE };
                Number::new(circle.run.clone(), side, &circle.square - &above * &above)
            }
        };
        Place { run: run.max(self.from.run.clone()).min(self.to.run.clone()), height }
    }

    /// The run of a line at a level; its ends are rational.
    fn on_line(&self, level: &Exact) -> Number {
        let (from, to) = (&self.from, &self.to);
        let (Some(low), Some(high)) = (from.height.rational(), to.height.rational()) else {
            return from.run.clone();
        };
        let (Some(first), Some(last)) = (from.run.rational(), to.run.rational()) else {
            return from.run.clone();
        };
        let rise = high - low;
        if rise.is_zero() {
            return from.run.clone();
        }
        (first + (level - low) / rise * (last - first)).into()
    }
}

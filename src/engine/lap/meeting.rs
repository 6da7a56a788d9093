//! Where two spans meet, one of them lowered: exact points, at most two (execution of LAP, 12).
//!
//! Runs and heights are below 2^41, so that two lines meet in quotients of numbers below 2^125 and 2^83.

use std::cmp::Ordering;

use crate::engine::arithmetic::wide::product;
use crate::engine::exact::{Formula, Real, SlowPaths, round, sign};

use super::graph::Span;
use super::outline::Circle;
use super::plane::Spot;
use super::value::Value;

/// A point of a circle on a line `normal · (point - centre) = distance`: on the left of the normal (1), or on its
/// right (-1).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OnCircle {
    centre: Spot,
    square: i128,
    normal: Spot,
    distance: i128,
    side: i128,
}

/// A run or a height.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Coordinate {
    Value(Value),
    Run(OnCircle),
    Height(OnCircle),
}

/// A point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Meeting {
    pub run: Coordinate,
    pub height: Coordinate,
}

/// A coordinate less a whole number, or less another coordinate.
struct Gap(Coordinate, Coordinate);

impl Formula for Gap {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        self.0.real::<R>(precision).minus(&self.1.real::<R>(precision))
    }
}

/// (sign * (coordinate + more)) / divisor.
struct Scaled {
    coordinate: Coordinate,
    more: i128,
    sign: i64,
    divisor: i128,
}

impl Formula for Scaled {
    fn value<R: Real>(&self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let sum = self.coordinate.real::<R>(precision).plus(&integer(self.more));
        sum.times(&integer(self.sign.into())).over(&integer(self.divisor))
    }
}

impl Coordinate {
    /// A whole number.
    pub fn whole(value: i128) -> Self {
        Self::Value(Value::whole(value))
    }

    fn real<R: Real>(self, precision: R::Precision) -> R {
        let integer = |value| R::integer(value, precision);
        let (point, of_run) = match self {
            Self::Value(value) => return value.real::<R>(precision),
            Self::Run(point) => (point, true),
            Self::Height(point) => (point, false),
        };
        let OnCircle { centre, square, normal, distance, side } = point;
        let (origin, along, across) = match of_run {
            true => (centre.run, normal.run, -normal.height),
            false => (centre.height, normal.height, normal.run),
        };
        let length = integer(normal.run)
            .times(&integer(normal.run))
            .plus(&{ integer(normal.height).times(&integer(normal.height)) });
        let rest = integer(square).times(&length).minus(&integer(distance).times(&integer(distance)));
        let foot = integer(along).times(&integer(distance));
        let aside = integer(side * across).times(&rest.root());
        integer(origin).plus(&foot.plus(&aside).over(&length))
    }

    /// Compares it with a whole number.
    pub fn cmp_whole(self, with: i128, slow: &mut SlowPaths) -> Ordering {
        match self {
            Self::Value(value) => value.cmp_whole(with),
            _ => sign(&Gap(self, Self::whole(with)), slow),
        }
    }

    /// Compares two coordinates.
    pub fn cmp(self, other: Self, slow: &mut SlowPaths) -> Ordering {
        match (self, other) {
            (Self::Value(value), Self::Value(other)) => value.cmp(other, slow),
            _ if self == other => Ordering::Equal,
            _ => sign(&Gap(self, other), slow),
        }
    }

    /// The greater one.
    pub fn max(self, other: Self, slow: &mut SlowPaths) -> Self {
        if self.cmp(other, slow) == Ordering::Less { other } else { self }
    }

    /// As [`Value::latch`], with a whole number added before.
    pub fn latch(self, more: i128, sign: i64, is_length: bool, slow: &mut SlowPaths) -> i64 {
        match self {
            Self::Value(value) => value.plus(more).latch(sign, is_length),
            coordinate => {
                let divisor = if is_length { 2 } else { 1 };
                round(&Scaled { coordinate, more, sign, divisor }, slow)
            }
        }
    }
}

/// The points in which two spans meet, in the order of their runs.
#[derive(Clone, Copy, Default, Debug)]
pub struct Meetings {
    pub points: [Option<Meeting>; 2],
    /// Whether they touch in one point.
    pub touch: bool,
}

/// Where a span meets another one that is lowered.
fn meetings(first: &Span, second: &Span, drop: i128) -> Meetings {
    let lowered = |spot: Spot| Spot { height: spot.height - drop, ..spot };
    let (from, to) = (lowered(second.from), lowered(second.to));
    match (first.circle, second.circle) {
        (None, None) => lines((first.from, first.to), (from, to)),
        (Some(circle), None) => on_line(circle, from, to),
        (None, Some(circle)) => {
            on_line(Circle { centre: lowered(circle.centre), ..circle }, first.from, first.to)
        }
        (Some(circle), Some(other)) => circles(circle, Circle { centre: lowered(other.centre), ..other }),
    }
}

fn lines((from, to): (Spot, Spot), (from_2, to_2): (Spot, Spot)) -> Meetings {
    let (along, rise) = (to.run - from.run, to.height - from.height);
    let (along_2, rise_2) = (to_2.run - from_2.run, to_2.height - from_2.height);
    let under = along * rise_2 - rise * along_2;
    if under == 0 {
        return Meetings::default();
    }
    let over = (from_2.run - from.run) * rise_2 - (from_2.height - from.height) * along_2;
    let value = |from: i128, along: i128| Coordinate::Value(Value::ratio(from * under + along * over, under));
    let meeting = Meeting { run: value(from.run, along), height: value(from.height, rise) };
    Meetings { points: [Some(meeting), None], touch: false }
}

fn on_line(circle: Circle, from: Spot, to: Spot) -> Meetings {
    if from.height == to.height {
        return on_level(circle, from.height);
    }
    let normal = Spot { run: to.height - from.height, height: from.run - to.run };
    let (run, height) = (from.run - circle.centre.run, from.height - circle.centre.height);
    points(circle, normal, normal.run * run + normal.height * height)
}

/// The points of a circle on a level have its height, and runs with one root, which compare in whole numbers.
fn on_level(Circle { centre, square, .. }: Circle, height: i128) -> Meetings {
    let above = height - centre.height;
    let square = square - above * above;
    if square < 0 {
        return Meetings::default();
    }
    let point = |side| {
        let run = Coordinate::Value(Value::Root { whole: centre.run, side, square });
        Some(Meeting { run, height: Coordinate::whole(height) })
    };
    let touch = square == 0;
    Meetings { points: [point(-1), point(1).filter(|_| !touch)], touch }
}

fn circles(circle: Circle, other: Circle) -> Meetings {
    let (run, height) = (other.centre.run - circle.centre.run, other.centre.height - circle.centre.height);
    if (run, height) == (0, 0) {
        return Meetings::default();
    }
    let distance = circle.square - other.square + run * run + height * height;
    points(circle, Spot { run: 2 * run, height: 2 * height }, distance)
}

/// The points of a circle on a line.
fn points(circle: Circle, normal: Spot, distance: i128) -> Meetings {
    let length = normal.run * normal.run + normal.height * normal.height;
    let reach = product(circle.square.unsigned_abs(), length.unsigned_abs());
    let touch = match reach.cmp(&product(distance.unsigned_abs(), distance.unsigned_abs())) {
        Ordering::Less => return Meetings::default(),
        Ordering::Equal => true,
        Ordering::Greater => false,
    };
    let Circle { centre, square, .. } = circle;
    let point = |side| {
        let point = OnCircle { centre, square, normal, distance, side };
        Meeting { run: Coordinate::Run(point), height: Coordinate::Height(point) }
    };
    // To the left of the normal runs are less when its height is positive.
    let first = if normal.height > 0 { 1 } else { -1 };
    let second = if touch { None } else { Some(point(-first)) };
    Meetings { points: [Some(point(first)), second], touch }
}

impl Meetings {
    /// Where a span meets another one that is lowered, between two runs; each point keeps its number.
    pub fn between(
        (first, second, drop): (&Span, &Span, i128),
        (begin, end): (i128, i128),
        slow: &mut SlowPaths,
    ) -> Self {
        let covers = |span: &Span| span.from.run <= begin && end <= span.to.run;
        if covers(first) && covers(second) && second.is_apart(first.bounds, drop) {
            return Self::default();
        }
        let Self { points, touch } = meetings(first, second, drop);
        let on_side = |span: &Span, drop: i128, height: Coordinate, slow: &mut SlowPaths| {
            let Some(Circle { centre, up, .. }) = span.circle else { return true };
            let side = height.cmp_whole(centre.height - drop, slow);
            side != if up > 0 { Ordering::Less } else { Ordering::Greater }
        };
        let points = points.map(|point| {
            point.filter(|Meeting { run, height }| {
                run.cmp_whole(begin, slow) == Ordering::Greater
                    && run.cmp_whole(end, slow) == Ordering::Less
                    && on_side(first, 0, *height, slow)
                    && on_side(second, drop, *height, slow)
            })
        });
        Self { points, touch }
    }
}

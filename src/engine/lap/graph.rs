//! Contour and blank of mode V as graphs over their runs: elements with run are spans, those without stand in the
//! joints between them (execution of LAP, 12).

use turnspec_oracle::vocabulary::Sense;

use crate::engine::arithmetic::lap;

use super::outline::{Circle, Element};
use super::plane::{Axes, Spot};
use super::value::Value;

/// An element with run.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    /// Its number among the elements.
    pub element: usize,
    pub from: Spot,
    pub to: Spot,
    pub circle: Option<Circle>,
    /// Whole numbers between which its heights lie from end to end, the bounds included.
    pub bounds: (i128, i128),
}

impl Span {
    /// An element with run, by its ends.
    pub fn new(element: usize, (from, to): (Spot, Spot), circle: Option<Circle>) -> Self {
        let bounds = (from.height.min(to.height), from.height.max(to.height));
        let mut span = Self { element, from, to, circle, bounds };
        if circle.is_some() {
            let heights = [span.height(from.run), span.height(to.run)];
            let top = span.top().map_or(heights[0], |(_, height)| height);
            let whole = [heights[0], heights[1], top].map(|height| i128::from(height.latch(1, false)));
            let [low, high] = [whole.iter().min(), whole.iter().max()].map(|end| end.copied().unwrap_or(0));
            // Rounding moved none of them by more than a half.
            span.bounds = (low - 1, high + 1);
        }
        span
    }

    /// Whether all its heights, when it is lowered, lie below or above some bounds.
    #[inline]
    pub fn is_apart(&self, bounds: (i128, i128), drop: i128) -> bool {
        self.bounds.1 - drop < bounds.0 || bounds.1 < self.bounds.0 - drop
    }

    /// Its height at a run between its ends: of the line, or of the circle through its start.
    pub fn height(&self, run: i128) -> Value {
        match self.circle {
            Some(Circle { centre, square, up, .. }) => {
                let along = run - centre.run;
                Value::Root { whole: centre.height, side: up, square: (square - along * along).max(0) }
            }
            None => {
                let point = |spot: Spot| (spot.run, spot.height);
                let (over, under) = lap::across(point(self.from), point(self.to), run);
                Value::ratio(over, under)
            }
        }
    }

    /// Twice its height half-way between two runs, of which the sum is given.
    pub fn twice_height(&self, sum: i128) -> Value {
        match self.circle {
            Some(Circle { centre, square, up, .. }) => {
                let along = sum - 2 * centre.run;
                let square = (4 * square - along * along).max(0);
                Value::Root { whole: 2 * centre.height, side: up, square }
            }
            None => {
                let length = self.to.run - self.from.run;
                let rise = (sum - 2 * self.from.run) * (self.to.height - self.from.height);
                Value::ratio(2 * self.from.height * length + rise, length)
            }
        }
    }

    /// The run, about, between two runs at which its slope is that of another span, if there is one.
    #[allow(clippy::cast_precision_loss)]
    pub fn parallel_to(&self, other: &Self) -> Option<f64> {
        match (self.circle, other.circle) {
            (None, None) => None,
            (Some(circle), None) => Some(circle.run_of_slope(other.slope())),
            (None, Some(circle)) => Some(circle.run_of_slope(self.slope())),
            (Some(circle), Some(other)) => {
                let apart = (other.centre.run - circle.centre.run) as f64;
                let (radius, radius_2) = ((circle.square as f64).sqrt(), (other.square as f64).sqrt());
                let sum = if circle.up == other.up { radius - radius_2 } else { radius + radius_2 };
                (sum != 0.0).then(|| circle.centre.run as f64 + radius * apart / sum)
            }
        }
    }

    #[allow(clippy::cast_precision_loss)]
    fn slope(&self) -> f64 {
        (self.to.height - self.from.height) as f64 / (self.to.run - self.from.run) as f64
    }

    /// About its height at a run.
    #[allow(clippy::cast_precision_loss)]
    pub fn estimate(&self, run: f64) -> f64 {
        match self.circle {
            Some(Circle { centre, square, up, .. }) => {
                let along = run - centre.run as f64;
                centre.height as f64 + f64::from(up) * (square as f64 - along * along).max(0.0).sqrt()
            }
            None => self.from.height as f64 + (run - self.from.run as f64) * self.slope(),
        }
    }

    /// The point over or under its centre, if it lies between its ends.
    pub fn top(&self) -> Option<(i128, Value)> {
        let Circle { centre, square, up, .. } = self.circle?;
        let inside = self.from.run < centre.run && centre.run < self.to.run;
        inside.then_some((centre.run, Value::Root { whole: centre.height, side: up, square }))
    }
}

/// Where one span ends and the next one begins, with the elements without run between them.
#[derive(Clone, Debug)]
pub struct Joint {
    pub run: i128,
    /// The height to which the circle or line before it leads.
    pub before: Option<Value>,
    /// The heights in which it begins and ends.
    pub first: i128,
    pub last: i128,
    /// The lowest and the highest of its points.
    pub low: i128,
    pub high: i128,
    /// Whole numbers between which all of them lie, and the height before it too, the bounds included.
    pub bounds: (i128, i128),
    /// Its elements, by number.
    pub elements: std::ops::Range<usize>,
}

impl Joint {
    /// The joint at a spot, behind a height, of no elements yet but those from a number on.
    fn new(spot: Spot, before: Option<Value>, element: usize) -> Self {
        let Spot { run, height } = spot;
        let bounds = match before.map(|before| i128::from(before.latch(1, false))) {
            Some(before) => (height.min(before - 1), height.max(before + 1)),
            None => (height, height),
        };
        let elements = element..element;
        Self { run, before, first: height, last: height, low: height, high: height, bounds, elements }
    }

    /// Takes in an element without run, which leads to a height.
    fn extend(&mut self, element: usize, height: i128) {
        self.last = height;
        (self.low, self.high) = (self.low.min(height), self.high.max(height));
        self.bounds = (self.bounds.0.min(height), self.bounds.1.max(height));
        self.elements.end = element + 1;
    }
}

/// The spans of an outline, and the joint before each of them and behind the last one.
#[derive(Debug)]
pub struct Graph {
    pub spans: Vec<Span>,
    pub joints: Vec<Joint>,
}

impl Graph {
    /// The graph of elements in a row that begin in a point.
    pub fn new(axes: Axes, start: Spot, elements: &[Element]) -> Self {
        let mut graph = Self { spans: Vec::with_capacity(elements.len()), joints: Vec::new() };
        let mut joint = Joint::new(start, None, 0);
        for (number, element) in elements.iter().enumerate() {
            let (from, to) = (axes.spot(element.from), axes.spot(element.to));
            if from.run == to.run {
                joint.extend(number, to.height);
                continue;
            }
            let circle = element.arc.map(|(sense, centre)| circle(axes, from, sense, axes.spot(centre)));
            let span = Span::new(number, (from, to), circle);
            let behind = Joint::new(to, Some(span.height(to.run)), number + 1);
            graph.joints.push(std::mem::replace(&mut joint, behind));
            graph.spans.push(span);
        }
        graph.joints.push(joint);
        graph
    }

    /// The span of an element with run.
    pub fn span_of(&self, element: usize) -> Option<&Span> {
        let place = self.spans.binary_search_by_key(&element, |span| span.element).ok()?;
        self.spans.get(place)
    }
}

impl Circle {
    /// The run at which it has a slope, about.
    #[allow(clippy::cast_precision_loss)]
    fn run_of_slope(&self, slope: f64) -> f64 {
        let radius = (self.square as f64).sqrt();
        self.centre.run as f64 - f64::from(self.up) * slope * radius / slope.hypot(1.0)
    }
}

fn circle(axes: Axes, from: Spot, sense: Sense, centre: Spot) -> Circle {
    let (along, across) = (from.run - centre.run, from.height - centre.height);
    let clockwise = (sense == Sense::Clockwise) == axes.keeps_sense();
    Circle { centre, square: along * along + across * across, up: if clockwise { 1 } else { -1 }, side: 1 }
}

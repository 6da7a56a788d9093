//! Contours in the plane of the cycle: heights rise from the workpiece, runs go along the cut, the start of the contour is
//! the origin. Both are amounts in nanometres, diameters on X.

use turnspec_oracle::vocabulary::{Chamfering, Feature};

use crate::builder::Builder;

const MM: i64 = 1_000_000;

/// What a definition has.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// G82: the infeed goes along Z.
    pub across: bool,
    pub kind: Kind,
    /// The first motion of the contour is in G01.
    pub linear: bool,
    /// The blank, with its first point; none without G83.
    pub blank: Option<Outline>,
    pub contour: Outline,
    /// The nose radius, in compensation.
    pub nose: Option<i64>,
}

/// What cuts the contour.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Turning,
    Thread,
}

/// A first point, and elements from there on.
#[derive(Clone, Default, Debug)]
pub(super) struct Outline {
    pub first: [i64; 2],
    pub elements: Vec<Element>,
}

/// An element to a height and a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    pub to: [i64; 2],
    pub form: Form,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Form {
    Line,
    /// A quarter with its centre from the start (height and run, both radii), clockwise as the plane is seen.
    Quarter {
        centre: [i64; 2],
        clockwise: bool,
    },
    /// An arc by its radius.
    Bow {
        radius: i64,
        clockwise: bool,
    },
    /// A line with a chamfer (75) or a rounding (76) at its end.
    Corner {
        code: i64,
        leg: i64,
    },
}

impl Outline {
    pub fn end(&self) -> [i64; 2] {
        self.elements.last().map_or(self.first, |element| element.to)
    }

    /// Lowest and highest coordinate, of heights (0) or runs (1).
    pub fn extent(&self, of: usize) -> (i64, i64) {
        let places = self.elements.iter().map(|element| element.to[of]).chain([self.first[of]]);
        places.fold((i64::MAX, i64::MIN), |(low, high), place| (low.min(place), high.max(place)))
    }
}

impl Plan {
    /// A contour, with a blank or for threads now and then.
    pub fn draw(builder: &mut Builder<'_, '_, '_>) -> Self {
        let across = builder.choices.chance(35);
        let leads = !across || builder.allows(Feature::Aux);
        let threads = leads && builder.choices.chance(14) && builder.ready_for_lap_threads();
        let kind = if threads { Kind::Thread } else { Kind::Turning };
        let blank = !threads && builder.choices.chance(40) && builder.state.setup.options.lap != 3;
        let radius = builder.state.compensation.radius();
        let compensated = !threads
            && radius > 0
            && radius < 5 * MM
            && builder.allows(Feature::RadiusCompensation)
            && builder.state.setup.options.nose_radius_compensation
            && builder.state.plane == 18
            && builder.choices.chance(60);
        let nose = compensated.then_some(radius);
        let mut pen = Pen { builder, across, blank: false, nose, grid: MM, rose: 0 };
        pen.grid = pen.builder.choices.pick(&[MM, 500_000, 1_000]);
        let contour = if threads { pen.legs() } else { pen.outline([0, 0], 10) };
        pen.blank = true;
        pen.nose = None;
        let blank = blank.then(|| {
            // A line beside the start of the contour, where inches are cut and rounded.
            let inch = pen.builder.state.units.system.is_inch();
            let aside = if inch || pen.builder.choices.chance(20) { pen.amount(1, 3) } else { 0 };
            let above = pen.amount(2, 12);
            pen.outline([above, aside], 5)
        });
        let linear = !threads && pen.builder.choices.chance(25);
        Self { across, kind, linear, blank, contour, nose }
    }

    /// Lowest and highest place of everything.
    pub fn extent(&self, of: usize) -> (i64, i64) {
        let (low, high) = self.contour.extent(of);
        let (least, most) = self.blank.as_ref().map_or((low, high), |blank| blank.extent(of));
        (low.min(least), high.max(most))
    }
}

/// What draws an outline.
struct Pen<'p, 'b, 'c, 'd> {
    builder: &'p mut Builder<'b, 'c, 'd>,
    across: bool,
    blank: bool,
    nose: Option<i64>,
    grid: i64,
    /// The way of the last wall, 1 up, -1 down, 0 when no wall was last.
    rose: i64,
}

impl Pen<'_, '_, '_, '_> {
    /// An amount of so many millimetres on the grid.
    fn amount(&mut self, least: i64, most: i64) -> i64 {
        let grid = self.grid;
        let finest = self.builder.state.units.finest();
        let least = least + self.nose.map_or(0, |nose| 4 * nose / MM + 1);
        let amount = self.builder.choices.within(least * MM / grid, most.max(least + 1) * MM / grid) * grid;
        (amount / finest * finest).max(finest)
    }

    fn outline(&mut self, first: [i64; 2], most: i64) -> Outline {
        // A blank rises from the start of the contour.
        self.rose = i64::from(self.blank);
        let mut elements = Vec::new();
        let mut at = first;
        let count = self.builder.choices.within(1, most);
        while (elements.len() as i64) < count || at[1] == first[1] {
            let from = elements.len();
            self.element(at, &mut elements);
            at = elements.last().map_or(at, |element: &Element| element.to);
            if elements.len() == from {
                break;
            }
        }
        if self.blank && self.rose != 0 {
            at[1] += self.amount(1, 12);
            elements.push(Element { to: at, form: Form::Line });
        }
        Outline { first, elements }
    }

    /// One element, or a corner and the wall behind it.
    fn element(&mut self, at: [i64; 2], elements: &mut Vec<Element>) {
        let [h, r] = at;
        let lowest = -8 * MM;
        let arcs = self.builder.allows(Feature::Arc) && self.nose.is_none();
        let walls = |rose: i64, way: i64| rose != -way;
        let mut add = |to: [i64; 2], form: Form| elements.push(Element { to, form });
        match self.builder.choices.below(100) {
            18..36 if walls(self.rose, 1) => {
                add([h + self.amount(1, 9), r], Form::Line);
                self.rose = 1;
                return;
            }
            36..44 if walls(self.rose, -1) && h > lowest && self.nose.is_none() => {
                add([h - self.amount(1, 6), r], Form::Line);
                self.rose = -1;
                return;
            }
            44..62 => {
                let up = self.up(h > lowest);
                let (rise, way) = (self.amount(1, 9), self.amount(1, 9));
                add([h + up * rise, r + way], Form::Line);
            }
            62..78 if arcs => {
                let up = self.up(h > lowest);
                let radius = self.amount(1, 5);
                let level = self.builder.choices.chance(50);
                if !level && self.rose == -up {
                    add([h, r + radius], Form::Line);
                } else {
                    let (dh, dr) = if self.across { (radius, 2 * radius) } else { (2 * radius, radius) };
                    let centre = if level { [up * radius, 0] } else { [0, radius] };
                    let clockwise = if level { up < 0 } else { up > 0 };
                    add([h + up * dh, r + dr], Form::Quarter { centre, clockwise });
                }
            }
            78..88 if arcs => {
                let way = self.amount(2, 12);
                let rise = self.builder.choices.pick(&[0, 0, way / 4, way / 2, -way / 4]);
                let rise = if h > lowest { rise } else { rise.abs() } / 2_000 * 2_000;
                let (dx, dz) = if self.across { (way, rise) } else { (rise, way) };
                let chord = (dx as f64 / 2.0).hypot(dz as f64);
                let times = self.builder.choices.pick(&[0.75, 1.0, 1.5, 4.0]);
                let radius = ((chord * times) as i64 / 1_000 + 1) * 1_000;
                let clockwise = self.builder.choices.chance(50);
                add([h + rise, r + way], Form::Bow { radius, clockwise });
            }
            88..94 if !self.blank && self.nose.is_none() => {
                let basic = self.builder.state.setup.parameters.chamfering != Chamfering::Off;
                let code = self.builder.choices.pick(&[75, 76]);
                let feature = if code == 75 { Feature::Chamfer } else { Feature::Rounding };
                let rising = self.builder.choices.chance(70) || h <= lowest;
                if basic && self.builder.allows(feature) {
                    let leg = self.builder.choices.pick(&[500_000, MM, 300_000]);
                    add([h, r + self.amount(5, 12)], Form::Corner { code, leg });
                    let wall = self.amount(4, 9) * if rising { 1 } else { -1 };
                    let to = elements.last().map_or(at, |element| element.to);
                    elements.push(Element { to: [to[0] + wall, to[1]], form: Form::Line });
                    self.rose = wall.signum();
                    return;
                }
                add([h, r + self.amount(1, 12)], Form::Line);
            }
            _ => add([h, r + self.amount(1, 12)], Form::Line),
        }
        self.rose = 0;
    }

    fn up(&mut self, may_fall: bool) -> i64 {
        if may_fall { self.builder.choices.pick(&[1, 1, -1]) } else { 1 }
    }

    /// Legs of a thread: level ones and tapers.
    fn legs(&mut self) -> Outline {
        let mut elements = Vec::new();
        let mut at = [0, 0];
        for _ in 0..self.builder.choices.within(1, 5) {
            let rise = if self.builder.choices.chance(45) { self.amount(0, 2) } else { 0 };
            at = [at[0] + rise, at[1] + self.amount(2, 15)];
            elements.push(Element { to: at, form: Form::Line });
        }
        Outline { first: [0, 0], elements }
    }
}

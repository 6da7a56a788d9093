//! From a trace to what is drawn of it: the motions of the tool, one after the other.

use turnspec_conformance::geometry::{Arc, Point, Way};
use turnspec_oracle::integer::area::{Bounds, chuck, tailstock};
use turnspec_oracle::vocabulary::{Action, Event, Length, Motion, Sense, Setup};

/// What a motion is, for the eye.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Positioning.
    Rapid,
    /// A straight line at a feed.
    Linear,
    /// An arc.
    Arc,
}

impl Kind {
    /// Every kind, in the order of the legend.
    pub const ALL: [Self; 3] = [Self::Rapid, Self::Linear, Self::Arc];

    /// Its name, which is its class in the drawing too.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rapid => "rapid",
            Self::Linear => "linear",
            Self::Arc => "arc",
        }
    }
}

/// A motion with a travel in X or Z.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Segment {
    /// The number of its event.
    pub n: u64,
    /// What it is.
    pub kind: Kind,
    /// The way of the tool.
    pub way: Way,
    /// The programmed way, where the tool goes another one.
    pub programmed: Option<Way>,
}

/// What is drawn of a run.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Plan {
    /// The motions, in order.
    pub segments: Vec<Segment>,
    /// Where the run ended in an alarm.
    pub alarm: Option<Point>,
    /// The areas of chuck and tailstock that the set-up describes: two opposite corners each.
    pub barriers: Vec<(Point, Point)>,
    /// Whether motions were left out because there were too many.
    pub cut: bool,
    /// Where the tool stands in machine coordinates.
    machine: Point,
    /// Where it would stand without compensation.
    uncompensated: Point,
    /// Where it stands in the program coordinates of the last motion.
    present: Point,
}

impl Plan {
    /// The most motions that are drawn.
    pub const MOST: usize = 100_000;

    /// Nothing yet, on this machine.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        let areas = chuck(&setup.barriers).into_iter().chain(tailstock(&setup.barriers)).flatten();
        let start = Point::of(setup.start.z, setup.start.x);
        let offset = Point::of(setup.zero_offset.z, setup.zero_offset.x);
        Self {
            barriers: areas.map(corners).collect(),
            machine: start,
            uncompensated: start,
            present: start - offset,
            ..Self::default()
        }
    }

    /// Takes the next event.
    pub fn event(&mut self, event: &Event) {
        match &event.action {
            Action::Rapid { motion } => self.motion(event.n, Kind::Rapid, motion, None),
            Action::Linear { motion, .. } => self.motion(event.n, Kind::Linear, motion, None),
            Action::Arc { motion, sense, centre_x, centre_z, .. } => {
                let sense = if *sense == Sense::Clockwise { -1.0 } else { 1.0 };
                let arc = Arc { centre: Point::of(*centre_z, *centre_x), sense };
                self.motion(event.n, Kind::Arc, motion, Some(arc));
            }
            Action::Alarm(_) => self.alarm = Some(self.present),
            _ => {}
        }
    }

    /// A motion that begins where the tool stands, in the coordinates of the motion.
    fn motion(&mut self, n: u64, kind: Kind, motion: &Motion, arc: Option<Arc>) {
        let programmed = Point::of(motion.program.z, motion.program.x);
        let tip = motion.tip.map_or(programmed, |tip| Point::of(tip.z, tip.x));
        let machine = Point::of(motion.machine.z, motion.machine.x);
        let frame = tip - machine;
        let contour = Way { from: self.uncompensated + frame, to: programmed, arc };
        // The nose goes round the centre, the tip beside it.
        let beside = motion.nose.map_or(Point::default(), |nose| tip - Point::of(nose.z, nose.x));
        let arc = arc.map(|arc| Arc { centre: arc.centre + beside, ..arc });
        let way = Way { from: self.machine + frame, to: tip, arc };
        (self.machine, self.uncompensated, self.present) = (machine, programmed - frame, tip);
        if !way.has_length() && !contour.has_length() {
            return;
        }
        if self.segments.len() == Self::MOST {
            self.cut = true;
            return;
        }
        let programmed = (motion.tip.is_some() && contour != way).then_some(contour);
        self.segments.push(Segment { n, kind, way, programmed });
    }
}

fn corners(bounds: Bounds) -> (Point, Point) {
    let corner = |z: i64, x: i64| Point::of(Length(z), Length(x));
    (corner(bounds.z.0, bounds.x.0), corner(bounds.z.1, bounds.x.1))
}

#[cfg(test)]
mod tests {
    use super::{Kind, Plan, Point};
    use turnspec_oracle::vocabulary::{Event, Setup};

    fn plan(program: &str, setup: &str) -> Plan {
        let setup = Setup::from_toml(setup).unwrap_or_default();
        let mut plan = Plan::new(&setup);
        turnspec_oracle::run(program.as_bytes(), &setup, &mut |event: &Event| plan.event(event));
        plan
    }

    #[test]
    fn motions_are_drawn_where_they_begin_and_end() {
        let plan = plan("G00 X20 Z5\nG01 Z-10 F0.2\nG02 X30 Z-15 I5\nM02\n", "");
        let kinds: Vec<_> = plan.segments.iter().map(|segment| segment.kind).collect();
        assert_eq!(kinds, [Kind::Rapid, Kind::Linear, Kind::Arc]);
        let arc = plan.segments[2];
        assert_eq!((arc.way.from, arc.way.to), (Point::new(-10.0, 10.0), Point::new(-15.0, 15.0)));
        assert_eq!(arc.way.arc.map(|arc| arc.centre), Some(Point::new(-10.0, 15.0)));
        assert!(plan.segments.iter().all(|segment| segment.programmed.is_none()));
        assert_eq!(plan.alarm, None);
    }

    /// A shift moves the coordinates, not the tool.
    #[test]
    fn a_motion_begins_in_its_own_coordinates() {
        let plan = plan("G00 X20 Z5\nG50 X40 Z0\nG00 X60\nG05\n", "");
        let last = plan.segments[1].way;
        assert_eq!((last.from, last.to), (Point::new(0.0, 20.0), Point::new(0.0, 30.0)));
        assert_eq!(plan.alarm, Some(last.to));
    }

    /// On a cone the imaginary tip lies beside the contour.
    #[test]
    fn in_compensation_the_tip_is_drawn_and_the_contour_beside_it() {
        let setup = "[[nose_radius]]\nnumber = 1\nx = 1\nz = 1\n";
        let plan = plan("G00 X40 Z10 T010101\nG42 G01 X20 F0.2\nZ-10\nX40 Z-20\nX60\nG40 Z20\nM02\n", setup);
        let cut = plan.segments[2];
        assert_eq!(cut.programmed.map(|way| way.to), Some(Point::new(-10.0, 10.0)));
        assert_ne!(cut.way.to, Point::new(-10.0, 10.0));
    }
}

//! From a trace to what is drawn of it: the motions of the tool, one after the other.

use turnspec_conformance::geometry::{Arc, Point, Way};
use turnspec_oracle::Outline;
use turnspec_oracle::integer::area::{Bounds, chuck, tailstock};
use turnspec_oracle::vocabulary::{Action, Event, Length, Motion, Setup, Side};

use super::outline::Definition;

/// What a motion is, for the eye.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Positioning.
    Rapid,
    /// A straight line at a feed.
    Linear,
    /// An arc.
    Arc,
    /// A thread.
    Thread,
}

impl Kind {
    /// Every kind, in the order of the legend.
    pub const ALL: [Self; 4] = [Self::Rapid, Self::Linear, Self::Arc, Self::Thread];

    /// Its name, which is its class in the drawing too.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rapid => "rapid",
            Self::Linear => "linear",
            Self::Arc => "arc",
            Self::Thread => "thread",
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
    /// The pass of a cycle that it cuts in, from 1.
    pub pass: Option<u32>,
}

/// What is drawn of a run.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Plan {
    /// The motions, in order.
    pub segments: Vec<Segment>,
    /// Where the run ended in an alarm.
    pub alarm: Option<Point>,
    /// What calls of LAP were told to cut; what the call before was told, too, is not repeated.
    pub definitions: Vec<Definition>,
    /// The areas of chuck and tailstock that the set-up describes: two opposite corners each.
    pub barriers: Vec<(Point, Point)>,
    /// Whether motions were left out because there were too many.
    pub cut: bool,
    /// How many ways the definitions have.
    defined: usize,
    /// Where the tools of saddle A and of saddle B stand in machine coordinates; without a second saddle the first.
    machine: [Point; 2],
    /// Where they would stand without compensation.
    uncompensated: [Point; 2],
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
        let starts = [start, Point::of(setup.turret_b.start.z, setup.turret_b.start.x)];
        let offset = Point::of(setup.zero_offset.z, setup.zero_offset.x);
        Self {
            barriers: areas.map(corners).collect(),
            machine: starts,
            uncompensated: starts,
            present: start - offset,
            ..Self::default()
        }
    }

    /// Takes the next event.
    pub fn event(&mut self, event: &Event) {
        match &event.action {
            Action::Rapid { motion } => self.motion(event, Kind::Rapid, motion, None),
            Action::Linear { motion, .. } => self.motion(event, Kind::Linear, motion, None),
            Action::Thread { motion, .. } => self.motion(event, Kind::Thread, motion, None),
            Action::Arc { motion, sense, centre_x, centre_z, .. } => {
                self.motion(event, Kind::Arc, motion, Some(Arc::of(*centre_z, *centre_x, *sense)));
            }
            // In a plane of the C axis: here only how far X and Z go is seen.
            Action::ContourArc { motion, .. } => self.motion(event, Kind::Arc, motion, None),
            Action::Alarm(_) => self.alarm = Some(self.present),
            _ => {}
        }
    }

    /// Takes the definition that a call of LAP has read.
    pub fn definition(&mut self, outline: &Outline) {
        let definition = Definition::of(outline, Self::MOST - self.defined);
        if self.definitions.last() != Some(&definition) {
            self.defined += definition.ways().count();
            self.cut |= self.defined == Self::MOST;
            self.definitions.push(definition);
        }
    }

    /// A motion that begins where the tool stands, in the coordinates of the motion.
    fn motion(&mut self, event: &Event, kind: Kind, motion: &Motion, arc: Option<Arc>) {
        let side = usize::from(event.saddle == Some(Side::B));
        let programmed = Point::of(motion.program.z, motion.program.x);
        let tip = motion.tip.map_or(programmed, |tip| Point::of(tip.z, tip.x));
        // With turret B of a saddle the plane of the program is the mirror image of that of the machine (E100L-MIRR-05).
        let mirrored = event.turret == Some(Side::B);
        let seen = |point: Point| if mirrored { Point::new(point.z, -point.x) } else { point };
        let machine = Point::of(motion.machine.z, motion.machine.x);
        let frame = tip - seen(machine);
        let contour = Way { from: seen(self.uncompensated[side]) + frame, to: programmed, arc };
        // The nose goes round the centre, the tip beside it.
        let beside = motion.nose.map_or(Point::default(), |nose| tip - Point::of(nose.z, nose.x));
        let arc = arc.map(|arc| Arc { centre: arc.centre + beside, ..arc });
        let way = Way { from: seen(self.machine[side]) + frame, to: tip, arc };
        self.machine[side] = machine;
        self.uncompensated[side] = seen(programmed - frame);
        self.present = tip;
        if !way.has_length() && !contour.has_length() {
            return;
        }
        if self.segments.len() == Self::MOST {
            self.cut = true;
            return;
        }
        let programmed = (motion.tip.is_some() && contour != way).then_some(contour);
        let pass = motion.pass.filter(|_| kind != Kind::Rapid);
        self.segments.push(Segment { n: event.n, kind, way, programmed, pass });
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

    #[test]
    fn a_thread_is_drawn_and_leads_back() {
        let plan = plan("G00 X60 Z10\nM03 S100\nG33 X50 Z-20 F2\nM02\n", "");
        let kinds: Vec<_> = plan.segments.iter().map(|segment| segment.kind).collect();
        assert_eq!(kinds, [Kind::Rapid, Kind::Rapid, Kind::Thread, Kind::Linear, Kind::Rapid]);
        assert_eq!(plan.segments[4].way.to, Point::new(10.0, 30.0));
        let passes: Vec<_> = plan.segments.iter().map(|segment| segment.pass).collect();
        assert_eq!(passes, [None, None, Some(1), Some(1), None]);
    }

    /// Turret B goes on from where the saddle stands: at X-20 of the machine it is at X20.
    #[test]
    fn the_second_turret_is_drawn_in_its_own_coordinates() {
        let setup = "[machine]\ntype = \"1S-2T\"\n";
        let plan = plan("G00 X20 Z5\nG14\nX30\nM02\n", setup);
        let last = plan.segments[1].way;
        assert_eq!((last.from, last.to), (Point::new(5.0, -10.0), Point::new(5.0, 15.0)));
    }

    /// Each saddle goes on from where it stands itself.
    #[test]
    fn saddles_are_drawn_each_from_its_place() {
        let setup = "[machine]\ntype = \"2S\"\n[turret_b.start]\nx = 100\n";
        let plan = plan("G13\nG00 X20 Z5\nG14\nG00 X30\nM02\n", setup);
        let ways: Vec<_> = plan.segments.iter().map(|segment| (segment.way.from, segment.way.to)).collect();
        let (a, b) = (Point::default(), Point::new(0.0, 50.0));
        assert_eq!(ways, [(a, Point::new(5.0, 10.0)), (b, Point::new(0.0, 15.0))]);
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

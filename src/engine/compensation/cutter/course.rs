//! What a block programs in the plane of a cutter: its targets, the points between which it goes, its arc, and the rules
//! that it cites for them (execution of contours, 9; E100L-CRC-06, E100L-CRC-07).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{ReadingSet, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::coordinate;
use crate::engine::arithmetic::turn;
use crate::engine::block::Plan;
use crate::engine::cite::{self, Cites};
use crate::engine::compensation::Phase;
use crate::engine::compensation::contour::Shape;
use crate::engine::contour::{self, Course, Station, check_diameters, sense, unspecified, word_cites};
use crate::engine::fault::Fault;
use crate::engine::slot::Slot;
use crate::engine::state::{C, W, X, Z};
use crate::engine::words::{Address, Words};

use super::{Place, Plane};

/// The targets of the words of a block, in program coordinates, with the rules and readings of its words.
#[derive(Clone, Copy, Default)]
pub struct Targets {
    pub x: Option<i64>,
    pub z: Option<i64>,
    pub w: Option<i64>,
    pub c: Option<i64>,
    pub cites: Cites,
    pub readings: ReadingSet,
}

/// What a block programs, with the plane point at which it starts, if that is known.
pub(super) struct Programs {
    pub start: Option<Place>,
    pub end: Place,
    /// In G119: the programmed travel of C.
    pub travel: i64,
    /// Of G101 to G103.
    of_face: Option<Course>,
}

/// A block that moves where a cutter was or is compensated.
pub(super) struct Block<'b> {
    pub words: &'b Words,
    pub motion: u16,
    pub plane: Plane,
    pub converted: bool,
}

impl Interpreter<'_> {
    /// The targets of the words, and the rules of the words out of conversion mode.
    pub(super) fn targets_of(
        &mut self,
        slot: &Slot,
        plan: Plan,
        converted: bool,
        sink: &mut impl Sink,
    ) -> Result<Targets, Fault> {
        let words = &slot.words;
        let incremental = self.state.incremental;
        let along = |address, axis| {
            words.get(address).map(|word| coordinate(self.state.program(axis), word, incremental))
        };
        let (w, c) = (along(Address::W, W), along(Address::C, C).map(turn::within));
        if contour::is_mode(plan.motion) || converted && words.has_any(contour::POINT) {
            let (x, z) = (along(Address::X, X).filter(|_| !converted), along(Address::Z, Z));
            self.state.base = None;
            let cites = word_cites(&self.state, self.inch_block, words.has(Address::X) && !converted);
            let readings = if self.inch_block { self.known.inch } else { ReadingSet::default() };
            return Ok(Targets { x, z, w, c, cites, readings });
        }
        let mut targets = Targets { w, c, cites: self.coordinate_cites(words), ..Targets::default() };
        let angle_target = self.state.angle_target.take();
        if words.has_any(Address::set(&[Address::X, Address::Z])) {
            let base = self.state.base.take();
            let end = self.line_end(slot, plan, base, angle_target, sink)?;
            targets.x = end.x.then_some(end.point.x);
            targets.z = end.z.then_some(end.point.z);
            targets.cites = targets.cites.and(end.cites);
            targets.readings = end.readings;
        }
        if self.inch_block {
            targets.readings = targets.readings.union(self.known.inch);
        }
        Ok(targets)
    }

    /// What a block programs.
    pub(super) fn cutter_course(&mut self, block: &Block, targets: &Targets) -> Result<Programs, Fault> {
        match block.plane {
            Plane::Face => self.course_on_face(block, targets),
            Plane::Side { .. } => Ok(self.course_on_side(block, targets)),
        }
    }

    fn course_on_face(&mut self, block: &Block, targets: &Targets) -> Result<Programs, Fault> {
        let z = self.state.program(Z);
        let place = |station: Station, z| {
            let Station { point, x, c } = station;
            Place { point, x, z, c, unwrapped: 0 }
        };
        let (start, end, of_face) = if contour::is_mode(block.motion) {
            let course = self.course(block.words)?;
            (Some(course.start), course.end, Some(course))
        } else if block.converted {
            let held = self.held_point();
            let target = self.target_point(block.words, held);
            // A start-up and the way back need no point to start from.
            let needs = self.compensation.phase == Phase::On;
            let Some(target) = target.filter(|_| held.is_some() || !needs) else {
                return Err(unspecified(rules::CSC_06, "start"));
            };
            (held, self.converted(target), None)
        } else {
            let (x, c) = (self.state.program(X), self.state.program(C));
            let (to_x, to_c) = (targets.x.unwrap_or(x), targets.c.unwrap_or(c));
            let start = Station { point: self.point_of(x, c), x, c };
            (Some(start), Station { point: self.point_of(to_x, to_c), x: to_x, c: to_c }, None)
        };
        let start = start.map(|start| place(start, z));
        Ok(Programs { start, end: place(end, targets.z.unwrap_or(z)), travel: 0, of_face })
    }

    fn course_on_side(&mut self, block: &Block, targets: &Targets) -> Programs {
        let [x, z, c] = [X, Z, C].map(|axis| self.state.program(axis));
        let (from_c, turned) =
            self.compensation.cutter.as_deref().map_or((c, 0), |cutter| (cutter.from_c, cutter.turned));
        let to_c = targets.c.unwrap_or(c);
        let travel = turn::travel(c, to_c, 0, self.state.c_negative);
        let mut at = |turned: i64, z: i64, c: i64| {
            let around = self.length_around(x, turned);
            let point = Spot { p: block.plane.seen(around), q: z };
            Place { point, x, z, c, unwrapped: from_c.saturating_add(turned) }
        };
        let start = at(turned, z, c);
        let end = at(turned.saturating_add(travel), targets.z.unwrap_or(z), to_c);
        Programs { start: Some(start), end, travel, of_face: None }
    }

    /// The centre of an arc, and its radius.
    pub(super) fn cutter_arc(
        &mut self,
        block: &Block,
        course: &Programs,
    ) -> Result<Option<(Spot, i64)>, Fault> {
        let Block { words, motion, .. } = *block;
        let radius = words.get(Address::L).unwrap_or_default();
        if let Some(of_face) = &course.of_face {
            let is_arc = motion != 101;
            check_diameters(of_face, is_arc)?;
            if !is_arc {
                return Ok(None);
            }
            return Ok(Some((self.face_centre(of_face, radius, sense(motion))?, radius)));
        }
        match course.start {
            Some(start) if matches!(motion, 132 | 133) => {
                let ends = (start.point, course.end.point);
                let way = (course.end.x, course.travel);
                Ok(Some((self.side_centre(ends, way, radius, sense(motion))?, radius)))
            }
            _ => Ok(None),
        }
    }

    /// The rules of a motion code, of a line or the feed.
    pub(super) fn cites_of_mode(&self, block: &Block) -> Cites {
        let point = block.converted && block.words.has_any(contour::POINT);
        match block.motion {
            0 => cite::G00_01.and_if(point, cite::CAX_05),
            1 => self.feed_cites().and(cite::G01_01).and(cite::G01_02),
            132 | 133 => self.feed_cites().and_if(block.words.has(Address::C), cite::CAX_05),
            _ => self.feed_cites(),
        }
    }

    /// The rules of a contour block, and of conversion mode.
    pub(super) fn rules_of_words(&self, block: &Block) -> RuleSet {
        let mut set = match block.motion {
            101..=103 => const { RuleSet::of(&[rules::CGF_01, rules::CGF_06]) },
            132 | 133 => self.side_rules(block.words),
            _ => RuleSet::EMPTY,
        };
        if block.converted {
            set = set.union(self.conversion_rules(block.words));
            if contour::is_face_mode(block.motion) {
                set = set.with(rules::CGF_14);
            }
        }
        set
    }
}

/// A block as an element of its plane.
pub(super) fn element(course: &Programs, centre: Option<Spot>, motion: u16) -> Shape {
    let from = course.start.unwrap_or(course.end).point;
    let to = course.end.point;
    match centre {
        Some(centre) => Shape::arc_between(from, to, centre, sense(motion)),
        None => Shape::line_between(from, to),
    }
}

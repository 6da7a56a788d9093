//! Motions of other axes than those of the plane, in compensation of a cutter: Z and W in G17, W in G119 (execution of
//! contours, 9).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{Action, Angle, Length, Motion, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::contour::Spot;
use crate::engine::arithmetic::frame::to_machine;
use crate::engine::arithmetic::plane::Point;
use crate::engine::cite;
use crate::engine::compensation::waiting::{Role, check_limit, position};
use crate::engine::contour::{self, Lines, Shape, check_diameters, face_point};
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::state::{W, Z};
use crate::engine::words::Words;

use super::Plane;
use super::course::Targets;

impl Interpreter<'_> {
    /// A motion of other axes; where the cutter is shows when its turn comes.
    pub(super) fn move_beside(
        &mut self,
        words: &Words,
        motion: u16,
        targets: &Targets,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        if motion == 101 {
            return self.line_beside(words, targets, sink);
        }
        if contour::is_mode(motion) {
            // Without a travel in its plane it is no arc.
            return self.cut_contour(words, motion, sink);
        }
        for target in [targets.x, targets.z, targets.w].into_iter().flatten() {
            self.check_coordinate(target)?;
        }
        let kind = if motion == 0 { Kind::Rapid } else { Kind::Linear };
        let feed = self.feed_of(kind)?;
        let mut readings = targets.readings;
        let mut cites = match kind {
            Kind::Rapid => targets.cites.and(cite::G00_01),
            _ => targets.cites.and(self.feed_cites()).and(cite::G01_01).and(cite::G01_02),
        };
        let start = self.state.machine;
        let mut end = start;
        if let Some(target) = targets.z {
            end[Z] = to_machine(target, self.state.frame(Z));
            check_limit(end[Z], self.limits_of_z())?;
        }
        if let Some(target) = targets.w {
            end[W] = to_machine(target, self.state.frame(W));
            if self.limit(W, &mut end[W], false)? {
                cites = cites.and(cite::LIM_01);
            }
        }
        if self.state.watch.acts() && (targets.x.is_some() || targets.z.is_some()) {
            self.check_barriers(kind, &end, &mut cites, &mut readings)?;
        }
        self.state.machine = end;
        self.state.last_motion_cut = feed.is_some();
        let linear = feed.is_some();
        cites = cites.and(cite::NRC_07).and_if(linear, cite::NRC_42);
        let mut motion = self.motion_to_here(linear, &mut cites, &mut readings);
        let rules = self.show_cutter(&mut motion);
        let action = self.action((kind, feed), motion, (&start, &end, None), &mut cites, &mut readings);
        let rules = self.cites.rules(cites).union(rules);
        self.emit_with(sink, rules, readings, action);
        Ok(())
    }

    /// Z alone in G101: a line on the same ray.
    fn line_beside(&mut self, words: &Words, targets: &Targets, sink: &mut impl Sink) -> Result<(), Fault> {
        self.check_c_axis(rules::CGF_07, rules::CGF_07)?;
        let course = self.course(words)?;
        check_diameters(&course, false)?;
        let lines = Lines::of(&course)?;
        self.check_coordinate(course.end.x)?;
        course.z_target.map_or(Ok(()), |z| self.check_coordinate(z))?;
        let feed = self.feed()?;
        self.check_no_barrier(rules::CGF_01)?;
        let mut set = const { RuleSet::of(&[rules::CGF_01, rules::CGF_06]) };
        if course.converted {
            set = set.with(rules::CGF_14).union(self.conversion_rules(words));
        }
        let legs = lines.legs(&course, feed, self.setup.parameters.centre_override, set);
        for leg in legs.into_iter().flatten() {
            let mut readings = targets.readings;
            let mut cites = targets.cites.and(self.feed_cites()).and(cite::NRC_07).and(cite::NRC_42);
            if let Some(target) = leg.z {
                let machine = to_machine(target, self.state.frame(Z));
                check_limit(machine, self.limits_of_z())?;
                self.state.machine[Z] = machine;
            }
            self.state.last_motion_cut = true;
            let mut motion = self.motion_to_here(true, &mut cites, &mut readings);
            motion.c_travel = Some(Angle(leg.travel));
            motion.face = Some(face_point(course.end.point));
            let set = leg.rules.union(self.show_cutter(&mut motion));
            let Shape::Line(path) = leg.shape else { continue };
            let rules = self.cites.rules(cites).union(set);
            let action = Action::Linear { motion, feed, path: Length(path) };
            self.emit_with(sink, rules, readings, action);
        }
        Ok(())
    }

    /// Shows the programmed point for the cutter, until the motion is released; and the rules of compensation.
    fn show_cutter(&self, motion: &mut Motion) -> RuleSet {
        let plane = self.compensation.cutter.as_deref().map_or(Plane::Face, |cutter| cutter.plane);
        motion.tip = Some(position(Point { x: motion.program.x.0, z: motion.program.z.0 }));
        motion.tip_c = motion.program.c;
        motion.face_tip = (plane == Plane::Face).then(|| face_point(Spot::default()));
        plane.rules_of(Role::Element)
    }

    fn limits_of_z(&self) -> (Option<i64>, Option<i64>) {
        (self.state.negative_limits[Z], self.state.positive_limits[Z])
    }
}

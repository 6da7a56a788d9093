//! Positioning in conversion mode (execution of contours, 7; E100L-CSC-02 to E100L-CSC-07).

use turnspec_oracle::vocabulary::{Action, Angle, Motion, ReadingSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::frame::{coordinate, to_machine};
use crate::engine::cite;
use crate::engine::fault::Fault;
use crate::engine::motion::Kind;
use crate::engine::state::{C, W, X, Z};
use crate::engine::words::{Address, Words};

use super::motion::{face_point, word_cites};

impl Interpreter<'_> {
    /// A block with G00 and X or Y in conversion mode.
    pub(in crate::engine) fn position_by_point(
        &mut self,
        words: &Words,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.base = None;
        let target = self.programmed_station(words)?;
        let along = |address, axis| {
            words.get(address).map(|word| coordinate(self.state.program(axis), word, self.state.incremental))
        };
        let targets = [(X, Some(target.x)), (Z, along(Address::Z, Z)), (W, along(Address::W, W))];
        for (_, target) in targets {
            target.map_or(Ok(()), |target| self.check_coordinate(target))?;
        }
        let turn = self.turn_to(target.c, 0)?;
        let mut cites = word_cites(&self.state, self.inch_block, false).and(cite::G00_01).and(cite::CAX_05);
        let mut readings = if self.inch_block { self.known.inch } else { ReadingSet::default() };
        let mut end = self.state.machine;
        for (axis, target) in targets {
            if let Some(target) = target {
                end[axis] = to_machine(target, self.state.frame(axis));
                if self.limit(axis, &mut end[axis], false)? {
                    cites = cites.and(cite::LIM_01);
                }
            }
        }
        if self.state.watch.acts() {
            self.check_barriers(Kind::Rapid, &end, &mut cites, &mut readings)?;
        }
        end[C] = turn.machine;
        self.state.machine = end;
        self.state.last_motion_cut = false;
        self.keep_point(target);
        let motion = Motion {
            c_travel: Some(Angle(turn.travel)),
            face: Some(face_point(target.point)),
            ..self.motion_to_here(false, &mut cites, &mut readings)
        };
        let rules = self.cites.rules(cites).union(self.conversion_rules(words));
        self.emit_with(sink, rules, readings, Action::Rapid { motion });
        Ok(())
    }
}

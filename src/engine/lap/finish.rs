//! G87: the blocks of a contour are carried out like any others (execution of LAP, 6; E100L-LAPC-06, E100L-LAP-13).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Ending, Label, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::plane::Point;
use crate::engine::block::Plan;
use crate::engine::cite;
use crate::engine::fault::Fault;
use crate::engine::motion::{Element, Kind};
use crate::engine::planted::{self, Bug};
use crate::engine::slot::Slot;
use crate::engine::words::{Address, Words};

use super::definition::{Finish, Purpose};
use super::{Code, Progress, malformed, unspecified};

impl Interpreter<'_> {
    /// Step 7 of a call with G87.
    pub(super) fn begin_to_finish(&mut self, call: &Slot, sink: &mut impl Sink) -> Result<(), Fault> {
        let word = |address| call.words.get(address).unwrap_or_default();
        let inch = self.inch_block;
        let mut definition = self.definition(Purpose::Finish, Code::Along);
        definition.finish = Finish {
            motion: self.state.motion,
            incremental: self.state.incremental,
            allowances: Point { x: word(Address::U), z: word(Address::W) },
        };
        self.state.base = None;
        let mut slot = Slot::default();
        if self.begin_definition(call.parsed.contour, &mut slot, sink)? == Code::Blank {
            self.pass_blank(&mut slot)?;
        }
        self.inch_block = inch;
        self.lap.progress = Progress::Defining(Box::new(definition));
        self.lap.observes = true;
        Ok(())
    }

    /// The next block of the contour.
    pub(super) fn define(&mut self, slot: &mut Slot, sink: &mut impl Sink) -> Result<Option<Ending>, Fault> {
        if !self.read_contour_block(slot, sink)? {
            return Ok(None);
        }
        if self.side.is_some() && self.stop_at_p(&slot.words, sink)? {
            return Ok(None);
        }
        self.carry_out(slot, sink)
    }

    /// A checked block of a contour that is carried out: what its motions cite besides.
    #[cold]
    pub(in crate::engine) fn begin_contour_block(&mut self, words: &Words, plan: Plan) -> Result<(), Fault> {
        self.take_contour_feeds(words, plan)?;
        if !self.lap.defines() {
            return Ok(());
        }
        let feeds = words.has(Address::F) || words.has(Address::S);
        self.lap.cites =
            cite::LAPC_06.and_if(feeds, cite::LAP_07).and_if(self.state.compensation != 40, cite::LAP_16);
        Ok(())
    }

    /// A motion of the contour is about to be made, in contour coordinates: it is moved into its place.
    #[cold]
    pub(in crate::engine) fn place_element(&mut self, element: &mut Element) -> Result<(), Fault> {
        let present = self.present();
        let Some(definition) = self.lap.definition_mut() else { return Ok(()) };
        let is_first = !std::mem::replace(&mut definition.placed, true);
        if is_first && matches!(element.kind, Kind::Arc { .. }) {
            return Err(malformed(LAP_05, const { Label::new("first") }));
        }
        if definition.purpose != Purpose::Finish {
            return Ok(());
        }
        if is_first {
            let Point { x: u, z: w } = definition.finish.allowances;
            let target = Point { x: element.x.unwrap_or(present.x), z: element.z.unwrap_or(present.z) };
            let side = |from: i64, to: i64| from.saturating_sub(to).signum();
            let (side_x, side_z) = (side(present.x, target.x), side(present.z, target.z));
            if u != 0 && side_x == 0 {
                return Err(unspecified(LAPC_06, const { Label::new("U") }));
            }
            if w != 0 && side_z == 0 {
                return Err(unspecified(LAPC_06, const { Label::new("W") }));
            }
            let side_x = if planted::is(Bug::ShiftOutward) { side_x.abs() } else { side_x };
            self.lap.shift = Point { x: side_x * u, z: side_z * w };
        }
        let shift = self.lap.shift;
        element.x = element.x.map(|x| x.saturating_add(shift.x));
        element.z = element.z.map(|z| z.saturating_add(shift.z));
        if let Kind::Arc { centre_x, centre_z, .. } = &mut element.kind {
            *centre_x = centre_x.saturating_add(shift.x);
            *centre_z = centre_z.saturating_add(shift.z);
        }
        Ok(())
    }

    /// A block with G80 is done: the contour is over, and the modes of the call come back.
    #[cold]
    pub(in crate::engine) fn finish_contour(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        self.check_end_of_definition()?;
        let Progress::Defining(definition) = std::mem::take(&mut self.lap.progress) else { return Ok(()) };
        self.lap.observes = false;
        self.lap.shift = Point::default();
        self.lap.cites = cite::Cites::default();
        self.state.base = None;
        const RULES: RuleSet = RuleSet::of(&[GCODE_02, LAP_13]);
        let Finish { motion, incremental, .. } = definition.finish;
        let motion = if planted::is(Bug::MotionOfContourStays) { self.state.motion } else { motion };
        let before = std::mem::replace(&mut self.state.motion, motion);
        if before != motion {
            self.emit_mode(sink, const { Label::new("motion") }, motion, before, RULES);
        }
        if std::mem::replace(&mut self.state.incremental, incremental) != incremental {
            let (code, previous) = if incremental { (91, 90) } else { (90, 91) };
            self.emit_mode(sink, const { Label::new("dimension") }, code, previous, RULES);
        }
        self.reader.seek(definition.back);
        Ok(())
    }
}

//! Which side runs, and which one is released (section "The order of the sides"; E100L-PSYNC-03 to E100L-PSYNC-08,
//! E100L-M100-01, E100L-M100-03, E100L-M100-05, E100L-AX4-06).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, Ending, Label, ReleaseCause, RuleId, RuleSet, Side, Sink,
};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::names::Names;
use crate::engine::slot::Slot;
use crate::engine::state::State;
use crate::engine::task::Turn;
use crate::engine::text::Reader;

use super::division::Division;
use super::{Lane, Record, Resume, Shared, Stage, Standing};

const SIDES: [Side; 2] = [Side::A, Side::B];

impl<'a> Interpreter<'a> {
    /// Carries out the next block of either side, or the end of the program.
    #[cold]
    pub(in crate::engine) fn step_saddles(&mut self, sink: &mut impl Sink) -> Result<Option<Ending>, Fault> {
        loop {
            match self.saddles.stage {
                Stage::Text => self.divide()?,
                Stage::Head => {
                    if self.with_slot(|interpreter, slot| interpreter.head_block(slot))? {
                        return Ok(None);
                    }
                    self.begin_sides();
                }
                Stage::Sides => match self.ready_side() {
                    Some(side) => {
                        self.turn_to(side);
                        if self.go_on(sink)? {
                            return Ok(None);
                        }
                    }
                    None if self.both_have_ended() => return self.end_saddles(sink).map(Some),
                    None => self.release_sides(sink)?,
                },
            }
        }
    }

    /// Divides the text; schedule programs are refused (E100L-AX4-12).
    fn divide(&mut self) -> Result<(), Fault> {
        let division = Division::new(self.reader.clone(), self.options);
        let schedule = division.schedule || self.setup.schedule && !self.reader.has_header();
        self.reader.confine(division.head.clone());
        self.saddles.division = division;
        self.saddles.stage = Stage::Head;
        if schedule {
            self.place = self.end_of_text();
            let detail = const { Label::new("schedule") };
            return Err(Fault::about(AlarmName::Unspecified, AX4_12, detail));
        }
        Ok(())
    }

    /// A block in front of the first selection, which must not count (E100L-AX4-02); false if there is none left.
    fn head_block(&mut self, slot: &mut Slot) -> Result<bool, Fault> {
        let found = self.read(slot, Turn::Now);
        self.place = slot.place;
        if !found? {
            return if self.saddles.division.sides.is_some() { Ok(false) } else { Err(self.end_missing()) };
        }
        if slot.parsed.is_only_name() {
            return Ok(true);
        }
        Err(Fault::about(AlarmName::Unspecified, AX4_02, const { Label::new("turret") }))
    }

    /// Both sides begin, each with its own data.
    fn begin_sides(&mut self) {
        let division = &self.saddles.division;
        let sides = division.sides.as_ref().map(|sides| (sides.a.clone(), sides.b.clone()));
        let counts = division.counts;
        if let Some((a, b)) = sides {
            self.begun = true;
            // The names in front of the selection are those of neither side.
            self.names = Names::default();
            self.reader.confine(a);
            let mut reader: Reader<'a> = self.reader.clone();
            reader.confine(b);
            self.saddles.idle = Some(Box::new(Lane {
                reader,
                names: Names::default(),
                begun: true,
                ahead: Default::default(),
                ahead_count: 0,
                current: None,
                place: self.place,
                inch_block: false,
                state: State::of_saddle_b(self.setup),
                task: self.task.of_other_side(),
                compensation: Default::default(),
            }));
        }
        for side in SIDES {
            let standing = if *counts.of(side) { Standing::Ready } else { Standing::Ended };
            let alone = !*counts.of(side.other());
            *self.saddles.records.of_mut(side) = Record { standing, alone, ..Record::default() };
        }
        self.saddles.stage = Stage::Sides;
    }

    fn ready_side(&self) -> Option<Side> {
        SIDES.into_iter().find(|side| self.saddles.records.of(*side).standing == Standing::Ready)
    }

    fn both_have_ended(&self) -> bool {
        SIDES.into_iter().all(|side| self.saddles.records.of(side).standing == Standing::Ended)
    }

    /// The side that runs goes on with the block that it waited at, or with the next one; whether it is the next.
    fn go_on(&mut self, sink: &mut impl Sink) -> Result<bool, Fault> {
        let resume = std::mem::take(&mut self.record_mut().resume);
        self.with_slot(|interpreter, slot| match resume {
            Resume::NextBlock => interpreter.next_block(slot, sink),
            Resume::Checks => interpreter.carry_out(slot, sink),
            Resume::Conclusion(plan) => interpreter.finish_steps(slot, plan, true, sink),
        })?;
        Ok(resume == Resume::NextBlock)
    }

    /// Both sides wait, or one waits and the other one has ended: the first row that fits.
    fn release_sides(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        use Standing::{AtM100, AtP, Ended};
        let [a, b] = SIDES.map(|side| self.saddles.records.of(side).standing);
        match (a, b) {
            (AtP(p), AtP(q)) if p == q => return self.release_pair(sink),
            (AtP(p), AtP(q)) => return self.release_smaller(if p < q { Side::A } else { Side::B }, sink),
            (AtP(_), AtM100) => self.release_side(Side::B, ReleaseCause::PCode, M100_05, sink),
            (AtM100, AtP(_)) => self.release_side(Side::A, ReleaseCause::PCode, M100_05, sink),
            (AtM100, AtM100) => {
                for side in SIDES {
                    self.release_side(side, ReleaseCause::Counterpart, M100_01, sink);
                }
            }
            (waits, Ended) => self.release_alone(Side::A, waits, sink),
            (_, waits) => self.release_alone(Side::B, waits, sink),
        }
        Ok(())
    }

    fn release_side(&mut self, side: Side, cause: ReleaseCause, rule: RuleId, sink: &mut impl Sink) {
        self.turn_to(side);
        let (p, code) = self.record().standing.stop_point();
        self.record_mut().standing = Standing::Ready;
        self.emit(sink, RuleSet::of(&[rule]), Action::Release { p, code, cause });
    }

    /// The other side has ended.
    fn release_alone(&mut self, side: Side, waits: Standing, sink: &mut impl Sink) {
        let rule = if waits == Standing::AtM100 { M100_03 } else { PSYNC_04 };
        self.release_side(side, ReleaseCause::OtherEnded, rule, sink);
        self.record_mut().alone = true;
    }

    /// The side with the smaller P goes on; it commands nothing that both have to command.
    fn release_smaller(&mut self, side: Side, sink: &mut impl Sink) -> Result<(), Fault> {
        self.turn_to(side);
        if !self.record().common.is_empty() {
            return Fault::raise(AlarmName::SidesDiffer, AX4_06);
        }
        self.release_side(side, ReleaseCause::Smaller, PSYNC_03, sink);
        Ok(())
    }

    /// Both sides go on: the block of each is carried out, their common words by that of A.
    fn release_pair(&mut self, sink: &mut impl Sink) -> Result<(), Fault> {
        self.turn_to(Side::A);
        let records = &self.saddles.records;
        if records.a.common != records.b.common {
            return Fault::raise(AlarmName::SidesDiffer, AX4_06);
        }
        for side in SIDES {
            self.release_side(side, ReleaseCause::Equal, PSYNC_03, sink);
        }
        for (side, shared) in SIDES.into_iter().zip([Shared::ForBoth, Shared::Done]) {
            self.turn_to(side);
            self.saddles.shared = shared;
            self.go_on(sink)?;
        }
        self.saddles.shared = Shared::No;
        Ok(())
    }
}

//! Schedule programs: PSELECT of main programs that are grown beside the forecast, VSET, jumps and loops, END.
//!
//! A main program that is selected once is grown like any program; modes, position and variables stay for the next one,
//! since M02 does not reset in a schedule. One that runs again begins with modes and a position of its own, or is
//! a short one whose effect is known.

mod loops;
mod main_program;
mod select;
mod short;

use std::collections::BTreeMap;
use std::rc::Rc;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::profile::Profile;
use crate::program::{Block, Item, Line, Program, Statement};
use crate::state::{Mode, State};

use main_program::Main;

/// What the generator knows of a schedule's files.
#[derive(Clone, Default, Debug)]
pub struct Schedule {
    /// Files with main programs and subprograms.
    pub(crate) files: BTreeMap<&'static str, Vec<Line>>,
    /// Main programs that may be selected again.
    mains: Vec<Rc<Main>>,
    /// Files that were named as subprogram files.
    subprograms: Vec<&'static str>,
    /// Whether the schedule is to lack its END.
    pub(crate) endless: bool,
    /// Whether the program is a schedule.
    pub(crate) active: bool,
    /// Whether a main program left the profile.
    misfit: bool,
}

/// Headers of schedules.
const HEADERS: &[&[u8]] = &[b"$DAY1.SDF%", b"$SHAFT-1.SDF%", b"$A.SDF% ", b"$X.Y.SDF%"];

/// Lines between the blocks.
const FILLERS: &[&[u8]] = &[b"(MORNING SHIFT)", b"", b"  ", b"%", b"\t(A)"];

/// What stands behind END, where nothing is read.
const BEHIND: &[&[u8]] = &[b"X??", b"N9 END", b"%", b"PSELECT", b"(OPEN", b"VSET V1=VDOUT[1]"];

/// What a block of a schedule does.
#[derive(Clone, Copy)]
enum Construction {
    Select,
    Set,
    Over,
    Known,
    Loop,
}

/// Whether a profile has room for schedules: what the words of their files need is not told apart from the other features,
/// so only the one with everything has.
pub(crate) fn is_within(profile: &Profile) -> bool {
    profile.is_full()
}

impl Builder<'_, '_, '_> {
    /// Writes the whole schedule.
    pub(crate) fn build_schedule(&mut self) {
        self.state.schedule.active = true;
        let foreign = self.schedule_beginning();
        let size = 1 + self.choices.below(8).min(1 + self.choices.below(8));
        let faulty = self.choices.chance(42) && self.allows(Feature::Alarm);
        let own = self.choices.chance(65);
        let place = if faulty && own && !foreign { self.choices.late(size + 1) } else { usize::MAX };
        if faulty && !own {
            let fault = self.any_fault();
            let place = self.choices.late(16);
            self.fault_in(fault, place);
        }
        for block in 0..=size {
            if block == place && self.schedule_fault() && self.choices.chance(70) {
                break;
            }
            if block == size || self.choices.is_empty() || self.is_spoilt() {
                break;
            }
            if self.choices.chance(10) {
                self.schedule_filler();
            }
            self.within_profile(3, |builder| {
                builder.schedule_block();
                !builder.state.schedule.misfit
            });
        }
        if !self.state.schedule.endless {
            self.schedule_line(Statement::End, Vec::new());
            if self.choices.chance(15) {
                let text = self.choices.pick(BEHIND);
                if self.profile.permits_text(text, Mode::Rapid) {
                    self.raw(text);
                }
            }
        }
    }

    /// The header, or the flag of the set-up instead; true when a header says that the text is no schedule.
    fn schedule_beginning(&mut self) -> bool {
        if self.state.is_eia() || self.choices.chance(30) {
            return false;
        }
        if self.choices.chance(2) && self.allows(Feature::Alarm) {
            self.raw(b"$DAY1.MIN%");
            return true;
        }
        self.state.setup.schedule = self.choices.chance(5);
        let header = self.choices.pick(HEADERS);
        self.raw(header);
        false
    }

    fn schedule_filler(&mut self) {
        let text = self.choices.pick(FILLERS);
        if self.profile.permits_text(text, Mode::Rapid) {
            self.raw(text);
        }
    }

    /// One of the constructions.
    fn schedule_block(&mut self) {
        let text = !self.state.is_eia() && self.allows(Feature::Expression);
        let jumps = self.allows(Feature::ControlStatement) && self.allows(Feature::SequenceName);
        let sets = text && self.allows(Feature::Variable);
        let weight = |weight, holds: bool| if holds { weight } else { 0 };
        let list = [
            (45, Construction::Select),
            (weight(18, sets), Construction::Set),
            (weight(6, jumps), Construction::Over),
            (weight(10, jumps && text), Construction::Known),
            (weight(11, jumps && sets && !self.state.control.steady), Construction::Loop),
        ];
        match self.choices.weighted(&list) {
            Construction::Select => self.select_program(),
            Construction::Set => self.vset(),
            Construction::Over => self.schedule_over(),
            Construction::Known => self.schedule_condition(),
            Construction::Loop => self.schedule_loop(),
        }
    }

    /// A block of a schedule: no slash stands in it.
    fn schedule_line(&mut self, statement: Statement, items: Vec<Item>) {
        self.state.control.jumps |= matches!(statement, Statement::Goto(_) | Statement::If(..));
        let sequence = self.next_name();
        self.lines.push(Line::Block(Block { delete: false, sequence, statement: Some(statement), items }));
    }

    /// A block with VSET.
    fn vset(&mut self) {
        self.begin();
        let mut items = Vec::new();
        for _ in 0..=self.choices.below(3) {
            items.push(self.set_item());
            self.state.begin_block();
        }
        self.schedule_line(Statement::Vset, items);
    }

    /// An assignment of VSET.
    fn set_item(&mut self) -> Item {
        let system = self.allows(Feature::SystemVariable);
        let io = system && self.allows(Feature::InputOutput) && self.state.setup.options.user_task == 2;
        if self.state.control.steady {
            return self.changing_common();
        }
        let weight = |weight, holds: bool| if holds { weight } else { 0 };
        match self.choices.weighted(&[
            (50, 0),
            (weight(18, system), 1),
            (weight(12, io), 2),
            (weight(8, system && self.allows(Feature::UserAlarm)), 3),
            (weight(6, system), 4),
            (weight(8, io), 5),
        ]) {
            1 => self.system(),
            2 => self.output_assignment(),
            3 => self.comment_item(),
            4 => self.interference_assignment(),
            5 => self.input_assignment(),
            _ => self.common(),
        }
    }

    /// The schedule and its files; programs that are called from anywhere stand in files that are always looked into.
    pub(crate) fn finish_schedule(mut self) -> (Program, State) {
        const FILES: &[&str] = &["A.SSB", "PROBE.SSB", "MAKER-1.MSB", "Z-9.MSB"];
        let lines = std::mem::take(&mut self.lines);
        for called in self.state.control.take_programs() {
            let file = self.choices.pick(FILES);
            self.add_program(file, &called);
        }
        self.bound_steps();
        let files = std::mem::take(&mut self.state.schedule.files);
        let library = files.into_iter().map(|(name, lines)| (name.to_owned(), lines)).collect();
        (Program { lines, library }, self.state)
    }
}

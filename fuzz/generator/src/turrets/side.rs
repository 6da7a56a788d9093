//! Programs for two saddles: each side is grown around its stops, beside a forecast of its own.

use turnspec_oracle::vocabulary::{AlarmName, Feature, Setup, Side};

use crate::builder::{ATTEMPTS, Builder};
use crate::faults::{self, Fault};
use crate::program::Line;
use crate::state::{Mode, State};

use super::common;
use super::plan::{Plan, SidePlan};

/// What a program for two saddles does not have (E100L-AX4-12), and the barriers, which are not modelled there.
const REFUSED: &[Feature] = &[
    Feature::Barrier,
    Feature::Communication,
    Feature::ControlStatement,
    Feature::InputOutput,
    Feature::MacroCode,
    Feature::ModalCall,
    Feature::Schedule,
    Feature::Subprogram,
    Feature::SystemVariable,
    Feature::UserAlarm,
    Feature::Variable,
    Feature::WAxis,
];

/// Alarms of programs for two saddles, and some that are found there in another way.
const FAULTS: &[(usize, Fault)] = &[
    (30, AlarmName::SidesDiffer),
    (34, AlarmName::Unspecified),
    (6, AlarmName::AddressRange),
    (6, AlarmName::CompensationNotAllowed),
    (4, AlarmName::NoProgramEnd),
    (4, AlarmName::SequenceNameDuplicate),
    (3, AlarmName::ProgramNameMisplaced),
    (3, AlarmName::NotModelled),
    (3, AlarmName::AngleLookahead),
    (3, AlarmName::VariableNumber),
];

/// Blocks in front of the first selection (E100L-AX4-02).
const IN_FRONT: &[&str] =
    &["G00 X5", "M08", "N5 G00 X5", "M02", "G13 X5", "G14 G13", "P10", "S500", "G14 M08", "NAB G18"];

impl Builder<'_, '_, '_> {
    /// Writes the whole program.
    pub(crate) fn build_sides(&mut self) {
        let faulty = self.choices.chance(38) && self.allows(Feature::Alarm);
        let fault = if faulty { Some(self.fault_of_sides()) } else { None };
        let mut plan = Plan::draw(self.choices);
        plan.give_words(self.choices, &self.whole);
        let mut placed = match fault {
            Some(AlarmName::SidesDiffer) if self.choices.chance(70) => {
                plan.make_differ(self.choices, &self.whole)
            }
            Some(AlarmName::NoProgramEnd) => {
                plan.sides.iter_mut().for_each(|side| side.ends = false);
                plan.sides.iter_mut().flat_map(|side| &mut side.stops).for_each(|stop| stop.at_end = false);
                true
            }
            _ => false,
        };
        placed |= self.front(fault);
        let front = std::mem::take(&mut self.lines);
        self.narrow(self.whole.without(REFUSED));
        let b_has_it = !plan.sides[1].absent && (plan.sides[0].absent || self.choices.chance(50));
        let fault = fault.filter(|fault| !placed && !faults::is_first(*fault));
        let a = self.side(&plan, Side::A, fault.filter(|_| !b_has_it));
        let saddle_b = State::new(setup_of_b(&self.state.setup));
        let state = std::mem::replace(&mut self.state, saddle_b);
        let b = self.side(&plan, Side::B, fault.filter(|_| b_has_it));
        let saddle_b = std::mem::replace(&mut self.state, state);
        self.state.setup.turret_b.torque_stops = saddle_b.setup.inputs.torque_stops;
        self.state.control.jumps |= saddle_b.control.jumps;
        let mut sides = [a, b];
        self.share_names(&mut sides);
        self.lines = front;
        let text = self.portions(sides);
        self.lines.extend(text);
    }

    /// A fault, mostly one of programs for two saddles.
    fn fault_of_sides(&mut self) -> Fault {
        if self.choices.chance(if self.threads || self.cycles { 35 } else { 70 }) {
            return self.choices.weighted(FAULTS);
        }
        self.any_fault()
    }

    /// What stands in front of the first selection; true when the fault is there.
    fn front(&mut self, fault: Option<Fault>) -> bool {
        let first = fault.is_some_and(faults::is_first);
        if first && fault.is_some_and(|fault| self.try_fault(fault)) {
            return true;
        }
        let undescribed = fault == Some(AlarmName::Unspecified);
        let scheduled = self.allows(Feature::Schedule) && self.allows(Feature::ProgramName);
        if undescribed && scheduled && self.choices.chance(6) {
            self.state.setup.schedule = self.state.is_eia() || self.choices.chance(50);
            if !self.state.setup.schedule {
                self.raw(b"$PAIR.SDF%");
            }
            return true;
        }
        if self.allows(Feature::ProgramName) {
            self.within_profile(ATTEMPTS, Self::beginning);
        }
        if self.choices.chance(15) {
            let skips = self.state.setup.switches.block_delete;
            let list: [&[u8]; 4] = [b"", b"(TWO SADDLES)", b"N9999", b"/G00 X5"];
            let text = self.choices.pick(&list[..if skips { 4 } else { 3 }]);
            if self.profile.permits_text(text, Mode::Rapid) {
                self.raw(text);
            }
        }
        if undescribed && self.choices.chance(10) {
            let text = self.choices.pick(IN_FRONT);
            return self.profile.permits_text(text.as_bytes(), Mode::Rapid) && self.blocks(&[text]);
        }
        false
    }

    /// The program of a side, with a fault or without.
    fn side(&mut self, plan: &Plan, side: Side, fault: Option<Fault>) -> Vec<Line> {
        let SidePlan { stops, ends, absent } = &plan.sides[side as usize];
        self.begin_side();
        if *absent {
            return Vec::new();
        }
        let mut alone = plan.sides[side.other() as usize].absent;
        self.stay_within(alone);
        let sizes: Vec<usize> = (0..=stops.len()).map(|_| self.choices.below(7)).collect();
        if let Some(fault) = fault {
            let total = sizes.iter().sum();
            let place = self.choices.late(total);
            self.fault_in(fault, place);
        }
        for (stop, size) in stops.iter().zip(&sizes) {
            self.grow_blocks(*size);
            if self.is_spoilt() {
                break;
            }
            self.stop_block(stop);
            alone |= stop.frees;
            self.stay_within(alone);
        }
        if !self.is_spoilt() && !stops.last().is_some_and(|stop| stop.at_end) {
            self.grow_blocks(sizes.last().copied().unwrap_or_default());
            if self.state.compensation.has_to_go_on() {
                self.ordinary_block();
            }
            if *ends && !self.within_profile(ATTEMPTS, Self::ending) {
                self.raw(b"M02");
            }
        }
        if self.lines.is_empty() {
            // Without a block the other side would be alone from the start.
            self.raw(b"M02");
        }
        std::mem::take(&mut self.lines)
    }

    /// Leaves common words to the stops while the side is not alone.
    fn stay_within(&mut self, alone: bool) {
        let profile = self.whole.without(REFUSED);
        self.profile = if alone { profile } else { profile.without(common::FEATURES) };
        self.state.environment.restrict(&self.profile);
    }
}

/// The set-up as saddle B sees it.
fn setup_of_b(setup: &Setup) -> Setup {
    let mut own = setup.clone();
    let b = &setup.turret_b;
    (own.start.x, own.start.z) = (b.start.x, b.start.z);
    (own.zero_offset.x, own.zero_offset.z) = (b.zero_offset.x, b.zero_offset.z);
    (own.limits.x, own.limits.z) = (b.limits.x, b.limits.z);
    own.tool_offset.clone_from(&b.tool_offset);
    own.nose_radius.clone_from(&b.nose_radius);
    own.inputs.torque_stops.clear();
    own
}

//! What the cycles of driven tools remember from block to block (execution of drilling, 2; E100L-MCYC-09,
//! E100L-MCYC-22).

use turnspec_oracle::vocabulary::{Part, Sink};

use crate::engine::Interpreter;
use crate::engine::codes::GGroup;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{X, Z};
use crate::engine::words::{Address, Words};

use super::axis::Axis;
use super::cites::cycle_rules;
use super::motion::Move;
use super::{CycleBlock, END_CONVERSION, MACHINING, NO_CYCLE};

/// The kept words: program coordinates and amounts.
#[derive(Clone, Copy, Debug, Default)]
pub struct Data {
    pub x: Option<i64>,
    pub z: Option<i64>,
    pub i: Option<i64>,
    pub k: Option<i64>,
    pub d: Option<i64>,
    pub l: Option<i64>,
    pub u: Option<i64>,
    pub w: Option<i64>,
    /// The depth from the cutting start.
    pub r: Option<i64>,
    /// A time in microseconds; of G190 a feed in picometres per minute.
    pub e: Option<i64>,
}

impl Data {
    /// The coordinate of an axis.
    pub fn coordinate(&self, axis: Axis) -> i64 {
        match axis {
            Axis::X => self.x,
            Axis::Z => self.z,
        }
        .unwrap_or_default()
    }

    /// The amount along an axis.
    pub fn amount(&self, axis: Axis) -> Option<i64> {
        match axis {
            Axis::X => self.i,
            Axis::Z => self.k,
        }
    }

    /// The words of a block replace what is kept.
    fn take(&mut self, words: &Words) {
        let slots = [
            (&mut self.x, Address::X),
            (&mut self.z, Address::Z),
            (&mut self.i, Address::I),
            (&mut self.k, Address::K),
            (&mut self.d, Address::D),
            (&mut self.l, Address::L),
            (&mut self.u, Address::U),
            (&mut self.w, Address::W),
            (&mut self.r, Address::R),
        ];
        for (slot, address) in slots {
            *slot = words.get(address).or(*slot);
        }
    }
}

/// The state of the cycles.
#[derive(Clone, Copy, Debug)]
pub struct Kept {
    /// The cycle code in force, G180 for none.
    pub code: u16,
    /// SA in thousandths of a revolution per minute.
    pub c_speed: Option<i64>,
    /// The cycle start, machine X and Z.
    pub(super) start: [i64; 2],
    /// The infeed axis of a hole cycle.
    pub(super) axis: Axis,
    /// That of the cut, 1 or -1.
    pub(super) direction: i64,
    pub(super) data: Data,
    /// Program C at which the passes of a thread begin.
    pub(super) c: i64,
    /// A block with Q was carried out.
    pub(super) spent: bool,
    /// G180 has ended a mode, and no word came since.
    pub(super) after_cancel: bool,
    /// The angle of the tool at which taps start.
    pub(super) start_angle: i64,
    /// M212.
    pub(super) zigzag: bool,
    /// M214.
    pub(super) equal: bool,
    /// Whether the block in progress has made a cutting pass.
    pub(super) has_cut: bool,
}

impl Default for Kept {
    fn default() -> Self {
        Self {
            code: NO_CYCLE,
            c_speed: None,
            start: [0; 2],
            axis: Axis::Z,
            direction: 0,
            data: Data::default(),
            c: 0,
            spent: false,
            after_cancel: false,
            start_angle: 0,
            zigzag: false,
            equal: false,
            has_cut: false,
        }
    }
}

impl Kept {
    /// Whether a block has to do with the cycles: a mode is in force, or has just ended, or begins.
    #[inline]
    pub fn concerns(&self, words: &Words) -> bool {
        self.code != NO_CYCLE || self.after_cancel || words.code_of(GGroup::Cycle).is_some()
    }

    /// What a block is.
    pub(super) fn block(&self, words: &Words) -> CycleBlock {
        let in_mode = self.code != NO_CYCLE;
        match words.code_of(GGroup::Cycle) {
            Some(NO_CYCLE) if in_mode => CycleBlock::Cancel(self.code),
            Some(NO_CYCLE) => CycleBlock::None,
            Some(_) if !in_mode => CycleBlock::First,
            None if !in_mode || !words.any() => CycleBlock::None,
            _ if words.has_any(MACHINING) => CycleBlock::Follow,
            _ => CycleBlock::Keep,
        }
    }

    /// A block has passed its checks.
    #[inline]
    pub fn begin_block(&mut self, words: &Words) {
        if self.after_cancel && words.any() {
            self.after_cancel = words.has_g(END_CONVERSION) && !planted::is(Bug::ConversionEndsDuty);
        }
        self.has_cut = false;
    }

    /// An M code that key ways look at (E100L-MCODE-38).
    pub fn switch(&mut self, code: u16) {
        match code {
            211 | 212 => self.zigzag = code == 212,
            _ => self.equal = code == 214,
        }
    }
}

impl Interpreter<'_> {
    /// The cycle start as a program coordinate now.
    pub(super) fn cycle_start(&self, axis: Axis) -> i64 {
        let [x, z] = self.state.cycle.start;
        let machine = match axis {
            Axis::X => x,
            Axis::Z => z,
        };
        machine.saturating_sub(self.state.frame(axis.place()))
    }

    /// The first block of a mode: it begins where the tool stands.
    pub(super) fn begin_cycle(&mut self, words: &Words) {
        let machine = self.state.machine;
        let kept = &mut self.state.cycle;
        kept.start = [machine[X], machine[Z]];
        kept.axis = if words.has(Address::K) { Axis::Z } else { Axis::X };
        kept.data = Data::default();
    }

    /// The words of a block are kept; bottom and R replace each other.
    pub(super) fn keep_words(&mut self, words: &Words) {
        let code = self.state.cycle.code;
        let synchronised = self.is_synchronised(code);
        let kept = &mut self.state.cycle;
        let data = &mut kept.data;
        data.take(words);
        if words.has(Address::R) {
            match kept.axis {
                Axis::X => data.x = None,
                Axis::Z => data.z = None,
            }
        } else if words.has(kept.axis.word()) && !planted::is(Bug::DepthOverBottom) {
            data.r = None;
        }
        if words.has(Address::E) {
            let unit = if code == 190 { self.units.feed[0] } else { self.units.time };
            data.e = Some(words.exact_e.rounded(unit, 1));
        }
        if synchronised && words.has(Address::D) {
            kept.start_angle = words.exact_d.rounded(self.units.angle, 1000);
        }
    }

    /// G180 has ended the mode of a code: the axes return from a chain of threads (E100L-CTHR-04).
    pub(super) fn cancel_cycle(
        &mut self,
        words: &Words,
        code: u16,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        self.state.cycle.spent = false;
        self.state.cycle.after_cancel = true;
        if !super::is_chain(code) || planted::is(Bug::ChainStays) {
            return Ok(());
        }
        let end = [Axis::X, Axis::Z]
            .into_iter()
            .fold(self.present(), |point, axis| axis.put(point, self.cycle_start(axis)));
        let cited = self.cited_in_cycle(words).and(cycle_rules(code, false));
        self.go(&Move::rapid(end, None, Part::Return, cited), sink)
    }
}

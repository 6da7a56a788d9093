//! The checks of a block before anything of it is carried out (execution, chapter 5).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Chamfering, Label};

use super::Interpreter;
use super::codes::GGroup;
use super::compensation::Change;
use super::contour;
use super::cycle::{self, CycleBlock};
use super::fault::Fault;
use super::lap::Code;
use super::plain::plain_plan;
use super::planted::{self, Bug};
use super::thread;
use super::words::{Address, Parsed, Words};

/// What a block does besides its modal codes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OneShot {
    None,
    Dwell,
    TorqueSkip,
    TorqueOff,
    TorqueLimit,
    ZeroShift,
    Chamfer,
    Rounding,
    /// G71.
    ThreadAlong,
    /// G72.
    ThreadAcross,
    /// G136.
    EndConversion,
    /// G137.
    BeginConversion,
    /// G73.
    GrooveAcross,
    /// G74.
    GrooveAlong,
    /// G77.
    TapRight,
    /// G78.
    TapLeft,
    /// A definition of LAP, or a call of one.
    Lap(Code),
}

impl OneShot {
    /// That of the words of a block. None outlasts it: each corner needs its own G75 or G76 (E100L-CHAM-06).
    fn of(words: &Words) -> Self {
        match words.code_of(GGroup::OneShot) {
            Some(4) => Self::Dwell,
            Some(22) => Self::TorqueSkip,
            Some(28) => Self::TorqueOff,
            Some(29) => Self::TorqueLimit,
            Some(50) => Self::ZeroShift,
            Some(75) => Self::Chamfer,
            Some(71) => Self::ThreadAlong,
            Some(72) => Self::ThreadAcross,
            Some(73) => Self::GrooveAcross,
            Some(74) => Self::GrooveAlong,
            Some(77) => Self::TapRight,
            Some(78) => Self::TapLeft,
            Some(76) => Self::Rounding,
            Some(136) => Self::EndConversion,
            Some(137) => Self::BeginConversion,
            Some(code) => Code::of(code).map_or(Self::None, Self::Lap),
            None => Self::None,
        }
    }

    /// Whether the block cuts a corner.
    pub fn is_chamfer(self) -> bool {
        matches!(self, Self::Chamfer | Self::Rounding)
    }

    /// Whether the block begins or ends coordinate conversion.
    pub fn is_conversion(self) -> bool {
        matches!(self, Self::EndConversion | Self::BeginConversion)
    }

    /// Whether the block cuts a whole thread.
    pub fn is_compound_thread(self) -> bool {
        matches!(self, Self::ThreadAlong | Self::ThreadAcross)
    }

    /// Whether the block cuts grooves, or drills with pecks.
    pub fn is_groove(self) -> bool {
        matches!(self, Self::GrooveAcross | Self::GrooveAlong)
    }

    /// Whether the block taps with the main spindle.
    pub fn is_tap(self) -> bool {
        matches!(self, Self::TapRight | Self::TapLeft)
    }
}

/// A checked block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Plan {
    pub one_shot: OneShot,
    /// The motion mode in force, as the state keeps it.
    pub motion: u16,
    /// Whether the block moves.
    pub moves: bool,
    /// Whether A is its only coordinate.
    pub only_angle: bool,
    /// What the block does to radius compensation.
    pub compensation: Change,
    /// What the block is to a cycle of driven tools.
    pub cycle: CycleBlock,
}

impl Plan {
    /// Whether it is an axis motion command of E100L-MODIN-03.
    pub fn is_axis_motion(&self, words: &Words) -> bool {
        let turns = planted::is(Bug::TriggeredByC) && words.has(Address::C);
        let coordinate = words.has_any(TRIGGERS) || turns;
        let line = self.one_shot == OneShot::None || self.one_shot.is_chamfer();
        self.moves && line && !self.cycle.acts() && !contour::is_mode(self.motion) && coordinate
    }

    /// Whether it is a thread block.
    pub fn cuts_thread(&self) -> bool {
        self.moves && self.one_shot == OneShot::None && thread::is_mode(self.motion) && !self.cycle.acts()
    }

    /// Whether an F word of the block is a lead (E100L-THRD-04).
    pub fn feeds_by_lead(&self) -> bool {
        let single = self.one_shot == OneShot::None && thread::is_mode(self.motion);
        self.one_shot.is_compound_thread() || single && !self.cycle.acts()
    }
}

const AXES: u64 =
    Address::set(&[Address::X, Address::Y, Address::Z, Address::C, Address::W, Address::A, Address::QA]);
const TRIGGERS: u64 = Address::set(&[Address::X, Address::Y, Address::Z]);
const ARC: u64 = Address::set(&[Address::I, Address::K, Address::L, Address::Calrg]);
const IMAGINARY: u64 = Address::set(&[Address::I, Address::K]);
pub(super) const ALWAYS: u64 =
    Address::set(&[Address::F, Address::S, Address::T, Address::SB, Address::SA, Address::P]);
pub(super) const ARC_TAKES: u64 =
    Address::set(&[Address::X, Address::Z, Address::I, Address::K, Address::L, Address::Calrg]);
const CHAMFER_TAKES: u64 = Address::set(&[Address::X, Address::Z, Address::A, Address::L]);
const SKIP_TAKES: u64 =
    Address::set(&[Address::Z, Address::W, Address::D, Address::L, Address::PZ, Address::PW]);
const LIMIT_TAKES: u64 = Address::set(&[Address::PZ, Address::PW]);
const SHIFT_TAKES: u64 = Address::set(&[Address::X, Address::Z, Address::C, Address::W]);

/// What the blocks before one leave to it.
#[derive(Clone, Copy)]
pub(super) struct Before {
    /// The motion mode.
    pub motion: u16,
    /// Whether the block before it is A-only.
    pub after_angle: bool,
    /// Whether a displacement of ended compensation is left over.
    pub left_over: bool,
}

impl Interpreter<'_> {
    /// Checks a block, and tells what it will do.
    pub(super) fn check(&self, parsed: &Parsed, words: &Words, before: Before) -> Result<Plan, Fault> {
        let motion = words.code_of(GGroup::Motion).unwrap_or(before.motion);
        if self.is_plain(words, motion, before.left_over) {
            let plan = plain_plan(words, motion);
            debug_assert_eq!(plan, self.check_whole(parsed, words, motion, before));
            return plan;
        }
        self.check_whole(parsed, words, motion, before)
    }

    /// The same by all checks.
    fn check_whole(
        &self,
        parsed: &Parsed,
        words: &Words,
        motion: u16,
        before: Before,
    ) -> Result<Plan, Fault> {
        let Before { after_angle, left_over, .. } = before;
        let threads = thread::is_mode(motion);
        let contours = contour::is_mode(motion);
        let one_shot = OneShot::of(words);
        check_alone(parsed, words)?;
        let lap = match one_shot {
            OneShot::Lap(code) => Some(code),
            _ => None,
        };
        if let Some(code) = lap {
            self.check_alone_in_lap(parsed, code)?;
        }
        let cycle = if self.state.cycle.concerns(words) {
            self.check_cycle_mode(parsed, words)?
        } else {
            CycleBlock::None
        };
        if self.state.contour.converts() {
            self.check_cycle_in_conversion(words, one_shot, cycle)?;
        }
        if cycle.in_mode() {
            self.check_cycle_block(words, cycle, left_over)?;
            let compensation = Change::None;
            return Ok(Plan { one_shot, motion, moves: true, only_angle: false, compensation, cycle });
        }
        let speed_mode = words.has_g(96) || words.has_g(97);
        if speed_mode && (!words.has(Address::S) || one_shot == OneShot::ZeroShift) {
            return Fault::raise(AlarmName::CuttingSpeedMissing, CSS_03);
        }
        if let Some(code) = lap {
            self.check_speed_in_lap(words, code)?;
        }
        let arc = matches!(motion, 2 | 3);
        let moving_words = match () {
            () if arc => AXES | ARC,
            () if threads => AXES | thread::WORDS,
            () if contours => AXES | contour::WORDS,
            () => AXES,
        };
        let free = one_shot == OneShot::None || one_shot.is_chamfer();
        let compound = one_shot.is_compound_thread();
        let bores = one_shot.is_groove() || one_shot.is_tap();
        let moves =
            words.has_any(moving_words) && (free || one_shot == OneShot::TorqueSkip) || compound || bores;
        let cuts = compound || threads && moves && one_shot == OneShot::None;
        if threads || compound {
            self.check_thread_speed(words, motion, cuts)?;
        }
        self.check_speed_turret(words)?;
        let compensation = self.compensation_change(words);
        let converted = self.state.contour.converts() && !one_shot.is_conversion();
        if converted || motion == contour::NO_CODE {
            let needs_code = free && moves || compensation != Change::None;
            self.check_conversion(words, (one_shot, motion), needs_code)?;
        }
        self.check_one_shot(words, one_shot, motion, after_angle)?;
        match lap {
            Some(code) => self.check_call(parsed, words, code, left_over)?,
            None if self.lap.is_active() || words.code_of(GGroup::OneShot) == Some(80) => {
                self.check_contour_block(words)?;
            }
            None => {}
        }
        if free && moves {
            if arc {
                check_arc(words)?;
            } else if threads {
                self.check_thread(words, motion, after_angle)?;
            } else if contours {
                self.check_contour(words, motion)?;
            } else {
                self.check_line(words, after_angle)?;
            }
            if words.has(Address::W) && !self.setup.options.w_axis {
                return Fault::raise(AlarmName::AxisMissing, AXIS_01);
            }
        }
        self.check_change_points(words, lap)?;
        match lap {
            Some(code) => self.check_words_of_call(parsed, words, code)?,
            None => {
                // I and K give an imaginary line in the plane of turning alone.
                let imaginary = compensation != Change::None && self.cutter_plane(words).is_none();
                check_functions(words, one_shot, motion, (imaginary, converted), self.lap.defines())?;
            }
        }
        if bores {
            self.check_bore_compensation(words, left_over)?;
        }
        if threads || compound {
            self.check_thread_compensation(words, motion, cuts, left_over)?;
        }
        if contours || converted || one_shot.is_conversion() {
            let contour_block = contours && free && moves;
            self.check_contour_compensation(
                words,
                (one_shot, compensation),
                (motion, contour_block),
                left_over,
            )?;
        }
        self.check_compensation(words, one_shot, (motion, moves, compensation), left_over)?;
        if words.has_m(100) && words.code_of(GGroup::Compensation).unwrap_or(self.state.compensation) != 40 {
            return Fault::raise(AlarmName::CompensationNotAllowed, M100_04);
        }
        let coordinate = words.has(Address::X) || words.has(Address::Z);
        let only_angle = free && !arc && !threads && words.has(Address::A) && !coordinate;
        Ok(Plan { one_shot, motion, moves, only_angle, compensation, cycle })
    }

    fn check_one_shot(
        &self,
        words: &Words,
        one_shot: OneShot,
        motion: u16,
        after_angle: bool,
    ) -> Result<(), Fault> {
        let missing = |rule| Fault::raise(AlarmName::WordMissing, rule);
        let w_axis = self.setup.options.w_axis;
        match one_shot {
            OneShot::None | OneShot::TorqueOff | OneShot::EndConversion | OneShot::Lap(_) => Ok(()),
            OneShot::BeginConversion => self.check_conversion_start(words),
            OneShot::Dwell if !words.has(Address::F) => missing(DWELL_01),
            OneShot::Dwell => Ok(()),
            OneShot::ZeroShift => {
                let axes = words.has_any(SHIFT_TAKES);
                if !axes && !words.has(Address::S) {
                    return missing(G50_01);
                }
                if words.has(Address::W) && !w_axis {
                    return Fault::raise(AlarmName::AxisMissing, AXIS_01);
                }
                if axes && words.get(Address::T).is_some_and(|tool| tool % 100 != 0) {
                    return Fault::raise(AlarmName::OffsetWithG50, G50_06);
                }
                Ok(())
            }
            OneShot::TorqueLimit => {
                if !words.has_any(LIMIT_TAKES) {
                    return missing(TRQ_01);
                }
                if words.has(Address::PW) && !w_axis {
                    return Fault::raise(AlarmName::AxisMissing, TRQ_01);
                }
                let most = i64::from(self.setup.parameters.torque_limit_upper);
                if [Address::PZ, Address::PW].iter().any(|word| words.get(*word) > Some(most)) {
                    return Fault::raise(AlarmName::TorqueLimitRange, TRQ_01);
                }
                Ok(())
            }
            OneShot::TorqueSkip => {
                let (z, w) = (words.has(Address::Z), words.has(Address::W));
                if z == w {
                    return missing(TRQ_03);
                }
                if w && !w_axis {
                    return Fault::raise(AlarmName::AxisMissing, TRQ_03);
                }
                if words.has(Address::PZ) != z || words.has(Address::PW) != w {
                    return missing(TRQ_03);
                }
                let Some(beyond) = words.get(Address::L).filter(|_| words.has(Address::D)) else {
                    return missing(TRQ_03);
                };
                if beyond < 0 {
                    return Fault::raise(AlarmName::AddressRange, ADDR_01);
                }
                Ok(())
            }
            OneShot::Chamfer | OneShot::Rounding => self.check_chamfer(words, one_shot, motion, after_angle),
            OneShot::ThreadAlong | OneShot::ThreadAcross => self.check_compound_thread(words, one_shot),
            OneShot::GrooveAcross | OneShot::GrooveAlong => self.check_groove(words, one_shot),
            OneShot::TapRight | OneShot::TapLeft => self.check_tap(words),
        }
    }

    fn check_chamfer(
        &self,
        words: &Words,
        one_shot: OneShot,
        motion: u16,
        after_angle: bool,
    ) -> Result<(), Fault> {
        let (x, z, a) = (words.has(Address::X), words.has(Address::Z), words.has(Address::A));
        if motion != 1 {
            return Fault::raise(AlarmName::ChamferNotLinear, CHAM_05);
        }
        let chamfering = self.setup.parameters.chamfering;
        if chamfering == Chamfering::Off {
            return Fault::raise(AlarmName::ChamferDisabled, CHAM_01);
        }
        if words.get(Address::L).unwrap_or_default() == 0 {
            let rule = if one_shot == OneShot::Chamfer { CHAM_02 } else { CHAM_10 };
            return Fault::raise(AlarmName::WordMissing, rule);
        }
        let basic = chamfering == Chamfering::Basic;
        if basic && (x == z || a) {
            return Fault::raise(AlarmName::ChamferAxes, CHAM_08);
        }
        if !(x || z || a) {
            return Fault::raise(AlarmName::ChamferAxes, ANG_05);
        }
        if (x || z) && self.task.modes_to_call() > 0 {
            let code = if one_shot == OneShot::Chamfer { "G75" } else { "G76" };
            return Err(Fault::about(AlarmName::Unspecified, MODIN_02, Label::new(code)));
        }
        if !basic && x && z && a && !after_angle {
            return Fault::raise(AlarmName::AngleOverdetermined, DTAP_01);
        }
        Ok(())
    }

    fn check_line(&self, words: &Words, after_angle: bool) -> Result<(), Fault> {
        if !words.has(Address::A) {
            return Ok(());
        }
        let (x, z) = (words.has(Address::X), words.has(Address::Z));
        if x && z && !after_angle {
            return Fault::raise(AlarmName::AngleOverdetermined, DTAP_01);
        }
        if !x && !z && self.setup.parameters.chamfering != Chamfering::AnyAngle {
            return Fault::raise(AlarmName::AngleUnderdetermined, DTAP_01);
        }
        if words.has_any(Address::set(&[Address::C, Address::QA, Address::W])) {
            return Fault::raise(AlarmName::AngleOverdetermined, DTAP_01);
        }
        Ok(())
    }
}

/// Some M codes stand alone in their block.
fn check_alone(parsed: &Parsed, words: &Words) -> Result<(), Fault> {
    if parsed.items.len() < 2 {
        return Ok(());
    }
    let codes = [(110, MCODE_24), (193, MCODE_36), (195, MCODE_37), (196, MCODE_37)];
    match codes.iter().find(|(code, _)| words.has_m(*code)) {
        Some((_, rule)) => Fault::raise(AlarmName::NotAlone, *rule),
        None if words.has_g(136) => Fault::raise(AlarmName::NotAlone, CSC_09),
        None if words.has_g(180) => Fault::raise(AlarmName::NotAlone, MCYC_02),
        None => Ok(()),
    }
}

pub(super) fn check_arc(words: &Words) -> Result<(), Fault> {
    let nothing = |address| words.get(address).unwrap_or_default() == 0;
    let (x, z) = (words.has(Address::X), words.has(Address::Z));
    if let Some(radius) = words.get(Address::L) {
        if words.has(Address::I) || words.has(Address::K) {
            return Fault::raise(AlarmName::ArcRadiusAndCentre, CIRC_15);
        }
        if radius <= 0 {
            return Fault::raise(AlarmName::ArcRadiusNotPositive, CIRC_13);
        }
        return if x && z { Ok(()) } else { Fault::raise(AlarmName::ArcRadiusNeedsBoth, CIRC_14) };
    }
    if words.has(Address::Calrg) {
        return Err(Fault::about(AlarmName::Unspecified, CIRC_18, Label::new("CALRG")));
    }
    if nothing(Address::I) && nothing(Address::K) {
        return Fault::raise(AlarmName::ArcWithoutCentre, CIRC_06);
    }
    if x || z { Ok(()) } else { Err(full_circle()) }
}

/// An arc that ends where it starts.
#[cold]
pub fn full_circle() -> Fault {
    Fault::about(AlarmName::Unspecified, CIRC_07, Label::new("circle"))
}

/// Every word needs a function that takes it.
fn check_functions(
    words: &Words,
    one_shot: OneShot,
    motion: u16,
    (imaginary, converted): (bool, bool),
    in_contour: bool,
) -> Result<(), Fault> {
    let takes = match one_shot {
        OneShot::None if matches!(motion, 2 | 3) => ARC_TAKES,
        OneShot::None if thread::is_mode(motion) => thread::takes(motion),
        OneShot::None if converted || contour::is_mode(motion) || motion == contour::NO_CODE => {
            contour::takes(motion, converted)
        }
        OneShot::None if imaginary => AXES | IMAGINARY,
        OneShot::None => AXES,
        OneShot::Dwell | OneShot::TorqueOff | OneShot::EndConversion | OneShot::Lap(_) => 0,
        OneShot::BeginConversion => contour::START_TAKES,
        OneShot::TorqueSkip => SKIP_TAKES,
        OneShot::TorqueLimit => LIMIT_TAKES,
        OneShot::ZeroShift => SHIFT_TAKES,
        OneShot::Chamfer | OneShot::Rounding => CHAMFER_TAKES,
        OneShot::ThreadAlong => thread::ALONG_TAKES,
        OneShot::ThreadAcross => thread::ACROSS_TAKES,
        OneShot::GrooveAcross | OneShot::GrooveAlong => cycle::GROOVE_TAKES,
        OneShot::TapRight | OneShot::TapLeft => cycle::TAP_TAKES,
    };
    check_taken(words, takes | if in_contour { Address::E.bit() } else { 0 })
}

/// The first word in written order that is not one of a set.
pub(super) fn check_taken(words: &Words, takes: u64) -> Result<(), Fault> {
    let takes = takes | ALWAYS;
    if words.present() & !takes == 0 {
        return Ok(());
    }
    match words.order().iter().find(|address| address.bit() & takes == 0) {
        Some(address) => {
            Err(Fault::about(AlarmName::WordWithoutFunction, ADDR_01, Label::new(address.text())))
        }
        None => Ok(()),
    }
}

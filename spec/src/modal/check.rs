//! What a block as a whole must satisfy before anything of it is carried out.

use super::compensation::{self, CutterPlane};
use super::function::every_word_has_a_function;
use super::machine::check_reference;
use super::words::Words;
use crate::contour;
use crate::controls::e100l::g_codes::{GCode, GGroup, g_code};
use crate::cycle::{self, CycleBlock};
use crate::fault::{Fault, Outcome, fail};
use crate::lap;
use crate::state::{Modes, State};
use crate::thread;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Chamfering, Label, Setup};

/// A block that can be carried out.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Its words.
    pub words: Words,
    /// The modes that its G codes select.
    pub modes: Modes,
    /// Its one-shot G code.
    pub one_shot: Option<u16>,
    /// What it does to radius compensation.
    pub compensation: Change,
    /// The plane of rotary tools in which G41 or G42 was or is in force.
    pub cutter: Option<CutterPlane>,
    /// What it is in a cycle of driven tools.
    pub cycle: Option<CycleBlock>,
    /// Whether it moves axes.
    pub moves: bool,
    /// Whether it is a block in conversion mode: that began in G137, and has no word G136 or G137.
    pub converts: bool,
}

/// What a block does to radius compensation (E100L-NRC-14, E100L-NRC-66).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Change {
    /// Its own words select G41 or G42 where G40 was in force.
    Begins,
    /// Its own words select G40 where G41 or G42 was in force.
    Ends,
    /// Neither.
    Stays,
}

impl Plan {
    /// Its motion code: 0 to 3, 31 to 35, 101 to 103, 132, 133; [`Modes::NO_CODE`] if none is in force.
    pub fn motion(&self) -> u16 {
        self.modes.get(GGroup::Motion)
    }

    /// Whether it is a chamfer or rounding block.
    pub fn is_chamfer(&self) -> bool {
        matches!(self.one_shot, Some(75 | 76))
    }

    /// Whether it cuts a thread in a motion mode, G31 to G35.
    pub fn is_thread(&self) -> bool {
        self.moves && self.one_shot.is_none() && self.cycle.is_none() && thread::is_mode(self.motion())
    }

    /// Whether it generates a contour with the C axis.
    pub fn is_contour(&self) -> bool {
        self.moves && self.one_shot.is_none() && self.cycle.is_none() && contour::is_mode(self.motion())
    }

    /// Whether it is a compound thread cycle.
    pub fn is_compound(&self) -> bool {
        matches!(self.one_shot, Some(71 | 72))
    }

    /// Whether it is a fixed cycle: G71 to G74, G77, G78, or a block of a cycle of driven tools.
    pub fn has_passes(&self) -> bool {
        let grooves_or_taps = cycle::is_groove(self.one_shot) || cycle::is_tapping(self.one_shot);
        self.is_compound() || grooves_or_taps || self.cycle.is_some()
    }

    /// Whether it is a call of LAP.
    pub fn is_contour_call(&self) -> bool {
        matches!(self.one_shot, Some(85..=88))
    }

    /// Whether it begins a definition of LAP.
    pub fn begins_definition(&self) -> bool {
        matches!(self.one_shot, Some(81..=83))
    }

    /// Whether it is a motion that modal calls come after (E100L-MODIN-03).
    pub fn triggers(&self) -> bool {
        let acts = self.one_shot != Some(22) && !self.has_passes() && !self.is_contour();
        self.moves && acts && self.words.has_any("XYZ")
    }

    /// Whether it moves in a plane of rotary tools (CRC-14): on the face along X or C, on the side along Z or C.
    pub fn moves_in(&self, plane: CutterPlane) -> bool {
        let letters = match plane {
            CutterPlane::Face if self.converts => "XY",
            CutterPlane::Face => "XC",
            CutterPlane::Side => "ZC",
        };
        self.moves && self.one_shot.is_none() && self.cycle.is_none() && self.words.has_any(letters)
    }

    /// Whether an angle is all that it says of its end point (E100L-ANG-06).
    pub fn is_angle_only(&self) -> bool {
        let line = self.motion() <= 1 || self.is_thread() && matches!(self.motion(), 34 | 35);
        self.moves && line && self.words.get('A').is_some() && !self.words.has_any("XZ")
    }
}

/// What the blocks before a block leave behind.
#[derive(Clone, Copy, Debug)]
pub struct Before {
    /// The modes.
    pub modes: Modes,
    /// Whether the block before had an angle alone.
    pub after_angle: bool,
    /// Whether a displacement of radius compensation is left over (E100L-NRC-71).
    pub left_over: bool,
    /// Whether a motion of X or Z calls programs (E100L-MODIN-02).
    pub modal: bool,
    /// Whether the program has the block that a call of LAP names (E100L-LAP-09).
    pub has_contour: bool,
}

/// Checks the words of a block.
pub fn check(words: Words, before: Before, state: &State) -> Outcome<Plan> {
    let setup = state.setup;
    let modes = select(&words, before.modes);
    let compensation = change(before.modes, modes);
    let cutter = CutterPlane::of(before.modes, modes);
    let motion = modes.get(GGroup::Motion);
    // G80 leaves its block what it is without it.
    let one_shot = words.one_shot().filter(|code| *code != 80);
    let cycle = CycleBlock::of(&words, before.modes, modes);
    let words = cycle::synchronised_words(words, cycle, setup);
    stands_alone(&words)?;
    cycle::refuse(&words, cycle, before.modes, modes, state)?;
    // The S of a G50 block is its clamp.
    let has_speed = words.get('S').is_some() && one_shot != Some(50);
    if (words.has_g(96) || words.has_g(97)) && !has_speed {
        return fail(AlarmName::CuttingSpeedMissing, CSS_03);
    }
    let is_thread =
        one_shot.is_none() && cycle.is_none() && thread::is_mode(motion) && is_motion(&words, motion);
    thread::not_in_constant_speed(&words, modes, is_thread.then_some(motion))?;
    lap::not_in_constant_speed(&words, modes)?;
    check_reference(&words, modes, setup)?;
    let converts = before.modes.converting() && !matches!(one_shot, Some(136 | 137));
    let moves_by_mode =
        matches!(one_shot, None | Some(75 | 76)) && cycle.is_none() && is_motion(&words, motion);
    let (changes, has_cycle) = (compensation != Change::Stays, cycle.is_some());
    let asked = contour::Asked { words: &words, one_shot, modes, changes, has_cycle };
    contour::check_conversion(&asked, converts, moves_by_mode, state)?;
    if !matches!(one_shot, Some(75 | 76)) {
        lap::check_contour_block(&words, state)?;
    }
    let mut moves = false;
    match one_shot {
        Some(4) => dwell(&words)?,
        Some(22) => {
            torque_skip(&words, setup)?;
            moves = true;
        }
        Some(29) => torque_limit(&words, setup)?,
        Some(code @ (71 | 72)) => {
            thread::check_compound(code, &words, state)?;
            moves = true;
        }
        Some(50) => zero_shift(&words, setup)?,
        Some(137) => contour::check_beginning(&words, modes)?,
        Some(code @ (73 | 74)) => {
            cycle::check_groove(code, &words, modes, state)?;
            moves = true;
        }
        Some(77 | 78) => {
            cycle::check_tapping(&words, modes)?;
            moves = true;
        }
        Some(code @ (75 | 76)) => {
            chamfer(code, &words, motion, setup)?;
            lap::check_contour_block(&words, state)?;
            if before.modal && words.has_any("XZ") {
                let detail = Label::of_code(b'G', code);
                return Err(Fault::about(AlarmName::Unspecified, MODIN_02, detail.as_str()));
            }
            path(&words, motion, before.after_angle, setup)?;
            moves = true;
        }
        Some(code @ 85..=88) => lap::check_call(code, &words, modes, before, state)?,
        None if let Some(block) = cycle => {
            cycle::check_block(&words, block, state)?;
            moves = true;
        }
        None if is_thread => {
            thread::check_block(&words, motion, before.after_angle, state)?;
            has_axis_w(&words, setup)?;
            moves = true;
        }
        None if is_motion(&words, motion) && contour::is_mode(motion) => {
            contour::check_block(&words, motion, modes)?;
            has_axis_w(&words, setup)?;
            moves = true;
        }
        None if is_motion(&words, motion) => {
            path(&words, motion, before.after_angle, setup)?;
            moves = true;
        }
        Some(_) | None => {}
    }
    lap::change_points_belong_to_call(&words)?;
    match one_shot {
        Some(code @ 85..=88) => lap::every_word_has_a_function(code, &words)?,
        _ => {
            let imaginary = compensation != Change::Stays && cutter.is_none();
            every_word_has_a_function(&words, one_shot, motion, imaginary, cycle, converts, state)?;
        }
    }
    let plan = Plan { words, modes, one_shot, compensation, cutter, cycle, moves, converts };
    cycle::not_in_compensation(&plan, before)?;
    thread::not_in_compensation(&plan, before)?;
    contour::check_plane(&plan, before, setup)?;
    compensation::check(&plan, before, state)?;
    Ok(plan)
}

fn change(before: Modes, after: Modes) -> Change {
    match (before.compensating(), after.compensating()) {
        (false, true) => Change::Begins,
        (true, false) => Change::Ends,
        _ => Change::Stays,
    }
}

/// The modes with the block's own G codes (E100L-GCODE-02).
fn select(words: &Words, mut modes: Modes) -> Modes {
    for code in &words.g {
        if let GCode::Modelled(group) = g_code(*code) {
            modes.set(group, *code);
        }
    }
    if words.has_g(137) {
        // E100L-CSC-05.
        modes.set(GGroup::Motion, Modes::NO_CODE);
    }
    modes
}

/// E100L-MCODE-24, E100L-MCODE-36, E100L-MCODE-37, E100L-CSC-09: codes that must stand alone.
fn stands_alone(words: &Words) -> Outcome<()> {
    let count = words.g.len() + words.m.len() + words.others.len() + usize::from(words.feed.is_some());
    let is_alone = count == 1 && !words.assigns;
    if is_alone {
        return Ok(());
    }
    let alone = [(110, MCODE_24), (193, MCODE_36), (195, MCODE_37), (196, MCODE_37)];
    match alone.iter().find(|(code, _)| words.m.contains(code)) {
        Some((_, rule)) => fail(AlarmName::NotAlone, *rule),
        None if words.has_g(136) => fail(AlarmName::NotAlone, CSC_09),
        None => cycle::stands_alone(words, is_alone).and_then(|()| lap::stands_alone(words)),
    }
}

/// E100L-DWELL-01.
fn dwell(words: &Words) -> Outcome<()> {
    if words.feed.is_none() { fail(AlarmName::WordMissing, DWELL_01) } else { Ok(()) }
}

/// E100L-TRQ-03: one axis with the torque of the same axis, D and L.
fn torque_skip(words: &Words, setup: &Setup) -> Outcome<()> {
    let axis_w = match (words.get('Z'), words.get('W')) {
        (Some(_), None) => false,
        (None, Some(_)) => true,
        _ => return fail(AlarmName::WordMissing, TRQ_03),
    };
    if axis_w && !setup.options.w_axis {
        return fail(AlarmName::AxisMissing, TRQ_03);
    }
    let torques = (words.extended("PZ").is_some(), words.extended("PW").is_some());
    if torques != (!axis_w, axis_w) || words.get('D').is_none() {
        return fail(AlarmName::WordMissing, TRQ_03);
    }
    match words.get('L') {
        None => fail(AlarmName::WordMissing, TRQ_03),
        Some(distance) if distance < 0 => fail(AlarmName::AddressRange, ADDR_01),
        Some(_) => Ok(()),
    }
}

/// E100L-TRQ-01.
fn torque_limit(words: &Words, setup: &Setup) -> Outcome<()> {
    let (z, w) = (words.extended("PZ"), words.extended("PW"));
    if z.is_none() && w.is_none() {
        return fail(AlarmName::WordMissing, TRQ_01);
    }
    if w.is_some() && !setup.options.w_axis {
        return fail(AlarmName::AxisMissing, TRQ_01);
    }
    let upper = i64::from(setup.parameters.torque_limit_upper);
    if z.into_iter().chain(w).any(|percent| percent > upper) {
        return fail(AlarmName::TorqueLimitRange, TRQ_01);
    }
    Ok(())
}

/// E100L-G50-01, E100L-G50-06.
fn zero_shift(words: &Words, setup: &Setup) -> Outcome<()> {
    if !words.has_any("XZCWS") {
        return fail(AlarmName::WordMissing, G50_01);
    }
    if words.get('W').is_some() && !setup.options.w_axis {
        return fail(AlarmName::AxisMissing, AXIS_01);
    }
    let offset = words.get('T').is_some_and(|tool| tool % 100 != 0);
    if words.has_any("XZCW") && offset {
        return fail(AlarmName::OffsetWithG50, G50_06);
    }
    Ok(())
}

/// E100L-CHAM-01, E100L-CHAM-02, E100L-CHAM-05, E100L-CHAM-08, E100L-CHAM-10, E100L-ANG-05.
fn chamfer(code: u16, words: &Words, motion: u16, setup: &Setup) -> Outcome<()> {
    let chamfering = setup.parameters.chamfering;
    if motion != 1 {
        return fail(AlarmName::ChamferNotLinear, CHAM_05);
    }
    if chamfering == Chamfering::Off {
        return fail(AlarmName::ChamferDisabled, CHAM_01);
    }
    if words.get('L').is_none_or(|size| size == 0) {
        return fail(AlarmName::WordMissing, if code == 75 { CHAM_02 } else { CHAM_10 });
    }
    let (x, z, angle) = (words.get('X').is_some(), words.get('Z').is_some(), words.get('A').is_some());
    if chamfering == Chamfering::Basic {
        return if x == z || angle { fail(AlarmName::ChamferAxes, CHAM_08) } else { Ok(()) };
    }
    if !x && !z && !angle {
        return fail(AlarmName::ChamferAxes, ANG_05);
    }
    Ok(())
}

/// What a line or an arc needs, and the axes that the machine must have.
fn path(words: &Words, motion: u16, after_angle: bool, setup: &Setup) -> Outcome<()> {
    if motion <= 1 {
        line(words, after_angle, setup)?
    } else {
        arc(words)?
    }
    has_axis_w(words, setup)
}

/// E100L-AXIS-01.
fn has_axis_w(words: &Words, setup: &Setup) -> Outcome<()> {
    if words.get('W').is_some() && !setup.options.w_axis {
        return fail(AlarmName::AxisMissing, AXIS_01);
    }
    Ok(())
}

fn is_motion(words: &Words, motion: u16) -> bool {
    words.has_any("XYZCWA")
        || contour::is_mode(motion) && words.get('L').is_some()
        || words.extended("QA").is_some()
        || matches!(motion, 2 | 3) && (words.has_any("IKL") || words.major_arc())
        || thread::is_mode(motion) && words.has_any("IKLEJ")
}

/// E100L-DTAP-01: what an angle may stand with.
fn line(words: &Words, after_angle: bool, setup: &Setup) -> Outcome<()> {
    if words.get('A').is_none() {
        return Ok(());
    }
    let (x, z) = (words.get('X').is_some(), words.get('Z').is_some());
    if x && z && !after_angle {
        return fail(AlarmName::AngleOverdetermined, DTAP_01);
    }
    if !x && !z && setup.parameters.chamfering != Chamfering::AnyAngle {
        return fail(AlarmName::AngleUnderdetermined, DTAP_01);
    }
    if words.has_any("CW") || words.extended("QA").is_some() {
        return fail(AlarmName::AngleOverdetermined, DTAP_01);
    }
    Ok(())
}

/// What an arc needs, in the order of execution.md.
fn arc(words: &Words) -> Outcome<()> {
    let (i, k) = (words.get('I'), words.get('K'));
    match words.get('L') {
        Some(_) if i.is_some() || k.is_some() => fail(AlarmName::ArcRadiusAndCentre, CIRC_15),
        Some(radius) if radius <= 0 => fail(AlarmName::ArcRadiusNotPositive, CIRC_13),
        Some(_) if words.get('X').is_none() || words.get('Z').is_none() => {
            fail(AlarmName::ArcRadiusNeedsBoth, CIRC_14)
        }
        Some(_) => Ok(()),
        None if words.major_arc() => Err(Fault::about(AlarmName::Unspecified, CIRC_18, "CALRG")),
        None if i.unwrap_or(0) == 0 && k.unwrap_or(0) == 0 => fail(AlarmName::ArcWithoutCentre, CIRC_06),
        None if !words.has_any("XZ") => Err(Fault::about(AlarmName::Unspecified, CIRC_07, "circle")),
        None => Ok(()),
    }
}

//! Everything that a control remembers from one block to the next.

use crate::barrier::Watch;
use crate::contour;
use crate::controls::e100l::g_codes::GGroup;
use crate::controls::e100l::m_codes::GROUPS;
use crate::controls::e100l::system_variables::Axis;
use crate::cycle;
use crate::frame::{self, Frame, Limits, TravelLimit};
use crate::lap;
use crate::path::Point;
use crate::saddle::Saddle;
use crate::task::Memory;
use crate::thread;
use crate::turret::OwnData;
use crate::vocabulary::{Length, MachineType, Setup, Side, SpindleState};

/// The state of a control.
#[derive(Clone)]
pub struct State<'a> {
    /// What it runs on.
    pub setup: &'a Setup,
    /// Coordinates.
    pub frame: Frame,
    /// Travel limits.
    pub limits: Limits,
    /// Variables.
    pub memory: Memory,
    /// Modal G codes.
    pub modes: Modes,
    /// Active M codes, in the order of the groups; none before the first where a group has no initial state.
    m_codes: Vec<Option<u16>>,
    /// The barriers that watch the motions of this block.
    pub watch: Watch,
    /// F, once it was programmed.
    pub feed: Option<StoredFeed>,
    /// Spindles.
    pub spindle: SpindleStore,
    /// Active tool (turret station).
    pub tool: u8,
    /// Active nose radius number.
    pub nose: u8,
    /// Torque limits of Z and W in percent.
    pub torque: (Option<u8>, Option<u8>),
    /// How many torque stops of the set-up were used.
    pub stops_used: usize,
    /// Whether the last motion was a cutting one.
    pub cut_last: bool,
    /// Where the next block counts from, after a chamfer block.
    pub base: Option<Base>,
    /// The data of the turret that is not selected, on a machine with two on one saddle.
    pub other_turret: Option<OwnData>,
    /// Which of two saddles it is the state of.
    pub saddle: Option<Saddle>,
    /// The end point of this block, when the block before had an angle alone.
    pub angle_target: Option<Point>,
    /// The thread that goes on in the next block.
    pub thread: thread::Kept,
    /// Coordinate conversion, and how far the C axis is wound.
    pub contour: contour::Kept,
    /// The cycle of a driven tool that goes on in the next block.
    pub cycle: cycle::Kept,
    /// What LAP keeps.
    pub lap: lap::Kept,
}

/// The modal G codes, in the order of the groups.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Modes([u16; GGroup::MODAL.len()]);

/// A feed word: the two readings of its number, in picometres (E100L-FEED-03).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StoredFeed {
    /// Per minute.
    pub per_minute: i64,
    /// Per revolution.
    pub per_revolution: i64,
    /// The feed code in force when it was programmed.
    pub given_in: u16,
    /// J: how many leads of a thread the feed per revolution holds (E100L-THRD-06).
    pub leads: i64,
}

/// What was commanded of the spindles.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SpindleStore {
    /// Main spindle, as it turns.
    pub main: SpindleState,
    /// The turret that was selected when its direction was commanded (E100L-MIRR-08).
    pub started_with: Option<Side>,
    /// S of G97, in thousandths of a revolution per minute.
    pub speed: i64,
    /// S of G96, in micrometres per minute.
    pub surface: i64,
    /// Clamp of `G50 S`.
    pub clamp: Option<i64>,
    /// Rotary tool.
    pub tool: SpindleState,
    /// SB.
    pub tool_speed: i64,
    /// SA, once it was programmed.
    pub c_axis_speed: Option<i64>,
}

/// The programmed corner of the chamfer block before (X as a diameter, Z).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Base {
    /// The corner.
    pub corner: Point,
    /// Whether targets count from it altogether (any-angle form) or only incremental words (basic form).
    pub whole: bool,
}

impl<'a> State<'a> {
    /// The state at power-on.
    pub fn new(setup: &'a Setup) -> Self {
        Self {
            setup,
            frame: Frame::new(setup),
            limits: Limits::new(setup),
            memory: Memory::new(setup),
            modes: Modes(GGroup::MODAL.map(GGroup::initial)),
            m_codes: GROUPS
                .iter()
                .map(|group| group.codes.first().copied().filter(|_| group.initial))
                .collect(),
            watch: Watch::default(),
            feed: None,
            spindle: SpindleStore::default(),
            tool: 0,
            nose: 0,
            torque: (None, None),
            stops_used: 0,
            cut_last: false,
            base: None,
            other_turret: (setup.machine.r#type == MachineType::TwoTurrets).then(|| OwnData::of_b(setup)),
            saddle: None,
            angle_target: None,
            thread: thread::Kept::default(),
            contour: contour::Kept::default(),
            cycle: cycle::Kept::default(),
            lap: lap::Kept::default(),
        }
    }

    /// The state of a saddle at power-on, with its own data (E100L-AX4-11).
    pub fn of_saddle(setup: &'a Setup, side: Side) -> Self {
        let mut state = Self::new(setup);
        state.saddle = Some(Saddle { side, alone: false, other_x: 0 });
        if side == Side::B {
            let data = &setup.turret_b;
            OwnData::of_b(setup).exchange(&mut state);
            (state.frame.machine.x, state.frame.machine.z) = (data.start.x.0, data.start.z.0);
            (state.limits.x, state.limits.z) = (frame::limit(data.limits.x), frame::limit(data.limits.z));
        }
        state
    }

    /// Where the torque of each successive G22 block reaches its preset value.
    pub fn torque_stops(&self) -> &'a [Length] {
        match self.saddle {
            Some(Saddle { side: Side::B, .. }) => &self.setup.turret_b.torque_stops,
            _ => &self.setup.inputs.torque_stops,
        }
    }

    /// E100L-MIRR-01: the turret that is selected.
    pub fn turret(&self) -> Side {
        if self.modes.get(GGroup::Turret) == 14 { Side::B } else { Side::A }
    }

    /// Selects a turret (E100L-MIRR-05, E100L-MIRR-18).
    pub fn select_turret(&mut self, turret: Side) {
        if turret == self.turret() {
            return;
        }
        self.modes.set(GGroup::Turret, if turret == Side::B { 14 } else { 13 });
        if let Some(mut other) = self.other_turret.take() {
            other.exchange(self);
            self.other_turret = Some(other);
        }
        self.frame.mirrored = turret == Side::B;
    }

    /// The side that an event tells, on machines with two.
    pub fn side(&self) -> Option<Side> {
        match self.setup.machine.r#type {
            MachineType::TwoTurrets => Some(self.turret()),
            MachineType::TwoSaddles => self.saddle.map(|saddle| saddle.side),
            MachineType::OneTurret => None,
        }
    }

    /// Whether an M code is the active one of its group.
    pub fn is_active(&self, code: u16) -> bool {
        self.m_codes.contains(&Some(code))
    }

    /// The active code of a group.
    pub fn active(&self, group: &str) -> Option<u16> {
        let index = GROUPS.iter().position(|each| each.name == group)?;
        self.m_codes.get(index).copied().flatten()
    }

    /// Makes an M code the active one of its group, if it has one.
    pub fn activate(&mut self, code: u16) {
        let index = GROUPS.iter().position(|group| group.codes.contains(&code));
        if let Some(slot) = index.and_then(|index| self.m_codes.get_mut(index)) {
            *slot = Some(code);
        }
    }

    /// The travel limit of an axis; C has none, and no variable that asks for it.
    pub fn travel_limit(&self, axis: Axis) -> &TravelLimit {
        match axis {
            Axis::X => &self.limits.x,
            Axis::Z => &self.limits.z,
            Axis::W | Axis::C => &self.limits.w,
        }
    }

    /// The travel limit of an axis, to be set.
    pub fn travel_limit_mut(&mut self, axis: Axis) -> &mut TravelLimit {
        match axis {
            Axis::X => &mut self.limits.x,
            Axis::Z => &mut self.limits.z,
            Axis::W | Axis::C => &mut self.limits.w,
        }
    }

    /// Whether the C axis is joined.
    pub fn c_joined(&self) -> bool {
        self.is_active(110)
    }
}

impl Modes {
    /// E100L-CSC-05: what the motion mode is while no code of its group is in force. It is the number of no G code.
    pub const NO_CODE: u16 = 1_000;

    /// The active code of a group; of the one-shot group none is.
    pub fn get(&self, group: GGroup) -> u16 {
        let index = GGroup::MODAL.iter().position(|each| *each == group);
        index.and_then(|index| self.0.get(index)).copied().unwrap_or_default()
    }

    /// Makes a code the active one of its group.
    pub fn set(&mut self, group: GGroup, code: u16) {
        let index = GGroup::MODAL.iter().position(|each| *each == group);
        if let Some(slot) = index.and_then(|index| self.0.get_mut(index)) {
            *slot = code;
        }
    }

    /// Whether G41 or G42 is in force.
    pub fn compensating(&self) -> bool {
        self.get(GGroup::Compensation) != 40
    }

    /// Whether G137 is in force.
    pub fn converting(&self) -> bool {
        self.get(GGroup::Conversion) == 137
    }

    /// Whether G91 is in force.
    pub fn incremental(&self) -> bool {
        self.get(GGroup::Dimension) == 91
    }

    /// Whether G96 is in force.
    pub fn cutting_speed(&self) -> bool {
        self.get(GGroup::CuttingSpeed) == 96
    }

    /// Whether G94 is in force.
    pub fn per_minute(&self) -> bool {
        self.get(GGroup::FeedUnit) == 94
    }
}

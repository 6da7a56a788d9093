//! What a control remembers from block to block.

use turnspec_oracle::vocabulary::{
    CuttingSpeed, FeedUnit, Length, Limit, Setup, Side, SpindleState, ToolOffsetSign,
};

use super::arithmetic::limit::{self, Limited};
use super::arithmetic::{frame, turn};
use super::barriers::Watch;
use super::contour;
use super::cycle;
use super::planted::{self, Bug};
use super::sides::{Turret, nose_radii, tool_offsets};
use super::thread::Kept;
use super::tool_data::{self, ToolTable};

/// Amounts of the four axes in nanometres and micro-degrees, X as a diameter; by [`super::system::Axis`].
pub type Amounts = [i64; 4];

/// Places in [`Amounts`].
pub const X: usize = 0;
pub const Z: usize = 1;
pub const C: usize = 2;
pub const W: usize = 3;

/// Number of tool offsets and nose radius entries, number 0 included.
pub const TABLE: usize = 97;

/// F as programmed, in both of its readings.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StoredFeed {
    /// Picometres per minute and per revolution.
    pub values: [i64; 2],
    /// The mode in which it was given.
    pub given: FeedUnit,
}

/// The corner of a chamfer block, from which the next motion counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Base {
    /// Program X of the corner.
    pub x: i64,
    /// Program Z of the corner.
    pub z: i64,
    /// Whether the chamfer was one of the basic form.
    pub basic: bool,
}

/// The whole state; every amount is exact.
#[derive(Clone, Debug)]
pub struct State {
    /// Machine position of the programmed point; C in [0, 360). X is that of [`Self::mirror`].
    pub machine: Amounts,
    pub zero_offset: Amounts,
    pub zero_shift: Amounts,
    pub tool_offsets: [[i64; 2]; TABLE],
    pub nose_radii: [[i64; 2]; TABLE],
    pub offset_sign: i64,
    pub positive_limits: [Option<i64>; 4],
    pub negative_limits: [Option<i64>; 4],
    pub droop: [i64; 3],
    /// Chuck and tailstock data that a program can change.
    pub barriers: [i64; 8],
    pub watch: Watch,
    pub pitch_errors: [[i64; 2]; 121],
    pub pitches: [i64; 2],
    pub tool_data: ToolTable,
    pub common: Box<[f64; 201]>,

    /// The turret, or the saddle, that acts.
    pub selected: Side,
    /// The data of the other turret, on a saddle that has two.
    pub other_turret: Option<Box<Turret>>,
    /// 1, or −1 with turret B of a saddle: machine X is this times [`Self::machine`] (E100L-MIRR-05).
    pub mirror: i64,
    /// The turret to which the cutting speed refers (G110, G111).
    pub speed_side: Side,
    /// Program X of the other saddle, when it ran last.
    pub other_x: i64,
    /// The turret that was selected when the main spindle was started.
    pub spindle_side: Side,

    /// G00 to G03, G31 to G35, G101 to G103, G132, G133, or [`contour::NO_CODE`].
    pub motion: u16,
    pub incremental: bool,
    pub per_minute: bool,
    pub constant_speed: bool,
    pub droop_control: bool,
    /// G17, G18 or G119.
    pub plane: u16,
    /// G40, G41 or G42.
    pub compensation: u16,

    pub feed: Option<StoredFeed>,
    /// S of G97 in thousandths of a revolution per minute.
    pub speed: i64,
    /// S of G96.
    pub surface: CuttingSpeed,
    pub clamp: Option<i64>,
    pub tool_speed: i64,
    pub spindle: SpindleState,
    pub tool_spindle: SpindleState,
    /// M code of the gear, 0 for none.
    pub gear: u16,
    pub tool_gear: u16,

    pub tool: u8,
    pub offset: u8,
    /// Nose radius number.
    pub nose: u8,

    pub c_joined: bool,
    pub c_clamped: bool,
    pub c_negative: bool,
    pub tool_interlock_released: bool,
    pub check_times: bool,

    /// Torque limits of Z and W in percent.
    pub torque: [Option<u8>; 2],
    pub last_motion_cut: bool,
    pub base: Option<Base>,
    /// Target of the block after a block with only A, in program coordinates.
    pub angle_target: Option<(i64, i64)>,
    /// Torque stops used so far.
    pub stops_used: usize,
    /// What thread cutting remembers.
    pub thread: Kept,
    /// What contour generation and coordinate conversion remember.
    pub contour: contour::Kept,
    /// What the cycles of driven tools remember.
    pub cycle: cycle::Kept,
}

impl State {
    /// The state at power-on.
    pub fn new(setup: &Setup) -> Self {
        // What a program finds in common variables is given by the set-up, else 0 (E100L-CVAR-03).
        let mut common = Box::new([0.0; 201]);
        for (name, value) in &setup.variables {
            let number = name.strip_prefix('V').and_then(|digits| digits.parse::<usize>().ok());
            if let Some(slot) = number.and_then(|number| common.get_mut(number)) {
                *slot = *value + 0.0;
            }
        }
        let limits = &setup.limits;
        let axes = [limits.x, limits.z, Limit::default(), limits.w];
        let metres = |length: Option<Length>| length.map(|length| length.0);
        let b = &setup.barriers;
        Self {
            machine: [setup.start.x.0, setup.start.z.0, turn::within(setup.start.c.0), setup.start.w.0],
            zero_offset: [
                setup.zero_offset.x.0,
                setup.zero_offset.z.0,
                setup.zero_offset.c.0,
                setup.zero_offset.w.0,
            ],
            zero_shift: [0; 4],
            tool_offsets: tool_offsets(&setup.tool_offset),
            nose_radii: nose_radii(&setup.nose_radius),
            offset_sign: if setup.readings.tool_offset == ToolOffsetSign::Added { 1 } else { -1 },
            positive_limits: axes.map(|limit| metres(limit.positive)),
            negative_limits: axes.map(|limit| metres(limit.negative)),
            droop: [setup.droop.x.into(), setup.droop.z.into(), setup.droop.c.into()],
            barriers: [
                b.grip_length.0,
                b.grip_height.0,
                b.chuck_x.0,
                b.chuck_z.0,
                b.front_length.0,
                b.front_diameter.0,
                b.centre_diameter.0,
                b.workpiece_end.0,
            ],
            watch: Watch::default(),
            pitch_errors: [[0; 2]; 121],
            pitches: [0; 2],
            tool_data: tool_data::table(setup),
            common,
            selected: Side::A,
            other_turret: Turret::other(setup),
            mirror: 1,
            speed_side: Side::A,
            spindle_side: Side::A,
            other_x: 0,
            motion: 0,
            incremental: false,
            per_minute: false,
            constant_speed: false,
            droop_control: false,
            plane: 18,
            compensation: 40,
            feed: None,
            speed: 0,
            surface: CuttingSpeed(0),
            clamp: None,
            tool_speed: 0,
            spindle: SpindleState::Stop,
            tool_spindle: SpindleState::Stop,
            gear: 0,
            tool_gear: 0,
            tool: 0,
            offset: 0,
            nose: 0,
            c_joined: false,
            c_clamped: false,
            c_negative: false,
            tool_interlock_released: false,
            check_times: false,
            torque: [None; 2],
            last_motion_cut: false,
            base: None,
            angle_target: None,
            stops_used: 0,
            thread: Kept::default(),
            contour: contour::Kept::default(),
            cycle: cycle::Kept::default(),
        }
    }

    /// The amounts of the active tool offset.
    pub fn active_offset(&self) -> [i64; 2] {
        self.tool_offsets.get(usize::from(self.offset)).copied().unwrap_or_default()
    }

    /// Machine coordinate less program coordinate of an axis (E100L-COORD-03).
    #[inline]
    pub fn frame(&self, axis: usize) -> i64 {
        let tool_offset = match axis {
            X | Z => self.offset_sign * self.active_offset()[axis],
            W if planted::is(Bug::ShiftTwice) => self.zero_shift[W],
            _ => 0,
        };
        frame::between(self.zero_offset[axis], self.zero_shift[axis], tool_offset)
    }

    /// The present program coordinate of an axis; C in [0, 360).
    #[inline]
    pub fn program(&self, axis: usize) -> i64 {
        let value = frame::to_program(self.machine[axis], self.frame(axis));
        if axis == C { turn::within(value) } else { value }
    }

    /// What the limits of an axis make of a position: that of [`Self::machine`], as the place of the limit is.
    #[inline]
    pub fn limited(&self, axis: usize, position: i64) -> Limited {
        let mirrored = axis == X && !planted::is(Bug::LimitsNotMirrored);
        let sign = if mirrored { self.mirror } else { 1 };
        match limit::limited(sign * position, self.negative_limits[axis], self.positive_limits[axis]) {
            Limited::AbovePositive(limit) => Limited::AbovePositive(sign * limit),
            other => other,
        }
    }

    /// Machine X at a place of [`Self::machine`].
    #[inline]
    pub fn machine_x(&self, place: i64) -> i64 {
        if planted::is(Bug::MirrorForgotten) { place } else { self.mirror * place }
    }

    /// The unit of the feed mode in force.
    pub fn feed_unit(&self) -> FeedUnit {
        if self.per_minute { FeedUnit::PerMinute } else { FeedUnit::PerRevolution }
    }
}

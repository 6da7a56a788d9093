//! What the generator believes about the control at the present block: modes, positions, frame, variables.
//!
//! It is a forecast that lets the next block fit, not a semantics: positions that the control computes are
//! known here to within a few nanometres, and nothing is compared with it.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_oracle::vocabulary::{Length, Limit, Setup, TapeCode, ToolOffsetSign};

use crate::barriers::Areas;
use crate::choices::Choices;
use crate::compensation::Compensation;
use crate::contour::Contours;
use crate::control::Control;
use crate::cutter::Cutter;
use crate::cycles::Cycles;
use crate::environment::Environment;
use crate::io::Io;
use crate::lap::Lap;
use crate::schedule::Schedule;
use crate::threads::Threads;
use crate::turrets::Turrets;
use crate::unit::{Estimate, Units};

/// A linear axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    /// The cross slide; lengths are diameters.
    X,
    /// The carriage.
    Z,
    /// The tailstock or second carriage.
    W,
}

impl Axis {
    /// Its address.
    #[must_use]
    pub fn address(self) -> &'static str {
        ["X", "Z", "W"][self as usize]
    }
}

/// The motion mode.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// G00.
    Rapid = 0,
    /// G01.
    Linear = 1,
    /// G02.
    Clockwise = 2,
    /// G03.
    CounterClockwise = 3,
    /// G31.
    ThreadAlongToo = 31,
    /// G32.
    ThreadAcross = 32,
    /// G33.
    ThreadAlong = 33,
    /// G34.
    GrowingThread = 34,
    /// G35.
    ShrinkingThread = 35,
    /// G101.
    FaceLine = 101,
    /// G102.
    FaceClockwise = 102,
    /// G103.
    FaceCounter = 103,
    /// G132.
    SideClockwise = 132,
    /// G133.
    SideCounter = 133,
    /// None, after G137.
    None = 137,
}

/// The forecast.
#[derive(Clone, Debug)]
pub struct State {
    /// The set-up; torque stops are appended while the program grows.
    pub setup: Setup,
    /// The unit system.
    pub units: Units,
    /// Machine position of X, Z, W in nanometres.
    pub machine: [i64; 3],
    /// Machine position of C in micro-degrees.
    pub c: i64,
    /// Zero offset of X, Z, W.
    pub zero_offset: [i64; 3],
    /// Zero shift of X, Z, W.
    pub shift: [i64; 3],
    /// Zero offset of C.
    pub c_offset: i64,
    /// Zero shift of C.
    pub c_shift: i64,
    /// Tool offset table, X and Z.
    pub tool_offsets: BTreeMap<u8, [i64; 2]>,
    /// Active tool offset number.
    pub offset: u8,
    /// Active tool number.
    pub tool: u8,
    /// Travel limits of X, Z, W.
    pub limits: [Limit; 3],
    /// Motion mode.
    pub mode: Mode,
    /// G91.
    pub incremental: bool,
    /// G94.
    pub per_minute: bool,
    /// G96.
    pub cutting_speed: bool,
    /// Whether an F was given.
    pub feed: bool,
    /// M110.
    pub joined: bool,
    /// M147.
    pub clamped: bool,
    /// M153.
    pub released: bool,
    /// The plane, G17, G18 or G119.
    pub plane: i64,
    /// Radius compensation.
    pub compensation: Compensation,
    /// M124.
    pub timed: bool,
    /// Whether the last motion was a cutting one.
    pub after_cutting: bool,
    /// Sequence names in use.
    pub names: BTreeSet<String>,
    /// Common variables.
    pub common: BTreeMap<u8, f64>,
    /// Loops, local variables, programs that are called.
    pub control: Control,
    /// Chuck and tailstock barriers.
    pub barriers: Areas,
    /// Thread cutting.
    pub threads: Threads,
    /// Grooving, drilling and tapping cycles, and cycles of driven tools.
    pub cycles: Cycles,
    /// Data communication, inputs and outputs.
    pub io: Io,
    /// Files and main programs of a schedule.
    pub schedule: Schedule,
    /// The turret that is selected, and the data of the other one.
    pub turrets: Turrets,
    /// Contours and coordinate conversion.
    pub contours: Contours,
    /// Cutter radius compensation.
    pub cutter: Cutter,
    /// Definitions of LAP.
    pub lap: Lap,
    /// What expressions of the present block read.
    pub environment: Environment,
}

impl State {
    /// The state at the start of a program.
    #[must_use]
    pub fn new(setup: Setup) -> Self {
        let units = Units::of(&setup);
        let values =
            |amounts: turnspec_oracle::vocabulary::AxisAmounts| [amounts.x.0, amounts.z.0, amounts.w.0];
        let variable = |(name, value): (&String, &f64)| Some((name.strip_prefix('V')?.parse().ok()?, *value));
        let mut state = Self {
            units,
            machine: values(setup.start),
            c: setup.start.c.0,
            zero_offset: values(setup.zero_offset),
            shift: [0; 3],
            c_offset: setup.zero_offset.c.0,
            c_shift: 0,
            tool_offsets: setup.tool_offset.iter().map(|each| (each.number, [each.x.0, each.z.0])).collect(),
            offset: 0,
            tool: 0,
            limits: [setup.limits.x, setup.limits.z, setup.limits.w],
            mode: Mode::Rapid,
            incremental: false,
            per_minute: false,
            cutting_speed: false,
            feed: false,
            joined: false,
            clamped: false,
            released: false,
            plane: 18,
            compensation: Compensation::new(&setup),
            timed: false,
            after_cutting: false,
            names: BTreeSet::new(),
            common: setup.variables.iter().filter_map(variable).collect(),
            control: Control::default(),
            barriers: Areas::new(&setup),
            threads: Threads::default(),
            cycles: Cycles::default(),
            io: Io::new(&setup),
            schedule: Schedule::default(),
            turrets: Turrets::new(&setup),
            contours: Contours::default(),
            cutter: Cutter::default(),
            lap: Lap::default(),
            environment: Environment::new(units, setup.options.offset_sets, setup.options.user_task == 2),
            setup,
        };
        state.begin_block();
        state
    }

    /// Whether the tape code lacks the equal sign and brackets.
    #[must_use]
    pub fn is_eia(&self) -> bool {
        self.setup.tape.code == TapeCode::Eia
    }

    /// The amount of the active tool offset, as it enters the frame.
    fn tool_offset(&self, axis: Axis) -> i64 {
        if axis == Axis::W {
            return 0;
        }
        let amount = self.tool_offsets.get(&self.offset).copied().unwrap_or_default()[axis as usize];
        match self.setup.readings.tool_offset {
            ToolOffsetSign::Added => amount,
            ToolOffsetSign::Subtracted => -amount,
        }
    }

    /// What is added to a program coordinate; the machine coordinate is the sum, mirrored for turret B.
    #[must_use]
    pub fn frame(&self, axis: Axis) -> i64 {
        self.zero_offset[axis as usize] + self.shift[axis as usize] + self.tool_offset(axis)
    }

    /// The present program coordinate.
    #[must_use]
    pub fn program(&self, axis: Axis) -> i64 {
        self.sign(axis) * self.machine[axis as usize] - self.frame(axis)
    }

    /// By what machine coordinates follow those of the program: turret B is mirrored in X (E100L-MIRR-05).
    #[must_use]
    pub fn sign(&self, axis: Axis) -> i64 {
        if axis == Axis::X && self.turrets.is_mirrored() { -1 } else { 1 }
    }

    /// The present program coordinate of C, in [0, 360) degrees.
    #[must_use]
    pub fn program_c(&self) -> i64 {
        (self.c - self.c_offset - self.c_shift).rem_euclid(360_000_000)
    }

    /// Lowest and highest program coordinate where blocks should end.
    #[must_use]
    pub fn window(&self, axis: Axis) -> (i64, i64) {
        let (low, high) = match axis {
            Axis::X => (-20_000_000, 300_000_000),
            Axis::Z | Axis::W => (-200_000_000, 200_000_000),
        };
        let (lowest, highest) = self.allowed(axis);
        if low > highest || high < lowest {
            (low.clamp(lowest, highest), high.clamp(lowest, highest))
        } else {
            (low.max(lowest), high.min(highest))
        }
    }

    /// Lowest and highest program coordinate within the travel limits.
    fn allowed(&self, axis: Axis) -> (i64, i64) {
        let Limit { mut positive, mut negative } = self.limits[axis as usize];
        if self.sign(axis) < 0 {
            let mirrored = |limit: Length| Length(-limit.0);
            (positive, negative) = (negative.map(mirrored), positive.map(mirrored));
        }
        let frame = self.frame(axis);
        let lowest = negative.map_or(-99_999_000_000, |limit| limit.0 - frame + self.units.finest());
        let highest = positive.map_or(99_999_000_000, |limit| limit.0 - frame - self.units.finest());
        (lowest, highest.max(lowest))
    }

    /// Whether a program coordinate lies within the travel limits.
    #[must_use]
    pub fn fits(&self, axis: Axis, target: i64) -> bool {
        let (lowest, highest) = self.allowed(axis);
        (lowest..=highest).contains(&target)
    }

    /// A program coordinate where a block may end, often a round one.
    pub fn somewhere(&self, axis: Axis, choices: &mut Choices<'_, '_>) -> i64 {
        let (low, high) = self.window(axis);
        let grid = choices.weighted(&[(40, 1_000_000), (20, 100_000), (10, 10_000), (30, 1_000)]);
        let target = choices.within(low / grid, high / grid) * grid;
        target.clamp(low, high)
    }

    /// Moves an axis to a program coordinate, or to the positive limit.
    pub fn move_to(&mut self, axis: Axis, target: i64) {
        let machine = self.sign(axis) * (target + self.frame(axis));
        let limit = match self.limits[axis as usize].positive {
            Some(limit) if !self.compensation.is_on() => limit,
            _ => Length(i64::MAX),
        };
        self.machine[axis as usize] = machine.min(limit.0);
    }

    /// Notes what the expressions of the next block will read.
    pub fn begin_block(&mut self) {
        let units = self.units;
        let length = |value: i64| Environment::shown_length(units, value);
        let amounts = self.tool_offsets.get(&self.offset).copied().unwrap_or_default();
        let factor = units.angle_unit() as f64;
        self.environment.system = vec![
            ("VSIOX", length(self.program(Axis::X))),
            ("VSIOZ", length(self.program(Axis::Z))),
            ("VSIOC", Environment::shown_angle(units, self.program_c())),
            ("VAPAX", length(self.machine[0])),
            ("VAPAZ", length(self.machine[1])),
            ("VETFX", length(amounts[0])),
            ("VETFZ", length(amounts[1])),
            ("VETON", Estimate::Integer(self.offset.into())),
            ("VETLN", Estimate::Integer(self.tool.into())),
            ("VRSTT", Estimate::Integer(if self.setup.inputs.restart { 128 } else { 0 })),
            ("VPAI", Estimate::Real(std::f64::consts::PI)),
            ("VRUND", Estimate::Real(360_000_000.0 / factor)),
            ("VZOFX", length(self.zero_offset[0])),
            ("VZOFZ", length(self.zero_offset[1])),
            ("VZSHX", length(self.shift[0])),
            ("VZSHZ", length(self.shift[1])),
            ("VPVLX", length(self.limits[0].positive.unwrap_or(Length(99_999_999_000)).0)),
            ("VNVLZ", length(self.limits[1].negative.unwrap_or(Length(-99_999_999_000)).0)),
        ];
        self.environment.common.clone_from(&self.common);
        self.environment.tool_offsets.clone_from(&self.tool_offsets);
        self.io.show(&mut self.environment);
        self.control.show(&mut self.environment);
        self.barriers.begin_block();
    }
}

//! The set-up: what a program runs on. Every field has a default, so that an empty set-up runs.
//!
//! Lengths are millimetres (X as a diameter), angles degrees, times seconds, whatever the unit system of
//! the program.

mod numbered;
mod validate;

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use super::{Angle, Duration, Label, Length, ProgramText, Readings, Speed};

macro_rules! table {
    ($(#[$meta:meta])* $name:ident { $($(#[$fmeta:meta])* $field:ident : $type:ty = $default:expr),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(default, deny_unknown_fields)]
        pub struct $name { $($(#[$fmeta])* pub $field: $type),* }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default),* }
            }
        }
    };
}

table! {
    /// A set-up file.
    Setup {
        /// The control.
        control: Control = Control::E100l,
        /// What a written 1 means (E100L-DEC-01).
        unit_system: UnitSystem = UnitSystem::Millimetre,
        /// How many saddles and turrets the machine has.
        machine: Machine = Machine::default(),
        /// Optional parameters.
        parameters: Parameters = Parameters::default(),
        /// Options of the machine.
        options: Options = Options::default(),
        /// Operation panel switches.
        switches: Switches = Switches::default(),
        /// How the program text is coded.
        tape: Tape = Tape::default(),
        /// Machine position at the start.
        start: AxisAmounts = AxisAmounts::default(),
        /// Zero offset.
        zero_offset: AxisAmounts = AxisAmounts::default(),
        /// Tool offsets; numbers without an entry hold zero.
        tool_offset: Vec<ToolOffset> = Vec::new(),
        /// Nose radius compensation data; numbers without an entry hold zero.
        nose_radius: Vec<NoseRadius> = Vec::new(),
        /// The data of turret B or of saddle B, on machines that have it.
        turret_b: TurretB = TurretB::default(),
        /// Variable travel limits in machine coordinates.
        limits: Limits = Limits::default(),
        /// Chuck and tailstock barrier data.
        barriers: Barriers = Barriers::default(),
        /// Permissible droop.
        droop: Droop = Droop::default(),
        /// Speed ranges of the main spindle.
        spindle: SpindleSetup = SpindleSetup::default(),
        /// Time-over check of S, T and M functions.
        stm: StmCheck = StmCheck::default(),
        /// Whether the program is a schedule program even without a header that says so.
        schedule: bool = false,
        /// What the devices `CN0` to `CN9` send, one text a transmission, one character a byte.
        devices: BTreeMap<String, Vec<ProgramText>> = BTreeMap::new(),
        /// Initial values of the tool interference data, such as `VTLL[3]`, in millimetres, degrees or as a number.
        system_variables: BTreeMap<String, Length> = BTreeMap::new(),
        /// What the machine reports while the program runs.
        inputs: Inputs = Inputs::default(),
        /// Initial values of common variables, by name (`V1` to `V200`).
        variables: BTreeMap<String, f64> = BTreeMap::new(),
        /// The programs that macro codes call, by code (`G161` to `G171`, `G205` to `G214`, `M321` to `M325`,
        /// `M341` to `M360`), with their `O`.
        macros: BTreeMap<String, Label> = BTreeMap::new(),
        /// Files with programs that can be called, by file name, such as `PULL.SUB`.
        library: BTreeMap<String, ProgramText> = BTreeMap::new(),
        /// Readings of what the manual leaves open.
        readings: Readings = Readings::default(),
    }
}

/// The control.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Control {
    /// Okuma OSP-E100L.
    #[default]
    E100l,
}

/// The unit system: what a written 1 means.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum UnitSystem {
    /// 0.001 mm.
    #[serde(rename = "1um")]
    Micrometre,
    /// 0.01 mm.
    #[serde(rename = "10um")]
    TenMicrometre,
    /// 1 mm.
    #[default]
    #[serde(rename = "1mm")]
    Millimetre,
    /// 0.0001 inch.
    #[serde(rename = "1/10000inch")]
    TenThousandthInch,
    /// 1 inch.
    #[serde(rename = "1inch")]
    Inch,
}

impl UnitSystem {
    /// Whether lengths are written in inches.
    #[must_use]
    pub fn is_inch(self) -> bool {
        matches!(self, Self::TenThousandthInch | Self::Inch)
    }
}

table! {
    /// The machine.
    #[derive(Copy, Eq)]
    Machine {
        /// Its saddles and turrets.
        r#type: MachineType = MachineType::OneTurret,
    }
}

/// Saddles and turrets of a machine (E100L-MIRR-01, E100L-AX4-01).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum MachineType {
    /// One saddle with one turret.
    #[serde(rename = "1S")]
    OneTurret,
    /// One saddle with two turrets.
    #[serde(rename = "1S-2T")]
    TwoTurrets,
    /// Two saddles.
    #[serde(rename = "2S")]
    TwoSaddles,
}

table! {
    /// The data of turret B or saddle B; the fields of the set-up with the same names are then those of A.
    TurretB {
        /// Machine position of saddle B at the start.
        start: PlaneAmounts = PlaneAmounts::default(),
        /// Zero offset.
        zero_offset: PlaneAmounts = PlaneAmounts::default(),
        /// Tool offsets; numbers without an entry hold zero.
        tool_offset: Vec<ToolOffset> = Vec::new(),
        /// Nose radius compensation data; numbers without an entry hold zero.
        nose_radius: Vec<NoseRadius> = Vec::new(),
        /// Variable travel limits of saddle B in machine coordinates.
        limits: PlaneLimits = PlaneLimits::default(),
        /// Machine coordinates at which the torque of each successive G22 block of saddle B reaches its preset value.
        torque_stops: Vec<Length> = Vec::new(),
    }
}

table! {
    /// One amount each for X and Z.
    #[derive(Copy)]
    PlaneAmounts {
        /// X, as a diameter.
        x: Length = Length(0),
        /// Z.
        z: Length = Length(0),
    }
}

table! {
    /// Variable travel limits of X and Z in machine coordinates.
    #[derive(Copy, Eq)]
    PlaneLimits {
        /// X, as a diameter.
        x: Limit = Limit::default(),
        /// Z.
        z: Limit = Limit::default(),
    }
}

table! {
    /// Optional parameters of the control.
    Parameters {
        /// (OTHER FUNCTION 1) No. 6: permissible difference of start and end radius of an arc.
        circular_radius_tolerance: Length = Length(20_000),
        /// (OTHER FUNCTION 1) automatic and any-angle chamfering.
        chamfering: Chamfering = Chamfering::AnyAngle,
        /// How many called programs may be active at a time, 1 to 126.
        call_depth: u8 = 8,
        /// (RS232C) what ends a transmission: stop bit check 1 or 0.
        end_code: EndCode = EndCode::Percent,
        /// Rate of run-out chamfer and retraction of threads, in 0.001 mm per 12.8 ms, 1 to 9999.
        thread_chamfer_feed: u16 = 640,
        /// Infeed pattern of M75, 3 or 4.
        m75_pattern: u8 = 3,
        /// (Optional parameter, long word) No. 7: retract between the cuts of a groove, 0 to 99.999.
        grooving_retract: Length = Length(100_000),
        /// Retract between the cuts of a deep hole and the passes of a key way, 0 to 99.999.
        drilling_retract: Length = Length(100_000),
        /// Where a cycle of a driven tool returns to without M136.
        cycle_return: CycleReturn = CycleReturn::CuttingStart,
        /// Whether G184 taps with a floating tap holder or synchronised.
        g184_tapping: G184Tapping = G184Tapping::Floating,
        /// Percent of the feed at which C turns at the centre of the face, 1 to 1000.
        centre_override: u16 = 100,
        /// From where the plane of contour generation on the side is seen.
        side_plane: SidePlane = SidePlane::Outer,
        /// (Optional parameter, bit) No. 56 bit 4: contour generation on the side needs G119.
        side_contour_mode: bool = false,
        /// Whether the C zero shift turns the axes of coordinate conversion.
        conversion_zero_shift: ConversionZeroShift = ConversionZeroShift::Included,
        /// Relief of LAP, in 0.001 mm, 0 to 9999.
        lap_relief: u16 = 100,
        /// Clearance of LAP, in 0.001 mm, 0 to 99999.
        lap_clearance: u32 = 2000,
        /// (OTHER FUNCTION 2) upper limit of the torque of G29, percent, 1 to 100.
        torque_limit_upper: u8 = 100,
        /// (OTHER FUNCTION 2) torque monitoring delay of G22 in units of 10 ms, 0 to 9999.
        torque_monitor_delay: u16 = 0,
    }
}

/// Where a cycle of a driven tool returns to (E100L-MCYC-15).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum CycleReturn {
    /// Where the cut begins.
    CuttingStart,
    /// Where the cycle began.
    CycleStart,
}

/// How G184 taps (E100L-G184-02).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum G184Tapping {
    /// With a floating tap holder.
    Floating,
    /// Synchronised with the tool spindle.
    Synchronised,
}

/// From where the plane of contour generation on the side is seen (E100L-CGS-02).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SidePlane {
    /// From outside.
    Outer,
    /// From inside.
    Inner,
}

/// Whether the C zero shift turns the axes of coordinate conversion (E100L-CSC-04).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ConversionZeroShift {
    /// It does.
    Included,
    /// It does not.
    Excluded,
}

/// What ends a transmission.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum EndCode {
    /// The character `%`.
    #[serde(rename = "%")]
    Percent,
    /// NUL.
    #[serde(rename = "null")]
    Null,
}

impl fmt::Display for EndCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Percent => "%",
            Self::Null => "null",
        })
    }
}

/// Automatic chamfering and rounding.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Chamfering {
    /// G75 and G76 are refused.
    Off,
    /// Between a motion along one axis and a motion along the other.
    Basic,
    /// Between any two lines.
    AnyAngle,
}

table! {
    /// Options of the machine.
    Options {
        /// Nose radius compensation: T words of six digits instead of four.
        nose_radius_compensation: bool = true,
        /// Number of tool offsets and nose radius entries: 32, 64 or 96.
        offset_sets: u8 = 32,
        /// Whether the machine has a W axis.
        w_axis: bool = false,
        /// User Task level, 1 or 2.
        user_task: u8 = 2,
        /// Lathe auto-programming: 0 (none), 3 (modes I to III), 4 (modes I to V).
        lap: u8 = 4,
        /// Number of tools with interference data: 12, 20 or 96.
        tools: u8 = 12,
        /// Number of tool groups with interference data: 12, 20 or 24.
        tool_groups: u8 = 12,
    }
}

table! {
    /// Operation panel switches.
    Switches {
        /// BLOCK DELETE.
        block_delete: bool = false,
        /// OPTIONAL STOP.
        optional_stop: bool = false,
    }
}

table! {
    /// How the program text is coded.
    Tape {
        /// The code.
        code: TapeCode = TapeCode::Ascii,
    }
}

/// The code of the program text.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum TapeCode {
    /// Seven-bit characters.
    Ascii,
    /// ISO: seven-bit characters with even parity in bit 8.
    Iso,
    /// EIA RS-244, odd parity.
    Eia,
}

table! {
    /// One amount an axis.
    #[derive(Copy)]
    AxisAmounts {
        /// X, as a diameter.
        x: Length = Length(0),
        /// Z.
        z: Length = Length(0),
        /// C.
        c: Angle = Angle(0),
        /// W.
        w: Length = Length(0),
    }
}

table! {
    /// One tool offset.
    ToolOffset {
        /// Its number, from 1.
        number: u8 = 1,
        /// X, as a diameter.
        x: Length = Length(0),
        /// Z.
        z: Length = Length(0),
    }
}

table! {
    /// One entry of nose radius data: the signed amounts from the imaginary tip to the nose centre.
    NoseRadius {
        /// Its number, from 1.
        number: u8 = 1,
        /// X, as a radius.
        x: Length = Length(0),
        /// Z.
        z: Length = Length(0),
    }
}

table! {
    /// Variable travel limits in machine coordinates, and the limit of a run.
    Limits {
        /// X, as a diameter.
        x: Limit = Limit::default(),
        /// Z.
        z: Limit = Limit::default(),
        /// W.
        w: Limit = Limit::default(),
        /// How many blocks a run may begin, at least 1.
        steps: u64 = 10_000_000,
    }
}

table! {
    /// The limits of one axis; without a value there is none.
    #[derive(Copy, Eq)]
    Limit {
        /// Positive limit.
        #[serde(skip_serializing_if = "Option::is_none")]
        positive: Option<Length> = None,
        /// Negative limit.
        #[serde(skip_serializing_if = "Option::is_none")]
        negative: Option<Length> = None,
    }
}

table! {
    /// Chuck and tailstock barrier data (E100L-BARR-02, E100L-BARR-03), by the manual's letters.
    #[derive(Copy)]
    Barriers {
        /// Length L of the chuck jaw.
        jaw_length: Length = Length(0),
        /// Size D of the chuck jaw in the direction of the radius.
        jaw_height: Length = Length(0),
        /// Length L1 of the gripping part of the jaw.
        grip_length: Length = Length(0),
        /// Width D1 of the gripping face.
        grip_height: Length = Length(0),
        /// Gripping diameter CX.
        chuck_x: Length = Length(0),
        /// Z of the front face of the jaw, CZ, from program zero.
        chuck_z: Length = Length(0),
        /// Length L of the rear step of the tailstock.
        rear_length: Length = Length(0),
        /// Diameter D of the rear step.
        rear_diameter: Length = Length(0),
        /// Length L1 of the middle step.
        middle_length: Length = Length(0),
        /// Diameter D1 of the middle step.
        middle_diameter: Length = Length(0),
        /// Length L2 of the front step, the projection of the tailstock spindle.
        front_length: Length = Length(0),
        /// Diameter D2 of the front step.
        front_diameter: Length = Length(0),
        /// Diameter D3 of the centre.
        centre_diameter: Length = Length(0),
        /// Z of the end face of the workpiece, WR, from program zero.
        workpiece_end: Length = Length(0),
    }
}

table! {
    /// Permissible droop, in 0.001 mm (0.0001 inch), 0 to 1000 (10000).
    #[derive(Copy, Eq)]
    Droop {
        /// X axis.
        x: u16 = 0,
        /// Z axis.
        z: u16 = 0,
        /// C axis.
        c: u16 = 0,
    }
}

table! {
    /// Speed ranges of the main spindle.
    SpindleSetup {
        /// Lowest speed when no gear entry applies.
        minimum: Speed = Speed(0),
        /// Highest speed when no gear entry applies.
        maximum: Speed = Speed(65_535_000),
        /// Gear ranges.
        gear: Vec<Gear> = Vec::new(),
    }
}

table! {
    /// The speeds of one gear.
    #[derive(Copy, Eq)]
    Gear {
        /// The M code, 40 to 44.
        code: u8 = 41,
        /// Lowest speed.
        minimum: Speed = Speed(0),
        /// Highest speed.
        maximum: Speed = Speed(65_535_000),
    }
}

table! {
    /// Time-over check (E100L-STM-01) and the times that the functions take.
    #[derive(Copy, Eq)]
    StmCheck {
        /// Whether the machine parameter enables the check.
        enabled: bool = false,
        /// The limit, at most 600 s in steps of 0.1 s.
        limit: Duration = Duration(600_000_000),
        /// Time that an S function takes.
        s: Duration = Duration(0),
        /// Time that a T function takes.
        t: Duration = Duration(0),
        /// Time that an M function takes.
        m: Duration = Duration(0),
    }
}

table! {
    /// What the machine reports while the program runs.
    Inputs {
        /// Machine coordinates at which the torque of each successive G22 block reaches its preset value.
        torque_stops: Vec<Length> = Vec::new(),
        /// Whether the turret clamp is confirmed when M203 asks.
        turret_clamp_confirmed: bool = true,
        /// Whether a sequence restart is in progress (VRSTT).
        restart: bool = false,
        /// Values of input variables VDIN, one a reading, the last one for all that follow; by number.
        #[serde(serialize_with = "numbered::serialize", deserialize_with = "numbered::deserialize")]
        vdin: BTreeMap<u16, Vec<i32>> = BTreeMap::new(),
        /// Values of input bits VIRD likewise; by I/O bit address.
        #[serde(serialize_with = "numbered::serialize", deserialize_with = "numbered::deserialize")]
        vird: BTreeMap<u16, Vec<u8>> = BTreeMap::new(),
        /// Values of output bits VORD likewise; by I/O bit address.
        #[serde(serialize_with = "numbered::serialize", deserialize_with = "numbered::deserialize")]
        vord: BTreeMap<u16, Vec<u8>> = BTreeMap::new(),
    }
}

impl Setup {
    /// Reads a set-up file.
    ///
    /// # Errors
    /// When the text is no TOML, has unknown keys or wrong types (the message shows the place), or when
    /// the values are impossible.
    pub fn from_toml(text: &str) -> Result<Self, SetupError> {
        let setup: Self = toml::from_str(text).map_err(|error| SetupError {
            message: error.to_string().trim_end().to_owned(),
            span: error.span(),
        })?;
        setup.validate()?;
        Ok(setup)
    }

    /// Largest coordinate, 99999.999 mm, in nanometres.
    pub const COORDINATE: i64 = 99_999_999_000;
}

/// Why a set-up cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SetupError {
    /// What is wrong, with the place where the text shows it.
    pub message: String,
    /// Byte span of the fault, when it is in the text itself.
    pub span: Option<std::ops::Range<usize>>,
}

impl fmt::Display for SetupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for SetupError {}

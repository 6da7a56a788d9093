//! The trace: what a control does, one event after the other.

use serde::{Deserialize, Serialize};

use super::{
    Alarm, Angle, CuttingSpeed, Duration, EndCode, FeedRate, Label, Length, Place, ReadingSet, RuleSet,
    Speed, Text,
};

/// Receives the events of a run in order.
pub trait Sink {
    /// Takes the next event.
    fn event(&mut self, event: &Event);
}

impl<F: FnMut(&Event)> Sink for F {
    fn event(&mut self, event: &Event) {
        self(event);
    }
}

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ending {
    /// By M02 or M30.
    End,
    /// By an alarm.
    Alarm,
}

/// One event of a trace.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Event {
    /// Ordinal, from 1.
    pub n: u64,
    /// The block that produced the event.
    pub block: Place,
    /// The rules that produced it.
    pub rules: RuleSet,
    /// The readings it depends on.
    #[serde(default, skip_serializing_if = "ReadingSet::is_empty")]
    pub readings: ReadingSet,
    /// The turret that is selected, on machines with two turrets on one saddle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turret: Option<Side>,
    /// The saddle that the event is about, on machines with two saddles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub saddle: Option<Side>,
    /// What happens.
    #[serde(flatten)]
    pub action: Action,
}

impl Event {
    /// An event of a machine with one turret.
    #[must_use]
    pub fn new(n: u64, block: Place, rules: RuleSet, readings: ReadingSet, action: Action) -> Self {
        Self { n, block, rules, readings, turret: None, saddle: None, action }
    }
}

/// One of two turrets or saddles.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Side {
    /// That of G13.
    A,
    /// That of G14.
    B,
}

impl Side {
    /// `A` or `B`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::A => "A",
            Self::B => "B",
        }
    }

    /// The other one.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::A => Self::B,
            Self::B => Self::A,
        }
    }
}

/// What happens.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Action {
    /// Positioning, each axis on its own.
    Rapid {
        /// Where to.
        #[serde(flatten)]
        motion: Motion,
    },
    /// Motion along a straight line at a feed.
    Linear {
        /// Where to.
        #[serde(flatten)]
        motion: Motion,
        /// The feed.
        feed: Feed,
        /// The length on which the feed is measured.
        path: Length,
    },
    /// Motion along a circle at a feed.
    Arc {
        /// Where to.
        #[serde(flatten)]
        motion: Motion,
        /// The feed, along the arc.
        feed: Feed,
        /// The way round, seen with Z to the right and X up.
        sense: Sense,
        /// Centre X in program coordinates, as a diameter.
        centre_x: Length,
        /// Centre Z in program coordinates.
        centre_z: Length,
    },
    /// Cutting a thread: a straight line whose feed is bound to the turning of the spindle.
    Thread {
        /// Where to.
        #[serde(flatten)]
        motion: Motion,
        /// The lead where the motion begins, in millimetres per revolution.
        lead: FeedRate,
        /// The axis along which the lead is measured.
        axis: LeadAxis,
        /// How much the lead changes per revolution, in millimetres per revolution.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        change: Option<FeedRate>,
        /// The angle of the spindle at which the thread starts, if it is not zero.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        start: Option<Angle>,
        /// The spindle whose turning it follows, if it is not the main spindle.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        spindle: Option<SpindleName>,
        /// The feed along the lead axis, when the thread follows the C axis.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        feed: Option<Feed>,
    },
    /// Motion along a circle in a plane of the C axis, at a feed.
    ContourArc {
        /// Where to.
        #[serde(flatten)]
        motion: Motion,
        /// The feed, along the arc.
        feed: Feed,
        /// The way round, seen in its plane.
        sense: Sense,
        /// Its centre, and on the side of the workpiece its end.
        #[serde(flatten)]
        plane: ContourPlane,
    },
    /// Waiting.
    Dwell {
        /// How long.
        time: Duration,
    },
    /// A spindle command.
    Spindle(Spindle),
    /// A tool command.
    Tool {
        /// Tool (turret station) number; 0 keeps the station.
        tool: u8,
        /// Tool offset number.
        offset: u8,
        /// Nose radius compensation number.
        nose: u8,
        /// Whether the turret indexes.
        index: bool,
    },
    /// Coolant.
    Coolant {
        /// On or off.
        on: bool,
    },
    /// An M code without another event of its own.
    Aux {
        /// The code, such as `M147`.
        code: Label,
        /// The modal group of the code, if it has one.
        #[serde(default, skip_serializing_if = "Label::is_empty")]
        group: Label,
    },
    /// The torque limits in force from here on, in percent of the rated torque.
    Torque {
        /// Z axis.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        z: Option<u8>,
        /// W axis.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        w: Option<u8>,
    },
    /// The relation between program and machine coordinates changed.
    Frame {
        /// Which amount changed.
        cause: FrameCause,
        /// New amount, X as a diameter.
        x: Length,
        /// New amount.
        z: Length,
        /// New amount.
        c: Angle,
        /// New amount.
        w: Length,
    },
    /// A modal G group changed.
    Mode {
        /// The group, such as `feed_unit`.
        group: Label,
        /// The code now active.
        code: Label,
        /// The code active before, if one was.
        #[serde(default, skip_serializing_if = "Label::is_empty")]
        previous: Label,
        /// The direction of the X axis of coordinate conversion.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        angle: Option<Angle>,
    },
    /// A variable was assigned.
    Variable {
        /// Its name with its suffix, such as `V5` or `VTOFX[3]`.
        name: Label,
        /// Its new value.
        value: Value,
    },
    /// A subprogram begins.
    Call {
        /// Its program name, with its `O`.
        name: Label,
        /// What called it.
        cause: CallCause,
    },
    /// A subprogram ends, and the program that it was called from goes on.
    Return,
    /// Characters go to a device.
    Output {
        /// The device, such as `CN0`.
        device: Label,
        /// The characters.
        text: Text,
        /// The end code behind them.
        end_code: EndCode,
    },
    /// An alarm that does not stop the program is displayed.
    Message {
        /// The control's number of the alarm.
        number: u16,
        /// The code that the program gave.
        code: u16,
        /// The comment.
        text: Text,
    },
    /// A schedule program begins to run a main program.
    Select {
        /// Its file, with the device, such as `MD1:A.MIN`.
        file: Label,
        /// Its program name, with its `O`, if it has one.
        #[serde(default, skip_serializing_if = "Label::is_empty")]
        name: Label,
        /// Which repetition it is, from 1.
        repetition: u16,
    },
    /// A saddle waits for the other one: at a P word or at M100.
    Wait {
        /// The value of P.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        p: Option<u16>,
        /// `M100`.
        #[serde(default, skip_serializing_if = "Label::is_empty")]
        code: Label,
    },
    /// A waiting saddle goes on.
    Release {
        /// The value of P that it waited at.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        p: Option<u16>,
        /// `M100`, if it waited there.
        #[serde(default, skip_serializing_if = "Label::is_empty")]
        code: Label,
        /// Why.
        cause: ReleaseCause,
    },
    /// The program of one saddle is at its end.
    SideEnd {
        /// `M02` or `M30`; nothing if it had neither.
        #[serde(default, skip_serializing_if = "Label::is_empty")]
        code: Label,
    },
    /// Program stop.
    Stop,
    /// Optional stop, with the switch on.
    OptionalStop,
    /// End of the program.
    End {
        /// `M02` or `M30`, and `END` of a schedule program.
        code: Label,
    },
    /// The control refuses to go on; always the last event.
    Alarm(Alarm),
}

/// The end of a motion.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Motion {
    /// End point in program coordinates.
    pub program: Position,
    /// End point in machine coordinates.
    pub machine: Position,
    /// The tool tip in program coordinates, in radius compensation; of a cutter its centre.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tip: Option<PlanePosition>,
    /// The nose centre in program coordinates, in radius compensation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nose: Option<PlanePosition>,
    /// C of the cutter centre in program coordinates, in cutter radius compensation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tip_c: Option<Angle>,
    /// The end as a point of the face plane, in contour generation on the face and in coordinate conversion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<FacePoint>,
    /// The cutter centre as a point of the face plane, in cutter radius compensation in G17.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face_tip: Option<FacePoint>,
    /// Travel of the C axis, signed, full turns included.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub c_travel: Option<Angle>,
    /// Speed of the main spindle at the end point, in constant cutting speed mode.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed: Option<Speed>,
    /// Which pass of a cycle it belongs to, from 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<u32>,
    /// What it does in a cycle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<Part>,
}

/// What a motion does in a cycle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// It goes to where the cut begins.
    Approach,
    /// It goes over the place of a hole.
    Position,
    /// It goes to the depth of a pass.
    Infeed,
    /// It cuts.
    Cut,
    /// It cuts along the contour.
    Contour,
    /// It cuts the last pass, which leaves nothing.
    Finish,
    /// It leaves the workpiece at a feed: the run-out chamfer of a thread, the way out of a hole.
    Exit,
    /// It leaves the workpiece.
    Retract,
    /// It leaves a hole, to come back.
    Withdraw,
    /// It goes back into a hole.
    Reentry,
    /// It goes sideways to the next place.
    Shift,
    /// It goes where there is no stock, on the level of a cut.
    Air,
    /// It leaves what it has cut by a little, in both axes.
    Relief,
    /// It goes above what it has cut.
    Clear,
    /// It goes back to where the cycle, or a pass of it, began.
    Return,
    /// It goes back to the point in front of the cycle.
    Home,
    /// X alone, to or from the centre of the face.
    Radial,
    /// C alone, at the centre of the face.
    Turn,
}

impl Part {
    /// The name, such as `cut`.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Approach => "approach",
            Self::Position => "position",
            Self::Infeed => "infeed",
            Self::Cut => "cut",
            Self::Contour => "contour",
            Self::Finish => "finish",
            Self::Exit => "exit",
            Self::Retract => "retract",
            Self::Withdraw => "withdraw",
            Self::Reentry => "reentry",
            Self::Shift => "shift",
            Self::Air => "air",
            Self::Relief => "relief",
            Self::Clear => "clear",
            Self::Return => "return",
            Self::Home => "home",
            Self::Radial => "radial",
            Self::Turn => "turn",
        }
    }
}

/// The axis along which the lead of a thread is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum LeadAxis {
    /// X, as a radius or a diameter (reading `feed_length`).
    X,
    /// Z.
    Z,
}

/// A point of the face of the workpiece: in coordinate conversion in its coordinates, else with the first axis on program C0.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FacePoint {
    /// Along the first axis.
    pub x: Length,
    /// Along the second axis.
    pub y: Length,
}

/// What an arc in a plane of the C axis is measured by.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ContourPlane {
    /// On the face.
    FaceCentre(FacePoint),
    /// On the side, developed.
    SideArc(SideArc),
}

/// An arc on the developed side of the workpiece.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SideArc {
    /// The travel on the cylinder from start to end, positive in the direction of C+.
    pub travel: Length,
    /// The centre on the cylinder, from the start.
    pub centre: Length,
    /// Program Z of the centre.
    pub centre_z: Length,
}

/// A point of the plane of X and Z.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PlanePosition {
    /// X, as a diameter.
    pub x: Length,
    /// Z.
    pub z: Length,
}

/// A position in one coordinate system.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Position {
    /// X, as a diameter.
    pub x: Length,
    /// Z.
    pub z: Length,
    /// C in [0, 360), while the C axis is joined.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub c: Option<Angle>,
    /// W, on machines that have it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub w: Option<Length>,
}

/// A feed with its unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Feed {
    /// The amount in millimetres.
    pub value: FeedRate,
    /// Per what.
    pub unit: FeedUnit,
}

/// Per what a feed is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum FeedUnit {
    /// Millimetres per revolution.
    #[serde(rename = "mm/rev")]
    PerRevolution,
    /// Millimetres per minute.
    #[serde(rename = "mm/min")]
    PerMinute,
}

/// The way round a circle, seen with Z to the right and X up.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Sense {
    /// G02.
    Clockwise,
    /// G03.
    CounterClockwise,
}

/// The state of a spindle after a command.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Spindle {
    /// Which one.
    pub spindle: SpindleName,
    /// What it does.
    pub state: SpindleState,
    /// Its speed; 0 unless it turns (for the C axis: the speed set).
    pub speed: Speed,
    /// The constant cutting speed, in G96 (a foot counts as 0.3048 m).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<CuttingSpeed>,
    /// What limited the speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limit: Option<SpeedLimit>,
    /// Active gear code, empty if none was commanded.
    #[serde(default, skip_serializing_if = "Label::is_empty")]
    pub gear: Label,
    /// The new clamp, in the event of a `G50 S` block.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clamp: Option<Speed>,
    /// Whether it is issued together with the motion of its block (M63).
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub with_motion: bool,
}

/// Which spindle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SpindleName {
    /// The work spindle.
    Main,
    /// The rotary tool.
    Tool,
    /// The work spindle as C axis (SA).
    CAxis,
}

/// What a spindle does.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SpindleState {
    /// It stands.
    #[default]
    Stop,
    /// It turns clockwise.
    Clockwise,
    /// It turns counter-clockwise.
    CounterClockwise,
    /// It is oriented.
    Orient,
}

/// What limited a spindle speed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum SpeedLimit {
    /// The highest speed of the gear range.
    GearMaximum,
    /// The lowest speed of the gear range.
    GearMinimum,
    /// The clamp of `G50 S`.
    Clamp,
}

/// Which amount of the frame changed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum FrameCause {
    /// The zero offset.
    ZeroOffset,
    /// The zero shift.
    ZeroShift,
    /// The active tool offset.
    ToolOffset,
}

/// What called a subprogram.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum CallCause {
    /// CALL.
    Call,
    /// A G or M code macro that calls.
    Macro,
    /// A motion while a MODIN mode is active.
    Modal,
}

/// Why a waiting saddle goes on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum ReleaseCause {
    /// The other saddle waits at a greater P.
    Smaller,
    /// The other saddle waits at the same P.
    Equal,
    /// It waited at M100, and the other saddle waits at a P.
    PCode,
    /// The other saddle waits at M100, too.
    Counterpart,
    /// The program of the other saddle is at its end.
    OtherEnded,
}

/// The value of a variable.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Value {
    /// A real number.
    Real(f64),
    /// A whole number.
    Integer(i32),
    /// A length.
    Length(Length),
    /// An angle.
    Angle(Angle),
    /// Characters.
    Text(Text),
}

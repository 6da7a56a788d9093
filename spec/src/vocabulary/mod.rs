//! What a set-up, an event, an alarm and a rule id *are*: the language that the oracle, the fast
//! interpreter, the generator and every other implementation speak to each other.
//!
//! Nothing here decides what a control does. The two implementations share this module and nothing
//! else, so that a mistake made once cannot hide in both.

mod alarm;
pub mod decimal;
mod event;
mod feature;
mod label;
pub mod notation;
mod place;
mod program_text;
mod reading;
mod rule;
pub mod rule_ids;
#[cfg(feature = "schema")]
mod schema;
mod setup;
mod text;
mod unit;

pub use alarm::{Alarm, AlarmName};
pub use event::{
    Action, CallCause, ContourPlane, Ending, Event, FacePoint, Feed, FeedUnit, FrameCause, LeadAxis, Motion,
    Part, PlanePosition, Position, ReleaseCause, Sense, Side, SideArc, Sink, SpeedLimit, Spindle,
    SpindleName, SpindleState, Value,
};
pub use feature::Feature;
pub use label::Label;
pub use place::Place;
pub use program_text::ProgramText;
pub use reading::{
    ArcOneCoordinate, BalancedInfeed, BarrierPath, ChamferLeg, ChipDischarge, ContourFeed, FeedLength,
    InchConversion, IncrementalAfterChamfer, KeywayReturn, PeckRetract, PutReal, Reading, ReadingSet,
    Readings, SpeedClamp, TaperReference, ThreadFlank, ThreadShift, ToolOffsetSign, UserAlarmC,
};
pub use rule::{RuleId, RuleSet};
pub use setup::{
    AxisAmounts, Barriers, Chamfering, Control, ConversionZeroShift, CycleReturn, Droop, EndCode,
    G184Tapping, Gear, Inputs, Limit, Limits, Machine, MachineType, NoseRadius, Options, Parameters,
    PlaneAmounts, PlaneLimits, Setup, SetupError, SidePlane, SpindleSetup, StmCheck, Switches, Tape,
    TapeCode, ToolOffset, TurretB, UnitSystem,
};
pub use text::Text;
pub use unit::{Angle, CuttingSpeed, Duration, FeedRate, Length, Speed};

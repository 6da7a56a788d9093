//! The closed lists of tags that cases carry.

use serde::{Deserialize, Serialize};

/// What an implementation needs to be able to run a case.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Feature {
    /// G90 as more than the power-on mode.
    Absolute,
    /// The case ends in an alarm.
    Alarm,
    /// Chamfer and rounding between any two lines, and the angle word.
    AnyAngle,
    /// Circular motion.
    Arc,
    /// M codes without an event of their own.
    Aux,
    /// Operators on bits.
    Boolean,
    /// The C axis.
    CAxis,
    /// G75.
    Chamfer,
    /// Comments.
    Comment,
    /// G96.
    CuttingSpeed,
    /// Expressions.
    Expression,
    /// F words and their units.
    Feed,
    /// Functions in expressions.
    Function,
    /// G91.
    Incremental,
    /// Linear motion.
    Linear,
    /// Rotary tools.
    MTool,
    /// Positioning.
    Rapid,
    /// G76.
    Rounding,
    /// The main spindle.
    Spindle,
    /// System variables.
    SystemVariable,
    /// T words.
    Tool,
    /// Torque limit and torque skip.
    Torque,
    /// Turret functions.
    Turret,
    /// Unit systems other than 1 mm.
    Units,
    /// Common variables.
    Variable,
    /// The W axis.
    WAxis,
    /// G50 with axis words, and the shift variables.
    ZeroShift,
}

/// Where a case comes from and what it depends on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Flag {
    /// The program is a worked example of the manual.
    ManualExample,
    /// Misprints of the program or of its explanation were repaired.
    Repaired,
    /// The manual prints figures or single words, from which the program was built.
    Constructed,
    /// Blocks or words were added to establish a state, to show a result or to end the program.
    Completed,
    /// The expected trace names a reading that the set-up can switch.
    Reading,
}

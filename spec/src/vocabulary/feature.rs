//! What a program needs of an implementation: the tags by which cases are chosen, implementations declare
//! what they have, and generated programs are kept within it.

use serde::{Deserialize, Serialize};

macro_rules! features {
    ($($(#[doc = $doc:literal])+ $variant:ident $name:literal)*) => {
        /// What a program needs of an implementation.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub enum Feature { $($(#[doc = $doc])+ #[serde(rename = $name)] $variant),* }

        impl Feature {
            /// Every feature.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// The name, such as `any-angle`.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $name),* }
            }
        }
    };
}

features! {
    /// G90 as more than the power-on mode.
    Absolute "absolute"
    /// The program ends in an alarm.
    Alarm "alarm"
    /// Chamfer and rounding between any two lines, and the angle word.
    AnyAngle "any-angle"
    /// Circular motion.
    Arc "arc"
    /// M codes without an event of their own.
    Aux "aux"
    /// The chuck and tailstock barriers.
    Barrier "barrier"
    /// Blocks with a slash.
    BlockDelete "block-delete"
    /// Operators on bits.
    Boolean "boolean"
    /// The C axis.
    CAxis "c-axis"
    /// G75.
    Chamfer "chamfer"
    /// Comments.
    Comment "comment"
    /// Coolant on and off.
    Coolant "coolant"
    /// READ, WRITE, GET and PUT.
    Communication "communication"
    /// Contour generation and coordinate conversion.
    ContourGeneration "contour-generation"
    /// GOTO and IF.
    ControlStatement "control-statement"
    /// G96.
    CuttingSpeed "cutting-speed"
    /// Cycles of driven tools.
    DrivenCycle "driven-cycle"
    /// G04.
    Dwell "dwell"
    /// Expressions.
    Expression "expression"
    /// F words and their units.
    Feed "feed"
    /// Functions in expressions.
    Function "function"
    /// Gear codes and the speeds of the gears.
    Gear "gear"
    /// Grooving, drilling and tapping cycles.
    Grooving "grooving"
    /// G91.
    Incremental "incremental"
    /// LAP, the lathe auto-programming function.
    Lap "lap"
    /// Travel limits.
    Limits "limits"
    /// Input and output variables.
    InputOutput "input-output"
    /// Linear motion.
    Linear "linear"
    /// Local variables.
    LocalVariable "local-variable"
    /// Rotary tools.
    MTool "m-tool"
    /// G and M codes that call a subprogram.
    MacroCode "macro-code"
    /// MODIN and MODOUT.
    ModalCall "modal-call"
    /// M01.
    OptionalStop "optional-stop"
    /// Program names, headers and what else surrounds the blocks of a program.
    ProgramName "program-name"
    /// Nose and cutter radius compensation, and its planes.
    RadiusCompensation "radius-compensation"
    /// Positioning.
    Rapid "rapid"
    /// G76.
    Rounding "rounding"
    /// Schedule programs.
    Schedule "schedule"
    /// Sequence names.
    SequenceName "sequence-name"
    /// The main spindle.
    Spindle "spindle"
    /// CALL and RTS.
    Subprogram "subprogram"
    /// System variables.
    SystemVariable "system-variable"
    /// Text in another code than seven-bit characters.
    TapeCode "tape-code"
    /// Thread cutting.
    Thread "thread"
    /// The time-over check of S, T and M functions.
    TimeOver "time-over"
    /// T words.
    Tool "tool"
    /// Torque limit and torque skip.
    Torque "torque"
    /// Turret functions.
    Turret "turret"
    /// Two saddles that move by themselves.
    TwoSaddles "two-saddles"
    /// Two turrets on one saddle, and M100.
    TwoTurrets "two-turrets"
    /// Unit systems other than 1 mm.
    Units "units"
    /// User alarms and their comment.
    UserAlarm "user-alarm"
    /// Common variables.
    Variable "variable"
    /// The W axis.
    WAxis "w-axis"
    /// G50 with axis words, and the shift variables.
    ZeroShift "zero-shift"
}

//! Alarms: the names, the control's own numbers where the manual prints them, the texts.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::Label;

/// Why the control refuses to go on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Alarm {
    /// Our stable name.
    pub name: AlarmName,
    /// The control's number, where the manual gives one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub number: Option<u16>,
    /// The code, address or name that the alarm is about, where the rule says which.
    #[serde(default, skip_serializing_if = "Label::is_empty")]
    pub detail: Label,
}

impl Alarm {
    /// The alarm of this name without detail.
    #[must_use]
    pub fn new(name: AlarmName) -> Self {
        Self { name, number: name.number(), detail: Label::default() }
    }

    /// The alarm with a detail.
    #[must_use]
    pub fn about(name: AlarmName, detail: Label) -> Self {
        Self { detail, ..Self::new(name) }
    }
}

macro_rules! alarms {
    ($($variant:ident $name:literal $number:expr, $text:literal;)*) => {
        /// Stable names of the alarms.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub enum AlarmName { $(#[doc = $text] #[serde(rename = $name)] $variant),* }

        impl AlarmName {
            /// Every alarm.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// The name, such as `no_feed`.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self { $(Self::$variant => $name),* }
            }

            /// What it means, for people.
            #[must_use]
            pub fn text(self) -> &'static str {
                match self { $(Self::$variant => $text),* }
            }

            /// The control's number, where the manual prints one.
            #[must_use]
            pub fn number(self) -> Option<u16> {
                match self { $(Self::$variant => $number),* }
            }
        }
    };
}

alarms! {
    IllegalCharacter "illegal_character" None, "illegal character";
    ParityError "parity_error" None, "character with wrong parity";
    HeaderMalformed "header_malformed" None, "malformed file header";
    BlockTooLong "block_too_long" None, "block longer than 158 characters";
    CommentUnclosed "comment_unclosed" None, "comment without closing parenthesis";
    ProgramNameMalformed "program_name_malformed" None, "malformed program name";
    ProgramNameReserved "program_name_reserved" None, "program name reserved for the system";
    ProgramNameNotAlone "program_name_not_alone" None, "program name with other words in its block";
    ProgramNameMisplaced "program_name_misplaced" None, "program name inside a program";
    SequenceNameMalformed "sequence_name_malformed" None, "malformed sequence name";
    SequenceDelimiterMissing "sequence_delimiter_missing" None, "no blank after a sequence name";
    SequenceNameDuplicate "sequence_name_duplicate" None, "sequence name used twice";
    SlashMisplaced "slash_misplaced" None, "block delete mark in a wrong place";
    ProgramKind "program_kind" None, "a subprogram cannot be started by itself";
    StatementMisplaced "statement_misplaced" None, "control statement not at the beginning of its block";
    StatementDelimiterMissing "statement_delimiter_missing" None, "no blank after a control statement or a name";
    Format "format" None, "format error";
    NumberMalformed "number_malformed" None, "malformed number";
    TooManyDigits "too_many_digits" None, "number of more than eight digits";
    EqualSignMissing "equal_sign_missing" None, "no equal sign after an address";
    AddressUnknown "address_unknown" None, "unknown address";
    OperatorBlankMissing "operator_blank_missing" None, "no blank around an operator word";
    FunctionBracketMissing "function_bracket_missing" None, "function argument not in brackets";
    BracketUnbalanced "bracket_unbalanced" None, "unbalanced bracket or wrong number of arguments";
    VariableNumber "variable_number" None, "common variable number outside 1 to 200";
    SystemVariableUnknown "system_variable_unknown" None, "illegal system variable";
    VariableSuffix "variable_suffix" None, "wrong suffix of a system variable";
    VariableReadOnly "variable_read_only" None, "assignment to a read-only variable";
    VariableRange "variable_range" None, "variable value out of range";
    LocalNameMalformed "local_name_malformed" None, "malformed name of a local variable";
    LocalUndefined "local_undefined" None, "local variable without value";
    LocalCapacity "local_capacity" None, "more than 127 local variables";
    DuplicateAddress "duplicate_address" None, "address used twice in a block";
    TooManyM "too_many_m" None, "more than eight M codes in a block";
    AddressRange "address_range" None, "value out of the range of its address";
    ToolNumber "tool_number" None, "tool number out of range";
    GCodeUnassigned "g_code_unassigned" None, "G code not assigned";
    MCodeUnassigned "m_code_unassigned" None, "M code not assigned";
    AbsoluteAndIncremental "absolute_and_incremental" None, "G90 and G91 in one block";
    GCodesConflict "g_codes_conflict" None, "two G codes of one group in a block";
    MCodesConflict "m_codes_conflict" None, "two M codes of one group in a block";
    TurretMissing "turret_missing" None, "turret not on this machine";
    TurretChange "turret_change" None, "change of turret in a mode that does not allow it";
    SidesDiffer "sides_differ" None, "code that both saddles must command together";
    NotAlone "not_alone" None, "code must stand alone in its block";
    CuttingSpeedMissing "cutting_speed_missing" None, "G96 or G97 without S";
    WordMissing "word_missing" None, "missing word";
    WordWithoutFunction "word_without_function" None, "word without function in its block";
    AxisMissing "axis_missing" None, "axis not on this machine";
    OffsetWithG50 "offset_with_g50" None, "tool offset number in a zero shift block";
    TorqueLimitRange "torque_limit_range" None, "torque limit above the parameter";
    TorqueReachedEarly "torque_reached_early" Some(1219), "torque reached during the approach";
    TorqueNotReached "torque_not_reached" Some(1220), "torque not reached";
    ThreadInConstantSpeed "thread_in_constant_speed" None, "thread cutting at constant cutting speed";
    ThreadLeadRange "thread_lead_range" None, "lead of a thread out of range";
    ThreadData "thread_data" None, "impossible data of a thread cycle";
    CycleIncremental "cycle_incremental" None, "cycle of a driven tool in G91";
    CycleWord "cycle_word" None, "code not allowed in a cycle of a driven tool";
    CycleFeedMode "cycle_feed_mode" None, "cycle of a driven tool in the wrong feed mode";
    CycleCancelMissing "cycle_cancel_missing" None, "cycle with Q not ended by G180";
    CycleApproachNegative "cycle_approach_negative" None, "negative approach of a cycle";
    CycleDepthOverdetermined "cycle_depth_overdetermined" None, "bottom of a hole given twice";
    LapLevel "lap_level" None, "needs the LAP option";
    LapData "lap_data" None, "impossible data of a LAP cycle";
    LapStartPoint "lap_start_point" None, "AP start on the wrong side of the contour";
    LapAllowance "lap_allowance" None, "finish allowance beyond the AP start";
    BlankFirstElement "blank_first_element" None, "blank that begins with an arc";
    ContourMalformed "contour_malformed" None, "malformed contour definition";
    ContourDirection "contour_direction" None, "contour runs back along the cutting axis";
    DescendingSlopes "descending_slopes" None, "more than ten descending slopes";
    ContourXNotPositive "contour_x_not_positive" None, "contour of the C axis at an X that is not positive";
    ContourArcZ "contour_arc_z" None, "Z in an arc on the face";
    ContourXChanged "contour_x_changed" None, "X changed in an arc on the side";
    ProfileGeneration "profile_generation" Some(2480), "C axis wound too far in contour generation";
    ContourCommandUnusable "contour_command_unusable" Some(2224), "contour generation on the side outside G119";
    ConversionIncremental "conversion_incremental" None, "coordinate conversion in G91";
    ConversionAxisMissing "conversion_axis_missing" None, "first point of coordinate conversion without X or Y";
    ConversionAtLimit "conversion_at_limit" None, "coordinate conversion begun at a travel limit";
    MotionCodeMissing "motion_code_missing" None, "no motion code after G137";
    ChamferNotLinear "chamfer_not_linear" None, "chamfer or rounding outside G01";
    ChamferDisabled "chamfer_disabled" None, "automatic chamfering not enabled";
    ChamferAxes "chamfer_axes" None, "wrong axis travel in a chamfer block";
    ChamferTooShort "chamfer_too_short" None, "block shorter than its chamfer";
    ChamferCorner "chamfer_corner" None, "chamfer at a corner that is not between two lines";
    AngleOverdetermined "angle_overdetermined" None, "angle with too many coordinates";
    AngleUnderdetermined "angle_underdetermined" None, "angle without coordinate";
    AngleNoIntersection "angle_no_intersection" None, "angle gives no intersection";
    AngleLookahead "angle_lookahead" None, "next block lacks the data of the corner";
    ArcRadiusAndCentre "arc_radius_and_centre" None, "arc with radius and centre";
    ArcRadiusNotPositive "arc_radius_not_positive" None, "arc radius not positive";
    ArcRadiusNeedsBoth "arc_radius_needs_both" None, "arc by radius needs X and Z";
    ArcRadiusTooSmall "arc_radius_too_small" None, "arc radius smaller than half the chord";
    ArcRadiusMismatch "arc_radius_mismatch" None, "arc end point not on the circle";
    ArcWithoutCentre "arc_without_centre" None, "arc without centre or radius";
    ArcNoEndPoint "arc_no_end_point" None, "arc does not meet the commanded coordinate";
    CompensationNotLinear "compensation_not_linear" None, "radius compensation begun or ended outside G00 and G01";
    CompensationStartUp "compensation_start_up" None, "no contour element after the start of radius compensation";
    CompensationImaginaryPoint "compensation_imaginary_point" None, "I and K both zero";
    CompensationNoIntersection "compensation_no_intersection" None, "no compensated point at a corner";
    CompensationArcTooSmall "compensation_arc_too_small" None, "inside arc smaller than the nose radius";
    CompensationNotAllowed "compensation_not_allowed" None, "command not allowed in radius compensation";
    PlaneChangeInCompensation "plane_change_in_compensation" None, "plane selected in radius compensation";
    CoordinateRange "coordinate_range" None, "target coordinate out of range";
    CAxisNotJoined "c_axis_not_joined" None, "C command while the C axis is not joined";
    CAxisClamped "c_axis_clamped" None, "C command while the C axis is clamped";
    MToolNotJoined "m_tool_not_joined" None, "M-tool command while the C axis is not joined";
    NoFeed "no_feed" None, "cutting motion without feed";
    TravelLimitNegative "travel_limit_negative" None, "target beyond the negative travel limit";
    TravelLimitPositive "travel_limit_positive" None, "target beyond the positive travel limit";
    Barrier "barrier" None, "motion into a barrier";
    TurretClamp "turret_clamp" Some(1730), "turret clamp or position code";
    StmOver "stm_over" None, "S, T or M function took too long";
    DivisionByZero "division_by_zero" None, "division by zero";
    IntegerOverflow "integer_overflow" None, "integer overflow";
    RealOverflow "real_overflow" None, "real overflow";
    FunctionDomain "function_domain" None, "argument outside the domain of its function";
    UserTaskLevel "user_task_level" None, "needs User Task 2";
    SequenceNameUnknown "sequence_name_unknown" None, "no block with the sequence name";
    ProgramUnknown "program_unknown" None, "no program with the name";
    ProgramDuplicate "program_duplicate" None, "two programs with one name";
    CallDepth "call_depth" None, "too many subprograms within each other";
    NoReturn "no_return" None, "subprogram without RTS";
    ReturnOutsideSubprogram "return_outside_subprogram" None, "RTS outside a subprogram";
    ModinDepth "modin_depth" None, "more than eight MODIN modes";
    ModoutWithoutModin "modout_without_modin" None, "MODOUT without MODIN";
    MacroUnassigned "macro_unassigned" None, "macro code without a program";
    UserAlarmA "user_alarm_a" Some(1213), "user reserve code, alarm A";
    UserAlarmB "user_alarm_b" Some(2288), "user reserve code, alarm B";
    UserAlarmC "user_alarm_c" Some(3202), "user reserve code, alarm C";
    DeviceUnknown "device_unknown" None, "no such device";
    DeviceNoData "device_no_data" None, "nothing to be read from the device";
    ReadTooLong "read_too_long" None, "more than 160 characters received";
    ReadPointer "read_pointer" None, "read pointer beyond the characters received";
    ReceivedNumber "received_number" None, "characters that form no number";
    FieldLength "field_length" None, "wrong number of characters in GET or PUT";
    FieldTooSmall "field_too_small" None, "number wider than its field";
    WriteAreaFull "write_area_full" None, "more than 160 characters to be sent";
    StringTooLong "string_too_long" None, "character string too long";
    ForbiddenCode "forbidden_code" None, "end code among the characters to be sent";
    ScheduleBlock "schedule_block" None, "block not allowed in a schedule program";
    ScheduleStatement "schedule_statement" None, "statement of schedule programs outside one";
    ScheduleLeftSide "schedule_left_side" None, "variable that VSET cannot set";
    ScheduleRightSide "schedule_right_side" None, "output variable on the right side of VSET";
    ScheduleEndMissing "schedule_end_missing" None, "schedule program without END";
    FileWildcard "file_wildcard" None, "asterisk or question mark in a file name";
    FileNameMalformed "file_name_malformed" None, "malformed file name";
    FileMissing "file_missing" None, "no such file";
    ProgramMissing "program_missing" None, "no such program in the file";
    MainEndMissing "main_end_missing" None, "selected main program without M02 or M30";
    SubprogramRtsMissing "subprogram_rts_missing" None, "subprogram of a selected main program without RTS";
    RepetitionsRange "repetitions_range" None, "number of repetitions outside 1 to 9999";
    StepLimit "step_limit" None, "step limit reached";
    NoProgramEnd "no_program_end" None, "no M02 or M30";
    Unspecified "unspecified" None, "not defined by the manual";
    NotModelled "not_modelled" None, "not modelled yet";
}

impl fmt::Display for AlarmName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

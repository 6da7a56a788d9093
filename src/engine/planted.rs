//! Known-wrong variants of the engine, to see whether the differential tests find them.
//!
//! Each is one expression elsewhere in the engine under [`is`]. Without the Cargo feature `planted-bugs` that is
//! a constant `false`, so that nothing of them is left in the program; with it a thread plants one bug at a time.

macro_rules! bugs {
    ($($variant:ident $bound:literal $family:literal [$($rule:ident),*] $description:literal)*) => {
        /// A known-wrong variant.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Bug { $(#[doc = $description] $variant),* }

        #[cfg(feature = "planted-bugs")]
        impl Bug {
            /// Every bug.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// What is known of it.
            #[must_use]
            pub fn entry(self) -> Entry {
                use turnspec_oracle::vocabulary::rule_ids::*;
                match self {
                    $(Self::$variant => Entry {
                        name: stringify!($variant),
                        family: $family,
                        description: $description,
                        rules: &[$($rule),*],
                        bound: $bound,
                    }),*
                }
            }
        }
    };
}

bugs! {
    ParityIgnored 3000 "text" [CMT_02] "A byte of wrong parity on an ISO tape reads as its seven bits."
    LongestBlock 50000 "text" [FMT_05] "A block may be one character longer than the longest one."
    ContinuationNotCounted 200 "text" [FMT_05] "Continuation lines do not count as lines."
    GreedyComment 200 "text" [CMT_01] "A comment ends at the last closing parenthesis of its block."
    SecondSlash 8000 "blocks" [DEL_02] "A slash before and behind the sequence name is accepted."
    SkippedNameForgotten 25000 "blocks" [SEQ_03] "The sequence name of a skipped block may be used again."
    NineDigits 1400 "items" [TYPE_02, TYPE_03, DEC_04] "A plain number may have nine digits."
    DuplicateFeed 20000 "items" [FMT_06] "A second F word takes the place of the first one."
    GroupConflictLost 20000 "items" [MCODE_01] "Two M codes of the gear group may share a block."
    LengthCut 100 "numbers" [TYPE_07, INCH_02] "A length that is no whole number of increments is cut, not rounded."
    WholeInchRounded 100 "numbers" [INCH_02] "A length in inches without a point is rounded, not cut."
    DwellUnit 1000 "numbers" [DWELL_02] "A dwell in the 10 micrometre system counts hundredths of a second."
    RightAssociative 160 "expressions" [AEXP_05] "Subtractions in a row are carried out from right to left."
    ExclusiveOrBinding 8000 "expressions" [AEXP_07] "EOR binds as strongly as AND."
    SignsCollapse 100 "expressions" [AEXP_06, TYPE_09] "Two minus signs in a row count as one."
    HexadecimalSaturates 500 "expressions" [MATH_18] "A hexadecimal constant beyond 7FFFFFFF is held at that."
    LessEqualStrict 4000 "expressions" [AEXP_03, TYPE_11] "LE does not hold of equal numbers."
    IntegerQuotient 200 "expressions" [TYPE_10] "The quotient of two integers is cut to an integer."
    CosineBySine 17000 "expressions" [FUNC_04] "COS is the sine of the angle and 90 degrees."
    ArcTangentUlp 700 "expressions" [FUNC_07] "ATAN2 is one unit in the last place too large."
    ModSign 1500 "expressions" [FUNC_18] "MOD has the sign of the divisor."
    RoundTiesToEven 19000 "expressions" [FUNC_12] "ROUND takes a half to the even number."
    VariableIndex 600 "variables" [CVAR_01] "Reading V100 and higher ones gives the variable before."
    NegativeZero 1600 "variables" [CVAR_04, TYPE_04] "A common variable keeps a negative zero."
    ActiveOffsetSilent 4000 "variables" [SVAR_05] "A change of the active tool offset is not reported as a change of the frame."
    FeedOfOtherMode 900 "modes" [FEED_03] "After G94 or G95 the feed keeps the value of the mode in which it was given."
    ResetForgetsDroop 100 "modes" [MCODE_04] "The end of the program does not reset G65."
    ResetAfterEnd 100 "modes" [MCODE_04] "The end of the program is reported before what it resets."
    ShiftReplaced 300 "frame" [G50_02] "A second G50 counts its shift from an unshifted frame."
    ShiftTwice 400 "frame" [COORD_03] "The zero shift enters the W frame twice."
    OffsetOfPreviousTool 500 "tools" [TOOL_02] "A T word of tool number 00 keeps the tool offset of before."
    AlwaysIndexes 1900 "tools" [TOOL_06] "The turret indexes to the station that it has."
    TimeLimitInclusive 8000 "tools" [STM_01] "An S or T function that takes exactly the permitted time is over time."
    CuttingForgotten 5000 "tools" [TUNC_02] "A rapid motion does not end the state after a cutting motion."
    ClampInclusive 7000 "spindle" [SMAX_01] "A speed equal to the clamp counts as clamped."
    ClampIgnored 10000 "spindle" [SMAX_01] "The clamp of G50 S does not limit the lowest speed of a gear."
    GearMinimumLost 1000 "spindle" [CSS_04] "A cutting speed below the lowest speed of the gear is not raised."
    SpeedAtStart 100 "spindle" [CSS_01] "The speed of a motion at constant cutting speed is that of its start."
    AnswerWithoutMotion 3000 "spindle" [M63_02] "M63 makes a spindle command go with a motion that the block does not have."
    LimitOfArcs 3000 "motion" [LIM_01] "An arc beyond a positive limit is held at it instead of refused."
    LimitInclusive 1200 "motion" [LIM_01] "A coordinate on the positive limit counts as beyond it."
    PathWithoutW 100 "motion" [G01_04] "The travel of W is left out of the path of the feed."
    DiameterRule 100 "motion" [ABS_03] "An incremental X does not cite its rule."
    CWrap 500 "c axis" [CAX_05] "The machine coordinate of C is not brought into the turn."
    TurnsOfNegativeSense 1800 "c axis" [CAX_06] "Full turns of QA go the positive way under M16."
    ClampLost 4000 "c axis" [CAX_07] "A clamped C axis turns."
    LineTurnsForward 3000 "contours" [CGF_06] "C turns forward along every line of the face."
    OverrideIgnored 3000 "contours" [CGF_12] "C turns at the centre with the full feed."
    ThroughCentreBackward 3000 "contours" [CGF_11] "Through the centre C turns back by 180 degrees."
    LatchedChord 10000 "contours" [CGF_04] "The distance of the ends of an arc is that of the latched points."
    ArcWithChord 3000 "contours" [CGF_06] "C turns along an arc as along its chord, also round the centre."
    NearCentreCut 40000 "contours" [CGF_04] "An arc that passes the centre of the face is cut."
    InnerPlaneIgnored 3000 "contours" [CGS_02] "The side is seen from outside whatever the parameter says."
    PlaneBeforeBlock 20000 "contours" [CGS_08] "An arc of the side is tested in the plane in force before its block."
    LostPointHolds 20000 "contours" [CSC_06, CGF_14] "The point programmed last holds wherever the axes stand."
    ShiftTurnsBack 6000 "contours" [CSC_04] "A zero shift that is excluded turns the other way."
    DirectionKept 20000 "contours" [CSC_01] "G137 in conversion mode keeps the direction of before."
    CodeKept 20000 "contours" [CSC_05] "G137 in conversion mode does not cancel the motion code."
    AtLimitAllowed 40000 "contours" [CSC_10] "Conversion mode begins on a positive limit."
    CentreDiameter 100 "arcs" [CIRC_05] "I is taken on the diameter."
    MajorSide 100 "arcs" [CIRC_18] "CALRG does not change the side of the centre of G02."
    QuadrantOnAxis 3000 "arcs" [CIRC_08] "An arc that starts on an axis line enters the wrong quadrant."
    ToleranceOnDiameter 500 "arcs" [CIRC_11] "The permissible difference of the radii is taken on the diameter."
    ArcReading 100 "arcs" [CIRC_08] "An arc with one coordinate does not name its reading."
    CornerBaseKept 7000 "arcs" [CHAM_13] "After an arc incremental words still count from the corner of the chamfer before it."
    FaceAsLeg 200 "chamfers" [ANG_03] "L of an any-angle chamfer is the leg whatever the reading says."
    LegRadius 100 "chamfers" [CHAM_03] "The leg along X of a basic chamfer is taken on the diameter."
    RoundingSense 100 "chamfers" [CHAM_11] "A basic rounding from X to Z goes round the wrong way."
    ExactFit 300 "chamfers" [CHAM_07] "A basic chamfer that takes the whole motion is too long."
    NextDimension 800 "chamfers" [ANG_05] "Look-ahead takes the dimension mode of this block for the next one."
    NextInchStale 3000 "chamfers" [INCH_02] "Whether a block read ahead has inch words is taken from the block before."
    CornerReading 600 "chamfers" [CHAM_13] "Incremental words after a chamfer always count from its end."
    AlarmOneBlockEarly 3000 "look-ahead" [ANG_05, ANG_06] "A fault of a block that is read ahead is reported at the block before it."
    TaperRadius 100 "angles" [DTAP_03] "X of a line at an angle is a radius."
    SideOfNoseThree 300 "compensation" [NRC_02] "The nose of entry 3 runs on the other side of the contour."
    SmallerRadius 300 "compensation" [NRC_04] "The nose radius is the smaller of the two amounts of its entry."
    BoringTip 500 "compensation" [NRC_05] "A negative X of a nose counts as positive on the way from the tip."
    LatchedRadius 100 "compensation" [NRC_07] "X of the nose centre is latched as a radius."
    TipOfNextNose 170 "compensation" [NRC_11] "The end of a motion has the tip of the nose that is in force when it becomes known."
    CornerOfOneRadius 1300 "compensation" [NRC_11] "A corner of two lines has the radius of the first one throughout."
    StartUpRadius 1400 "compensation" [NRC_15] "The start-up ends with its own radius, not that of the next element."
    StartUpWithoutWords 100 "compensation" [NRC_20] "A start-up block without words of axes has no motion."
    ImaginaryStart 600 "compensation" [NRC_23] "The imaginary line of a start-up leads to the imaginary point."
    ReversalOnOutgoing 1400 "compensation" [NRC_32, NRC_33] "Between parallel elements the nose touches on the side of the outgoing one."
    NearlyParallel 100 "compensation" [NRC_34] "Directions that turn by a few thousandths of a degree count as parallel."
    PathOfProgrammed 100 "compensation" [NRC_42] "The path of the feed is counted from the programmed start."
    FirstIdleBlock 100 "compensation" [NRC_43, NRC_44] "The first block without X/Z motion ends an element, not the second."
    RepetitionCounted 500 "compensation" [NRC_46] "A repeated point counts as a block without X/Z motion."
    ExtraForgotten 2200 "compensation" [NRC_46] "The extra motion back to a corner is left out."
    ExtraAlways 500 "compensation" [NRC_46] "The extra motion is made to a corner where the tip is already."
    InsideArcOfTheNose 1100 "compensation" [NRC_48] "An inside arc as large as the nose is too small."
    CommonPointAhead 100 "compensation" [NRC_51] "Of the common points of a line and a circle the one ahead is taken."
    ImaginaryCancel 500 "compensation" [NRC_69] "The imaginary line of G40 leads from the imaginary point."
    LeftOverAxis 2200 "compensation" [NRC_66, NRC_71] "After G40 an axis without a word keeps its displacement."
    HeldMotion 4000 "compensation" [NRC_43] "A motion of C or W that was held shows the programmed point."
    HeldAhead 100 "compensation" [NRC_12] "Events that are held come before the motion that they are held behind."
    LimitOfProgrammed 3000 "compensation" [NRC_80] "Travel limits are tested on the programmed point."
    SamePlane 3200 "compensation" [CRC_13] "The plane that is in force may be selected again in compensation."
    PlaneKept 7000 "compensation" [CRC_03] "M109 leaves the plane as it is."
    CutterSideMirrored 1000 "cutter" [CGS_02, CRC_05] "In G119 a cutter runs on the side that is seen from outside whatever the parameter says."
    CutterEntryOfOffset 1000 "cutter" [CRC_08, NRC_04] "The radius of a cutter comes from the entry with the offset number."
    CutterTravelOfProgram 1000 "cutter" [CRC_16] "In G00 and G01 C travels to where the programmed point has it."
    CutterTurnsAsNow 1000 "cutter" [CRC_16] "C turns in the direction in force when the end of a motion becomes known."
    CutterTurnUncited 1000 "cutter" [CRC_16] "A travel of C in G00 and G01 does not cite its rule."
    CutterMajorArc 1000 "cutter" [CRC_15] "An arc of a cutter of more than 180 degrees is executed as it is."
    CutterPathToProgram 1000 "cutter" [CGF_02, CRC_06] "The length of a line of G101 of a cutter is measured to the programmed point."
    CutterTurnsForgotten 1000 "cutter" [CRC_14, CRC_07] "In G119 the length on the cylinder is counted from the start of each block."
    CutterCentreFromOrigin 1000 "cutter" [CRC_07] "The centre of an arc on the side is shown from where C stood when compensation began."
    CutterUnwoundLost 1500 "cutter" [CRC_07] "Along an arc of the side C turns the shorter way."
    CutterFrameFree 15000 "cutter" [CRC_14] "The frame may change while a cutter is compensated."
    CutterClampLost 6000 "cutter" [CAX_07, CRC_14] "A motion of the plane of a cutter without C word turns a clamped C axis."
    CutterWaits 6000 "cutter" [CRC_14] "A second block without motion in the plane ends an element of a cutter in contact."
    CutterThroughCentre 1000 "cutter" [CRC_14] "A cutter may stop in the centre of the face."
    CutterDiameterUncited 1000 "cutter" [CRC_18] "Motions of a cutter in G119 do not cite the rule of the diameter."
    CutterHeldMotion 1000 "cutter" [CRC_14] "A motion of Z or W that was held shows the programmed point, not the cutter."
    CutterLimitOfProgram 18000 "cutter" [NRC_80] "Travel limits of a cutter are tested on the programmed point."
    CutterWholeTurn 45000 "cutter" [CRC_14] "Where rounding contradicts the side of a line on one ray C turns once round."
    TorqueStopReused 1000 "torque" [TRQ_03] "A second torque skip stops where the first one did."
    TorqueLimitLost 8000 "torque" [TRQ_01] "G29 takes off the limit of the axis that it does not name."
    JumpBehindTarget 100 "jumps" [GOTO_01] "A jump goes on behind the block that it leads to."
    LastOfEqualNames 3000 "jumps" [GOTO_02, SEQ_03] "Of two blocks with one sequence name the last one is meant."
    NamesBeyondEnd 60000 "jumps" [GOTO_02] "A jump looks for its name beyond the end of the program too."
    SkippedNoTarget 1100 "jumps" [GOTO_02] "A jump does not find the name of a block that is skipped."
    PositiveConditions 1900 "jumps" [IFST_04] "A condition is true for positive values only."
    DefinedHere 25000 "jumps" [IFST_02] "IF with a local name asks for entries of the program that runs alone."
    FalseNeedsName 300 "jumps" [IFST_03] "The name of an IF has to exist although its condition is false."
    OneStepMore 300 "jumps" [GOTO_03] "A run may begin one block more than the limit of its steps."
    AheadNoStep 3000 "jumps" [GOTO_03] "A block that was looked ahead at is no step when the run arrives there."
    OldestEntry 1200 "local variables" [LVAR_09] "Reading a local name gives its first registered entry."
    CallAssigns 7000 "local variables" [LVAR_08] "An assignment behind CALL changes an entry of that name instead of covering it."
    EntriesKept 3000 "local variables" [LVAR_12] "The local variables of a program stay after its RTS."
    OneLocalMore 10000 "local variables" [LVAR_03] "A 128th local variable is accepted."
    ReturnBehindNext 100 "calls" [RTS_02] "RTS leads to the block after the next one."
    NameNotRestored 100 "calls" [RTS_02] "After RTS the name of the called program stays in force."
    OneCallMore 3000 "calls" [CALL_04] "One program more than permitted may be active."
    ModalCallsUncounted 16000 "calls" [CALL_04] "Modal calls do not count for the depth of calls."
    MainTextPassed 100 "calls" [CALL_03] "Programs of the main text are not found."
    FirstOfEqualPrograms 3000 "calls" [NAME_05] "Of two programs of one name the first one is called."
    MacroRange 300 "calls" [MACRO_01] "G171 begins a modal call."
    TextsMixedUp 100 "calls" [CALL_02] "A block that is kept is taken for one at the same place of another text."
    StatementCounts 500 "calls" [CTL_01] "A statement counts as a block without X/Z motion in compensation."
    TriggeredByC 1400 "modal calls" [MODIN_03] "A motion of C alone triggers modal calls."
    IdleNoTrigger 600 "modal calls" [MODIN_03] "A motion without travel triggers nothing."
    ModesBackwards 4000 "modal calls" [MODIN_06] "The mode that began last is called first."
    ModeCallsItself 100 "modal calls" [MODIN_07] "A motion inside a modal call calls its own mode too."
    PlaceOfReturn 3500 "modal calls" [MODIN_02] "The second of two modal calls has the place of the RTS before it."
    FirstModeEnds 6000 "modal calls" [MODIN_04] "MODOUT ends the mode that began first."
    ModeEntriesEnd 8000 "modal calls" [MODIN_09] "The variables of a MODIN block are removed by the first RTS."
    NineModes 4000 "modal calls" [MODIN_05] "A ninth mode is accepted."
    ClosedArea 900 "barriers" [BARR_01] "Touching the edge of an area is an alarm."
    TailstockFirst 20000 "barriers" [BARR_01] "Of both barriers the tailstock is named."
    MachineEnd 300 "barriers" [BARR_01] "The end of a path is tested as a machine coordinate."
    HeightOnDiameter 4000 "barriers" [BARR_02] "The heights of the jaw count on the diameter."
    GripDiameterSigned 5000 "barriers" [BARR_02] "The sign of the gripping diameter counts."
    ImageForgotten 4000 "barriers" [BARR_01, BARR_02] "The chuck is watched on one side of the axis alone."
    JawFromFront 500 "barriers" [BARR_02] "The jaw has its height up to the front face."
    TailstockAbove 14000 "barriers" [BARR_01, BARR_03] "The tailstock is watched with X positive alone."
    CentreForgotten 26000 "barriers" [BARR_03] "The diameter of the centre does not count for the front step."
    StepAlone 16000 "barriers" [BARR_03] "A step of the tailstock reaches only as far as its own length."
    OnBlockFree 300 "barriers" [BARR_04] "The motion of the block that switches a barrier on is not watched."
    OffBlockFree 3000 "barriers" [BARR_04] "The motion of the block that switches a barrier off is not watched."
    EndsAlone 7000 "barriers" [BARR_08] "A positioning is tested at its end whatever the reading says."
    ChordOfArc 9000 "barriers" [BARR_09] "An arc is tested as its chord."
    SweepSense 700 "barriers" [BARR_09] "An arc is tested on the other way round."
    WholeCircle 700 "barriers" [BARR_09] "An arc is tested as its whole circle."
    MirrorForgotten 100 "turrets" [MIRR_05] "Machine X of turret B has the sign of program X."
    LimitsNotMirrored 1800 "turrets" [MIRR_05, LIM_01, LIM_02] "The limits of X are those of the plane of turret B."
    HeldNotMirrored 60000 "turrets" [MIRR_05, NRC_07] "A motion that was held is displaced in the wrong direction of machine X."
    OffsetOfOtherTurret 6000 "turrets" [MIRR_18] "The number of the tool offset stays at a change of turret."
    DirectionNotMirrored 1400 "turrets" [MIRR_06] "M03 turns the spindle in one direction with both turrets."
    ReversalAllowed 10000 "turrets" [MIRR_08] "The other turret may turn the spindle the other way round."
    ChangeInIncremental 6000 "turrets" [MIRR_09] "The turret may change in G91."
    ShiftOfBKept 2500 "turrets" [MIRR_18, G50_05] "The reset does not clear the zero shift of turret B."
    GreaterGoesOn 100 "saddles" [PSYNC_03] "The side with the greater P goes on."
    CommonTwice 1200 "saddles" [AX4_06] "Both sides carry out the common words of blocks that start together."
    SWithoutG50 60000 "saddles" [AX4_06] "S of a G50 block is the same as the S of another."
    AloneWaits 100 "saddles" [PSYNC_04] "A side goes on waiting at P when the other one has ended."
    OwnReference 4500 "saddles" [AX4_08] "The cutting speed refers to the side that commands it."
    DivisorIgnored 300 "threads" [THRD_06] "The lead is F whatever J is."
    LeadCut 3000 "threads" [THRD_04] "The quotient of F and J is cut, not rounded."
    DivisorKept 3000 "threads" [THRD_06] "An F word without J keeps the J of before."
    SameCodeGoesOn 3000 "threads" [G33_03] "A thread code that is written again goes on with the cycle."
    AngleOfFollowUp 3000 "threads" [G33_10] "C of a follow-up block is the start angle from there on."
    AngleInChain 3000 "threads" [G34_05] "Each length of a chain begins at its own C."
    LegFromCorner 2500 "threads" [ANG_06] "In G91 a leg behind a block with A alone counts from the corner."
    ShrinkingGrows 300 "threads" [G34_02] "The lead grows in G35 too."
    TaperHalved 300 "threads" [G33_05] "I is the difference of diameter."
    TaperFromCycleStart 3000 "threads" [G33_06, G33_07] "The taper of an angle counts from the cycle start, not from the shifted start."
    LastLeadUntested 12000 "threads" [G33_09] "A lead that leaves its range before the end is cut."
    ConstantSpeedLater 12000 "threads" [THRD_01] "In a thread mode selected before a thread is cut in G96."
    RateOfParameterLost 300 "threads" [TCHM_03] "The chamfer withdraws at 3000 mm/min whatever the parameter says."
    ChamferOfFirstLead 1000 "threads" [TCHM_03] "The chamfer of a changing lead has the lead of the start."
    ChamferBeyondStart 1000 "threads" [TCHM_04] "A chamfer goes on beyond the level of the cycle start."
    OpeningTaperAllowed 20000 "threads" [TCHM_04] "A chamfer on a taper that opens faster is cut."
    SpringPass 300 "threads" [G71_07] "Without an allowance the last depth is cut twice."
    RemainderLeft 1000 "threads" [TINF_02] "M73 leaves out the shorter step up to T - D."
    TargetTwice 6000 "threads" [TINF_04] "A depth of equal areas that is the last one comes twice."
    BalancedCut 6000 "threads" [TINF_06, TINF_07] "The number of passes of equal area is rounded down."
    PatternStale 6000 "threads" [G71_09] "Height and first depth are tested by the pattern in force before the block."
    PassesUncounted 6000 "threads" [G71_10, GOTO_03] "The passes of a cycle are no steps of the run."
    StartsCut 3000 "threads" [TMUL_01] "The angle of a start is cut to a micro-degree."
    TurnsOnOtherFlank 1000 "threads" [TMOD_04] "In M33 the passes of even number lie on the flank of M32."
    FlankOnRadius 1000 "threads" [TMOD_02] "On the face the flank shift counts on the radius."
    LastPeckWhole 100 "cycles" [GRV_04, G183_01] "The last peck is as deep as the others."
    PeckReadingLost 1000 "cycles" [GRV_04] "The retract of a peck on X counts on the diameter whatever the reading says."
    PecksUncounted 6000 "cycles" [GOTO_03] "The pecks of a block are no steps of the run."
    DischargeOnce 300 "cycles" [GRV_05, G183_02] "After the first withdrawal the tool withdraws after every peck."
    DischargeLevelLost 3000 "cycles" [G183_02] "G183 withdraws to the cutting start whatever the reading says."
    HolesForward 3000 "cycles" [MCYC_20] "Holes round the axis go on in the positive direction under M16."
    DirectionAnew 12000 "cycles" [MCYC_05] "Each block of a cycle drills in the direction of its own bottom."
    SpentForgotten 12000 "cycles" [MCYC_21] "A hole may follow holes round the axis."
    ReturnLevelLost 300 "cycles" [MCYC_15] "M136 does not change the level of return."
    ClampKept 1000 "cycles" [MCYC_10, MCYC_18] "M169 lets the C axis be clamped."
    ZigzagShifted 1000 "cycles" [G190_04] "With M212 the odd passes run backwards."
    StepsCut 300 "cycles" [G190_05, G190_06] "The number of passes of a key way is rounded down."
    LeftTapTurnsRight 1000 "cycles" [STAP_03] "G179 turns the tool as G178 does."
    GrooveEdgeAdded 12000 "cycles" [GRV_08] "The offset of the other edge is added whatever the reading says."
    HelixOnDiameter 1000 "cycles" [CTHR_03] "On the face the C axis turns by the travel on the diameter."
    DepthOverBottom 1000 "cycles" [MCYC_22] "A bottom does not take the place of a depth that is kept."
    ChainStays 1000 "cycles" [CTHR_04] "G180 does not return from lengths that followed one another."
    TapsNotMirrored 12000 "cycles" [TAP_07] "Turret B taps in the direction of turret A."
    XAloneBehindCancel 50000 "cycles" [MCYC_13] "Behind G180 X suffices."
    ConversionEndsDuty 40000 "cycles" [MCYC_13] "G136 behind G180 ends the duty of X and Z."
    HoleOnDiameter 1000 "cycles" [CSC_09] "The X of a hole in conversion mode is a diameter."
    HoleDirectionLost 1000 "cycles" [CSC_09, CSC_03] "A hole in conversion mode leaves the angle of G137 out."
    HolePointForgotten 1000 "cycles" [CSC_06, CSC_09] "The point of a hole in conversion mode is not kept."
    LevelsUncounted 6000 "lap" [GOTO_03] "The passes of a rough cycle are no steps of the run."
    SingleReliefInRecess 1000 "lap" [AP1_12] "The relief of the last pass of a recess is that of any other one."
    FirstPassLeaves 6000 "lap" [AP4_01] "The first pass of mode IV leaves the contour at the upper level."
    ChangeBehindPoint 1000 "lap" [LAPC_03] "A change point acts only behind a pass that has gone beyond it."
    AllowanceUpToStart 12000 "lap" [LAP_20, AP2_01] "An allowance may reach up to the AP start."
    AllowanceForward 1000 "lap" [LAP_21] "The allowance on the cutting axis moves the contour in the cutting direction."
    AlwaysHome 1000 "lap" [LAPC_08] "M85 does not keep the tool where it is."
    KeptFeedAlways 1000 "lap" [LAP_08] "An element without E has the E before the call whatever the reading says."
    LastRecessFirst 3000 "lap" [AP1_11] "Of the recesses of a pass the last one is finished first."
    ShiftOutward 3000 "lap" [LAPC_06] "U of G87 moves the contour outward from inside too."
    MotionOfContourStays 1000 "lap" [LAP_13] "The motion mode of the contour stays in force behind G87."
    ClearanceIsNear 12000 "lap" [AP4_02, AP4_03] "An AP start at the clearance from the contour is near."
    InfeedBesideStart 1000 "lap" [AP1_03] "Passes of mode I begin at the run of the AP start."
    StockWithoutClearance 6000 "lap" [AP4_05] "Feed begins at the stock itself."
    HomeAtOnce 1000 "lap" [LAP_06] "The tool goes home in both axes at once behind a first motion in G01 too."
    WallEntered 12000 "lap" [AP5_03] "A pass along the blank that begins on a wall of the contour goes through it."
    WallLeftOnce 12000 "lap" [AP5_06] "A falling wall is left along the blank once at most."
    M100WaitsForM100 1100 "saddles" [M100_05] "A side at M100 whose counterpart waits at P goes on as if it had waited at M100."
}

/// What is known of a planted bug.
#[cfg(feature = "planted-bugs")]
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name.
    pub name: &'static str,
    /// The part of the language that it spoils.
    pub family: &'static str,
    /// What it does.
    pub description: &'static str,
    /// Rules that it breaks.
    pub rules: &'static [turnspec_oracle::vocabulary::RuleId],
    /// Within how many generated programs, seeds from 0 on, the comparison with the reference has to find it.
    pub bound: u64,
}

#[cfg(feature = "planted-bugs")]
thread_local! {
    static PLANTED: std::cell::Cell<Option<Bug>> = const { std::cell::Cell::new(None) };
}

/// Whether a bug is planted in this thread.
#[cfg(feature = "planted-bugs")]
#[must_use]
pub fn is(bug: Bug) -> bool {
    PLANTED.get() == Some(bug)
}

/// Whether a bug is planted: never in a build without the feature.
#[cfg(not(feature = "planted-bugs"))]
#[inline(always)]
pub const fn is(_: Bug) -> bool {
    false
}

/// Plants a bug in this thread in the place of the one before it, or none.
#[cfg(feature = "planted-bugs")]
pub fn plant(bug: Option<Bug>) {
    PLANTED.set(bug);
}

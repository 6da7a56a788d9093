//! Named readings: the choices that the manual leaves open and that two real machines may make
//! differently. The default is the reading that the rule's text gives reasons for.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

macro_rules! readings {
    ($($(#[$meta:meta])* $field:ident : $type:ident { $($(#[$vmeta:meta])* $variant:ident $text:literal),* })*) => {
        /// `[readings]` of a set-up.
        #[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(default, deny_unknown_fields)]
        pub struct Readings { $($(#[$meta])* pub $field: $type),* }

        $(
            $(#[$meta])*
            #[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
            #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
            pub enum $type { $($(#[$vmeta])* #[serde(rename = $text)] $variant),* }

            impl From<$type> for Reading {
                fn from(value: $type) -> Self {
                    match value { $($type::$variant => Reading::$type($type::$variant)),* }
                }
            }
        )*

        /// One reading with the value that was used.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Reading { $($(#[$meta])* $type($type)),* }

        impl Reading {
            /// Every reading with every value, in a fixed order.
            pub const ALL: &'static [Self] = &[$($(Self::$type($type::$variant)),*),*];

            /// `name=value`.
            #[must_use]
            pub fn as_str(self) -> &'static str {
                match self {
                    $($(Self::$type($type::$variant) => concat!(stringify!($field), "=", $text)),*),*
                }
            }
        }
    };
}

readings! {
    /// E100L-INCH-02: what inch input is rounded to when it becomes internal metric data.
    inch_conversion: InchConversion {
        /// To 0.001 mm.
        #[default] MetricIncrement "metric_increment",
        /// To 0.0001 inch.
        InchIncrement "inch_increment"
    }
    /// E100L-CIRC-08: the coordinate that an arc by centre does not command.
    arc_one_coordinate: ArcOneCoordinate {
        /// Where the circle meets the commanded coordinate inside the starting quadrant.
        #[default] Quadrant "quadrant",
        /// The coordinate of the start point.
        Start "start"
    }
    /// E100L-ANG-03: what L of an any-angle chamfer measures.
    chamfer_leg: ChamferLeg {
        /// The leg on either line.
        #[default] Leg "leg",
        /// The face of the chamfer.
        Face "face"
    }
    /// E100L-CHAM-13: where incremental words count from after a chamfer block.
    incremental_after_chamfer: IncrementalAfterChamfer {
        /// From the programmed corner.
        #[default] Corner "corner",
        /// From the end of the chamfer.
        End "end"
    }
    /// E100L-G01-04: the X travel on which the feed of an X-Z motion is measured.
    feed_length: FeedLength {
        /// The radius travel: F is the speed along the path.
        #[default] Radius "radius",
        /// The diameter travel, as in C-axis blocks.
        Diameter "diameter"
    }
    /// E100L-COORD-03: the sign of the tool offset.
    tool_offset: ToolOffsetSign {
        /// Machine coordinate = program coordinate + offsets + tool offset.
        #[default] Added "added",
        /// Machine coordinate = program coordinate + offsets - tool offset.
        Subtracted "subtracted"
    }
    /// E100L-BARR-08: what of a positioning the barriers watch.
    barrier_path: BarrierPath {
        /// The straight line to its end.
        #[default] Line "line",
        /// Its end alone.
        Ends "ends"
    }
    /// E100L-GPUT-07: the decimals with which PUT writes a dimensional system variable.
    put_real: PutReal {
        /// All decimals of the increment.
        #[default] Fixed "fixed",
        /// Without zeros at the end.
        Shortest "shortest"
    }
    /// E100L-VUACM-02: what a user alarm C does.
    user_alarm_c: UserAlarmC {
        /// It is displayed and the program goes on.
        #[default] Continues "continues",
        /// It stops the program.
        Stops "stops"
    }
    /// E100L-G33-05: which end of a tapered thread has the level that is programmed.
    taper_reference: TaperReference {
        /// That where the thread starts.
        #[default] Start "start",
        /// That where it ends.
        End "end"
    }
    /// E100L-G33-07: the sign of the shift of a thread's start.
    thread_shift: ThreadShift {
        /// Positive toward the end of the thread.
        #[default] TowardEnd "toward_end",
        /// That of the coordinate.
        Coordinate "coordinate"
    }
    /// E100L-TMOD-03: to which side M32 shifts the passes.
    thread_flank: ThreadFlank {
        /// To the negative side of the lead axis; M34 to the positive one.
        #[default] Negative "negative",
        /// To the positive side; M34 to the negative one.
        Positive "positive"
    }
    /// E100L-TINF-06, E100L-TINF-07: the infeed of M75 where the manual's formula does not serve.
    balanced_infeed: BalancedInfeed {
        /// It is refused.
        #[default] Refused "refused",
        /// Depths that take equal areas.
        EqualArea "equal_area"
    }
    /// E100L-GRV-04: what a retract amount on X measures.
    peck_retract: PeckRetract {
        /// The change of the diameter.
        #[default] Diameter "diameter",
        /// The way of the tool, half of it.
        Radius "radius"
    }
    /// E100L-G183-02: where a deep hole drill goes to discharge chips.
    chip_discharge: ChipDischarge {
        /// To where the cut began.
        #[default] CuttingStart "cutting_start",
        /// To where the cycle began.
        CycleStart "cycle_start"
    }
    /// E100L-G190-03: how high the tool returns between the passes of a key way with M211.
    keyway_return: KeywayReturn {
        /// To where the cut began.
        #[default] CuttingStart "cutting_start",
        /// By the retract amount.
        Relief "relief"
    }
    /// E100L-LAP-08: the feed of an element of a LAP contour without E.
    contour_feed: ContourFeed {
        /// The E of a contour before, and F of the call when there was none.
        #[default] Kept "kept",
        /// F of the call.
        Call "call"
    }
    /// E100L-SMAX-02: where the clamp of `G50 S` acts.
    speed_clamp: SpeedClamp {
        /// On every spindle speed.
        #[default] Always "always",
        /// In G96 only.
        CuttingSpeed "cutting_speed"
    }
}

/// The readings that an event depends on.
#[derive(Clone, Copy, PartialEq, Eq, Default)]
pub struct ReadingSet(u64);

impl ReadingSet {
    /// Whether no reading is named.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0 == 0
    }

    /// The set and one more reading.
    #[must_use]
    pub fn with(self, reading: impl Into<Reading>) -> Self {
        let reading = reading.into();
        let bit = Reading::ALL.iter().position(|each| *each == reading).unwrap_or_default();
        Self(self.0 | 1 << bit)
    }

    /// The union of two sets.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The readings, in a fixed order.
    pub fn iter(self) -> impl Iterator<Item = Reading> {
        Reading::ALL
            .iter()
            .enumerate()
            .filter(move |(bit, _)| self.0 & 1 << bit != 0)
            .map(|(_, reading)| *reading)
    }
}

impl fmt::Debug for ReadingSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_set().entries(self.iter().map(Reading::as_str)).finish()
    }
}

impl Serialize for ReadingSet {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter().map(Reading::as_str))
    }
}

impl<'de> Deserialize<'de> for ReadingSet {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut set = Self::default();
        for text in Vec::<String>::deserialize(deserializer)? {
            let reading = Reading::ALL.iter().find(|each| each.as_str() == text);
            set = set.with(*reading.ok_or_else(|| de::Error::custom(format!("unknown reading {text:?}")))?);
        }
        Ok(set)
    }
}

#[cfg(test)]
mod tests {
    use super::{Reading, ReadingSet};

    #[test]
    fn a_set_is_empty_until_something_is_in_it() {
        assert!(ReadingSet::default().is_empty());
        assert!(Reading::ALL.iter().all(|reading| !ReadingSet::default().with(*reading).is_empty()));
    }

    #[test]
    fn a_union_has_what_either_set_has() {
        let (first, last) = (Reading::ALL[0], Reading::ALL[Reading::ALL.len() - 1]);
        let (one, both) = (ReadingSet::default().with(first), ReadingSet::default().with(first).with(last));
        for (left, right) in [(one, both), (both, one), (both, both), (both, ReadingSet::default())] {
            assert_eq!(left.union(right).iter().collect::<Vec<_>>(), [first, last]);
        }
    }

    #[test]
    fn a_set_reads_back_and_shows_its_names() {
        let set = ReadingSet::default().with(Reading::ALL[0]);
        let json = serde_json::to_string(&set).unwrap_or_default();
        assert_eq!(json, format!("[\"{}\"]", Reading::ALL[0].as_str()));
        assert_eq!(serde_json::from_str::<ReadingSet>(&json).ok(), Some(set));
        assert!(format!("{set:?}").contains(Reading::ALL[0].as_str()));
    }
}

//! Tool interference data (E100L-SVAR-14): stores that only programs and the set-up fill.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::Setup;

/// What a variable of tool interference data holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Classification,
    Form,
    NoseAngle,
    EdgeAngle,
    Size,
    Pattern,
}

use Kind::{Classification, EdgeAngle, Form, NoseAngle, Pattern, Size};

/// The variables of tools, then those of tool groups.
const TABLE: [(&[u8], Kind); 19] = [
    (b"VTLIN", Classification),
    (b"VTLFN", Form),
    (b"VTLA1", NoseAngle),
    (b"VTLA2", EdgeAngle),
    (b"VTLL", Size),
    (b"VTLD", Size),
    (b"VTLW", Size),
    (b"VTIZN", Size),
    (b"VTIZP", Size),
    (b"VTIXN", Size),
    (b"VTIXP", Size),
    (b"VTIPN", Pattern),
    (b"VGRIN", Classification),
    (b"VGRFN", Form),
    (b"VGRA1", NoseAngle),
    (b"VGRA2", EdgeAngle),
    (b"VGRL", Size),
    (b"VGRD", Size),
    (b"VGRW", Size),
];

/// A variable of tool interference data, by its place in the table.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct ToolData(u8);

impl ToolData {
    /// The variable with a name.
    pub fn named(name: &[u8]) -> Option<Self> {
        (0_u8..).zip(TABLE).find(|(_, (other, _))| *other == name).map(|(place, _)| Self(place))
    }

    /// Its name.
    pub fn name(self) -> &'static [u8] {
        TABLE.get(usize::from(self.0)).map_or(b"", |(name, _)| name)
    }

    fn kind(self) -> Kind {
        TABLE.get(usize::from(self.0)).map_or(Size, |(_, kind)| *kind)
    }

    /// Whether it is a plain number.
    pub fn is_plain(self) -> bool {
        matches!(self.kind(), Classification | Form | Pattern)
    }

    /// Whether it is an angle.
    pub fn is_angle(self) -> bool {
        matches!(self.kind(), NoseAngle | EdgeAngle)
    }

    /// Its range in nanometres, micro-degrees or plain numbers.
    pub fn range(self) -> (i64, i64) {
        match self.kind() {
            Classification => (1, 38),
            Form => (0, 4),
            NoseAngle => (0, 360_000_000),
            EdgeAngle => (-360_000_000, 360_000_000),
            Size => (0, 9_999_999_000),
            Pattern => (0, 2),
        }
    }

    /// The largest suffix: the number of tools, or of tool groups.
    pub fn last(self, setup: &Setup) -> u8 {
        if self.name().starts_with(b"VGR") { setup.options.tool_groups } else { setup.options.tools }
    }
}

/// The data that are not zero from the beginning, by variable and suffix.
pub type ToolTable = BTreeMap<(ToolData, usize), i64>;

/// The data of a set-up.
pub fn table(setup: &Setup) -> ToolTable {
    let entry = |name: &str| {
        let (name, number) = name.strip_suffix(']')?.split_once('[')?;
        Some((ToolData::named(name.as_bytes())?, number.parse().ok()?))
    };
    let amounts = setup.system_variables.iter().filter_map(|(name, value)| {
        let (data, number) = entry(name)?;
        let unit = if data.is_plain() { 1_000_000 } else { 1 };
        Some(((data, number), value.0 / unit))
    });
    amounts.collect()
}

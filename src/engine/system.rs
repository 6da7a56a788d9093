//! The table of system variables (E100L-SVTAB-01), and the variables of inputs and outputs.

use turnspec_oracle::vocabulary::RuleId;
use turnspec_oracle::vocabulary::rule_ids::*;

use super::arithmetic::scale::TEN;
use super::communication::{input_exists, output_exists};
use super::tool_data::ToolData;

/// An axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum Axis {
    X,
    Z,
    C,
    W,
}

/// A modelled system variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SystemVariable {
    ZeroOffset(Axis),
    ZeroShift(Axis),
    ToolOffset(Axis),
    NoseRadius(Axis),
    PositiveLimit(Axis),
    NegativeLimit(Axis),
    Droop(Axis),
    /// Chuck and tailstock data: VCHKL VCHKD VCHKX VCHKZ VTSL VTSDA VTSDB VWKR.
    Barrier(u8),
    PitchError(Axis),
    Pitch(Axis),
    Commanded(Axis),
    Actual(Axis),
    ActiveOffset(Axis),
    OffsetNumber,
    ToolNumber,
    Restart,
    Pi,
    FullTurn,
    ToolData(ToolData),
    /// VDIN.
    Input,
    /// VDOUT.
    Output,
    /// VIRD.
    InputBit,
    /// VORD.
    OutputBit,
    /// VUACM.
    Comment,
}

/// What the table says about a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Lookup {
    Modelled(SystemVariable),
    /// VUNIT, whose coding the manual does not tell.
    Unspecified,
    NotModelled,
    Unknown,
}

/// Names in the table that have no data in a set-up, and the spellings that the table misprints.
const OTHERS: &str = " VZOFY VZSHY VTSOY VTOFY VINPY VTRTS VTLGN VTLSN VTLCN VTLST VTLCT VTLSA VTLCA \
    VTLOA VTLOB VTLOC VTLUS VTLNG VTLLF VGRSL VGRLF VGRID VXMP0 VXMPO VXMCD VXMON VXMTG VXMOG VXMXZ VXMNC \
    VXMCO VXMMC VXMMO VXMMD VXMDR VRNGZ VRNGX VSNZ VSNX VIMDZ VIMDX VPFVY VPFVT VTOAA VTOBA VTOCA VTOAB \
    VTOBB VTOCB VTHRZ VTHRX VLMON VEINT VBNCT VPWSP VPWTP VSIDC VEXPO VEXTR VEXAX VEXGF VEXTO VEXOG VEXOK \
    VEXFB VEXDR VSIOY VSKPZ VSKPY VSKPX VSKPC VETFY VDIFZ VDIFX VAPPZ VAPPX VMIRZ VCNGC VXMD5 VXMDS VTOPC \
    VCEJM VMCN VMDT VXMBD VXMAB VWKCS VWKCC VSKFA VSKFB VRZV VRCV VRRG VLZV VLYV VLRG VPLOF VRVY VRYV \
    VRBV VRVW VRWV VRVX VRXV VTLMT VMXA1 VMNA1 VMXA2 VMNA2 VCHIO VCHSW VZARP VZBRP VZCRP VXARP VXBRP VWAP \
    VSNWD VSNTU ";

/// The chuck and tailstock data, in the order of [`SystemVariable::Barrier`].
const BARRIERS: [&[u8]; 8] = [b"VCHKL", b"VCHKD", b"VCHKX", b"VCHKZ", b"VTSL", b"VTSDA", b"VTSDB", b"VWKR"];

/// Looks a name up.
pub fn lookup(name: &[u8], w_axis: bool) -> Lookup {
    use SystemVariable as V;
    let variable = match name {
        b"VUNIT" => return Lookup::Unspecified,
        b"VETON" => V::OffsetNumber,
        b"VETLN" => V::ToolNumber,
        b"VRSTT" => V::Restart,
        b"VPAI" => V::Pi,
        b"VRUND" => V::FullTurn,
        b"VDIN" => V::Input,
        b"VDOUT" => V::Output,
        b"VIRD" => V::InputBit,
        b"VORD" => V::OutputBit,
        b"VUACM" => V::Comment,
        _ => {
            if let Some(place) = (0_u8..).zip(BARRIERS).find(|(_, barrier)| *barrier == name) {
                V::Barrier(place.0)
            } else if let Some(variable) = by_axis(name) {
                if variable.axis() == Some(Axis::W) && !w_axis {
                    return Lookup::NotModelled;
                }
                variable
            } else if let Some(data) = ToolData::named(name) {
                V::ToolData(data)
            } else {
                let listed = !name.contains(&b' ') && OTHERS.split(' ').any(|other| other.as_bytes() == name);
                return if listed { Lookup::NotModelled } else { Lookup::Unknown };
            }
        }
    };
    Lookup::Modelled(variable)
}

/// A name that ends in its axis.
fn by_axis(name: &[u8]) -> Option<SystemVariable> {
    use SystemVariable as V;
    let (last, stem) = name.split_last()?;
    let axis = match last {
        b'X' => Axis::X,
        b'Z' => Axis::Z,
        b'C' => Axis::C,
        b'W' => Axis::W,
        _ => return None,
    };
    let in_plane = matches!(axis, Axis::X | Axis::Z);
    match stem {
        b"VZOF" => Some(V::ZeroOffset(axis)),
        b"VZSH" => Some(V::ZeroShift(axis)),
        b"VTOF" if in_plane => Some(V::ToolOffset(axis)),
        b"VNSR" if in_plane => Some(V::NoseRadius(axis)),
        b"VPVL" if axis != Axis::C => Some(V::PositiveLimit(axis)),
        b"VNVL" if axis != Axis::C => Some(V::NegativeLimit(axis)),
        b"VINP" if axis != Axis::W => Some(V::Droop(axis)),
        b"VPFV" if in_plane => Some(V::PitchError(axis)),
        b"VPCH" if in_plane => Some(V::Pitch(axis)),
        b"VSIO" if axis != Axis::W => Some(V::Commanded(axis)),
        b"VAPA" if in_plane => Some(V::Actual(axis)),
        b"VETF" if in_plane => Some(V::ActiveOffset(axis)),
        _ => None,
    }
}

impl SystemVariable {
    fn axis(self) -> Option<Axis> {
        match self {
            Self::ZeroOffset(axis)
            | Self::ZeroShift(axis)
            | Self::ToolOffset(axis)
            | Self::NoseRadius(axis)
            | Self::PositiveLimit(axis)
            | Self::NegativeLimit(axis)
            | Self::Droop(axis)
            | Self::PitchError(axis)
            | Self::Pitch(axis)
            | Self::Commanded(axis)
            | Self::Actual(axis)
            | Self::ActiveOffset(axis) => Some(axis),
            _ => None,
        }
    }

    /// Why programs may not assign it, if they may not.
    pub fn read_only(self) -> Option<RuleId> {
        match self {
            Self::Commanded(_)
            | Self::Actual(_)
            | Self::ActiveOffset(_)
            | Self::OffsetNumber
            | Self::ToolNumber
            | Self::Restart
            | Self::Pi
            | Self::FullTurn => Some(SVTAB_01),
            Self::Input => Some(IOV_01),
            Self::InputBit | Self::OutputBit => Some(IORD_01),
            _ => None,
        }
    }

    /// The rule of its suffix.
    pub fn suffix_rule(self) -> RuleId {
        match self {
            Self::Input => IOV_01,
            Self::Output => IOV_02,
            Self::InputBit | Self::OutputBit => IORD_01,
            Self::Comment => VUACM_01,
            _ => SVTAB_01,
        }
    }

    /// The rule that demands User Task 2, if one does.
    /// VIRD and VORD belong to User Task 1 (E100L-UT-02).
    pub fn level_rule(self) -> Option<RuleId> {
        match self {
            Self::Input => Some(IOV_01),
            Self::Output => Some(IOV_02),
            _ => None,
        }
    }

    /// Whether it takes a suffix.
    pub fn has_suffix(self) -> bool {
        matches!(
            self,
            Self::ToolOffset(_)
                | Self::NoseRadius(_)
                | Self::PitchError(_)
                | Self::ToolData(_)
                | Self::Input
                | Self::Output
                | Self::InputBit
                | Self::OutputBit
                | Self::Comment
        )
    }

    /// Whether there is an input or output of this number; of other variables the range decides.
    pub fn has_number(self, number: usize) -> bool {
        match self {
            Self::Input => input_exists(number),
            Self::Output => output_exists(number),
            _ => true,
        }
    }

    /// Whether it is an angle.
    pub fn is_angle(self) -> bool {
        match self {
            Self::ToolData(data) => data.is_angle(),
            Self::Droop(_) => false,
            _ => self.axis() == Some(Axis::C),
        }
    }

    /// Whether it is a plain number, not a length or an angle.
    pub fn is_plain(self) -> bool {
        match self {
            Self::ToolData(data) => data.is_plain(),
            _ => matches!(self, Self::Droop(_)),
        }
    }

    /// Its range in nanometres (micro-degrees, or plain numbers for the droop).
    pub fn range(self, inch: bool) -> (i64, i64) {
        const WIDE: i64 = 99_999_999 * TEN[3];
        const SIZE: i64 = 9_999_999 * TEN[3];
        match self {
            Self::ToolOffset(_) | Self::NoseRadius(_) => (-999_999_000, 999_999_000),
            Self::Droop(_) => (0, if inch { 10_000 } else { 1000 }),
            // Sizes, and the three positions among them.
            Self::Barrier(2 | 3 | 7) => (-SIZE, SIZE),
            Self::Barrier(_) => (0, SIZE),
            Self::PitchError(_) => (-999_000, 999_000),
            Self::Pitch(_) => (2_000_000, 65_000_000),
            Self::ToolData(data) => data.range(),
            _ => (-WIDE, WIDE),
        }
    }

    /// Its name.
    pub fn name(self) -> ([u8; 5], usize) {
        let stem: &[u8] = match self {
            Self::ZeroOffset(_) => b"VZOF",
            Self::ZeroShift(_) => b"VZSH",
            Self::ToolOffset(_) => b"VTOF",
            Self::NoseRadius(_) => b"VNSR",
            Self::PositiveLimit(_) => b"VPVL",
            Self::NegativeLimit(_) => b"VNVL",
            Self::Droop(_) => b"VINP",
            Self::PitchError(_) => b"VPFV",
            Self::Pitch(_) => b"VPCH",
            Self::Commanded(_) => b"VSIO",
            Self::Actual(_) => b"VAPA",
            Self::ActiveOffset(_) => b"VETF",
            Self::Barrier(number) => BARRIERS.get(usize::from(number)).copied().unwrap_or_default(),
            Self::OffsetNumber => b"VETON",
            Self::ToolNumber => b"VETLN",
            Self::Restart => b"VRSTT",
            Self::Pi => b"VPAI",
            Self::FullTurn => b"VRUND",
            Self::ToolData(data) => data.name(),
            Self::Input => b"VDIN",
            Self::Output => b"VDOUT",
            Self::InputBit => b"VIRD",
            Self::OutputBit => b"VORD",
            Self::Comment => b"VUACM",
        };
        let mut name = [0; 5];
        let mut length = 0;
        let axis = self.axis().map(|axis| b"XZCW"[axis as usize]);
        for byte in stem.iter().copied().chain(axis).take(5) {
            name[length] = byte;
            length += 1;
        }
        (name, length)
    }
}

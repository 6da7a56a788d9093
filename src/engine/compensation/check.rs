//! What is checked of plane and compensation before a block is carried out (execution, check 6).

use turnspec_oracle::vocabulary::AlarmName;
use turnspec_oracle::vocabulary::rule_ids as rules;

use crate::engine::Interpreter;
use crate::engine::block::OneShot;
use crate::engine::codes::GGroup;
use crate::engine::contour;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Words};

use super::waiting::undefined;

/// What the words of a block do to compensation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Change {
    /// Nothing, or they change the side.
    None,
    /// They begin it.
    Begins,
    /// They end it.
    Ends,
}

impl Change {
    /// How an alarm names it.
    pub fn detail(self) -> &'static str {
        if self == Self::Begins { "start_up" } else { "cancel" }
    }
}

const SHIFTS: u64 = Address::set(&[Address::X, Address::Z, Address::C, Address::W]);
const IMAGINARY: u64 = Address::set(&[Address::I, Address::K]);

impl Interpreter<'_> {
    /// What the words of a block do to compensation.
    pub(in crate::engine) fn compensation_change(&self, words: &Words) -> Change {
        match (words.code_of(GGroup::Compensation), self.state.compensation) {
            (Some(41 | 42), 40) => Change::Begins,
            (Some(40), 41 | 42) => Change::Ends,
            _ => Change::None,
        }
    }

    /// Check 6, of a block with a motion mode.
    pub(in crate::engine) fn check_compensation(
        &self,
        words: &Words,
        one_shot: OneShot,
        (motion, moves, change): (u16, bool, Change),
        left_over: bool,
    ) -> Result<(), Fault> {
        let compensation = words.code_of(GGroup::Compensation);
        let plane = words.code_of(GGroup::Plane);
        let before = self.state.compensation;
        if compensation.is_none() && plane.is_none() && before == 40 && !left_over {
            return Ok(());
        }
        self.check_plane(plane, change)?;
        self.check_cutter(words, (one_shot, change), (motion, moves), left_over)?;
        if change != Change::None {
            check_change(words, one_shot, motion, change, self.cutter_plane(words).is_some())?;
        }
        let compensating = before != 40;
        let compensated = compensation.unwrap_or(before) != 40;
        match one_shot {
            OneShot::ZeroShift if compensated && words.has_any(SHIFTS) => {
                Fault::raise(AlarmName::CompensationNotAllowed, rules::NRC_81)
            }
            OneShot::Dwell | OneShot::TorqueOff | OneShot::TorqueLimit | OneShot::ZeroShift
                if change == Change::Begins =>
            {
                Err(undefined(rules::NRC_20, "start_up"))
            }
            OneShot::TorqueSkip if compensating || compensated || left_over => {
                Err(undefined(rules::NRC_81, "G22"))
            }
            _ => Ok(()),
        }
    }

    /// The plane word.
    fn check_plane(&self, plane: Option<u16>, change: Change) -> Result<(), Fault> {
        if matches!(plane, Some(17 | 119)) && !self.state.c_joined {
            return Fault::raise(AlarmName::CAxisNotJoined, rules::CRC_02);
        }
        let same = planted::is(Bug::SamePlane) && plane == Some(self.state.plane);
        if plane.is_some() && self.state.compensation != 40 && change != Change::Ends && !same {
            return Fault::raise(AlarmName::PlaneChangeInCompensation, rules::CRC_13);
        }
        Ok(())
    }
}

/// A block that begins or ends compensation: its motion mode, and its imaginary point.
/// `of_cutter`: in G17 or G119.
fn check_change(
    words: &Words,
    one_shot: OneShot,
    motion: u16,
    change: Change,
    of_cutter: bool,
) -> Result<(), Fault> {
    let begins = change == Change::Begins;
    if of_cutter && contour::is_mode(motion) && motion != 101 {
        return Err(undefined(rules::CRC_14, change.detail()));
    }
    if motion >= 2 && motion != 101 {
        let rule = if begins { rules::NRC_19 } else { rules::NRC_72 };
        return Fault::raise(AlarmName::CompensationNotLinear, rule);
    }
    let zero = [Address::I, Address::K].iter().all(|address| words.get(*address).unwrap_or_default() == 0);
    if one_shot == OneShot::None && words.has_any(IMAGINARY) && zero {
        let rule = if begins { rules::NRC_24 } else { rules::NRC_70 };
        return Fault::raise(AlarmName::CompensationImaginaryPoint, rule);
    }
    Ok(())
}

//! What is checked of contours and coordinate conversion: before a block is carried out (execution of contours, 3), and
//! of the machine before its motion (5 and 6).

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Label, RuleId};

use crate::engine::Interpreter;
use crate::engine::block::OneShot;
use crate::engine::codes::{self, GGroup};
use crate::engine::compensation::Change;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::words::{Address, Words};

use super::{NO_CODE, POINT, is_face_mode, unspecified};

/// The first code of a block that conversion mode leaves undescribed (E100L-CSC-09).
fn undescribed(words: &Words) -> Option<u16> {
    words.g_codes().iter().copied().find(|code| match code {
        0 | 1 | 101..=103 => false,
        71 | 72 | 75 | 76 => true,
        code => codes::g_group(*code) == Some(GGroup::Motion),
    })
}

/// What is not described, about a G code.
#[cold]
fn about_code<T>(rule: RuleId, code: u16) -> Result<T, Fault> {
    Err(Fault::about(AlarmName::Unspecified, rule, Label::of_code(b'G', code)))
}

impl Interpreter<'_> {
    /// Check 2a, of a block in conversion mode or without a motion code; `needs_code`: it moves, or begins or ends
    /// compensation.
    pub(in crate::engine) fn check_conversion(
        &self,
        words: &Words,
        (one_shot, motion): (OneShot, u16),
        needs_code: bool,
    ) -> Result<(), Fault> {
        if self.awaits_point() && words.has_g(91) {
            return Fault::raise(AlarmName::ConversionIncremental, rules::CSC_08);
        }
        if motion == NO_CODE && needs_code {
            return Fault::raise(AlarmName::MotionCodeMissing, rules::CSC_05);
        }
        if !self.state.contour.converts() {
            return Ok(());
        }
        if let Some(code) = undescribed(words) {
            return about_code(rules::CSC_09, code);
        }
        if one_shot == OneShot::ZeroShift && words.has_any(Address::set(&[Address::X, Address::C])) {
            return Err(unspecified(rules::CSC_09, "G50"));
        }
        if one_shot != OneShot::None || !words.has_any(POINT) {
            return Ok(());
        }
        if motion == 1 {
            return Err(unspecified(rules::CSC_09, "G01"));
        }
        self.check_first_point(words)
    }

    /// Whether conversion mode has not had a point yet.
    fn awaits_point(&self) -> bool {
        self.state.contour.conversion.is_some_and(|conversion| conversion.kept.is_none())
    }

    /// The last row of check 2a: the first point has both coordinates (E100L-CSC-06).
    pub(in crate::engine) fn check_first_point(&self, words: &Words) -> Result<(), Fault> {
        if self.awaits_point() && words.has(Address::X) != words.has(Address::Y) {
            return Fault::raise(AlarmName::ConversionAxisMissing, rules::CSC_06);
        }
        Ok(())
    }

    /// Check 3 of G137.
    pub(in crate::engine) fn check_conversion_start(&self, words: &Words) -> Result<(), Fault> {
        if !words.has(Address::C) {
            return Fault::raise(AlarmName::WordMissing, rules::CSC_01);
        }
        if let Some(code) = words.code_of(GGroup::Motion) {
            return about_code(rules::CSC_05, code);
        }
        let incremental = words.code_of(GGroup::Dimension).map_or(self.state.incremental, |code| code == 91);
        if incremental {
            return Fault::raise(AlarmName::ConversionIncremental, rules::CSC_07);
        }
        Ok(())
    }

    /// Check 4 of a contour block.
    pub(in crate::engine) fn check_contour(&self, words: &Words, motion: u16) -> Result<(), Fault> {
        if matches!(motion, 102 | 103) && words.has(Address::Z) {
            return Fault::raise(AlarmName::ContourArcZ, rules::CGF_05);
        }
        let face = is_face_mode(motion);
        if motion != 101 {
            let rule = if face { rules::CGF_04 } else { rules::CGS_04 };
            match words.get(Address::L) {
                None => return Fault::raise(AlarmName::WordMissing, rule),
                Some(..=0) => return Fault::raise(AlarmName::ArcRadiusNotPositive, rule),
                Some(_) => {}
            }
        }
        let per_minute = words.code_of(GGroup::FeedUnit).map_or(self.state.per_minute, |code| code == 94);
        if !per_minute {
            let rule = if face { rules::CGF_02 } else { rules::CGS_01 };
            return Err(unspecified(rule, "G95"));
        }
        Ok(())
    }

    /// Check 6 of a block in a contour mode or in conversion mode, or with G136 or G137.
    pub(in crate::engine) fn check_contour_compensation(
        &self,
        words: &Words,
        (one_shot, change): (OneShot, Change),
        (motion, contour_block): (u16, bool),
        left_over: bool,
    ) -> Result<(), Fault> {
        let plane = words.code_of(GGroup::Plane).unwrap_or(self.state.plane);
        let before = self.state.compensation != 40;
        let after = words.code_of(GGroup::Compensation).map_or(before, |code| code != 40);
        let of_side = matches!(words.code_of(GGroup::Motion), Some(132 | 133))
            || contour_block && !is_face_mode(motion);
        let tested = if planted::is(Bug::PlaneBeforeBlock) { self.state.plane } else { plane };
        if of_side && self.setup.parameters.side_contour_mode && tested != 119 {
            return Fault::raise(AlarmName::ContourCommandUnusable, rules::CGS_08);
        }
        if one_shot == OneShot::BeginConversion && after {
            return Fault::raise(AlarmName::CompensationNotAllowed, rules::NRC_81);
        }
        if one_shot.is_conversion() {
            return if before || left_over {
                Err(unspecified(rules::CSC_09, "compensation"))
            } else {
                Ok(())
            };
        }
        if self.state.contour.converts() && after && !before && plane != 17 {
            return Err(unspecified(rules::CSC_09, "compensation"));
        }
        let concerned = contour_block || motion == 101 && change != Change::None;
        // Compensation that was in force acts in its plane, whatever plane the block selects behind it.
        let turning = if before { self.state.plane == 18 } else { after && plane == 18 };
        if concerned && (turning || left_over) {
            return about_code(if is_face_mode(motion) { rules::CRC_06 } else { rules::CRC_07 }, motion);
        }
        Ok(())
    }

    /// The C axis is joined and released.
    pub(in crate::engine) fn check_c_axis(&self, joined: RuleId, released: RuleId) -> Result<(), Fault> {
        if !self.state.c_joined {
            return Fault::raise(AlarmName::CAxisNotJoined, joined);
        }
        if self.state.c_clamped {
            return Fault::raise(AlarmName::CAxisClamped, released);
        }
        Ok(())
    }

    /// No barrier watches the block.
    pub(in crate::engine) fn check_no_barrier(&self, rule: RuleId) -> Result<(), Fault> {
        if self.state.watch.acts() {
            return Err(Fault::about(AlarmName::NotModelled, rule, const { Label::new("barrier") }));
        }
        Ok(())
    }
}

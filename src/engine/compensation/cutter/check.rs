//! What is checked of cutter compensation before a block is carried out (execution of contours, 9, check 6), and at M109.

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, Label};

use crate::engine::Interpreter;
use crate::engine::block::OneShot;
use crate::engine::codes::GGroup;
use crate::engine::compensation::Change;
use crate::engine::compensation::waiting::undefined;
use crate::engine::contour;
use crate::engine::fault::Fault;
use crate::engine::words::{Address, Words};

use super::Plane;

impl Interpreter<'_> {
    /// The plane of cutter compensation that was or is in force in a block.
    pub(in crate::engine) fn cutter_plane(&self, words: &Words) -> Option<Plane> {
        let before = self.state.compensation;
        let after = words.code_of(GGroup::Compensation).unwrap_or(before);
        let selected = words.code_of(GGroup::Plane).filter(|_| before == 40);
        match selected.unwrap_or(self.state.plane) {
            _ if before == 40 && after == 40 => None,
            17 => Some(Plane::Face),
            119 => Some(Plane::Side { inner: self.is_seen_from_inside() }),
            _ => None,
        }
    }

    /// The rows of check 6 about G41 and G42 in G17 and G119, of a block that moves or not.
    pub(in crate::engine::compensation) fn check_cutter(
        &self,
        words: &Words,
        (one_shot, change): (OneShot, Change),
        (motion, moves): (u16, bool),
        left_over: bool,
    ) -> Result<(), Fault> {
        let Some(plane) = self.cutter_plane(words) else { return Ok(()) };
        if let Some(code @ (41 | 42)) = words.code_of(GGroup::Compensation) {
            if self.lap.is_active() {
                let detail = Label::of_code(b'G', code);
                return Err(Fault::about(AlarmName::Unspecified, rules::LAP_16, detail));
            }
            if !matches!(self.state.compensation, before if before == 40 || before == code) {
                return Err(undefined(rules::CRC_12, "side"));
            }
        }
        let moves = moves && (one_shot == OneShot::None || one_shot.is_chamfer());
        if moves {
            check_motion(words, plane, motion)?;
        }
        if change != Change::None && one_shot != OneShot::TorqueSkip {
            let in_plane = moves && plane.is_moved_by(words, self.state.contour.converts());
            if !in_plane || change == Change::Begins && left_over {
                return Err(undefined(rules::CRC_14, change.detail()));
            }
        }
        Ok(())
    }

    /// M109, when its turn comes: not where a cutter was or is compensated.
    #[cold]
    pub(in crate::engine) fn check_separation(&self) -> Result<(), Fault> {
        let begins = self.state.compensation != 40 && self.state.plane != 18;
        if self.compensation.cutter.is_some() || begins {
            return Err(undefined(rules::CRC_14, "M109"));
        }
        Ok(())
    }
}

/// The motion mode of a motion block, and words that the planes of rotary tools leave undescribed.
fn check_motion(words: &Words, plane: Plane, motion: u16) -> Result<(), Fault> {
    let (fits, rule) = match plane {
        Plane::Face => (motion < 2 || contour::is_face_mode(motion), rules::CRC_06),
        Plane::Side { .. } => (motion < 2 || matches!(motion, 132 | 133), rules::CRC_07),
    };
    if !fits {
        return Err(Fault::about(AlarmName::Unspecified, rule, Label::of_code(b'G', motion)));
    }
    let found = [
        (words.has(Address::A), "A"),
        (words.has(Address::QA), "QA"),
        (words.has_g(75), "G75"),
        (words.has_g(76), "G76"),
    ];
    match found.iter().find(|(has, _)| *has) {
        Some((_, what)) => Err(undefined(rules::CRC_14, what)),
        None => Ok(()),
    }
}

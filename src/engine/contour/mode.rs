//! G136 and G137 as modal codes (execution of contours, step 1; E100L-CSC-01, E100L-CSC-05, E100L-CSC-10,
//! E100L-CGS-07).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, Angle, Label, RuleSet, Sink};

use crate::engine::Interpreter;
use crate::engine::arithmetic::turn;
use crate::engine::fault::Fault;
use crate::engine::planted::{self, Bug};
use crate::engine::state::{X, Z};
use crate::engine::words::{Address, Words};

use super::{Conversion, NO_CODE};

impl Interpreter<'_> {
    /// Carries out G136 or G137.
    pub(in crate::engine) fn change_conversion(
        &mut self,
        code: u16,
        words: &Words,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        if code == 137 {
            return self.begin_conversion(words.get(Address::C).unwrap_or_default(), sink);
        }
        let group = const { Label::new("conversion") };
        if self.state.contour.conversion.take().is_some() {
            self.emit_mode(sink, group, 136, 137, const { RuleSet::of(&[GCODE_02, CSC_01, CSC_09]) });
        }
        if self.state.plane == 119 {
            self.state.plane = 18;
            let group = const { Label::new("plane") };
            self.emit_mode(sink, group, 18, 119, const { RuleSet::of(&[CGS_07]) });
        }
        Ok(())
    }

    /// G137: the motion code is cancelled.
    fn begin_conversion(&mut self, angle: i64, sink: &mut impl Sink) -> Result<(), Fault> {
        if self.stands_at_limit(X) || self.stands_at_limit(Z) {
            return Fault::raise(AlarmName::ConversionAtLimit, CSC_10);
        }
        let present = self.state.contour.conversion.map(|conversion| conversion.angle);
        let angle = match present.filter(|_| planted::is(Bug::DirectionKept)) {
            Some(present) => present,
            None => turn::within(angle),
        };
        let before = self.state.contour.conversion.replace(Conversion { angle, kept: None });
        if before.is_none() || !planted::is(Bug::CodeKept) {
            self.state.motion = NO_CODE;
            self.state.thread.select_motion(NO_CODE);
        }
        let action = Action::Mode {
            group: const { Label::new("conversion") },
            code: Label::of_code(b'G', 137),
            previous: Label::of_code(b'G', if before.is_some() { 137 } else { 136 }),
            angle: Some(Angle(angle)),
        };
        self.emit(sink, const { RuleSet::of(&[GCODE_02, CSC_01]) }, action);
        Ok(())
    }

    /// Whether the machine stands at a travel limit of an axis, or beyond it.
    fn stands_at_limit(&self, axis: usize) -> bool {
        let place = self.state.machine[axis];
        let machine = if axis == X { self.state.machine_x(place) } else { place };
        self.state.positive_limits[axis]
            .is_some_and(|limit| machine >= limit && !planted::is(Bug::AtLimitAllowed))
            || self.state.negative_limits[axis].is_some_and(|limit| machine <= limit)
    }
}

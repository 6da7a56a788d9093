//! Short main programs that change the state every time they run, by what is known.

use turnspec_oracle::vocabulary::Feature;

use super::main_program::Effect;
use crate::builder::Builder;
use crate::expression::Variable;
use crate::io::AREA;
use crate::number::Number;
use crate::program::Line;
use crate::state::{Axis, Mode};
use crate::unit::Written;

/// A short main program.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Short {
    /// An incremental motion.
    Step,
    /// A zero shift.
    Shift,
    /// A variable that counts.
    Count,
    /// Characters for a later WRITE.
    Send,
    /// A local variable.
    Local,
    /// A mode of the speed.
    Speed,
    /// Part of a comment.
    Comment,
    /// Nothing but the end.
    Nothing,
}

impl Short {
    const ALL: [Self; 8] = [
        Self::Step,
        Self::Shift,
        Self::Count,
        Self::Send,
        Self::Local,
        Self::Speed,
        Self::Comment,
        Self::Nothing,
    ];

    fn lines(self) -> &'static [&'static str] {
        match self {
            Self::Step => &["G91 G00 X1 Z-1", "M02"],
            Self::Shift => &["G50 X5 Z0", "M30"],
            Self::Count => &["V1=V1+1", "/M30", "M02"],
            Self::Send => &["PUT ,2", "PUT $4142", "M02"],
            Self::Local => &["LC=5", "N1 M30 M08"],
            Self::Speed => &["G96 S100 M08", "M02"],
            Self::Comment => &["VUACM[3]='AB'", "M02"],
            Self::Nothing => &["(SPARE)", "M02"],
        }
    }
}

impl Builder<'_, '_, '_> {
    /// A short main program that fits the set-up.
    pub(super) fn short_program(&mut self) -> (Effect, Vec<Line>) {
        let mut short = self.choices.pick(&Short::ALL);
        let eia = self.state.is_eia();
        if eia && matches!(short, Short::Count | Short::Send | Short::Local | Short::Comment) {
            short = Short::Step;
        }
        if self.state.setup.options.user_task == 1 && matches!(short, Short::Send) {
            short = Short::Shift;
        }
        let lines = short.lines().iter().map(|line| Line::Raw(line.as_bytes().to_vec())).collect();
        (Effect::Short(short), lines)
    }

    /// Whether a short program may run so often from here.
    pub(super) fn bears(&self, short: Short, times: i64) -> bool {
        let unit = self.state.units.length_unit();
        match short {
            Short::Step => [(Axis::X, unit), (Axis::Z, -unit)]
                .iter()
                .all(|(axis, way)| self.state.fits(*axis, self.state.program(*axis) + way * times)),
            Short::Send => self.state.io.written + 4 * usize::try_from(times).unwrap_or(AREA) <= AREA,
            Short::Count => self.allows(Feature::Variable),
            Short::Speed => self.state.turrets.has_own_reference(),
            _ => true,
        }
    }

    /// The state after a short program.
    pub(super) fn after_short(&mut self, short: Short, times: i64) {
        let unit = self.state.units.length_unit();
        match short {
            Short::Step => {
                self.state.incremental = true;
                self.state.mode = Mode::Rapid;
                self.state.after_cutting = false;
                for (axis, way) in [(Axis::X, unit), (Axis::Z, -unit)] {
                    let target = self.state.program(axis) + way * times;
                    self.state.move_to(axis, target);
                }
            }
            Short::Shift => {
                for (axis, wanted) in [(Axis::X, 5), (Axis::Z, 0)] {
                    let value = self.state.units.length(Written::Plain(Number::whole(wanted)));
                    self.state.shift[axis as usize] += self.state.program(axis) - value;
                }
            }
            Short::Count if !self.state.setup.switches.block_delete || times > 0 => {
                let present = self.state.common.get(&1).copied().unwrap_or_default();
                let counted = present + times as f64;
                if self.state.environment.unknown.contains(&1) {
                    self.forget(&Variable::Common(1));
                } else {
                    self.state.common.insert(1, counted);
                }
            }
            Short::Send => self.state.io.written += 4 * usize::try_from(times).unwrap_or_default(),
            Short::Local => self.state.control.assign_local("LC", 5.0),
            Short::Speed => self.state.cutting_speed = true,
            _ => {}
        }
    }
}

//! The barriers in radius compensation: they are tested on the path of the programmed point (E100L-BARR-09).

use crate::engine::Interpreter;
use crate::engine::arithmetic::limit::Limited;
use crate::engine::fault::Fault;
use crate::engine::motion::Element;
use crate::engine::state::{Amounts, X, Z};

use super::{Compensation, Phase};

impl Compensation {
    /// Whether the barriers are among the own tests of a motion, before what waits ends; else they are tested
    /// behind its limits.
    pub(super) fn barriers_come_first(&self) -> bool {
        matches!(self.phase, Phase::Starting | Phase::On | Phase::Ending)
    }
}

impl Interpreter<'_> {
    /// The barriers as the last of the own tests of a motion to a machine position of the programmed point.
    pub(super) fn check_barriers_first(&self, element: &mut Element, end: Amounts) -> Result<(), Fault> {
        let acts = self.state.watch.acts() && element.moves_plane();
        if !acts || !self.compensation.barriers_come_first() {
            return Ok(());
        }
        // In compensation a limit cuts nothing back (E100L-NRC-80).
        let ends = self.compensation.phase == Phase::Ending;
        let end = if ends { self.cut_back(end) } else { end };
        self.check_barriers(element.kind, &end, &mut element.cites, &mut element.readings)
    }

    /// Where a line ends whose positive limits act later, in G40 again.
    fn cut_back(&self, mut end: Amounts) -> Amounts {
        for axis in [X, Z] {
            if let Limited::AbovePositive(limit) = self.state.limited(axis, end[axis]) {
                end[axis] = limit;
            }
        }
        end
    }
}

//! Chuck and tailstock barriers: which motions are tested, and the test of one (execution, chapter 5, Barriers;
//! E100L-BARR-01, E100L-BARR-04, E100L-BARR-07 to E100L-BARR-09).

mod arc;
mod watch;

pub use watch::Watch;

use turnspec_oracle::vocabulary::rule_ids as rules;
use turnspec_oracle::vocabulary::{AlarmName, BarrierPath, Label, ReadingSet};

use super::Interpreter;
use super::arithmetic::plane::Point;
use super::arithmetic::rectangle::Rectangle;
use super::arithmetic::{area, segment};
use super::cite::{self, Cites};
use super::fault::Fault;
use super::motion::Kind;
use super::planted::{self, Bug};
use super::state::{Amounts, X, Z};
use arc::Sweep;

/// What of a motion is tested.
enum Path {
    /// The straight segment between two points, both included; they may be the same.
    Line(Point, Point),
    /// An arc and its commanded end.
    Arc(Sweep),
}

impl Path {
    /// What of a motion of a kind from one point to another is tested (E100L-BARR-08, E100L-BARR-09).
    fn of(kind: Kind, from: Point, to: Point, positioning: BarrierPath) -> Self {
        match kind {
            Kind::Rapid if positioning == BarrierPath::Ends || planted::is(Bug::EndsAlone) => {
                Self::Line(to, to)
            }
            Kind::Arc { .. } if planted::is(Bug::ChordOfArc) => Self::Line(from, to),
            Kind::Rapid | Kind::Linear | Kind::LinearAt(_) => Self::Line(from, to),
            Kind::Arc { sense, centre_x, centre_z } => {
                Self::Arc(Sweep { from, to, centre: Point { x: centre_x, z: centre_z }, sense })
            }
        }
    }

    /// Whether it has a point in one of some open rectangles.
    fn enters(&self, area: &[Option<Rectangle>]) -> bool {
        let edge = i64::from(planted::is(Bug::ClosedArea));
        area.iter().flatten().any(|Rectangle { z, x }| {
            let [z, x] = [z, x].map(|(low, high)| (low - edge, high + edge));
            match self {
                Self::Line(from, to) => segment::enters(*from, *to, &Rectangle { z, x }),
                Self::Arc(sweep) => sweep.enters(&Rectangle { z, x }),
            }
        })
    }
}

impl Interpreter<'_> {
    /// Tests a motion in X or Z from the present point to a machine position against the barriers that watch
    /// the block, the chuck first; the rules and the reading of a motion that was tested (E100L-BARR-01).
    #[cold]
    pub(super) fn check_barriers(
        &self,
        kind: Kind,
        end: &Amounts,
        cites: &mut Cites,
        readings: &mut ReadingSet,
    ) -> Result<(), Fault> {
        let [x, z] = match planted::is(Bug::MachineEnd) {
            true => [end[X], end[Z]],
            false => [X, Z].map(|axis| self.state.to_program(axis, end[axis])),
        };
        let path = Path::of(kind, self.present(), Point { x, z }, self.setup.readings.barrier_path);
        let (machine, variables) = (&self.setup.barriers, &self.state.barriers);
        let chuck = self.state.watch.chuck() && path.enters(&area::chuck(machine, variables));
        if chuck && !planted::is(Bug::TailstockFirst) {
            return Err(refusal("chuck"));
        }
        if self.state.watch.tailstock() && path.enters(&area::tailstock(machine, variables)) {
            return Err(refusal("tailstock"));
        }
        if chuck {
            return Err(refusal("chuck"));
        }
        *cites = cites.and(cite::BARR_01);
        if kind == Kind::Rapid {
            *cites = cites.and(cite::BARR_08);
            *readings = readings.union(self.known.barrier_path);
        }
        Ok(())
    }
}

#[cold]
fn refusal(barrier: &str) -> Fault {
    Fault::about(AlarmName::Barrier, rules::BARR_01, Label::new(barrier))
}

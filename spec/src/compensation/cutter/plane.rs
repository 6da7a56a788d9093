//! Where the axes go for a point of the plane (E100L-CRC-14).

use crate::contour::{Cylinder, Direction, End, PlanePoint};
use crate::controls::e100l::units;
use crate::fault::{Fault, Outcome, fail};
use crate::frame::{Amounts, TravelLimit};
use crate::integer::turn;
use crate::modal::CutterPlane;
use crate::state::State;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Angle, FacePoint, Length, Motion, Place, PlanePosition, Position, Setup};

use super::super::ending::within_limit;
use super::programmed::Programmed;

/// Where the cutter is.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// Its centre in the plane.
    pub point: PlanePoint,
    /// C, turns counted since compensation began; on the side alone.
    pub unwrapped: i64,
    /// The axes of the machine; Z on the face and X on the side are those of P.
    pub machine: Amounts,
}

impl Standing {
    /// Writes where the cutter is into a motion that tells P.
    pub fn show(&self, plane: CutterPlane, motion: &mut Motion) {
        let (program, machine) = (motion.program, motion.machine);
        let (x, z) = match plane {
            CutterPlane::Face => (self.machine.x, machine.z.0),
            CutterPlane::Side => (machine.x.0, self.machine.z),
        };
        let c_of = |position: Position| position.c.map_or(0, |c| c.0);
        let c = turn::within(c_of(program) + self.machine.c - c_of(machine));
        let tip = |program: Length, machine: Length, axis: i64| Length(program.0 + axis - machine.0);
        motion.tip = Some(PlanePosition { x: tip(program.x, machine.x, x), z: tip(program.z, machine.z, z) });
        motion.tip_c = Some(Angle(c));
        if plane == CutterPlane::Face {
            motion.face_tip = Some(FacePoint { x: Length(self.point.p), y: Length(self.point.q) });
        }
        motion.machine.x = Length(x);
        motion.machine.z = Length(z);
        motion.machine.c = machine.c.map(|_| Angle(self.machine.c));
    }
}

/// P at the end of a motion, and what was in force in its block.
#[derive(Clone, Debug)]
pub struct Spot {
    /// The block.
    pub place: Place,
    /// P in the plane.
    pub point: PlanePoint,
    /// C of P, turns counted since compensation began.
    unwrapped: i64,
    /// P in program coordinates.
    pub program: Amounts,
    /// P in machine coordinates.
    pub machine: Amounts,
    /// The limits of X and Z.
    limits: (TravelLimit, TravelLimit),
    lies: Lies,
}

/// How the plane lies to the axes.
#[derive(Clone, Copy, Debug)]
enum Lies {
    Face(Direction),
    Side(Cylinder),
}

impl Spot {
    /// The present point, which P has reached.
    pub fn present(programmed: &Programmed, converts: bool, place: Place, state: &State) -> Self {
        let lies = match programmed.plane {
            CutterPlane::Side => Lies::Side(Cylinder::present(state)),
            CutterPlane::Face if converts => Lies::Face(Direction::of_conversion(state)),
            CutterPlane::Face => Lies::Face(Direction::ZERO),
        };
        Self {
            place,
            point: programmed.point.unwrap_or_default(),
            unwrapped: programmed.unwrapped(),
            program: state.frame.program(),
            machine: state.frame.machine,
            limits: (state.limits.x, state.limits.z),
            lies,
        }
    }

    /// The plane.
    pub fn plane(&self) -> CutterPlane {
        match self.lies {
            Lies::Face(_) => CutterPlane::Face,
            Lies::Side(_) => CutterPlane::Side,
        }
    }

    /// The axes with the cutter centre in a point.
    pub fn at(&self, point: PlanePoint) -> Outcome<Standing> {
        if point == self.point {
            return Ok(Standing { point, unwrapped: self.unwrapped, machine: self.machine });
        }
        match self.lies {
            Lies::Face(_) if point == PlanePoint::CENTRE => {
                Err(Fault::about(AlarmName::Unspecified, CRC_14, "centre"))
            }
            Lies::Face(direction) => {
                let (x, c) = direction.axes(point);
                Ok(self.on_face(point, x, c))
            }
            Lies::Side(cylinder) => {
                let aside = cylinder.turn(self.point, point);
                let place = Amounts { z: point.q, c: self.program.c.saturating_add(aside), ..self.program };
                let unwrapped = self.unwrapped.saturating_add(aside);
                Ok(Standing { point, unwrapped, machine: self.machine_of(place) })
            }
        }
    }

    /// The axes in a point of the face with this program X and C.
    pub fn on_face(&self, point: PlanePoint, x: i64, c: i64) -> Standing {
        let place = Amounts { x, c, ..self.program };
        Standing { point, unwrapped: 0, machine: self.machine_of(place) }
    }

    /// Where the cutter is on the face, with program X and C.
    pub fn face_end(&self, standing: &Standing) -> End {
        let x = standing.machine.x - self.machine.x + self.program.x;
        let c = turn::within(standing.machine.c - self.machine.c + self.program.c);
        End::of_point(standing.point, (x, c))
    }

    fn machine_of(&self, program: Amounts) -> Amounts {
        self.machine.plus(program.plus(self.program, -1), 1).turned()
    }

    /// E100L-CRC-17, E100L-NRC-29: X and Z within the range of their addresses, however acute a corner is.
    pub fn check_range(&self, to: &Standing, setup: &Setup) -> Outcome<()> {
        let largest = units::largest_length(setup.unit_system).unsigned_abs();
        let x = to.machine.x - self.machine.x + self.program.x;
        let z = to.machine.z - self.machine.z + self.program.z;
        if x.unsigned_abs() > largest || z.unsigned_abs() > largest {
            return fail(AlarmName::CoordinateRange, ADDR_01);
        }
        Ok(())
    }

    /// E100L-NRC-80, on the side of Z alone.
    pub fn check_limits(&self, to: &Standing) -> Outcome<()> {
        if self.plane() == CutterPlane::Face {
            within_limit(self.limits.0, to.machine.x)?;
        }
        within_limit(self.limits.1, to.machine.z)
    }
}

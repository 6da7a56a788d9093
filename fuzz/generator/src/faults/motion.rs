//! Faults of geometry: arcs that do not close, corners that do not fit, coordinates beyond the limits.

use turnspec_oracle::vocabulary::{ArcOneCoordinate, Chamfering};

use super::Fault;
use crate::builder::Builder;
use crate::program::Item;
use crate::state::Axis;

const MM: i64 = 1_000_000;

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn motion_fault(&mut self, fault: Fault) -> bool {
        match fault {
            Fault::ArcRadiusTooSmall => {
                let sense = self.choices.within(2, 3);
                self.travel(&[sense], &[("X", 50 * MM), ("Z", 30 * MM), ("L", 5 * MM)])
            }
            Fault::ArcRadiusMismatch => {
                let sense = self.choices.within(2, 3);
                let x = self.choices.within(10, 90) * MM;
                self.travel(&[sense], &[("X", x), ("Z", 7 * MM), ("I", -50 * MM), ("K", 3 * MM)])
            }
            Fault::ArcNoEndPoint => self.no_end_point(),
            Fault::CoordinateRange => self.coordinate_range(),
            Fault::TravelLimitNegative | Fault::TravelLimitPositive => self.beyond_limit(fault),
            Fault::AngleNoIntersection => self.no_intersection(),
            _ => self.corner_fault(fault),
        }
    }

    /// A block of G91 with these G codes, lengths in nanometres, and F.
    pub(super) fn travel(&mut self, codes: &[i64], lengths: &[(&'static str, i64)]) -> bool {
        let mut items = vec![Item::g(91)];
        items.extend(codes.iter().map(|code| Item::g(*code)));
        for (address, length) in lengths {
            items.push(self.plain_length(address, *length).0);
        }
        items.push(Item::whole("F", 1));
        self.state.incremental = true;
        self.push(items);
        true
    }

    fn no_end_point(&mut self) -> bool {
        if self.state.setup.readings.arc_one_coordinate != ArcOneCoordinate::Quadrant {
            return false;
        }
        let sense = self.choices.within(2, 3);
        // The circle of radius 10 mm about a point beside the start does not reach 60 mm; and 1 mm against
        // the sense of the arc is not in the commanded direction.
        let (x, z) = if self.choices.chance(50) { (0, 60 * MM) } else { (60 * MM, 0) };
        let coordinate = if x == 0 { ("Z", z) } else { ("X", x) };
        self.travel(&[sense], &[coordinate, ("I", -8 * MM), ("K", -6 * MM)])
    }

    fn coordinate_range(&mut self) -> bool {
        let axis = if self.choices.chance(50) { Axis::X } else { Axis::Z };
        let mode = self.choices.within(0, 1);
        let sign = if self.state.program(axis) < 0 { -1 } else { 1 };
        let most = if self.state.units.system.is_inch() { 250_000 * MM } else { 99_999_999_000 };
        self.travel(&[mode], &[(axis.address(), sign * most)]);
        self.travel(&[mode], &[(axis.address(), sign * most)])
    }

    /// A limit close to the present position, and a motion beyond it.
    fn beyond_limit(&mut self, fault: Fault) -> bool {
        if self.state.is_eia() {
            return false;
        }
        let axis = if self.choices.chance(50) { Axis::X } else { Axis::Z };
        let index = axis as usize;
        let positive = fault == Fault::TravelLimitPositive;
        let name = match (positive, axis) {
            (true, Axis::X) => "VPVLX",
            (true, _) => "VPVLZ",
            (false, Axis::X) => "VNVLX",
            (false, _) => "VNVLZ",
        };
        let limit = self.state.machine[index] / 1_000 + if positive { 3_000 } else { -3_000 };
        let number = self.state.units.write_length(limit * 1_000);
        self.raw(format!("{name}={}", number.text()).as_bytes());
        if positive {
            let way = [("X", self.state.sign(Axis::X) * 20 * MM), ("Z", 20 * MM), ("L", 80 * MM)];
            let sense = self.choices.within(2, 3);
            return self.travel(&[sense], &way);
        }
        let mode = self.choices.within(0, 1);
        self.travel(&[mode], &[(axis.address(), self.state.sign(axis) * -20 * MM)])
    }

    fn no_intersection(&mut self) -> bool {
        let turn = self.choices.pick(&[0, 180, -180, 360]) * MM;
        let any_angle = self.state.setup.parameters.chamfering == Chamfering::AnyAngle;
        if any_angle && self.choices.chance(30) {
            let angle = self.state.units.write_angle(10 * MM);
            let parallel = self.state.units.write_angle(10 * MM + turn);
            self.push(vec![Item::g(1), Item::plain("A", angle), Item::whole("F", 1)]);
            let (x, z) = (self.plain_length("X", 15 * MM).0, self.plain_length("Z", 25 * MM).0);
            self.push(vec![x, z, Item::plain("A", parallel)]);
            return true;
        }
        let mode = self.choices.within(0, 1);
        let (address, angle) = if self.choices.chance(50) { ("X", turn) } else { ("Z", turn + 90 * MM) };
        let angle = self.state.units.write_angle(angle);
        let coordinate = self.plain_length(address, 5 * MM).0;
        self.push(vec![Item::g(mode), coordinate, Item::plain("A", angle), Item::whole("F", 1)]);
        true
    }

    fn corner_fault(&mut self, fault: Fault) -> bool {
        let code = self.choices.within(75, 76);
        let chamfering = self.state.setup.parameters.chamfering;
        let any_angle = chamfering == Chamfering::AnyAngle;
        match fault {
            Fault::ChamferDisabled if chamfering == Chamfering::Off => {
                self.travel(&[1, code], &[("X", 50 * MM), ("L", MM)])
            }
            Fault::ChamferAxes if any_angle => self.travel(&[1, code], &[("L", MM)]),
            Fault::ChamferAxes if chamfering == Chamfering::Basic => {
                let second = if self.choices.chance(50) { ("Z", 9 * MM) } else { ("A", 9 * MM) };
                let travel = if self.choices.chance(30) { 0 } else { 50 * MM };
                self.travel(&[1, code], &[("X", travel), second, ("L", MM)])
            }
            Fault::ChamferTooShort if chamfering != Chamfering::Off => {
                self.travel(&[1, code], &[("X", 10 * MM), ("L", 30 * MM)]);
                self.travel(&[1], &[("X", 10 * MM), ("Z", 20 * MM)])
            }
            Fault::ChamferCorner if any_angle => {
                self.travel(&[1, code], &[("X", 50 * MM), ("L", MM)]);
                let mode = self.choices.pick(&[0, 2, 3]);
                let mut way = vec![("X", 9 * MM), ("Z", 9 * MM)];
                if mode > 0 && self.choices.chance(70) {
                    way.push(("L", 50 * MM));
                }
                self.travel(&[mode], &way)
            }
            Fault::AngleUnderdetermined if !any_angle => {
                let mode = self.choices.within(0, 1);
                self.blocks(&[&format!("G0{mode} A30 F1")])
            }
            Fault::AngleLookahead if any_angle => self.blind_corner(code),
            Fault::WordMissing if chamfering != Chamfering::Off && self.choices.chance(40) => {
                let length = if self.choices.chance(50) {
                    vec![("X", 50 * MM)]
                } else {
                    vec![("X", 50 * MM), ("L", 0)]
                };
                self.travel(&[1, code], &length)
            }
            _ => false,
        }
    }

    /// A block that needs the next one, and a next one that does not help.
    fn blind_corner(&mut self, code: i64) -> bool {
        if self.choices.chance(50) {
            self.blocks(&["G01 A30 F1"]);
        } else {
            self.travel(&[1, code], &[("X", 50 * MM), ("L", MM)]);
        }
        let text = self.choices.pick(&[
            "M08",
            "G04 F1",
            "T0101 X5 Z9",
            "S100",
            "G50 X1",
            "G01 X5 Z9 K2",
            "V1=5 X5 Z5",
        ]);
        self.blocks(&[text])
    }
}

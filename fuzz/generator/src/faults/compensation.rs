//! Faults of radius compensation and of the plane.

use super::Fault;
use crate::builder::Builder;
use crate::compensation::Side;
use crate::program::Item;
use crate::state::Axis;

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn compensation_fault(&mut self, fault: Fault) -> bool {
        let on = self.state.compensation.is_on();
        let joined = self.state.joined;
        match fault {
            Fault::CompensationNotLinear => self.outside_lines(),
            Fault::CompensationStartUp => self.without_element(),
            Fault::CompensationImaginaryPoint => {
                if self.choices.chance(40) {
                    self.in_force("");
                }
                let list: &[&str] = if self.state.compensation.is_on() {
                    &["G40 G01 K0 F1", "G00 G40 X5 I0 K0", "G01 G40 I=0 F1"]
                } else {
                    &["G18 G42 G01 X5 K0 F1", "G41 G00 I0", "G00 G42 Z5 I0 K0"]
                };
                self.one_of(list)
            }
            Fault::CompensationNoIntersection => self.apart(),
            Fault::CompensationArcTooSmall => self.narrow_arc(),
            Fault::CompensationNotAllowed => {
                let list: &[&str] = if on {
                    &["G50 X5", "G50 Z5 S100", "G50 C1", "G50 X1 G41"]
                } else {
                    &["G00 G42 G50 X0", "G00 G50 Z1 S5 G41"]
                };
                self.one_of(list)
            }
            Fault::PlaneChangeInCompensation => {
                if !on {
                    self.in_force("");
                }
                let list: &[&str] =
                    if joined { &["G17", "G18", "G119 X5"] } else { &["G18", "G18 G01 X1 F1"] };
                self.one_of(list)
            }
            Fault::TravelLimitNegative | Fault::TravelLimitPositive
                if self.has_noses() && self.choices.chance(75) =>
            {
                self.tip_beyond_limit()
            }
            Fault::CAxisNotJoined if !joined && self.choices.chance(40) => {
                self.one_of(&["G17", "G119", "G17 G42 X5", "G40 G17"])
            }
            Fault::Unspecified if self.choices.chance(55) => self.not_described(),
            _ => false,
        }
    }

    pub(super) fn one_of(&mut self, list: &[&str]) -> bool {
        let text = self.choices.pick(list);
        self.blocks(&text.split('\n').collect::<Vec<_>>())
    }

    /// A start-up and an element, in G91, with more words in the start-up block.
    pub(super) fn in_force(&mut self, words: &str) {
        if self.state.compensation.left_over || !self.state.compensation.is_on() {
            let side = self.choices.pick(&[41, 42]);
            let first = format!("G18 G{side} G91 G01 F1 X2 {words}");
            self.blocks(&[first.trim_end(), "Z-5"]);
            self.state.incremental = true;
            self.state.compensation.side = if side == 41 { Side::Left } else { Side::Right };
        }
    }

    /// A beginning or an end in G02 or G03, the code written or in force; a rounding as long as its line.
    fn outside_lines(&mut self) -> bool {
        if self.choices.chance(40) {
            self.in_force("");
        }
        let list: &[&str] = match self.state.compensation.is_on() {
            true => &["G40 G02 X5 Z5 L50 F1", "G03 G40", "G02 G40 G04 F1", "G91 G03 X6 Z3 L9 F1\nG40"],
            false => &["G18 G42 G02 X5 Z5 L50 F1", "G03 G41", "G91 G02 X6 Z3 L9 F1\nG41 X1"],
        };
        self.one_of(list)
    }

    /// A start-up with no element behind it: a repeated point, two blocks without motion.
    fn without_element(&mut self) -> bool {
        if self.state.compensation.is_on() {
            self.blocks(&["G40 G00 G91 Z1"]);
        }
        let side = self.choices.pick(&["G41", "G42"]);
        let motion = self.choices.pick(&["G91 G01 X2 F1", "G00 G91", "G91 G00 Z-3", "G01 F1 G91 Z2 K5"]);
        self.blocks(&[&format!("G18 {side} {motion}")]);
        self.one_of(&["X0", "Z0 X0", "M08\nZ0", "M08\nS5", "G04 F1\nM09", "G90\nG41\nG91", "M65\nG50 S100"])
    }

    /// Whether the set-up has noses and tools may select them.
    fn has_noses(&self) -> bool {
        !self.state.setup.nose_radius.is_empty() && self.state.setup.options.nose_radius_compensation
    }

    /// The code of a nose that has a radius, where there is one.
    fn some_nose(&mut self) -> Option<Item> {
        let radius = self.state.compensation.radius();
        (radius == 0).then(|| self.nose_word()).flatten()
    }

    /// An element with a nose in force; false when there is none.
    fn with_nose(&mut self) -> bool {
        if !self.state.compensation.is_on() {
            self.state.compensation.left_over = false;
            self.in_force("");
        }
        if let Some(nose) = self.some_nose() {
            self.push(vec![nose]);
        }
        self.state.compensation.radius() > 0
    }

    /// Elements of which the second lies apart from the first: a side change on an arc that goes straight on, an
    /// arc of which the nose does not come out.
    fn apart(&mut self) -> bool {
        if !self.with_nose() {
            return false;
        }
        let finest = self.state.units.finest();
        let inside = self.state.compensation.side == Side::Right;
        let sense = if inside { 2 } else { 3 };
        let (sign, other) = if inside { (1, 41) } else { (-1, 42) };
        let large = 10_000 * finest;
        self.travel(&[1], &[("Z", -large)]);
        if self.choices.chance(50) {
            return self
                .travel(&[sense, other], &[("X", sign * 2 * large), ("Z", -large), ("I", sign * large)]);
        }
        let radius = self.state.compensation.radius() * self.choices.within(11, 19) / 10;
        self.travel(&[sense], &[("X", sign * 2 * radius), ("Z", -radius), ("I", sign * radius)]);
        self.travel(&[1], &[("Z", -large)])
    }

    /// An inside arc that the nose does not fit into.
    fn narrow_arc(&mut self) -> bool {
        if !self.with_nose() {
            return false;
        }
        let sense = if self.state.compensation.side == Side::Right { 2 } else { 3 };
        let radius = self.state.compensation.radius() - self.choices.within(1, 4) * self.state.units.finest();
        self.travel(&[1], &[("Z", -10_000 * self.state.units.finest())]);
        self.travel(&[sense], &[("X", 2 * radius), ("Z", -radius), ("L", radius)])
    }

    /// A limit along Z between the programmed point and the tip at the end of a line.
    fn tip_beyond_limit(&mut self) -> bool {
        if self.state.is_eia() || !self.with_nose() {
            return false;
        }
        if self.state.compensation.tip_aside() == 0
            && let Some(nose) = self.nose_word()
        {
            self.push(vec![nose]);
        }
        let tip = self.state.compensation.tip_aside();
        if tip == 0 {
            return false;
        }
        let (name, direction) = if tip < 0 { ("VNVLZ", -1) } else { ("VPVLZ", 1) };
        let leg = 5_000 * self.state.units.finest();
        let limit = self.state.machine[Axis::Z as usize] + 2 * direction * leg + tip / 2;
        let number = self.state.units.write_length(limit);
        self.blocks(&[&format!("{name}={}", number.text())]);
        (0..3).all(|_| self.travel(&[1], &[("Z", direction * leg)]))
    }

    /// What the manual says nothing of.
    fn not_described(&mut self) -> bool {
        let forced = self.choices.chance(50) && self.with_nose();
        if !forced && !self.state.compensation.is_on() {
            return self.one_of(&[
                "G18 G42 G91 G01 X2 F1\nG40",
                "G18 G41 G00\nG40 Z5",
                "G18 G41 G00 G91 X1\nM02",
                "G18 G42 G00 G04 F1",
                "G00 G41 G28",
                "G00 G41 G50 S100",
                "G18 G42 G01 G04 F1",
                "G00 G42 G22 Z5 D1 L1 F1 PZ=5",
            ]);
        }
        self.one_of(&[
            "G40 G00\nG91 G02 X6 Z3 L9 F1",
            "G40\nG91 G03 X6 Z3 L9 F1",
            "G40 G01\nM08\nS5\nG02 X5 Z5 L90",
            "G40 G01 F1\nM08\nG03 X5 Z5 L90",
            "G22 Z5 D1 L1 F1 PZ=5",
            "G40 G01 G22 Z5 D1 L1 F1 PZ=5",
            "G40 G00\nG91 G22 Z5 D1 L1 F1 PZ=5",
        ])
    }
}

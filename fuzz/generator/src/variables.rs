//! Assignments to common variables and to the system variables of frame, tools, limits and stores.

use turnspec_oracle::vocabulary::{Feature, Length};

use crate::builder::Builder;
use crate::expression::{Expression, Variable};
use crate::number::Number;
use crate::program::{Item, Value};
use crate::state::Axis;
use crate::unit::{Estimate, Written};
use crate::words::expression_length;

/// Stores of lengths without effect on motion, with the highest value in 0.001 mm; those of the second list
/// may be negative.
const SIZES: &[&str] = &["VCHKL", "VCHKD", "VTSL", "VTSDA", "VTSDB"];
const PLACES: &[&str] = &["VCHKX", "VCHKZ", "VWKR"];

impl Builder<'_, '_, '_> {
    /// A block with one or two assignments, sometimes with words behind them.
    pub(crate) fn assignment(&mut self) {
        let changing = self.allows(Feature::Variable) || self.allows(Feature::LocalVariable);
        if self.state.is_eia() || self.state.control.steady && !changing {
            return self.auxiliary();
        }
        let mut items = Vec::new();
        for _ in 0..=self.choices.below(2) {
            if self.state.control.steady {
                items.push(self.changing_assignment());
                self.state.begin_block();
                continue;
            }
            let common = self.choices.chance(55) && self.allows(Feature::Variable);
            let item =
                if common || !self.allows(Feature::SystemVariable) { self.common() } else { self.system() };
            items.push(item);
            self.state.begin_block();
        }
        if self.choices.chance(15) {
            self.companions(&mut items);
        }
        self.push(items);
    }

    /// An assignment to a common variable.
    pub(crate) fn common(&mut self) -> Item {
        let number =
            if self.choices.chance(70) { self.choices.within(1, 9) } else { self.choices.within(1, 200) };
        let number = u8::try_from(number).unwrap_or(1);
        let depth = 1 + self.choices.below(4);
        let mut expression = Expression::grow(self.choices, &self.state.environment, depth);
        let mut value = expression.estimate(&self.state.environment);
        let too_long = expression_length(&expression) > 70;
        let too_large = value.is_none_or(|value| value.to_f64().abs() > 1e12);
        if too_long || too_large {
            let constant = self.choices.within(-99_999, 99_999);
            expression = Expression::Constant(Number::decimal(constant, 2).with_point());
            value = expression.estimate(&self.state.environment);
        }
        let value = value.map_or(0.0, Estimate::to_f64);
        self.state.common.insert(number, value);
        self.state.control.now_known(number);
        Item::Assignment(Variable::Common(number), expression)
    }

    /// An assignment to a system variable.
    pub(crate) fn system(&mut self) -> Item {
        let w = self.state.setup.options.w_axis;
        let axis = self.choices.pick(&[Axis::X, Axis::Z, if w { Axis::W } else { Axis::X }]);
        match self.choices.below(10) {
            0 | 1 => self.frame_variable(axis),
            2 | 3 => self.tool_offset_variable(),
            4 => self.limit_variable(axis),
            5 => {
                let most = if self.state.units.system.is_inch() { 10_000 } else { 1_000 };
                let number = Number::whole(self.choices.within(0, most));
                let target = self.choices.pick(&["VINPX", "VINPZ", "VINPC"]);
                self.assign(Variable::System(target), number).0
            }
            6 | 7 if self.state.barriers.is_wanted() => self.barrier_variable(),
            6 => {
                let target = self.choices.pick(SIZES);
                self.assign_length(Variable::System(target), 0, 9_999_999).0
            }
            7 => {
                let target = self.choices.pick(PLACES);
                self.assign_length(Variable::System(target), -9_999_999, 9_999_999).0
            }
            8 => {
                let suffix = self.choices.within(1, 120);
                let target = self.choices.pick(&["VPFVX", "VPFVZ"]);
                let variable =
                    Variable::Indexed(target, Box::new(Expression::Constant(Number::whole(suffix))));
                self.assign_length(variable, -999, 999).0
            }
            _ => {
                let target = self.choices.pick(&["VPCHX", "VPCHZ"]);
                self.assign_length(Variable::System(target), 2_100, 64_900).0
            }
        }
    }

    /// VZOFX … or VZSHX …, changed a little.
    fn frame_variable(&mut self, axis: Axis) -> Item {
        let offset = self.choices.chance(50);
        if self.choices.chance(10) {
            let name = if offset { "VZOFC" } else { "VZSHC" };
            let wanted = self.choices.within(-180, 360) * 1_000_000;
            let number = self.state.units.write_angle(wanted);
            let (item, written) = self.assign(Variable::System(name), number);
            let angle = self.state.units.angle(written);
            *(if offset { &mut self.state.c_offset } else { &mut self.state.c_shift }) = angle;
            return item;
        }
        let names = if offset { ["VZOFX", "VZOFZ", "VZOFW"] } else { ["VZSHX", "VZSHZ", "VZSHW"] };
        let index = axis as usize;
        let present = if offset { self.state.zero_offset[index] } else { self.state.shift[index] };
        let near = present / 1_000 + self.choices.within(-20_000, 20_000);
        let (item, value) = self.assign_length(Variable::System(names[index]), near, near);
        if offset {
            self.state.zero_offset[index] = value;
        } else {
            self.state.shift[index] = value;
        }
        item
    }

    fn tool_offset_variable(&mut self) -> Item {
        let number = self.choices.within(1, self.state.setup.options.offset_sets.into());
        let number = if self.choices.chance(70) { number % 4 + 1 } else { number };
        let suffix = Box::new(Expression::Constant(Number::whole(number)));
        let axis = self.choices.below(2);
        if self.choices.chance(25) {
            let name = ["VNSRX", "VNSRZ"][axis];
            return self.nose_variable(number, axis, Variable::Indexed(name, suffix));
        }
        let name = ["VTOFX", "VTOFZ"][axis];
        let (item, value) = self.assign_length(Variable::Indexed(name, suffix), -50_000, 50_000);
        let number = u8::try_from(number).unwrap_or(1);
        self.state.tool_offsets.entry(number).or_default()[axis] = value;
        item
    }

    /// A component of a nose, usually a small one.
    fn nose_variable(&mut self, number: i64, axis: usize, variable: Variable) -> Item {
        let most = self.choices.pick(&[2_000, 2_000, 20_000]);
        let (item, value) = self.assign_length(variable, -most, most);
        let number = u8::try_from(number).unwrap_or(1);
        self.state.compensation.radii.entry(number).or_default()[axis] = value;
        item
    }

    /// A travel limit that leaves room around the present position.
    fn limit_variable(&mut self, axis: Axis) -> Item {
        let index = axis as usize;
        let positive = self.choices.chance(50);
        let names = if positive { ["VPVLX", "VPVLZ", "VPVLW"] } else { ["VNVLX", "VNVLZ", "VNVLW"] };
        let away = self.choices.within(60_000, 400_000);
        let limit = self.state.machine[index] / 1_000 + if positive { away } else { -away };
        let (item, value) = self.assign_length(Variable::System(names[index]), limit, limit);
        if positive {
            self.state.limits[index].positive = Some(Length(value));
        } else {
            self.state.limits[index].negative = Some(Length(value));
        }
        item
    }

    /// An assignment of a length between bounds in 0.001 mm; the length that is stored, in nanometres.
    pub(crate) fn assign_length(&mut self, variable: Variable, low: i64, high: i64) -> (Item, i64) {
        let wanted = self.choices.within(low, high) * 1_000;
        let (item, written) = self.assign(variable, self.state.units.write_length(wanted));
        (item, self.state.units.assigned_length(written))
    }

    fn assign(&mut self, variable: Variable, number: Number) -> (Item, Written) {
        let (value, written) = self.value(number);
        match value {
            Value::Expression(expression) => (Item::Assignment(variable, expression), written),
            Value::Plain(number) => (Item::Assignment(variable, Expression::Constant(number)), written),
        }
    }
}

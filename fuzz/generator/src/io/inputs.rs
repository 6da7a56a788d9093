//! Input variables VDIN, VIRD and VORD: what they will show, and blocks that read them.

use std::collections::{BTreeMap, BTreeSet};

use turnspec_oracle::vocabulary::{Feature, Setup};

use crate::builder::Builder;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::Value;
use crate::program::{Condition, Item, Word};

/// An input: its variable and its number.
pub(crate) type Input = (&'static str, u16);

/// Inputs that programs read whether the set-up has values for them or not.
const ALWAYS: &[Input] = &[
    ("VDIN", 1),
    ("VDIN", 8),
    ("VDIN", 9),
    ("VDIN", 10),
    ("VDIN", 19),
    ("VDIN", 24),
    ("VDIN", 39),
    ("VDIN", 1000),
    ("VDIN", 1004),
    ("VDIN", 1235),
    ("VDIN", 1250),
    ("VIRD", 0),
    ("VIRD", 1234),
    ("VORD", 9999),
];

/// What the inputs show, and how often each was read.
#[derive(Clone, Default, Debug)]
pub(super) struct Inputs {
    lists: BTreeMap<Input, Vec<i32>>,
    taken: BTreeMap<Input, usize>,
    /// Inputs that were read in what runs more than once.
    doubtful: BTreeSet<Input>,
}

impl Inputs {
    pub fn new(setup: &Setup) -> Self {
        let inputs = &setup.inputs;
        let mut lists: BTreeMap<Input, Vec<i32>> =
            inputs.vdin.iter().map(|(number, list)| (("VDIN", *number), list.clone())).collect();
        for (name, bits) in [("VIRD", &inputs.vird), ("VORD", &inputs.vord)] {
            let of = |(number, list): (&u16, &Vec<u8>)| {
                ((name, *number), list.iter().copied().map(i32::from).collect())
            };
            lists.extend(bits.iter().map(of));
        }
        Self { lists, ..Self::default() }
    }

    /// The inputs that always show the same, with what they show.
    pub fn constant(&self, level_2: bool) -> Vec<(&'static str, u16, i32)> {
        let inputs = self.lists.keys().chain(ALWAYS).filter(|(name, _)| level_2 || *name != "VDIN");
        inputs.filter_map(|input| self.constant_of(*input).map(|value| (input.0, input.1, value))).collect()
    }

    fn constant_of(&self, input: Input) -> Option<i32> {
        let of =
            |list: &Vec<i32>| list.first().filter(|first| list.iter().all(|value| value == *first)).copied();
        parts(input).try_fold(0, |sum, (part, weight)| {
            Some(sum + weight * self.lists.get(&part).map_or(Some(0), of)?)
        })
    }

    /// Reads an input; none when it is not known what it shows.
    pub fn read(&mut self, input: Input) -> Option<i32> {
        let mut sum = Some(0_i32);
        for (part, weight) in parts(input) {
            let taken = self.taken.entry(part).or_default();
            let shown = self.lists.get(&part).map_or(Some(&0), |list| list.get(*taken).or(list.last()));
            let shown = shown.filter(|_| !self.doubtful.contains(&part));
            *taken += 1;
            sum = sum.zip(shown).map(|(sum, shown)| sum.saturating_add(weight * shown));
        }
        sum
    }

    /// Reads an input nobody knows how often.
    fn read_often(&mut self, input: Input) {
        self.doubtful.extend(parts(input).map(|(part, _)| part));
    }
}

/// The inputs of which an input is made (E100L-IOV-03), with their weights: the bits of a byte, or itself.
fn parts((name, number): Input) -> impl Iterator<Item = (Input, i32)> {
    let byte = name == "VDIN" && matches!(number, 9 | 19 | 39);
    let (first, count) = if byte { (number - 8, 8) } else { (number, 1) };
    (0..count).map(move |bit| ((name, first + bit), 1_i32 << bit))
}

impl Builder<'_, '_, '_> {
    /// An input, often one with values in the set-up.
    fn some_input(&mut self) -> Input {
        let known: Vec<Input> = self.state.io.inputs.lists.keys().copied().collect();
        let input = if known.is_empty() || self.choices.chance(25) {
            self.choices.pick(ALWAYS)
        } else {
            self.choices.pick(&known)
        };
        // The byte of a bit.
        match input {
            ("VDIN", number @ (1..=8 | 11..=18 | 31..=38)) if self.choices.chance(25) => {
                ("VDIN", number / 10 * 10 + 9)
            }
            input => input,
        }
    }

    /// The value of an input in an expression.
    fn input_operand(&mut self, (name, number): Input) -> Expression {
        let (suffix, _) = self.suffix(number.into());
        Expression::Variable(Variable::Indexed(name, suffix))
    }

    /// An assignment of an input, of two of them, or a dwell of its length.
    pub(super) fn input(&mut self) {
        self.begin();
        let item = self.input_assignment();
        let mut items = vec![item];
        self.state.begin_block();
        if self.choices.chance(20) && !self.state.control.steady && self.allows(Feature::Dwell) {
            let operand = self.input_operand(("VDIN", 10));
            self.state.io.inputs.read(("VDIN", 10));
            let one = Expression::Constant(Number::whole(1));
            let value = Value::Expression(Expression::binary(Operator::Add, operand, one));
            items.extend([Item::g(4), Item::Word(Word { address: "F", value })]);
        }
        self.push(items);
    }

    /// An assignment of an input to a common variable.
    pub(crate) fn input_assignment(&mut self) -> Item {
        let input = self.some_input();
        let operand = self.input_operand(input);
        if self.state.control.steady {
            self.state.io.inputs.read_often(input);
            let number = self.choices.within(101, 120) as u8;
            self.forget(&Variable::Common(number));
            return Item::Assignment(Variable::Common(number), operand);
        }
        let shown = self.state.io.inputs.read(input);
        let (operator, constant) = self.choices.pick(&[
            (Operator::Add, 1),
            (Operator::Multiply, 2),
            (Operator::Subtract, 7),
            (Operator::Add, 0),
        ]);
        let real = self.choices.chance(50) || shown.is_none_or(|shown| shown > 1_000_000);
        let constant = Number::whole(constant);
        let constant = Expression::Constant(if real { constant.with_point() } else { constant });
        let bare = self.choices.chance(40);
        let of =
            |operand| if bare { operand } else { Expression::binary(operator, operand, constant.clone()) };
        let value = shown.and_then(|shown| {
            of(Expression::Constant(Number::whole(shown.into()))).estimate(&self.state.environment)
        });
        let number = self.choices.within(1, 9) as u8;
        match value {
            Some(value) => {
                self.state.common.insert(number, value.to_f64());
                self.state.control.now_known(number);
            }
            None => self.forget(&Variable::Common(number)),
        }
        Item::Assignment(Variable::Common(number), of(operand))
    }

    /// IF with an input whose value is known.
    pub(super) fn question(&mut self) {
        self.begin();
        let input = self.some_input();
        let operand = self.input_operand(input);
        let Some(shown) = self.state.io.inputs.read(input) else {
            return self.auxiliary();
        };
        let border = self.choices.pick(&[0, 1, 1, 5]);
        let operator = self.choices.pick(&Operator::COMPARISON);
        let holds = match operator {
            Operator::Lt => shown < border,
            Operator::Le => shown <= border,
            Operator::Eq => shown == border,
            Operator::Ne => shown != border,
            Operator::Gt => shown > border,
            _ => shown >= border,
        };
        let border = Expression::Constant(Number::whole(border.into()));
        self.branch(Condition::Holds(Expression::binary(operator, operand, border)), holds);
    }
}

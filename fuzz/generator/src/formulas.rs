//! Expressions alone: an expression with the values of its variables, without a program around it.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_oracle::vocabulary::{Setup, TapeCode};

use crate::choices::Choices;
use crate::environment::Environment;
use crate::expression::{Expression, Variable};
use crate::print::{self, Style};
use crate::profile::Profile;
use crate::program::{Block, Item};
use crate::setup;
use crate::state::State;

/// How many common variables have values that are any binary64 numbers.
const VALUES: u8 = 6;

/// Expressions and what their variables hold.
#[derive(Clone, PartialEq, Debug)]
pub struct Formulas {
    /// A set-up with the values of `V1` to `V6`: any finite binary64 numbers.
    pub setup: Setup,
    /// The texts of some expressions, each fit for a block of its own.
    pub texts: Vec<String>,
}

impl<'a> Arbitrary<'a> for Formulas {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let choices = &mut Choices::new(bytes);
        let mut setup = setup::setup(choices, &Profile::FULL);
        setup.tape.code = TapeCode::Ascii;
        // Two saddles have no variables (E100L-AX4-12).
        setup.machine = Setup::default().machine;
        setup.variables = (1..=VALUES).map(|number| (format!("V{number}"), any_value(choices))).collect();
        let mut environment = State::new(setup.clone()).environment;
        environment.common = (1..=VALUES).map(|number| (number, 0.0)).collect();
        let texts = (0..=choices.below(4)).map(|_| text(choices, &environment)).collect();
        Ok(Self { setup, texts })
    }
}

/// A number: any bits, or one that lies at a border of the integers or of rounding.
fn any_value(choices: &mut Choices<'_, '_>) -> f64 {
    const BORDERS: [f64; 12] = [
        0.5,
        1.5,
        2_147_483_647.0,
        2_147_483_648.5,
        -2_147_483_648.0,
        9_007_199_254_740_991.0,
        90.0,
        0.000_5,
        1e-308,
        5e-324,
        1.797e308,
        0.1,
    ];
    let any = |choices: &mut Choices<'_, '_>| {
        let word = |choices: &mut Choices<'_, '_>| choices.within(0, 0xFFFF_FFFF).unsigned_abs();
        f64::from_bits(word(choices) << 32 | word(choices))
    };
    let value = match choices.below(4) {
        0 => choices.within(-1_000_000, 1_000_000) as f64 / 1_000.0,
        1 => choices.within(-360, 360) as f64,
        2 => choices.pick(&BORDERS),
        _ => any(choices),
    };
    // A set-up file has no sign of zero.
    if value.is_finite() && value != 0.0 { value } else { 0.0 }
}

fn text(choices: &mut Choices<'_, '_>, environment: &Environment) -> String {
    loop {
        let depth = 1 + choices.below(5);
        let expression = Expression::grow(choices, environment, depth);
        let items = vec![Item::Assignment(Variable::Common(9), expression)];
        let block = Block { items, ..Block::default() };
        let text = print::block_text(&block, Style::choose(choices, true, Profile::FULL), choices);
        if text.len() <= print::LONGEST || choices.is_empty() {
            return text;
        }
    }
}

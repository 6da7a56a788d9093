//! Two spellings of one program: what the control does must not depend on them.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_oracle::vocabulary::TapeCode;

use crate::builder::Builder;
use crate::case::Case;
use crate::choices::Choices;
use crate::print::{self, Style};
use crate::profile::Profile;
use crate::program::{Block, Item, Line, Program};
use crate::state::State;
use crate::{setup, tape};

/// One program in two spellings: blanks, comments, leading zeros, signs, continuation lines, ends of line,
/// tape code, and the order of words that are not codes.
#[derive(Clone, PartialEq, Debug)]
pub struct Respelled {
    /// A spelling.
    pub one: Case,
    /// Another one.
    pub other: Case,
    /// Whether words stand in another order.
    pub reordered: bool,
}

impl<'a> Arbitrary<'a> for Respelled {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let choices = &mut Choices::new(bytes);
        let (program, state) = grown(choices);
        let setup = state.setup;
        let all_characters = setup.tape.code != TapeCode::Eia;
        let spell = |program: &Program, choices: &mut Choices<'_, '_>| {
            let style = Style::choose(choices, all_characters, Profile::FULL);
            print::program(program, style, choices)
        };
        let one = spell(&program, choices);
        let reordered = choices.chance(50);
        let shuffled = if reordered { reorder(&program, choices) } else { program };
        let other = spell(&shuffled, choices);
        let codes = [TapeCode::Ascii, TapeCode::Iso, TapeCode::Eia];
        let code = choices.pick(&codes);
        let fits = [&one, &other].iter().all(|text| {
            let reads_back = |code: TapeCode| tape::decode(&tape::encode(text, code), code) == **text;
            !text.contains(&tape::WRONG_PARITY) && reads_back(setup.tape.code) && reads_back(code)
        });
        let mut other_setup = setup.clone();
        if fits {
            other_setup.tape.code = code;
        }
        let program = tape::encode(&one, setup.tape.code);
        let one = Case { setup, program };
        let program = tape::encode(&other, other_setup.tape.code);
        Ok(Self { one, other: Case { setup: other_setup, program }, reordered })
    }
}

/// A program with sequence names, and the same one without them but with remarks in lines of their own.
#[derive(Clone, PartialEq, Debug)]
pub struct Remarked {
    /// The program as it was grown.
    pub named: Case,
    /// The program without sequence names, with remarks.
    pub remarked: Case,
}

impl<'a> Arbitrary<'a> for Remarked {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let choices = &mut Choices::new(bytes);
        let (program, state) = grown(choices);
        let plain = |program: &Program| {
            let text = print::plainest(program);
            Case { program: tape::encode(&text, state.setup.tape.code), setup: state.setup.clone() }
        };
        let named = plain(&program);
        Ok(Self { named, remarked: plain(&remark(program, choices)) })
    }
}

/// A program of any kind and the state that it ends in.
fn grown(choices: &mut Choices<'_, '_>) -> (Program, State) {
    let setup = setup::setup(choices, &Profile::FULL);
    let mut builder = Builder::new(choices, State::new(setup), Profile::FULL);
    builder.build();
    builder.finish()
}

/// The program with the words of some blocks in another order. G words keep their order among themselves, so
/// do M words (they are carried out in written order); a block with an assignment stays as it is.
fn reorder(program: &Program, choices: &mut Choices<'_, '_>) -> Program {
    let mut program = program.clone();
    for line in &mut program.lines {
        let Line::Block(block) = line else { continue };
        let fixed = |item: &Item| matches!(item, Item::Assignment(..) | Item::Raw(_));
        if !block.items.iter().any(fixed) && choices.chance(60) {
            shuffle_words(&mut block.items, choices);
        }
    }
    program
}

fn shuffle_words(items: &mut [Item], choices: &mut Choices<'_, '_>) {
    let before = items.to_vec();
    choices.shuffle(items);
    for address in ["G", "M"] {
        let of_address = |item: &&mut Item| is_word(item, address);
        let codes = before.iter().filter(|item| is_word(item, address));
        for (place, code) in items.iter_mut().filter(of_address).zip(codes) {
            *place = code.clone();
        }
    }
}

fn is_word(item: &Item, address: &str) -> bool {
    matches!(item, Item::Word(word) if word.address == address)
}

/// Takes the sequence names away, but not those that are the whole of a block (without them it would be
/// none), and adds remarks.
fn remark(program: Program, choices: &mut Choices<'_, '_>) -> Program {
    const REMARKS: [&[u8]; 5] = [b"(REMARK)", b"", b"\t (A) ", b" ", b"(( G00 X1)"];
    let mut lines = Vec::new();
    for line in program.lines {
        let continued = matches!(&line, Line::Raw(text) if text.first() == Some(&b'$'));
        if !continued && !lines.is_empty() && choices.chance(20) {
            lines.push(Line::Raw(choices.pick(&REMARKS).to_vec()));
        }
        lines.push(match line {
            Line::Block(block) if !block.items.is_empty() => Line::Block(Block { sequence: None, ..block }),
            line => line,
        });
    }
    Program { lines }
}

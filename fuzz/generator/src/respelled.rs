//! Two spellings of one program: what the control does must not depend on them.

use std::collections::BTreeSet;

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_oracle::vocabulary::{Setup, TapeCode};

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
            (print::program(program, style, choices), print::library(program, style, choices))
        };
        let one = spell(&program, choices);
        let reordered = choices.chance(50);
        let shuffled = if reordered { reorder(&program, choices) } else { program };
        let other = spell(&shuffled, choices);
        let codes = [TapeCode::Ascii, TapeCode::Iso, TapeCode::Eia];
        let code = choices.pick(&codes);
        let texts = [&one, &other]
            .into_iter()
            .flat_map(|(main, library)| std::iter::once(main).chain(library.iter().map(|(_, text)| text)));
        let fits = texts.into_iter().all(|text| {
            let reads_back = |code: TapeCode| tape::decode(&tape::encode(text, code), code) == *text;
            !text.contains(&tape::WRONG_PARITY) && reads_back(setup.tape.code) && reads_back(code)
        });
        let mut other_setup = setup.clone();
        if fits {
            other_setup.tape.code = code;
        }
        Ok(Self { one: coded(one, setup), other: coded(other, other_setup), reordered })
    }
}

/// The case of texts of a program and its library, in the tape code of a set-up.
fn coded((main, library): (Vec<u8>, Vec<(String, Vec<u8>)>), mut setup: Setup) -> Case {
    let program = tape::encode(&main, setup.tape.code);
    setup.library = tape::library(library, setup.tape.code);
    Case { setup, program }
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
            coded((print::plainest(program), print::plainest_library(program)), state.setup.clone())
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
/// do M words (they are carried out in written order); a block with an assignment, or with G77 or G78, stays as it is.
fn reorder(program: &Program, choices: &mut Choices<'_, '_>) -> Program {
    let mut program = program.clone();
    let library = program.library.iter_mut().flat_map(|(_, lines)| lines);
    for line in program.lines.iter_mut().chain(library) {
        let Line::Block(block) = line else { continue };
        let fixed = |item: &Item| match item {
            Item::Assignment(..) | Item::Comment(..) | Item::Raw(_) => true,
            // These have to stand first (E100L-TAP-01).
            Item::Word(word) => word.is_g(&[77, 78]),
            Item::Calrg => false,
        };
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
/// none) and those that are looked for, and adds remarks.
fn remark(program: Program, choices: &mut Choices<'_, '_>) -> Program {
    let texts = || program.library.iter().map(|(_, lines)| lines).chain([&program.lines]);
    let wanted: BTreeSet<String> = texts().flatten().filter_map(target).collect();
    let raw: Vec<String> = texts().flatten().filter_map(raw_text).collect();
    let is_wanted = |name: &String| {
        let named = format!("N{name}");
        wanted.contains(name) || raw.iter().any(|text| text.contains(&named))
    };
    let library = program.library.clone().into_iter();
    let library = library.map(|(name, lines)| (name, remarked(lines, &is_wanted, choices))).collect();
    Program { lines: remarked(program.lines.clone(), &is_wanted, choices), library }
}

/// The sequence name that a block looks for.
fn target(line: &Line) -> Option<String> {
    let Line::Block(Block { statement: Some(statement), .. }) = line else { return None };
    statement.target().map(str::to_owned)
}

fn raw_text(line: &Line) -> Option<String> {
    let Line::Raw(text) = line else { return None };
    Some(String::from_utf8_lossy(text).into_owned())
}

fn remarked(
    lines: Vec<Line>,
    is_wanted: &impl Fn(&String) -> bool,
    choices: &mut Choices<'_, '_>,
) -> Vec<Line> {
    const REMARKS: [&[u8]; 5] = [b"(REMARK)", b"", b"\t (A) ", b" ", b"(( G00 X1)"];
    let mut more = Vec::new();
    for line in lines {
        let continued = matches!(&line, Line::Raw(text) if text.first() == Some(&b'$'));
        if !continued && !more.is_empty() && choices.chance(20) {
            more.push(Line::Raw(choices.pick(&REMARKS).to_vec()));
        }
        more.push(match line {
            Line::Block(block) if block.items.is_empty() && block.statement.is_none() => Line::Block(block),
            Line::Block(block) => Line::Block(Block { sequence: block.sequence.filter(is_wanted), ..block }),
            line => line,
        });
    }
    more
}

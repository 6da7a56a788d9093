//! Reading a program: which block comes next (execution.md, chapter 9), and what it holds.

use std::collections::VecDeque;

use super::programs::Programs;
use super::texts::{Read, Spot, Texts};
use crate::fault::{Fault, Outcome};
use crate::integer::steps;
use crate::modal::Words;
use crate::syntax::{Body, Communication, Heading, Item, Statement, heading, parse};
use crate::task::Activation;
use crate::turret::selected_by;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, MachineType, Place, Setup, Side};

/// A block that was read.
pub struct Block {
    /// Where it stands.
    pub place: Place,
    /// What it holds.
    pub content: Content,
    /// The block behind it.
    pub behind: Spot,
    /// The codes G80 to G83 that its items have as plain numbers (E100L-LAP-10).
    pub definition: Vec<u16>,
}

/// What a block holds.
pub enum Content {
    /// Nothing, or what is skipped: look-ahead does not see it.
    Nothing,
    /// A program name, or a sequence name alone.
    Name,
    /// Items, not evaluated yet; NOEX in front of them, or alone, does nothing (E100L-NOEX-01).
    Items(Vec<Item>),
    /// It selects a turret (E100L-MIRR-03).
    Turret(Vec<Side>),
    /// Words that look-ahead has evaluated.
    Words(Box<Words>),
    /// A statement that tells which block comes next.
    Statement(Statement),
    /// A statement of data communication.
    Communication(Communication),
    /// A call of LAP: the name of its contour, and its items.
    ContourCall(Label, Vec<Item>),
}

/// The place of a run in its texts.
pub struct Reader<'a> {
    /// The programs.
    pub programs: Programs<'a>,
    setup: &'a Setup,
    /// The block that is read next.
    next: Spot,
    /// Blocks that were read ahead of their turn.
    waiting: VecDeque<Block>,
    /// How many blocks the run has arrived at.
    pub steps: u64,
}

impl<'a> Reader<'a> {
    /// At the beginning of the main text.
    pub fn new(texts: Texts<'a>, setup: &'a Setup) -> Self {
        let programs = Programs::new(texts, setup);
        let next = programs.texts().main_start();
        Self { programs, setup, next, waiting: VecDeque::new(), steps: 0 }
    }

    /// The run goes on elsewhere (E100L-GOTO-01, E100L-CALL-02, E100L-RTS-02).
    pub fn go_to(&mut self, next: Spot) {
        self.waiting.clear();
        self.next = next;
    }

    /// The block at which the run arrives; none at the end of the text. The place is set as soon as it is known.
    pub fn arrive(&mut self, program: &mut Activation, place: &mut Place) -> Outcome<Option<Block>> {
        if let Some(block) = self.waiting.pop_front() {
            self.step(Place { sequence: Label::default(), ..block.place }, place)?;
            *place = block.place;
            return Ok(Some(block));
        }
        let Some(read) = self.programs.texts().read(self.next)? else {
            *place = Place { program: program.name, ..self.programs.texts().end(self.next) };
            return Ok(None);
        };
        let here = Place { program: program.name, ..read.line.place };
        if program.began && self.begins_program(&read) {
            *place = here;
            // E100L-RTS-01: of the block that the next program begins with nothing is checked.
            return if program.caller.is_some() || program.selected {
                Err(end(program))
            } else {
                self.block(read, program, place).map(Some)
            };
        }
        self.step(here, place)?;
        self.block(read, program, place).map(Some)
    }

    /// E100L-GOTO-03: one step more.
    pub fn step(&mut self, block: Place, place: &mut Place) -> Outcome<()> {
        *place = block;
        let next = steps::next(self.steps, self.setup.limits.steps);
        self.steps = next.ok_or_else(|| Fault::new(AlarmName::StepLimit, GOTO_03))?;
        Ok(())
    }

    fn begins_program(&self, read: &Read) -> bool {
        matches!(heading(&read.line, self.setup), Heading::Program(_))
    }

    /// Reads a block at its place.
    fn block(&mut self, read: Read, program: &mut Activation, place: &mut Place) -> Outcome<Block> {
        let Read { start, line, behind } = read;
        let parsed = parse(&line, self.setup, &mut place.sequence);
        let body = parsed.map_err(|fault| fault.of_block(*place))?.body;
        // E100L-SEQ-03, E100L-SEQ-04: each name once in a program, compared as text.
        let name = place.sequence;
        if !name.is_empty() && self.programs.stands_before(name, program.start, start) {
            return Err(Fault::new(AlarmName::SequenceNameDuplicate, SEQ_03).of_block(*place));
        }
        let began = program.began;
        program.began |= body != Body::Empty;
        let definition = definition_codes(&body);
        let content = match body {
            Body::Empty | Body::Skipped => Content::Nothing,
            Body::ProgramName(_) if began => {
                return Err(Fault::new(AlarmName::ProgramNameMisplaced, PROG_02).of_block(*place));
            }
            Body::ProgramName(name) => {
                program.name = name;
                program.start = behind;
                place.program = name;
                Content::Name
            }
            Body::Items(items) if items.is_empty() => Content::Name,
            Body::Items(items) if self.selects_turret(&items) => Content::Turret(selected_by(&items)),
            Body::Items(items) | Body::Noex(items) => Content::Items(items),
            Body::Statement(statement) => Content::Statement(statement),
            Body::Communication(statement) => Content::Communication(statement),
            Body::ContourCall(contour, items) => Content::ContourCall(contour, items),
        };
        self.next = behind;
        Ok(Block { place: *place, content, behind, definition })
    }

    /// Whether the program has no further block (execution.md, chapter 9).
    pub fn at_end(&self, program: &Activation) -> Outcome<bool> {
        if !self.waiting.is_empty() {
            return Ok(false);
        }
        let next = self.programs.texts().read(self.next)?;
        Ok(next.is_none_or(|read| program.began && self.begins_program(&read)))
    }

    fn selects_turret(&self, items: &[Item]) -> bool {
        self.setup.machine.r#type == MachineType::TwoTurrets && !selected_by(items).is_empty()
    }

    /// The block `index` places further in the program, those aside that look-ahead does not see; none where the
    /// program ends.
    pub fn ahead(&mut self, index: usize, program: &mut Activation) -> Outcome<Option<&mut Block>> {
        while self.waiting.iter().filter(|block| is_seen(block)).count() <= index {
            let Some(read) = self.programs.texts().read(self.next)? else { return Ok(None) };
            if self.begins_program(&read) {
                return Ok(None);
            }
            let mut place = Place { program: program.name, ..read.line.place };
            let block = self.block(read, program, &mut place).map_err(|fault| fault.of_block(place))?;
            self.waiting.push_back(block);
        }
        Ok(self.waiting.iter_mut().filter(|block| is_seen(block)).nth(index))
    }
}

fn definition_codes(body: &Body) -> Vec<u16> {
    let items = match body {
        Body::Items(items) | Body::ContourCall(_, items) => items.as_slice(),
        _ => &[],
    };
    items.iter().filter_map(|item| item.kind.plain_g()).filter(|code| (80..=83).contains(code)).collect()
}

fn is_seen(block: &Block) -> bool {
    !matches!(block.content, Content::Nothing)
}

/// The end of a program without RTS, M02 or M30.
pub fn end(program: &Activation) -> Fault {
    match program.caller {
        Some(_) => Fault::new(AlarmName::NoReturn, RTS_01),
        None => Fault::new(AlarmName::NoProgramEnd, PROG_02),
    }
}

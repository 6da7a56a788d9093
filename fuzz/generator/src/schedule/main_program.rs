//! Main programs of a schedule: how they are grown, in which files they stand.

use std::rc::Rc;

use turnspec_oracle::vocabulary::Feature;

use super::short::Short;
use crate::builder::{ATTEMPTS, Builder, Kind};
use crate::control::{Called, Nature};
use crate::program::Line;
use crate::state::Mode;

/// Files of main programs; those that PSELECT may leave out in part come first.
const FILES: &[&str] = &[
    "A.MIN",
    "A.MIN",
    "A.MIN",
    "B.MIN",
    "SHAFT-1.MIN",
    "A.XYZ",
    "ABCDEFGHIJKLMNOP.MIN",
    "P2.SUB",
    "SDF.MIN",
];

/// Files of subprograms.
const SUBPROGRAMS: &[&str] = &["S.SUB", "PULL.SUB", "X1.SUB", "T.MIN"];

/// A main program that can be selected.
#[derive(Debug)]
pub(crate) struct Main {
    pub file: &'static str,
    /// Its name, without the `O`.
    pub name: Option<String>,
    /// Whether it is the first program of its file.
    pub first: bool,
    /// The file with its subprograms.
    pub subprograms: Option<&'static str>,
    pub effect: Effect,
}

/// What it does each time.
#[derive(Debug)]
pub(crate) enum Effect {
    /// It was grown where it runs, once.
    Grown,
    /// It leads to a state of its own.
    Again(Rc<Called>),
    /// A short one.
    Short(Short),
}

impl Builder<'_, '_, '_> {
    /// A new main program, for this place or for others too.
    pub(super) fn new_main(&mut self) -> Rc<Main> {
        let (file, name, first) = self.place_of_main();
        let full = self.profile.is_full() && !self.state.control.steady;
        let positions = self.allows(Feature::Rapid) && self.allows(Feature::Absolute);
        let again = positions && (self.state.control.steady || self.choices.chance(35));
        let before = self.state.control.programs_count();
        let mode = self.state.mode;
        let (effect, lines) = if full && self.choices.chance(22) {
            self.short_program()
        } else if again {
            self.grown_apart(&name)
        } else {
            (Effect::Grown, self.grown(&name))
        };
        let written = self.text_of(&lines);
        self.state.schedule.misfit |= !self.profile.permits_text(&written, mode);
        let mut text: Vec<Line> = Vec::new();
        if let Some(name) = &name {
            text.push(Line::Raw(self.name_block(name)));
        }
        text.extend(lines);
        self.state.schedule.files.entry(file).or_default().extend(text);
        let subprograms = self.place_subprograms(before, file);
        let main = Rc::new(Main { file, name, first, subprograms, effect });
        if !matches!(main.effect, Effect::Grown) {
            self.state.schedule.mains.push(main.clone());
        }
        main
    }

    /// File and name of a main program, and whether it is the first one of its file.
    fn place_of_main(&mut self) -> (&'static str, Option<String>, bool) {
        let file = self.choices.pick(FILES);
        if self.state.schedule.files.contains_key(file) {
            return (file, Some(self.program_name()), false);
        }
        let nameless = self.choices.chance(35);
        let mut head = if nameless { Vec::new() } else { self.head_of_file() };
        let begun = head.iter().any(|line| matches!(line, Line::Raw(text) if begins_program(text)));
        if self.choices.chance(15) && !begun {
            head.push(Line::Raw(b"%".to_vec()));
        }
        self.state.schedule.files.insert(file, head);
        let name = if nameless { None } else { Some(self.program_name()) };
        (file, name, !begun)
    }

    /// A main program that goes on from the present state.
    fn grown(&mut self, name: &Option<String>) -> Vec<Line> {
        self.inside_main(name, |builder| {
            let size = 1 + builder.choices.below(12);
            builder.grow_blocks(size);
        })
    }

    /// A main program that may run at other places too.
    fn grown_apart(&mut self, name: &Option<String>) -> (Effect, Vec<Line>) {
        let nature = self.choices.weighted(&[(40, Nature::Full), (40, Nature::Robust), (20, Nature::Still)]);
        let before = self.begin_apart();
        let lines = self.inside_main(name, |builder| {
            builder.allow_blocks(6);
            builder.shared_body(nature);
        });
        let (lines, again) = self.end_apart(nature, before, Vec::new(), lines);
        let called = Called { name: String::new(), lines: Vec::new(), again: Some(again) };
        (Effect::Again(Rc::new(called)), lines)
    }

    /// The lines of a main program up to its end.
    fn inside_main(&mut self, name: &Option<String>, body: impl FnOnce(&mut Self)) -> Vec<Line> {
        let lines = std::mem::take(&mut self.lines);
        let names = std::mem::take(&mut self.state.names);
        let tail = self.state.control.change_tail(Vec::new());
        let label = self.state.control.take_label();
        self.state.control.main.clone_from(name);
        self.settled();
        body(self);
        self.settle_label();
        self.end_compensation();
        if !self.within_profile(ATTEMPTS, Self::ending) {
            self.raw(b"M02");
        }
        self.state.control.main = None;
        let mut written = std::mem::replace(&mut self.lines, lines);
        self.state.names = names;
        written.append(&mut self.state.control.change_tail(tail));
        if let Some(label) = label {
            self.set_label(label);
        }
        written
    }

    /// Compensation that is off at the end, mostly.
    fn end_compensation(&mut self) {
        if !self.choices.chance(4) {
            self.out_of_compensation();
        }
    }

    /// Blocks that end compensation, if it is in force.
    pub(crate) fn out_of_compensation(&mut self) {
        if !self.state.compensation.is_on() {
            return;
        }
        if self.state.compensation.has_to_go_on() {
            self.ordinary_block();
        }
        for _ in 0..6 {
            if !self.state.compensation.is_on() {
                break;
            }
            self.within_profile(ATTEMPTS, |builder| {
                builder.begin();
                builder.fitting(|builder| builder.block_of(Kind::Cancel));
                true
            });
        }
    }

    /// Places the programs that were written for a main program beside it, in a file that PSELECT names, or leaves them
    /// for other main programs too.
    fn place_subprograms(&mut self, before: usize, file: &'static str) -> Option<&'static str> {
        let beside = self.choices.chance(60);
        let programs = if beside { self.state.control.take_programs_from(before) } else { Vec::new() };
        let named = self.choices.pick(SUBPROGRAMS);
        let mut used = false;
        for called in programs {
            if self.choices.chance(40) {
                self.add_program(file, &called);
            } else {
                self.add_program(named, &called);
                used = true;
            }
        }
        if used {
            self.state.schedule.subprograms.push(named);
            return Some(named);
        }
        let known = self.state.schedule.subprograms.clone();
        if known.is_empty() || self.choices.chance(70) { None } else { Some(self.choices.pick(&known)) }
    }

    /// Adds a program to a file.
    pub(super) fn add_program(&mut self, file: &'static str, called: &Called) {
        if !self.state.schedule.files.contains_key(file) {
            let head = self.head_of_file();
            self.state.schedule.files.insert(file, head);
        }
        let name = Line::Raw(self.name_block(&called.name));
        let file = self.state.schedule.files.entry(file).or_default();
        file.push(name);
        file.extend(called.lines.iter().cloned());
    }

    /// Notes that a main program begins in the mode that the one before left.
    fn settled(&mut self) {
        if !matches!(self.state.mode, Mode::Rapid | Mode::Linear) {
            self.state.compensation.left_over = false;
        }
    }
}

/// Whether a line before the first name block is a block.
fn begins_program(text: &[u8]) -> bool {
    !matches!(text.first(), None | Some(b'$' | b'(')) && text != b"%"
}

//! The programs of the texts, and where their names stand (E100L-CALL-03, E100L-CALL-06, E100L-GOTO-02).

use std::collections::{BTreeMap, BTreeSet};

use super::texts::{Read, Spot, Texts};
use crate::fault::{Fault, Outcome};
use crate::syntax::{Heading, heading};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Label, Setup};

/// A program that can be called.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Program {
    /// Its name, with `O`.
    pub name: Label,
    /// Its name block.
    pub start: Spot,
}

/// What was found out about the texts so far.
pub struct Programs<'a> {
    texts: Texts<'a>,
    setup: &'a Setup,
    /// All programs with a name, once they were asked for.
    all: Option<Vec<Program>>,
    /// The texts that subprograms are found in, if not in all (E100L-SDF-10).
    pub within: Option<BTreeSet<usize>>,
    /// The sequence names of the programs, by the places where these begin.
    names: BTreeMap<Spot, Names>,
}

/// The sequence names of a program.
struct Names {
    /// The first block of each name.
    first: BTreeMap<Label, Spot>,
    /// How far the program was searched.
    searched: Spot,
    /// Whether that is its end.
    whole: bool,
}

impl<'a> Programs<'a> {
    /// The programs of these texts.
    pub fn new(texts: Texts<'a>, setup: &'a Setup) -> Self {
        Self { texts, setup, all: None, within: None, names: BTreeMap::new() }
    }

    /// The texts.
    pub fn texts(&self) -> &Texts<'a> {
        &self.texts
    }

    /// E100L-CALL-03: the program that is called by a name.
    pub fn find(&mut self, name: Label) -> Outcome<Program> {
        let within = self.within.clone();
        let found = self.only(name, |text| within.as_ref().is_none_or(|within| within.contains(&text)))?;
        found.ok_or_else(|| Fault::about(AlarmName::ProgramUnknown, CALL_03, name.as_str()))
    }

    /// E100L-NAME-04, E100L-NAME-05: the only program of a name, compared as text, in the texts that are searched.
    pub fn only(&mut self, name: Label, searched: impl Fn(usize) -> bool) -> Outcome<Option<Program>> {
        let (texts, setup) = (&self.texts, self.setup);
        let all = self.all.get_or_insert_with(|| programs(texts, setup));
        let mut found = all.iter().filter(|program| program.name == name && searched(program.start.text));
        let first = found.next().copied();
        if found.next().is_some() {
            return Err(Fault::about(AlarmName::ProgramDuplicate, NAME_05, name.as_str()));
        }
        Ok(first)
    }

    /// E100L-GOTO-02, E100L-SEQ-04, E100L-DEL-04: the first block with a name in the program that begins at `start`,
    /// skipped or not.
    pub fn block(&mut self, name: Label, start: Spot) -> Option<Spot> {
        self.search(start, None).first.get(&name).copied()
    }

    /// E100L-SEQ-03: whether a block of the program that begins at `start` has the name and stands before another.
    pub fn stands_before(&mut self, name: Label, start: Spot, other: Spot) -> bool {
        self.search(start, Some(other)).first.get(&name).is_some_and(|first| *first < other)
    }

    /// Searches a program up to a place, or to its end.
    fn search(&mut self, start: Spot, limit: Option<Spot>) -> &Names {
        let names = self.names.entry(start).or_insert_with(|| Names {
            first: BTreeMap::new(),
            searched: start,
            whole: false,
        });
        while !names.whole && limit.is_none_or(|limit| names.searched < limit) {
            let Ok(Some(Read { start, line, behind })) = self.texts.read(names.searched) else {
                names.whole = true;
                break;
            };
            match heading(&line, self.setup) {
                Heading::Program(_) => names.whole = true,
                Heading::Sequence(name) => {
                    names.first.entry(name).or_insert(start);
                }
                Heading::Nothing => {}
            }
            names.searched = behind;
        }
        names
    }
}

/// E100L-PROG-03, E100L-NAME-06: the programs of all texts; what has no name is called by nobody.
fn programs(texts: &Texts, setup: &Setup) -> Vec<Program> {
    let mut programs = Vec::new();
    for mut spot in texts.starts() {
        while let Ok(Some(Read { start, line, behind })) = texts.read(spot) {
            if let Heading::Program(Some(name)) = heading(&line, setup) {
                programs.push(Program { name, start });
            }
            spot = behind;
        }
    }
    programs
}

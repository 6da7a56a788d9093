//! Where programs stand in the end: behind the main program, or in files of the library.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::program::{Line, Program};
use crate::state::State;

use super::text;

impl Builder<'_, '_, '_> {
    /// The program, and the state with the torque stops, macros and limits that it needs.
    pub(crate) fn finish(mut self) -> (Program, State) {
        if self.state.schedule.active {
            return self.finish_schedule();
        }
        let mut main = std::mem::take(&mut self.lines);
        main.append(&mut self.state.control.tail);
        let mut files: BTreeMap<&'static str, Vec<Line>> = BTreeMap::new();
        for called in std::mem::take(&mut self.state.control.programs) {
            let mut lines = vec![Line::Raw(self.name_block(&called.name))];
            lines.extend(called.lines.iter().cloned());
            if self.choices.chance(40) {
                main.extend(lines);
            } else {
                let file = self.choices.pick(text::FILES);
                if !files.contains_key(file) {
                    let head = self.head_of_file();
                    files.insert(file, head);
                }
                files.entry(file).or_default().extend(lines);
            }
        }
        self.other_programs(&mut files);
        self.bound_steps();
        let library = files.into_iter().map(|(name, lines)| (name.to_owned(), lines)).collect();
        (Program { lines: main, library }, self.state)
    }

    pub(crate) fn name_block(&mut self, name: &str) -> Vec<u8> {
        let colon = !self.state.is_eia() && self.choices.chance(12);
        let tail = if self.choices.chance(15) && self.allows(Feature::Comment) { " (PART)" } else { "" };
        format!("{}{name}{tail}", if colon { ":" } else { "O" }).into_bytes()
    }

    /// What stands in a file before its first program.
    pub(crate) fn head_of_file(&mut self) -> Vec<Line> {
        let mut lines = Vec::new();
        if !self.state.is_eia() && self.choices.chance(40) {
            self.add_within(text::HEADERS, &mut lines);
        }
        if !self.state.is_eia() && self.choices.chance(20) {
            self.add_within(text::BEFORE, &mut lines);
        }
        lines
    }

    /// Programs and files that nothing calls.
    fn other_programs(&mut self, files: &mut BTreeMap<&'static str, Vec<Line>>) {
        if self.state.is_eia() || !self.state.control.jumps || !self.choices.chance(20) {
            return;
        }
        if !self.allows(Feature::Subprogram) {
            return;
        }
        let file = self.choices.pick(text::FILES);
        let mut lines = Vec::new();
        self.add_within(text::OTHERS, &mut lines);
        files.entry(file).or_default().extend(lines);
    }

    fn add_within(&mut self, list: &[&'static [u8]], lines: &mut Vec<Line>) {
        let text = self.choices.pick(list);
        if self.profile.permits_text(text, crate::state::Mode::Rapid) {
            lines.push(Line::Raw(text.to_vec()));
        }
    }

    /// Programs that jump, or have threads, cycles or LAP, have a limit of their steps, some a low one.
    pub(crate) fn bound_steps(&mut self) {
        let plain = turnspec_oracle::vocabulary::Setup::default().limits.steps;
        let passes = self.has_passes();
        let limits = &mut self.state.setup.limits;
        let profile = if passes { &self.whole } else { &self.profile };
        let repeats = self.state.control.jumps || passes;
        if repeats && limits.steps == plain && profile.allows(Feature::ControlStatement) {
            limits.steps = if self.choices.chance(7) {
                self.choices.within(3, 80).unsigned_abs()
            } else {
                self.choices.pick(&[1_000, 3_000, 1_500])
            };
        }
    }
}

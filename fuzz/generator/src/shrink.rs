//! Makes a failing case smaller while it keeps failing: plain code and set-up first, then fewer lines, fewer
//! words, shorter numbers, and of a short text anything.

use turnspec_oracle::vocabulary::{Setup, TapeCode};

use crate::case::Case;
use crate::tape;

/// The smallest case that this finds for which `fails` still holds. `fails` must hold for `case`.
#[must_use]
pub fn shrink(case: Case, mut fails: impl FnMut(&Case) -> bool) -> Case {
    let mut shrinker = Shrinker { best: case, fails: &mut fails };
    shrinker.plain_code();
    while shrinker.lines()
        | shrinker.library()
        | shrinker.devices()
        | shrinker.setup()
        | shrinker.words()
        | shrinker.numbers()
        | shrinker.runs()
    {}
    shrinker.best
}

struct Shrinker<'f> {
    best: Case,
    fails: &'f mut dyn FnMut(&Case) -> bool,
}

impl Shrinker<'_> {
    /// Takes a candidate if it fails too.
    fn try_case(&mut self, candidate: Case) -> bool {
        let better = (self.fails)(&candidate);
        if better {
            self.best = candidate;
        }
        better
    }

    /// The texts of the best case: the program, then the files of the library.
    fn texts(&self) -> usize {
        1 + self.best.setup.library.len()
    }

    /// One of these texts.
    fn text(&self, place: usize) -> &[u8] {
        let file = place.checked_sub(1).and_then(|place| self.best.setup.library.values().nth(place));
        file.map_or(&self.best.program, |text| &text.0)
    }

    /// Tries another text in the place of one.
    fn try_text(&mut self, place: usize, text: Vec<u8>) -> bool {
        let mut candidate = self.best.clone();
        let file = place.checked_sub(1).and_then(|place| candidate.setup.library.values_mut().nth(place));
        match file {
            Some(file) => file.0 = text,
            None => candidate.program = text,
        }
        self.try_case(candidate)
    }

    /// Files of the library left out, or put behind the program.
    fn library(&mut self) -> bool {
        let mut smaller = false;
        let end = tape::end_of_block(self.best.setup.tape.code);
        let names: Vec<String> = self.best.setup.library.keys().cloned().collect();
        for name in names {
            let mut candidate = self.best.clone();
            let Some(text) = candidate.setup.library.remove(&name) else { continue };
            if self.try_case(candidate.clone()) {
                smaller = true;
                continue;
            }
            if candidate.program.last() != Some(&end) {
                candidate.program.push(end);
            }
            candidate.program.extend(text.0);
            smaller |= self.try_case(candidate);
        }
        smaller
    }

    /// What devices send and inputs show: fewer texts, shorter ones, fewer values.
    fn devices(&mut self) -> bool {
        let mut smaller = false;
        for name in self.best.setup.devices.keys().cloned().collect::<Vec<_>>() {
            let mut place = self.best.setup.devices.get(&name).map_or(0, Vec::len);
            while place > 0 {
                place -= 1;
                let mut candidate = self.best.clone();
                if let Some(texts) = candidate.setup.devices.get_mut(&name) {
                    texts.remove(place);
                    texts.is_empty().then(|| candidate.setup.devices.remove(&name));
                }
                smaller |= self.try_case(candidate) || self.shorter_text(&name, place);
            }
        }
        for number in self.best.setup.inputs.vdin.keys().copied().collect::<Vec<_>>() {
            let mut candidate = self.best.clone();
            candidate.setup.inputs.vdin.remove(&number);
            smaller |= self.try_case(candidate);
        }
        smaller
    }

    /// One text of a device, shorter.
    fn shorter_text(&mut self, name: &str, place: usize) -> bool {
        let mut smaller = false;
        let text = |case: &Case| {
            case.setup.devices.get(name).and_then(|texts| texts.get(place)).map_or(0, |text| text.0.len())
        };
        let mut byte = text(&self.best);
        while byte > 0 {
            byte -= 1;
            let mut candidate = self.best.clone();
            let texts = candidate.setup.devices.get_mut(name);
            let Some(text) = texts.and_then(|texts| texts.get_mut(place)) else { break };
            text.0.remove(byte);
            smaller |= self.try_case(candidate);
        }
        smaller
    }

    /// Seven-bit characters instead of the tape's code.
    fn plain_code(&mut self) {
        if self.best.setup.tape.code == TapeCode::Ascii {
            return;
        }
        let mut candidate = self.best.clone();
        let code = candidate.setup.tape.code;
        candidate.program = tape::decode(&candidate.program, code);
        for text in candidate.setup.library.values_mut() {
            text.0 = tape::decode(&text.0, code);
        }
        candidate.setup.tape.code = TapeCode::Ascii;
        self.try_case(candidate);
    }

    /// Parts of the set-up as they are by default.
    fn setup(&mut self) -> bool {
        const PARTS: &[fn(&mut Setup, &Setup)] = &[
            |setup, plain| {
                let (library, macros) = (setup.library.clone(), setup.macros.clone());
                let machine = setup.machine;
                *setup = Setup { library, macros, machine, ..plain.clone() };
            },
            |setup, plain| {
                let kept = setup.clone();
                *setup = plain.clone();
                (setup.library, setup.macros, setup.devices) = (kept.library, kept.macros, kept.devices);
                (setup.schedule, setup.tape, setup.inputs) = (kept.schedule, kept.tape, kept.inputs);
                setup.machine = kept.machine;
            },
            |setup, plain| setup.schedule = plain.schedule,
            |setup, plain| setup.devices.clone_from(&plain.devices),
            |setup, plain| setup.system_variables.clone_from(&plain.system_variables),
            |setup, plain| setup.inputs.vdin.clone_from(&plain.inputs.vdin),
            |setup, plain| setup.inputs.vird.clone_from(&plain.inputs.vird),
            |setup, plain| setup.inputs.vord.clone_from(&plain.inputs.vord),
            |setup, plain| setup.macros.clone_from(&plain.macros),
            |setup, plain| setup.machine = plain.machine,
            |setup, plain| setup.turret_b = plain.turret_b.clone(),
            |setup, plain| setup.turret_b.zero_offset = plain.turret_b.zero_offset,
            |setup, plain| setup.turret_b.start = plain.turret_b.start,
            |setup, plain| setup.turret_b.limits = plain.turret_b.limits,
            |setup, plain| setup.turret_b.tool_offset.clone_from(&plain.turret_b.tool_offset),
            |setup, plain| setup.turret_b.nose_radius.clone_from(&plain.turret_b.nose_radius),
            |setup, plain| setup.turret_b.torque_stops.clone_from(&plain.turret_b.torque_stops),
            |setup, plain| setup.start = plain.start,
            |setup, plain| setup.zero_offset = plain.zero_offset,
            |setup, plain| setup.tool_offset.clone_from(&plain.tool_offset),
            |setup, plain| setup.nose_radius.clone_from(&plain.nose_radius),
            |setup, plain| setup.limits = plain.limits.clone(),
            |setup, plain| setup.spindle = plain.spindle.clone(),
            |setup, plain| setup.stm = plain.stm,
            |setup, plain| setup.inputs = plain.inputs.clone(),
            |setup, plain| setup.variables.clone_from(&plain.variables),
            |setup, plain| setup.readings = plain.readings,
            |setup, plain| setup.unit_system = plain.unit_system,
            |setup, plain| setup.parameters = plain.parameters.clone(),
            |setup, plain| setup.options = plain.options.clone(),
            |setup, plain| setup.switches = plain.switches.clone(),
            |setup, plain| setup.barriers = plain.barriers,
            |setup, plain| setup.droop = plain.droop,
        ];
        let plain = Setup::default();
        let mut smaller = false;
        for part in PARTS {
            let mut candidate = self.best.clone();
            part(&mut candidate.setup, &plain);
            // Without this limit a loop might run for long.
            candidate.setup.limits.steps = self.best.setup.limits.steps;
            if candidate.setup != self.best.setup && candidate.setup.validate().is_ok() {
                smaller |= self.try_case(candidate);
            }
        }
        smaller
    }

    /// Leaves lines out: halves first, then ever smaller runs.
    fn lines(&mut self) -> bool {
        let end = tape::end_of_block(self.best.setup.tape.code);
        self.without_pieces(|program| {
            let pieces = program.split_inclusive(|byte| *byte == end);
            pieces.map(<[u8]>::to_vec).collect()
        })
    }

    /// Leaves words out: runs of characters that begin with a letter or stand in a comment.
    fn words(&mut self) -> bool {
        self.without_pieces(pieces)
    }

    /// Leaves out runs of the pieces that a program falls into.
    fn without_pieces(&mut self, cut: impl Fn(&[u8]) -> Vec<Vec<u8>>) -> bool {
        let mut smaller = false;
        for text in 0..self.texts() {
            let mut run = cut(self.text(text)).len() / 2;
            while run > 0 {
                let mut place = 0;
                loop {
                    let mut left = cut(self.text(text));
                    if place >= left.len() {
                        break;
                    }
                    left.drain(place..(place + run).min(left.len()));
                    if self.try_text(text, left.concat()) {
                        smaller = true;
                    } else {
                        place += run;
                    }
                }
                run /= 2;
            }
        }
        smaller
    }

    /// Leaves single digits, points, signs and blanks out.
    fn numbers(&mut self) -> bool {
        let mut smaller = false;
        for text in 0..self.texts() {
            let mut place = self.text(text).len();
            while place > 0 {
                place -= 1;
                let byte = self.text(text).get(place).copied().unwrap_or_default();
                if byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b' ' | b'\r' | b'\t' | b'/') {
                    let mut shorter = self.text(text).to_vec();
                    shorter.remove(place);
                    smaller |= self.try_text(text, shorter);
                }
            }
        }
        smaller
    }

    /// Leaves any run of characters of a short text out, the longest ones first: operands, brackets, comments.
    fn runs(&mut self) -> bool {
        for text in 0..self.texts() {
            let length = self.text(text).len();
            if length > SHORT {
                continue;
            }
            for run in (1..length).rev() {
                for place in 0..=length - run {
                    let mut shorter = self.text(text).to_vec();
                    shorter.drain(place..place + run);
                    if self.try_text(text, shorter) {
                        return true;
                    }
                }
            }
        }
        false
    }
}

/// The longest text of which every run of characters is tried.
const SHORT: usize = 20;

/// The words of a program: each begins at a letter that follows no letter, or at an end of block.
fn pieces(program: &[u8]) -> Vec<Vec<u8>> {
    let mut pieces: Vec<Vec<u8>> = Vec::new();
    let mut before = b'\n';
    for &byte in program {
        let begins = byte.is_ascii_uppercase() && !before.is_ascii_uppercase() && before != b'=';
        match pieces.last_mut() {
            Some(piece) if !begins && byte != b'\n' && before != b'\n' => piece.push(byte),
            _ => pieces.push(vec![byte]),
        }
        before = byte;
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::shrink;
    use crate::case::Case;
    use turnspec_oracle::vocabulary::Setup;

    #[test]
    fn what_does_not_matter_goes() {
        let program = b"G00 X5\nM08 M03\nG01 X12.345 Z3 F0.2\nV1=V2+5\nM02\n".to_vec();
        let mut setup = Setup::default();
        setup.switches.optional_stop = true;
        let fails = |case: &Case| {
            let text = String::from_utf8_lossy(&case.program).into_owned();
            text.lines().any(|line| line.contains("X1") && line.contains('F'))
        };
        let small = shrink(Case { setup, program }, fails);
        assert_eq!(small.program, b"X1F");
        assert_eq!(small.setup, Setup::default());
    }
}

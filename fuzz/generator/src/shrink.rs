//! Makes a failing case smaller while it keeps failing: plain code and set-up first, then fewer lines, fewer
//! words, shorter numbers.

use turnspec_oracle::vocabulary::{Setup, TapeCode};

use crate::case::Case;
use crate::tape;

/// The smallest case that this finds for which `fails` still holds. `fails` must hold for `case`.
#[must_use]
pub fn shrink(case: Case, mut fails: impl FnMut(&Case) -> bool) -> Case {
    let mut shrinker = Shrinker { best: case, fails: &mut fails };
    shrinker.plain_code();
    while shrinker.lines() | shrinker.setup() | shrinker.words() | shrinker.numbers() {}
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

    fn try_program(&mut self, program: Vec<u8>) -> bool {
        self.try_case(Case { setup: self.best.setup.clone(), program })
    }

    /// Seven-bit characters instead of the tape's code.
    fn plain_code(&mut self) {
        if self.best.setup.tape.code == TapeCode::Ascii {
            return;
        }
        let mut candidate = self.best.clone();
        candidate.program = tape::decode(&candidate.program, candidate.setup.tape.code);
        candidate.setup.tape.code = TapeCode::Ascii;
        self.try_case(candidate);
    }

    /// Parts of the set-up as they are by default.
    fn setup(&mut self) -> bool {
        const PARTS: &[fn(&mut Setup, &Setup)] = &[
            |setup, plain| *setup = plain.clone(),
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
        let mut run = cut(&self.best.program).len() / 2;
        while run > 0 {
            let mut place = 0;
            loop {
                let mut left = cut(&self.best.program);
                if place >= left.len() {
                    break;
                }
                left.drain(place..(place + run).min(left.len()));
                if self.try_program(left.concat()) {
                    smaller = true;
                } else {
                    place += run;
                }
            }
            run /= 2;
        }
        smaller
    }

    /// Leaves single digits, points, signs and blanks out.
    fn numbers(&mut self) -> bool {
        let mut smaller = false;
        let mut place = self.best.program.len();
        while place > 0 {
            place -= 1;
            let byte = self.best.program.get(place).copied().unwrap_or_default();
            if byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b' ' | b'\r' | b'\t' | b'/') {
                let mut program = self.best.program.clone();
                program.remove(place);
                smaller |= self.try_program(program);
            }
        }
        smaller
    }
}

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

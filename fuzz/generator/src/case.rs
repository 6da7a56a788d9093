//! A case: a program and the set-up that it runs on, from bytes or from a seed.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_oracle::vocabulary::{Feature, Setup, TapeCode};

use crate::builder::Builder;
use crate::choices::Choices;
use crate::print::{self, Style};
use crate::profile::Profile;
use crate::program::Program;
use crate::state::State;
use crate::{contour, cycles, lap, setup, tape, threads};

/// How many bytes a seed is stretched to: enough for a program of the greatest size.
const STRETCHED: usize = 16 * 1024;

/// How many steps a program of raw bytes may take.
const RAW_STEPS: u64 = 3_000;

/// A program and the set-up that it runs on.
#[derive(Clone, PartialEq, Debug)]
pub struct Case {
    /// A valid set-up.
    pub setup: Setup,
    /// The program in the tape code of the set-up.
    pub program: Vec<u8>,
}

impl Case {
    /// How many bytes of raw input choose the set-up.
    pub const SETUP_BYTES: usize = 32;

    /// A case from raw bytes: the first ones choose the set-up (zeros, or none, a plain one), the rest is the
    /// program as it stands, with a limit of its steps.
    #[must_use]
    pub fn from_raw(bytes: &[u8]) -> Self {
        let (choice, program) = bytes.split_at(bytes.len().min(Self::SETUP_BYTES));
        let mut bytes = Unstructured::new(choice);
        let choices = &mut Choices::new(&mut bytes);
        let mut setup = setup::setup(choices, &Profile::FULL);
        if choices.chance(30) {
            threads::set_up(&mut setup, choices, &Profile::FULL);
            contour::set_up(&mut setup, choices);
            cycles::set_up(&mut setup, choices, &Profile::FULL);
            lap::set_up(&mut setup, choices, &Profile::FULL);
        }
        setup.limits.steps = RAW_STEPS;
        Self { setup, program: program.to_vec() }
    }
}

impl<'a> Arbitrary<'a> for Case {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        Ok(case(&mut Choices::new(bytes), Profile::FULL))
    }
}

impl<'a> Arbitrary<'a> for Program {
    /// A program for the default set-up.
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let mut choices = Choices::new(bytes);
        let mut builder = Builder::new(&mut choices, State::new(Setup::default()), Profile::FULL);
        builder.build();
        Ok(builder.finish().0)
    }
}

/// The case of a seed, the same for ever.
#[must_use]
pub fn case_from_seed(seed: u64) -> Case {
    case_from_seed_within(seed, &Profile::FULL)
}

/// The case of a seed that stays within a profile, the same for ever; with everything allowed it is that of
/// [`case_from_seed`].
///
/// Without `tape-code` the program is made of printable characters and LF. Without `alarm` no fault is
/// placed and no byte is changed, yet a motion may still run into an alarm that the generator did not foresee.
/// Without `feed` no motion cuts.
#[must_use]
pub fn case_from_seed_within(seed: u64, profile: &Profile) -> Case {
    let bytes = stretch(seed);
    case(&mut Choices::new(&mut Unstructured::new(&bytes)), *profile)
}

fn case(choices: &mut Choices<'_, '_>, profile: Profile) -> Case {
    let setup = setup::setup(choices, &profile);
    let mut builder = Builder::new(choices, State::new(setup), profile);
    builder.build();
    let has_passes = builder.has_passes();
    let (program, state) = builder.finish();
    let mut setup = state.setup;
    let style = Style::choose(choices, setup.tape.code != TapeCode::Eia, profile);
    let text = print::program(&program, style, choices);
    setup.library = tape::library(print::library(&program, style, choices), setup.tape.code);
    let mut program = tape::encode(&text, setup.tape.code);
    // A cycle with other words may have passes without number.
    let bounded = !has_passes || setup.limits.steps != Setup::default().limits.steps;
    if choices.chance(4) && profile.allows(Feature::Alarm) && bounded {
        corrupt(&mut program, choices);
    }
    let case = Case { setup, program };
    if profile.permits(&case) {
        case
    } else {
        Case { program: tape::encode(&text, case.setup.tape.code), ..case }
    }
}

/// Changes a few bytes.
fn corrupt(program: &mut Vec<u8>, choices: &mut Choices<'_, '_>) {
    const BYTES: &[u8] = b"\n/()=+-*.[],$%: GMXZNOVTE0159SIN\t\r\x00\x7F\xFF";
    for _ in 0..=choices.below(3) {
        let place = choices.below(program.len());
        let byte = choices.pick(BYTES);
        match choices.below(3) {
            _ if program.is_empty() => program.push(byte),
            0 => program[place] = byte,
            1 => program.insert(place, byte),
            _ => drop(program.remove(place)),
        }
    }
}

/// The bytes of a seed: the output of the generator splitmix64.
fn stretch(seed: u64) -> Vec<u8> {
    let mut state = seed;
    let mut bytes = Vec::with_capacity(STRETCHED);
    while bytes.len() < STRETCHED {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bytes.extend_from_slice(&(mixed ^ (mixed >> 31)).to_le_bytes());
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::{Case, Setup, case_from_seed, stretch};
    use arbitrary::{Arbitrary, Unstructured};

    #[test]
    fn a_seed_gives_one_case_and_every_setup_is_valid() {
        for seed in 0..500 {
            let case = case_from_seed(seed);
            assert!(case.setup.validate().is_ok(), "seed {seed}: {:?}", case.setup.validate());
            assert_eq!(case, case_from_seed(seed));
        }
    }

    #[test]
    fn no_bytes_give_a_plain_program() {
        let case = Case::arbitrary(&mut Unstructured::new(&[])).expect("bytes are not needed");
        assert_eq!(case.program.last(), Some(&b'\n'));
    }

    #[test]
    fn zeros_choose_the_default_setup() {
        let mut bytes = vec![0; Case::SETUP_BYTES];
        bytes.extend(b"M02");
        let mut setup = Setup::default();
        setup.limits.steps = super::RAW_STEPS;
        assert_eq!(Case::from_raw(&bytes), Case { setup, program: b"M02".to_vec() });
    }

    #[test]
    fn the_stream_is_splitmix64() {
        // First output for seed 0 in the published reference implementation.
        assert_eq!(stretch(0)[..8], 0xE220_A839_7B1D_CDAF_u64.to_le_bytes());
    }
}

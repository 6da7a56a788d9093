//! What holds for every program and every set-up, said once for fuzzers and tests.
//!
//! A property is a function of bytes. It reads from them what it needs (a program, a set-up, choices of the
//! generator) and says in words what does not hold. A fuzz target calls it and panics on its answer; the
//! tests of this crate call it with the bytes of seeds and with kept regressions, so that each property is
//! exercised wherever `cargo test` runs. Every input is answered: one that gives no case holds.

mod bores;
mod contour_pairs;
mod contours;
mod cutters;
mod cycles;
mod differential;
mod expression;
mod lap;
mod lap_cuts;
mod lap_draw;
mod lap_job;
mod lap_pairs;
mod lap_passes;
mod lap_plane;
mod lap_programs;
mod lap_shape;
mod lap_strokes;
#[cfg(test)]
mod lap_tests;
mod lap_threads;
mod metamorphic;
mod parse;
mod path;
mod perturbation;
mod plane;
mod round_trip;
mod seed;
mod setup;
mod shape;
mod termination;
mod thread_counts;
mod threads;
mod trace;
mod tree_text;

pub use seed::bytes_of_seed;

/// What a property says about an input: nothing when it holds, else what is wrong.
pub type Verdict = Result<(), String>;

/// A property under the name of its fuzz target.
#[derive(Clone, Copy, Debug)]
pub struct Property {
    /// The name.
    pub name: &'static str,
    /// Whether it holds for an input.
    pub holds: fn(&[u8]) -> Verdict,
}

/// Every property.
pub const PROPERTIES: &[Property] = &[
    Property { name: "structured", holds: differential::generated_programs_agree },
    Property { name: "raw", holds: differential::any_bytes_agree },
    Property { name: "parse", holds: parse::texts_are_read_in_order },
    Property { name: "round_trip", holds: round_trip::spelling_does_not_matter },
    Property { name: "setup", holds: setup::setup_files_read_back },
    Property { name: "trace", holds: trace::traces_read_back },
    Property { name: "expression", holds: expression::expressions_agree },
    Property { name: "termination", holds: termination::programs_end },
    Property { name: "perturbation", holds: perturbation::a_small_change_moves_little },
    Property { name: "threads", holds: threads::threads_are_whole },
    Property { name: "contours", holds: contours::contours_are_true },
    Property { name: "lap", holds: lap::rough_turning_is_true },
    Property { name: "cycles", holds: cycles::holes_are_whole },
    Property { name: "metamorphic", holds: metamorphic::rewritten_programs_do_the_same },
];

/// The property of this name.
#[must_use]
pub fn property(name: &str) -> Option<&'static Property> {
    PROPERTIES.iter().find(|property| property.name == name)
}

/// What a fuzz target does with an input.
///
/// # Panics
/// When the property of this name does not hold, or when there is none.
#[allow(clippy::panic)]
pub fn assert_holds(name: &str, input: &[u8]) {
    match property(name).map(|property| (property.holds)(input)) {
        Some(Ok(())) => {}
        Some(Err(message)) => panic!("{name}: {message}"),
        None => panic!("no property {name}"),
    }
}

/// Says in words what does not hold.
fn require(holds: bool, message: impl FnOnce() -> String) -> Verdict {
    if holds { Ok(()) } else { Err(message()) }
}

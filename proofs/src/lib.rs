//! Theorems about the integer arithmetic of the engine, of the oracle and of the vocabulary.
//!
//! Each theorem is one function: a harness for the model checker, which proves it for all inputs within
//! its bound, and a property test, which samples it wherever `cargo test` runs. Its doc comment is the
//! statement in plain English. Every family has a refuted twin, a false statement that must be caught, so
//! that a harness that could not fail would be noticed. `README.md` tabulates them.

#[cfg(any(kani, test))]
#[macro_use]
mod harness;
#[cfg(all(any(kani, test), stand_in))]
pub mod kani;

/// Declares the families, which exist for the model checker and for the tests alone.
macro_rules! families {
    ($($name:ident)*) => { $(#[cfg(any(kani, test))] pub mod $name;)* };
}

families! {
    draw areas bores contours corners counts decimals feeds frame infeeds labels leads levels limits modal noses places products
    reading_sets rectangles roots rounding rule_sets run_outs segments sequence_names sides signs speeds surds
    thread_courses tools turns units words
}

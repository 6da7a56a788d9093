//! Turns a statement into a model-checking harness and a property test.
//!
//! The doc comment of a statement is its theorem, then a line `Of:` with the functions that it is about, a line
//! `Assumes:` with its bounds, and a line `Rules:` with the rules that it supports. `#[unwind(n)]` bounds the loops
//! for the model checker, at least one more than the longest loop turns.

/// Statements that hold.
macro_rules! theorems {
    ($($(#[doc = $doc:literal])+ #[unwind($unwind:literal)] fn $name:ident() $body:block)+) => {
        $(
            $(#[doc = $doc])+
            #[cfg_attr(not(stand_in), kani::proof, kani::unwind($unwind))]
            pub fn $name() $body
        )+

        #[cfg(test)]
        mod theorems {
            $(#[test] fn $name() { $crate::kani::holds(super::$name); })+
        }
    };
}

/// Statements that do not hold: the model checker and the property test must both find a counterexample.
macro_rules! refutations {
    ($($(#[doc = $doc:literal])+ #[unwind($unwind:literal)] fn $name:ident() $body:block)+) => {
        $(
            $(#[doc = $doc])+
            #[cfg_attr(not(stand_in), kani::proof, kani::unwind($unwind), kani::should_panic)]
            pub fn $name() $body
        )+

        #[cfg(test)]
        mod refutations {
            $(#[test] fn $name() { $crate::kani::fails(super::$name); })+
        }
    };
}

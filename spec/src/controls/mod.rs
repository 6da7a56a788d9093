//! What distinguishes one control from another: tables and choices, no code paths.

pub mod e100l;

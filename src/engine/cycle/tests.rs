//! Cycles on the engine, beyond the examples of the rule texts.

//! What a machine with two saddles refuses because nobody tells how it goes together with two sides (E100L-AX4-12).

use crate::fault::{Fault, Outcome};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, MachineType, Setup};

/// Whether the machine has two saddles.
pub fn has_two_saddles(setup: &Setup) -> bool {
    setup.machine.r#type == MachineType::TwoSaddles
}

/// E100L-AX4-12: a variable, of which nobody tells whose it is, or a statement.
pub fn is_described(name: &str, setup: &Setup) -> Outcome<()> {
    if has_two_saddles(setup) {
        return Err(Fault::about(AlarmName::Unspecified, AX4_12, name));
    }
    Ok(())
}

//! What a cycle does, one act after the other: motions, M codes of its own (E100L-MCYC-10, E100L-TAP-02), dwells.

use super::motion::{Go, carry_out};
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::modal::{Plan, by_cycle, turning_speed};
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Duration};

/// An act.
#[derive(Clone, Copy, Debug)]
pub enum Act {
    /// A motion.
    Go(Go),
    /// An M code.
    Code(u16, Cited),
    /// An M code that starts the main spindle, which must have a speed (E100L-TAP-04).
    Start(u16, Cited),
    /// A dwell.
    Dwell(Duration, Cited),
    /// The next cutting pass begins (E100L-GOTO-03).
    Pass,
}

impl Act {
    /// Carries it out; its event, if it has one.
    pub fn carry_out(self, plan: &Plan, state: &mut State) -> Outcome<Option<Emission>> {
        match self {
            Self::Go(go) => carry_out(&go, plan, state),
            Self::Code(code, cited) => Ok(Some(citing(by_cycle(code, state), cited))),
            Self::Start(code, cited) => {
                let event = by_cycle(code, state);
                if turning_speed(state).is_none_or(|turning| turning.speed.0 == 0) {
                    return Err(Fault::about(AlarmName::Unspecified, TAP_04, "speed"));
                }
                Ok(Some(citing(event, cited)))
            }
            Self::Dwell(time, cited) => {
                Ok(Some(Emission::new(Action::Dwell { time }, cited.rules).readings(cited.readings)))
            }
            Self::Pass => Ok(None),
        }
    }
}

fn citing(event: Emission, cited: Cited) -> Emission {
    event.rules(cited.rules).readings(cited.readings)
}

//! What the events of the cycles of driven tools cite (E100L-MCYC-01 to -22 and the rules of each cycle).

use super::block::{CycleBlock, Role, is_synchronised};
use super::motion::Axis;
use crate::contour;
use crate::modal::Plan;
use crate::state::State;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Part, RuleId, RuleSet, Setup};

/// The rule of a cycle code; none for other codes.
fn rules_of(code: u16) -> &'static [RuleId] {
    match code {
        178 => &[STAP_01],
        179 => &[STAP_01, STAP_03],
        180 => &[MCYC_02, MCYC_12],
        181 => &[G181_01],
        182 => &[G182_01],
        183 => &[G183_01],
        184 => &[G184_01],
        185 => &[CTHR_02],
        186 => &[CTHR_03],
        187 => &[CTHR_04],
        188 => &[CTHR_05],
        189 => &[G189_01],
        190 => &[G190_01],
        _ => &[],
    }
}

/// What the `mode` event of a cycle code cites besides E100L-GCODE-02; nothing for other codes.
pub fn mode_rules(code: u16) -> RuleSet {
    match rules_of(code) {
        [] => RuleSet::EMPTY,
        own => RuleSet::of(own).with(MCYC_01),
    }
}

/// The rule of a cycle, which its events cite.
pub fn of_cycle(code: u16, setup: &Setup) -> Cited {
    Cited::rules(match code {
        178 => &[STAP_02],
        179 => &[STAP_02, STAP_03],
        184 if is_synchronised(code, setup) => &[STAP_02, G184_02],
        190 => &[G190_01, G190_02],
        _ => rules_of(code),
    })
}

/// What the events of a block name.
#[derive(Clone, Copy, Debug)]
pub struct Cites {
    /// The rule of the cycle.
    cycle: Cited,
    /// Motions, dwells: every event but those of M codes.
    all: Cited,
    /// The cut of a hole.
    cut: Cited,
    /// The way to a point of the face in conversion mode (E100L-CSC-09).
    converted: Cited,
    /// Motions with a pass.
    passes: Cited,
    /// The way out of a hole and back (E100L-G183-02).
    discharge: Cited,
    /// Taps.
    tap: Cited,
    /// The way out at a feed.
    exit: Cited,
    /// The dwell.
    dwell: Cited,
}

impl Cites {
    /// Those of a block of a hole cycle; `depth`: the bottom is given by R.
    pub fn of_holes(block: CycleBlock, axis: Axis, depth: bool, plan: &Plan, state: &State) -> Self {
        let (CycleBlock { code, .. }, setup) = (block, state.setup);
        let has = |code| plan.words.m.contains(&code);
        let (side, readings) = (axis == Axis::X, &setup.readings);
        let own_axis = Cited::rules(&[if side { MCYC_08 } else { MCYC_07 }]);
        let on_x = Cited::default().reading(readings.peck_retract);
        Self {
            all: of_block(block, setup).and_if(code != 190, own_axis),
            cut: Cited::rules(&[MCYC_03])
                .and_if(depth, Cited::rules(&[MCYC_22]))
                .and_if(is_unclamped(plan), Cited::rules(&[MCYC_18]))
                // E100L-MCYC-19: it changes no path.
                .and_if(code == 184 && !is_synchronised(code, setup) && has(140), Cited::rules(&[MCYC_19])),
            converted: Cited { rules: contour::converted(plan, state).with(CSC_09), ..Cited::default() },
            passes: Cited::default().and_if(side, on_x),
            discharge: Cited::rules(&[G183_02]).reading(readings.chip_discharge),
            tap: Cited::rules(&[STAP_01]).and_if(side, Cited::default().reading(readings.feed_length)),
            exit: Cited::default().and_if(matches!(code, 184 | 189), Cited::rules(&[MCYC_03])),
            dwell: Cited::rules(&[DWELL_02]).and_if(code == 183, Cited::rules(&[G183_03])),
            cycle: of_cycle(code, setup),
        }
    }

    /// An M code that the cycle carries out (E100L-MCYC-10).
    pub fn code(&self) -> Cited {
        self.cycle.and(Cited::rules(&[MCYC_10]))
    }

    /// The dwell at the bottom.
    pub fn dwell(&self) -> Cited {
        self.all.and(self.dwell)
    }

    /// The way along the slot back to its beginning.
    pub fn back(&self) -> Cited {
        self.all
    }

    /// A motion of a hole; `again`: another one of Q came before it.
    pub fn motion(&self, part: Part, again: bool) -> Cited {
        let own = match part {
            Part::Position => Cited::default().and_if(again, Cited::rules(&[MCYC_20])),
            Part::Approach => Cited::rules(&[MCYC_05]).and_if(again, Cited::rules(&[MCYC_17])),
            Part::Cut | Part::Finish => self.cut,
            Part::Exit => self.exit,
            Part::Return => Cited::rules(&[MCYC_15]),
            _ => Cited::default(),
        };
        self.all.and(own)
    }

    /// The way to a point of the face in conversion mode.
    pub fn converted(&self) -> Cited {
        self.motion(Part::Position, false).and(self.converted)
    }

    /// The return after a way out at a feed (E100L-MCYC-16).
    pub fn return_after_exit(&self) -> Cited {
        self.motion(Part::Return, false).and(Cited::rules(&[MCYC_16]))
    }

    /// A motion of a deep hole, in one of its passes.
    pub fn peck(&self, part: Part) -> Cited {
        let out = matches!(part, Part::Withdraw | Part::Reentry);
        self.motion(part, false).and(self.passes).and_if(out, self.discharge)
    }

    /// A motion of a tap.
    pub fn tap(&self, part: Part) -> Cited {
        self.motion(part, false).and(self.tap)
    }

    /// A motion of a key way, in one of its passes; `retracts`: M211 is in force.
    pub fn key_way(&self, part: Part, retracts: bool) -> Cited {
        self.motion(part, false).and_if(retracts, self.passes)
    }
}

/// What every motion of a block names.
pub fn of_block(block: CycleBlock, setup: &Setup) -> Cited {
    let follows = block.role == Role::FollowUp;
    of_cycle(block.code, setup).and_if(follows, Cited::rules(&[MCYC_09]))
}

/// E100L-MCYC-18: C is neither clamped nor released.
pub fn is_unclamped(plan: &Plan) -> bool {
    plan.words.m.iter().any(|code| matches!(code, 141 | 169))
}

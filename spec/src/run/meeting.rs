//! Both sides wait, or one waits and the other one has ended: who goes on (E100L-PSYNC-03 to -06, E100L-PSYNC-08,
//! E100L-M100-01, E100L-M100-03, E100L-M100-05), and what two blocks that start together must have in common
//! (E100L-AX4-06).

use std::cmp::Ordering;

use super::saddles::Saddles;
use super::side::{At, Left, Rest, SideProgram, Status};
use crate::emission::Emission;
use crate::fault::{Outcome, fail};
use crate::modal::Words;
use crate::saddle::{Commands, CommonWords};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Action, AlarmName, Place, ReleaseCause, RuleId, RuleSet, Side};

impl Saddles<'_> {
    /// Every pair of states has its row, so that the sides cannot wait for each other for ever.
    pub(super) fn meet(&mut self, place: &mut Place, decided: &mut Vec<(Place, Emission)>) -> Outcome<()> {
        let (a, b) = (self.a.waits_at(), self.b.waits_at());
        let (released, cause, rule): (&[Side], ReleaseCause, RuleId) = match (a, b) {
            (Some(At::P(p)), Some(At::P(q))) => match p.cmp(&q) {
                Ordering::Less => (&[Side::A], ReleaseCause::Smaller, PSYNC_03),
                Ordering::Greater => (&[Side::B], ReleaseCause::Smaller, PSYNC_03),
                Ordering::Equal => (&[Side::A, Side::B], ReleaseCause::Equal, PSYNC_03),
            },
            (Some(At::P(_)), Some(At::M100)) => (&[Side::B], ReleaseCause::PCode, M100_05),
            (Some(At::M100), Some(At::P(_))) => (&[Side::A], ReleaseCause::PCode, M100_05),
            (Some(At::M100), Some(At::M100)) => (&[Side::A, Side::B], ReleaseCause::Counterpart, M100_01),
            (Some(at), None) => (&[Side::A], ReleaseCause::OtherEnded, end_rule(at)),
            (None, Some(at)) => (&[Side::B], ReleaseCause::OtherEnded, end_rule(at)),
            // Both have ended: they do not meet.
            (None, None) => return Ok(()),
        };
        match cause {
            ReleaseCause::Smaller => {
                for side in released {
                    alone_without_common_words(self.enter(*side), place)?;
                }
            }
            ReleaseCause::Equal => self.start_together(place)?,
            ReleaseCause::PCode | ReleaseCause::Counterpart | ReleaseCause::OtherEnded => {}
        }
        for side in released {
            let program = self.enter(*side);
            decided.extend(release(program, cause, rule));
        }
        Ok(())
    }

    /// E100L-AX4-06: two blocks of the same P have the same common words, which the block of side A carries out. The two
    /// blocks come first, that of A before that of B (E100L-PSYNC-03).
    fn start_together(&mut self, place: &mut Place) -> Outcome<()> {
        let common = |program: &SideProgram| waiting_words(program).map(CommonWords::of);
        if common(&self.a) != common(&self.b) {
            return sides_differ(self.enter(Side::A), place);
        }
        for (program, commands) in [(&mut self.a, Commands::ForBoth), (&mut self.b, Commands::ByOther)] {
            if let Status::Waiting(_, Rest { left: Left::All(words), .. }) = &mut program.status {
                words.commands = commands;
            }
        }
        self.together = [Side::A, Side::B].into();
        Ok(())
    }
}

/// The rule of a release by the end of the other side.
fn end_rule(at: At) -> RuleId {
    match at {
        At::P(_) => PSYNC_04,
        At::M100 => M100_03,
    }
}

/// The words of the block in which a side waits at P.
fn waiting_words<'p>(program: &'p SideProgram) -> Option<&'p Words> {
    match &program.status {
        Status::Waiting(_, Rest { left: Left::All(words), .. }) => Some(words),
        _ => None,
    }
}

/// E100L-AX4-06: a block that starts without a fellow has no common word.
fn alone_without_common_words(program: &SideProgram, place: &mut Place) -> Outcome<()> {
    match waiting_words(program) {
        Some(words) if !CommonWords::of(words).is_empty() => sides_differ(program, place),
        _ => Ok(()),
    }
}

fn sides_differ(program: &SideProgram, place: &mut Place) -> Outcome<()> {
    if let Status::Waiting(_, rest) = &program.status {
        *place = rest.block.place;
    }
    fail(AlarmName::SidesDiffer, AX4_06)
}

/// A side goes on: its event.
fn release(program: &mut SideProgram, cause: ReleaseCause, rule: RuleId) -> Option<(Place, Emission)> {
    match std::mem::replace(&mut program.status, Status::Ended) {
        Status::Waiting(at, rest) => {
            if cause == ReleaseCause::OtherEnded {
                program.channel.state.set_alone(true);
            }
            let place = rest.block.place;
            program.status = Status::Ready(Some(rest));
            let (p, code) = at.keys();
            let event = Emission::new(Action::Release { p, code, cause }, RuleSet::of(&[rule]));
            Some((place, event.of(program.side())))
        }
        other => {
            program.status = other;
            None
        }
    }
}

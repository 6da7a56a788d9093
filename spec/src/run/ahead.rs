//! What look-ahead sees: the blocks behind a corner (E100L-ANG-05, E100L-ANG-06).

use super::channel::Channel;
use super::definition::refuse_content;
use super::reading::{Block, Content};
use crate::fault::{Fault, Outcome};
use crate::lap;
use crate::modal::{self, Before, Plan};
use crate::path::{self, Ahead};
use crate::task::Registration;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, Chamfering, Setup};

impl Channel<'_> {
    /// What a corner needs of the blocks behind it: evaluated once, and kept for their turn.
    pub(super) fn look_ahead(&mut self, plan: &Plan) -> Outcome<Vec<Ahead>> {
        let mut ahead = Vec::new();
        if !plan.is_angle_only() && !is_any_angle_chamfer(plan, self.setup) {
            return Ok(ahead);
        }
        // The needing block leads away from a displacement that was left over.
        let before = Before { modes: self.state.modes, after_angle: plan.is_angle_only(), ..self.ahead() };
        ahead.extend(self.peek(0, plan, before)?);
        let (next, place) = path::next_block(plan, &ahead)?;
        // E100L-ANG-06: an angle-only line ends on the line of the block after it; when that line is the one
        // behind a corner, its own end needs one block more.
        if next.is_angle_only() && !plan.is_angle_only() {
            let next = next.clone();
            let before = Before { modes: next.modes, after_angle: true, ..self.ahead() };
            let further = self.peek(1, &next, before)?;
            path::next_block(&next, further.as_slice()).map_err(|fault| fault.of_block(place))?;
            ahead.extend(further);
        }
        Ok(ahead)
    }

    fn ahead(&self) -> Before {
        Before { left_over: false, ..self.before() }
    }

    /// The block `index` places further, checked as one that comes after this; none if there is nothing that a
    /// corner could be computed from.
    fn peek(&mut self, index: usize, needing: &Plan, before: Before) -> Outcome<Option<Ahead>> {
        if needing.words.has_g(80) {
            // The block with G80 is the last one of its definition (E100L-LAP-01).
            return Ok(None);
        }
        let called = self.calls.depth();
        let program = self.calls.running_mut();
        let Some(Block { place, content, .. }) = self.reader.ahead(index, program)? else { return Ok(None) };
        let place = *place;
        if let Some(definition) = &self.state.lap.definition {
            refuse_content(content, definition.in_called(called), &self.state)
                .map_err(|fault| fault.of_block(place))?;
        }
        let words = match content {
            Content::Statement(statement) => {
                let rule = if needing.is_chamfer() { ANG_05 } else { ANG_06 };
                let fault = Fault::about(AlarmName::Unspecified, rule, statement.label().as_str());
                return Err(fault.of_block(place));
            }
            Content::Items(items) => {
                if items.iter().any(|item| item.kind.is_assignment()) {
                    return Ok(None);
                }
                // Without assignments nothing is registered.
                let nothing = Registration::Change { program: 0 };
                let words = modal::evaluate(items, nothing, &mut self.state, &mut Vec::new())
                    .map_err(|fault| fault.of_block(place))?;
                *content = Content::Words(Box::new(words.clone()));
                lap::refuse_words(&words, true, &self.state).map_err(|fault| fault.of_block(place))?;
                words
            }
            Content::ContourCall(contour, items) => {
                if items.iter().any(|item| item.kind.is_assignment()) {
                    return Ok(None);
                }
                let nothing = Registration::Change { program: 0 };
                modal::evaluate_call(*contour, items, nothing, &mut self.state, &mut Vec::new())
                    .map_err(|fault| fault.of_block(place))?
            }
            Content::Words(words) => words.as_ref().clone(),
            Content::Nothing | Content::Name | Content::Turret(_) | Content::Communication(_) => {
                return Ok(None);
            }
        };
        let before = Before { has_contour: self.has_contour(&words), ..before };
        let plan = modal::check(words, before, &self.state);
        plan.map(|plan| Some(Ahead { plan, place })).map_err(|fault| fault.of_block(place))
    }
}

fn is_any_angle_chamfer(plan: &Plan, setup: &Setup) -> bool {
    plan.is_chamfer() && setup.parameters.chamfering == Chamfering::AnyAngle
}

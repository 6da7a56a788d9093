//! Lathe auto-programming, G80 to G88: which definitions and calls the generator writes.
//!
//! A run of LAP is one definition with the calls that name it. [`ready`] ends what would forbid a call and goes to the AP
//! start. [`plan`] draws a contour in the plane of the cycle, where heights rise from the workpiece and runs go along
//! the cut, [`place`] finds room for it on the machine, [`definition`] writes its blocks and [`call`] the calls.

mod call;
mod definition;
mod place;
mod plan;
mod ready;
mod setup;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::profile::Profile;
use crate::program::Line;
use crate::state::Mode;

use call::Call;
use place::Place;
use plan::Plan;
pub(crate) use setup::{is_set_up, set_up};

/// What the generator keeps of LAP.
#[derive(Clone, Default, Debug)]
pub struct Lap {
    /// Definitions that are to stand behind the end of the program.
    behind: Vec<Line>,
    /// Whether the program has a definition.
    pub(crate) written: bool,
}

/// Whether a profile has something for LAP.
pub(crate) fn is_within(profile: &Profile) -> bool {
    [Feature::Lap, Feature::Feed, Feature::Rapid, Feature::Linear, Feature::SequenceName]
        .iter()
        .all(|feature| profile.allows(*feature))
}

/// How often a contour is drawn for which there may be no room.
const ATTEMPTS: usize = 6;

impl Builder<'_, '_, '_> {
    /// A definition and its calls, or a positioning where there can be none.
    pub(crate) fn lap(&mut self) {
        if !self.ready_for_lap() {
            return self.line(Mode::Rapid);
        }
        for _ in 0..ATTEMPTS {
            let plan = Plan::draw(self);
            if let Some(place) = Place::find(self, &plan) {
                return self.run_of_lap(&plan, &place);
            }
        }
        self.line(Mode::Rapid);
    }

    fn run_of_lap(&mut self, plan: &Plan, place: &Place) {
        self.settle_label();
        let Some(name) = self.sequence_name() else { return self.line(Mode::Rapid) };
        self.state.lap.written = true;
        let calls = Call::draw(self, plan);
        let before = self.lines.len();
        let state = self.state.clone();
        // An arc that ends at the height of its centre bears no doubt about an expression.
        let expressions = self.expressions;
        self.expressions = if self.choices.chance(85) { 0 } else { expressions };
        self.definition(&name, plan, place, calls.contains(&Call::Finish));
        self.expressions = expressions;
        // What a definition does to the modes comes with its calls.
        let (names, threads) = (self.state.names.clone(), self.state.threads.clone());
        self.state = state;
        self.state.names = names;
        let definition = self.lines.split_off(before);
        let plain = self.nesting == 0 && self.profile.is_full() && !self.state.setup.schedule;
        let place_of_text = self.choices.below(if plain { 5 } else { 3 });
        if place_of_text < 2 {
            self.lines.extend(definition.iter().cloned());
        }
        for (number, call) in calls.iter().enumerate() {
            self.lap_call(*call, number > 0, &name, plan, place);
        }
        if calls.contains(&Call::Finish) {
            self.state.threads = threads;
            self.state.threads.forget_feed();
        }
        match place_of_text {
            0 | 1 => {}
            2 => self.lines.extend(definition),
            _ => self.state.lap.behind.extend(definition),
        }
    }

    /// Adds the definitions that stand behind the end of the program; whether there are any.
    pub(crate) fn definitions_behind(&mut self) -> bool {
        let mut behind = std::mem::take(&mut self.state.lap.behind);
        let any = !behind.is_empty();
        self.lines.append(&mut behind);
        any
    }
}

//! The stream of events of a block on its way to the trace (E100L-NRC-12).

use crate::emission::Emission;
use crate::vocabulary::Place;

/// The events of a block, and where decided ones go.
pub struct Stream<'a> {
    /// The block.
    pub place: Place,
    /// Its events so far that are not decided.
    pub emissions: Vec<Emission>,
    /// Whether an alarm drops them.
    pub holding: bool,
    decided: &'a mut Vec<(Place, Emission)>,
}

impl<'a> Stream<'a> {
    /// The stream of a block that begins. `holding`: compensation is in force.
    pub fn new(place: Place, holding: bool, decided: &'a mut Vec<(Place, Emission)>) -> Self {
        Self { place, emissions: Vec::new(), holding, decided }
    }

    /// Sends a decided event on.
    pub fn decide(&mut self, event: (Place, Emission)) {
        self.decided.push(event);
    }

    /// Takes the events of the block so far, each with its place.
    pub fn take(&mut self) -> impl Iterator<Item = (Place, Emission)> + use<> {
        let place = self.place;
        std::mem::take(&mut self.emissions).into_iter().map(move |event| (place, event))
    }

    /// What the block has emitted so far is decided.
    pub fn flush(&mut self) {
        let events = self.take();
        self.decided.extend(events);
    }

    /// The end of the block: what is not held is decided, what is still held was dropped by an alarm.
    pub fn close(mut self) {
        if !self.holding {
            self.flush();
        }
    }
}

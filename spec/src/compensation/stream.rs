//! The stream of events of a block on its way to the trace (E100L-NRC-12).

use crate::emission::Emission;
use crate::vocabulary::{Place, Side};

/// The events of a block, and where decided ones go.
pub struct Stream<'a> {
    /// The block.
    pub place: Place,
    /// The turret or the saddle of its events, where they tell it.
    side: Option<Side>,
    /// Its events so far that are not decided.
    pub emissions: Vec<Emission>,
    /// Whether an alarm drops them.
    pub holding: bool,
    decided: &'a mut Vec<(Place, Emission)>,
}

impl<'a> Stream<'a> {
    /// The stream of a block that begins. `holding`: compensation is in force.
    pub fn new(
        place: Place,
        side: Option<Side>,
        holding: bool,
        decided: &'a mut Vec<(Place, Emission)>,
    ) -> Self {
        Self { place, side, emissions: Vec::new(), holding, decided }
    }

    /// Sends a decided event on.
    pub fn decide(&mut self, (place, event): (Place, Emission)) {
        self.decided.push((place, with_side(event, self.side)));
    }

    /// Takes the events of the block so far, each with its place.
    pub fn take(&mut self) -> impl Iterator<Item = (Place, Emission)> + use<> {
        let (place, side) = (self.place, self.side);
        std::mem::take(&mut self.emissions).into_iter().map(move |event| (place, with_side(event, side)))
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

/// E100L-MIRR-01, E100L-AX4-01: an event is one of the side of its block, unless it knows another.
fn with_side(event: Emission, side: Option<Side>) -> Emission {
    let known = event.side.or(side);
    event.of(known)
}

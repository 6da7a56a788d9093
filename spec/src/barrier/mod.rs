//! Chuck and tailstock barriers: areas that the programmed point must not enter (E100L-BARR-01 to -09).
//!
//! [`watch`] says which barriers watch a block, [`area`] what they keep free, [`path`] what of a motion they look at;
//! [`mod@line`] and [`arc`] decide whether it enters a [`rectangle`], on exact numbers ([`surd`]).

mod arc;
mod line;
mod path;
mod rectangle;
#[cfg(test)]
mod samples;
mod surd;
mod watch;

pub use watch::Watch;

use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::integer::area::{self, Bounds};
use crate::path::{Element, Shape};
use crate::state::State;
use crate::vocabulary::AlarmName;
use crate::vocabulary::rule_ids::*;
use path::Path;
use rectangle::Rectangle;

/// Whether a barrier that is on looks at a motion: one that has or computes X or Z.
fn is_watched(element: &Element, state: &State) -> bool {
    element.in_plane() && (state.watch.chuck || state.watch.tailstock)
}

/// E100L-BARR-01: refuses a motion from and to these program coordinates whose path has a point in an area.
pub fn check(element: &Element, from: Amounts, to: Amounts, state: &State) -> Outcome<()> {
    if !is_watched(element, state) {
        return Ok(());
    }
    let path = Path::of(element.shape, (from.x, from.z), (to.x, to.z), state.setup.readings.barrier_path);
    let data = &state.memory.barriers;
    if state.watch.chuck {
        keep_out(&path, &area::chuck(data), "chuck")?;
    }
    if state.watch.tailstock {
        keep_out(&path, &area::tailstock(data), "tailstock")?;
    }
    Ok(())
}

fn keep_out(path: &Path, area: &[Option<Bounds>], barrier: &str) -> Outcome<()> {
    if area.iter().flatten().any(|bounds| path.enters(&Rectangle::new(bounds.z, bounds.x))) {
        return Err(Fault::about(AlarmName::Barrier, BARR_01, barrier));
    }
    Ok(())
}

/// The event of a motion that was tested.
pub fn tested(event: Emission, element: &Element, state: &State) -> Emission {
    if !is_watched(element, state) {
        return event;
    }
    let event = event.rule_if(true, BARR_01);
    if element.shape == Shape::Rapid {
        event.rule_if(true, BARR_08).reading(state.setup.readings.barrier_path)
    } else {
        event
    }
}

//! What each turret has for itself (E100L-MIRR-11, E100L-MIRR-18).

use std::mem::swap;

use crate::frame::{Amounts, offsets_by_number};
use crate::state::State;
use crate::task::nose_radii_by_number;
use crate::vocabulary::Setup;

/// The data of a turret. C and W have one zero offset and one zero shift, whichever turret is selected.
#[derive(Clone, Debug)]
pub struct OwnData {
    zero_offset: (i64, i64),
    zero_shift: (i64, i64),
    tool_offsets: Vec<Amounts>,
    offset_number: u8,
    nose_radii: Vec<(i64, i64)>,
    tool: u8,
    nose: u8,
}

impl OwnData {
    /// Those of turret B, or of saddle B, at the start: no tool, no shift.
    pub fn of_b(setup: &Setup) -> Self {
        let (data, sets) = (&setup.turret_b, setup.options.offset_sets);
        Self {
            zero_offset: (data.zero_offset.x.0, data.zero_offset.z.0),
            zero_shift: (0, 0),
            tool_offsets: offsets_by_number(&data.tool_offset, sets),
            offset_number: 0,
            nose_radii: nose_radii_by_number(&data.nose_radius, sets),
            tool: 0,
            nose: 0,
        }
    }

    /// Takes the place of the data in force, which are kept here instead.
    pub fn exchange(&mut self, state: &mut State) {
        let frame = &mut state.frame;
        swap_plane(&mut self.zero_offset, &mut frame.zero_offset);
        swap_plane(&mut self.zero_shift, &mut frame.zero_shift);
        swap(&mut self.tool_offsets, &mut frame.tool_offsets);
        swap(&mut self.offset_number, &mut frame.offset_number);
        swap(&mut self.nose_radii, &mut state.memory.nose_radii);
        swap(&mut self.tool, &mut state.tool);
        swap(&mut self.nose, &mut state.nose);
    }

    /// Clears the zero shift; whether there was one (E100L-G50-05).
    pub fn clear_shift(&mut self) -> bool {
        std::mem::take(&mut self.zero_shift) != (0, 0)
    }
}

fn swap_plane(own: &mut (i64, i64), in_force: &mut Amounts) {
    swap(&mut own.0, &mut in_force.x);
    swap(&mut own.1, &mut in_force.z);
}

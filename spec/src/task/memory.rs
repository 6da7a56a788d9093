//! What variables hold besides the frame: common and local variables, and plain stores.

use super::communication::Areas;
use super::inputs::Readings;
use super::interference::Interference;
use super::locals::Locals;
use super::outputs::Comment;
use crate::controls::e100l::system_variables::{Axis, BarrierDatum};
use crate::vocabulary::{Barriers, Length, NoseRadius, Setup};

/// The memory of a control.
#[derive(Clone, Debug)]
pub struct Memory {
    common: Vec<f64>,
    /// Local variables.
    pub locals: Locals,
    /// Nose radius amounts by number: X and Z, in nanometres.
    pub nose_radii: Vec<(i64, i64)>,
    /// Barrier data: those of the machine, and those that the program can change (E100L-SVAR-08).
    pub barriers: Barriers,
    /// Permissible droop of X, Z and C, in increments.
    pub droop: [u16; 3],
    /// Pitch error compensation by number: X and Z, in nanometres.
    pub pitch_errors: Vec<(i64, i64)>,
    /// Pitch of X and Z, in nanometres.
    pub pitch: (i64, i64),
    /// Tool interference data.
    pub interference: Interference,
    /// How far the inputs were read.
    pub inputs: Readings,
    /// The comment of user alarms.
    pub comment: Comment,
    /// The areas of data communication.
    pub areas: Areas,
}

impl Memory {
    /// The memory of a set-up: what common variables hold is handed in (E100L-CVAR-03).
    pub fn new(setup: &Setup) -> Self {
        let mut common = vec![0.0; 201];
        for (name, value) in &setup.variables {
            let number = name.get(1..).and_then(|digits| digits.parse::<usize>().ok());
            if let Some(slot) = number.and_then(|number| common.get_mut(number)) {
                *slot = *value + 0.0;
            }
        }
        Self {
            common,
            locals: Locals::default(),
            nose_radii: nose_radii_by_number(&setup.nose_radius, setup.options.offset_sets),
            barriers: setup.barriers,
            droop: [setup.droop.x, setup.droop.z, setup.droop.c],
            pitch_errors: vec![(0, 0); 121],
            pitch: (0, 0),
            interference: Interference::new(setup),
            inputs: Readings::default(),
            comment: Comment::default(),
            areas: Areas::default(),
        }
    }

    /// E100L-GPUT-04, E100L-GPUT-11, E100L-VUACM-01: what the reset takes back to the beginning.
    pub fn reset(&mut self) {
        self.areas.reset();
        self.comment = Comment::default();
    }

    /// E100L-CVAR-02: one set for all programs.
    pub fn common(&self, number: u8) -> f64 {
        self.common.get(usize::from(number)).copied().unwrap_or_default()
    }

    /// Sets a common variable; it holds no negative zero.
    pub fn set_common(&mut self, number: u8, value: f64) -> f64 {
        let value = value + 0.0;
        if let Some(slot) = self.common.get_mut(usize::from(number)) {
            *slot = value;
        }
        value
    }
}

/// Nose radius amounts by number; number 0, and those without an entry, hold zero.
pub fn nose_radii_by_number(entries: &[NoseRadius], sets: u8) -> Vec<(i64, i64)> {
    let mut radii = vec![(0, 0); usize::from(sets) + 1];
    for entry in entries {
        if let Some(slot) = radii.get_mut(usize::from(entry.number)) {
            *slot = (entry.x.0, entry.z.0);
        }
    }
    radii
}

/// The member of an X-Z pair.
pub fn of_pair(pair: (i64, i64), axis: Axis) -> i64 {
    if axis == Axis::X { pair.0 } else { pair.1 }
}

/// The member of an X-Z pair, to be set.
pub fn of_pair_mut(pair: &mut (i64, i64), axis: Axis) -> &mut i64 {
    if axis == Axis::X { &mut pair.0 } else { &mut pair.1 }
}

/// Place of an axis among the droops.
pub fn droop_index(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Z => 1,
        Axis::C | Axis::W => 2,
    }
}

/// A barrier datum, in nanometres.
pub fn barrier_datum(barriers: &Barriers, datum: BarrierDatum) -> i64 {
    let mut barriers = *barriers;
    barrier_datum_mut(&mut barriers, datum).0
}

/// A barrier datum, to be set.
pub fn barrier_datum_mut(barriers: &mut Barriers, datum: BarrierDatum) -> &mut Length {
    match datum {
        BarrierDatum::GripLength => &mut barriers.grip_length,
        BarrierDatum::GripHeight => &mut barriers.grip_height,
        BarrierDatum::ChuckX => &mut barriers.chuck_x,
        BarrierDatum::ChuckZ => &mut barriers.chuck_z,
        BarrierDatum::FrontLength => &mut barriers.front_length,
        BarrierDatum::FrontDiameter => &mut barriers.front_diameter,
        BarrierDatum::CentreDiameter => &mut barriers.centre_diameter,
        BarrierDatum::WorkpieceEnd => &mut barriers.workpiece_end,
    }
}

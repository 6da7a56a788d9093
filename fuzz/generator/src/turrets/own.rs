//! What each of two turrets has for itself, and which of them is selected.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::{MachineType, Setup, Side};

use crate::builder::Kind;
use crate::state::State;

/// What the generator believes of the turrets.
#[derive(Clone, Debug)]
pub struct Turrets {
    machine: MachineType,
    /// The turret that is selected; its data are those of the state.
    pub(super) selected: Side,
    /// The data of the other turret.
    other: Own,
    /// Whose X the cutting speed follows: G110 or G111.
    pub(super) reference: Side,
    /// The turret that started the main spindle, and whether it turns forward.
    turning: Option<(Side, bool)>,
}

/// What a turret has for itself, X and Z (E100L-MIRR-18, E100L-MIRR-11).
#[derive(Clone, Default, Debug)]
struct Own {
    zero_offset: [i64; 2],
    shift: [i64; 2],
    tool_offsets: BTreeMap<u8, [i64; 2]>,
    radii: BTreeMap<u8, [i64; 2]>,
    offset: u8,
    tool: u8,
    nose: u8,
}

impl Turrets {
    /// Turret A is selected.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        let b = &setup.turret_b;
        let other = Own {
            zero_offset: [b.zero_offset.x.0, b.zero_offset.z.0],
            tool_offsets: b.tool_offset.iter().map(|each| (each.number, [each.x.0, each.z.0])).collect(),
            radii: b.nose_radius.iter().map(|each| (each.number, [each.x.0, each.z.0])).collect(),
            ..Own::default()
        };
        let machine = setup.machine.r#type;
        Self { machine, selected: Side::A, other, reference: Side::A, turning: None }
    }

    /// Whether machine coordinates of X are those of the program with the other sign.
    pub(crate) fn is_mirrored(&self) -> bool {
        self.selected == Side::B
    }

    /// Whether the cutting speed follows the turret that is selected, as far as a program can change that.
    pub(crate) fn has_own_reference(&self) -> bool {
        self.machine != MachineType::TwoTurrets || self.reference == self.selected
    }

    /// Whether a block of this kind may stand here: a turret is not selected in what runs more than once, and the C axis
    /// belongs to turret A (E100L-MIRR-20, E100L-AX4-12).
    pub(crate) fn permits(&self, kind: Kind, steady: bool) -> bool {
        match kind {
            Kind::Turret => self.machine == MachineType::TwoTurrets && !steady,
            // Calls are refused on two saddles (E100L-AX4-12).
            Kind::Lap => self.machine != MachineType::TwoSaddles,
            Kind::CAxis | Kind::Contour | Kind::Cutter => match self.machine {
                MachineType::OneTurret => true,
                MachineType::TwoTurrets => self.selected == Side::A,
                MachineType::TwoSaddles => false,
            },
            _ => true,
        }
    }

    /// Whether M03 (forward with turret A) or M04 may be commanded (E100L-MIRR-08).
    pub(super) fn may_turn(&self, m03: bool, steady: bool) -> bool {
        let forward = m03 != self.is_mirrored();
        match self.turning {
            _ if self.machine != MachineType::TwoTurrets => true,
            _ if steady => false,
            Some((turret, turns)) => turret == self.selected || turns == forward,
            None => true,
        }
    }

    /// Notes that the spindle turns.
    pub(super) fn turn(&mut self, m03: bool) {
        self.turning = Some((self.selected, m03 != self.is_mirrored()));
    }

    /// Notes that it stops.
    pub(super) fn stop(&mut self) {
        self.turning = None;
    }
}

impl State {
    /// The other turret is selected: its data become those of the state.
    pub(super) fn change_turret(&mut self) {
        let own = &mut self.turrets.other;
        for axis in 0..2 {
            std::mem::swap(&mut own.zero_offset[axis], &mut self.zero_offset[axis]);
            std::mem::swap(&mut own.shift[axis], &mut self.shift[axis]);
        }
        std::mem::swap(&mut own.tool_offsets, &mut self.tool_offsets);
        std::mem::swap(&mut own.radii, &mut self.compensation.radii);
        std::mem::swap(&mut own.offset, &mut self.offset);
        std::mem::swap(&mut own.tool, &mut self.tool);
        std::mem::swap(&mut own.nose, &mut self.compensation.nose);
        self.turrets.selected = self.turrets.selected.other();
    }
}

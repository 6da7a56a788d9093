//! Program and machine coordinates, and the travel limits.
//!
//! E100L-COORD-01, E100L-COORD-02: of the three coordinate systems the encoder's is not modelled, since its
//! constant offset shows nowhere. E100L-COORD-03: machine = program + zero offset + zero shift + tool offset,
//! with turret B of two on one saddle its mirror image in X (E100L-MIRR-05).

mod limits;

pub use crate::integer::{Amounts, TravelLimit};
pub use limits::{Limits, limit};

use crate::integer::mirror;
use crate::vocabulary::{Action, Position};
use crate::vocabulary::{Angle, FrameCause, Length, Setup, ToolOffset, ToolOffsetSign};

/// The relation between program and machine coordinates, and where the machine is.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Machine position, C in a full turn.
    pub machine: Amounts,
    /// Zero offset.
    pub zero_offset: Amounts,
    /// Zero shift (E100L-G50-02).
    pub zero_shift: Amounts,
    /// Active tool offset number.
    pub offset_number: u8,
    /// Tool offsets by number; number 0 holds zero.
    pub tool_offsets: Vec<Amounts>,
    /// Whether X of the machine runs against X of the program (E100L-MIRR-05).
    pub mirrored: bool,
    sign: ToolOffsetSign,
}

impl Frame {
    /// The frame at power-on.
    pub fn new(setup: &Setup) -> Self {
        Self {
            machine: Amounts::of(&setup.start).turned(),
            zero_offset: Amounts::of(&setup.zero_offset),
            zero_shift: Amounts::default(),
            offset_number: 0,
            tool_offsets: offsets_by_number(&setup.tool_offset, setup.options.offset_sets),
            mirrored: false,
            sign: setup.readings.tool_offset,
        }
    }

    /// The active tool offset amounts.
    pub fn active_offset(&self) -> Amounts {
        self.tool_offsets.get(usize::from(self.offset_number)).copied().unwrap_or_default()
    }

    /// Machine minus program coordinates (E100L-COORD-03).
    pub fn total(&self) -> Amounts {
        let sign = match self.sign {
            ToolOffsetSign::Added => 1,
            ToolOffsetSign::Subtracted => -1,
        };
        self.zero_offset.plus(self.zero_shift, 1).plus(self.active_offset(), sign)
    }

    /// Present program coordinates, C in a full turn.
    pub fn program(&self) -> Amounts {
        self.to_program(self.machine)
    }

    /// Program coordinates of a machine position.
    pub fn to_program(&self, machine: Amounts) -> Amounts {
        self.mirror(machine).plus(self.total(), -1).turned()
    }

    /// Machine coordinates of a program position.
    pub fn to_machine(&self, program: Amounts) -> Amounts {
        self.mirror(program.plus(self.total(), 1)).turned()
    }

    /// E100L-MIRR-05: from the sense of the turret to that of the machine, and back; Z, C and W are not mirrored.
    fn mirror(&self, amounts: Amounts) -> Amounts {
        Amounts { x: mirror::x(amounts.x, self.mirrored), ..amounts }
    }

    /// The amounts between program and machine coordinates.
    pub fn amounts(&self, cause: FrameCause) -> Amounts {
        match cause {
            FrameCause::ZeroOffset => self.zero_offset,
            FrameCause::ZeroShift => self.zero_shift,
            FrameCause::ToolOffset => self.active_offset(),
        }
    }

    /// The event of a changed amount.
    pub fn event(&self, cause: FrameCause) -> Action {
        let amounts = self.amounts(cause);
        Action::Frame {
            cause,
            x: Length(amounts.x),
            z: Length(amounts.z),
            c: Angle(amounts.c),
            w: Length(amounts.w),
        }
    }
}

/// Tool offsets by number; number 0, and those without an entry, hold zero.
pub fn offsets_by_number(entries: &[ToolOffset], sets: u8) -> Vec<Amounts> {
    let mut offsets = vec![Amounts::default(); usize::from(sets) + 1];
    for offset in entries {
        if let Some(entry) = offsets.get_mut(usize::from(offset.number)) {
            *entry = Amounts { x: offset.x.0, z: offset.z.0, ..Amounts::default() };
        }
    }
    offsets
}

/// A position as it stands in the trace.
pub fn position(amounts: Amounts, c_joined: bool, w_axis: bool) -> Position {
    Position {
        x: Length(amounts.x),
        z: Length(amounts.z),
        c: c_joined.then_some(Angle(amounts.c)),
        w: w_axis.then_some(Length(amounts.w)),
    }
}

//! Radius compensation (execution, chapter 5, Radius compensation): what it remembers from block to block.
//!
//! The position of the state is that of the programmed point P throughout; compensation keeps the
//! displacement of the tip from it, the motion that waits for its end, and the events behind that motion.
//! At most two blocks without X/Z motion follow a motion that waits, so that little is held, unless a program
//! goes round in calls, which are not counted.

mod arcs;
mod barriers;
mod blocks;
mod check;
mod contour;
mod corner;
mod cutter;
mod hold;
mod line_arc;
mod lines;
mod motion;
mod waiting;

pub use check::Change;

use turnspec_oracle::vocabulary::Event;

use super::arithmetic::idle::IdleBlocks;
use super::arithmetic::plane::{Direction, Point};
use contour::Contour;
use cutter::Cutter;
use waiting::Waiting;

/// Where compensation stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Phase {
    /// G40, the tip on the programmed point.
    Off,
    /// In the motion of the block that begins compensation.
    Starting,
    /// G41 or G42, from the start-up on.
    On,
    /// In the block that ends compensation, before its motion.
    Ending,
    /// In the block that ends compensation, after its first motion in X or Z.
    Ended,
    /// G40, the displacement not taken away yet.
    LeftOver,
}

/// What radius compensation remembers.
#[derive(Debug)]
pub struct Compensation {
    phase: Phase,
    /// From the programmed point to the tip, X as a diameter.
    displacement: Point,
    /// The imaginary line of the block in progress, from its I and K, in half nanometres.
    imaginary: Option<Direction>,
    /// The motion that waits for its end.
    waiting: Option<Waiting>,
    /// The last element, or what stands for it at the start-up: its v, and the imaginary line.
    last: Contour,
    /// Blocks without X/Z motion since the motion waits.
    idle_blocks: IdleBlocks,
    /// Statements since the motion waits.
    statements: u8,
    /// Whether the block in progress has an X/Z motion, or is the start-up block.
    moved: bool,
    /// The return to the corner that the next element will ask for, when no motion waits.
    extra: Option<Waiting>,
    /// Whether events are held.
    holding: bool,
    held: Vec<Event>,
    /// In G17 and G119: the cutter that is compensated.
    cutter: Option<Box<Cutter>>,
}

impl Default for Compensation {
    fn default() -> Self {
        Self {
            phase: Phase::Off,
            displacement: Point { x: 0, z: 0 },
            imaginary: None,
            waiting: None,
            last: Contour::default(),
            idle_blocks: IdleBlocks::None,
            statements: 0,
            moved: false,
            extra: None,
            holding: false,
            held: Vec::new(),
            cutter: None,
        }
    }
}

impl Compensation {
    /// Whether motions are anything else than those of G40 with the tip on the programmed point.
    #[inline]
    pub fn acts(&self) -> bool {
        self.phase != Phase::Off
    }

    /// Whether events are held.
    #[inline]
    pub fn holds(&self) -> bool {
        self.holding
    }

    /// Whether it is that of a cutter, in G17 or G119.
    #[inline]
    pub fn is_of_cutter(&self) -> bool {
        self.cutter.is_some()
    }

    /// Whether the displacement of an ended compensation is left over.
    pub fn is_left_over(&self) -> bool {
        self.phase == Phase::LeftOver
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Event, Setup};

    use crate::engine::Interpreter;

    #[test]
    fn little_is_held_however_long_no_axis_moves() {
        let head = "G42 G01 X100 Z100 F0.2 T010101\nZ60\n";
        let idle = "M08 S100 V1=1 V2=2 V3=3\n".repeat(1000);
        let program = format!("{head}{idle}X150\nM02\n");
        let setup = Setup::default();
        let mut interpreter = Interpreter::new(program.as_bytes(), &setup);
        let mut events = 0;
        let mut most = 0;
        while interpreter.step(&mut |_: &Event| events += 1).is_none() {
            most = most.max(interpreter.compensation.held.len());
        }
        // Two modes, the tool, three motions, two modes of the reset, the end; five events of 1000 blocks each.
        assert_eq!(events, 9 + 5 * 1000);
        assert!((5..=10).contains(&most), "{most} events held");
    }
}

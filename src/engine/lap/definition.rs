//! A definition that is read or carried out, and the motions that come of it (execution of LAP, 5 and 6).

use turnspec_oracle::vocabulary::{Angle, FeedRate, LeadAxis, Place, ReadingSet, RuleSet, Sense};

use crate::engine::arithmetic::plane::Point;
use crate::engine::state::StoredFeed;
use crate::engine::text::Mark;

/// What a definition is gone through for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Purpose {
    /// G85 and G86 read it.
    Rough,
    /// G88 reads it.
    Thread,
    /// G87 carries it out.
    Finish,
}

/// The definition in progress.
#[derive(Debug)]
pub struct Definition {
    pub purpose: Purpose,
    /// Whether its blank is gone through.
    pub blank: bool,
    /// The block with the call.
    pub call: Place,
    /// Where the run goes on behind the call.
    pub back: Mark,
    /// How many calls were active in the call.
    pub depth: u8,
    /// How many motions were begun in the blank, or in the contour.
    pub motions: u32,
    /// Whether one of them has been made.
    pub placed: bool,
    /// Whether its end has been carried out.
    pub ended: bool,
    /// How many motions count as recorded in the blank, or in the contour, and where the last one ended.
    pub count: u32,
    pub last: Point,
    pub has_leg: bool,
    /// What a contour motion that comes now has of its block.
    pub marks: Marks,
    pub blank_motions: Vec<Recorded>,
    pub contour_motions: Vec<Recorded>,
    /// What the end of G87 restores, and what its first motion needs.
    pub finish: Finish,
}

impl Definition {
    /// A definition that begins.
    pub fn new(purpose: Purpose, blank: bool, (call, back, depth): (Place, Mark, u8)) -> Self {
        Self {
            purpose,
            blank,
            call,
            back,
            depth,
            motions: 0,
            placed: false,
            ended: false,
            count: 0,
            last: Point::default(),
            has_leg: false,
            marks: Marks::default(),
            blank_motions: Vec::new(),
            contour_motions: Vec::new(),
            finish: Finish::default(),
        }
    }

    /// Whether it is that of a thread.
    pub fn cuts_thread(&self) -> bool {
        self.purpose == Purpose::Thread
    }

    /// The blank is over, the contour begins.
    pub fn begin_contour(&mut self) {
        self.blank = false;
        self.motions = 0;
        self.placed = false;
        self.count = 0;
        self.marks = Marks::default();
    }

    /// Takes note of a motion to a point, unless it does not count; whether it does.
    pub fn count(&mut self, end: Point) -> bool {
        let counts = self.count == 0 || end != self.last;
        self.count = self.count.saturating_add(u32::from(counts));
        self.last = end;
        counts
    }
}

/// What a motion has of its block, though it may come later.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct BlockMark {
    /// E.
    pub feed: Option<StoredFeed>,
    /// Whether compensation was in force.
    pub compensated: bool,
}

/// The marks of blocks, by number; the last one is that of the block in progress.
#[derive(Debug)]
pub struct Marks(Vec<BlockMark>);

impl Default for Marks {
    fn default() -> Self {
        Self(vec![BlockMark::default()])
    }
}

impl Marks {
    /// A block has this mark.
    pub fn enter(&mut self, mark: BlockMark) {
        if self.0.last() != Some(&mark) {
            self.0.push(mark);
        }
    }

    /// The mark of the block in progress.
    pub fn present(&self) -> BlockMark {
        self.0.last().copied().unwrap_or_default()
    }

    /// The number of the mark of the block in progress.
    pub fn number(&self) -> u32 {
        u32::try_from(self.0.len().saturating_sub(1)).unwrap_or(u32::MAX)
    }

    /// The mark with a number.
    pub fn get(&self, number: u32) -> BlockMark {
        usize::try_from(number).ok().and_then(|number| self.0.get(number)).copied().unwrap_or_default()
    }
}

/// What a recorded motion is.
#[derive(Clone, Copy, Debug)]
pub enum Course {
    /// A line in G00.
    Rapid,
    Line,
    Arc {
        sense: Sense,
        centre: Point,
    },
    Leg(Leg),
}

/// A leg of a thread, with the rules that it cites as such.
#[derive(Clone, Copy, Debug)]
pub struct Leg {
    pub lead: FeedRate,
    pub axis: LeadAxis,
    pub change: Option<FeedRate>,
    pub start: Option<Angle>,
    pub rules: RuleSet,
    pub readings: ReadingSet,
}

/// A recorded motion.
#[derive(Clone, Copy, Debug)]
pub struct Recorded {
    pub course: Course,
    /// In program coordinates; of the tip in compensation.
    pub end: Point,
    /// The end that is programmed.
    pub programmed: Point,
    /// E of its block, for a line of a thread F.
    pub feed: Option<StoredFeed>,
    /// Whether compensation was in force in its block.
    pub compensated: bool,
}

/// What G87 needs besides.
#[derive(Clone, Copy, Default, Debug)]
pub struct Finish {
    /// The motion mode of the call.
    pub motion: u16,
    /// Whether the call was in G91.
    pub incremental: bool,
    /// U and W.
    pub allowances: Point,
}

//! What LAP keeps from one block to the next: the last contour feed (E100L-LAP-08), and the definition that is read or
//! carried out.

use crate::controls::e100l::g_codes::GGroup;
use crate::emission::Emission;
use crate::fault::{Fault, Outcome};
use crate::frame::Amounts;
use crate::modal::{Change, Plan, Words, feed_readings};
use crate::path::{Element, Point, Shape};
use crate::state::{State, StoredFeed};
use crate::syntax::Address;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, RuleSet};

/// What is kept.
#[derive(Clone, Copy, Default, Debug)]
pub struct Kept {
    /// E: the contour feed commanded last (E100L-LAP-08).
    pub feed: Option<StoredFeed>,
    /// FA and FB of the call (E100L-LAPC-02).
    pub other_feeds: [Option<StoredFeed>; 2],
    /// The definition in which the run is.
    pub definition: Option<Definition>,
}

/// What a definition is gone through for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Purpose {
    /// It is read for G85 or G86.
    Rough,
    /// It is read for G88.
    Thread,
    /// G87 carries it out.
    Finish,
}

/// A definition that is read or carried out.
#[derive(Clone, Copy, Debug)]
pub struct Definition {
    /// What for.
    pub purpose: Purpose,
    /// How many called programs are active where it stands.
    pub depth: usize,
    /// Whether it is the blank in front of the contour.
    pub blank: bool,
    /// The E in force in it.
    pub feed: Option<StoredFeed>,
    /// Whether its first motion has come.
    pub moved: bool,
    /// U and W of G87, and where the tool was in its call.
    pub allowance: (i64, i64),
    /// Where the tool was in the call.
    pub from: Point,
    /// Program coordinates less contour coordinates (E100L-LAPC-06).
    pub shift: Point,
    /// What its block gives to motions.
    pub mark: Mark,
}

/// What was in force in the block of a motion of a contour.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Mark {
    /// E, if one was given in the contour.
    pub feed: Option<StoredFeed>,
    /// F.
    pub own_feed: Option<StoredFeed>,
    /// Whether G41 or G42 was in force (E100L-LAP-16).
    pub compensated: bool,
    /// The rules that its events name besides.
    pub rules: RuleSet,
}

impl Mark {
    /// Nothing.
    pub const NONE: Self = Self { feed: None, own_feed: None, compensated: false, rules: RuleSet::EMPTY };
}

impl Kept {
    /// Whether a contour is read: nothing moves.
    pub fn is_reading(&self) -> bool {
        self.definition.is_some_and(|definition| definition.purpose != Purpose::Finish)
    }

    /// Whether E is a feed (E100L-LAP-07); for G88 it is the change of the lead.
    pub fn takes_feeds(&self) -> bool {
        self.definition.is_some_and(|definition| definition.purpose != Purpose::Thread)
    }

    /// The event of a motion, with what was in force in its block.
    pub fn marked(&self, event: Emission) -> Emission {
        let Some(Definition { mark, .. }) = self.definition else { return event };
        Emission { mark: Some(mark), ..event.rules(mark.rules) }
    }

    /// Contour coordinates as program coordinates (E100L-LAPC-06).
    pub fn in_program(&self, amounts: Amounts) -> Amounts {
        let (x, z) = self.definition.map_or((0, 0), |definition| definition.shift);
        Amounts { x: amounts.x + x, z: amounts.z + z, ..amounts }
    }

    /// A block as it is carried out: while a contour is read, F has no effect but for threads, and S none at all
    /// (E100L-LAP-07).
    pub fn taken(&self, mut plan: Plan) -> Plan {
        if self.is_reading() {
            plan.words.others.retain(|other| other.address != Some(Address::Letter(b'S')));
            if self.takes_feeds() {
                plan.words.feed = None;
            }
        }
        plan
    }
}

impl Definition {
    /// Whether a program runs that it has called, at this depth.
    pub fn in_called(&self, depth: usize) -> bool {
        depth > self.depth
    }

    /// The shift of E100L-LAPC-06, by the target of the first motion.
    fn shift_toward(&self, target: Point) -> Outcome<Point> {
        let of = |allowance: i64, from: i64, to: i64, detail: &str| match (from - to).signum() {
            0 if allowance != 0 => Err(Fault::about(AlarmName::Unspecified, LAPC_06, detail)),
            sign => Ok(sign * allowance),
        };
        let x = of(self.allowance.0, self.from.0, target.0, "U")?;
        Ok((x, of(self.allowance.1, self.from.1, target.1, "W")?))
    }
}

impl State<'_> {
    /// Does something with the present point in contour coordinates (E100L-LAPC-06).
    pub fn in_contour_coordinates<T>(&mut self, act: impl FnOnce(&mut Self) -> T) -> T {
        let (x, z) = self.lap.definition.map_or((0, 0), |definition| definition.shift);
        let shift = Amounts { x, z, ..Amounts::default() };
        self.frame.zero_shift = self.frame.zero_shift.plus(shift, 1);
        let result = act(self);
        self.frame.zero_shift = self.frame.zero_shift.plus(shift, -1);
        result
    }
}

/// Stores E of a block of a definition, and FA and FB of a call (E100L-LAP-07, E100L-LAPC-02).
pub fn store_feeds(words: &Words, state: &mut State) -> Outcome<()> {
    let read = |address| words.feed_of(address).map(|number| feed_readings(number, false, state)).transpose();
    let e = read(Address::Letter(b'E'))?;
    let others = [read(Address::Extended("FA"))?, read(Address::Extended("FB"))?];
    if words.contour.is_some() {
        state.lap.other_feeds = others;
    }
    if let (Some(feed), Some(definition)) = (e, &mut state.lap.definition) {
        definition.feed = Some(feed);
        state.lap.feed = Some(feed);
    }
    Ok(())
}

/// The motion of a block of a definition is about to come: what its events tell, and whether it may come.
pub fn begin_motion(plan: &Plan, state: &mut State) -> Outcome<()> {
    let (own_feed, compensated) = (state.feed, state.modes.compensating());
    let Some(definition) = &mut state.lap.definition else { return Ok(()) };
    let feeds = plan.words.feed.is_some() || plan.words.get('S').is_some();
    let rules = match definition.purpose {
        Purpose::Finish => {
            let rules = if feeds { RuleSet::of(&[LAPC_06, LAP_07]) } else { RuleSet::of(&[LAPC_06]) };
            if compensated { rules.with(LAP_16) } else { rules }
        }
        Purpose::Rough | Purpose::Thread => RuleSet::EMPTY,
    };
    definition.mark = Mark { feed: definition.feed, own_feed, compensated, rules };
    if plan.moves || plan.compensation == Change::Begins { may_move(plan, definition) } else { Ok(()) }
}

/// E100L-LAP-05, E100L-LAP-03, E100L-LAP-04: the motions that a definition may not have.
fn may_move(plan: &Plan, definition: &Definition) -> Outcome<()> {
    let motion = plan.modes.get(GGroup::Motion);
    if !definition.moved {
        let refused = matches!(motion, 2 | 3) || definition.purpose == Purpose::Thread && motion != 0;
        return if refused { Err(first_refused(definition)) } else { Ok(()) };
    }
    if motion == 0 && plan.compensation != Change::Ends {
        let rule: RuleId = if definition.blank { LAP_03 } else { LAP_04 };
        return Err(Fault::about(AlarmName::ContourMalformed, rule, "G00"));
    }
    Ok(())
}

fn first_refused(definition: &Definition) -> Fault {
    if definition.blank {
        Fault::new(AlarmName::BlankFirstElement, LAP_03)
    } else {
        Fault::about(AlarmName::ContourMalformed, LAP_05, "first")
    }
}

/// The motions of a block of a definition, in contour coordinates, come to their place in program coordinates.
pub fn place(plan: &Plan, elements: &mut [Element], state: &mut State) -> Outcome<()> {
    let present = state.frame.program();
    let Some(definition) = &mut state.lap.definition else { return Ok(()) };
    let first = elements.first();
    if first.is_none() && plan.compensation != Change::Begins {
        return Ok(());
    }
    if !definition.moved {
        if first.is_some_and(|first| matches!(first.shape, Shape::Arc { .. })) {
            return Err(first_refused(definition));
        }
        let target = first.map_or(present, |first| first.programmed_end(present));
        definition.shift = definition.shift_toward((target.x, target.z))?;
        definition.moved = true;
    }
    let (x, z) = definition.shift;
    for element in elements {
        element.target.x += x;
        element.target.z += z;
        if let Shape::Arc { centre, .. } = &mut element.shape {
            *centre = (centre.0 + x, centre.1 + z);
        }
    }
    Ok(())
}

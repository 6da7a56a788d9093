//! What runs more than once: blocks that lead to a known state wherever they begin, and programs made of them.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::{Builder, Kind};
use crate::companions::has;
use crate::expression::{Expression, Operator, Variable};
use crate::number::Number;
use crate::program::{Item, Line, Statement, Value, Word};
use crate::state::{Axis, Mode, State};
use crate::threads;

use super::local::{self, Owner};

/// A variable that changes, with its bounds.
#[derive(Clone, Debug)]
pub(super) struct Bounded {
    pub variable: Variable,
    pub low: i64,
    pub high: i64,
}

/// A program that can be called.
#[derive(Debug)]
pub(crate) struct Called {
    /// Its name, without the `O`.
    pub name: String,
    pub lines: Vec<Line>,
    /// What is known of a program that may be called again.
    pub again: Option<Again>,
}

/// A program that may be called again.
#[derive(Clone, Debug)]
pub(crate) struct Again {
    pub nature: Nature,
    /// The local variables that it needs, with their bounds.
    pub arguments: Vec<(&'static str, i64, i64)>,
    /// How many programs are active within each other, this one included.
    pub levels: usize,
    /// Its blocks that count in compensation.
    blocks: usize,
    /// Whether it gives a feed.
    feeds: bool,
    /// Whether it cuts threads, or taps.
    threads: bool,
    /// Where it ends, if it moves.
    effect: Option<Effect>,
    /// The lowest and highest program coordinates of X and Z on its way.
    extent: [(i64, i64); 2],
}

/// How much a program does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Nature {
    /// No motion.
    Still,
    /// Motions each of which begins anew, so that other programs may run between them.
    Robust,
    /// A first motion that begins anew, then blocks of many kinds.
    Full,
}

/// The state in which a program ends.
#[derive(Clone, Copy, Debug)]
struct Effect {
    mode: Mode,
    incremental: bool,
    per_minute: bool,
    after_cutting: bool,
    /// Program coordinates X and Z.
    position: [i64; 2],
}

impl Called {
    /// Whether it moves.
    pub fn moves(&self) -> bool {
        self.again.as_ref().is_none_or(|again| again.effect.is_some())
    }

    /// Whether compensation bears it behind a start-up.
    pub fn is_short(&self) -> bool {
        self.again.as_ref().is_some_and(|again| again.effect.is_none() && again.blocks <= 1)
    }
}

impl Builder<'_, '_, '_> {
    /// A block of G90 that names motion code, feed, X and Z: it leads to the same state wherever it begins.
    pub(super) fn anchor(&mut self) {
        self.begin();
        if self.state.barriers.is_watched() {
            self.fitting(Self::anchor_block);
        } else {
            self.anchor_block();
        }
    }

    fn anchor_block(&mut self) {
        let expressions = std::mem::take(&mut self.expressions);
        let linear = self.allows(Feature::Linear) && self.allows(Feature::Feed) && self.choices.chance(40);
        let mode = if linear { Mode::Linear } else { Mode::Rapid };
        let mut items = vec![self.incremental_word(false), Item::g(mode as i64)];
        if self.allows(Feature::Feed) && (linear || self.choices.chance(60)) {
            self.state.per_minute = self.choices.chance(50);
            items.push(Item::g(if self.state.per_minute { 94 } else { 95 }));
            items.push(self.feed_word());
        }
        self.state.mode = mode;
        let from = self.present();
        for axis in [Axis::X, Axis::Z] {
            let wanted = self.state.somewhere(axis, self.choices);
            let (item, target) = self.target(axis, wanted);
            items.push(item);
            self.state.move_to(axis, target);
        }
        self.travelled(from, self.present(), None);
        self.state.after_cutting = linear;
        self.expressions = expressions;
        self.push(items);
    }

    /// A position that depends on a variable that changes, and an anchor behind it.
    pub(super) fn varied(&mut self) {
        let known = &self.state.control.bounded;
        let Bounded { variable, low, high } = known[self.choices.below(known.len())].clone();
        let axis = if self.choices.chance(50) { Axis::X } else { Axis::Z };
        let factor = self.choices.pick(&[1, 2, -1, 3]);
        let most = low.abs().max(high.abs()) * i64::from(factor).abs() * self.state.units.length_unit();
        let (lowest, highest) = self.state.window(axis);
        let (lowest, highest) = (lowest + most, highest - most);
        if lowest >= highest || self.state.barriers.is_watched() {
            return self.anchor();
        }
        self.begin();
        let number =
            self.state.units.write_length(self.choices.within(lowest / 1_000, highest / 1_000) * 1_000);
        let factor = Expression::Constant(Number::whole(factor.into()));
        let product = Expression::binary(Operator::Multiply, Expression::Variable(variable), factor);
        let sum = Expression::binary(Operator::Add, Expression::Constant(number), product);
        let mut items = vec![self.incremental_word(false), Item::g(0)];
        items.push(Item::Word(Word { address: axis.address(), value: Value::Expression(sum) }));
        self.state.mode = Mode::Rapid;
        self.push(items);
        self.anchor();
    }

    /// Marks what changes as unknown.
    pub(crate) fn forget_changing(&mut self) {
        let state = &mut self.state;
        for number in super::CHANGING {
            state.common.remove(&number);
            state.control.unknown.insert(number);
        }
        let changing = state.control.entries.iter_mut().filter(|entry| local::CHANGING.contains(&entry.name));
        changing.for_each(|entry| entry.value = None);
    }

    /// Writes a program that may be called again; the state stays as it is.
    pub(super) fn shared_program(&mut self, nature: Nature) -> std::rc::Rc<Called> {
        let name = self.program_name();
        let arguments = self.argument_list();
        let before = self.begin_apart();
        for (name, low, high) in &arguments {
            let owner = Owner::Program(self.state.control.depth + 1);
            self.state.control.register(name, None, owner);
            let variable = Variable::Local(name);
            self.state.control.bounded.push(Bounded { variable, low: *low, high: *high });
        }
        let lines = self.write_program(|builder| builder.shared_body(nature));
        let (lines, again) = self.end_apart(nature, before, arguments, lines);
        let called = std::rc::Rc::new(Called { name, lines, again: Some(again) });
        self.state.control.programs.push(called.clone());
        called
    }

    /// The blocks of a program that may run at another place.
    pub(crate) fn shared_body(&mut self, nature: Nature) {
        match nature {
            Nature::Still => self.still_body(),
            Nature::Robust => (0..=self.choices.below(2)).for_each(|_| self.robust_block()),
            Nature::Full => {
                self.anchor();
                (0..self.choices.below(5)).for_each(|_| self.grow_block());
            }
        }
    }

    /// Begins what may run at another place; the state before it.
    pub(crate) fn begin_apart(&mut self) -> State {
        let before = self.state.clone();
        self.state.control.steady = true;
        self.state.control.shared = true;
        self.state.control.loops = 0;
        self.state.control.deepest = self.state.control.depth + 1;
        self.state.control.extent = [(i64::MAX, i64::MIN); 2];
        self.state.control.bounded.clear();
        self.state.threads.forget();
        self.forget_changing();
        before
    }

    /// Ends it: the state is again as it was before, and what it does is known.
    pub(crate) fn end_apart(
        &mut self,
        nature: Nature,
        before: State,
        arguments: Vec<(&'static str, i64, i64)>,
        lines: Vec<Line>,
    ) -> (Vec<Line>, Again) {
        let state = std::mem::replace(&mut self.state, before);
        let effect = Effect {
            mode: state.mode,
            incremental: state.incremental,
            per_minute: state.per_minute,
            after_cutting: state.after_cutting,
            position: [state.program(Axis::X), state.program(Axis::Z)],
        };
        let again = Again {
            nature,
            arguments,
            levels: state.control.deepest - self.state.control.depth,
            blocks: lines.iter().filter(|line| counts(line)).count(),
            effect: (nature != Nature::Still).then_some(effect),
            feeds: gives_feed(&lines),
            threads: lines.iter().any(cuts_thread),
            extent: state.control.extent,
        };
        // What it needs of set-up and names was found while it was written.
        self.state.setup = state.setup;
        self.state.control.programs = state.control.programs;
        self.state.control.names = state.control.names;
        self.state.control.jumps |= state.control.jumps;
        (lines, again)
    }

    fn argument_list(&mut self) -> Vec<(&'static str, i64, i64)> {
        let wanted = self.choices.chance(40) && self.allows(Feature::LocalVariable);
        if !wanted || !self.allows(Feature::Expression) || self.state.is_eia() {
            return Vec::new();
        }
        let count = 1 + self.choices.below(2);
        let bounds = [(0, 9), (-3, 3), (1, 5)];
        let list = local::ARGUMENTS.iter().take(count);
        list.map(|name| {
            let (low, high) = self.choices.pick(&bounds);
            (*name, low, high)
        })
        .collect()
    }

    fn robust_block(&mut self) {
        if !self.state.control.bounded.is_empty() && self.choices.chance(30) {
            self.varied();
        } else {
            self.anchor();
        }
    }

    /// Blocks without motion.
    fn still_body(&mut self) {
        for _ in 0..=self.choices.below(3) {
            let text = self.allows(Feature::Expression) && !self.state.is_eia();
            match self.choices.below(5) {
                0 if text && (self.allows(Feature::Variable) || self.allows(Feature::LocalVariable)) => {
                    self.begin();
                    let item = self.changing_assignment();
                    if self.choices.chance(25) && self.allows(Feature::ControlStatement) {
                        self.statement(Statement::Noex, vec![item]);
                    } else {
                        self.push(vec![item]);
                    }
                }
                1 if text && self.allows(Feature::ControlStatement) && self.allows(Feature::SequenceName) => {
                    self.unknown_condition();
                }
                2 => self.call(),
                _ => self.harmless_block(),
            }
        }
    }

    /// Whether a program may be called here.
    pub(crate) fn is_usable(&self, called: &Called, modal: bool) -> bool {
        let Some(again) = &called.again else { return false };
        let state = &self.state;
        let control = &state.control;
        let depth = control.depth + control.modes.len() + again.levels;
        if depth > usize::from(state.setup.parameters.call_depth) {
            return false;
        }
        let free = !state.compensation.is_on() && !state.barriers.is_watched() && !control.shared;
        if again.threads && !state.may_cut_threads() {
            return false;
        }
        let fits = |axis: Axis| {
            let (low, high) = again.extent[axis as usize];
            low > high || state.fits(axis, low) && state.fits(axis, high)
        };
        let goes = free && fits(Axis::X) && fits(Axis::Z);
        match again.nature {
            Nature::Still => !state.compensation.has_to_go_on(),
            Nature::Robust => goes && (modal || control.modes.is_empty()),
            Nature::Full => goes && control.modes.is_empty(),
        }
    }

    /// The natures of programs that can be written here.
    pub(super) fn nature(&mut self, modal: bool) -> Nature {
        let state = &self.state;
        let control = &state.control;
        let free = !state.compensation.is_on()
            && !state.barriers.is_watched()
            && !control.shared
            && super::rapid(self)
            && !control.modes.iter().any(|mode| mode.called.moves() && !modal);
        let empty = control.modes.is_empty();
        if !free || !(empty || modal) {
            return Nature::Still;
        }
        let full = if empty { 45 } else { 0 };
        self.choices.weighted(&[(45, Nature::Still), (full, Nature::Full), (25, Nature::Robust)])
    }

    /// The state after a program that was called.
    pub(crate) fn after_program(&mut self, called: &Called) {
        self.forget_changing();
        let Some(again) = &called.again else { return };
        self.state.compensation.pass(again.blocks);
        self.state.feed |= again.feeds;
        self.state.threads.forget();
        let control = &mut self.state.control;
        control.deepest = control.deepest.max(control.depth + again.levels);
        let Some(effect) = again.effect else { return };
        let state = &mut self.state;
        state.mode = effect.mode;
        state.incremental = effect.incremental;
        state.after_cutting = effect.after_cutting;
        state.compensation.left_over = false;
        state.per_minute = effect.per_minute;
        state.move_to(Axis::X, effect.position[0]);
        state.move_to(Axis::Z, effect.position[1]);
    }

    /// The name of a new program.
    pub(crate) fn program_name(&mut self) -> String {
        let wanted = self.choices.pick(super::text::PROGRAMS).to_owned();
        let others = (5_000..).map(|number: u32| number.to_string());
        let names = &mut self.state.control.names;
        let name =
            std::iter::once(wanted).chain(others).find(|name| !names.contains(name)).unwrap_or_default();
        names.insert(name.clone());
        name
    }

    /// Kinds of blocks that begin and end compensation, with a contour, in what runs more than once.
    pub(super) fn contour_in_passing(&mut self) {
        self.begin();
        self.fitting(|builder| builder.block_of(Kind::StartUp));
        for _ in 0..2 + self.choices.below(3) {
            self.grow_block();
        }
        for _ in 0..6 {
            if !self.state.compensation.is_on() {
                break;
            }
            self.begin();
            self.fitting(|builder| builder.block_of(Kind::Cancel));
        }
        self.anchor();
    }
}

/// Whether a line counts as a block in compensation.
fn counts(line: &Line) -> bool {
    let Line::Block(block) = line else { return false };
    match &block.statement {
        Some(statement) => *statement == Statement::Noex,
        None => !block.items.is_empty(),
    }
}

/// Whether a line has a code of thread cutting or tapping.
fn cuts_thread(line: &Line) -> bool {
    let code =
        |item: &Item| matches!(item, Item::Word(word) if word.is_g(threads::CODES) || word.is_g(&[77, 78]));
    matches!(line, Line::Block(block) if block.items.iter().any(code))
}

/// Whether lines give a feed.
fn gives_feed(lines: &[Line]) -> bool {
    let dwells = |item: &Item| matches!(item, Item::Word(word) if word.is_g(&[4]));
    let gives = |line: &Line| match line {
        Line::Block(block) => has(&block.items, "F") && !block.items.iter().any(dwells),
        Line::Raw(_) => false,
    };
    lines.iter().any(gives)
}

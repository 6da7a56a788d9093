//! Control flow: jumps, loops, local variables, programs that are called, modal calls.
//!
//! Most of it is foreseen exactly. Blocks that are carried out once, wherever the text has them, are written
//! beside the forecast in the order in which they run. What runs more than once (the body of a loop, a program that
//! is called again) is *steady*: it begins with modes and a position of its own, and contains nothing that adds
//! up; a variable that changes with every pass counts as unknown, and words that use one lead to a position
//! that the next block leaves for a known one.

mod call;
mod jump;
mod library;
mod local;
mod modal;
mod passes;
mod steady;
mod text;

use std::collections::BTreeSet;
use std::rc::Rc;

use turnspec_oracle::vocabulary::Feature;

use crate::builder::{Builder, Kind};
use crate::environment::Environment;
use crate::profile::Profile;
use crate::program::{Block, Item, Line, Statement};

pub(crate) use passes::compare;
pub(crate) use steady::{Called, Nature};

use local::Entry;
use modal::Mode;
/// The common variables that change in what runs more than once.
const CHANGING: std::ops::RangeInclusive<u8> = 101..=120;

/// What the generator believes of control flow.
#[derive(Clone, Default, Debug)]
pub struct Control {
    /// Local variables in the order in which they were registered.
    entries: Vec<Entry>,
    /// How many called programs are active.
    depth: usize,
    /// How many of them were called modally.
    modally: usize,
    /// Modal calls that are active.
    modes: Vec<Mode>,
    /// Whether what is written now runs more than once.
    pub steady: bool,
    /// Whether it may run at another place too, where other variables and offsets are in force.
    shared: bool,
    /// Loops around the present place.
    loops: usize,
    /// Variables that change with every pass, with their bounds.
    bounded: Vec<steady::Bounded>,
    /// Common variables whose value is not known.
    unknown: BTreeSet<u8>,
    /// Programs that are complete.
    programs: Vec<Rc<Called>>,
    /// Blocks behind the end of the present program.
    tail: Vec<Line>,
    /// The sequence name that the next block gets.
    label: Option<String>,
    /// The name of the main program, without the `O`.
    pub(crate) main: Option<String>,
    /// Names of programs in use, without the `O`.
    pub(crate) names: BTreeSet<String>,
    /// The greatest depth of calls that was reached.
    deepest: usize,
    /// The lowest and highest program coordinates of X and Z since a program began.
    extent: [(i64, i64); 2],
    /// Whether blocks may run without end.
    pub(crate) jumps: bool,
}

impl Control {
    /// Shows an expression which variables are known.
    pub fn show(&self, environment: &mut Environment) {
        environment.local.clear();
        for entry in &self.entries {
            match entry.value {
                Some(value) => environment.local.insert(entry.name, value),
                None => environment.local.remove(entry.name),
            };
        }
        environment.unknown.clone_from(&self.unknown);
        environment.shared = self.shared;
        if self.shared {
            environment.system.retain(|(name, _)| matches!(*name, "VPAI" | "VRUND" | "VRSTT"));
        }
    }

    /// Notes that a common variable has a known value again.
    pub fn now_known(&mut self, number: u8) {
        self.unknown.remove(&number);
    }

    /// Whether a block of this kind may stand here.
    pub(crate) fn permits(&self, kind: Kind) -> bool {
        match kind {
            Kind::Chamfer => self.modes.is_empty(),
            Kind::StartUp => {
                !self.steady && self.modes.len() < 2 && self.modes.iter().all(|mode| mode.called.is_short())
            }
            Kind::Shift | Kind::Torque | Kind::CAxis | Kind::Contour | Kind::Lap | Kind::Cutter => {
                !self.steady
            }
            _ => true,
        }
    }

    /// Notes a way to program coordinates X and Z.
    pub(crate) fn note_way(&mut self, position: [i64; 2]) {
        for ((low, high), coordinate) in self.extent.iter_mut().zip(position) {
            (*low, *high) = ((*low).min(coordinate), (*high).max(coordinate));
        }
    }

    /// Whether a called program runs.
    pub(crate) fn is_called(&self) -> bool {
        self.depth > 0
    }

    /// Whether what is written now may run at another place too.
    pub(crate) fn is_shared(&self) -> bool {
        self.shared
    }

    /// How many called programs are active.
    pub(crate) fn calls(&self) -> usize {
        self.depth
    }

    /// Whether a modal call is active.
    pub(crate) fn has_modes(&self) -> bool {
        !self.modes.is_empty()
    }

    /// The name of the main program, if it has one.
    pub(crate) fn main_name(&self) -> Option<String> {
        self.main.clone()
    }

    /// Whether blocks stand behind the end of the present program.
    pub(crate) fn has_tail(&self) -> bool {
        !self.tail.is_empty()
    }

    /// How many blocks and programs stand behind the end.
    pub(crate) fn written(&self) -> (usize, usize) {
        (self.tail.len(), self.programs.len())
    }

    /// The blocks and programs behind the end from a place on.
    pub(crate) fn texts_from(&self, tail: usize, programs: usize) -> impl Iterator<Item = &[Line]> {
        let programs = self.programs.get(programs..).unwrap_or_default();
        let texts = programs.iter().map(|called| called.lines.as_slice());
        texts.chain(self.tail.get(tail..))
    }

    /// How many programs are complete.
    pub(crate) fn programs_count(&self) -> usize {
        self.programs.len()
    }

    /// Takes the programs that are complete.
    pub(crate) fn take_programs(&mut self) -> Vec<Rc<Called>> {
        std::mem::take(&mut self.programs)
    }

    /// Takes those from a place on.
    pub(crate) fn take_programs_from(&mut self, place: usize) -> Vec<Rc<Called>> {
        self.programs.split_off(place.min(self.programs.len()))
    }

    /// Puts other blocks behind the end of the present program; those that were there.
    pub(crate) fn change_tail(&mut self, tail: Vec<Line>) -> Vec<Line> {
        std::mem::replace(&mut self.tail, tail)
    }

    /// Notes the value of a local variable.
    pub(crate) fn assign_local(&mut self, name: &'static str, value: f64) {
        self.assign(name, Some(value));
    }

    /// Takes the name that the next block gets.
    pub(crate) fn take_label(&mut self) -> Option<String> {
        self.label.take()
    }
}

/// A construction of control flow.
#[derive(Clone, Copy)]
enum Construction {
    /// A jump forward over text that does not run.
    Over,
    /// A condition whose value is known.
    Known,
    /// A condition whose value is not known, over blocks that change nothing.
    Unknown,
    /// Blocks behind the end of the program.
    Excursion,
    /// A loop.
    Passes,
    /// A loop of travels.
    Steps,
    /// A loop without end.
    Endless,
    /// An assignment to a local variable.
    Local,
    /// A call.
    Call,
    /// A program that calls itself.
    Recursion,
    /// A modal call with blocks that trigger it.
    Modal,
    /// A word that depends on a variable that changes.
    Varied,
}

impl Construction {
    const ALL: [(usize, Self); 12] = [
        (14, Self::Over),
        (16, Self::Known),
        (5, Self::Unknown),
        (10, Self::Excursion),
        (14, Self::Passes),
        (5, Self::Steps),
        (1, Self::Endless),
        (16, Self::Local),
        (30, Self::Call),
        (2, Self::Recursion),
        (14, Self::Modal),
        (4, Self::Varied),
    ];

    fn is_within(self, builder: &Builder<'_, '_, '_>) -> bool {
        let allows = |feature| builder.allows(feature);
        let state = &builder.state;
        let control = &state.control;
        let jumps = allows(Feature::ControlStatement) && allows(Feature::SequenceName);
        let expressions = allows(Feature::Expression) && !state.is_eia();
        let counts = jumps && expressions && (allows(Feature::Variable) || allows(Feature::LocalVariable));
        let calls = allows(Feature::Subprogram)
            && allows(Feature::ProgramName)
            && state.setup.options.user_task == 2
            && builder.choices_left();
        let compensated = state.compensation.is_on();
        let nested = control.steady && (control.loops > 1 || control.shared);
        match self {
            Self::Over => jumps,
            Self::Excursion => jumps && !compensated,
            Self::Known => jumps && expressions,
            Self::Unknown => {
                let changes = !control.unknown.is_empty() || !control.bounded.is_empty();
                jumps && expressions && changes && !compensated
            }
            Self::Passes => counts && !nested && !compensated && !builder.is_modal_motion() && rapid(builder),
            Self::Steps => {
                counts
                    && !control.steady
                    && !compensated
                    && !builder.is_modal_motion()
                    && !state.barriers.is_watched()
                    && allows(Feature::Incremental)
                    && rapid(builder)
            }
            Self::Endless => jumps && control.loops == 0 && control.depth == 0,
            Self::Local => expressions && allows(Feature::LocalVariable),
            Self::Call => calls,
            Self::Recursion => calls && counts && !control.steady && control.depth == 0 && !compensated,
            Self::Modal => {
                calls && allows(Feature::ModalCall) && control.modally == 0 && control.modes.len() < 8
            }
            Self::Varied => expressions && !control.bounded.is_empty() && !compensated && rapid(builder),
        }
    }
}

/// Whether positions can be taken in G90 and G00.
fn rapid(builder: &Builder<'_, '_, '_>) -> bool {
    builder.allows(Feature::Rapid) && builder.allows(Feature::Absolute)
}

/// Whether a profile has something for control flow.
pub(crate) fn is_within(profile: &Profile) -> bool {
    [Feature::ControlStatement, Feature::LocalVariable, Feature::Subprogram]
        .iter()
        .any(|feature| profile.allows(*feature))
}

impl Builder<'_, '_, '_> {
    /// Whether there is a decision left: calls within calls end with the bytes.
    fn choices_left(&self) -> bool {
        !self.choices.is_empty()
    }

    /// Whether a modal call is active whose program moves.
    pub(crate) fn is_modal_motion(&self) -> bool {
        self.state.control.modes.iter().any(|mode| mode.called.moves())
    }

    /// A construction of control flow, or an auxiliary block when none fits here.
    pub(crate) fn control(&mut self) {
        let list: Vec<_> =
            Construction::ALL.into_iter().filter(|(_, construction)| construction.is_within(self)).collect();
        if list.is_empty() {
            return self.auxiliary();
        }
        match self.choices.weighted(&list) {
            Construction::Over => self.jump_over(),
            Construction::Known => self.known_condition(),
            Construction::Unknown => self.unknown_condition(),
            Construction::Excursion => self.excursion(),
            Construction::Passes => self.passes(),
            Construction::Steps => self.steps(),
            Construction::Endless => self.endless(),
            Construction::Local => self.local_block(),
            Construction::Call => self.call(),
            Construction::Recursion => self.recursion(),
            Construction::Modal => self.modal(),
            Construction::Varied => self.varied(),
        }
    }

    /// Whether a kind of block may stand here.
    pub(crate) fn permits_kind(&self, kind: Kind) -> bool {
        self.state.control.permits(kind) && self.state.turrets.permits(kind, self.state.control.steady)
    }

    /// Adds a statement with what follows it.
    pub(crate) fn statement(&mut self, statement: Statement, items: Vec<Item>) {
        if statement == Statement::Noex || statement.is_communication() {
            self.state.compensation.note_block(&items);
        }
        let sequence = self.next_name();
        let delete = self.deletable();
        self.state.control.jumps |= !statement.is_communication();
        self.lines.push(Line::Block(Block { delete, sequence, statement: Some(statement), items }));
    }

    /// A sequence name that this program does not have yet.
    pub(crate) fn new_name(&mut self) -> String {
        if let Some(name) = self.sequence_name() {
            return name;
        }
        let free = (0..).map(|number| format!("Q{number}"));
        let name = free.into_iter().find(|name| !self.state.names.contains(name)).unwrap_or_default();
        self.state.names.insert(name.clone());
        name
    }

    /// Gives the next block this name.
    pub(crate) fn set_label(&mut self, name: String) {
        self.settle_label();
        self.state.control.label = Some(name);
    }

    /// A block with this name: one that does something, or the name alone.
    fn labelled(&mut self, name: String) {
        self.set_label(name);
        if self.choices.chance(60) && !self.choices.is_empty() {
            self.ordinary_block();
        }
        self.settle_label();
    }

    /// Writes a name that no block has taken.
    pub(crate) fn settle_label(&mut self) {
        if let Some(name) = self.state.control.take_label() {
            let skipped = self.state.setup.switches.block_delete && self.choices.chance(25);
            let delete = skipped || self.deletable();
            let items = if skipped { vec![Item::g(0), Item::whole("X", 5)] } else { Vec::new() };
            self.lines.push(Line::Block(Block { delete, sequence: Some(name), items, ..Block::default() }));
        }
    }
}

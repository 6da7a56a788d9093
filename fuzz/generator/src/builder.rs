//! Grows a program block by block: chooses what comes next, places the fault, ends the program.

use turnspec_oracle::vocabulary::{Feature, MachineType};

use crate::choices::Choices;
use crate::contour;
use crate::control;
use crate::cutter;
use crate::cycles;
use crate::faults::{self, Fault};
use crate::io;
use crate::lap;
use crate::print;
use crate::profile::Profile;
use crate::program::{Block, Item, Line};
use crate::state::{Mode, State};
use crate::threads;

/// The characters that the expressions of one block may take together.
const EXPRESSION_ROOM: usize = 70;

/// A program that is being written, and the state that its end is in.
pub(crate) struct Builder<'b, 'c, 'd> {
    pub(crate) choices: &'b mut Choices<'c, 'd>,
    pub(crate) state: State,
    pub(crate) lines: Vec<Line>,
    /// How often, in a hundred, a value is written as an expression.
    pub(crate) expressions: usize,
    /// Characters left for expressions in the present block.
    pub(crate) room: usize,
    /// What the program may need of an implementation.
    pub(crate) profile: Profile,
    /// The same of the whole program: a side of a machine with two saddles may need less.
    pub(crate) whole: Profile,
    /// How often a block is one of control flow.
    pub(crate) control: usize,
    /// Whether the program is to have contours.
    pub(crate) contours: bool,
    /// Whether the program is to have cutter radius compensation.
    pub(crate) cutters: bool,
    /// Whether the program is to have threads.
    pub(crate) threads: bool,
    /// Whether the program is to have cycles of grooving, drilling and tapping.
    pub(crate) cycles: bool,
    /// Whether the program is to have LAP.
    pub(crate) lap: bool,
    /// Constructions of control flow around the present place.
    pub(crate) nesting: usize,
    /// Blocks that the program may still get.
    left: usize,
    /// Whether a fault came behind which nothing is to come.
    spoilt: bool,
    /// The fault that is to come, and after how many blocks.
    due: Option<(usize, Fault)>,
    /// The kinds of blocks with their weights.
    kinds: Vec<(usize, Kind)>,
}

/// A kind of block.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    Rapid,
    Linear,
    Arc,
    Taper,
    Chamfer,
    Auxiliary,
    Modes,
    Dwell,
    Shift,
    Torque,
    Assignment,
    CAxis,
    Filler,
    StartUp,
    ContourLine,
    ContourArc,
    Repetition,
    Idle,
    Cancel,
    Control,
    Barrier,
    Io,
    Turret,
    Contour,
    Thread,
    Cycle,
    Lap,
    Cutter,
}

const KINDS: &[(usize, Kind)] = &[
    (14, Kind::Rapid),
    (20, Kind::Linear),
    (16, Kind::Arc),
    (6, Kind::Taper),
    (8, Kind::Chamfer),
    (7, Kind::Auxiliary),
    (6, Kind::Modes),
    (3, Kind::Dwell),
    (4, Kind::Shift),
    (4, Kind::Torque),
    (8, Kind::Assignment),
    (4, Kind::CAxis),
    (4, Kind::Filler),
    (34, Kind::Turret),
];

/// How often a block begins compensation, in programs that are to have it and in others.
const START_UPS: (usize, usize) = (40, 1);

/// How often a run of contours comes in programs that are to have them.
const CONTOURS: usize = 60;
/// The same in programs that are to have threads, and how often a block cuts one there.
const BESIDE_THREADS: usize = 8;
const THREADS: usize = 70;

/// How often a run of cutter radius compensation comes in programs that are to have it, and how often contours without it do there.
const CUTTERS: usize = 60;
const BESIDE_CUTTERS: usize = 8;

/// How often a block cuts grooves or holes in programs that are to have them.
const CYCLES: usize = 60;

/// How often a block is a definition of LAP with its calls, in programs that are to have them.
const LAPS: usize = 40;

/// How often a block is one of control flow, in programs that are to have it.
const CONTROL: usize = 44;

/// How often a block goes to the edge of a barrier, in programs that are to have barriers.
const BARRIER: usize = 24;

/// How often a block is one of input and output, in programs that are to have it.
const IO: usize = 80;

/// The most constructions of control flow within each other.
const NESTING: usize = 6;

impl Kind {
    /// Whether a profile has something for blocks of this kind.
    pub(crate) fn is_within(self, profile: &Profile) -> bool {
        let any = |features: &[Feature]| features.iter().any(|feature| profile.allows(*feature));
        let feed = profile.allows(Feature::Feed);
        match self {
            Self::Rapid => any(&[Feature::Rapid]),
            Self::Linear | Self::ContourLine | Self::Repetition => feed && any(&[Feature::Linear]),
            Self::Arc | Self::ContourArc => feed && any(&[Feature::Arc]),
            Self::Taper => any(&[Feature::AnyAngle]),
            Self::Chamfer => feed && any(&[Feature::Chamfer, Feature::Rounding, Feature::AnyAngle]),
            Self::Dwell => any(&[Feature::Dwell]),
            Self::Shift => any(&[Feature::ZeroShift, Feature::Spindle]),
            Self::Torque => any(&[Feature::Torque]),
            Self::Assignment => any(&[Feature::Variable, Feature::SystemVariable]),
            Self::CAxis => any(&[Feature::CAxis]),
            Self::Auxiliary | Self::Modes | Self::Filler => true,
            Self::StartUp | Self::Idle | Self::Cancel => any(&[Feature::RadiusCompensation]),
            Self::Control => control::is_within(profile),
            Self::Barrier => any(&[Feature::Barrier]),
            Self::Io => io::is_within(profile),
            Self::Turret => any(&[Feature::TwoTurrets]),
            Self::Contour => contour::is_within(profile),
            Self::Thread => threads::is_within(profile),
            Self::Cycle => cycles::is_within(profile),
            Self::Lap => lap::is_within(profile),
            Self::Cutter => cutter::is_within(profile),
        }
    }
}

/// How often a block is written anew when it leaves the profile.
pub(crate) const ATTEMPTS: usize = 20;

impl<'b, 'c, 'd> Builder<'b, 'c, 'd> {
    /// A program that begins in this state.
    pub(crate) fn new(choices: &'b mut Choices<'c, 'd>, mut state: State, profile: Profile) -> Self {
        let expressions = choices.pick(&[0, 3, 10, 40]);
        let expressions = if profile.allows(Feature::Expression) { expressions } else { 0 };
        let (many, few) = START_UPS;
        let (start_ups, threads, contours, cycles, laps, cutters) = match choices.below(100) {
            60.. => (many, 0, 0, 0, 0, 0),
            47..60 if threads::is_within(&profile) => (BESIDE_THREADS, THREADS, 0, 0, 0, 0),
            40..47 if contour::is_within(&profile) => (few, 0, CONTOURS, 0, 0, 0),
            31..40 if cycles::is_within(&profile) => (BESIDE_THREADS, 0, 0, CYCLES, 0, 0),
            21..31 if lap::is_within(&profile) => (few, 0, 0, 0, LAPS, 0),
            13..21 if cutter::is_within(&profile) => (few, 0, BESIDE_CUTTERS, 0, 0, CUTTERS),
            _ => (few, 0, 0, 0, 0, 0),
        };
        if threads > 0 {
            threads::set_up(&mut state.setup, choices, &profile);
        }
        if contours > 0 {
            contour::set_up(&mut state.setup, choices);
        }
        if cutters > 0 {
            cutter::set_up(&mut state, choices);
        }
        if cycles > 0 {
            cycles::set_up(&mut state.setup, choices, &profile);
        }
        if laps > 0 {
            lap::set_up(&mut state.setup, choices, &profile);
        }
        let control = if choices.chance(50) { CONTROL + (threads + cycles) / 3 } else { 0 };
        let barrier = if state.barriers.is_wanted() { BARRIER } else { 0 };
        let io = if state.io.is_wanted() { IO } else { 0 };
        let special = [
            (contours, Kind::Contour),
            (start_ups, Kind::StartUp),
            (control, Kind::Control),
            (barrier, Kind::Barrier),
            (io, Kind::Io),
            (threads, Kind::Thread),
            (cycles, Kind::Cycle),
            (laps, Kind::Lap),
            (cutters, Kind::Cutter),
        ];
        let kinds = KINDS.iter().copied().chain(special);
        let kinds = kinds.filter(|(_, kind)| kind.is_within(&profile)).collect();
        let profile = profile.on(state.setup.machine.r#type);
        state.environment.restrict(&profile);
        Self {
            choices,
            state,
            lines: Vec::new(),
            expressions,
            room: 0,
            profile,
            whole: profile,
            control,
            contours: contours > 0,
            cutters: cutters > 0,
            threads: threads > 0,
            cycles: cycles > 0,
            lap: laps > 0,
            nesting: 0,
            left: 0,
            spoilt: false,
            due: None,
            kinds,
        }
    }

    /// The same without control flow, input and output.
    pub(crate) fn straight_on(mut self) -> Self {
        self.control = 0;
        self.state.setup.schedule = false;
        self.kinds.retain(|(_, kind)| !matches!(kind, Kind::Control | Kind::Io));
        self
    }

    /// Whether the program is to have blocks that count as steps more than once: cycles of any family.
    pub(crate) fn has_passes(&self) -> bool {
        self.threads || self.cycles || self.lap
    }

    /// Whether a feature is allowed.
    pub(crate) fn allows(&self, feature: Feature) -> bool {
        self.profile.allows(feature)
    }

    /// Adds lines that stay within the profile: what does not is taken back, and left out after a number of
    /// attempts. False when nothing was added.
    pub(crate) fn within_profile(&mut self, attempts: usize, write: impl Fn(&mut Self) -> bool) -> bool {
        if self.profile.is_full() {
            return write(self);
        }
        for _ in 0..attempts {
            let (state, lines) = (self.state.clone(), self.lines.len());
            let (left, due) = (self.left, self.due);
            let (tail, programs) = self.state.control.written();
            let written = write(self);
            let mut texts = vec![self.text_of(self.lines.get(lines..).unwrap_or_default())];
            texts.extend(self.state.control.texts_from(tail, programs).map(|lines| self.text_of(lines)));
            if written && texts.iter().all(|text| self.profile.permits_text(text, state.mode)) {
                return true;
            }
            (self.state, self.left, self.due) = (state, left, due);
            self.lines.truncate(lines);
        }
        false
    }

    /// The plainest text of some lines.
    pub(crate) fn text_of(&self, lines: &[Line]) -> Vec<u8> {
        let mut text = Vec::new();
        for line in lines {
            // A line that begins with $ is a header at the beginning of a text only.
            text.push(b'\n');
            match line {
                Line::Raw(bytes) => text.extend_from_slice(bytes),
                Line::Block(block) => text.extend_from_slice(print::plain(block).as_bytes()),
            }
        }
        text
    }

    /// Writes the whole program.
    pub(crate) fn build(&mut self) {
        if self.state.setup.schedule {
            return self.build_schedule();
        }
        if self.state.setup.machine.r#type == MachineType::TwoSaddles {
            return self.build_sides();
        }
        let size = 1 + self.choices.below(40).min(1 + self.choices.below(40));
        let faulty = self.choices.chance(35) && self.allows(Feature::Alarm);
        let fault = faulty.then(|| self.any_fault());
        let place = match fault {
            Some(fault) if faults::is_first(fault) => 0,
            Some(fault) if faults::is_early(fault) => self.choices.below(3),
            Some(_) => self.choices.late(size + 1),
            None => usize::MAX,
        };
        if !fault.is_some_and(faults::is_first) && self.allows(Feature::ProgramName) {
            self.within_profile(ATTEMPTS, Self::beginning);
        }
        let guarded = self.state.barriers.is_wanted() && !fault.is_some_and(faults::is_first);
        if guarded && self.choices.chance(75) {
            self.within_profile(1, Self::guarded);
        }
        self.left = size;
        self.due = fault.map(|fault| (place, fault));
        while self.left > 0 {
            self.grow_block();
        }
        if self.state.compensation.has_to_go_on() && self.choices.chance(92) {
            self.within_profile(ATTEMPTS, Self::next_block);
        }
        if fault != Some(Fault::NoProgramEnd) && !self.within_profile(ATTEMPTS, Self::ending) {
            self.raw(b"M02");
        }
    }

    /// Adds the next block, or several that belong together, or the fault when its turn has come.
    pub(crate) fn grow_block(&mut self) {
        if self.left == 0 {
            return;
        }
        self.left -= 1;
        match &mut self.due {
            Some((0, fault)) => {
                let fault = *fault;
                self.due = None;
                if self.try_fault(fault) {
                    self.left = 0;
                    self.spoilt = true;
                }
            }
            Some((place, _)) => *place -= 1,
            None => {}
        }
        if self.choices.is_empty() {
            self.left = 0;
        }
        if self.left > 0 {
            self.within_profile(ATTEMPTS, Self::next_block);
        }
    }

    /// A fault that comes after a number of blocks.
    pub(crate) fn fault_in(&mut self, fault: Fault, place: usize) {
        self.due = (!faults::is_first(fault)).then_some((place, fault));
    }

    /// Whether a fault was placed behind which nothing more is to come.
    pub(crate) fn is_spoilt(&self) -> bool {
        self.spoilt
    }

    /// Begins a program that runs beside the one before: no fault is to come in it.
    pub(crate) fn begin_side(&mut self) {
        (self.spoilt, self.due) = (false, None);
    }

    /// Leaves only what such a profile has.
    pub(crate) fn narrow(&mut self, profile: Profile) {
        self.profile = profile;
        self.state.environment.restrict(&profile);
        self.control = if control::is_within(&profile) { self.control } else { 0 };
        self.kinds.retain(|(_, kind)| kind.is_within(&profile));
    }

    /// Adds about so many blocks.
    pub(crate) fn grow_blocks(&mut self, count: usize) {
        self.left = count;
        while self.left > 0 {
            self.grow_block();
        }
    }

    /// Allows so many blocks more.
    pub(crate) fn allow_blocks(&mut self, count: usize) {
        self.left = count;
    }

    /// Lets the program end here.
    pub(crate) fn nothing_more(&mut self) {
        self.left = 0;
    }

    /// A block outside the count of blocks.
    pub(crate) fn ordinary_block(&mut self) {
        self.within_profile(ATTEMPTS, Self::next_block);
    }

    /// Tries to place a fault, and if the set-up does not let it happen, another one.
    pub(crate) fn try_fault(&mut self, fault: Fault) -> bool {
        let profile = std::mem::replace(&mut self.profile, self.whole);
        let spoils = self.place_fault(fault);
        self.profile = profile;
        spoils
    }

    fn place_fault(&mut self, fault: Fault) -> bool {
        if self.within_profile(3, |builder| builder.fault(fault)) {
            return self.choices.chance(70);
        }
        let other = self.any_fault();
        !faults::is_first(other)
            && self.within_profile(3, |builder| builder.fault(other))
            && self.choices.chance(70)
    }

    /// Header, `%`, program name.
    pub(crate) fn beginning(&mut self) -> bool {
        if !self.state.is_eia() && self.choices.chance(8) {
            let list: [&[u8]; 5] = [b"$SHAFT-1.MIN%", b"$A.MIN% ", b"$PART%", b"$X.Y.LIB %", b"$%"];
            let text = self.choices.pick(&list);
            self.raw(text);
        }
        if self.choices.chance(8) {
            self.raw(b"%");
        }
        if self.choices.chance(35) {
            let list: [&[u8]; 7] = [b"O1", b"O1234", b"OA", b"OABCD", b"OX12", b"O0", b"OTEST"];
            let mut name = self.choices.pick(&list);
            if !self.state.is_eia() && self.choices.chance(15) {
                name = self.choices.pick(&[b":1".as_slice(), b":PART", b":Z9"]);
            }
            let tail: &[u8] = if self.choices.chance(15) { b" (SHAFT)" } else { b"" };
            let known = String::from_utf8_lossy(&name[1..]).into_owned();
            self.state.control.main = Some(known.clone());
            self.state.control.names.insert(known);
            self.raw(&[name, tail].concat());
        }
        true
    }

    /// M02 or M30, with what may stand beside and after it.
    pub(crate) fn ending(&mut self) -> bool {
        self.begin();
        let mut items = Vec::new();
        if self.choices.chance(10) {
            self.companions(&mut items);
        }
        items.push(Item::m(if self.choices.chance(30) { 30 } else { 2 }));
        self.push(items);
        if !self.definitions_behind() && self.choices.chance(10) {
            let list: [&[u8]; 4] = [b"%", b"G00 X1", b"REMNANT )", b"O2"];
            let behind = if self.state.control.has_tail() { 3 } else { list.len() };
            let text = self.choices.pick(&list[..behind]);
            self.raw(text);
        }
        true
    }

    fn next_block(&mut self) -> bool {
        self.begin();
        if self.state.barriers.is_watched() {
            self.clear_of_barriers();
        }
        let compensated = self.state.compensation.is_on();
        let kind = if compensated { self.compensated_kind() } else { self.free_kind() };
        let may_not_fit = compensated || self.state.barriers.is_watched();
        // Blocks of control flow fit one by one.
        if may_not_fit && !matches!(kind, Kind::Control) {
            self.fitting(|builder| builder.block_of(kind));
        } else {
            self.block_of(kind);
        }
        true
    }

    /// The kind of the next block without compensation.
    fn free_kind(&mut self) -> Kind {
        for _ in 0..ATTEMPTS {
            let Self { choices, kinds, .. } = &mut *self;
            let kind = choices.weighted(kinds);
            if self.permits_kind(kind) {
                return kind;
            }
        }
        Kind::Auxiliary
    }

    /// Adds a block of a kind, or several that belong together.
    pub(crate) fn block_of(&mut self, kind: Kind) {
        match kind {
            Kind::Rapid => self.line(Mode::Rapid),
            Kind::Linear => self.line(Mode::Linear),
            Kind::Arc => self.arc(),
            Kind::Taper => self.taper(),
            Kind::Chamfer => self.chamfer(),
            Kind::Auxiliary => self.auxiliary(),
            Kind::Modes => self.modes(),
            Kind::Dwell => self.dwell(),
            Kind::Shift => self.shift(),
            Kind::Torque => self.torque(),
            Kind::Assignment => self.assignment(),
            Kind::CAxis => self.c_axis(),
            Kind::Filler => self.filler(),
            Kind::StartUp => self.start_up(),
            Kind::ContourLine => self.contour_line(),
            Kind::ContourArc => self.contour_arc(),
            Kind::Repetition => self.repetition(),
            Kind::Idle => self.idle(),
            Kind::Cancel => self.cancel(),
            Kind::Control if self.nesting < NESTING => {
                self.nesting += 1;
                self.control();
                self.nesting -= 1;
            }
            Kind::Control => self.auxiliary(),
            Kind::Barrier => self.barrier(),
            Kind::Io => self.io(),
            Kind::Turret => self.turret_block(),
            Kind::Contour => self.contours(),
            Kind::Thread => self.thread(),
            Kind::Cycle => self.cycle(),
            Kind::Lap => self.lap(),
            Kind::Cutter => self.cutter(),
        }
    }

    /// Begins a block: its expressions read the state as it is now.
    pub(crate) fn begin(&mut self) {
        self.state.begin_block();
        self.room = EXPRESSION_ROOM;
    }

    /// Begins a block that is evaluated while the block before it still waits for its motion: its expressions
    /// read no positions.
    pub(crate) fn begin_ahead(&mut self) {
        self.state.environment.system.clear();
        self.room = EXPRESSION_ROOM;
    }

    /// Adds a block of these words, in another order now and then.
    pub(crate) fn push(&mut self, mut items: Vec<Item>) {
        self.state.compensation.note_block(&items);
        let assigns = items.iter().any(|item| matches!(item, Item::Assignment(..) | Item::Comment(..)));
        if !assigns && self.choices.chance(15) {
            self.choices.shuffle(&mut items);
        }
        let sequence = self.next_name();
        let delete = self.deletable();
        self.lines.push(Line::Block(Block { delete, sequence, items: items.clone(), ..Block::default() }));
        self.trigger(&items);
        if self.state.setup.switches.block_delete && self.choices.chance(10) {
            self.skipped();
        }
    }

    /// The name that the next block has to get, or one now and then.
    pub(crate) fn next_name(&mut self) -> Option<String> {
        if let Some(name) = self.state.control.take_label() {
            return Some(name);
        }
        let named = self.choices.chance(15) && self.allows(Feature::SequenceName);
        named.then(|| self.sequence_name()).flatten()
    }

    /// Whether the next block carries a mark of block delete that does not act.
    pub(crate) fn deletable(&mut self) -> bool {
        !self.state.setup.switches.block_delete && self.choices.chance(3) && self.allows(Feature::BlockDelete)
    }

    /// Adds a line as it stands.
    pub(crate) fn raw(&mut self, text: &[u8]) {
        self.lines.push(Line::Raw(text.to_vec()));
    }

    /// A sequence name that the program does not have yet.
    pub(crate) fn sequence_name(&mut self) -> Option<String> {
        let name = match self.choices.below(4) {
            0 => {
                const LETTERS: &[u8] = b"ABCXZTG";
                let letters = (0..=self.choices.below(5)).map(|_| char::from(self.choices.pick(LETTERS)));
                letters.collect()
            }
            1 => format!("{:05}", self.choices.within(0, 99_999)),
            2 => format!("A{}", self.choices.within(0, 9_999)),
            _ => self.choices.within(0, 999).to_string(),
        };
        self.state.names.insert(name.clone()).then_some(name)
    }

    /// A block that the block delete switch skips: whatever stands after the slash.
    fn skipped(&mut self) {
        let named = self.choices.chance(30) && self.allows(Feature::SequenceName);
        if let Some(name) = named.then(|| self.sequence_name()).flatten() {
            let items = vec![Item::g(0), Item::whole("X", 5)];
            let block = Block { delete: true, sequence: Some(name), items, ..Block::default() };
            self.lines.push(Line::Block(block));
            return;
        }
        let list: [&[u8]; 6] =
            [b"/G00 X5", b"/ G05 NONSENSE ))", b"/", b"/M02", b"/G00 (OPEN", b"/V1=V2/0 GOTO"];
        let allowed = if self.state.is_eia() { 1 } else { list.len() };
        let text = self.choices.pick(&list[..allowed]);
        self.raw(text);
    }

    /// A line that is no block, or a block that does nothing.
    fn filler(&mut self) {
        let list: [&[u8]; 7] = [b"", b"  ", b"(FINISH)", b"%", b"\t(A)\t(B)", b"( (( )", b" % "];
        let place = self.choices.below(list.len() + 1);
        match list.get(place) {
            Some(text) => self.raw(text),
            None => {
                let sequence = self.sequence_name();
                self.lines.push(Line::Block(Block { sequence, ..Block::default() }));
            }
        }
    }
}

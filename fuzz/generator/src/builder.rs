//! Grows a program block by block: chooses what comes next, places the fault, ends the program.

use turnspec_oracle::vocabulary::Feature;

use crate::choices::Choices;
use crate::faults::{self, Fault};
use crate::print;
use crate::profile::Profile;
use crate::program::{Block, Item, Line, Program};
use crate::state::{Mode, State};

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
];

/// How often a block begins compensation, in programs that are to have it and in others.
const START_UPS: (usize, usize) = (40, 1);

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
        }
    }
}

/// How often a block is written anew when it leaves the profile.
const ATTEMPTS: usize = 20;

impl<'b, 'c, 'd> Builder<'b, 'c, 'd> {
    /// A program that begins in this state.
    pub(crate) fn new(choices: &'b mut Choices<'c, 'd>, mut state: State, profile: Profile) -> Self {
        let expressions = choices.pick(&[0, 3, 10, 40]);
        let expressions = if profile.allows(Feature::Expression) { expressions } else { 0 };
        let (many, few) = START_UPS;
        let start_ups = if choices.chance(40) { many } else { few };
        let kinds = KINDS.iter().copied().chain([(start_ups, Kind::StartUp)]);
        let kinds = kinds.filter(|(_, kind)| kind.is_within(&profile)).collect();
        state.environment.restrict(&profile);
        Self { choices, state, lines: Vec::new(), expressions, room: 0, profile, kinds }
    }

    /// Whether a feature is allowed.
    pub(crate) fn allows(&self, feature: Feature) -> bool {
        self.profile.allows(feature)
    }

    /// Adds lines that stay within the profile: what does not is taken back, and left out after a number of
    /// attempts. False when nothing was added.
    fn within_profile(&mut self, attempts: usize, write: impl Fn(&mut Self) -> bool) -> bool {
        if self.profile.is_full() {
            return write(self);
        }
        for _ in 0..attempts {
            let (state, lines) = (self.state.clone(), self.lines.len());
            if write(self) && self.profile.permits_text(&self.text_from(lines), state.mode) {
                return true;
            }
            self.state = state;
            self.lines.truncate(lines);
        }
        false
    }

    /// The plainest text of the lines from a place on.
    fn text_from(&self, place: usize) -> Vec<u8> {
        let mut text = Vec::new();
        for line in self.lines.get(place..).unwrap_or_default() {
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
        let size = 1 + self.choices.below(40).min(1 + self.choices.below(40));
        let faulty = self.choices.chance(35) && self.allows(Feature::Alarm);
        let fault = faulty.then(|| faults::choose(self.choices, &self.state.setup));
        let place = match fault {
            Some(fault) if faults::is_first(fault) => 0,
            Some(fault) if faults::is_early(fault) => self.choices.below(3),
            Some(_) => self.choices.late(size + 1),
            None => usize::MAX,
        };
        if !fault.is_some_and(faults::is_first) && self.allows(Feature::ProgramName) {
            self.within_profile(ATTEMPTS, Self::beginning);
        }
        for number in 0..size {
            if number == place && fault.is_some_and(|fault| self.try_fault(fault)) {
                break;
            }
            if self.choices.is_empty() {
                break;
            }
            self.within_profile(ATTEMPTS, Self::next_block);
        }
        if self.state.compensation.has_to_go_on() && self.choices.chance(92) {
            self.within_profile(ATTEMPTS, Self::next_block);
        }
        if fault != Some(Fault::NoProgramEnd) && !self.within_profile(ATTEMPTS, Self::ending) {
            self.raw(b"M02");
        }
    }

    /// Tries to place a fault, and if the set-up does not let it happen, another one.
    fn try_fault(&mut self, fault: Fault) -> bool {
        if self.within_profile(3, |builder| builder.fault(fault)) {
            return self.choices.chance(70);
        }
        let other = faults::choose(self.choices, &self.state.setup);
        !faults::is_first(other)
            && self.within_profile(3, |builder| builder.fault(other))
            && self.choices.chance(70)
    }

    /// Header, `%`, program name.
    fn beginning(&mut self) -> bool {
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
            self.raw(&[name, tail].concat());
        }
        true
    }

    /// M02 or M30, with what may stand beside and after it.
    fn ending(&mut self) -> bool {
        self.begin();
        let mut items = Vec::new();
        if self.choices.chance(10) {
            self.companions(&mut items);
        }
        items.push(Item::m(if self.choices.chance(30) { 30 } else { 2 }));
        self.push(items);
        if self.choices.chance(10) {
            let list: [&[u8]; 4] = [b"%", b"G00 X1", b"O2", b"REMNANT )"];
            let text = self.choices.pick(&list);
            self.raw(text);
        }
        true
    }

    fn next_block(&mut self) -> bool {
        self.begin();
        if self.state.compensation.is_on() {
            let kind = self.compensated_kind();
            self.fitting(|builder| builder.block_of(kind));
        } else {
            let Self { choices, kinds, .. } = self;
            let kind = choices.weighted(kinds);
            self.block_of(kind);
        }
        true
    }

    /// Adds a block of a kind, or several that belong together.
    fn block_of(&mut self, kind: Kind) {
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
        let assigns = items.iter().any(|item| matches!(item, Item::Assignment(..)));
        if !assigns && self.choices.chance(15) {
            self.choices.shuffle(&mut items);
        }
        let named = self.choices.chance(15) && self.allows(Feature::SequenceName);
        let sequence = named.then(|| self.sequence_name()).flatten();
        let delete = !self.state.setup.switches.block_delete
            && self.choices.chance(3)
            && self.allows(Feature::BlockDelete);
        self.lines.push(Line::Block(Block { delete, sequence, items }));
        if self.state.setup.switches.block_delete && self.choices.chance(10) {
            self.skipped();
        }
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
            self.lines.push(Line::Block(Block { delete: true, sequence: Some(name), items }));
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

    /// The program, and the state with the torque stops that it needs.
    pub(crate) fn finish(self) -> (Program, State) {
        (Program { lines: self.lines }, self.state)
    }
}

//! Which features generated programs and set-ups may need of an implementation.

use turnspec_oracle::vocabulary::{Chamfering, Feature, MachineType, Setup};

use crate::case::Case;
use crate::needs;
use crate::scan;
use crate::state::Mode;
use crate::tape;

/// What a program may need of an implementation: a set of features.
///
/// Where no feature names a piece of the language it goes with the nearest one:
///
/// | piece | feature |
/// |---|---|
/// | continuation lines | `program-name` |
/// | control characters, TAB and CR | `tape-code` |
/// | M00 | `optional-stop` |
/// | G13, G110 | `turret` |
/// | G64, G65 | `aux` |
/// | M152, M153 | `m-tool` |
/// | `=` before a single number | `expression` |
/// | I and K of a block that begins or ends compensation | `arc` |
/// | nose radius entries of the set-up | `tool` |
/// | G41 and G42 in G17 and G119 | `radius-compensation`, with `contour-generation`, `c-axis` and `tool` |
/// | zero offset of the set-up | `zero-shift` |
/// | lowest and highest speed of the spindle | `gear` |
/// | `NOEX`, the limit of the steps of a run | `control-statement` |
/// | name blocks of programs that are called | `program-name` |
/// | files of a schedule | `subprogram` |
/// | what devices send, the end code, strings and codes of `PUT` | `communication` |
/// | tool interference data, numbers of tools and tool groups | `system-variable` |
/// | data of turret B | those of A |
/// | M100 on two saddles | `two-saddles` |
/// | positionings and withdrawals of threads | `thread`, with `rapid` and `linear` |
/// | A, C and W of threads | `any-angle`, `c-axis`, `w-axis` |
/// | other words of threads, parameters of thread cutting | `thread` |
/// | motions of grooves and taps, the spindle of taps | `grooving`, with `rapid`, `linear` and `spindle` |
/// | motions of cycles of driven tools | `driven-cycle`, with `c-axis`, `m-tool`, `rapid` and `linear` |
/// | C and W of cycles, and E where it is a dwell | `c-axis`, `w-axis`, `dwell` |
/// | M codes of cycles | `aux` |
/// | motions and words of LAP, its parameters | `lap`, calls with `rapid` and `linear`, G88 with `thread` |
/// | what the blocks of a definition have besides | that of the same words elsewhere |
/// | the names of definitions | `sequence-name` |
/// | other words of cycles and their parameters | `grooving`, `driven-cycle` |
///
/// Schedule programs occur only with every feature allowed. M02 and M30 are always there. Readings other than the default ones occur with every feature
/// allowed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Profile {
    features: Features,
    readings: bool,
    /// The machine that the programs are for; some words are something else on another one.
    machine: MachineType,
}

impl Profile {
    /// Everything.
    pub const FULL: Self =
        Self { features: Features::of(Feature::ALL), readings: true, machine: MachineType::OneTurret };

    /// Programs that need nothing but these features.
    #[must_use]
    pub fn of(features: &[Feature]) -> Self {
        let features = Features::of(features);
        Self { features, readings: features == Self::FULL.features, machine: MachineType::OneTurret }
    }

    /// The same without some features.
    pub(crate) fn without(self, features: &[Feature]) -> Self {
        Self { features: self.features.less(Features::of(features)), ..self }
    }

    /// The same for programs of a machine.
    pub(crate) fn on(self, machine: MachineType) -> Self {
        Self { machine, ..self }
    }

    /// Whether a feature is allowed.
    #[must_use]
    pub fn allows(&self, feature: Feature) -> bool {
        self.features.contains(Features::of(&[feature]))
    }

    /// Whether set-ups may choose readings.
    #[must_use]
    pub fn allows_readings(&self) -> bool {
        self.readings
    }

    /// Whether every feature is allowed.
    #[must_use]
    pub fn is_full(&self) -> bool {
        self.features == Self::FULL.features
    }

    /// Whether a case stays within the profile, as far as its words tell: the same test that the generator
    /// applies to every block, for programs that were changed since, by [`crate::shrink`] for example.
    ///
    /// It does not tell whether the program runs into an alarm; an illegal character or an unknown word counts as
    /// one.
    #[must_use]
    pub fn permits(&self, case: &Case) -> bool {
        let code = case.setup.tape.code;
        let library = case.setup.library.values().map(|text| &text.0);
        let mut texts = library.chain([&case.program]).map(|text| tape::decode(text, code));
        let jumps =
            case.setup.limits.steps != Setup::default().limits.steps || !case.setup.library.is_empty();
        // In which mode a block is carried out that others jump to, its place in the text does not tell.
        let modes: &[Mode] = if jumps { &[Mode::Rapid, Mode::Linear] } else { &[Mode::Rapid] };
        let here = self.on(case.setup.machine.r#type);
        self.permits_setup(&case.setup)
            && texts.all(|text| modes.iter().any(|mode| here.permits_text(&text, *mode)))
    }

    /// Whether corners must be cut in the basic form: an any-angle corner looks ahead to its next line.
    pub(crate) fn has_basic_corners(&self) -> bool {
        let corners = self.allows(Feature::Chamfer) || self.allows(Feature::Rounding);
        corners && !self.allows(Feature::AnyAngle)
    }

    /// Whether a set-up stays within the profile.
    fn permits_setup(&self, setup: &Setup) -> bool {
        let any_angle = setup.parameters.chamfering == Chamfering::AnyAngle;
        self.features.contains(needs::of_setup(setup))
            && (self.readings || setup.readings == Setup::default().readings)
            && !(any_angle && self.has_basic_corners())
    }

    /// Whether a text that begins in a motion mode stays within the profile.
    pub(crate) fn permits_text(&self, text: &[u8], mode: Mode) -> bool {
        self.is_full() || self.features.contains(scan::needs_of(text, mode, self.machine))
    }
}

/// A set of features.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Features(u64);

impl Features {
    /// The set of these features.
    pub const fn of(features: &[Feature]) -> Self {
        let mut bits = 0;
        let mut place = 0;
        while place < features.len() {
            bits |= 1 << features[place] as u32;
            place += 1;
        }
        Self(bits)
    }

    /// Those that the other set lacks.
    pub fn less(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    /// The features of both sets.
    pub fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Adds features.
    pub fn add(&mut self, features: &[Feature]) {
        self.0 |= Self::of(features).0;
    }

    /// Whether it holds every feature of another set.
    pub fn contains(self, other: Self) -> bool {
        other.0 & !self.0 == 0
    }
}

//! Data communication, inputs and outputs, user alarms, tool interference data: what the generator knows of them, and
//! blocks with them.
//!
//! What the program has read, what it has put and what the inputs show is foreseen exactly, but for what runs more than
//! once: there a text is begun and sent within one construction, and inputs go to variables that change.

mod device;
mod inputs;
mod interference;
mod machine;
mod outputs;
mod receive;
mod records;
mod send;
mod string;

use turnspec_oracle::vocabulary::{Feature, Setup};

use crate::builder::Builder;
use crate::environment::Environment;
use crate::profile::Profile;

use inputs::Inputs;
use interference::Stored;

pub(crate) use device::transmission;
pub(crate) use interference::{NAMES as INTERFERENCE, unset};
pub(crate) use machine::machine;
pub(crate) use receive::number_at;

/// The characters that each of the areas holds (E100L-RDWR-05, E100L-GPUT-11).
pub(crate) const AREA: usize = 160;

/// What the generator believes of input and output.
#[derive(Clone, Debug)]
pub struct Io {
    /// Whether the program is to have such blocks.
    wanted: bool,
    /// What of the READ area lies behind the pointer.
    pub(crate) unread: Vec<u8>,
    /// How many texts of each device were read.
    pub(crate) taken: [usize; 10],
    /// The characters before the write pointer.
    pub(crate) written: usize,
    /// Input signals.
    inputs: Inputs,
    /// Tool interference data.
    stored: Stored,
}

impl Io {
    /// Nothing read and nothing written, with the devices and inputs of a set-up.
    #[must_use]
    pub fn new(setup: &Setup) -> Self {
        let plain = Setup::default();
        let wanted = !setup.devices.is_empty()
            || setup.inputs.vdin != plain.inputs.vdin
            || setup.inputs.vird != plain.inputs.vird
            || setup.inputs.vord != plain.inputs.vord
            || !setup.system_variables.is_empty();
        Self {
            wanted,
            unread: Vec::new(),
            taken: [0; 10],
            written: 0,
            inputs: Inputs::new(setup),
            stored: Stored::new(setup),
        }
    }

    /// Whether the program is to have blocks of input and output.
    #[must_use]
    pub fn is_wanted(&self) -> bool {
        self.wanted
    }

    /// Shows an expression which inputs and data it can read.
    pub fn show(&self, environment: &mut Environment) {
        environment.inputs.clear();
        if self.wanted {
            environment.inputs.extend(self.inputs.constant(environment.user_task_2));
        }
        environment.stored.clone_from(&self.stored.values);
    }
}

/// Whether a profile has something for blocks of this kind.
pub(crate) fn is_within(profile: &Profile) -> bool {
    [Feature::Communication, Feature::InputOutput, Feature::UserAlarm]
        .iter()
        .any(|feature| profile.allows(*feature))
}

/// What a block, or several, do with input and output.
#[derive(Clone, Copy)]
enum Construction {
    /// READ, and GET of some of it.
    Receive,
    /// PUT and WRITE.
    Send,
    /// A loop that reads.
    Records,
    /// An input in an expression.
    Input,
    /// An input in a condition.
    Question,
    /// An output.
    Output,
    /// A part of the comment of user alarms.
    Comment,
    /// User alarm C.
    Message,
    /// An assignment to tool interference data.
    Interference,
}

impl Construction {
    const ALL: [(usize, Self); 9] = [
        (26, Self::Receive),
        (26, Self::Send),
        (4, Self::Records),
        (14, Self::Input),
        (6, Self::Question),
        (10, Self::Output),
        (9, Self::Comment),
        (12, Self::Message),
        (10, Self::Interference),
    ];

    fn is_within(self, builder: &Builder<'_, '_, '_>) -> bool {
        let allows = |features: &[Feature]| features.iter().all(|feature| builder.allows(*feature));
        let state = &builder.state;
        let level_2 = state.setup.options.user_task == 2;
        let text = !state.is_eia();
        let steady = state.control.steady;
        let system = allows(&[Feature::SystemVariable, Feature::Expression]) && text;
        let jumps = allows(&[Feature::ControlStatement, Feature::SequenceName]);
        match self {
            Self::Receive => allows(&[Feature::Communication]) && level_2 && !steady,
            Self::Send => allows(&[Feature::Communication]) && level_2,
            Self::Records => {
                allows(&[Feature::Communication, Feature::Variable])
                    && system
                    && jumps
                    && level_2
                    && !steady
                    && !state.compensation.is_on()
            }
            Self::Input => {
                allows(&[Feature::InputOutput, Feature::Variable])
                    && system
                    && level_2
                    && !state.control.is_shared()
            }
            Self::Question => allows(&[Feature::InputOutput]) && system && jumps && level_2 && !steady,
            Self::Output => allows(&[Feature::InputOutput]) && system && level_2,
            Self::Comment => allows(&[Feature::UserAlarm]) && system,
            Self::Message => allows(&[Feature::UserAlarm, Feature::InputOutput]) && system && level_2,
            Self::Interference => system && !steady,
        }
    }
}

impl Builder<'_, '_, '_> {
    /// Blocks of input and output, or an auxiliary block when none fits here.
    pub(crate) fn io(&mut self) {
        let list: Vec<_> =
            Construction::ALL.into_iter().filter(|(_, construction)| construction.is_within(self)).collect();
        if list.is_empty() {
            return self.auxiliary();
        }
        match self.choices.weighted(&list) {
            Construction::Receive => self.receive(),
            Construction::Send => self.send(),
            Construction::Records => self.records(),
            Construction::Input => self.input(),
            Construction::Question => self.question(),
            Construction::Output => self.output(),
            Construction::Comment => self.comment(),
            Construction::Message => self.message(),
            Construction::Interference => self.interference(),
        }
    }
}

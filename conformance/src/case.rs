//! What a conformance case is, and when a trace satisfies it.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use turnspec_oracle::vocabulary::notation::Expectation;
use turnspec_oracle::vocabulary::{Control, Event, Feature, RuleId, Setup, SetupError};

use crate::{Figure, Flag, bytes_of_text};

/// One conformance case.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, expecting = "a case: a JSON object")]
pub struct Case {
    /// Permanent name: `e100l/s3-g75-anyangle`, or, of an example in a rule's text, the rule and the number of
    /// the example: `e100l/rules/E100L-G50-02/1`.
    pub id: String,
    /// What the case shows, in one line.
    pub title: String,
    /// Full ids of the rules that the case is about, such as `E100L-ANG-03`.
    #[cfg_attr(feature = "schema", schemars(with = "Vec<String>"))]
    pub rules: Vec<RuleId>,
    /// The control that runs the program.
    pub control: Control,
    /// What an implementation needs to be able to run the case.
    pub features: Vec<Feature>,
    /// Where the case comes from and what it depends on.
    pub flags: Vec<Flag>,
    /// Place in the manual, such as `section 3, 4-3, page 34`.
    pub source: String,
    /// Whether the manual settles the expected trace.
    pub basis: Basis,
    /// What was repaired in, or added to, the printed program, in one sentence.
    pub repairs: String,
    /// The part program, one character a byte (U+0000 to U+00FF); lines end with LF.
    pub program: String,
    /// The set-up; same structure as a set-up file, every field optional.
    #[cfg_attr(feature = "schema", schemars(with = "Setup"))]
    pub setup: Map<String, Value>,
    /// The expected trace in compact notation, one line an event. A line `...` stands for any number of
    /// events; without such a line every event is there.
    pub expect: Vec<String>,
    /// The figures that the manual itself prints.
    pub stated: Vec<Figure>,
    /// How the expected trace follows from the rules.
    pub derivation: String,
}

/// Whether the manual settles the expected trace of a case.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Basis {
    /// It does.
    Manual,
    /// The manual is silent, damaged or contradictory; the rule's text gives the reasons of the choice.
    Interpretation,
    /// It does not, and the oracle declines to guess: the trace ends in `unspecified`.
    Unspecified,
}

impl Case {
    /// The set-up, with its values checked.
    ///
    /// # Errors
    /// Names the first field that is unknown or impossible, or the control that differs from the case's.
    pub fn setup(&self) -> Result<Setup, SetupError> {
        let fault = |message: String| SetupError { message, span: None };
        let setup: Setup = serde_json::from_value(Value::Object(self.setup.clone()))
            .map_err(|error| fault(error.to_string()))?;
        setup.validate()?;
        if setup.control != self.control {
            return Err(fault("the set-up is for another control".to_owned()));
        }
        Ok(setup)
    }

    /// The bytes of the program; `None` when it has a character above U+00FF.
    #[must_use]
    pub fn program_bytes(&self) -> Option<Vec<u8>> {
        bytes_of_text(&self.program)
    }

    /// Compares a trace with the expected one, and with the figures that the manual prints.
    ///
    /// # Errors
    /// The first divergence, in words.
    pub fn check(&self, trace: &[Event]) -> Result<(), String> {
        if let Some((expected, event)) = (1..).zip(trace).find(|(ordinal, event)| event.n != *ordinal) {
            return Err(format!("event {expected} is numbered {}", event.n));
        }
        Expectation::parse(&self.expect.join("\n")).matches(trace)?;
        self.stated.iter().try_for_each(|figure| figure.check(trace))
    }
}

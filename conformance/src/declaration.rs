//! What an implementation declares: what it has, what it reports, how exact it is, what may fail.

use std::collections::BTreeSet;
use std::fmt;

use serde::Deserialize;
use turnspec_oracle::vocabulary::{Control, Feature, RuleId};

use crate::observation::{KINDS, is_field};
use crate::{Divergence, Tolerance};

/// The difference of two kinds of event.
const KIND: &str = "kind";

/// A declaration, `--declare impl.toml`.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Declaration {
    /// Name of the implementation.
    pub name: String,
    /// Its version.
    pub version: Option<String>,
    /// The controls that it has; all without a list.
    pub controls: Option<Vec<Control>>,
    /// The features that it has; all without a list.
    pub features: Option<BTreeSet<Feature>>,
    /// The kinds of event that it reports; all without a list.
    pub events: Option<BTreeSet<String>>,
    /// Fields in compact notation that it does not report.
    #[serde(default)]
    pub omits: BTreeSet<String>,
    /// How alarms are compared.
    #[serde(default)]
    pub alarms: Alarms,
    /// What is demanded where the expected trace ends in `unspecified` or `not_modelled`.
    #[serde(default)]
    pub undecided: Undecided,
    /// What exit status 3 counts as although every feature is declared.
    #[serde(default)]
    pub refusals: Refusals,
    /// Largest permitted differences.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Failures that are known and permitted.
    #[serde(default, rename = "waiver")]
    pub waivers: Vec<Waiver>,
}

/// How alarms are compared.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Alarms {
    /// By their fields, as every other event.
    #[default]
    Named,
    /// That there is one is enough.
    Any,
}

/// What is demanded where the expected trace ends in the alarm `unspecified` or `not_modelled`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Undecided {
    /// Nothing from there on: whatever the implementation does, and exit status 3, is right.
    #[default]
    Free,
    /// The alarm itself, as Turnspec raises it.
    Alarm,
}

/// What exit status 3 counts as although every feature is declared.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Refusals {
    /// A failure.
    #[default]
    Fail,
    /// A case that is skipped: features are too coarse to tell what the implementation has.
    Skip,
}

/// A failure that is known and permitted.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(try_from = "WaiverTable")]
pub struct Waiver {
    /// What may fail.
    pub subject: Subject,
    /// The only field that may differ first, or `kind`: another event, or none, in the place of the expected one.
    pub field: Option<String>,
    /// Text that the implementation's event must hold in compact notation.
    pub got: Option<String>,
    /// Why.
    pub reason: String,
}

/// What a waiver is about.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Subject {
    /// The case with this id.
    Case(String),
    /// Every case about this rule.
    Rule(RuleId),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WaiverTable {
    case: Option<String>,
    rule: Option<RuleId>,
    field: Option<String>,
    got: Option<String>,
    reason: String,
}

impl TryFrom<WaiverTable> for Waiver {
    type Error = &'static str;

    fn try_from(table: WaiverTable) -> Result<Self, Self::Error> {
        if table.reason.trim().is_empty() {
            return Err("a waiver needs a reason");
        }
        let subject = match (table.case, table.rule) {
            (Some(case), None) => Subject::Case(case),
            (None, Some(rule)) => Subject::Rule(rule),
            _ => return Err("a waiver names either a case or a rule"),
        };
        if table.field.as_ref().is_some_and(|field| field != KIND && !is_field(field)) {
            return Err("the field of a waiver is `kind`, or a field of compact notation");
        }
        Ok(Self { subject, field: table.field, got: table.got, reason: table.reason })
    }
}

impl Waiver {
    /// Whether it is limited to a part of the divergences that its subject may show.
    #[must_use]
    pub fn is_limited(&self) -> bool {
        self.field.is_some() || self.got.is_some()
    }

    /// Whether a divergence is of the kind that it permits.
    #[must_use]
    pub fn covers(&self, divergence: &Divergence) -> bool {
        let first = divergence.differences.first().map_or(KIND, |difference| difference.field.as_str());
        let got = divergence.actual.as_ref().map(ToString::to_string).unwrap_or_default();
        self.field.as_ref().is_none_or(|field| field == first)
            && self.got.as_ref().is_none_or(|text| got.contains(text.as_str()))
    }
}

impl Declaration {
    /// The declaration of an implementation that claims everything and is exact.
    #[must_use]
    pub fn of_everything(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            version: None,
            controls: None,
            features: None,
            events: None,
            omits: BTreeSet::new(),
            alarms: Alarms::default(),
            undecided: Undecided::default(),
            refusals: Refusals::default(),
            tolerance: Tolerance::default(),
            waivers: Vec::new(),
        }
    }

    /// Reads a declaration file.
    ///
    /// # Errors
    /// When the text is no TOML, has unknown keys or impossible values; the message shows the place.
    pub fn from_toml(text: &str) -> Result<Self, DeclarationError> {
        let declaration: Self = toml::from_str(text)
            .map_err(|error| DeclarationError(error.to_string().trim_end().to_owned()))?;
        let fault = |text: String| Err(DeclarationError(text));
        let mut kinds = declaration.events.iter().flatten();
        if let Some(kind) = kinds.find(|kind| !KINDS.contains(&kind.as_str())) {
            return fault(format!("events: there is no kind {kind:?}; the kinds are {}", KINDS.join(", ")));
        }
        if let Some(field) = declaration.omits.iter().find(|field| !is_field(field)) {
            return fault(format!("omits: compact notation has no field {field:?}"));
        }
        if let Some(quantity) = declaration.tolerance.negative() {
            return fault(format!("tolerance.{quantity} is negative"));
        }
        Ok(declaration)
    }

    /// Whether it has a control.
    #[must_use]
    pub fn has_control(&self, control: Control) -> bool {
        self.controls.as_ref().is_none_or(|controls| controls.contains(&control))
    }

    /// Whether it has a feature.
    #[must_use]
    pub fn has_feature(&self, feature: Feature) -> bool {
        self.features.as_ref().is_none_or(|features| features.contains(&feature))
    }

    /// Whether it reports events of a kind.
    #[must_use]
    pub fn reports(&self, kind: &str) -> bool {
        self.events.as_ref().is_none_or(|kinds| kinds.contains(kind))
    }

    /// Whether a field of an event of a kind is compared.
    #[must_use]
    pub fn compares(&self, kind: &str, field: &str) -> bool {
        !self.omits.contains(field) && (kind != "alarm" || self.alarms == Alarms::Named)
    }
}

/// Why a declaration cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DeclarationError(String);

impl fmt::Display for DeclarationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for DeclarationError {}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Control, Feature};

    use super::{Alarms, Declaration, Refusals, Subject, Undecided};

    #[test]
    fn a_name_is_enough() {
        assert_eq!(Declaration::from_toml("name = 'a'"), Ok(Declaration::of_everything("a")));
    }

    #[test]
    fn every_key_is_read() -> Result<(), Box<dyn std::error::Error>> {
        let declaration = Declaration::from_toml(
            "name = 'mylathe'\nversion = '1.2'\ncontrols = ['e100l']\nfeatures = ['linear', 'any-angle']\n\
             events = ['rapid', 'alarm']\nomits = ['mx', 'path']\nalarms = 'any'\nundecided = 'alarm'\nrefusals = 'skip'\n\
             [tolerance]\nlength = '0.0005'\nspeed = 0.01\n\
             [[waiver]]\ncase = 'e100l/s4-g50-shift'\nreason = 'planned'\n\
             [[waiver]]\nrule = 'E100L-G50-02'\nfield = 'kind'\ngot = 'alarm'\nreason = 'planned'\n",
        )?;
        assert!(declaration.has_control(Control::E100l));
        assert!(declaration.has_feature(Feature::AnyAngle) && !declaration.has_feature(Feature::Arc));
        assert!(declaration.reports("rapid") && !declaration.reports("mode"));
        assert!(declaration.compares("linear", "x") && !declaration.compares("linear", "mx"));
        assert!(!declaration.compares("alarm", "name"));
        assert_eq!((declaration.alarms, declaration.undecided), (Alarms::Any, Undecided::Alarm));
        assert_eq!(declaration.refusals, Refusals::Skip);
        assert_eq!(declaration.waivers[0].subject, Subject::Case("e100l/s4-g50-shift".to_owned()));
        assert!(
            matches!(declaration.waivers[1].subject, Subject::Rule(rule) if rule.as_str() == "E100L-G50-02")
        );
        Ok(())
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, named) in [
            ("", "name"),
            ("name = 'a'\nfetures = []", "fetures"),
            ("name = 'a'\nfeatures = ['linar']", "linar"),
            ("name = 'a'\ncontrols = ['fanuc']", "fanuc"),
            ("name = 'a'\nevents = ['move']", "move"),
            ("name = 'a'\nomits = ['machine']", "machine"),
            ("name = 'a'\nalarms = 'none'", "none"),
            ("name = 'a'\n[tolerance]\nlength = -1", "length"),
            ("name = 'a'\n[tolerance]\nlength = 'small'", "small"),
            ("name = 'a'\n[[waiver]]\ncase = 'x'", "reason"),
            ("name = 'a'\n[[waiver]]\ncase = 'x'\nreason = ' '", "reason"),
            ("name = 'a'\n[[waiver]]\nrule = 'E100L-G50-02'\nfield = 'y'\nreason = 'x'", "`kind`"),
            ("name = 'a'\n[[waiver]]\nreason = 'x'", "either a case or a rule"),
            ("name = 'a'\n[[waiver]]\nrule = 'E100L-XYZ-99'\nreason = 'x'", "E100L-XYZ-99"),
        ] {
            match Declaration::from_toml(text) {
                Err(error) => assert!(error.to_string().contains(named), "{text}: {error}"),
                Ok(_) => panic!("{text} is accepted"),
            }
        }
    }
}

//! Which cases are run: those that the filters select and whose control and features are declared.

use turnspec_oracle::vocabulary::Feature;
use wildmatch::WildMatch;

use crate::{Case, Declaration};

/// A filter: it selects a case by a part of its id, by a pattern with `*` and `?` for its whole id, or by the
/// name of a rule, a feature or a flag (patterns too).
#[derive(Clone, Debug)]
pub struct Filter {
    text: String,
    pattern: WildMatch,
}

impl Filter {
    /// The filter of a text.
    #[must_use]
    pub fn new(text: &str) -> Self {
        Self { text: text.to_owned(), pattern: WildMatch::new(text) }
    }

    /// Whether it selects a case.
    #[must_use]
    pub fn selects(&self, case: &Case) -> bool {
        let Self { text, pattern } = self;
        (case.id.contains(text.as_str()) || pattern.matches(&case.id))
            || case.rules.iter().any(|rule| pattern.matches(rule.as_str()))
            || case.features.iter().any(|feature| pattern.matches(feature.as_str()))
            || case.flags.iter().any(|flag| pattern.matches(flag.as_str()))
    }
}

/// Why a case is not run; `None` when it is. Without filters every case is selected, with several those that
/// one of them selects.
#[must_use]
pub fn reason_to_skip(case: &Case, declaration: &Declaration, filters: &[Filter]) -> Option<String> {
    if !filters.is_empty() && !filters.iter().any(|filter| filter.selects(case)) {
        return Some("left out by --filter".to_owned());
    }
    if !declaration.has_control(case.control) {
        return Some("its control is not declared".to_owned());
    }
    let missing = |feature: &&Feature| !declaration.has_feature(**feature);
    let missing: Vec<&str> = case.features.iter().filter(missing).map(|feature| feature.as_str()).collect();
    (!missing.is_empty()).then(|| format!("needs what is not declared: {}", missing.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::{Filter, reason_to_skip};
    use crate::{Case, Declaration, corpus};

    fn case() -> Case {
        let mut cases = corpus::embedded().unwrap_or_else(|error| panic!("{error}")).into_iter();
        let found = cases.find(|each| each.case.id == "e100l/s3-g75-chamfer");
        found.unwrap_or_else(|| panic!("no such case")).case
    }

    #[test]
    fn a_filter_knows_ids_rules_features_and_flags() {
        let case = case();
        for text in
            ["s3-g75", "e100l/*chamfer", "*g75*", "E100L-CHAM-03", "E100L-CHAM-*", "linear", "manual-example"]
        {
            assert!(Filter::new(text).selects(&case), "{text}");
        }
        for text in ["s4", "s3-g75?", "E100L-CHAM", "E100L-CHAM-99", "line", "manual", "arc"] {
            assert!(!Filter::new(text).selects(&case), "{text}");
        }
    }

    #[test]
    fn a_case_is_skipped_for_a_reason() {
        let case = case();
        let everything = Declaration::of_everything("a");
        assert_eq!(reason_to_skip(&case, &everything, &[]), None);
        assert_eq!(reason_to_skip(&case, &everything, &[Filter::new("arc"), Filter::new("linear")]), None);
        assert!(reason_to_skip(&case, &everything, &[Filter::new("arc")]).is_some());
        let little =
            Declaration::from_toml("name = 'a'\nfeatures = ['linear', 'feed']").unwrap_or(everything);
        let reason = reason_to_skip(&case, &little, &[]);
        assert_eq!(reason.as_deref(), Some("needs what is not declared: chamfer, sequence-name"));
        let other = Declaration { controls: Some(vec![]), ..little };
        assert_eq!(reason_to_skip(&case, &other, &[]).as_deref(), Some("its control is not declared"));
    }
}

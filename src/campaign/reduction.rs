//! The smallest program that still disagrees in the same way.

use turnspec_conformance::{Declaration, Implementation, RunError};
use turnspec_generator::{Case, Profile, shrink};

use super::judgement::{Disagreement, Judgement, judge};

/// The most runs of the implementation that one reduction may take.
const RUNS: usize = 500;

/// A smaller case of a disagreement of the same class, within the profile, and that disagreement.
pub(super) fn reduced(
    implementation: &Implementation,
    declaration: &Declaration,
    profile: &Profile,
    case: &Case,
    disagreement: &Disagreement,
) -> Result<(Case, Disagreement), RunError> {
    let class = &disagreement.signature.class;
    let mut smallest = disagreement.clone();
    let mut runs = 0;
    let mut failure = None;
    let smaller = shrink(case.clone(), |candidate| {
        if runs >= RUNS || failure.is_some() || !profile.permits(candidate) {
            return false;
        }
        runs += 1;
        match judge(implementation, declaration, candidate) {
            Ok(Judgement::Disagreed(found)) if found.signature.class == *class => {
                smallest = *found;
                true
            }
            Ok(_) => false,
            Err(error) => {
                failure = Some(error);
                false
            }
        }
    });
    match failure {
        Some(error) => Err(error),
        None => Ok((smaller, smallest)),
    }
}

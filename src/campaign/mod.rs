//! Campaigns against another implementation: generated programs without end, run by it and by the oracle,
//! compared in full.
//!
//! Everything follows from the seed: which programs are run, which disagreements count as one, what they
//! shrink to. Work is shared among threads a batch at a time, and the results of a batch are taken in the order
//! of its runs, so that the number of threads changes nothing but the time. (Only a run at the edge of its
//! time-out may come out otherwise.) After every batch the state is saved; a campaign that was interrupted
//! goes on from there.

mod finding;
mod judgement;
mod pool;
mod reduction;
mod report;
mod signature;
mod state;

pub use finding::Finding;
pub use report::Group;
pub use signature::Signature;
pub use state::{Campaign, StateError};

use std::path::Path;

use turnspec_conformance::{Declaration, Implementation, RunError};
use turnspec_generator::{Case, Profile, case_from_seed_within};
use turnspec_oracle::vocabulary::Feature;

use judgement::{Disagreement, Judgement, judge};
use pool::in_parallel;
use reduction::reduced;

/// Runs that are shared among the threads before their results are taken.
const BATCH: u64 = 64;

/// What a campaign is about. All of it but `runs`, `jobs` and `max_findings` is fixed at its start.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'p> {
    /// The implementation.
    pub implementation: &'p Implementation,
    /// What it declares.
    pub declaration: &'p Declaration,
    /// Where the programs come from.
    pub seed: u64,
    /// How many programs are run in all, those of earlier parts of the campaign included.
    pub runs: u64,
    /// Threads.
    pub jobs: usize,
    /// The campaign stops at the run that brings it to this number of findings; 0 is no limit.
    pub max_findings: usize,
}

/// Why a campaign did not go on.
#[derive(Debug)]
pub enum Failure {
    /// The implementation could not be run, or the interrupt flag was raised.
    Run(RunError),
    /// The state or a finding could not be saved.
    State(StateError),
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        Self::Run(error)
    }
}

impl From<StateError> for Failure {
    fn from(error: StateError) -> Self {
        Self::State(error)
    }
}

/// Carries on with a campaign until its runs are done or it has enough findings. With a directory its state and
/// its findings are saved there. `progress` is called with the number of runs done.
///
/// # Errors
/// [`Failure`]; what had been saved before stays valid.
pub fn carry_on(
    campaign: &mut Campaign,
    plan: &Plan<'_>,
    directory: Option<&Path>,
    mut progress: impl FnMut(&Campaign),
) -> Result<(), Failure> {
    let profile = profile(plan.declaration);
    while campaign.done < plan.runs && !campaign.is_full(plan.max_findings) {
        let first = campaign.done;
        let batch: Vec<u64> = (first..plan.runs.min(first + BATCH)).collect();
        take_batch(campaign, plan, &profile, &batch)?;
        if let Some(directory) = directory {
            campaign.save(directory)?;
        }
        progress(campaign);
    }
    Ok(())
}

/// The programs that a declaration permits.
fn profile(declaration: &Declaration) -> Profile {
    match &declaration.features {
        None => Profile::FULL,
        Some(features) => Profile::of(&features.iter().copied().collect::<Vec<Feature>>()),
    }
}

/// The case of a run: other seeds lead to other cases.
fn case(seed: u64, run: u64, profile: &Profile) -> Case {
    case_from_seed_within(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(run), profile)
}

/// Runs a batch, reduces what is new in it, and takes the results in the order of the runs.
fn take_batch(
    campaign: &mut Campaign,
    plan: &Plan<'_>,
    profile: &Profile,
    batch: &[u64],
) -> Result<(), Failure> {
    let judgements = in_parallel(plan.jobs, batch, |run| {
        let case = case(plan.seed, *run, profile);
        judge(plan.implementation, plan.declaration, &case).map(|judgement| (case, judgement))
    })?;
    let news = news(campaign, batch, &judgements);
    let findings = in_parallel(plan.jobs, &news, |(run, case, disagreement)| {
        reduced(plan.implementation, plan.declaration, profile, case, disagreement)
            .map(|(case, smallest)| Finding::new(plan.seed, *run, disagreement, &case, &smallest))
    })?;
    let mut findings = findings.into_iter().peekable();
    for (run, (_, judgement)) in batch.iter().zip(judgements) {
        if campaign.is_full(plan.max_findings) {
            break;
        }
        campaign.take(judgement, findings.next_if(|finding| finding.run == *run));
    }
    Ok(())
}

/// The first disagreement of each signature that the campaign has not met yet.
fn news<'j>(
    campaign: &Campaign,
    batch: &[u64],
    judgements: &'j [(Case, Judgement)],
) -> Vec<(u64, &'j Case, &'j Disagreement)> {
    let mut met: Vec<&Signature> = Vec::new();
    let mut news = Vec::new();
    for (run, (case, judgement)) in batch.iter().zip(judgements) {
        if let Judgement::Disagreed(disagreement) = judgement
            && !campaign.has_met(&disagreement.signature)
            && !met.contains(&&disagreement.signature)
        {
            met.push(&disagreement.signature);
            news.push((*run, case, &**disagreement));
        }
    }
    news
}

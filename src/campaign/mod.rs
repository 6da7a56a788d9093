//! Campaigns against another implementation: generated programs without end, run by it and by the oracle,
//! compared in full.
//!
//! Everything follows from the seed: which programs are run, which disagreements count as one, what they
//! shrink to. Work is shared among threads a batch at a time, and the results of a batch are taken in the order
//! of its runs, so that neither the number of threads nor an interruption changes anything but the time. (Only a run
//! at the edge of its time-out may come out otherwise.) What was taken is saved with every finding, every second
//! and at an interruption; a campaign that was interrupted goes on from there.

mod batch;
mod finding;
mod judgement;
mod reduction;
mod report;
mod signature;
mod state;

pub use finding::Finding;
pub use report::Group;
pub use signature::Signature;
pub use state::{Campaign, StateError};

use std::path::Path;
use std::time::{Duration, Instant};

use turnspec_conformance::{Declaration, Implementation, RunError};
use turnspec_generator::Profile;
use turnspec_oracle::vocabulary::Feature;

use batch::Batch;

/// Runs for each thread before their results are taken.
const RUNS_A_THREAD: u64 = 4;
/// The longest time that results without a finding wait for being saved.
const UNSAVED: Duration = Duration::from_secs(1);

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
/// its findings are saved there. `progress` is called with the campaign whenever results have been taken.
///
/// # Errors
/// [`Failure`]. The campaign is as far as its results were taken, and with a directory it is saved so, unless the
/// failure is that it cannot be saved; then what had been saved before stays valid.
pub fn carry_on(
    campaign: &mut Campaign,
    plan: &Plan<'_>,
    directory: Option<&Path>,
    mut progress: impl FnMut(&Campaign),
) -> Result<(), Failure> {
    let profile = profile(plan.declaration);
    let mut keeper = Keeper::new(campaign, directory);
    let width = RUNS_A_THREAD.saturating_mul(plan.jobs.max(1) as u64);
    while campaign.done < plan.runs && !campaign.is_full(plan.max_findings) {
        let runs = campaign.done..plan.runs.min(campaign.done.saturating_add(width));
        let mut batch = Batch::judged(plan, &profile, runs);
        while !batch.is_taken() && !campaign.is_full(plan.max_findings) {
            batch.take_some(campaign);
            keeper.keep(campaign)?;
            progress(campaign);
        }
        if let Some(failure) = batch.into_failure().filter(|_| !campaign.is_full(plan.max_findings)) {
            keeper.keep_at_last(campaign)?;
            return Err(failure.into());
        }
    }
    Ok(keeper.keep_at_last(campaign)?)
}

/// Saves a campaign, often enough that an end by force costs little.
struct Keeper<'d> {
    directory: Option<&'d Path>,
    /// When it was saved, how many runs it had then, and how many findings.
    saved: (Instant, u64, usize),
}

impl<'d> Keeper<'d> {
    /// Of a campaign as it begins or as it was read.
    fn new(campaign: &Campaign, directory: Option<&'d Path>) -> Self {
        Self { directory, saved: (Instant::now(), campaign.done, campaign.findings.len()) }
    }

    /// Saves it if there is a new finding, or if the last time is long ago.
    fn keep(&mut self, campaign: &mut Campaign) -> Result<(), StateError> {
        let (time, _, findings) = self.saved;
        if findings < campaign.findings.len() || time.elapsed() >= UNSAVED {
            self.keep_at_last(campaign)?;
        }
        Ok(())
    }

    /// Saves it if anything is new.
    fn keep_at_last(&mut self, campaign: &mut Campaign) -> Result<(), StateError> {
        let (_, done, _) = self.saved;
        if let Some(directory) = self.directory.filter(|_| done < campaign.done) {
            campaign.save(directory)?;
            self.saved = (Instant::now(), campaign.done, campaign.findings.len());
        }
        Ok(())
    }
}

/// The programs that a declaration permits.
fn profile(declaration: &Declaration) -> Profile {
    match &declaration.features {
        None => Profile::FULL,
        Some(features) => Profile::of(&features.iter().copied().collect::<Vec<Feature>>()),
    }
}

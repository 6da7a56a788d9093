//! A batch: some runs, shared among threads, whose results are taken in their order as far as they are there.

use std::collections::VecDeque;
use std::ops::Range;

use turnspec_conformance::{RunError, finished_in_parallel};
use turnspec_generator::{Case, Profile, case_from_seed_within};

use super::judgement::{Disagreement, Judgement, judge};
use super::reduction::reduced;
use super::{Campaign, Finding, Plan, Signature};

/// A run with its result.
struct Judged {
    run: u64,
    case: Case,
    judgement: Judgement,
}

/// Runs whose results are not taken yet.
pub(super) struct Batch<'p> {
    plan: &'p Plan<'p>,
    profile: &'p Profile,
    waiting: VecDeque<Judged>,
    /// Why there are not more of them, or why they are not reduced.
    failure: Option<RunError>,
    /// Whether a reduction has failed: from its run on nothing can be taken.
    is_stuck: bool,
}

impl<'p> Batch<'p> {
    /// Runs the programs, up to the first that cannot be run.
    pub(super) fn judged(plan: &'p Plan<'p>, profile: &'p Profile, runs: Range<u64>) -> Self {
        let runs: Vec<u64> = runs.collect();
        let (judged, failure) = finished_in_parallel(plan.jobs, &runs, |run| {
            let case = case(plan.seed, *run, profile);
            let judgement = judge(plan.implementation, plan.declaration, &case)?;
            Ok(Judged { run: *run, case, judgement })
        });
        Self { plan, profile, waiting: judged.into(), failure, is_stuck: false }
    }

    /// Whether nothing is left that can be taken.
    pub(super) fn is_taken(&self) -> bool {
        self.waiting.is_empty() || self.is_stuck
    }

    /// Why it was cut short.
    pub(super) fn into_failure(self) -> Option<RunError> {
        self.failure
    }

    /// Reduces some disagreements that are new, no more than threads or than findings are wanted, and takes the
    /// results in the order of the runs, up to the next one that is new.
    pub(super) fn take_some(&mut self, campaign: &mut Campaign) {
        let room = campaign.room(self.plan.max_findings).min(self.plan.jobs.max(1));
        let news = news(campaign, &self.waiting, room);
        let (findings, failure) = finished_in_parallel(self.plan.jobs, &news, |(run, case, disagreement)| {
            let Plan { implementation, declaration, seed, .. } = *self.plan;
            reduced(implementation, declaration, self.profile, case, disagreement)
                .map(|(case, smallest)| Finding::new(seed, *run, disagreement, &case, &smallest))
        });
        self.is_stuck = failure.is_some();
        self.failure = failure.or(self.failure.take());
        self.take(campaign, findings);
    }

    fn take(&mut self, campaign: &mut Campaign, findings: Vec<Finding>) {
        let mut findings = findings.into_iter().peekable();
        while let Some(judged) = self.waiting.pop_front() {
            let finding = findings.next_if(|finding| finding.run == judged.run);
            let is_new = is_new(campaign, &judged.judgement).is_some();
            if campaign.is_full(self.plan.max_findings) || (is_new && finding.is_none()) {
                self.waiting.push_front(judged);
                return;
            }
            campaign.take(judged.judgement, finding);
        }
    }
}

/// The case of a run: other seeds lead to other cases.
fn case(seed: u64, run: u64, profile: &Profile) -> Case {
    case_from_seed_within(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(run), profile)
}

/// The disagreement of a result, if the campaign has not met its signature yet.
fn is_new<'j>(campaign: &Campaign, judgement: &'j Judgement) -> Option<&'j Disagreement> {
    match judgement {
        Judgement::Disagreed(disagreement) if !campaign.has_met(&disagreement.signature) => {
            Some(disagreement)
        }
        _ => None,
    }
}

/// The first disagreement of each signature that the campaign has not met yet, `most` of them.
fn news<'j>(
    campaign: &Campaign,
    waiting: &'j VecDeque<Judged>,
    most: usize,
) -> Vec<(u64, &'j Case, &'j Disagreement)> {
    let mut met: Vec<&Signature> = Vec::new();
    let mut news = Vec::new();
    for Judged { run, case, judgement } in waiting {
        if news.len() == most {
            break;
        }
        if let Some(disagreement) = is_new(campaign, judgement).filter(|each| !met.contains(&&each.signature))
        {
            met.push(&disagreement.signature);
            news.push((*run, case, disagreement));
        }
    }
    news
}

//! A campaign: generated programs through both implementations, counted, until the first disagreement.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Mutex, PoisonError};

use turnspec::differential::{Agreement, compare};
use turnspec_generator::{Case, case_from_seed, shrink};

/// What a campaign has run.
#[derive(Clone, Default, Debug)]
pub struct Summary {
    /// Programs.
    pub programs: u64,
    /// Blocks that were carried out.
    pub blocks: u64,
    /// Events on which both agreed.
    pub events: u64,
    /// Programs that reached M02 or M30.
    pub ended: u64,
    /// The other programs, by the name of their alarm.
    pub alarms: BTreeMap<&'static str, u64>,
}

impl Summary {
    /// Counts a run.
    pub fn count(&mut self, agreement: &Agreement) {
        self.programs += 1;
        self.blocks += agreement.blocks;
        self.events += agreement.events;
        match agreement.alarm {
            None => self.ended += 1,
            Some(alarm) => *self.alarms.entry(alarm.as_str()).or_default() += 1,
        }
    }

    /// Adds another campaign.
    pub fn add(&mut self, other: &Self) {
        self.programs += other.programs;
        self.blocks += other.blocks;
        self.events += other.events;
        self.ended += other.ended;
        for (alarm, count) in &other.alarms {
            *self.alarms.entry(alarm).or_default() += count;
        }
    }

    /// Programs in a hundred that reached their end.
    #[must_use]
    pub fn percent_ended(&self) -> f64 {
        self.ended as f64 * 100.0 / self.programs.max(1) as f64
    }
}

impl std::fmt::Display for Summary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(
            f,
            "{} programs, {} blocks, {} events, {:.1} % reached the end of the program",
            self.programs,
            self.blocks,
            self.events,
            self.percent_ended()
        )?;
        let mut alarms: Vec<_> = self.alarms.iter().collect();
        alarms.sort_by_key(|(name, count)| (std::cmp::Reverse(**count), **name));
        for (name, count) in alarms {
            writeln!(f, "{count:>8} {name}")?;
        }
        Ok(())
    }
}

/// A seed on which the implementations disagree, or one of them panics.
#[derive(Clone, Debug)]
pub struct Failure {
    /// The seed.
    pub seed: u64,
    /// Its case.
    pub case: Case,
    /// What is wrong.
    pub message: String,
}

/// Compares one seed; its agreement is counted.
///
/// # Errors
/// The failure.
pub fn run_seed(seed: u64, summary: &mut Summary) -> Result<(), Box<Failure>> {
    let case = case_from_seed(seed);
    match verdict(&case) {
        Ok(agreement) => {
            summary.count(&agreement);
            Ok(())
        }
        Err(message) => Err(Box::new(Failure { seed, case, message })),
    }
}

/// Compares one case.
///
/// # Errors
/// The disagreement or the panic as text.
pub fn verdict(case: &Case) -> Result<Agreement, String> {
    match catch_unwind(AssertUnwindSafe(|| compare(&case.program, &case.setup))) {
        Ok(Ok(agreement)) => Ok(agreement),
        Ok(Err(disagreement)) => Err(disagreement.to_string()),
        Err(_) => Err("an implementation panics".to_owned()),
    }
}

/// The smallest case that still fails, and what is wrong with it. Panics stay silent meanwhile.
#[must_use]
pub fn smallest(failure: Failure) -> Failure {
    // The hook is the process's own: one at a time.
    static TURN: Mutex<()> = Mutex::new(());
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let case = shrink(failure.case, |case| verdict(case).is_err());
    let message = verdict(&case).err().unwrap_or(failure.message);
    std::panic::set_hook(hook);
    Failure { case, message, ..failure }
}

//! The long differential run: generated programs through the oracle and the engine.
//!
//! `cargo run --release --example differential -- --blocks 1000000 --seed 1 --threads 2`
//!
//! Progress goes to standard error, the summary to standard output. Ends with status 1 at the first
//! disagreement, after shrinking it and writing it into `fuzz/regressions/`; with status 2 on wrong usage.

use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

#[path = "../tests/support/mod.rs"]
#[allow(dead_code)]
mod support;

use support::campaign::{self, Failure, Summary};
use support::regression;

/// Seeds that a thread takes at a time.
const SHARE: u64 = 64;

/// What the command line asks for.
struct Wish {
    blocks: u64,
    seed: u64,
    threads: u64,
}

fn main() -> ExitCode {
    let wish = match wish(std::env::args().skip(1)) {
        Ok(wish) => wish,
        Err(message) => {
            eprintln!("differential: {message}\nusage: differential [--blocks N] [--seed N] [--threads N]");
            return ExitCode::from(2);
        }
    };
    let start = Instant::now();
    let (summary, failure) = run(&wish);
    let out = &mut io::stdout();
    let seconds = start.elapsed().as_secs_f64().max(1e-9);
    let _ = write!(out, "{summary}");
    let _ = writeln!(out, "{seconds:.1} s, {:.0} blocks/s", summary.blocks as f64 / seconds);
    match failure {
        None => ExitCode::SUCCESS,
        Some(failure) => {
            let _ = report(out, failure);
            ExitCode::FAILURE
        }
    }
}

fn wish(mut arguments: impl Iterator<Item = String>) -> Result<Wish, String> {
    let threads = std::thread::available_parallelism().map_or(1, |count| count.get() as u64);
    let mut wish = Wish { blocks: 1_000_000, seed: 1, threads };
    while let Some(name) = arguments.next() {
        let value = arguments.next().ok_or_else(|| format!("{name} needs a value"))?;
        let number = value.parse().map_err(|_| format!("{name}: {value:?} is no whole number"))?;
        match name.as_str() {
            "--blocks" => wish.blocks = number,
            "--seed" => wish.seed = number,
            "--threads" => wish.threads = number.max(1),
            _ => return Err(format!("unknown argument {name}")),
        }
    }
    Ok(wish)
}

/// Runs seeds on all threads until enough blocks are done or one fails.
fn run(wish: &Wish) -> (Summary, Option<Failure>) {
    let next = AtomicU64::new(wish.seed);
    let done = AtomicU64::new(0);
    let stop = AtomicBool::new(false);
    let total = Mutex::new((Summary::default(), None::<Failure>));
    let work = || {
        while !stop.load(Ordering::Relaxed) && done.load(Ordering::Relaxed) < wish.blocks {
            let first = next.fetch_add(SHARE, Ordering::Relaxed);
            let mut summary = Summary::default();
            let failure =
                (first..first + SHARE).find_map(|seed| campaign::run_seed(seed, &mut summary).err());
            done.fetch_add(summary.blocks, Ordering::Relaxed);
            if failure.is_some() {
                stop.store(true, Ordering::Relaxed);
            }
            let mut total = total.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            total.0.add(&summary);
            total.1 = total.1.take().or(failure.map(|failure| *failure));
        }
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..wish.threads).map(|_| scope.spawn(work)).collect();
        while workers.iter().any(|worker| !worker.is_finished()) {
            std::thread::sleep(Duration::from_millis(200));
            progress(done.load(Ordering::Relaxed), wish.blocks);
        }
    });
    if io::stderr().is_terminal() {
        eprintln!();
    }
    total.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// A line that overwrites itself, on a terminal only.
fn progress(done: u64, wanted: u64) {
    if io::stderr().is_terminal() {
        eprint!("\r{done} of {wanted} blocks");
    }
}

/// Shrinks a failure, writes it as a regression, and shows it.
fn report(out: &mut impl Write, failure: Failure) -> io::Result<()> {
    let failure = campaign::smallest(failure);
    writeln!(out, "seed {} fails:\n{}", failure.seed, failure.message)?;
    writeln!(out, "{}", String::from_utf8_lossy(&failure.case.program))?;
    let note = format!("Found by seed {} of the program generator.", failure.seed);
    let path = regression::write(&format!("seed-{}", failure.seed), &failure.case, &note)?;
    writeln!(out, "written to {}", path.display())
}

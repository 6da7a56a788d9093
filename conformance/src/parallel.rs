//! Work shared among threads, with its results in order.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The results of some work on each item, in the order of the items.
///
/// # Errors
/// The error of the first item, in their order, that was found to fail; the threads stop at it.
pub fn in_parallel<T: Sync, R: Send, E: Send>(
    jobs: usize,
    items: &[T],
    work: impl Fn(&T) -> Result<R, E> + Sync,
) -> Result<Vec<R>, E> {
    match finished_in_parallel(jobs, items, work) {
        (results, None) => Ok(results),
        (_, Some(error)) => Err(error),
    }
}

/// The results of some work on each item, in the order of the items, up to the first item that was found to fail, and
/// its error; the threads stop at it.
pub fn finished_in_parallel<T: Sync, R: Send, E: Send>(
    jobs: usize,
    items: &[T],
    work: impl Fn(&T) -> Result<R, E> + Sync,
) -> (Vec<R>, Option<E>) {
    let next = AtomicUsize::new(0);
    let has_failed = AtomicBool::new(false);
    let results = Mutex::new(Vec::with_capacity(items.len()));
    std::thread::scope(|scope| {
        for _ in 0..jobs.clamp(1, items.len().max(1)) {
            scope.spawn(|| {
                while !has_failed.load(Ordering::Relaxed) {
                    let place = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(place) else { return };
                    let result = work(item);
                    if result.is_err() {
                        has_failed.store(true, Ordering::Relaxed);
                    }
                    results.lock().unwrap_or_else(PoisonError::into_inner).push((place, result));
                }
            });
        }
    });
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    // Places are given out in order, and whoever takes one leaves a result: there is no gap.
    results.sort_by_key(|(place, _)| *place);
    let mut finished = Vec::with_capacity(results.len());
    for (_, result) in results {
        match result {
            Ok(result) => finished.push(result),
            Err(error) => return (finished, Some(error)),
        }
    }
    (finished, None)
}

#[cfg(test)]
mod tests {
    use super::{finished_in_parallel, in_parallel};

    #[test]
    fn results_are_in_order_whatever_the_number_of_threads() {
        let items: Vec<u64> = (0..200).collect();
        let expected: Vec<u64> = items.iter().map(|item| item * item).collect();
        for jobs in [0, 1, 3, 500] {
            assert_eq!(in_parallel(jobs, &items, |item| Ok::<_, ()>(item * item)), Ok(expected.clone()));
        }
        assert_eq!(in_parallel(2, &[], |item: &u64| Ok::<_, ()>(*item)), Ok(Vec::new()));
    }

    #[test]
    fn a_failure_is_passed_on() {
        let items: Vec<u64> = (0..200).collect();
        let work = |item: &u64| if *item == 7 { Err(*item) } else { Ok(*item) };
        assert_eq!(in_parallel(3, &items, work), Err(7));
        assert_eq!(finished_in_parallel(3, &items, work), ((0..7).collect(), Some(7)));
    }
}

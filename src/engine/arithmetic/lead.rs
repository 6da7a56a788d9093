//! The lead of a thread, constant or changing: its range, and what it is at a distance (E100L-THRD-04, E100L-THRD-06,
//! E100L-G33-09). Leads and changes are picometres in a revolution, the change of at most 2^47 in size; distances are
//! doubled nanometres, so that half a diameter is whole, from 0 to 2^65.

use super::root::root_over;
use super::round::Rounding;
use crate::engine::planted::{self, Bug};

/// Least and greatest lead: 0.001 and 1000 mm.
pub const LEAST: i64 = 1_000_000;
/// See [`LEAST`].
pub const MOST: i64 = 1_000_000_000_000;

/// The lead of any F that is divided by a J of at least 1; none when it is out of range.
#[must_use]
pub fn of_feed(per_revolution: i64, divisor: i64) -> Option<i64> {
    let rounding = if planted::is(Bug::LeadCut) { Rounding::Cut } else { Rounding::HalfAway };
    let lead = rounding.divide_narrow(per_revolution, divisor);
    (LEAST..=MOST).contains(&lead).then_some(lead)
}

/// The square of the lead at twice a distance from the start: P² + 2 e d, for a lead in range; below 2^123 in size.
#[must_use]
pub fn square_at(start: i64, change: i64, twice: i128) -> i128 {
    let start = i128::from(start);
    start * start + 1000 * i128::from(change) * twice
}

/// Whether the lead at twice a distance is still a lead in range.
#[must_use]
pub fn stays_in_range(start: i64, change: i64, twice: i128) -> bool {
    let square = |lead: i64| i128::from(lead) * i128::from(lead);
    change == 0 || (square(LEAST)..=square(MOST)).contains(&square_at(start, change, twice))
}

/// The lead at twice a distance, rounded, where the square of it is below 2^120; 0 where it would be imaginary.
#[must_use]
pub fn at(start: i64, change: i64, twice: i128) -> i64 {
    if change == 0 {
        return start;
    }
    root_over(square_at(start, change, twice).max(0).unsigned_abs(), 1)
}

#[cfg(test)]
mod tests {
    use super::{MOST, at, of_feed, stays_in_range};

    #[test]
    fn the_lead_changes_along_the_thread() {
        // sqrt(2.5^2 + 2 * 39.5) = sqrt(85.25).
        let (start, change) = (2_500_000_000, 1_000_000_000);
        assert_eq!(at(start, change, 79_000_000), 9_233_092_656);
        assert_eq!(at(start, change, 0), start);
        assert_eq!(at(start, 0, 79_000_000), start);
        assert!(stays_in_range(start, 0, i128::MAX >> 64));
    }

    #[test]
    fn the_lead_stays_in_its_range() {
        let (start, change) = (2_000_000_000, -100_000_000);
        assert!(stays_in_range(start, change, 38_000_000));
        assert!(!stays_in_range(start, change, 40_000_000));
        // 0.001 mm is reached where 2 * 0.1 * d is 4 - 0.001^2: at d = 19.999995 mm.
        assert!(stays_in_range(start, change, 39_999_990));
        assert!(!stays_in_range(start, change, 39_999_991));
    }

    #[test]
    fn leads_are_parts_of_the_feed() {
        assert_eq!(of_feed(25_400_000_000, 11), Some(2_309_090_909));
        assert_eq!(of_feed(1_000_000, 3), None);
        assert_eq!(of_feed(MOST + 1, 1), None);
    }
}

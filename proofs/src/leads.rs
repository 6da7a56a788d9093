//! Theorems about the lead of a thread and about lengths along its axes. The lead at a distance is a root: that is
//! tested (`lead::tests`).

use turnspec::engine::arithmetic::lead::{LEAST, MOST, at, of_feed, square_at, stays_in_range};
use turnspec::engine::arithmetic::lead_axis::{halves, twice_length};
use turnspec::engine::arithmetic::round::Rounding;
use turnspec_oracle::vocabulary::FeedLength;

use crate::draw::{between, factor, within, within_wide};
#[cfg(stand_in)]
use crate::kani;

/// Changes of the lead: more than any E word.
const CHANGE: i64 = 1 << 47;
/// Twice the greatest distance between two coordinates.
const DISTANCE: i128 = 1 << 65;

/// A lead in range.
fn lead() -> i64 {
    between(LEAST, MOST)
}

fn reading() -> FeedLength {
    if kani::any() { FeedLength::Radius } else { FeedLength::Diameter }
}

theorems! {
    /// The square of a lead at any distance does not overflow.
    /// Of: `lead::square_at`, `lead::stays_in_range`
    /// Assumes: a lead in range, a change of at most 2^47 in size, twice a distance of at most 2^65.
    /// Rules: E100L-G33-09
    #[unwind(2)]
    fn no_lead_overflows() {
        let (lead, change) = (lead(), within(CHANGE));
        let twice = within_wide(DISTANCE).abs();
        kani::cover!(twice == DISTANCE && change == -CHANGE, "the greatest distance and change");
        let square = square_at(lead, change, twice);
        assert!(-(1 << 123) < square && square < 1 << 123);
        assert!(!stays_in_range(lead, change, twice) || change == 0 || square > 0);
    }

    /// A lead that does not change is the same at any distance, and stays in range.
    /// Of: `lead::at`, `lead::stays_in_range`
    /// Assumes: any lead, any distance.
    /// Rules: E100L-G33-08
    #[unwind(2)]
    fn a_constant_lead_stays() {
        let (lead, twice) = (kani::any(), kani::any());
        kani::cover!(lead > MOST, "a lead out of range");
        assert!(at(lead, 0, twice) == lead && stays_in_range(lead, 0, twice));
    }

    /// At the start of a thread the lead is in range, however it changes.
    /// Of: `lead::square_at`, `lead::stays_in_range`
    /// Assumes: a lead in range, at most 1000 picometres from an end of it for the range, a change of at most 2^47 in size.
    /// Rules: E100L-THRD-04, E100L-G33-09
    #[unwind(2)]
    fn a_lead_begins_in_range() {
        let (lead, change, inside) = (lead(), within(CHANGE), between(0, 1000));
        kani::cover!(inside == 0 && change > 0, "an end of the range, growing");
        assert!(square_at(lead, change, 0) == i128::from(lead) * i128::from(lead));
        assert!(stays_in_range(LEAST + inside, change, 0) && stays_in_range(MOST - inside, change, 0));
    }

    /// A lead grows or shrinks all the way, so that its end tells whether it stays in range.
    /// Of: `lead::square_at`
    /// Assumes: leads, changes and distances of at most 8 in size for the model checker, leads of at most 2^40, changes of
    /// at most 2^46 and twice distances of at most 2^60 for the property tests.
    /// Rules: E100L-G33-09
    #[unwind(2)]
    fn a_lead_goes_one_way() {
        let narrow = |value: i128| i64::try_from(value).unwrap_or(0);
        let (lead, change) = (narrow(factor(1 << 40)), narrow(factor(1 << 46)));
        let (near, more) = (factor(1 << 60).abs(), factor(1 << 60).abs());
        let way = square_at(lead, change, near + more) - square_at(lead, change, near);
        kani::cover!(change < 0 && more > 0, "a shrinking lead");
        assert!(way.signum() == i128::from(change.signum()) * more.signum());
    }

    /// A lead is F divided by J and rounded if it is in range; it is none otherwise.
    /// Of: `lead::of_feed`
    /// Assumes: any F, a J of at least 1.
    /// Rules: E100L-THRD-04, E100L-THRD-06
    #[unwind(2)]
    fn a_lead_is_a_part_of_the_feed() {
        let (feed, leads): (i64, i64) = (kani::any(), kani::any());
        kani::assume(leads >= 1);
        let part = Rounding::HalfAway.divide_narrow(feed, leads);
        let found = of_feed(feed, leads);
        kani::cover!(found.is_some() && leads > 1, "a part in range");
        assert!(found == if (LEAST..=MOST).contains(&part) { Some(part) } else { None });
    }

    /// A length is the same both ways and none from a place to itself; no two coordinates overflow it.
    /// Of: `lead_axis::twice_length`, `lead_axis::halves`
    /// Assumes: any coordinates.
    /// Rules: E100L-G32-03
    #[unwind(2)]
    fn a_length_is_the_same_both_ways() {
        let (from, to) = (kani::any(), kani::any());
        let halves = halves(kani::any(), reading());
        let twice = twice_length(from, to, halves);
        kani::cover!(twice > 1 << 64, "far apart");
        assert!(twice == twice_length(to, from, halves) && twice <= DISTANCE);
        assert!((twice == 0) == (from == to) && twice >= 0);
    }

    /// Lengths along a way add up.
    /// Of: `lead_axis::twice_length`
    /// Assumes: any three coordinates in their order.
    /// Rules: E100L-G32-03
    #[unwind(2)]
    fn lengths_add_up() {
        let (first, second, third) = (kani::any(), kani::any(), kani::any());
        kani::assume(first <= second && second <= third);
        let halves = halves(kani::any(), reading());
        let length = |from, to| twice_length(from, to, halves);
        kani::cover!(first < second && second < third, "a way with a stop");
        assert!(length(first, third) == length(first, second) + length(second, third));
    }

    /// A difference of diameters counts half where the way of the slide is measured, and whole otherwise, as along Z.
    /// Of: `lead_axis::halves`, `lead_axis::twice_length`
    /// Assumes: any coordinates.
    /// Rules: E100L-G32-03, E100L-G01-04
    #[unwind(2)]
    fn a_diameter_counts_half_along_x() {
        let (from, to) = (kani::any(), kani::any());
        let of = |is_x, reading| twice_length(from, to, halves(is_x, reading));
        kani::cover!(from > to, "a way back");
        let along_z = of(false, reading());
        assert!(2 * of(true, FeedLength::Radius) == along_z && of(true, FeedLength::Diameter) == along_z);
    }
}

refutations! {
    /// False: a lead in range stays in range.
    #[unwind(2)]
    fn every_lead_stays_in_range() {
        assert!(stays_in_range(lead(), within(CHANGE), 1000));
    }

    /// False: a lead is never less than the feed by more than its part.
    #[unwind(2)]
    fn the_lead_is_the_feed() {
        let (feed, leads) = (lead(), between(1, 9999));
        assert!(of_feed(feed, leads) == Some(feed));
    }
}

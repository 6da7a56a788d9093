//! Theorems about what feeds are measured on, and about the feeds of a torque skip.

use turnspec::engine::arithmetic::feed::{
    LONGEST, Measure, fifth, is_watched, path, path_with_turn, square, way,
};
use turnspec::engine::arithmetic::turn::TURN;
use turnspec_oracle::vocabulary::FeedLength;

use crate::draw::{between, within};
#[cfg(stand_in)]
use crate::kani;

/// Bound of the squares that roots are taken of.
const ROOM: u128 = 1 << 120;

/// The delay of a set-up, in units of 10 ms.
fn delay() -> u16 {
    u16::try_from(between(0, 9999)).unwrap_or(0)
}

theorems! {
    /// Whatever the positions, the squares of a path without the C axis stay below 2^120.
    /// Of: `feed::square`, `feed::path`
    /// Assumes: any positions.
    /// Rules: E100L-G01-04
    #[unwind(6)]
    fn no_path_overflows() {
        let [x, z, w] = [(); 3].map(|()| square(kani::any(), kani::any()));
        kani::cover!(x == 1 << 108, "beyond what is measured");
        for reading in [FeedLength::Radius, FeedLength::Diameter] {
            let Measure { square, divisor } = path(x, z + w, reading);
            assert!(square < ROOM && (1..=2).contains(&divisor));
        }
    }

    /// Nor do those of a path with the C axis, however far it turns.
    /// Of: `feed::square`, `feed::path_with_turn`
    /// Assumes: any positions, any turn.
    /// Rules: E100L-CFEED-03
    #[unwind(6)]
    fn no_path_with_a_turn_overflows() {
        let [x, z, w] = [(); 3].map(|()| square(kani::any(), kani::any()));
        let turn: i64 = kani::any();
        kani::cover!(turn == i64::MIN, "the longest turn");
        let Measure { square, divisor } = path_with_turn(x, z + w, turn);
        assert!(square < ROOM && divisor == 18);
    }

    /// The way back is as long as the way out, there is none from a place to itself, and none is longer than what is
    /// measured.
    /// Of: `feed::way`
    /// Assumes: any positions.
    /// Rules: E100L-G01-04
    #[unwind(2)]
    fn the_way_back_is_as_long() {
        let (start, end): (i64, i64) = (kani::any(), kani::any());
        kani::cover!(start == i64::MIN && end > 0, "across zero");
        assert!(way(start, end) == way(end, start) && way(start, end) <= LONGEST);
        assert!((way(start, end) == 0) == (start == end));
    }

    /// A diameter counts half where feeds are measured on the radius.
    /// Of: `feed::path`, `feed::square`
    /// Assumes: travels of at most 128 in size.
    /// Rules: E100L-G01-04, E100L-DIA-01
    #[unwind(2)]
    fn a_diameter_counts_half() {
        let (radius, along) = (i64::from(kani::any::<i8>()), i64::from(kani::any::<i8>()));
        kani::cover!(radius != 0 && along != 0, "both axes");
        let measure = path(square(0, 2 * radius), square(0, along), FeedLength::Radius);
        let wanted = path(square(0, radius), square(0, along), FeedLength::Diameter);
        assert!(measure.divisor == 2 && wanted.divisor == 1 && measure.square == 4 * wanted.square);
    }

    /// A full turn of the C axis counts as 500 mm, and several as so many of them.
    /// Of: `feed::path_with_turn`
    /// Assumes: at most 8 turns either way.
    /// Rules: E100L-CFEED-03
    #[unwind(2)]
    fn a_turn_counts_500_millimetres() {
        let turns = within(8);
        kani::cover!(turns == -8, "eight turns back");
        let Measure { square: found, divisor } = path_with_turn(0, 0, turns * TURN);
        let length = 18 * 500_000_000 * turns;
        assert!(divisor == 18 && found == square(0, length));
    }

    /// With the C axis travels along X count as diameters: a motion without turn is as long as X and Z are.
    /// Of: `feed::path_with_turn`, `feed::path`
    /// Assumes: squares of at most 2^109.
    /// Rules: E100L-CFEED-03, E100L-DIA-02
    #[unwind(6)]
    fn without_a_turn_only_the_axes_count() {
        let [x, z] = [(); 2].map(|()| square(0, kani::any()));
        kani::cover!(x != 0 && z != 0, "both axes");
        assert!(path_with_turn(x, z, 0).square == 324 * path(x, z, FeedLength::Diameter).square);
    }

    /// A fifth of any feed is a fifth in size at most rounded, keeps its sign, and does not overflow.
    /// Of: `feed::fifth`
    /// Assumes: any feed.
    /// Rules: E100L-TRQ-04
    #[unwind(2)]
    fn a_fifth_of_any_feed_is_smaller() {
        let feed: i64 = kani::any();
        kani::cover!(feed == i64::MAX, "the largest feed");
        let fifth = fifth(feed);
        assert!(fifth.unsigned_abs() <= feed.unsigned_abs() && (fifth == 0 || (fifth < 0) == (feed < 0)));
    }

    /// Five fifths differ from the feed by at most two units.
    /// Of: `feed::fifth`
    /// Assumes: feeds of at most 10^5.
    /// Rules: E100L-TRQ-04
    #[unwind(2)]
    fn a_fifth_is_rounded() {
        let feed = between(0, 100_000);
        let rest = 5 * fifth(feed) - feed;
        kani::cover!(rest == 2, "rounded up");
        kani::cover!(rest == -2, "rounded down");
        assert!((-2..=2).contains(&rest));
    }

    /// Whether the torque is watched is decided without overflow; without a delay it is from the start on.
    /// Of: `feed::is_watched`
    /// Assumes: any distance, any feed, any delay.
    /// Rules: E100L-TRQ-07
    #[unwind(2)]
    fn the_watch_never_overflows() {
        let (distance, feed, delay): (i64, i64, u16) = (kani::any(), kani::any(), kani::any());
        kani::cover!(distance == i64::MIN, "the least distance");
        assert!(is_watched(distance, feed, 0) == (distance >= 0));
        assert!(is_watched(distance, feed, delay) || distance < 0 || feed > 0);
    }

    /// Once the torque is watched it stays watched further on, and with a shorter delay it is watched no later.
    /// Of: `feed::is_watched`
    /// Assumes: distances and feeds of at most 1000, delays of at most 9999.
    /// Rules: E100L-TRQ-07
    #[unwind(2)]
    fn the_watch_lasts() {
        let (distance, feed, delay) = (between(0, 1000), between(0, 1000), delay());
        if is_watched(distance, feed, delay) {
            kani::cover!(delay > 0 && feed > 0, "after a delay");
            assert!(is_watched(distance + 1, feed, delay));
            assert!(delay == 0 || is_watched(distance, feed, delay - 1));
        }
    }
}

refutations! {
    /// False: a motion is as long whichever way its diameter is measured.
    #[unwind(2)]
    fn the_reading_does_not_matter() {
        let x = square(0, within(1000));
        let (radius, diameter) = (path(x, 0, FeedLength::Radius), path(x, 0, FeedLength::Diameter));
        assert!(radius.square == 4 * diameter.square);
    }

    /// False: five fifths make the feed.
    #[unwind(2)]
    fn five_fifths_make_the_feed() {
        let feed = between(0, 100_000);
        assert!(5 * fifth(feed) == feed);
    }
}

//! Theorems about where a pass of a thread begins and about its levels.

use turnspec::engine::arithmetic::thread_course::{begin, is_clear, levels};
use turnspec_oracle::integer::thread as oracle;
use turnspec_oracle::vocabulary::{TaperReference, ThreadShift};

use crate::draw::{between, within};
#[cfg(stand_in)]
use crate::kani;

/// Coordinates: far more than those of any address.
const COORDINATE: i64 = 1 << 60;

fn shift_reading() -> ThreadShift {
    if kani::any() { ThreadShift::TowardEnd } else { ThreadShift::Coordinate }
}

fn taper_reading() -> TaperReference {
    if kani::any() { TaperReference::Start } else { TaperReference::End }
}

fn coordinate() -> i64 {
    within(COORDINATE)
}

theorems! {
    /// A thread that begins leads from there to its end in the direction from the cycle start, without overflow.
    /// Of: `thread_course::begin`
    /// Assumes: any coordinates, any shift but the least of 64 bits.
    /// Rules: E100L-G33-04, E100L-G33-07
    #[unwind(2)]
    fn a_thread_leads_on() {
        let (start, end, shift): (i64, i64, i64) = (kani::any(), kani::any(), kani::any());
        kani::assume(shift > i64::MIN);
        let found = begin(start, end, shift, shift_reading());
        kani::cover!(found.is_some() && end < start, "toward smaller coordinates");
        kani::cover!(found.is_none() && end != start, "a shift beyond the end");
        if let Some(begin) = found {
            assert!(begin.cmp(&end) == start.cmp(&end) && begin != end);
        }
    }

    /// A shift toward the end moves the start by its amount that way, one of the coordinate by its sign.
    /// Of: `thread_course::begin`
    /// Assumes: coordinates and shifts of at most 2^60 in size.
    /// Rules: E100L-G33-07
    #[unwind(2)]
    fn a_shift_moves_the_start() {
        let (start, end, shift) = (coordinate(), coordinate(), coordinate());
        let way = if end > start { shift } else { -shift };
        let toward = begin(start, end, shift, ThreadShift::TowardEnd);
        kani::cover!(toward.is_some() && shift < 0, "away from the end");
        assert!(toward.is_none_or(|begin| begin == start + way));
        assert!(begin(start, end, shift, ThreadShift::Coordinate).is_none_or(|begin| begin == start + shift));
        assert!(begin(start, end, 0, shift_reading()) == (start != end).then_some(start));
    }

    /// Engine and oracle begin threads alike.
    /// Of: `thread_course::begin`, `integer::thread::beginning`
    /// Assumes: coordinates and shifts of at most 2^60 in size.
    /// Rules: E100L-G33-04, E100L-G33-07
    #[unwind(2)]
    fn both_begin_alike() {
        let (start, end, shift, reading) = (coordinate(), coordinate(), coordinate(), shift_reading());
        let engine = begin(start, end, shift, reading);
        let beginning = oracle::beginning(start, end, shift, reading);
        kani::cover!(engine.is_some() && shift != 0, "a shifted start");
        assert!(engine == beginning.map(|(_, from)| from));
        assert!(beginning.is_none_or(|(direction, _)| direction == (end - start).signum()));
    }

    /// The levels differ by the taper, and one of them is that of the pass.
    /// Of: `thread_course::levels`
    /// Assumes: levels and tapers of at most 2^60 in size.
    /// Rules: E100L-G33-05
    #[unwind(2)]
    fn levels_differ_by_the_taper() {
        let (level, taper, reading) = (coordinate(), coordinate(), taper_reading());
        let (first, last) = levels(level, taper, reading);
        kani::cover!(reading == TaperReference::End && taper < 0, "falling to the level");
        assert!(last - first == taper);
        assert!(level == if reading == TaperReference::Start { first } else { last });
    }

    /// No level wraps: a taper that grows never falls.
    /// Of: `thread_course::levels`
    /// Assumes: any level and taper.
    /// Rules: E100L-G33-05, E100L-ADDR-01
    #[unwind(2)]
    fn no_level_wraps() {
        let (level, taper): (i64, i64) = (kani::any(), kani::any());
        let (first, last) = levels(level, taper, taper_reading());
        kani::cover!(first == i64::MIN && taper > 0, "the end of 64 bits");
        assert!(if taper >= 0 { first <= last } else { first >= last });
    }

    /// Engine and oracle taper alike.
    /// Of: `thread_course::levels`, `integer::thread::levels`
    /// Assumes: levels and tapers of at most 2^60 in size.
    /// Rules: E100L-G33-05
    #[unwind(2)]
    fn both_taper_alike() {
        let (level, taper, reading) = (coordinate(), coordinate(), taper_reading());
        kani::cover!(taper != 0, "a taper");
        assert!(levels(level, taper, reading) == oracle::levels(level, taper, reading));
    }

    /// The cycle start is clear of the thread exactly when it lies above both levels, on side 1, or below both, on side
    /// -1.
    /// Of: `thread_course::is_clear`
    /// Assumes: any levels.
    /// Rules: E100L-G33-04
    #[unwind(2)]
    fn the_start_is_clear_above_or_below() {
        let (start, first, last): (i64, i64, i64) = (kani::any(), kani::any(), kani::any());
        kani::cover!(start > first && start < last, "between the levels");
        assert!(is_clear(1, start, (first, last)) == (start > first.max(last)));
        assert!(is_clear(-1, start, (first, last)) == (start < first.min(last)));
        assert!(!is_clear(0, start, (first, last)));
    }

    /// Engine and oracle refuse the same cycle starts.
    /// Of: `thread_course::is_clear`, `integer::thread::is_beyond`
    /// Assumes: levels of at most 2^60 in size.
    /// Rules: E100L-G33-04
    #[unwind(2)]
    fn both_refuse_a_side_alike() {
        let (side, start, first, last) = (between(-1, 1), coordinate(), coordinate(), coordinate());
        let beyond = |level| oracle::is_beyond(side, start, level);
        kani::cover!(beyond(first) && !beyond(last), "beyond one of them");
        assert!(is_clear(side, start, (first, last)) != (beyond(first) || beyond(last)));
    }

    /// A pass lies above the last one by what is left, on the side of the cycle start.
    /// Of: `integer::thread::level_above`
    /// Assumes: levels and heights of at most 2^60 in size.
    /// Rules: E100L-G71-02, E100L-G72-02
    #[unwind(2)]
    fn a_pass_lies_above_the_last_one() {
        let (last, above) = (coordinate(), between(0, COORDINATE));
        kani::cover!(above > 0, "not the last pass");
        assert!(oracle::level_above(last, 1, above) - last == above);
        assert!(last - oracle::level_above(last, -1, above) == above);
    }
}

refutations! {
    /// False: a shift always leaves a thread.
    #[unwind(2)]
    fn a_shift_leaves_a_thread() {
        let (start, end) = (coordinate(), coordinate());
        assert!(start == end || begin(start, end, coordinate(), shift_reading()).is_some());
    }

    /// False: a cycle start that is clear of the level of the pass is clear of the thread.
    #[unwind(2)]
    fn one_level_is_enough() {
        let (level, taper) = (coordinate(), coordinate());
        let start = coordinate();
        assert!(start <= level || is_clear(1, start, levels(level, taper, taper_reading())));
    }
}

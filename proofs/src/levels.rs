//! Theorems about the levels and lines of LAP.

use turnspec::engine::arithmetic::lap::{
    across, halves, is_reached, keeps_sense, next_level, on_line, scaled,
};
use turnspec_oracle::integer::lap::{below, has_reached};

use crate::draw::{between, factor, within};
#[cfg(stand_in)]
use crate::kani;

/// Coordinates and words.
const FAR: i64 = 1 << 60;
const WORD: i64 = 1 << 38;
/// Coordinates of contours in half nanometres.
const NEAR: i128 = 1 << 40;

fn sense() -> i64 {
    if kani::any() { 1 } else { -1 }
}

fn coordinate() -> i64 {
    i64::try_from(factor(i128::from(FAR))).unwrap_or(0)
}

theorems! {
    /// The next level lies a depth lower, and engine and oracle find the same one.
    /// Of: `lap::next_level`, oracle `lap::below`
    /// Assumes: levels of at most 2^60 in size, depths of 0 to 2^38.
    /// Rules: E100L-AP1-02
    #[unwind(2)]
    fn the_next_level_is_a_depth_lower() {
        let (level, depth, sense) = (within(FAR), between(0, WORD), sense());
        let next = next_level(level, sense, depth);
        kani::cover!(sense < 0 && depth > 0, "from inside");
        assert!((level - next) * sense == depth);
        assert!(next == below(level, sense, depth));
    }

    /// A change point acts on the level where it is and on every one below, on none above; engine and oracle agree.
    /// Of: `lap::is_reached`, oracle `lap::has_reached`
    /// Assumes: levels and points of at most 2^60 in size.
    /// Rules: E100L-LAPC-03
    #[unwind(2)]
    fn a_change_point_acts_from_its_level_on() {
        let (level, place, sense) = (within(FAR), within(FAR), sense());
        let reached = is_reached(level, place, sense);
        kani::cover!(level == place, "a level at the change point");
        assert!(reached == if sense > 0 { level <= place } else { level >= place });
        assert!(reached == has_reached(level, place, sense));
    }

    /// What has reached a change point stays there one level further down.
    /// Of: `lap::is_reached`, `lap::next_level`
    /// Assumes: levels and points of at most 2^60 in size, depths of 0 to 2^38.
    /// Rules: E100L-AP1-02, E100L-LAPC-03
    #[unwind(2)]
    fn a_change_point_stays_reached() {
        let (level, place, sense) = (within(FAR), within(FAR), sense());
        let next = next_level(level, sense, between(0, WORD));
        let before = is_reached(level, place, sense);
        kani::cover!(!before && is_reached(next, place, sense), "a point between two levels");
        assert!(!before || is_reached(next, place, sense));
    }

    /// Heights are ordered as coordinates are in the sense in which heights grow, whether they are diameters or not.
    /// Of: `lap::scaled`
    /// Assumes: coordinates of at most 2^60 in size.
    /// Rules: E100L-LAP-20
    #[unwind(2)]
    fn heights_are_ordered_like_coordinates() {
        let (one, other, sense, diameter) = (within(FAR), within(FAR), sense(), kani::any());
        let heights = scaled(one, sense, diameter).cmp(&scaled(other, sense, diameter));
        kani::cover!(sense < 0 && one < other, "from inside");
        assert!(heights == if sense > 0 { one.cmp(&other) } else { other.cmp(&one) });
    }

    /// A diameter counts half as much as a length.
    /// Of: `lap::halves`, `lap::scaled`
    /// Assumes: coordinates of at most 2^60 in size.
    /// Rules: E100L-DIA-01
    #[unwind(2)]
    fn diameters_count_half() {
        let (value, sense) = (within(FAR), sense());
        kani::cover!(value != 0, "a coordinate");
        assert!(scaled(value, sense, false) == 2 * scaled(value, sense, true));
        assert!(halves(false) == 2 * halves(true));
    }

    /// The mirror image of an arc in either axis is one of the other sense, that in both has its own.
    /// Of: `lap::keeps_sense`
    /// Assumes: nothing.
    /// Rules: E100L-CIRC-01
    #[unwind(2)]
    fn a_mirror_turns_arcs_round() {
        let (infeed, cutting, along) = (sense(), sense(), kani::any());
        let kept = keeps_sense(infeed, cutting, along);
        kani::cover!(kept, "an arc of its own sense");
        kani::cover!(!kept, "an arc of the other sense");
        assert!(keeps_sense(-infeed, cutting, along) != kept && keeps_sense(infeed, -cutting, along) != kept);
        assert!(keeps_sense(-infeed, -cutting, along) == kept && keeps_sense(infeed, cutting, !along) != kept);
    }

    /// The line from the AP start to the contour begins in the one and ends in the other.
    /// Of: `lap::on_line`
    /// Assumes: coordinates of at most 8 in size for the model checker, of at most 2^60 for the property tests; levels differ.
    /// Rules: E100L-AP1-03
    #[unwind(2)]
    fn the_way_in_has_its_ends() {
        let (start, end) = ((coordinate(), coordinate()), (coordinate(), coordinate()));
        kani::assume(start.0 != end.0);
        kani::cover!(start.1 != end.1, "a slanting line");
        let (over, under) = on_line(start, end, start.0);
        assert!(under != 0 && over == i128::from(start.1) * under);
        let (over, under) = on_line(start, end, end.0);
        assert!(over == i128::from(end.1) * under);
    }

    /// On a level between the two the line lies between their coordinates of the cutting axis.
    /// Of: `lap::on_line`
    /// Assumes: coordinates of at most 8 in size for the model checker, of at most 2^60 for the property tests; the start above.
    /// Rules: E100L-AP1-03
    #[unwind(2)]
    fn the_way_in_lies_between_its_ends() {
        let (start, end, level) = ((coordinate(), coordinate()), (coordinate(), coordinate()), coordinate());
        let level = level.clamp(start.0.min(end.0), start.0.max(end.0));
        kani::assume(start.0 > end.0);
        kani::cover!(end.0 < level && level < start.0, "a level between them");
        let (over, under) = on_line(start, end, level);
        let (low, high) = (start.1.min(end.1), start.1.max(end.1));
        assert!(i128::from(low) * under <= over && over <= i128::from(high) * under);
    }

    /// A line of the contour has its ends, and where it is level every point of it has their height.
    /// Of: `lap::across`
    /// Assumes: coordinates of at most 8 in size for the model checker, of at most 2^40 for the property tests; runs differ.
    /// Rules: E100L-AP1-04
    #[unwind(2)]
    fn a_line_has_its_ends() {
        let (from, to) = ((factor(NEAR), factor(NEAR)), (factor(NEAR), factor(NEAR)));
        kani::assume(from.0 != to.0);
        kani::cover!(from.1 != to.1, "a slope");
        let (over, under) = across(from, to, from.0);
        assert!(over == from.1 * under);
        let (over, under) = across(from, to, to.0);
        assert!(over == to.1 * under);
        let (over, under) = across(from, (to.0, from.1), factor(NEAR));
        assert!(over == from.1 * under);
    }

    /// A line is the same from either end.
    /// Of: `lap::across`
    /// Assumes: coordinates of at most 8 in size for the model checker, of at most 2^40 for the property tests; runs differ.
    /// Rules: E100L-AP1-04
    #[unwind(2)]
    fn a_line_is_the_same_from_either_end() {
        let (from, to) = ((factor(NEAR), factor(NEAR)), (factor(NEAR), factor(NEAR)));
        let at = factor(NEAR);
        kani::assume(from.0 != to.0);
        kani::cover!(from.1 != to.1 && at != from.0, "a point of a slope");
        let ((over, under), (back, below)) = (across(from, to, at), across(to, from, at));
        assert!(over * below == back * under);
    }
}

refutations! {
    /// False: a change point acts only behind it.
    #[unwind(2)]
    fn change_points_act_behind_them() {
        let (level, place) = (within(FAR), within(FAR));
        kani::assume(level - place < 3 && place - level < 3);
        assert!(is_reached(level, place, 1) == (level < place));
    }

    /// False: the line from the AP start never leads beyond the start of the contour.
    #[unwind(2)]
    fn the_way_in_ends_at_the_contour() {
        let (start, end, level) = ((coordinate(), coordinate()), (coordinate(), coordinate()), coordinate());
        kani::assume(start.0 > end.0);
        let (over, under) = on_line(start, end, level);
        assert!(i128::from(start.1.min(end.1)) * under <= over);
    }

    /// False: a mirror in the infeed axis alone keeps the sense of arcs.
    #[unwind(2)]
    fn a_mirror_keeps_arcs() {
        let (infeed, cutting, along) = (sense(), sense(), kani::any());
        assert!(keeps_sense(-infeed, cutting, along) == keeps_sense(infeed, cutting, along));
    }
}

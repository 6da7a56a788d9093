//! The corner of two elements, i that ends in P and j that begins there: where the nose circle touches both, or what
//! takes the place of such a point (E100L-NRC-50).

use super::circle::Circle;
use super::leg::{Course, Leg};
use super::reach::Reach;
use super::{arcs, line_and_arc, lines};
use crate::fault::{Outcome, fail};
use crate::integer::nose::touches_both;
use crate::quantity::Exact;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, RuleId, RuleSet};

/// The way from P to the nose centre, and the rules of the corner.
pub fn corner(i: &Leg, j: &Leg) -> Outcome<(Reach, RuleSet)> {
    let (before, after) = (i.tangent(), j.tangent());
    let parallel = before.cross(&after).is_zero();
    let (reach, rule) =
        if parallel { along_one_line(i, j, before.dot(&after) > Exact::ZERO)? } else { meeting(i, j)? };
    let mut rules = RuleSet::of(&[rule]);
    if i.nose.radius != j.nose.radius {
        rules = rules.with(NRC_11);
    }
    if i.nose.side != j.nose.side && !parallel {
        // E100L-NRC-64: in an arc block as in a line.
        rules = rules.with(if both_straight(i, j) { NRC_62 } else { NRC_63 });
    }
    Ok((reach, rules))
}

fn both_straight(i: &Leg, j: &Leg) -> bool {
    i.is_line() && j.is_line()
}

/// Tangents that are parallel, exactly (E100L-NRC-34).
fn along_one_line(i: &Leg, j: &Leg, onward: bool) -> Outcome<(Reach, RuleId)> {
    let (offset, next) = (i.nose.offset(), j.nose.offset());
    let straight = both_straight(i, j);
    // E100L-NRC-30 and E100L-NRC-49: straight on with one offset. E100L-NRC-31: back on the other side.
    let touches_both = touches_both(offset, next, onward);
    let rule = match (onward, touches_both) {
        (true, true) if straight => NRC_30,
        (true, true) => NRC_49,
        (false, true) => NRC_31,
        // E100L-NRC-33, E100L-NRC-32: beside one another; the special processing stays with i.
        (true, false) if straight => NRC_33,
        (false, false) if straight => NRC_32,
        _ => return fail(AlarmName::CompensationNoIntersection, NRC_53),
    };
    Ok((Reach::contact(i), rule))
}

fn meeting(i: &Leg, j: &Leg) -> Outcome<(Reach, RuleId)> {
    let (reach, rule) = match (&i.course, &j.course) {
        (Course::Line(before), Course::Line(after)) => {
            (Some(lines::meeting(before, i.nose, after, j.nose)), NRC_26)
        }
        (Course::Line(line), Course::Arc(from_centre, sense)) => {
            (line_and_arc::meeting(line, i.nose, Circle::new(from_centre, *sense, &j.nose)), NRC_51)
        }
        (Course::Arc(from_centre, sense), Course::Line(line)) => {
            (line_and_arc::meeting(line, j.nose, Circle::new(from_centre, *sense, &i.nose)), NRC_51)
        }
        (Course::Arc(before, sense), Course::Arc(after, sense_after)) => {
            let (before, after) =
                (Circle::new(before, *sense, &i.nose), Circle::new(after, *sense_after, &j.nose));
            (arcs::meeting(before, after), NRC_52)
        }
    };
    match reach {
        Some(reach) => Ok((reach, rule)),
        None => fail(AlarmName::CompensationNoIntersection, NRC_53),
    }
}

//! E100L-AP4-05: where a cut along a level goes through stock, and where through air.

use super::number::Number;
use crate::quantity::Exact;

/// A part of a straight cut.
#[derive(Clone, Debug)]
pub struct Section {
    /// The run at which it ends.
    pub to: Number,
    /// Whether it goes through air.
    pub air: bool,
}

/// The parts of a cut from one run to another: around the stretches of stock, and around its ends, it is cut.
pub fn sections(from: &Number, to: &Number, stock: &[(Number, Number)], clearance: &Exact) -> Vec<Section> {
    let backward = to < from;
    let (low, high) = if backward { (to, from) } else { (from, to) };
    let between = |run: Number| run.max(low.clone()).min(high.clone());
    let lengthened = |(begin, end): (Number, Number)| {
        (between(begin.plus(&-clearance.clone())), between(end.plus(clearance)))
    };
    // Stock beyond the cut is clipped to one of its ends.
    let clipped = stock.iter().map(|(begin, end)| (between(begin.clone()), between(end.clone())));
    let ends = [(low.clone(), low.clone()), (high.clone(), high.clone())];
    let mut stretches: Vec<_> = clipped.chain(ends).map(lengthened).collect();
    stretches.sort();
    let mut joined: Vec<(Number, Number)> = Vec::new();
    for (begin, end) in stretches {
        match joined.last_mut() {
            Some(last) if begin <= last.1 => last.1 = last.1.clone().max(end),
            _ => joined.push((begin, end)),
        }
    }
    if backward {
        joined.reverse();
    }
    let mut sections = Vec::new();
    for (index, (begin, end)) in joined.into_iter().enumerate() {
        let (first, last) = if backward { (end, begin) } else { (begin, end) };
        if index > 0 {
            sections.push(Section { to: first, air: true });
        }
        sections.push(Section { to: last, air: false });
    }
    sections
}

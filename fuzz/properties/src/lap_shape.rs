//! Contours and blanks that are composed from bytes: lines and arcs that do not go back, in increments, and what the
//! control makes of them as chains of legs.

use arbitrary::{Result, Unstructured};

use crate::lap_plane::{Bow, Leg, Spot};

/// Nanometres of half a micrometre, in which points are composed: an increment of X as a radius, half an increment of Z.
pub(crate) const HALF: f64 = 500.0;

/// A way by run and height, in half micrometres; amounts on X as radii.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) struct Way {
    pub(crate) run: i64,
    pub(crate) height: i64,
}

impl Way {
    pub(crate) fn plus(self, other: Self) -> Self {
        Self { run: self.run + other.run, height: self.height + other.height }
    }

    pub(crate) fn less(self, other: Self) -> Self {
        Self { run: self.run - other.run, height: self.height - other.height }
    }

    pub(crate) fn spot(self) -> Spot {
        Spot { run: self.run as f64 * HALF, height: self.height as f64 * HALF }
    }
}

/// An arc: its centre from its start, its radius, and whether it passes over its centre.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Arc {
    pub(crate) centre: Way,
    pub(crate) radius: i64,
    pub(crate) over: bool,
}

/// An element: the way to its end, and what makes it an arc.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Element {
    pub(crate) way: Way,
    pub(crate) arc: Option<Arc>,
}

impl Element {
    pub(crate) fn line(run: i64, height: i64) -> Self {
        Self { way: Way { run, height }, arc: None }
    }

    /// The direction of a line without run: 1 up, -1 down; 0 of all others.
    fn wall(self) -> i64 {
        if self.way.run == 0 { self.way.height.signum() } else { 0 }
    }
}

/// Spokes of the upper half of a circle of radius 5, in the order of their run.
const SPOKES: [(i64, i64); 7] = [(-5, 0), (-4, 3), (-3, 4), (0, 5), (3, 4), (4, 3), (5, 0)];

/// A size in half micrometres, a whole micrometre or many.
fn size(bytes: &mut Unstructured<'_>) -> Result<i64> {
    Ok(2 * match bytes.int_in_range(0..=5)? {
        0 => bytes.int_in_range(1..=3)?,
        1 => bytes.int_in_range(1..=400)?,
        2 => 1_000 * bytes.int_in_range(1..=5)?,
        _ => bytes.int_in_range(100..=6_000)?,
    })
}

fn arc(bytes: &mut Unstructured<'_>, rises: bool) -> Result<Element> {
    let size = size(bytes)?.min(1_600);
    let over = bytes.arbitrary()?;
    let side = if over { 1 } else { -1 };
    // One that only rises is on the left side over its centre, or on the right side under it.
    let (low, high) = match (rises, over) {
        (false, _) => (0, 6),
        (true, true) => (0, 3),
        (true, false) => (3, 6),
    };
    let first = bytes.int_in_range(low..=high - 1)?;
    let (from, to) = (SPOKES[first], SPOKES[bytes.int_in_range(first + 1..=high)?]);
    let way = Way { run: size * (to.0 - from.0), height: side * size * (to.1 - from.1) };
    let centre = Way { run: -size * from.0, height: -side * size * from.1 };
    Ok(Element { way, arc: Some(Arc { centre, radius: 5 * size, over }) })
}

/// An element behind a line of this direction without run.
fn element(bytes: &mut Unstructured<'_>, wall: i64, rises: bool) -> Result<Element> {
    let (run, height) = (size(bytes)?, size(bytes)?);
    let down = !rises && bytes.arbitrary()?;
    let height = if down { -height } else { height };
    Ok(match bytes.int_in_range(0..=5)? {
        0 | 1 if wall * height >= 0 => Element::line(0, height),
        0..=2 => Element::line(run, height),
        3 => Element::line(run, 0),
        _ => arc(bytes, rises)?,
    })
}

/// Elements that do not go back; the last one has run.
pub(crate) fn elements(
    bytes: &mut Unstructured<'_>,
    most: usize,
    wall: i64,
    rises: bool,
) -> Result<Vec<Element>> {
    let count = bytes.int_in_range(0..=most)?;
    let mut made: Vec<Element> = Vec::new();
    for _ in 0..count {
        let wall = made.last().map_or(wall, |element| element.wall());
        made.push(element(bytes, wall, rises)?);
    }
    made.push(Element::line(size(bytes)?, 0));
    Ok(made)
}

/// Whether two successive elements go up and down at one run.
pub(crate) fn turns_back(elements: &[Element]) -> bool {
    elements.windows(2).any(|pair| pair[0].wall() * pair[1].wall() < 0)
}

/// Where a chain of elements ends.
pub(crate) fn end(from: Way, elements: &[Element]) -> Way {
    elements.iter().fold(from, |at, element| at.plus(element.way))
}

/// The legs of a chain of elements.
pub(crate) fn legs(from: Way, elements: &[Element]) -> Vec<Leg> {
    let mut at = from;
    let mut legs = Vec::new();
    for element in elements {
        let to = at.plus(element.way);
        let bow = element.arc.map(|arc| Bow { centre: at.plus(arc.centre).spot(), over: arc.over });
        legs.push(Leg { from: at.spot(), to: to.spot(), bow });
        at = to;
    }
    legs
}

/// The heights at which a chain of elements turns, those of its ends first and last; what is level counts once.
pub(crate) fn turns(from: Way, elements: &[Element]) -> Vec<i64> {
    let mut at = from;
    let mut heights = vec![at.height];
    for element in elements {
        if let Some(Arc { centre, radius, over }) = element.arc {
            let middle = at.plus(centre);
            if at.run < middle.run && middle.run < at.run + element.way.run {
                heights.push(middle.height + if over { radius } else { -radius });
            }
        }
        at = at.plus(element.way);
        heights.push(at.height);
    }
    heights.dedup();
    let mut turns: Vec<i64> = Vec::new();
    for height in heights {
        if let [.., before, last] = turns.as_slice()
            && (last - before).signum() == (height - last).signum()
        {
            turns.pop();
        }
        turns.push(height);
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::{Arc, Element, Way, elements, end, turns, turns_back};
    use crate::bytes_of_seed;
    use arbitrary::Unstructured;

    const OVER: Element = Element {
        way: Way { run: 80, height: 0 },
        arc: Some(Arc { centre: Way { run: 40, height: -30 }, radius: 50, over: true }),
    };

    #[test]
    fn turns_are_the_highest_and_lowest_points() {
        let chain =
            [Element::line(0, 10), Element::line(5, 0), Element::line(5, 20), OVER, Element::line(0, -40)];
        assert_eq!(turns(Way::default(), &chain), [0, 50, -10]);
        assert_eq!(end(Way::default(), &chain), Way { run: 90, height: -10 });
    }

    #[test]
    fn composed_elements_do_not_go_back() {
        for seed in 0..200 {
            let bytes = bytes_of_seed(seed, 200);
            let rises = seed % 2 == 0;
            let made = elements(&mut Unstructured::new(&bytes), 9, 0, rises).expect("bytes suffice");
            assert!(!turns_back(&made) && made.iter().all(|element| element.way.run >= 0));
            assert!(!rises || turns(Way::default(), &made).len() <= 2, "{made:?}");
        }
    }
}

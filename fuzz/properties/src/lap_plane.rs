//! The plane of a rough turning cycle: lines and arcs by run and height, and what lies above them.
//!
//! Height grows away from the finished part, run in the sense in which the contour is cut; both in nanometres, on X as
//! radii. Nothing here is rounded, and everything is told within a tolerance.

/// How far a point may lie from where it should: that of latching.
pub(crate) const LATCHED: f64 = 3.0;

/// A point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Spot {
    pub(crate) run: f64,
    pub(crate) height: f64,
}

impl Spot {
    pub(crate) fn plus(self, other: Self) -> Self {
        Self { run: self.run + other.run, height: self.height + other.height }
    }

    pub(crate) fn less(self, other: Self) -> Self {
        Self { run: self.run - other.run, height: self.height - other.height }
    }

    pub(crate) fn length(self) -> f64 {
        self.run.hypot(self.height)
    }
}

/// The circle of an arc that does not go back along the run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Bow {
    pub(crate) centre: Spot,
    /// Whether it passes over its centre.
    pub(crate) over: bool,
}

/// A line or an arc.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Leg {
    pub(crate) from: Spot,
    pub(crate) to: Spot,
    pub(crate) bow: Option<Bow>,
}

impl Leg {
    /// The same, moved.
    pub(crate) fn moved(self, way: Spot) -> Self {
        let bow = self.bow.map(|bow| Bow { centre: bow.centre.plus(way), ..bow });
        Self { from: self.from.plus(way), to: self.to.plus(way), bow }
    }

    /// Its least and its greatest run.
    pub(crate) fn runs(self) -> (f64, f64) {
        (self.from.run.min(self.to.run), self.from.run.max(self.to.run))
    }

    /// Its point at a run that it has; of a line without run its start.
    pub(crate) fn point(self, run: f64) -> Spot {
        let height = match self.bow {
            Some(Bow { centre, over }) => {
                let (radius, side) = (self.from.less(centre).length(), run - centre.run);
                let rise = (radius * radius - side * side).max(0.0).sqrt();
                let height = centre.height + if over { rise } else { -rise };
                // Where a circle is steep, the rounding of an end is a greater way along its height.
                if (self.from.run < centre.run) == (centre.run < self.to.run) {
                    height
                } else {
                    let (one, other) = (self.from.height, self.to.height);
                    height.clamp(one.min(other), one.max(other))
                }
            }
            None if self.from.run == self.to.run => self.from.height,
            None => {
                let share = (run - self.from.run) / (self.to.run - self.from.run);
                self.from.height + share * (self.to.height - self.from.height)
            }
        };
        Spot { run, height }
    }

    /// The least and the greatest height that it has within the tolerance of a run.
    pub(crate) fn heights(self, run: f64) -> Option<(f64, f64)> {
        let (first, last) = self.runs();
        let (from, to) = ((run - LATCHED).max(first), (run + LATCHED).min(last));
        if from > to {
            return None;
        }
        let mut heights = vec![self.point(from).height, self.point(to).height];
        if from == first || to == last {
            let ends = [self.from, self.to];
            heights.extend(ends.iter().filter(|end| (from..=to).contains(&end.run)).map(|end| end.height));
        }
        if let Some(Bow { centre, .. }) = self.bow.filter(|bow| (from..=to).contains(&bow.centre.run)) {
            heights.push(self.point(centre.run).height);
        }
        Some(
            heights
                .iter()
                .fold((f64::MAX, f64::MIN), |(low, high), height| (height.min(low), height.max(high))),
        )
    }

    /// Points along it, its ends among them.
    pub(crate) fn points(self) -> impl Iterator<Item = Spot> {
        (0..=8).map(move |part| {
            let share = f64::from(part) / 8.0;
            let run = self.from.run + share * (self.to.run - self.from.run);
            match part {
                0 => self.from,
                8 => self.to,
                _ if self.from.run == self.to.run => {
                    Spot { run, height: self.from.height + share * (self.to.height - self.from.height) }
                }
                _ => self.point(run),
            }
        })
    }

    /// Whether a point lies on it, within the tolerance.
    pub(crate) fn holds(self, spot: Spot) -> bool {
        let close = |end: Spot| end.less(spot).length() <= LATCHED;
        if close(self.from) || close(self.to) {
            return true;
        }
        let (first, last) = self.runs();
        match self.bow {
            Some(Bow { centre, over }) => {
                let (radius, spoke) = (self.from.less(centre).length(), spot.less(centre));
                let side = if over { spoke.height } else { -spoke.height };
                (spoke.length() - radius).abs() <= LATCHED
                    && side >= -LATCHED
                    && (first - LATCHED..=last + LATCHED).contains(&spot.run)
            }
            None => {
                let (way, to) = (self.to.less(self.from), spot.less(self.from));
                let length = way.length();
                let along = (to.run * way.run + to.height * way.height) / length;
                let across = (to.run * way.height - to.height * way.run) / length;
                across.abs() <= LATCHED && (-LATCHED..=length + LATCHED).contains(&along)
            }
        }
    }

    /// The greatest height of it.
    pub(crate) fn top(self) -> f64 {
        let (first, last) = self.runs();
        let ends = self.from.height.max(self.to.height);
        match self.bow {
            Some(bow) if bow.over && (first..=last).contains(&bow.centre.run) => {
                ends.max(self.point(bow.centre.run).height)
            }
            _ => ends,
        }
    }
}

/// The least and the greatest height of a chain of legs within the tolerance of a run; none where it has no such run.
pub(crate) fn heights(legs: &[Leg], run: f64) -> Option<(f64, f64)> {
    let own = legs.iter().filter_map(|leg| leg.heights(run));
    own.reduce(|(low, high), (lower, higher)| (low.min(lower), high.max(higher)))
}

/// Runs between the ends of legs, some in each gap between them: no leg ends, and none has its highest or lowest point,
/// between two successive ones of a gap and far from both.
pub(crate) fn runs_between(chains: &[&[Leg]]) -> Vec<f64> {
    let legs = chains.iter().flat_map(|legs| legs.iter());
    let mut ends: Vec<f64> = legs
        .flat_map(|leg| [Some(leg.from.run), Some(leg.to.run), leg.bow.map(|bow| bow.centre.run)])
        .flatten()
        .collect();
    ends.sort_by(f64::total_cmp);
    let gaps = ends.windows(2).filter(|gap| gap[1] - gap[0] > 12.0 * LATCHED);
    gaps.flat_map(|gap| [0.03, 0.25, 0.5, 0.75, 0.97].map(|share| gap[0] + share * (gap[1] - gap[0])))
        .filter(|run| ends.iter().all(|end| (end - run).abs() > 2.0 * LATCHED))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Bow, Leg, Spot, heights};

    fn spot(run: f64, height: f64) -> Spot {
        Spot { run, height }
    }

    /// A wall up by 5000, and over a quarter and a half of a circle of 5000.
    fn chain() -> [Leg; 2] {
        let bow = Some(Bow { centre: spot(5_000.0, 5_000.0), over: true });
        [
            Leg { from: spot(0.0, 0.0), to: spot(0.0, 5_000.0), bow: None },
            Leg { from: spot(0.0, 5_000.0), to: spot(8_000.0, 9_000.0), bow },
        ]
    }

    #[test]
    fn heights_are_those_of_lines_and_circles() {
        assert_eq!(heights(&chain(), 0.0).map(|(low, _)| low), Some(0.0));
        assert_eq!(heights(&chain(), 5_000.0).map(|(_, high)| high), Some(10_000.0));
        assert_eq!(heights(&chain(), 9_000.0), None);
        assert_eq!(chain()[1].top(), 10_000.0);
    }

    #[test]
    fn points_lie_on_their_leg_only() {
        let [wall, arc] = chain();
        assert!(wall.points().all(|point| wall.holds(point) && !wall.holds(point.plus(spot(-5.0, 5.0)))));
        assert!(arc.points().all(|point| arc.holds(point)));
        assert!(!arc.holds(spot(5_000.0, 10_005.0)) && !arc.holds(spot(5_000.0, 0.0)));
        assert!(!arc.holds(spot(9_000.0, 8_000.0)));
    }
}

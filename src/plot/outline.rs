//! What a LAP call was told to cut: the programmed contour, and the blank.

use turnspec_conformance::geometry::{Arc, Point, Way};
use turnspec_oracle::vocabulary::PlanePosition;
use turnspec_oracle::{Outline, OutlineMotion};

/// A contour and its blank as ways.
#[derive(Clone, PartialEq, Debug)]
pub struct Definition {
    /// The contour, without allowance.
    pub contour: Vec<Way>,
    /// The blank; nothing without one.
    pub blank: Vec<Way>,
}

impl Definition {
    /// That of a call, as far as there is room for so many ways.
    pub fn of(outline: &Outline, room: usize) -> Self {
        let contour: Vec<Way> = ways(&outline.contour).take(room).collect();
        let blank = ways(&outline.blank).take(room - contour.len()).collect();
        Self { contour, blank }
    }

    /// Contour and blank.
    pub fn ways(&self) -> impl Iterator<Item = &Way> {
        self.contour.iter().chain(&self.blank)
    }
}

fn ways(motions: &[OutlineMotion]) -> impl Iterator<Item = Way> {
    let pairs = motions.iter().zip(motions.iter().skip(1));
    pairs.map(|(from, to)| {
        let arc = to.arc.map(|(centre, sense)| Arc::of(centre.z, centre.x, sense));
        Way { from: point(from.end), to: point(to.end), arc }
    })
}

fn point(position: PlanePosition) -> Point {
    Point::of(position.z, position.x)
}

#[cfg(test)]
mod tests {
    use super::{Definition, Point};
    use turnspec_oracle::Run;
    use turnspec_oracle::vocabulary::{Event, Setup};

    const PROGRAM: &[u8] =
        b"NAT1 G83\nG01 X40 Z22\nX62\nZ0\nG81\nG00 X40 Z22\nG01 Z10 F0.2\nG02 X60 Z0 I10\nG80\n\
        G00 X62 Z22\nG85 NAT1 D8 U0.2 F0.3\nM02\n";

    #[test]
    fn contour_and_blank_of_a_call_are_ways() {
        let setup = Setup::from_toml("[options]\nlap = 4\n").expect("a set-up");
        let mut run = Run::new(PROGRAM, &setup);
        let mut alarms = Vec::new();
        while run.step(&mut |event: &Event| alarms.push(*event)).is_none() {}
        let outline = run.outline().unwrap_or_else(|| panic!("{alarms:?}"));
        let definition = Definition::of(outline, 100);
        let ends = |ways: &[super::Way]| ways.iter().map(|way| (way.to.z, way.to.x)).collect::<Vec<_>>();
        assert_eq!(ends(&definition.contour), [(10.0, 20.0), (0.0, 30.0)]);
        assert_eq!(definition.contour[1].arc.map(|arc| arc.centre), Some(Point::new(10.0, 30.0)));
        assert_eq!(definition.contour[0].from, Point::new(22.0, 20.0));
        assert_eq!(ends(&definition.blank), [(22.0, 31.0), (0.0, 31.0)]);
        assert_eq!(Definition::of(outline, 3).ways().count(), 3);
    }
}

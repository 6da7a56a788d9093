//! Contours that are composed: the commanded radius, the image in a mirror, one increment more.

use arbitrary::{Result, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{Action, AlarmName, ContourPlane, Event, Part, Setup, SidePlane};

use crate::contours::{LATCHED, follow};
use crate::plane::Spot;
use crate::shape::trace;
use crate::{Verdict, require};

/// A block behind a positioning: X, Z in micrometres, C in thousandths of a degree, L in micrometres.
#[derive(Clone, Copy, Debug)]
struct Contour {
    code: u16,
    start: (i64, i64),
    end: (i64, i64),
    rise: i64,
    radius: i64,
    /// M16 instead of M15.
    backward: bool,
    inner: bool,
}

impl Contour {
    fn arbitrary(bytes: &mut Unstructured<'_>) -> Result<Self> {
        let code = bytes.choose(&[101, 102, 103, 132, 133]).copied()?;
        let x = bytes.int_in_range(1_000..=200_000)?;
        let c = bytes.int_in_range(0..=359_999)?;
        let same = code > 103 || bytes.ratio(1, 4)?;
        let to_x = if same { x } else { bytes.int_in_range(1_000..=200_000)? };
        let turn = match bytes.int_in_range(0..=5)? {
            0 => 180_000,
            1 => 180_000 + bytes.int_in_range(-9..=9)?,
            2 => 0,
            _ => bytes.int_in_range(0..=359_999)?,
        };
        let rise = if code > 103 { bytes.int_in_range(-100_000..=100_000)? } else { 0 };
        let radius = match bytes.int_in_range(0..=3)? {
            0 => bytes.int_in_range(1..=300_000)?,
            1 => (x + to_x) / 4,
            _ => (x + to_x) / 4 + bytes.int_in_range(0..=90_000)?,
        };
        let (backward, inner) = (bytes.arbitrary()?, bytes.arbitrary()?);
        let end = (to_x, (c + turn) % 360_000);
        Ok(Self { code, start: (x, c), end, rise, radius: radius.max(1), backward, inner })
    }

    /// What the mirror at the direction C0 makes of it.
    fn mirrored(self) -> Self {
        let code = match self.code {
            102 => 103,
            103 => 102,
            132 => 133,
            133 => 132,
            other => other,
        };
        let image = |(x, c): (i64, i64)| (x, (360_000 - c) % 360_000);
        Self { code, start: image(self.start), end: image(self.end), backward: !self.backward, ..self }
    }

    /// What its plane from the other side makes of it.
    fn seen_inside(self) -> Self {
        let code = if self.code == 132 { 133 } else { 132 };
        Self { code, inner: !self.inner, ..self }
    }

    fn case(self) -> Case {
        let mut setup = Setup::default();
        setup.parameters.side_plane = if self.inner { SidePlane::Inner } else { SidePlane::Outer };
        let number = |thousandths: i64| {
            let sign = if thousandths < 0 { "-" } else { "" };
            let size = thousandths.abs();
            format!("{sign}{}.{:03}", size / 1_000, size % 1_000)
        };
        let Self { code, start, end, rise, radius, backward, .. } = self;
        let mut words = format!("G{code} C{}", number(end.1));
        if code < 104 {
            words += &format!(" X{}", number(end.0));
        } else {
            words += &format!(" Z{}", number(rise));
        }
        if code != 101 {
            words += &format!(" L{}", number(radius));
        }
        let (x, c) = (number(start.0), number(start.1));
        let turns = if backward { 16 } else { 15 };
        let text = format!("M110\nM{turns} G94 G00 X{x} Z0 C{c} F100\n{words}\nM02\n");
        Case { setup, program: text.into_bytes() }
    }
}

/// Of a contour that is composed from the bytes:
///
/// 1. **Radius.** The ends of an arc are as far from its centre as L says, to within 3 nm of latching.
/// 2. **Mirror.** The image at the direction C0, with the other sense and the other direction of C, does the same with other
///    signs of `py`, `pcy`, `pu`, `pcu` and `c_travel`, to the nanometre; only a turn by 180 degrees at the centre stays
///    positive. From inside the side shows the other sense.
/// 3. **Increment.** A thousandth of a degree more in C of the target is just as much more in the travel of C, unless a
///    threshold lies between: a ray through an end, half a turn, the present C, the centre of the face, or a radius that is too small.
pub(crate) fn pairs_agree(bytes: &mut Unstructured<'_>) -> Verdict {
    let Ok(contour) = Contour::arbitrary(bytes) else { return Ok(()) };
    let shown = |message: String| format!("{message}\n{contour:?}");
    let events = trace(&contour.case());
    follow(&events).and_then(|()| radius(&events, contour.radius * 1_000)).map_err(shown)?;
    mirror(&events, &trace(&contour.mirrored().case())).map_err(shown)?;
    if contour.code > 103 {
        let seen = trace(&contour.seen_inside().case());
        require(arcs(&events) == arcs(&seen), || "another arc from inside".to_owned()).map_err(shown)?;
    }
    let end = (contour.end.0, (contour.end.1 + 1) % 360_000);
    increment(&events, &trace(&Contour { end, ..contour }.case())).map_err(shown)
}

/// Statement 1.
fn radius(events: &[Event], radius: i64) -> Verdict {
    for event in events {
        let Action::ContourArc { motion, plane, .. } = event.action else { continue };
        let distance = match (plane, motion.face) {
            (ContourPlane::FaceCentre(centre), Some(end)) => {
                let at = |x: i64, y: i64| Spot { p: x as f64, q: y as f64 };
                at(centre.x.0, centre.y.0).distance(at(end.x.0, end.y.0))
            }
            (ContourPlane::SideArc(side), _) => {
                let (u, z) = (side.travel.0 - side.centre.0, motion.program.z.0 - side.centre_z.0);
                (u as f64).hypot(z as f64)
            }
            _ => return Err("an arc without points".to_owned()),
        };
        require((distance - radius as f64).abs() < LATCHED, || {
            format!("{distance} from its centre, L {radius}")
        })?;
    }
    Ok(())
}

/// The signed amounts of the motions of a contour: points, centres, travels.
fn amounts(events: &[Event], sign: i64) -> Vec<[i64; 6]> {
    let amounts = |event: &Event| match event.action {
        Action::Linear { motion, path, .. } => {
            let face = motion.face?;
            let travel = motion.c_travel?.0;
            let kept = motion.part == Some(Part::Turn) && travel.abs() == 180_000_000;
            let travel = if kept { travel } else { sign * travel };
            Some([face.x.0, sign * face.y.0, travel, path.0, 0, motion.program.x.0])
        }
        Action::ContourArc { motion, plane, .. } => {
            let travel = sign * motion.c_travel?.0;
            Some(match plane {
                ContourPlane::FaceCentre(centre) => {
                    let face = motion.face?;
                    [face.x.0, sign * face.y.0, travel, centre.x.0, sign * centre.y.0, motion.program.x.0]
                }
                ContourPlane::SideArc(side) => {
                    let u = [sign * side.travel.0, sign * side.centre.0];
                    [u[0], u[1], travel, side.centre_z.0, motion.program.z.0, motion.program.x.0]
                }
            })
        }
        _ => None,
    };
    events.iter().filter_map(amounts).collect()
}

fn alarm(events: &[Event]) -> Option<(AlarmName, turnspec_oracle::vocabulary::Label)> {
    match events.last()?.action {
        Action::Alarm(alarm) => Some((alarm.name, alarm.detail)),
        _ => None,
    }
}

/// Statement 2.
fn mirror(events: &[Event], image: &[Event]) -> Verdict {
    require(alarm(events) == alarm(image), || format!("{:?} and {:?}", alarm(events), alarm(image)))?;
    let (these, those) = (amounts(events, 1), amounts(image, -1));
    require(these == those, || format!("{these:?} and in the mirror {those:?}"))
}

/// The planes and travels of the arcs.
fn arcs(events: &[Event]) -> Vec<(ContourPlane, Option<i64>)> {
    let arc = |event: &Event| match event.action {
        Action::ContourArc { motion, plane, .. } => Some((plane, motion.c_travel.map(|travel| travel.0))),
        _ => None,
    };
    events.iter().filter_map(arc).collect()
}

/// Statement 3.
fn increment(events: &[Event], more: &[Event]) -> Verdict {
    let travels =
        |events: &[Event]| -> Vec<i64> { amounts(events, 1).iter().map(|amount| amount[2]).collect() };
    let (these, those) = (travels(events), travels(more));
    let ([one], [other]) = (these.as_slice(), those.as_slice()) else { return Ok(()) };
    let near =
        |angle: i64| angle.rem_euclid(180_000_000) <= 1_000 || angle.rem_euclid(180_000_000) >= 179_999_000;
    let threshold = near(*one) || near(*other) || close_to_centre(events) || close_to_centre(more);
    require(threshold || other - one == 1_000, || format!("C travels by {one} and by {other}"))
}

/// Whether an arc passes the centre of the face within 0.02 mm: an increment may take it to the other side.
fn close_to_centre(events: &[Event]) -> bool {
    events.iter().any(|event| match event.action {
        Action::ContourArc { plane: ContourPlane::FaceCentre(centre), motion, .. } => {
            let at = |x: i64, y: i64| Spot { p: x as f64, q: y as f64 };
            let centre = at(centre.x.0, centre.y.0);
            let radius = motion.face.map_or(0.0, |end| centre.distance(at(end.x.0, end.y.0)));
            (centre.radius() - radius).abs() < 200_000.0
        }
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::{Contour, increment, mirror, radius};
    use crate::shape::trace;

    const ARC: Contour = Contour {
        code: 103,
        start: (120_000, 0),
        end: (80_000, 80_000),
        rise: 0,
        radius: 50_000,
        backward: false,
        inner: false,
    };

    #[test]
    fn another_radius_is_refused() {
        assert_eq!(radius(&trace(&ARC.case()), 50_000_000), Ok(()));
        assert!(radius(&trace(&ARC.case()), 50_001_000).is_err());
    }

    #[test]
    fn another_image_is_refused() {
        let events = trace(&ARC.case());
        assert_eq!(mirror(&events, &trace(&ARC.mirrored().case())), Ok(()));
        assert!(mirror(&events, &events).is_err());
        let other_sense = Contour { code: 103, ..ARC.mirrored() };
        assert!(mirror(&events, &trace(&other_sense.case())).is_err());
    }

    #[test]
    fn another_increment_is_refused() {
        let more = |by: i64| trace(&Contour { end: (80_000, 80_000 + by), ..ARC }.case());
        assert_eq!(increment(&trace(&ARC.case()), &more(1)), Ok(()));
        assert!(increment(&trace(&ARC.case()), &more(2)).is_err());
    }
}

//! What a drawing shows, read from a trace: where contour, tip and nose centre go.

use turnspec_oracle::vocabulary::{Action, Event, Label, Motion};

use crate::geometry::{Arc, Point, Way};

/// The motions of a trace.
pub struct Scene {
    pub steps: Vec<Step>,
}

/// One motion.
pub struct Step {
    /// Sequence name of its block.
    pub block: Label,
    pub from: Stand,
    pub to: Stand,
    pub arc: Option<Arc>,
    /// +1 with the tool on the left (G41), −1 on the right (G42).
    pub side: f64,
}

/// Where everything is between two motions.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stand {
    pub programmed: Point,
    pub tip: Point,
    pub nose: Point,
    /// Whether compensation is in force.
    pub compensated: bool,
}

impl Stand {
    /// The nose radius: the larger amount from the tip to the nose centre.
    pub fn radius(&self) -> f64 {
        let v = self.nose - self.tip;
        v.z.abs().max(v.x.abs())
    }
}

impl Step {
    /// Whether both ends are in compensation: neither start-up nor cancel, nor without compensation.
    pub fn compensated(&self) -> bool {
        self.from.compensated && self.to.compensated
    }

    pub fn contour(&self) -> Way {
        Way { from: self.from.programmed, to: self.to.programmed, arc: self.arc }
    }

    pub fn centre_way(&self) -> Way {
        Way { from: self.from.nose, to: self.to.nose, arc: self.arc }
    }

    /// The way of the tip: round a centre that is displaced as the tip is at the end.
    pub fn tip_way(&self) -> Way {
        let v = self.to.nose - self.to.tip;
        let arc = self.arc.map(|arc| Arc { centre: arc.centre - v, ..arc });
        Way { from: self.from.tip, to: self.to.tip, arc }
    }
}

impl Scene {
    /// The scene of a trace. Where the machine stands before its first motion is left out: that motion has no
    /// length.
    ///
    /// # Errors
    /// When program and machine coordinates differ, or nothing moves in compensation.
    pub fn of(trace: &[Event]) -> Result<Self, String> {
        let v = trace.iter().find_map(|event| displacement(motion(event)?.0));
        let mut v = v.ok_or("nothing moves in compensation, so there is nothing to draw")?;
        let mut side = 0.0;
        let mut steps: Vec<Step> = Vec::new();
        for event in trace {
            if let Action::Mode { code, .. } = event.action {
                match code.as_str() {
                    "G41" => side = 1.0,
                    "G42" => side = -1.0,
                    _ => {}
                }
            }
            let Some((motion, arc)) = motion(event) else { continue };
            v = displacement(motion).unwrap_or(v);
            let to = stand(motion, v)?;
            let from = steps.last().map_or(to, |step| step.to);
            steps.push(Step { block: event.block.sequence, from, to, arc, side });
        }
        Ok(Self { steps })
    }
}

fn stand(motion: &Motion, v: Point) -> Result<Stand, String> {
    let programmed = Point::of(motion.program.z, motion.program.x);
    let tip = motion.tip.map_or(programmed, |tip| Point::of(tip.z, tip.x));
    if tip != Point::of(motion.machine.z, motion.machine.x) {
        return Err("program and machine coordinates differ, such an example is not drawn".to_owned());
    }
    Ok(Stand { programmed, tip, nose: tip + v, compensated: motion.nose.is_some() })
}

/// From the tip to the nose centre.
fn displacement(motion: &Motion) -> Option<Point> {
    let (tip, nose) = (motion.tip?, motion.nose?);
    Some(Point::of(nose.z, nose.x) - Point::of(tip.z, tip.x))
}

fn motion(event: &Event) -> Option<(&Motion, Option<Arc>)> {
    match &event.action {
        Action::Rapid { motion } | Action::Linear { motion, .. } => Some((motion, None)),
        Action::Arc { motion, sense, centre_x, centre_z, .. } => {
            Some((motion, Some(Arc::of(*centre_z, *centre_x, *sense))))
        }
        _ => None,
    }
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use turnspec_oracle::vocabulary::{Event, Setup};

    use super::{Point, Scene};

    fn scene(program: &str, setup: &str) -> Result<Scene, String> {
        let setup = Setup::from_toml(setup).unwrap_or_else(|error| panic!("{error}"));
        let mut trace = Vec::new();
        turnspec_oracle::run(program.as_bytes(), &setup, &mut |event: &Event| trace.push(*event));
        Scene::of(&trace)
    }

    const NOSE: &str = "[[nose_radius]]\nnumber = 1\nx = 0.8\nz = 0.8\n";

    #[test]
    fn a_step_knows_its_side_and_whether_it_is_compensated() {
        let program = "N1 G00 X100 Z100 T010101\nN2 G42 X80\nN3 G01 Z50 F0.2\nN4 G40 X90\nM02\n";
        let scene = scene(program, NOSE).unwrap_or_else(|fault| panic!("{fault}"));
        let compensated: Vec<bool> = scene.steps.iter().map(|step| step.compensated()).collect();
        assert_eq!(compensated, [false, false, true, false]);
        let [_, start_up, cut, cancel] = scene.steps.as_slice() else { panic!("four steps") };
        assert_eq!(
            (start_up.to.tip, start_up.to.programmed),
            (Point::new(99.2, 40.0), Point::new(100.0, 40.0))
        );
        assert_eq!((cut.side, cut.block.as_str()), (-1.0, "N3"));
        assert!((cut.to.radius() - 0.8).abs() < 1e-9);
        assert_eq!(cancel.to.tip, cancel.to.programmed);
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        assert!(scene("G01 X10 F0.2\nM02\n", NOSE).is_err());
        let shifted = format!("{NOSE}[zero_offset]\nx = 1\n");
        assert!(scene("G42 G01 X10 F0.2 T010101\nZ10\nM02\n", &shifted).is_err());
    }
}

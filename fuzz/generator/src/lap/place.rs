//! Where a contour lies on the machine, and the AP starts from which it is cut.

use crate::builder::Builder;
use crate::state::Axis;

use super::plan::{Kind, Plan};

const MM: i64 = 1_000_000;

/// The place of a contour: the origin of its plane and the senses of height and run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub infeed: Axis,
    /// Program coordinates of the start of the contour, on the infeed axis and on the cutting axis.
    origin: [i64; 2],
    /// σ and γ.
    pub senses: [i64; 2],
    /// Height and run of the AP start.
    pub start: [i64; 2],
}

impl Place {
    /// A place within the limits, with what the cycles need around the contour.
    pub fn find(builder: &mut Builder<'_, '_, '_>, plan: &Plan) -> Option<Self> {
        let (infeed, cutting) = if plan.across { (Axis::Z, Axis::X) } else { (Axis::X, Axis::Z) };
        let sigma = if builder.choices.chance(75) { 1 } else { -1 };
        let gamma = if builder.choices.chance(75) { -1 } else { 1 };
        let (low, high) = plan.extent(0);
        let (back, far) = plan.extent(1);
        let start = Self::start(builder, plan, high);
        let parameters = &builder.state.setup.parameters;
        let relief = i64::from(parameters.lap_relief) * 1_000;
        let clearance = i64::from(parameters.lap_clearance) * 1_000;
        let above = high.max(start[0]) + 2 * relief + 3 * MM;
        let before = -(start[1].min(back - clearance - 2 * relief) - 3 * MM);
        let boxes =
            [(low - 3 * MM, above + 22 * MM * i64::from(plan.nose.is_some())), (-before, far + 3 * MM)];
        let mut origin = [0; 2];
        for (place, (axis, sense)) in [(infeed, sigma), (cutting, gamma)].into_iter().enumerate() {
            let (low, high) = boxes[place];
            let (low, high) = if sense > 0 { (low, high) } else { (-high, -low) };
            let (least, most) = builder.state.window(axis);
            let (least, most) = (least - low, most - high);
            if least > most {
                return None;
            }
            let grid = builder.choices.pick(&[MM, MM, 1_000]);
            let wanted = builder.choices.within(least / grid, most / grid) * grid;
            origin[place] = builder.on_grid(wanted.clamp(least, most));
        }
        Some(Self { infeed, origin, senses: [sigma, gamma], start })
    }

    /// Height and run of an AP start.
    fn start(builder: &mut Builder<'_, '_, '_>, plan: &Plan, high: i64) -> [i64; 2] {
        let finest = builder.state.units.finest();
        let grid = builder.choices.pick(&[MM, MM, 1_000]);
        let least = if plan.kind == Kind::Thread { 4 * MM } else { 0 };
        let above = least + builder.choices.within(0, 6 * MM / grid) * grid;
        let blank = if plan.blank.is_some() { 2 * MM } else { 0 };
        let mut height = high.max(0) + blank + above;
        if plan.blank.is_none() && plan.kind == Kind::Turning && builder.choices.chance(12) {
            height = high / 2 + MM;
        }
        let away = match builder.choices.below(6) {
            0 => 0,
            1 => builder.choices.within(10, 40) * MM,
            _ => builder.choices.within(0, 6 * MM / grid) * grid,
        };
        [height.max(2 * MM) / finest * finest, -away / finest * finest]
    }

    /// Program coordinates of a height and a run, on X and on Z.
    pub fn point(&self, [height, run]: [i64; 2]) -> [i64; 2] {
        let infeed = self.origin[0] + self.senses[0] * height;
        let cutting = self.origin[1] + self.senses[1] * run;
        if self.infeed == Axis::X { [infeed, cutting] } else { [cutting, infeed] }
    }

    /// The program coordinate of a height.
    pub fn level(&self, height: i64) -> i64 {
        self.origin[0] + self.senses[0] * height
    }

    /// Whether an arc that is seen clockwise is G02.
    pub fn keeps_sense(&self) -> bool {
        (self.senses[0] == self.senses[1]) == (self.infeed == Axis::X)
    }
}

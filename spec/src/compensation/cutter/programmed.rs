//! P in the plane of the cutter: where it is, and where a block leads it (E100L-CRC-14).

use super::plane::Standing;
use crate::contour::{Cylinder, PlanePoint, axes_of_point, point_of};
use crate::fault::Outcome;
use crate::frame::Amounts;
use crate::integer::turn;
use crate::modal::{CutterPlane, Plan};
use crate::path::{Origin, line_end, origin};
use crate::state::State;

/// P since compensation began.
#[derive(Clone, Copy, Debug)]
pub struct Programmed {
    /// The plane.
    pub plane: CutterPlane,
    /// Machine less program coordinates when it began.
    total: Amounts,
    /// Where program C stood when it began, in micro-degrees.
    began: i64,
    /// Γ: the programmed travels of C since.
    turned: i64,
    /// P as a point of the plane; none in conversion mode, before a point is programmed.
    pub point: Option<PlanePoint>,
}

/// Where a block leads.
#[derive(Clone, Copy, Debug)]
pub struct Destination {
    /// Program X.
    pub x: i64,
    /// Program C.
    pub c: i64,
    /// The travel of C, on the side that of the program.
    pub travel: i64,
    /// As a point of the plane; none if the start that it needs is not known.
    pub point: Option<PlanePoint>,
}

impl Programmed {
    /// Compensation begins, with P at the present point.
    pub fn begin(plane: CutterPlane, plan: &Plan, state: &State) -> Self {
        let present = state.frame.program();
        let point = match plane {
            CutterPlane::Face if plan.converts => state.contour.point(&state.frame),
            CutterPlane::Face => Some(PlanePoint::at(present.x, present.c)),
            CutterPlane::Side => Some(Cylinder::present(state).point(0, present.z)),
        };
        Self { plane, total: state.frame.total(), began: present.c, turned: 0, point }
    }

    /// Whether the frame of X, Z and C is what it was when compensation began.
    pub fn has_frame(&self, state: &State) -> bool {
        let of = |total: Amounts| (total.x, total.z, total.c);
        of(self.total) == of(state.frame.total())
    }

    /// C of P, turns counted since compensation began.
    pub fn unwrapped(&self) -> i64 {
        self.began.saturating_add(self.turned)
    }

    /// The axes in P. (Where P is no point of the plane yet nothing asks for it.)
    pub fn standing(&self, state: &State) -> Standing {
        let point = self.point.unwrap_or_default();
        Standing { point, unwrapped: self.unwrapped(), machine: state.frame.machine }
    }

    /// Where a block with a motion leads.
    pub fn destination(&self, plan: &Plan, state: &State) -> Outcome<Destination> {
        let present = state.frame.program();
        if plan.converts {
            let point = point_of(plan, state.contour.point(&state.frame));
            let (x, c) = point.map_or((present.x, present.c), |point| axes_of_point(point, state));
            return Ok(Destination { x, c, travel: 0, point });
        }
        let from = if plan.is_contour() { Origin::present(state) } else { origin(plan, state).0 };
        let (x, z) = line_end(plan, from, None, &[])?.point;
        let c = match plan.words.get('C') {
            None => present.c,
            Some(word) if plan.modes.incremental() => present.c + word,
            Some(word) => word,
        };
        let travel = turn::travel(present.c, c, 0, state.is_active(15));
        let c = turn::within(c);
        let point = match self.plane {
            CutterPlane::Face => PlanePoint::at(x, c),
            CutterPlane::Side => Cylinder::present(state).point(self.turned.saturating_add(travel), z),
        };
        Ok(Destination { x, c, travel, point: Some(point) })
    }

    /// P goes there.
    pub fn go(&mut self, destination: &Destination) {
        self.turned = self.turned.saturating_add(destination.travel);
        self.point = destination.point;
    }
}

//! Blocks that lead to a point by X and Y: G00, G101, G102, G103 in conversion mode.

use super::plane::Spot;
use crate::builder::Builder;
use crate::state::{Axis, Mode};

/// What a block does.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Course {
    /// Positioning by X and Y.
    Both,
    /// Positioning by one of them or both.
    Rapid,
    /// G101.
    Line,
    /// G102 or G103.
    Arc,
}

impl Builder<'_, '_, '_> {
    /// A block that leads to a point; false where the control would refuse it.
    pub(super) fn point_block(&mut self, course: Course) -> bool {
        let mut items = Vec::new();
        self.beside_contour(!self.state.contours.given || course != Course::Both, &mut items);
        let counter = self.choices.chance(50);
        let mode = match course {
            Course::Both | Course::Rapid => Mode::Rapid,
            Course::Line => Mode::FaceLine,
            Course::Arc if counter => Mode::FaceCounter,
            Course::Arc => Mode::FaceClockwise,
        };
        self.select(mode, &mut items);
        let kept = self.state.kept_point();
        if self.state.contours.given
            && course != Course::Both
            && !crate::companions::has(&items, "G")
            && self.choices.chance(25)
        {
            let change = !self.state.incremental;
            items.push(self.incremental_word(change));
        }
        let start = match kept {
            Some(point) => point,
            None if course == Course::Both && !self.state.incremental => [0, 0],
            None => return false,
        };
        let wanted = self.wanted_point(start, course);
        let both = [course == Course::Both; 2];
        let chosen = match both {
            [true, true] => both,
            _ => [0, 1].map(|place| wanted[place] != start[place] || self.choices.chance(25)),
        };
        let (words, point) = self.point_words(wanted, start, chosen);
        items.extend(words);
        let (x, _) = self.axes_of_point(point);
        if !self.bears_point(start, point, x, course) {
            return false;
        }
        let along = matches!(course, Course::Both | Course::Rapid)
            || course == Course::Line && self.keeps_c(start, point);
        if along && self.choices.chance(20) {
            self.axis_word(Axis::Z, &mut items);
        }
        if course == Course::Arc {
            let (one, other) = (Spot::of(start), Spot::of(point));
            let exact = [0, 1].into_iter().find(|axis| point[*axis] == start[*axis]);
            let exact = exact.map(|axis| (point[1 - axis] - start[1 - axis]).abs());
            let Some(word) = self.radius_of_arc(one, other, exact, counter) else { return false };
            items.push(word);
        }
        if chosen == [false, false] {
            let from = self.present();
            self.travelled(from, self.present(), None);
        } else {
            self.move_to_point(point);
        }
        if mode == Mode::Rapid {
            self.state.after_cutting = false;
            self.push(items);
        } else {
            self.cut_contour(items);
        }
        true
    }

    /// Whether Z may move along: C does not turn alone.
    fn keeps_c(&self, start: [i64; 2], end: [i64; 2]) -> bool {
        start != [0, 0] && end != [0, 0] && cross(start, end) != 0
    }

    /// Whether limits and centre allow a point.
    fn bears_point(&mut self, start: [i64; 2], end: [i64; 2], x: i64, course: Course) -> bool {
        let centre = start == [0, 0] || end == [0, 0];
        let opposite = !centre && cross(start, end) == 0;
        match course {
            // X is cut back at a positive limit; then the point is lost.
            Course::Both | Course::Rapid => {
                self.state.fits(Axis::X, x)
                    || x > 0 && self.choices.chance(10) && {
                        let limit = self.state.limits[Axis::X as usize];
                        limit.positive.is_some() && limit.negative.is_none()
                    }
            }
            Course::Line => {
                let passes = centre || opposite;
                self.state.fits(Axis::X, x) && (!passes || self.state.fits(Axis::X, 0))
            }
            Course::Arc => !centre && self.state.fits(Axis::X, x),
        }
    }

    /// A point where a block may lead: anywhere, on the line through the centre, at the centre, beside the present one.
    fn wanted_point(&mut self, start: [i64; 2], course: Course) -> [i64; 2] {
        let anywhere = self.some_point();
        if course == Course::Both || start == [0, 0] {
            return if self.choices.chance(4) { [0, 0] } else { anywhere };
        }
        let line = course == Course::Line;
        match self.choices.below(12) {
            0 | 1 if line => start.map(|coordinate| -coordinate),
            2 if line => start.map(|coordinate| coordinate * 2),
            3 if line => start.map(|coordinate| -2 * coordinate),
            4 if course != Course::Arc => [0, 0],
            // Round the centre, or past it.
            5 | 6 => start.map(|coordinate| {
                let beside = self.choices.within(-3_000, 3_000) * 1_000;
                self.on_grid(beside - coordinate)
            }),
            7 | 8 => [anywhere[0], start[1]],
            9 => [start[0], anywhere[1]],
            10 if course == Course::Rapid => start,
            _ => anywhere,
        }
    }
}

/// On which side of the line from the centre to one point the other lies.
fn cross(one: [i64; 2], other: [i64; 2]) -> i128 {
    i128::from(one[0]) * i128::from(other[1]) - i128::from(one[1]) * i128::from(other[0])
}

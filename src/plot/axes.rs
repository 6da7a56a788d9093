//! The axes of a sheet: ticks at round numbers, and the centre line of the spindle.

use maud::{Markup, html};

use turnspec_conformance::geometry::{self, Point};

use super::view::{View, WIDTH, number};

/// The least distance between two ticks in pixels.
const APART: f64 = 72.0;

/// Ticks of Z below and of X, as a diameter, at the left; the grid; the centre line.
pub fn axes(view: &View) -> Markup {
    let height = view.height();
    let place = |z, x| view.place(Point::new(z, x));
    html! {
        g.grid {
            @for z in ticks(view.low.z, view.high.z, APART / view.scale) {
                @let (right, _) = place(z, 0.0);
                path d={ "M" (number(right)) " 0V" (number(height)) } {}
                text x=(number(right)) y=(number(height + 16.0)) { (label(z)) }
            }
            @for diameter in ticks(2.0 * view.low.x, 2.0 * view.high.x, APART / view.scale) {
                @let (_, down) = place(0.0, diameter / 2.0);
                path d={ "M0 " (number(down)) "H" (number(WIDTH)) } {}
                text.end x="-8" y=(number(down)) dy=".35em" { (label(diameter)) }
            }
        }
        @let (_, centre) = place(0.0, 0.0);
        @if (0.0..=height).contains(&centre) {
            path.axis d={ "M0 " (number(centre)) "H" (number(WIDTH)) } {}
        }
        path.frame d={ "M0 0V" (number(height)) "H" (number(WIDTH)) } {}
        text.name x=(number(WIDTH)) y=(number(height + 32.0)) { "Z in mm" }
        text.name.left x="-52" y="-12" { "X in mm, diameter" }
    }
}

/// Round numbers between two, at least `apart` from each other.
fn ticks(low: f64, high: f64, apart: f64) -> Vec<f64> {
    let power = 10_f64.powf(apart.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|factor| factor * power).find(|step| *step >= apart);
    let step = step.unwrap_or(10.0 * power);
    let (first, last) = ((low / step).ceil(), (high / step).floor());
    // A sheet is a thousand pixels wide.
    (0..64)
        .map(|count| first + f64::from(count))
        .take_while(|each| *each <= last)
        .map(|each| each * step)
        .collect()
}

fn label(value: f64) -> String {
    // The sign of a number is as wide as a digit.
    geometry::number(value, 6).replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::{label, ticks};

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(-7.0, 12.0, 4.0), [-5.0, 0.0, 5.0, 10.0]);
        assert_eq!(ticks(0.0, 0.05, 0.015), [0.0, 0.02, 0.04]);
        assert!(ticks(3.0, 4.0, 5.0).is_empty());
    }

    #[test]
    fn labels_are_short() {
        for (value, text) in [(-0.02, "\u{2212}0.02"), (0.0, "0"), (500.0, "500")] {
            assert_eq!(label(value), text);
        }
    }
}

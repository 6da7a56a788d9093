//! The legend of a sheet: what its lines and marks mean.

use maud::{Markup, html};

use super::path::{Kind, Plan};
use super::sheet::HUES;
use super::view::number;

/// Entries of a row, and how far apart they are in pixels, and rows.
const ROW: usize = 7;
const APART: (f64, f64) = (134.0, 26.0);

/// Samples and their names.
pub struct Legend(Vec<(Markup, &'static str)>);

impl Legend {
    /// What there is on the sheet of a plan.
    pub fn of(plan: &Plan) -> Self {
        let has =
            |kind: Kind| plan.segments.iter().any(|segment| segment.kind == kind && segment.pass.is_none());
        let contour = plan.segments.iter().any(|segment| segment.programmed.is_some())
            || plan.definitions.iter().any(|definition| !definition.contour.is_empty());
        let blank = plan.definitions.iter().any(|definition| !definition.blank.is_empty());
        let passes = plan.segments.iter().any(|segment| segment.pass.is_some());
        let kinds = Kind::ALL.map(|kind| (has(kind), line(kind.name()), kind.name()));
        let marks = [
            (contour, line("contour"), "programmed"),
            (blank, line("blank"), "blank"),
            (passes, hues(), "passes"),
            (
                !plan.barriers.is_empty(),
                html! { g.barriers { rect.barrier width="28" height="12" y="-6" {} } },
                "barrier",
            ),
            (!plan.segments.is_empty(), html! { circle.start r="4" cx="14" {} }, "start"),
            (!plan.segments.is_empty(), html! { circle.finish r="4" cx="14" {} }, "end"),
            (plan.alarm.is_some(), html! { path.alarm d="M8 -6l12 12m0 -12l-12 12" {} }, "alarm"),
        ];
        let entries = kinds.into_iter().chain(marks).filter(|entry| entry.0);
        Self(entries.map(|(_, sample, name)| (sample, name)).collect())
    }

    /// Pixels that rows after the first one need.
    pub fn more_rows(&self) -> f64 {
        self.0.len().saturating_sub(1).div_euclid(ROW) as f64 * APART.1
    }

    /// The legend, its first row this far down.
    pub fn at(&self, y: f64) -> Markup {
        html! {
            g.legend {
                @for (place, (sample, name)) in self.0.iter().enumerate() {
                    @let (right, down) = ((place % ROW) as f64 * APART.0, y + (place / ROW) as f64 * APART.1);
                    g transform={ "translate(" (number(right)) " " (number(down)) ")" } {
                        (sample)
                        text x="36" dy=".35em" { (name) }
                    }
                }
            }
        }
    }
}

fn line(class: &str) -> Markup {
    html! { path class=(class) d="M0 0h28" {} }
}

/// A sample of the colours that passes take in turn.
fn hues() -> Markup {
    html! {
        g {
            @for hue in 0..HUES {
                path class=(format!("pass p{hue}")) d=(format!("M{} 0h5", 5 * hue)) {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Legend, Plan};
    use turnspec_oracle::vocabulary::{Event, Setup};

    /// Eight entries take two rows.
    #[test]
    fn a_long_legend_has_rows() {
        let legend = |program: &[u8]| {
            let mut plan = Plan::new(&Setup::default());
            turnspec_oracle::run(program, &Setup::default(), &mut |event: &Event| plan.event(event));
            Legend::of(&plan)
        };
        assert_eq!(legend(b"G00 X20 Z5\nM02\n").more_rows(), 0.0);
        let long = legend(b"G00 X60 Z10\nG01 X58 F0.2\nG02 X60 Z9 I1\nM03 S100\nG33 X50 Z-20 F2\n");
        let names: Vec<&str> = long.0.iter().map(|entry| entry.1).collect();
        assert_eq!(names, ["rapid", "linear", "arc", "passes", "start", "end", "alarm"]);
        assert_eq!(long.more_rows(), 0.0);
        let mut longer = long;
        longer.0.push((super::line("blank"), "blank"));
        assert!(longer.more_rows() > 0.0 && longer.at(0.0).into_string().contains("translate(0 26)"));
    }
}

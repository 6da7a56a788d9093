//! The sheet: a plan as SVG text, with a look for light surroundings, one for dark ones and one for paper.

use maud::{Markup, PreEscaped, html};

use turnspec_conformance::geometry::{Point, Way};
use turnspec_conformance::page::permitted;

use super::axes::axes;
use super::legend::Legend;
use super::path::{Plan, Segment};
use super::view::{Extent, View, WIDTH, number};

/// The look of a sheet.
const STYLE: &str = include_str!("style.css");
/// How many colours the passes of a cycle take in turn.
pub const HUES: u32 = 6;
/// Room for titles and numbers beside the plot in pixels: left, above, right, below.
const MARGIN: [f64; 4] = [76.0, 56.0, 24.0, 84.0];

/// The drawing of a plan under a title. Characters of the title that XML forbids are replaced.
#[must_use]
pub fn svg(title: &str, plan: &Plan, extent: Extent) -> String {
    let text = html! { (sheet(title, plan, extent, true)) "\n" };
    permitted(&text.into_string())
}

/// The drawing; in a page the look is that of the page.
pub fn sheet(title: &str, plan: &Plan, extent: Extent, alone: bool) -> Markup {
    let view = View::of(plan, extent);
    let [left, above, right, below] = MARGIN;
    let legend = Legend::of(plan);
    let (width, height) = (WIDTH + left + right, view.height() + above + below + legend.more_rows());
    html! {
        svg xmlns="http://www.w3.org/2000/svg" width=(number(width)) height=(number(height))
            viewBox={ "0 0 " (number(width)) " " (number(height)) } role="img" aria-label=(title) {
            @if alone {
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            clipPath id="plot" { rect width=(number(WIDTH)) height=(number(view.height())) {} }
            rect.back width="100%" height="100%" {}
            text.title x=(number(left - 52.0)) y="24" { (title) }
            g transform={ "translate(" (number(left)) " " (number(above)) ")" } {
                (axes(&view))
                g clip-path="url(#plot)" { (plot(&view, plan)) }
                (legend.at(view.height() + 56.0))
            }
        }
    }
}

fn plot(view: &View, plan: &Plan) -> Markup {
    html! {
        g.barriers {
        @for (one, other) in &plan.barriers {
            @let ((right, down), (width, height)) = rectangle(view, *one, *other);
            rect.barrier x=(number(right)) y=(number(down)) width=(number(width)) height=(number(height)) {}
        }
        }
        @for definition in &plan.definitions {
            path.blank d=(chain(view, &definition.blank)) {}
            path.contour d=(chain(view, &definition.contour)) {}
        }
        @for segment in &plan.segments {
            @if let Some(way) = &segment.programmed { path.contour d=(view.data(way)) {} }
        }
        @for segment in &plan.segments { (motion(view, segment)) }
        @if let Some(first) = plan.segments.first() { (dot(view, "start", first.way.from)) }
        @if let Some(last) = plan.segments.last() { (dot(view, "finish", last.way.to)) }
        @if let Some(at) = plan.alarm {
            @let (right, down) = view.place(at);
            path.alarm d={ "M" (number(right - 6.0)) " " (number(down - 6.0)) "l12 12m0 -12l-12 12" } {}
        }
    }
}

/// Path data of ways, each of which begins where the one before ends.
fn chain(view: &View, ways: &[Way]) -> String {
    ways.iter().map(|way| view.data(way)).collect()
}

/// A motion, with the number of its event.
fn motion(view: &View, segment: &Segment) -> Markup {
    let class = match segment.pass {
        Some(pass) => format!("{} pass p{}", segment.kind.name(), pass.saturating_sub(1) % HUES),
        None => segment.kind.name().to_owned(),
    };
    html! { path class=(class) data-n=(segment.n) d=(view.data(&segment.way)) {} }
}

fn dot(view: &View, class: &str, point: Point) -> Markup {
    let (right, down) = view.place(point);
    html! { circle class=(class) cx=(number(right)) cy=(number(down)) r="4" {} }
}

/// Upper left corner and size of a rectangle in pixels.
fn rectangle(view: &View, one: Point, other: Point) -> ((f64, f64), (f64, f64)) {
    let (first, second) = (view.place(one), view.place(other));
    let corner = (first.0.min(second.0), first.1.min(second.1));
    (corner, ((first.0 - second.0).abs(), (first.1 - second.1).abs()))
}

#[cfg(test)]
mod tests {
    use super::{Extent, Plan, svg};
    use turnspec_oracle::vocabulary::{Event, Setup};

    #[test]
    fn what_there_is_is_in_drawing_and_legend() {
        let mut plan = Plan::new(&Setup::default());
        turnspec_oracle::run(b"G00 X20 Z5\nG01 Z-10 F0.2\nG05\n", &Setup::default(), &mut |event: &Event| {
            plan.event(event);
        });
        let text = svg("a < b\u{1}", &plan, Extent::All);
        for part in
            ["a &lt; b\u{FFFD}<", "class=\"rapid\" data-n=\"1\"", "class=\"linear\"", ">alarm<", ">end<"]
        {
            assert!(text.contains(part), "{part}: {text}");
        }
        for part in [">passes<", "class=\"arc\"", ">barrier<", ">programmed<"] {
            assert!(!text.contains(part), "{part}");
        }
    }

    /// Two passes of a thread are told apart.
    #[test]
    fn passes_take_colours_in_turn() {
        let mut plan = Plan::new(&Setup::default());
        let program = b"G00 X60 Z10\nM03 S100\nG33 X50 Z-20 F2\nX49\nM02\n";
        turnspec_oracle::run(program, &Setup::default(), &mut |event: &Event| plan.event(event));
        let text = svg("t", &plan, Extent::All);
        for part in ["class=\"thread pass p0\"", "class=\"thread pass p1\"", ">passes<", ">rapid<"] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(!text.contains("pass p2\" data"), "{text}");
    }
}

//! The sheet: a scene as SVG text, with a look for light and one for dark surroundings.

use maud::{Markup, PreEscaped, html};

use super::scene::{Scene, Stand, Step};
use super::view::{HEIGHT, View, WIDTH, number};
use crate::geometry::{Point, Way};

/// Height of the strip below the plot, in pixels.
const STRIP: f64 = 34.0;
/// Length of the strokes that mark the side of the workpiece, in pixels.
const HATCH: f64 = 8.0;

const STYLE: &str = "svg{--back:#fff;--ink:#1c1f23;--faint:#b4bac2;--centre:#0a5fb4;--tip:#b4480f}\
@media(prefers-color-scheme:dark){svg{--back:#14171a;--ink:#e4e7eb;--faint:#59626c;--centre:#6cb6ff;--tip:#f2a65a}}\
*{fill:none;stroke-width:1.3}text{font:13px sans-serif;fill:var(--ink);text-anchor:middle;stroke:var(--back);\
stroke-width:4;paint-order:stroke}.back{fill:var(--back)}.contour{stroke:var(--ink);stroke-width:3}\
.thin{stroke:var(--ink)}.work{stroke:var(--faint);stroke-width:8;stroke-dasharray:1.2 5}\
.centre{stroke:var(--centre)}.tip{stroke:var(--tip)}.dash{stroke-dasharray:5 4}\
.dot{fill:var(--ink)}.mid{fill:var(--centre)}.start{text-anchor:start}text.centre{fill:var(--centre);stroke:var(--back)}";

/// The drawing of a scene round the points of some blocks.
///
/// # Errors
/// When there is nothing to show.
pub fn svg(caption: &str, scene: &Scene, blocks: &[&str]) -> Result<String, String> {
    let view = View::of(scene, blocks)?;
    let text = html! {
        svg xmlns="http://www.w3.org/2000/svg" width=(number(WIDTH)) height=(number(HEIGHT + STRIP))
            viewBox={ "0 0 " (number(WIDTH)) " " (number(HEIGHT + STRIP)) } {
            "\n" title { (caption) }
            "\n" style { (PreEscaped(STYLE)) }
            "\n" rect.back width="100%" height="100%" rx="6" {}
            "\n" svg width=(number(WIDTH)) height=(number(HEIGHT)) { "\n" (plot(&view, scene)) }
            "\n" (strip(&view))
            "\n"
        }
        "\n"
    };
    Ok(text.into_string())
}

fn plot(view: &View, scene: &Scene) -> Markup {
    let steps = |compensated: bool| scene.steps.iter().filter(move |step| step.compensated() == compensated);
    let stands = distinct_noses(view, scene);
    html! {
        (line("work", &view.path(scene.steps.iter().filter_map(|step| work_side(view, step)))))
        (line("contour", &view.path(steps(true).map(Step::contour))))
        (line("thin dash", &view.path(steps(false).map(Step::contour))))
        (line("centre", &view.path(steps(true).map(Step::centre_way))))
        (line("centre dash", &view.path(steps(false).map(Step::centre_way))))
        (line("tip", &view.path(steps(true).map(Step::tip_way))))
        (line("tip dash", &view.path(steps(false).map(Step::tip_way))))
        @for stand in &stands { (nose(view, stand)) }
        (labels(view, scene))
    }
}

/// A path with its class; nothing without data.
fn line(class: &str, data: &str) -> Markup {
    html! { @if !data.is_empty() { path class=(class) d=(data) {} "\n" } }
}

/// The band of strokes beside an element of the contour, on the side of the workpiece.
fn work_side(view: &View, step: &Step) -> Option<Way> {
    let away_from_tool = -step.side * HATCH / 2.0 / view.scale;
    step.compensated().then(|| step.contour().beside(away_from_tool)).flatten()
}

/// Where the nose stands between motions, each place once, as far as it can be seen.
fn distinct_noses(view: &View, scene: &Scene) -> Vec<Stand> {
    let mut stands: Vec<Stand> = Vec::new();
    for stand in scene.steps.iter().map(|step| step.to) {
        if view.shows(stand.nose) && !stands.iter().any(|other| other.nose == stand.nose) {
            stands.push(stand);
        }
    }
    stands
}

/// The nose circle, its centre, and the tip as the corner of two tangents.
fn nose(view: &View, stand: &Stand) -> Markup {
    let (z, x) = view.place(stand.nose);
    let v = stand.nose - stand.tip;
    let tangents =
        [(stand.tip + Point::new(v.z, 0.0), stand.tip), (stand.tip, stand.tip + Point::new(0.0, v.x))];
    let tangents = view.path(tangents.map(|(from, to)| Way { from, to, arc: None }));
    let dash = if stand.compensated { "" } else { " dash" };
    html! {
        circle class={ "centre" (dash) } cx=(number(z)) cy=(number(x)) r=(number(stand.radius() * view.scale)) {}
        circle.mid cx=(number(z)) cy=(number(x)) r="2" {}
        (line(&format!("tip{dash}"), &tangents))
    }
}

/// The names of the blocks at their programmed points, and at the nose centres where one point has several.
fn labels(view: &View, scene: &Scene) -> Markup {
    let mut points: Vec<Point> = Vec::new();
    for step in &scene.steps {
        let point = step.to.programmed;
        if view.shows(point) && !points.contains(&point) {
            points.push(point);
        }
    }
    html! {
        @for point in points { (point_labels(view, scene, point)) }
    }
}

fn point_labels(view: &View, scene: &Scene, point: Point) -> Markup {
    let steps: Vec<&Step> = scene.steps.iter().filter(|step| step.to.programmed == point).collect();
    let mut noses: Vec<Point> = Vec::new();
    for nose in steps.iter().map(|step| step.to.nose) {
        if !noses.contains(&nose) {
            noses.push(nose);
        }
    }
    let names = |wanted: &dyn Fn(&Step) -> bool| {
        let mut names: Vec<&str> = Vec::new();
        for step in steps.iter().filter(|step| wanted(step)) {
            if names.last() != Some(&step.block.as_str()) {
                names.push(step.block.as_str());
            }
        }
        names.join(" ")
    };
    let (z, x) = view.place(point);
    let middle = noses.iter().fold(Point::default(), |sum, nose| sum + *nose) * (1.0 / noses.len() as f64);
    html! {
        circle.dot cx=(number(z)) cy=(number(x)) r="3" {} "\n"
        (label("", view, point, point - middle, 20.0, &names(&|_| true)))
        @if noses.len() > 1 {
            @for nose in &noses {
                (label("centre", view, *nose, *nose - middle, 16.0, &names(&|step| step.to.nose == *nose)))
            }
        }
    }
}

/// A text some pixels from a point, in a direction of the plane.
fn label(class: &str, view: &View, point: Point, direction: Point, distance: f64, text: &str) -> Markup {
    let (z, x) = view.place(point);
    let direction = direction.unit().unwrap_or(Point::new(0.0, 1.0));
    let (z, x) = (number(z + direction.z * distance), number(x - direction.x * distance));
    html! {
        @if class.is_empty() { text x=(z) y=(x) dy=".35em" { (text) } }
        @else { text class=(class) x=(z) y=(x) dy=".35em" { (text) } }
        "\n"
    }
}

/// Axes, what the lines mean, and the scale.
fn strip(view: &View) -> Markup {
    let bar = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0].into_iter().rfind(|length| length * view.scale <= 80.0);
    let bar = bar.unwrap_or(0.1);
    let lines = [("contour", 66.0, "contour"), ("centre", 152.0, "nose centre"), ("tip", 264.0, "tip")];
    html! {
        g transform={ "translate(0 " (number(HEIGHT)) ")" } {
            "\n" path.thin d="M14 2V24H36M11 7L14 2L17 7M31 21L36 24L31 27" {}
            text.start x="18" y="11" { "X" } text.start x="40" y="28" { "Z" } "\n"
            @for (class, at, name) in lines {
                path class=(class) d={ "M" (number(at)) " 17h22" } {}
                text.start x=(number(at + 28.0)) y="21" { (name) } "\n"
            }
            path.thin d={ "M" (number(WIDTH - 16.0)) " 13v8M" (number(WIDTH - 16.0)) " 17h-" (number(bar * view.scale)) "m0 -4v8" } {}
            text x=(number(WIDTH - 46.0 - bar * view.scale)) y="21" { (number(bar)) " mm" }
        }
    }
}

#[cfg(test)]
#[allow(clippy::panic)]
mod tests {
    use turnspec_oracle::vocabulary::{Event, Setup};

    use super::super::scene::Scene;
    use super::svg;

    fn drawing(blocks: &[&str]) -> Result<String, String> {
        let program = b"N1 G42 G01 X100 Z100 F0.2 T010101\nN2 Z80\nN3 Z80\nN4 X60 Z70\nM02\n";
        let setup = Setup::from_toml("[[nose_radius]]\nnumber = 1\nx = 0.8\nz = 0.8\n");
        let mut trace = Vec::new();
        let setup = setup.unwrap_or_else(|error| panic!("{error}"));
        turnspec_oracle::run(program, &setup, &mut |event: &Event| trace.push(*event));
        svg("At N2 & N3", &Scene::of(&trace)?, blocks)
    }

    #[test]
    fn a_drawing_has_its_caption_and_the_names_of_its_points() {
        let text = drawing(&["N2", "N3"]).unwrap_or_else(|reason| panic!("{reason}"));
        assert!(text.contains("<title>At N2 &amp; N3</title>"));
        assert!(text.contains(">N2 N3</text>"), "one point, two blocks");
        assert!(text.contains(">N2</text>") && text.contains(">N3</text>"), "two nose centres");
        assert!(!text.contains(">N1<") && !text.contains(">N4<"), "outside the window");
    }

    #[test]
    fn a_caption_without_blocks_is_refused() {
        assert!(drawing(&["N9"]).is_err());
    }
}

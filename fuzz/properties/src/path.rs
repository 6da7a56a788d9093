//! Paths of lines, corners and arcs, known by their programmed points, that can be spelled in several ways.

use arbitrary::{Result, Unstructured};
use turnspec_oracle::vocabulary::Length;

/// A point in micrometres, X as a diameter.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) struct Point {
    pub(crate) x: i64,
    pub(crate) z: i64,
}

impl Point {
    pub(crate) fn plus(self, other: Self) -> Self {
        Self { x: self.x + other.x, z: self.z + other.z }
    }

    pub(crate) fn minus(self, other: Self) -> Self {
        Self { x: self.x - other.x, z: self.z - other.z }
    }
}

/// The blocks of a path, each with the point that it is programmed to.
#[derive(Clone, Debug)]
pub(crate) struct Path {
    pub(crate) elements: Vec<Element>,
}

/// A block.
#[derive(Clone, Debug)]
pub(crate) struct Element {
    /// Its words but for X and Z.
    words: String,
    /// Where it is programmed to.
    pub(crate) to: Point,
    /// Whether the block after it belongs to it (E100L-ANG-04: the line behind a corner).
    pub(crate) is_corner: bool,
}

/// How the point of a block is written.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Spelling {
    /// In G91 instead of G90.
    pub(crate) incremental: bool,
    /// By how much program coordinates are moved, after a G50 block in front if that changes here.
    pub(crate) shift: Point,
}

/// Spokes of a circle with whole components, counter-clockwise: Z and X as a radius.
const SPOKES: [(i64, i64); 12] = [
    (5, 0),
    (4, 3),
    (3, 4),
    (0, 5),
    (-3, 4),
    (-4, 3),
    (-5, 0),
    (-4, -3),
    (-3, -4),
    (0, -5),
    (3, -4),
    (4, -3),
];

impl Path {
    /// A path from the origin.
    pub(crate) fn grow(bytes: &mut Unstructured<'_>) -> Result<Self> {
        let mut elements = Vec::new();
        let mut here = Point::default();
        let count = bytes.int_in_range(1..=12)?;
        while elements.len() < count {
            let element = match bytes.int_in_range(0..=5)? {
                0 => line(bytes, "G00")?,
                1 | 2 => line(bytes, "G01")?,
                3 => {
                    elements.push(corner(bytes)?);
                    line(bytes, "G01")?
                }
                4 => arc_by_radius(bytes, here)?,
                _ => arc_by_centre(bytes, here)?,
            };
            here = element.to;
            elements.push(element);
        }
        Ok(Self { elements })
    }

    /// The text of a program with this path, each block spelled as it is said for it.
    pub(crate) fn program(&self, spelling: impl Fn(usize) -> Spelling) -> String {
        let mut text = String::from("G95 F0.25\n");
        let (mut here, mut shift) = (Point::default(), Point::default());
        for (index, element) in self.elements.iter().enumerate() {
            let spelling = spelling(index);
            if spelling.shift != shift {
                shift = spelling.shift;
                text += &format!("G50 {}\n", words(here.plus(shift)));
            }
            let (code, target) = match spelling.incremental {
                true => ("G91", element.to.minus(here)),
                false => ("G90", element.to.plus(shift)),
            };
            text += &format!("{code} {} {}\n", element.words, words(target));
            here = element.to;
        }
        text + "M02\n"
    }
}

fn words(point: Point) -> String {
    format!("X{} Z{}", length(point.x), length(point.z))
}

/// Micrometres as millimetres.
fn length(micrometres: i64) -> String {
    Length(micrometres * 1_000).to_string()
}

fn point(bytes: &mut Unstructured<'_>) -> Result<Point> {
    let grid = *bytes.choose(&[1_000, 1])?;
    let mut amount = |most: i64| Ok(bytes.int_in_range(-most / grid..=most / grid)? * grid);
    Ok(Point { x: amount(200_000)?, z: amount(200_000)? })
}

fn line(bytes: &mut Unstructured<'_>, code: &str) -> Result<Element> {
    Ok(Element { words: code.to_owned(), to: point(bytes)?, is_corner: false })
}

/// G75 or G76 (E100L-ANG-03, E100L-ANG-04).
fn corner(bytes: &mut Unstructured<'_>) -> Result<Element> {
    let code = *bytes.choose(&["G01 G75", "G01 G76"])?;
    let size = bytes.int_in_range(1..=20_000)?;
    Ok(Element { words: format!("{code} L{}", length(size)), to: point(bytes)?, is_corner: true })
}

fn arc_code(bytes: &mut Unstructured<'_>) -> Result<&'static str> {
    Ok(*bytes.choose(&["G02", "G03"])?)
}

/// L, with CALRG for the longer way round (E100L-CIRC-17, E100L-CIRC-18).
fn arc_by_radius(bytes: &mut Unstructured<'_>, here: Point) -> Result<Element> {
    let to = point(bytes)?;
    let (x, z) = ((to.x - here.x) as f64 / 2.0, (to.z - here.z) as f64);
    let least = (x.hypot(z) / 2.0).ceil() as i64;
    let radius = least + bytes.int_in_range(0..=50_000)?;
    let major = if bytes.arbitrary()? { " CALRG" } else { "" };
    let words = format!("{} L{}{major}", arc_code(bytes)?, length(radius.max(1)));
    Ok(Element { words, to, is_corner: false })
}

/// I and K (E100L-CIRC-04), closing exactly.
fn arc_by_centre(bytes: &mut Unstructured<'_>, here: Point) -> Result<Element> {
    let size = bytes.int_in_range(1..=8_000)?;
    let mut spoke = || Ok(*bytes.choose(&SPOKES)?);
    let ((from_z, from_x), (to_z, to_x)) = (spoke()?, spoke()?);
    let (k, i) = (-from_z * size, -from_x * size);
    let to = Point { x: here.x + 2 * (i + to_x * size), z: here.z + k + to_z * size };
    let words = format!("{} I{} K{}", arc_code(bytes)?, length(i), length(k));
    Ok(Element { words, to, is_corner: false })
}

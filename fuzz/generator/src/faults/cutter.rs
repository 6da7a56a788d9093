//! Faults of cutter radius compensation in G17 and G119.

use turnspec_oracle::vocabulary::{Feature, Length, NoseRadius, SidePlane};

use super::Fault;
use super::cutter_texts as texts;
use crate::builder::{Builder, Kind};

/// The number of the entry of the cutter of faults, which no other program has.
const CUTTER: u8 = 31;
/// Its radius, as written.
const RADIUS: i64 = 5;

/// What stands before the lines of a fault.
const READY: [&str; 4] = ["M110", "M146 M15 M24 M20", "T310100", "G90 G00 X100 Z50 C0 G94 F100"];

impl Builder<'_, '_, '_> {
    /// A fault of cutter radius compensation, mostly, where the program is to have it.
    pub(super) fn some_cutter_fault(&mut self) -> Option<Fault> {
        (self.cutters && self.choices.chance(80)).then(|| self.choices.weighted(texts::FAULTS))
    }

    /// Adds blocks with this fault.
    pub(super) fn cutter_fault(&mut self, fault: Fault) -> bool {
        let state = &self.state;
        let free = !state.compensation.is_on() && !state.compensation.left_over && !state.control.steady;
        let permitted = !state.control.has_modes() && self.permits_kind(Kind::Cutter);
        if !self.cutters || !free || !permitted || self.choices.chance(6) {
            return false;
        }
        match fault {
            Fault::Unspecified => {
                let at_centre = self.choices.chance(25);
                let text = self.choices.pick(if at_centre { texts::AT_CENTRE } else { texts::NOT_DESCRIBED });
                self.behind_cutter(text)
            }
            Fault::ProfileGeneration => self.cutter_wound_too_far(),
            Fault::NoFeed if !self.state.feed => {
                self.add_cutter();
                let text = self.choices.pick(&["G17 G41 G01 X80", "G119 G42 G01 Z45", "G17 G42 G101 C5"]);
                self.cutter_lines(&format!("M110\nM146\nT310100\nG90 G00 X100 Z50 C0 G94\n{text}"))
            }
            Fault::TravelLimitNegative | Fault::TravelLimitPositive => self.cutter_beyond_limit(fault),
            _ => match texts::FORMS.iter().find(|(known, _)| *known == fault) {
                Some((_, list)) => {
                    let text = self.choices.pick(list);
                    self.behind_cutter(text)
                }
                None => false,
            },
        }
    }

    /// A text, its mark replaced, behind what compensation needs.
    fn behind_cutter(&mut self, text: &str) -> bool {
        let turned = !text.contains("G119") && !text.starts_with('@');
        let parameters = &mut self.state.setup.parameters;
        parameters.side_contour_mode &= !(turned && (text.contains("G132") || text.contains("G133")));
        self.add_cutter();
        self.blocks(&READY) && self.cutter_lines(text)
    }

    /// The lines of a text.
    fn cutter_lines(&mut self, text: &str) -> bool {
        let first = text.lines().next().unwrap_or_default();
        let mark = texts::MARKS.iter().find(|(mark, _)| *mark == first);
        let mut lines: Vec<&str> = mark.map(|(_, lines)| lines.to_vec()).unwrap_or_default();
        lines.extend(text.lines().skip(usize::from(mark.is_some())));
        self.blocks(&lines)
    }

    /// The entry of the cutter, in the units of the program.
    fn add_cutter(&mut self) {
        let unit = self.state.units.length_unit();
        let radius = (RADIUS * unit / 1_000).max(1) * 1_000;
        let entries = &mut self.state.setup.nose_radius;
        entries.retain(|entry| entry.number != CUTTER);
        entries.push(NoseRadius { number: CUTTER, x: Length(radius), z: Length(radius) });
    }

    /// More turns of C than an arc on the side bears.
    fn cutter_wound_too_far(&mut self) -> bool {
        self.state.setup.parameters.side_contour_mode = false;
        let code = self.choices.within(15, 16);
        let side = self.choices.pick(&["G41", "G42"]);
        let arc = self.choices.pick(&["G132 Z20 C350 L900", "G133 C10 L900", "G132 Z20 C1 L900"]);
        let end = self.choices.pick(&["G40 G01 Z60", "M02", "G01 Z-30"]);
        self.add_cutter();
        self.blocks(&READY)
            && self.cutter_lines(&format!(
                "M{code} QA=1999\nQA=1999\nQA=1967\nC180\nG119 {side} G01 Z45\nM{code} {arc}\n{end}"
            ))
    }

    /// A limit between a programmed point and the cutter centre (E100L-NRC-80).
    fn cutter_beyond_limit(&mut self, fault: Fault) -> bool {
        if !self.allows(Feature::SystemVariable) {
            return false;
        }
        let positive = fault == Fault::TravelLimitPositive;
        let outer = self.state.setup.parameters.side_plane == SidePlane::Outer;
        let up = if positive == outer { "G41" } else { "G42" };
        let (limits, out) = if positive {
            (["VPVLX=VAPAX+4", "VPVLZ=VAPAZ+2"], "G42")
        } else {
            (["VNVLX=VAPAX-4", "VNVLZ=VAPAZ-2"], "G41")
        };
        let face = self.choices.chance(60);
        let text = if face {
            let way = self.choices.pick(&["G101 C40", "G01 C40", "G103 C40 L90", "G00 C50\nG40 C60"]);
            format!("{}\nG17 {out} G01 X100 C10\n{way}\nM02", limits[0])
        } else {
            let way = self.choices.pick(&["C40", "G00 C40\nG40 C60", "C50\nC90"]);
            format!("{}\nG119 {up} G01 Z50 C10\n{way}\nM02", limits[1])
        };
        self.behind_cutter(&text)
    }
}

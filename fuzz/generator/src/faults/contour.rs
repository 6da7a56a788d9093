//! Faults of contours and of coordinate conversion.

use turnspec_oracle::vocabulary::{Feature, Length, NoseRadius};

use super::Fault;
use super::contour_texts as texts;
use crate::builder::Builder;

const MM: i64 = 1_000_000;

/// What stands before the lines of a fault.
const READY: [&str; 3] = ["M110", "M146 M15 M24 M20", "G90 G00 X100 Z50 C0 G94 F100"];

impl Builder<'_, '_, '_> {
    /// A fault of contours, mostly, where the program is to have them.
    pub(super) fn some_contour_fault(&mut self) -> Option<Fault> {
        (self.contours && self.choices.chance(75)).then(|| self.choices.weighted(texts::FAULTS))
    }

    /// Adds blocks with this fault.
    pub(super) fn contour_fault(&mut self, fault: Fault) -> bool {
        let state = &self.state;
        let free = !state.compensation.is_on() && !state.compensation.left_over && !state.control.steady;
        if !self.contours || !free || !self.allows(Feature::ContourGeneration) || self.choices.chance(8) {
            return false;
        }
        if !self.permits_kind(crate::builder::Kind::Contour) {
            return false;
        }
        match fault {
            Fault::Unspecified if self.choices.chance(18) => self.contour_in_compensation(),
            Fault::Unspecified => self.behind_ready(texts::NOT_DESCRIBED),
            Fault::CompensationNotAllowed => {
                let text = self.choices.pick(&["G42\nG137 C0", "G41 G137 C0", "G41\nG04 F1\nG137 C9 M08"]);
                self.contour_lines(text)
            }
            Fault::ContourCommandUnusable => self.outside_side_mode(),
            Fault::ConversionAtLimit => self.at_the_limit(),
            Fault::NotModelled => {
                let text = self.choices.pick(&[
                    "M25\nG101 C90",
                    "M21\nG102 C90 L60",
                    "G132 Z20 L60 M25",
                    "M21\nG133 C60 L60\nM20",
                    "M25\nM24 G101 X50",
                    "G138",
                ]);
                self.state.setup.parameters.side_contour_mode = false;
                self.behind_ready(&[text])
            }
            Fault::ProfileGeneration => self.wound_too_far(),
            Fault::NoFeed if !self.state.feed => {
                let text = self.choices.pick(&["G101 C90", "G102 C90 L60", "G101 X0", "G132 Z20 L60"]);
                self.state.setup.parameters.side_contour_mode = false;
                self.contour_lines("M110\nM146\nG90 G00 X100 Z50 C0 G94") && self.contour_lines(text)
            }
            Fault::TravelLimitNegative | Fault::TravelLimitPositive => self.contour_beyond_limit(fault),
            _ => match texts::FORMS.iter().find(|(known, _)| *known == fault) {
                Some((_, list)) => self.behind_ready(list),
                None => false,
            },
        }
    }

    /// One of these texts, a block a line.
    fn contour_lines(&mut self, text: &str) -> bool {
        self.blocks(&text.split('\n').collect::<Vec<_>>())
    }

    /// One of these texts behind what a contour needs.
    fn behind_ready(&mut self, list: &[&str]) -> bool {
        self.state.setup.parameters.side_contour_mode &= self.choices.chance(20);
        let text = self.choices.pick(list);
        self.blocks(&READY) && self.contour_lines(text)
    }

    /// A contour, G136 or G137 while compensation is in force, in the block that ends it, or with a displacement left over.
    fn contour_in_compensation(&mut self) -> bool {
        if !self.state.setup.options.nose_radius_compensation || !self.allows(Feature::RadiusCompensation) {
            return false;
        }
        if !self.state.compensation.radii.contains_key(&1) {
            self.state.setup.nose_radius.push(NoseRadius { number: 1, x: Length(MM), z: Length(MM) });
        }
        let text = self.choices.pick(texts::IN_COMPENSATION);
        self.state.setup.parameters.side_contour_mode = false;
        self.blocks(&READY)
            && self.blocks(&["G18 G42 G01 X90 Z45 T010100", "Z20"])
            && self.contour_lines(text)
    }

    /// A code of the side in another plane.
    fn outside_side_mode(&mut self) -> bool {
        self.state.setup.parameters.side_contour_mode = true;
        let text = self.choices.pick(&[
            "G18\nG132",
            "G18 G133 Z20 L60",
            "G119\nG132 Z20 L60\nG18 Z10 L60",
            "G119\nG133 Z20 L60\nG136\nZ10 L60",
            "G119\nG132 Z20 L60\nM109\nG133",
            "G17 G132 C60 L60",
        ]);
        self.blocks(&READY) && self.contour_lines(text)
    }

    /// A limit where an axis stands, and G137.
    fn at_the_limit(&mut self) -> bool {
        let name = self.choices.pick(&["VPVLX", "VNVLX", "VPVLZ", "VNVLZ"]);
        if !self.allows(Feature::SystemVariable) {
            return false;
        }
        let axis = if name.ends_with('X') { "VAPAX" } else { "VAPAZ" };
        let beyond = match (self.choices.chance(30), name.contains('P')) {
            (false, _) => "",
            (true, true) => "-1",
            (true, false) => "+1",
        };
        self.blocks(&READY) && self.blocks(&[&format!("{name}={axis}{beyond}"), "G137 C0"])
    }

    /// More turns of C than an arc on the side bears.
    fn wound_too_far(&mut self) -> bool {
        self.state.setup.parameters.side_contour_mode = false;
        let code = self.choices.within(15, 16);
        let arc = self.choices.pick(&["G132 Z20 C350 L900", "G133 C10 L900", "G132 Z20 C1 L900"]);
        let text = format!("M{code} QA=1999\nQA=1999\nQA=1967\nC180\nM{code} {arc}");
        self.blocks(&READY) && self.contour_lines(&text)
    }

    /// A limit close to the present position, and a contour that ends beyond it.
    fn contour_beyond_limit(&mut self, fault: Fault) -> bool {
        if !self.allows(Feature::SystemVariable) {
            return false;
        }
        self.state.setup.parameters.side_contour_mode = false;
        let positive = fault == Fault::TravelLimitPositive;
        let (limit, ways) = if positive {
            (
                ["VPVLX=VAPAX+1", "VPVLZ=VAPAZ+1"],
                ["G101 X120", "G103 X120 L60", "G101 C90 Z60", "G133 Z60 L60"],
            )
        } else {
            (["VNVLX=VAPAX-1", "VNVLZ=VAPAZ-1"], ["G101 X60", "G101 X50 C180", "G132 Z20 L60", "G101 Z5"])
        };
        let way = self.choices.pick(&ways);
        self.blocks(&READY) && self.blocks(&limit) && self.blocks(&[way])
    }
}

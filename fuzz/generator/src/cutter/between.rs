//! What may stand beside the elements of a compensated contour, and blocks without motion in the plane between them.

use turnspec_oracle::vocabulary::Feature;

use super::Surface;
use super::setup::CUTTERS;
use crate::builder::Builder;
use crate::companions::has;
use crate::expression::{Expression, Variable};
use crate::program::{Item, Statement};
use crate::state::{Axis, Mode};

/// M codes without effect on motion.
const HARMLESS: &[i64] = &[8, 9, 65, 146];

/// A block between elements.
#[derive(Clone, Copy)]
enum Between {
    Dwell,
    Code,
    Speed,
    Feed,
    Dimension,
    /// Axes that have no part in the plane.
    Aside,
    Tool,
    Jump,
    Assignment,
    /// The frame is written as it is, or that of W changes.
    Frame,
    Remark,
}

const BLOCKS: &[(usize, Between)] = &[
    (14, Between::Dwell),
    (14, Between::Code),
    (10, Between::Speed),
    (6, Between::Feed),
    (10, Between::Dimension),
    (30, Between::Aside),
    (8, Between::Tool),
    (4, Between::Jump),
    (8, Between::Assignment),
    (6, Between::Frame),
    (6, Between::Remark),
];

impl Builder<'_, '_, '_> {
    /// A few words for the beginning of a block that change neither frame nor feed mode.
    pub(super) fn beside_cutter(&mut self, items: &mut Vec<Item>) {
        if self.state.cutter.surface != Surface::Side && self.choices.chance(10) {
            let code = self.choices.within(15, 16);
            self.state.contours.note_m(code);
            items.push(Item::m(code));
        }
        if !self.choices.chance(30) {
            return;
        }
        match self.choices.below(8) {
            0 | 1 if self.allows(Feature::Feed) => items.push(self.feed_word()),
            2 if self.allows(Feature::Spindle) => items.push(self.spindle_speed()),
            3 if self.allows(Feature::MTool) && !self.state.is_eia() => items.push(self.whole("SB", 400)),
            4 | 5 => items.extend(self.other_dimension()),
            6 if self.choices.chance(40) => items.extend(self.cutter_word(false)),
            _ => items.push(self.harmless_code()),
        }
    }

    /// A block without motion in the plane, or a statement.
    pub(super) fn between_elements(&mut self) {
        self.begin();
        let mut items = Vec::new();
        match self.choices.weighted(BLOCKS) {
            Between::Dwell if self.allows(Feature::Dwell) => {
                items.extend([Item::g(4), Item::whole("F", 1)]);
            }
            Between::Speed if self.allows(Feature::Spindle) => items.push(self.spindle_speed()),
            Between::Feed if self.allows(Feature::Feed) => items.push(self.feed_word()),
            Between::Dimension => items.extend(self.other_dimension()),
            Between::Aside => self.axes_aside(&mut items),
            Between::Tool => items.extend(self.cutter_word(false)),
            Between::Assignment if self.allows(Feature::Variable) && !self.state.is_eia() => {
                items.push(self.common());
            }
            Between::Frame if self.allows(Feature::SystemVariable) && !self.state.is_eia() => {
                let item = self.same_frame();
                items.push(item);
            }
            Between::Jump => {
                if self.allows(Feature::ControlStatement) && self.allows(Feature::SequenceName) {
                    let name = self.new_name();
                    self.statement(Statement::Goto(name.clone()), Vec::new());
                    self.dead_text(&name);
                    self.set_label(name);
                }
                return;
            }
            Between::Remark if self.allows(Feature::Comment) => return self.raw(b"(SLOT)"),
            _ => {}
        }
        if items.is_empty() {
            items.push(self.harmless_code());
        }
        self.state.cutter.idle += 1;
        self.push(items);
    }

    /// The number of blocks without motion in the plane, which is one at most (E100L-CRC-14).
    pub(super) fn is_idle(&self) -> bool {
        self.state.cutter.idle > 0
    }

    /// An assignment to the frame that leaves X, Z and C where they are (E100L-CRC-14).
    fn same_frame(&mut self) -> Item {
        if self.state.setup.options.w_axis && self.choices.chance(50) {
            let present = self.state.zero_offset[Axis::W as usize] / 1_000;
            let (low, high) = (present - 20_000, present + 20_000);
            let (item, value) = self.assign_length(Variable::System("VZOFW"), low, high);
            self.state.zero_offset[Axis::W as usize] = value;
            return item;
        }
        let name = self.choices.pick(&["VZOFX", "VZOFZ", "VZSHX", "VZSHZ"]);
        Item::Assignment(Variable::System(name), Expression::Variable(Variable::System(name)))
    }

    fn harmless_code(&mut self) -> Item {
        let code = self.choices.pick(HARMLESS);
        if code == 146 {
            self.note_m(code);
        }
        Item::m(code)
    }

    fn other_dimension(&mut self) -> Option<Item> {
        let both = self.allows(Feature::Absolute) && self.allows(Feature::Incremental);
        let change = self.choices.chance(70);
        both.then(|| self.incremental_word(self.state.incremental != change))
    }

    /// Z or W on the face, W or the present X on the side.
    fn axes_aside(&mut self, items: &mut Vec<Item>) {
        let face = self.state.cutter.surface != Surface::Side;
        let w = self.state.setup.options.w_axis && self.choices.chance(40);
        let linear = self.choices.chance(50);
        let mut mode = if linear { Mode::Linear } else { Mode::Rapid };
        if face && !w && self.choices.chance(40) {
            mode = Mode::FaceLine;
        }
        self.select(mode, items);
        if linear {
            self.feed_if_needed(items);
        }
        let from = self.present();
        match (w, face) {
            (true, _) => self.aside_word(Axis::W, items),
            (false, true) => self.aside_word(Axis::Z, items),
            (false, false) => {
                let x = self.state.program(Axis::X);
                let (item, reached) = self.plain_target_x(x);
                if reached == x {
                    items.push(item);
                }
            }
        }
        self.travelled(from, self.present(), None);
        self.state.after_cutting = mode != Mode::Rapid;
    }

    /// An X word toward a diameter as a plain number, and what it leads to.
    pub(super) fn plain_target_x(&mut self, wanted: i64) -> (Item, i64) {
        let base = if self.state.incremental { self.state.program(Axis::X) } else { 0 };
        let (item, length) = self.plain_length("X", wanted - base);
        (item, base + length)
    }

    /// A T word of a cutter. `freely`: with any tool offset, else with that in force.
    pub(super) fn cutter_word(&mut self, freely: bool) -> Option<Item> {
        let radii = &self.state.compensation.radii;
        let known: Vec<u8> = CUTTERS.filter(|number| radii.contains_key(number)).collect();
        if known.is_empty() || !self.allows(Feature::Tool) {
            return None;
        }
        let nose = if self.choices.chance(94) { self.choices.pick(&known) } else { 0 };
        let offset = if freely { self.choices.within(0, 4) } else { i64::from(self.state.offset) };
        let tool = self.choices.within(1, 12);
        self.state.compensation.nose = nose;
        self.state.offset = u8::try_from(offset).unwrap_or_default();
        self.state.tool = u8::try_from(tool).unwrap_or_default();
        Some(self.whole("T", i64::from(nose) * 10_000 + tool * 100 + offset))
    }

    /// Whether a block has a T word.
    pub(super) fn has_tool(items: &[Item]) -> bool {
        has(items, "T")
    }
}

//! Words that may stand beside any motion: modes, feed, S, SB, SA, T, M codes.

use turnspec_oracle::vocabulary::Feature;

use crate::builder::Builder;
use crate::codes;
use crate::needs;
use crate::program::Item;

impl Builder<'_, '_, '_> {
    /// A few words for the beginning of a block; what they do happens before its motion.
    pub(crate) fn companions(&mut self, items: &mut Vec<Item>) {
        self.due_compensation(items);
        if self.choices.chance(50) {
            return;
        }
        self.mode_words(items, 10);
        if self.choices.chance(8) && !has(items, "F") && self.allows(Feature::Feed) {
            items.push(self.feed_word());
        }
        if self.choices.chance(8) && !has(items, "S") && self.allows(Feature::Spindle) {
            items.push(self.spindle_speed());
        }
        self.extended_speeds(items, 4);
        let steady = self.state.control.steady;
        if self.choices.chance(6) && !has(items, "T") && self.allows(Feature::Tool) && !steady {
            items.push(self.tool_word());
        }
        if self.choices.chance(25) {
            self.m_words(items, 3);
        }
    }

    /// A block of modes only.
    pub(crate) fn modes(&mut self) {
        let mut items = Vec::new();
        self.mode_words(&mut items, 45);
        if items.is_empty() {
            items.push(self.incremental_word(!self.state.incremental));
        }
        self.push(items);
    }

    /// A block of S, T and M words.
    pub(crate) fn auxiliary(&mut self) {
        let mut items = Vec::new();
        if self.choices.chance(40) && self.allows(Feature::Spindle) {
            items.push(self.spindle_speed());
        }
        self.extended_speeds(&mut items, 15);
        if self.choices.chance(30) && self.allows(Feature::Tool) && !self.state.control.steady {
            items.push(self.tool_word());
        }
        if items.is_empty() || self.choices.chance(60) {
            self.m_words(&mut items, 8);
        }
        if self.choices.chance(5) && self.allows(Feature::OptionalStop) {
            items.push(Item::m(self.choices.within(0, 1)));
        }
        if items.is_empty() {
            items.push(Item::m(8));
        }
        self.push(items);
    }

    /// Codes of the modal groups, each with this chance in a hundred.
    fn mode_words(&mut self, items: &mut Vec<Item>, percent: usize) {
        let dimension = self.allows(Feature::Absolute) || self.allows(Feature::Incremental);
        if self.choices.chance(percent) && dimension {
            let incremental = if self.choices.chance(60) { false } else { !self.state.incremental };
            items.push(self.incremental_word(incremental));
        }
        if self.choices.chance(percent) && self.allows(Feature::Feed) {
            self.state.per_minute = self.choices.chance(50);
            items.push(Item::g(if self.state.per_minute { 94 } else { 95 }));
            if self.choices.chance(50) {
                items.push(self.feed_word());
            }
        }
        let speeds = self.allows(Feature::CuttingSpeed) && !self.state.control.steady;
        if self.choices.chance(percent / 2) && speeds {
            self.state.cutting_speed = self.choices.chance(60);
            items.push(Item::g(if self.state.cutting_speed { 96 } else { 97 }));
            items.push(self.spindle_speed());
        }
        if self.choices.chance(percent / 2) && self.allows(Feature::Aux) {
            items.push(Item::g(self.choices.within(64, 65)));
        }
        self.turret_words(items, percent);
        self.compensation_words(items, percent);
    }

    /// Codes of the plane and of compensation that change little here.
    fn compensation_words(&mut self, items: &mut Vec<Item>, percent: usize) {
        let written = |item: &Item| matches!(item, Item::Word(word) if word.is_g(&[18, 40, 41, 42]));
        if !self.allows(Feature::RadiusCompensation) || items.iter().any(written) {
            return;
        }
        if self.state.compensation.is_on() {
            if self.choices.chance(percent / 2) {
                self.side_word(items);
            }
            return;
        }
        if self.choices.chance(percent / 4) {
            items.push(Item::g(18));
            self.state.plane = 18;
        }
        if self.choices.chance(percent / 4) {
            items.push(Item::g(40));
        }
    }

    /// G90 or G91.
    pub(crate) fn incremental_word(&mut self, incremental: bool) -> Item {
        self.state.incremental = incremental;
        Item::g(if incremental { 91 } else { 90 })
    }

    /// An S word for the speed mode in force.
    pub(crate) fn spindle_speed(&mut self) -> Item {
        let speed = if self.state.cutting_speed {
            self.choices.pick(&[100, 180, 250, 1, 33, 600])
        } else {
            self.choices.pick(&[500, 1_200, 3_000, 0, 1, 9_999, 65_535])
        };
        self.state.threads.note_speed(self.state.cutting_speed, speed);
        self.whole("S", speed)
    }

    /// SB and SA words.
    fn extended_speeds(&mut self, items: &mut Vec<Item>, percent: usize) {
        if self.state.is_eia() {
            return;
        }
        if self.choices.chance(percent) && self.allows(Feature::MTool) {
            let speed = self.choices.pick(&[400, 0, 1_500, 65_535]);
            items.push(self.whole("SB", speed));
        }
        if self.choices.chance(percent / 2) && self.allows(Feature::CAxis) {
            let speed = self.choices.pick(&[1, 5, 20]);
            items.push(self.whole("SA", speed));
        }
    }

    /// A T word of two, four or six digits.
    pub(crate) fn tool_word(&mut self) -> Item {
        let sets = i64::from(self.state.setup.options.offset_sets);
        let offset =
            if self.choices.chance(80) { self.choices.within(0, 4) } else { self.choices.within(0, sets) };
        let tool = if self.choices.chance(15) { 0 } else { self.choices.within(1, 12) };
        let nose = self.tool_nose(sets);
        self.state.offset = u8::try_from(offset).unwrap_or_default();
        if tool != 0 {
            self.state.tool = u8::try_from(tool).unwrap_or_default();
        }
        self.state.compensation.nose = u8::try_from(nose).unwrap_or_default();
        self.whole("T", nose * 10_000 + tool * 100 + offset)
    }

    /// The first two digits of a T word, often those of an entry.
    fn tool_nose(&mut self, sets: i64) -> i64 {
        if !self.state.setup.options.nose_radius_compensation || !self.choices.chance(60) {
            return 0;
        }
        if self.choices.chance(70) { self.choices.within(1, 4) } else { self.choices.within(0, sets) }
    }

    /// One to `most` M codes of different groups that raise no alarm here.
    pub(crate) fn m_words(&mut self, items: &mut Vec<Item>, most: usize) {
        let possible: Vec<_> = codes::M_GROUPS.iter().filter(|group| self.allows_m(group[0])).collect();
        let mut groups = vec![false; possible.len()];
        let mut seen = Vec::new();
        let mut special = false;
        for _ in 0..=self.choices.late(most).min(self.choices.late(most)) {
            let code = match self.choices.weighted(&[(55, 0), (24, 1), (18, 2), (3, 3)]) {
                0 if groups.is_empty() => continue,
                0 => {
                    let group = self.choices.below(groups.len());
                    if std::mem::replace(&mut groups[group], true) {
                        continue;
                    }
                    self.choices.pick(possible[group])
                }
                1 => codes::single_m(self.choices.below(400)),
                3 => 100,
                _ if self.state.control.steady || std::mem::replace(&mut special, true) => continue,
                _ => self.special_m(),
            };
            let unsafe_index = code == 203 && !self.state.setup.inputs.turret_clamp_confirmed;
            let grouped = matches!(code, 12..=14 | 109 | 110 | 124 | 125 | 146 | 147 | 152 | 153 | 194);
            if !self.allows_m(code) || !self.bears_m(code) {
                continue;
            }
            if seen.contains(&code) || unsafe_index || grouped && special && seen.iter().any(is_special) {
                continue;
            }
            seen.push(code);
            self.note_m(code);
            items.push(self.whole("M", code));
        }
    }

    /// Whether the profile allows an M code.
    fn allows_m(&self, code: i64) -> bool {
        needs::of_m_code(code, self.state.setup.machine.r#type).iter().all(|feature| self.allows(*feature))
    }

    /// A code of the C axis, of the rotary tool or of the time check that is allowed here.
    fn special_m(&mut self) -> i64 {
        let may_start = self.state.joined || self.state.released;
        let slow = crate::setup::is_over_time(&self.state.setup);
        match self.choices.below(6) {
            0 if may_start => self.choices.within(13, 14),
            0 => 12,
            1 => self.choices.within(146, 147),
            2 => self.choices.within(152, 153),
            3 if slow => 125,
            3 => self.choices.within(124, 125),
            4 if self.state.joined && self.choices.chance(50) => 109,
            4 => 146,
            _ => 194,
        }
    }

    /// Changes the state as an M code does.
    pub(crate) fn note_m(&mut self, code: i64) {
        self.state.barriers.note_m(code);
        self.state.contours.note_m(code);
        match code {
            109 => (self.state.joined, self.state.plane) = (false, 18),
            110 => self.state.joined = true,
            146 | 147 => self.state.clamped = code == 147,
            152 | 153 => self.state.released = code == 153,
            124 | 125 => self.state.timed = code == 124,
            _ => {}
        }
        self.note_turning(code);
    }

    /// The C axis is joined or taken off, clamped or freed.
    pub(crate) fn c_axis(&mut self) {
        let plane = self.state.joined && !self.state.compensation.is_on();
        if plane && self.allows(Feature::RadiusCompensation) && self.choices.chance(30) {
            return self.plane();
        }
        let code = match (self.state.joined, self.state.clamped) {
            (false, _) if self.choices.chance(85) => 110,
            (true, true) if self.choices.chance(70) => 146,
            (true, false) if self.choices.chance(20) => 147,
            (true, _) if self.choices.chance(40) => 109,
            _ => self.choices.pick(codes::M_ALONE),
        };
        self.note_m(code);
        self.push(vec![Item::m(code)]);
    }
}

/// Whether an M code belongs to the groups that `special_m` draws from.
fn is_special(code: &i64) -> bool {
    matches!(code, 12..=14 | 109 | 124 | 125 | 146 | 147 | 152 | 153 | 194)
}

/// Whether a block has a word of this address.
pub(crate) fn has(items: &[Item], address: &str) -> bool {
    items.iter().any(|item| matches!(item, Item::Word(word) if word.address == address))
}

//! What the blocks and the motions of a definition may hold (execution of LAP, 5; E100L-LAP-03 to E100L-LAP-05,
//! E100L-LAP-11, E100L-LAP-12, E100L-LAP-14, E100L-LAP-16).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, Label};

use crate::engine::Interpreter;
use crate::engine::block::Plan;
use crate::engine::codes::GGroup;
use crate::engine::compensation::Change;
use crate::engine::fault::Fault;
use crate::engine::thread;
use crate::engine::words::{Address, Item, Parsed, Source, Words};

use super::definition::Definition;
use super::pass_over::codes;
use super::{malformed, unspecified};

const UNFIT: u64 =
    Address::set(&[Address::M, Address::T, Address::SA, Address::SB, Address::W, Address::QA, Address::C]);

impl Interpreter<'_> {
    /// Tests a parsed block of a definition.
    #[cold]
    pub(in crate::engine) fn admit_parsed(&self, parsed: &Parsed) -> Result<(), Fault> {
        let Some(definition) = self.lap.definition() else { return Ok(()) };
        if self.is_turret_block(parsed) {
            // E100L-MIRR-03: nothing else in it counts. E100L-MIRR-09: LAP forbids a change.
            let code = Self::turret_code(parsed)?;
            if self.changes_turret(code) {
                return Fault::raise(AlarmName::TurretChange, MIRR_09);
            }
            let rule = if definition.blank { LAP_03 } else { LAP_04 };
            return Err(malformed(rule, Label::of_code(b'G', code)));
        }
        let returns = self.task.depth() > definition.depth;
        if let Some(control) = parsed.control.filter(|control| !control.is_for_contours(returns)) {
            return Err(unspecified(LAP_04, control.word()));
        }
        for item in &parsed.items {
            let name = match item {
                Item::System { variable, .. } => variable.name(),
                Item::Comment { .. } => (*b"VUACM", 5),
                _ => continue,
            };
            let (name, length) = name;
            let name = name.get(..length).unwrap_or_default();
            return Err(unspecified(LAP_04, Label::from_bytes(name)));
        }
        if !parsed.contour.is_empty() {
            let code = codes(parsed).next().unwrap_or_default();
            return Err(malformed(LAP_14, Label::of_code(b'G', code)));
        }
        Ok(())
    }

    /// Tests an evaluated block of a definition.
    #[cold]
    pub(in crate::engine) fn admit_words(&self, parsed: &Parsed, words: &Words) -> Result<(), Fault> {
        let Some(definition) = self.lap.definition() else { return Ok(()) };
        admit_codes(definition, words)?;
        let motion = words.code_of(GGroup::Motion).unwrap_or(self.state.motion);
        let mut m = words.m_codes().iter().copied();
        for address in parsed.items.iter().filter_map(Item::address) {
            let code = if address == Address::M { m.next().unwrap_or_default() } else { 0 };
            let of_thread = definition.cuts_thread()
                && (code == 27 || address == Address::C && thread::is_leg_mode(motion));
            if UNFIT & address.bit() != 0 && !of_thread {
                let detail = match address {
                    Address::M => Label::of_code(b'M', code),
                    _ => Label::new(address.text()),
                };
                return Err(malformed(LAP_04, detail));
            }
        }
        let coordinate = words.has(Address::X) || words.has(Address::Z);
        match words.code_of(GGroup::Dimension) {
            Some(code) if definition.motions == 0 && !coordinate => {
                Err(malformed(LAP_11, Label::of_code(b'G', code)))
            }
            _ => Ok(()),
        }
    }

    /// A block of a definition comes to its motions.
    #[cold]
    pub(in crate::engine) fn admit_motion(&mut self, plan: Plan) -> Result<(), Fault> {
        let Some(definition) = self.lap.definition_mut() else { return Ok(()) };
        let is_first = definition.motions == 0;
        definition.motions = definition.motions.saturating_add(1);
        let arc = matches!(plan.motion, 2 | 3);
        let rule = if definition.blank { LAP_03 } else { LAP_04 };
        if is_first {
            if definition.blank && arc {
                return Fault::raise(AlarmName::BlankFirstElement, LAP_03);
            }
            if arc || definition.cuts_thread() && plan.motion != 0 {
                return Err(malformed(LAP_05, const { Label::new("first") }));
            }
        } else if plan.motion == 0 && plan.compensation != Change::Ends {
            return Err(malformed(rule, const { Label::new("G00") }));
        }
        if thread::is_mode(plan.motion) && !(definition.cuts_thread() && thread::is_leg_mode(plan.motion)) {
            return Err(malformed(rule, Label::of_code(b'G', plan.motion)));
        }
        Ok(())
    }
}

/// The G codes of a block, row by row.
fn admit_codes(definition: &Definition, words: &Words) -> Result<(), Fault> {
    let find = |row: &dyn Fn(u16) -> bool| words.g_codes().iter().copied().find(|code| row(*code));
    let code = |code| Label::of_code(b'G', code);
    if let Some(found) = find(&|code| matches!(code, 64 | 65 | 94..=97)) {
        return Err(malformed(LAP_12, code(found)));
    }
    if definition.blank {
        if words.has_g(83) {
            return Err(malformed(LAP_02, code(83)));
        }
        if let Some(found) = find(&|code| matches!(code, 40..=42)) {
            return Err(malformed(LAP_16, code(found)));
        }
        if words.has_g(80) {
            return Err(malformed(LAP_02, const { Label::new("blank") }));
        }
        return match find(&|code| !matches!(code, 0..=3 | 81 | 82 | 90 | 91)) {
            Some(found) => Err(malformed(LAP_03, code(found))),
            None => Ok(()),
        };
    }
    if let Some(found) = find(&|code| matches!(code, 81..=83)) {
        return Err(malformed(LAP_01, code(found)));
    }
    let fits = |code: u16| match definition.cuts_thread() {
        true => matches!(code, 0 | 1 | 34 | 35 | 80 | 90 | 91),
        false => matches!(code, 0..=3 | 40..=42 | 75 | 76 | 80 | 90 | 91),
    };
    match find(&|code| !fits(code)) {
        Some(found) => Err(malformed(LAP_04, code(found))),
        None => Ok(()),
    }
}

/// Whether a word is a G code that is written as a plain number.
pub fn plain_code(item: &Item) -> Option<u16> {
    match item {
        Item::Word(Address::G, Source::Plain(number)) => crate::engine::task::whole(*number),
        _ => None,
    }
}

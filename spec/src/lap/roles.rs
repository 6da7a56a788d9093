//! What the motions of modes I and IV name, by their parts (execution-lap.md, section 14).

use super::motion::Role;
use crate::thread::Cited;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{Part, RuleId};

/// The pass that a motion belongs to.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// Its number.
    pub number: u32,
    /// Whether it belongs to the last one, which goes along the contour.
    pub last: bool,
    /// Whether it begins in a recess.
    pub in_recess: bool,
    /// What its depth and feed are named for.
    pub cited: Cited,
}

/// A straight cut.
#[derive(Clone, Copy, Debug)]
pub struct Straight {
    /// Whether it leads over a recess.
    pub over_recess: bool,
    /// Whether it is cut in more than one part.
    pub parted: bool,
    /// Whether its level meets the contour.
    pub meets: bool,
}

/// The roles of mode I, or of mode IV.
#[derive(Clone, Copy, Debug)]
pub struct Roles {
    /// Whether it is mode IV.
    pub high_speed: bool,
    /// Whether S is nearer than the clearance (E100L-AP4-03).
    pub near: bool,
}

impl Roles {
    fn role(self, pass: &Pass, part: Part, rules: &[RuleId]) -> Role {
        let own = Cited::rules(rules).and(pass.cited);
        let cited = if self.high_speed {
            own.and_if(pass.number == 1, Cited::rules(&[AP4_01]))
        } else {
            own.and(Cited::rules(&[AP1_01]))
        };
        Role { pass: Some(pass.number), part, cited }
    }

    /// The same, of what mode IV does as mode I.
    fn as_in_mode_i(self, pass: &Pass, part: Part, rules: &[RuleId]) -> Role {
        let role = self.role(pass, part, rules);
        Role { cited: role.cited.and_if(self.high_speed, Cited::rules(&[AP4_06])), ..role }
    }

    /// The way in.
    pub fn infeed(self, pass: &Pass) -> Role {
        let role = if self.high_speed {
            let role = self.role(pass, Part::Infeed, &[if self.near { AP4_03 } else { AP4_02 }]);
            let cited = role
                .cited
                .and_if(pass.number > 1, Cited::rules(&[AP4_04]))
                .and_if(!pass.last, Cited::rules(&[LAP_05]));
            Role { cited, ..role }
        } else {
            self.role(pass, Part::Infeed, &[LAP_05, AP1_02, AP1_03])
        };
        Role { cited: role.cited.and_if(pass.last, Cited::rules(&[AP1_08])), ..role }
    }

    /// A cut along a level.
    pub fn cut(self, pass: &Pass, straight: Straight) -> Role {
        let rule: RuleId = match (pass.in_recess, straight.over_recess) {
            (true, _) => AP1_11,
            (false, true) => AP1_10,
            (false, false) => AP1_04,
        };
        let role = self.role(pass, Part::Cut, &[rule]);
        let cited = role
            .cited
            .and_if(self.high_speed && straight.parted, Cited::rules(&[AP4_05]))
            .and_if(self.high_speed && !straight.meets, Cited::rules(&[AP4_07]));
        Role { cited, ..role }
    }

    /// The way through air on a level.
    pub fn air(self, pass: &Pass) -> Role {
        self.role(pass, Part::Air, &[AP4_05])
    }

    /// A motion along the contour.
    pub fn contour(self, pass: &Pass, ends_in_recess: bool) -> Role {
        let rule: RuleId = match (pass.in_recess, ends_in_recess, pass.last) {
            (true, ..) => AP1_11,
            (false, true, _) => AP1_10,
            (false, false, true) => AP1_08,
            (false, false, false) => AP1_05,
        };
        self.as_in_mode_i(pass, Part::Contour, &[rule])
    }

    /// The relief; `double`: behind the last pass of a recess.
    pub fn relief(self, pass: &Pass, double: bool) -> Role {
        let role = self.as_in_mode_i(pass, Part::Relief, &[AP1_06]);
        let cited = role
            .cited
            .and_if(pass.in_recess, Cited::rules(&[AP1_11]))
            .and_if(double, Cited::rules(&[AP1_12]));
        Role { cited, ..role }
    }

    /// The lift of a pass that has ended below its highest point.
    pub fn clear(self, pass: &Pass) -> Role {
        self.as_in_mode_i(pass, Part::Clear, &[AP1_06])
    }

    /// The lift behind and between recesses.
    pub fn clear_of_recess(self, pass: &Pass) -> Role {
        self.as_in_mode_i(pass, Part::Clear, &[AP1_12])
    }

    /// The way into a recess.
    pub fn return_to_recess(self, pass: &Pass) -> Role {
        self.as_in_mode_i(pass, Part::Return, &[AP1_11])
    }

    /// The way back to an infeed point.
    pub fn return_to_infeed(self, pass: &Pass) -> Role {
        self.role(pass, Part::Return, &[if self.high_speed { AP4_04 } else { AP1_07 }])
    }

    /// The way back to S.
    pub fn home(self) -> Role {
        let rules: &[RuleId] = if self.high_speed { &[AP4_08, LAP_06] } else { &[AP1_09, LAP_06, AP1_01] };
        Role { pass: None, part: Part::Home, cited: Cited::rules(rules) }
    }
}

//! What the events of the cycles cite (execution of drilling, 10).

use turnspec_oracle::vocabulary::RuleSet;
use turnspec_oracle::vocabulary::rule_ids::*;

use crate::engine::Interpreter;
use crate::engine::cite;
use crate::engine::contour::word_cites;
use crate::engine::thread::Cited;
use crate::engine::words::Words;

/// The rules of the `mode` event of a cycle code.
pub fn mode_rules(code: u16) -> RuleSet {
    let common = const { RuleSet::of(&[GCODE_02, MCYC_01]) };
    common.union(match code {
        178 => const { RuleSet::of(&[STAP_01]) },
        179 => const { RuleSet::of(&[STAP_01, STAP_03]) },
        180 => const { RuleSet::of(&[MCYC_02, MCYC_12]) },
        190 => const { RuleSet::of(&[G190_01]) },
        _ => cycle_rules(code, false),
    })
}

/// The rules of a cycle, which all its events cite.
pub fn cycle_rules(code: u16, synchronised: bool) -> RuleSet {
    match code {
        178 => const { RuleSet::of(&[STAP_02]) },
        179 => const { RuleSet::of(&[STAP_02, STAP_03]) },
        181 => const { RuleSet::of(&[G181_01]) },
        182 => const { RuleSet::of(&[G182_01]) },
        183 => const { RuleSet::of(&[G183_01]) },
        184 if synchronised => const { RuleSet::of(&[STAP_02, G184_02]) },
        184 => const { RuleSet::of(&[G184_01]) },
        185 => const { RuleSet::of(&[CTHR_02]) },
        186 => const { RuleSet::of(&[CTHR_03]) },
        187 => const { RuleSet::of(&[CTHR_04]) },
        188 => const { RuleSet::of(&[CTHR_05]) },
        189 => const { RuleSet::of(&[G189_01]) },
        _ => const { RuleSet::of(&[G190_01, G190_02]) },
    }
}

impl Interpreter<'_> {
    /// What every motion of a block cites.
    pub(super) fn cited_in_cycle(&mut self, words: &Words) -> Cited {
        let cited = if self.state.contour.converts() {
            // There X is no diameter.
            self.cited_by(word_cites(&self.state, self.inch_block, false))
        } else {
            self.cited_by_words(words)
        };
        cited.and_if(self.state.mirror < 0, const { RuleSet::of(&[MIRR_05]) })
    }

    /// What a motion at the feed in force cites besides.
    pub(super) fn cited_by_feed(&mut self) -> Cited {
        let rules = self.cites.rules(self.feed_cites().and(cite::G01_04));
        Cited { rules, readings: self.known.feed_length }
    }
}

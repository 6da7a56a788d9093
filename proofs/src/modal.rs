//! Theorems about the tables of G and M codes: every code has its place.

use turnspec::engine::codes::{Status, g_code, g_group, m_code, m_group, m_group_number, m_rules};

#[cfg(stand_in)]
use crate::kani;

theorems! {
    /// Every number is a G code of one status, and has a group exactly when it is modelled.
    /// Of: `codes::g_code`, `codes::g_group`
    /// Assumes: any number of 16 bits.
    /// Rules: E100L-GTAB-01, E100L-GCODE-01
    #[unwind(27)]
    fn every_g_code_has_its_place() {
        let code: u16 = kani::any();
        let status = g_code(code);
        kani::cover!(status == Status::Modelled, "modelled");
        kani::cover!(status == Status::Unspecified, "listed without meaning");
        kani::cover!(status == Status::NotModelled, "not modelled");
        assert!((status == Status::Modelled) == g_group(code).is_some());
        assert!(status == Status::Unassigned || code <= 313);
    }

    /// The groups of G codes fit a set of 16 bits.
    /// Of: `codes::g_group`
    /// Assumes: any number of 16 bits.
    /// Rules: E100L-GCODE-02, E100L-GCODE-04
    #[unwind(2)]
    fn groups_of_g_codes_fit_their_set() {
        let group = g_group(kani::any());
        kani::cover!(group.is_some(), "a group");
        assert!(group.is_none_or(|group| (group as u16) < 16));
    }

    /// The codes that switch a mode on and off share a group, and no other code is in it.
    /// Of: `codes::g_group`
    /// Assumes: any number of 16 bits.
    /// Rules: E100L-GCODE-02, E100L-ABS-04, E100L-FEED-01, E100L-FEED-02, E100L-CSS-02, E100L-DROOP-02
    #[unwind(6)]
    fn a_mode_has_two_codes() {
        let code: u16 = kani::any();
        kani::cover!(code == 95, "a code of a pair");
        for (on, off) in [(64, 65), (90, 91), (94, 95), (96, 97)] {
            assert!(g_group(on).is_some() && g_group(on) == g_group(off));
            assert!((g_group(code) == g_group(on)) == (code == on || code == off));
        }
    }

    /// The groups of M codes fit a set of 64 bits; only codes of the table have one, and each has a name.
    /// Of: `codes::m_group_number`, `codes::m_group`, `codes::m_code`
    /// Assumes: any number of 16 bits.
    /// Rules: E100L-MCODE-01, E100L-MTAB-01
    #[unwind(27)]
    fn groups_of_m_codes_fit_their_set() {
        let code: u16 = kani::any();
        let group = m_group_number(code);
        kani::cover!(group == Some(0), "a spindle command");
        assert!(group.is_none_or(|group| group < 64 && m_code(code) != Status::Unassigned));
        assert!(m_group(code).is_some() == group.is_some());
    }

    /// Beyond 511 there is no M code.
    /// Of: `codes::m_code`, `codes::m_group_number`
    /// Assumes: any number of 16 bits.
    /// Rules: E100L-MCODE-01
    #[unwind(27)]
    fn m_codes_end() {
        let code: u16 = kani::any();
        kani::assume(code > 511);
        kani::cover!(code == u16::MAX, "the last number");
        assert!(m_code(code) == Status::Unassigned && m_group_number(code).is_none());
    }

    /// Every M code cites a rule, two at most.
    /// Of: `codes::m_rules`
    /// Assumes: any number of 16 bits.
    /// Rules: E100L-MTAB-01
    #[unwind(26)]
    fn every_m_code_cites_a_rule() {
        let rules = m_rules(kani::any());
        kani::cover!(rules.as_slice().len() == 2, "two rules");
        assert!((1..=2).contains(&rules.as_slice().len()));
    }
}

refutations! {
    /// False: every M code of the table excludes others.
    #[unwind(27)]
    fn every_m_code_has_a_group() {
        let code: u16 = kani::any();
        assert!(m_code(code) != Status::Modelled || m_group(code).is_some());
    }

    /// False: two modelled G codes of different numbers may share a block.
    #[unwind(2)]
    fn g_codes_never_conflict() {
        let (one, other): (u8, u8) = (kani::any(), kani::any());
        kani::assume(one != other && g_group(one.into()).is_some());
        assert!(g_group(one.into()) != g_group(other.into()));
    }
}

//! The rules that motion events cite, as bits, and their sets.

use turnspec_oracle::vocabulary::{RuleId, RuleSet, rule_ids};

/// A set of rules that motion events cite, in two halves.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Cites {
    /// Rules of all motions.
    motion: u64,
    /// Rules of radius compensation and of the barriers.
    compensation: u64,
}

impl Cites {
    /// One rule, by the place of its bit.
    const fn one(bit: u8) -> Self {
        if bit < 64 {
            Self { motion: 1 << bit, compensation: 0 }
        } else {
            Self { motion: 0, compensation: 1 << (bit - 64) }
        }
    }

    /// The union.
    pub const fn and(self, other: Self) -> Self {
        Self { motion: self.motion | other.motion, compensation: self.compensation | other.compensation }
    }

    /// The set, with another one under a condition.
    pub const fn and_if(self, condition: bool, other: Self) -> Self {
        if condition { self.and(other) } else { self }
    }

    /// As a rule set.
    fn rules(self) -> RuleSet {
        let mut set = RuleSet::EMPTY;
        for (first, bits) in [(0, self.motion), (64, self.compensation)] {
            let mut rest = bits;
            while rest != 0 {
                set = set.with(TABLE[first + rest.trailing_zeros() as usize]);
                rest &= rest - 1;
            }
        }
        set
    }
}

macro_rules! cites {
    ($($name:ident)*) => {
        #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
        #[repr(u8)]
        enum Bit { $($name),* }
        /// The rules in the order of the bits, which is that of the catalogue.
        const TABLE: &[RuleId] = &[$(rule_ids::$name),*];
        $(
            pub const $name: Cites = Cites::one(Bit::$name as u8);
        )*
    };
}

cites! {
    LIM_01 CFEED_01 CFEED_03 COORD_03 INCH_02 ABS_01 ABS_02 ABS_03 DIA_01 G00_01 G01_01 G01_02 G01_04
    CIRC_01 CIRC_02 CIRC_03 CIRC_04 CIRC_05 CIRC_06 CIRC_08 CIRC_09 CIRC_10 CIRC_11 CIRC_12 CIRC_17 CIRC_18
    CIRC_19 CHAM_03 CHAM_11 CHAM_12 CHAM_13 ANG_01 ANG_02 ANG_03 ANG_04 ANG_05 ANG_06 TRQ_03 TRQ_04 SMAX_01
    FEED_01 FEED_02 FEED_03 CSS_01 CSS_04 CSS_05 CAX_05 CAX_06 DTAP_03 DTAP_05 NRC_07 NRC_11 NRC_14 NRC_15 NRC_18
    NRC_20 NRC_23 NRC_26 NRC_30 NRC_31 NRC_32 NRC_33 NRC_41 NRC_42 NRC_43 NRC_44 NRC_45 NRC_46 NRC_48 NRC_49 NRC_51
    NRC_52 NRC_60 NRC_62 NRC_63 NRC_66 NRC_69 NRC_71 BARR_01 BARR_08 MIRR_05 AX4_08
    LAP_07 LAP_16 LAPC_06
}

/// Remembers the sets made last, since one program uses few of them.
#[derive(Debug)]
pub struct CiteCache {
    entries: [(Cites, RuleSet); Self::SIZE],
}

impl CiteCache {
    const SIZE: usize = 64;

    /// The rule set of some citations.
    #[inline]
    pub fn rules(&mut self, cites: Cites) -> RuleSet {
        let folded = cites.motion ^ cites.compensation.rotate_left(29);
        let place = (folded.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 58) as usize;
        let entry = &mut self.entries[place];
        if entry.0 != cites {
            *entry = (cites, cites.rules());
        }
        entry.1
    }
}

impl Default for CiteCache {
    fn default() -> Self {
        Self { entries: [(Cites::default(), RuleSet::EMPTY); Self::SIZE] }
    }
}

#[cfg(test)]
mod tests {
    use super::{ABS_01, CiteCache, DTAP_05, TABLE};
    use turnspec_oracle::vocabulary::{RuleSet, rule_ids};

    #[test]
    fn bits_are_in_the_order_of_the_catalogue() {
        assert!(TABLE.is_sorted());
        assert!(TABLE.len() <= 128);
        let expected = RuleSet::of(&[rule_ids::DTAP_05, rule_ids::ABS_01]);
        assert_eq!(CiteCache::default().rules(ABS_01.and(DTAP_05)), expected);
    }
}

//! Which barriers are on, and which ones watch the motions of the block in progress (E100L-BARR-04).

use crate::engine::planted::{self, Bug};

/// The barriers, each a bit. At power-on none is on (E100L-BARR-05).
#[derive(Clone, Copy, Default, Debug)]
pub struct Watch {
    /// Those that are on now.
    on: u8,
    /// Those that are on before or after the M codes of the block in progress.
    block: u8,
}

const CHUCK: u8 = 1;
const TAILSTOCK: u8 = 2;

impl Watch {
    /// A block comes to its M codes.
    #[inline]
    pub fn begin_block(&mut self) {
        self.block = self.on;
    }

    /// M25 and M24, M21 and M20: a barrier on and off (E100L-MCODE-11, E100L-MCODE-09).
    pub fn switch(&mut self, code: u16) {
        match code {
            20 => self.on &= !TAILSTOCK,
            21 => self.on |= TAILSTOCK,
            24 => self.on &= !CHUCK,
            25 => self.on |= CHUCK,
            _ => {}
        }
        let before = if planted::is(Bug::OffBlockFree) { 0 } else { self.block };
        let after = if planted::is(Bug::OnBlockFree) { 0 } else { self.on };
        self.block = before | after;
    }

    /// Whether any barrier watches the block.
    #[inline]
    pub fn acts(self) -> bool {
        self.block != 0
    }

    /// Whether the chuck barrier watches the block.
    pub fn chuck(self) -> bool {
        self.block & CHUCK != 0
    }

    /// Whether the tailstock barrier watches the block.
    pub fn tailstock(self) -> bool {
        self.block & TAILSTOCK != 0
    }
}

#[cfg(test)]
mod tests {
    use super::Watch;

    #[test]
    fn the_blocks_of_both_codes_are_watched() {
        let mut watch = Watch::default();
        let mut block = |codes: &[u16]| {
            watch.begin_block();
            codes.iter().for_each(|code| watch.switch(*code));
            (watch.acts(), watch.chuck(), watch.tailstock())
        };
        assert_eq!(block(&[24, 20]), (false, false, false));
        assert_eq!(block(&[25]), (true, true, false));
        assert_eq!(block(&[24, 21]), (true, true, true));
        assert_eq!(block(&[]), (true, false, true));
        assert_eq!(block(&[20]), (true, false, true));
        assert_eq!(block(&[]), (false, false, false));
    }
}

//! Which sequence names a program has used (E100L-SEQ-03): one bit a name, on pages made when needed.

use super::arithmetic::sequence_name::index;

/// Names on a page.
const PAGE: usize = 4096;

/// The sequence names met so far.
#[derive(Debug, Default)]
pub struct Names {
    pages: Vec<Option<Box<[u64; PAGE / 64]>>>,
}

impl Names {
    /// Adds a valid name; false when it was there already.
    pub fn insert(&mut self, name: &[u8]) -> bool {
        let index = index(name);
        let (page, bit) = (index / PAGE, index % PAGE);
        if self.pages.len() <= page {
            self.pages.resize_with(page + 1, || None);
        }
        let Some(slot) = self.pages.get_mut(page) else { return true };
        let words = slot.get_or_insert_with(|| Box::new([0; PAGE / 64]));
        let Some(word) = words.get_mut(bit / 64) else { return true };
        let fresh = *word & 1 << (bit % 64) == 0;
        *word |= 1 << (bit % 64);
        fresh
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn names_are_strings() {
        let mut names = Names::default();
        for name in [b"1".as_slice(), b"01", b"001", b"A", b"A1", b"ZZZZZ"] {
            assert!(names.insert(name));
            assert!(!names.insert(name));
        }
    }
}

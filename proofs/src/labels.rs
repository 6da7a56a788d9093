//! Theorems about labels: names of any length are held in place, and no byte does harm.

use turnspec_oracle::vocabulary::Label;

#[cfg(stand_in)]
use crate::kani;

/// Most characters of a label.
const LENGTH: usize = 23;

theorems! {
    /// A label of any 28 bytes is the label of the first 23: nothing overflows.
    #[unwind(30)]
    fn a_long_name_is_cut() {
        let bytes: [u8; LENGTH + 5] = kani::any();
        assert!(Label::from_bytes(&bytes) == Label::from_bytes(&bytes[..LENGTH]));
    }

    /// A full label ignores every further character.
    #[unwind(26)]
    fn a_full_label_stays_as_it_is() {
        let bytes: [u8; LENGTH] = kani::any();
        let full = Label::from_bytes(&bytes);
        let mut more = full;
        more.push(kani::any());
        assert!(more == full);
    }

    /// A label with room changes with every character that is appended, whatever byte it is.
    #[unwind(26)]
    fn a_character_is_kept_while_there_is_room() {
        let (bytes, count): ([u8; LENGTH], u8) = (kani::any(), kani::any());
        let count = usize::from(count);
        kani::assume(count < LENGTH);
        kani::cover!(count == 0, "an empty label");
        kani::cover!(count == LENGTH - 1, "room for one character");
        let label = Label::from_bytes(&bytes[..count]);
        let mut more = label;
        more.push(kani::any());
        assert!(more != label && !more.is_empty());
        assert!(label.is_empty() == (count == 0));
    }

    /// A byte that is no visible ASCII character becomes a question mark; every other byte is kept.
    #[unwind(26)]
    fn invisible_bytes_become_question_marks() {
        let byte: u8 = kani::any();
        let label = Label::from_bytes(&[byte]);
        kani::cover!(byte > 0x7E, "not ASCII");
        kani::cover!(byte.is_ascii_graphic(), "visible");
        assert!((label == Label::from_bytes(b"?")) == (byte == b'?' || !byte.is_ascii_graphic()));
    }
}

refutations! {
    /// False: two labels of different bytes differ.
    #[unwind(26)]
    fn labels_tell_all_bytes_apart() {
        let (one, two): (u8, u8) = (kani::any(), kani::any());
        kani::assume(one != two);
        assert!(Label::from_bytes(&[one]) != Label::from_bytes(&[two]));
    }
}

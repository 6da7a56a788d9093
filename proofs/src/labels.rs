//! Theorems about labels: names of any length are held in place, and no byte does harm.

use turnspec_oracle::vocabulary::Label;

#[cfg(stand_in)]
use crate::kani;

/// Most characters of a label.
const LENGTH: usize = 24;

theorems! {
    /// A label of any 29 bytes is the label of the first 24: nothing overflows.
    /// Of: `Label::from_bytes`
    /// Assumes: 29 bytes.
    /// Rules: none (the form of the trace)
    #[unwind(31)]
    fn a_long_name_is_cut() {
        let bytes: [u8; LENGTH + 5] = kani::any();
        kani::cover!(bytes[LENGTH] != bytes[LENGTH - 1], "a byte that is cut differs from the last one kept");
        assert!(Label::from_bytes(&bytes) == Label::from_bytes(&bytes[..LENGTH]));
    }

    /// A full label ignores every further character.
    /// Of: `Label::push`
    /// Assumes: any bytes.
    /// Rules: none (the form of the trace)
    #[unwind(27)]
    fn a_full_label_stays_as_it_is() {
        let bytes: [u8; LENGTH] = kani::any();
        let full = Label::from_bytes(&bytes);
        kani::cover!(bytes[0] != bytes[1], "different characters");
        let mut more = full;
        more.push(kani::any());
        assert!(more == full);
    }

    /// A label with room changes with every character that is appended, whatever byte it is.
    /// Of: `Label::push`, `Label::is_empty`
    /// Assumes: any bytes, any length.
    /// Rules: none (the form of the trace)
    #[unwind(27)]
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
    /// Of: `Label::from_bytes`
    /// Assumes: any byte.
    /// Rules: none (the form of the trace)
    #[unwind(27)]
    fn invisible_bytes_become_question_marks() {
        let byte: u8 = kani::any();
        let label = Label::from_bytes(&[byte]);
        kani::cover!(byte > 0x7E, "not ASCII");
        kani::cover!(byte.is_ascii_graphic(), "visible");
        assert!((label == Label::from_bytes(b"?")) == (byte == b'?' || !byte.is_ascii_graphic()));
    }

    /// Labels tell all codes of at most three digits apart; a longer one counts as 999.
    /// Of: `Label::of_code`
    /// Assumes: any codes of 16 bits.
    /// Rules: E100L-GCODE-01, E100L-MCODE-01
    #[unwind(27)]
    fn labels_tell_codes_apart() {
        let (one, other): (u16, u16) = (kani::any(), kani::any());
        kani::cover!(one < 100 && other >= 100, "two and three digits");
        kani::cover!(one > 999, "four digits");
        let same = Label::of_code(b'G', one) == Label::of_code(b'G', other);
        assert!(same == (one.min(999) == other.min(999)));
        assert!(Label::of_code(b'M', one) != Label::of_code(b'G', one));
    }
}

refutations! {
    /// False: two labels of different bytes differ.
    #[unwind(27)]
    fn labels_tell_all_bytes_apart() {
        let (one, two): (u8, u8) = (kani::any(), kani::any());
        kani::assume(one != two);
        assert!(Label::from_bytes(&[one]) != Label::from_bytes(&[two]));
    }
}

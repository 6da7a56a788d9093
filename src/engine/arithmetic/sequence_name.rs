//! Numbers of sequence names (E100L-SEQ-01, E100L-SEQ-03): names are compared as text, and each text has its own.

/// Names of one to five digits.
const NUMERALS: usize = 111_110;

/// A number of its own for every name of one to five characters: all digits, or a letter and
/// alphanumerics.
/// Names of one value are different if their text is: N0123 and N123 (E100L-SEQ-04).
#[must_use]
pub fn index(name: &[u8]) -> usize {
    let digit = |byte: u8| usize::from(byte.wrapping_sub(b'0'));
    if name.first().is_none_or(u8::is_ascii_digit) {
        // Shorter numerals come first: 0 + 10 + 100 + ... of them.
        let before = [0, 0, 10, 110, 1110, 11_110][name.len().min(5)];
        return before + name.iter().fold(0, |value, byte| value * 10 + digit(*byte));
    }
    let rank = |byte: u8| {
        if byte.is_ascii_digit() { digit(byte) } else { usize::from(byte.wrapping_sub(b'A')) + 10 }
    };
    let shorter = [0, 0, 26, 962, 34_658, 1_247_714][name.len().min(5)];
    let first = name.first().map_or(0, |byte| rank(*byte) - 10);
    let rest = name.iter().skip(1).fold(first, |value, byte| value * 36 + rank(*byte));
    NUMERALS + shorter + rest
}

#[cfg(test)]
mod tests {
    use super::index;

    #[test]
    fn indices_are_compact_and_distinct() {
        assert_eq!(index(b"0"), 0);
        assert_eq!(index(b"9"), 9);
        assert_eq!(index(b"00"), 10);
        assert_eq!(index(b"99999"), 111_109);
        assert_eq!(index(b"A"), 111_110);
        assert_eq!(index(b"Z"), 111_135);
        assert_eq!(index(b"A0"), 111_136);
        assert_eq!(index(b"ZZ"), 111_110 + 26 + 936 - 1);
        assert_eq!(index(b"A00"), index(b"ZZ") + 1);
        assert_eq!(index(b"A000"), index(b"ZZZ") + 1);
        assert_eq!(index(b"A0000"), index(b"ZZZZ") + 1);
    }
}

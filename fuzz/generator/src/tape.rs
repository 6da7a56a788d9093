//! From seven-bit characters to the codes of the tape (E100L-TAPE-01): plain, ISO with even parity, EIA
//! (RS-244) with odd parity.

use std::collections::BTreeMap;

use turnspec_oracle::vocabulary::{ProgramText, TapeCode};

/// Stands in a text for a byte of wrong parity.
pub const WRONG_PARITY: u8 = 0xFF;

/// A byte of even parity, for characters that EIA lacks.
const UNCODED: u8 = 0x03;

/// The codes of `A` to `Z`.
const EIA_LETTERS: [u8; 26] = [
    0x61, 0x62, 0x73, 0x64, 0x75, 0x76, 0x67, 0x68, 0x79, 0x51, 0x52, 0x43, 0x54, 0x45, 0x46, 0x57, 0x58,
    0x49, 0x32, 0x23, 0x34, 0x25, 0x26, 0x37, 0x38, 0x29,
];

/// The codes of `0` to `9`.
const EIA_DIGITS: [u8; 10] = [0x20, 0x01, 0x02, 0x13, 0x04, 0x15, 0x16, 0x07, 0x08, 0x19];

/// The byte that ends a block.
#[must_use]
pub fn end_of_block(code: TapeCode) -> u8 {
    if code == TapeCode::Eia { 0x80 } else { b'\n' }
}

/// Encodes a text. Characters that EIA lacks become bytes of wrong parity, CR is left out there.
#[must_use]
pub fn encode(text: &[u8], code: TapeCode) -> Vec<u8> {
    match code {
        TapeCode::Ascii => text.to_vec(),
        TapeCode::Iso => text.iter().map(|byte| iso(*byte)).collect(),
        TapeCode::Eia => text.iter().filter(|byte| **byte != b'\r').map(|byte| eia(*byte)).collect(),
    }
}

/// The library of a set-up, from texts.
#[must_use]
pub fn library(texts: Vec<(String, Vec<u8>)>, code: TapeCode) -> BTreeMap<String, ProgramText> {
    texts.into_iter().map(|(name, text)| (name, ProgramText(encode(&text, code)))).collect()
}

/// Decodes a tape to seven-bit characters; bytes of wrong parity become an illegal character.
#[must_use]
pub fn decode(program: &[u8], code: TapeCode) -> Vec<u8> {
    let plain = |byte: u8| match code {
        TapeCode::Ascii => Some(byte),
        TapeCode::Iso if byte.count_ones() % 2 == 1 => Some(WRONG_PARITY),
        TapeCode::Iso => Some(byte & 0x7F),
        TapeCode::Eia if byte == 0 => None,
        TapeCode::Eia if byte == UNCODED => Some(WRONG_PARITY),
        TapeCode::Eia => Some((0..0x80).find(|character| eia(*character) == byte).unwrap_or(WRONG_PARITY)),
    };
    program.iter().filter_map(|byte| plain(*byte)).collect()
}

fn iso(byte: u8) -> u8 {
    match byte {
        WRONG_PARITY => 0x01,
        byte if (byte & 0x7F).count_ones() % 2 == 1 => byte | 0x80,
        byte => byte & 0x7F,
    }
}

fn eia(byte: u8) -> u8 {
    match byte {
        b'A'..=b'Z' => EIA_LETTERS[usize::from(byte - b'A')],
        b'0'..=b'9' => EIA_DIGITS[usize::from(byte - b'0')],
        b' ' => 0x10,
        b'\n' => 0x80,
        b'\t' => 0x3E,
        0x08 => 0x2A,
        0x7F => 0x7F,
        b'%' => 0x0B,
        b'(' => 0x1A,
        b')' => 0x4A,
        b'+' => 0x70,
        b'-' => 0x40,
        b'/' => 0x31,
        b'.' => 0x6B,
        b',' => 0x3B,
        b'&' => 0x0E,
        _ => UNCODED,
    }
}

#[cfg(test)]
mod tests {
    use super::{EIA_DIGITS, EIA_LETTERS, decode, encode};
    use turnspec_oracle::vocabulary::TapeCode;

    #[test]
    fn eia_codes_have_odd_parity_and_iso_codes_even_parity() {
        let codes = EIA_LETTERS.iter().chain(&EIA_DIGITS);
        assert!(codes.clone().all(|code| code.count_ones() % 2 == 1));
        let distinct: std::collections::BTreeSet<_> = codes.collect();
        assert_eq!(distinct.len(), 36);
        assert_eq!(encode(b"1C\r", TapeCode::Iso), [0xB1, 0xC3, 0x8D]);
    }

    #[test]
    fn what_was_encoded_is_decoded() {
        let text = b"N1 G01 X-5.3 (A,B)\n/M02 &%";
        for code in [TapeCode::Ascii, TapeCode::Iso, TapeCode::Eia] {
            assert_eq!(decode(&encode(text, code), code), text);
        }
    }
}

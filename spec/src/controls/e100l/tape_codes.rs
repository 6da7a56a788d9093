//! E100L-TAPE-01: the EIA code (RS-244, odd parity), and the parity of the ISO code.

/// What stands at each EIA code; the other codes have wrong parity or no character.
const EIA: &[(u8, &[u8])] = &[
    (b' ', &[0x10]),
    (b'\n', &[0x80]),
    (b'\t', &[0x3E]),
    (0x08, &[0x2A]),
    (0x7F, &[0x7F, 0x00]),
    (b'%', &[0x0B]),
    (b'(', &[0x1A]),
    (b')', &[0x4A]),
    (b'+', &[0x70]),
    (b'-', &[0x40]),
    (b'/', &[0x31]),
    (b'.', &[0x6B]),
    (b',', &[0x3B]),
    (b'&', &[0x0E]),
];

const EIA_DIGITS: [u8; 10] = [0x20, 0x01, 0x02, 0x13, 0x04, 0x15, 0x16, 0x07, 0x08, 0x19];

const EIA_LETTERS: [u8; 26] = [
    0x61, 0x62, 0x73, 0x64, 0x75, 0x76, 0x67, 0x68, 0x79, 0x51, 0x52, 0x43, 0x54, 0x45, 0x46, 0x57, 0x58,
    0x49, 0x32, 0x23, 0x34, 0x25, 0x26, 0x37, 0x38, 0x29,
];

/// The character of an EIA code.
pub fn from_eia(byte: u8) -> Option<u8> {
    let place =
        |table: &[u8]| table.iter().position(|code| *code == byte).and_then(|index| u8::try_from(index).ok());
    if let Some((character, _)) = EIA.iter().find(|(_, codes)| codes.contains(&byte)) {
        return Some(*character);
    }
    place(&EIA_DIGITS).map(|digit| b'0' + digit).or_else(|| place(&EIA_LETTERS).map(|letter| b'A' + letter))
}

/// The character of an ISO code, whatever its parity.
pub fn from_iso(byte: u8) -> u8 {
    byte & 0x7F
}

/// Whether an ISO code has even parity.
pub fn iso_parity_holds(byte: u8) -> bool {
    byte.count_ones().is_multiple_of(2)
}

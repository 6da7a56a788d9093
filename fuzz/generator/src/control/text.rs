//! Lines of text that never run, names of programs and of files.

/// Lines that a name is looked for behind.
pub(super) const DEAD: &[&[u8]] = &[
    b"G00 X5",
    b"M02",
    b"G05 NONSENSE ))",
    b"M08 (OPEN",
    b"N GOTO",
    b"N123456 X5",
    b"N1A2B3C X5",
    b"/ G01 Z=V0",
    b"RTS",
    b"X=1/0",
    b"%",
    b"",
    b"\xFF BAD PARITY",
    b"(ONLY A REMARK)",
    b"//N55 X5",
    b"CALL O404",
    b"G00 X1\n$ N4711 X2",
    b"X(A) N99",
    b"IF [1 EQ 1] N98",
    b"M100",
];

/// Those that EIA has the characters for.
pub(super) const DEAD_EIA: &[&[u8]] = &[
    b"G00 X5",
    b"M02",
    b"G05 NONSENSE ))",
    b"N GOTO",
    b"N123456 X5",
    b"RTS",
    b"%",
    b"",
    b"CALL O404",
    b"M100",
];

/// Names of programs, without the `O`; some are equal as numbers only.
pub(super) const PROGRAMS: &[&str] = &[
    "1000", "2000", "77", "077", "PULL", "SUB1", "GRV", "Z", "A1B2", "0", "00", "IF", "RTS", "N1", "9999",
    "V5",
];

/// File names of the library.
pub(super) const FILES: &[&str] =
    &["PULL.SUB", "A.SSB", "MAKER-1.MSB", "SHAFT.MIN", "X1.SUB", "ABCDEFGHIJKLMNOP.SUB", "Z-9.SSB"];

/// Headers of library files, which are passed over.
pub(super) const HEADERS: &[&[u8]] =
    &[b"$PULL.SUB%", b"$A.SSB%", b"$DAY1.SDF%", b"$ NO HEADER", b"$\xFF%", b"$"];

/// What stands before the first name block of a library file.
pub(super) const BEFORE: &[&[u8]] = &[b"G00 X5", b"%", b"(LIBRARY)", b"N1 ))", b"RTS", b"", b"\xFF"];

/// Programs that nothing calls.
pub(super) const OTHERS: &[&[u8]] = &[
    b"OLIB\nG00 X=1/0\nRTS",
    b"O1A\nRTS",
    b"O(NO NAME)\nM02",
    b":3\nN1 X5\nN1 X6\nRTS",
    b"O12345\nRTS",
    b"OLIB2 (A)\n%",
];

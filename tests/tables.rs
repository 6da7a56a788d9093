//! Exhaustive comparisons of what the oracle and the engine know: every G and M code, every address, every
//! system variable, every character.

#![allow(clippy::panic)]

use turnspec_oracle::vocabulary::{Setup, TapeCode};

/// Runs a program through both and fails on the first difference.
fn agree(program: &[u8], setup: &Setup) {
    if let Err(disagreement) = turnspec::differential::compare(program, setup) {
        panic!("{}\n{disagreement}", String::from_utf8_lossy(program));
    }
}

fn agree_on_text(program: &str) {
    agree(program.as_bytes(), &Setup::default());
}

#[test]
fn every_g_code() {
    for code in 0..=1000 {
        agree_on_text(&format!("F1\nG={code}\nG={code} X1 Z2 L1 K3 S5 PZ=4\nX5\nM02\n"));
    }
}

#[test]
fn every_pair_of_modelled_g_codes() {
    const CODES: [u16; 27] = [
        0, 1, 2, 3, 4, 13, 17, 18, 22, 28, 29, 40, 41, 42, 50, 64, 65, 75, 76, 90, 91, 94, 95, 96, 97, 110,
        119,
    ];
    for first in CODES {
        for second in CODES {
            agree_on_text(&format!("F1 G{first} G{second} S100\nX10 Z5\nG{second} X3 L1 F2\nZ10\nM30\n"));
        }
    }
}

#[test]
fn every_m_code_alone_and_with_motion() {
    for code in 0..=512 {
        agree_on_text(&format!("M={code}\nG00 X1 M={code}\nM02\n"));
    }
}

#[test]
fn every_pair_of_m_codes() {
    for first in 0..=511 {
        for second in 0..=511 {
            agree_on_text(&format!("M={first} M={second}\nM02\n"));
        }
    }
}

#[test]
fn every_address_with_boundary_values() {
    let letters = (b'A'..=b'Z').map(|letter| char::from(letter).to_string());
    let extended = ["SB", "SA", "QA", "PZ", "PW", "XA", "AA", "BC", "CALRG", "DIA1"].map(str::to_owned);
    let values = [
        "0",
        "1",
        "-1",
        "0.0005",
        "-0.0005",
        "99999.999",
        "99999999",
        "100000",
        "65535",
        "65536",
        "20.001",
        "359.999",
        "360",
        "1999",
    ];
    for address in letters.chain(extended) {
        for value in values {
            for head in ["", "G01 F1 ", "G02 F1 ", "G04 ", "G22 F1 PZ=5 D1 ", "G50 ", "G75 G01 F1 "] {
                agree_on_text(&format!("{head}{address}={value}\nM02\n"));
                agree_on_text(&format!("{head}{address}{value}\nM02\n"));
            }
        }
    }
}

#[test]
fn every_name_of_a_system_variable() {
    let table = include_str!("../spec/rules/e100l/variables.md");
    let words = table.split(|c: char| !c.is_ascii_alphanumeric());
    let names: std::collections::BTreeSet<&str> =
        words.filter(|word| word.starts_with('V') && word.len() > 2).collect();
    assert!(names.len() > 170, "the table of system variables was not found");
    for name in names {
        for suffix in ["", "[1]", "[0]", "[33]", "[120]", "[1.5]"] {
            agree_on_text(&format!("V1={name}{suffix}\nM02\n"));
            for value in ["1", "0", "-1.0005", "99999.999", "100000"] {
                agree_on_text(&format!(
                    "T000101\n{name}{suffix}={value}\nV1={name}{suffix}\nG00 X1 Z1\nM02\n"
                ));
            }
        }
    }
}

#[test]
fn every_character_in_every_code() {
    for code in [TapeCode::Ascii, TapeCode::Iso, TapeCode::Eia] {
        let mut setup = Setup::default();
        setup.tape.code = code;
        for byte in 0..=255 {
            for (head, tail) in
                [("", ""), ("G", "0"), ("X1", "2"), ("(", ")"), ("V1=", "1"), ("V1=1 ", " 2"), ("N1", "X1")]
            {
                let program = [head.as_bytes(), &[byte], tail.as_bytes(), b"\nM02\n"].concat();
                agree(&program, &setup);
            }
        }
    }
}

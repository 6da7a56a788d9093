//! Exhaustive comparisons of what the oracle and the engine know: every G and M code, every address, every
//! system variable, every character.

#![allow(clippy::panic)]

use turnspec_oracle::vocabulary::{BalancedInfeed, FeedLength, Setup, TapeCode, TaperReference, ThreadFlank};

/// The modelled G codes.
const CODES: [u16; 36] = [
    0, 1, 2, 3, 4, 13, 14, 17, 18, 22, 28, 29, 31, 32, 33, 34, 35, 40, 41, 42, 50, 64, 65, 71, 72, 75, 76,
    90, 91, 94, 95, 96, 97, 110, 111, 119,
];
/// Those of them that cut threads.
const THREADS: [u16; 7] = [31, 32, 33, 34, 35, 71, 72];

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
    for first in CODES {
        for second in CODES {
            agree_on_text(&format!("F1 G{first} G{second} S100\nX10 Z5\nG{second} X3 L1 F2\nZ10\nM30\n"));
        }
    }
}

#[test]
fn every_g_code_beside_and_between_threads() {
    for thread in THREADS {
        let data = if matches!(thread, 71 | 72) { " D1 H2" } else { "" };
        let thread = format!("G{thread} X-10 Z-20{data}");
        for code in CODES {
            agree_on_text(&format!("F1\n{thread} G{code} S100\nX-5 Z-9\nM02\n"));
            agree_on_text(&format!("F1\n{thread}\nX-8 C90\nG{code} S100\nX-9 Z-12 L1\n{thread}\nM02\n"));
            agree_on_text(&format!("F1 G{code} S100\n{thread}\nJ2\nZ-7 A170\nM02\n"));
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
fn every_m_code_beside_and_between_threads() {
    for code in 0..=511 {
        for thread in THREADS {
            let data = match thread {
                71 | 72 => " D1 H2 B60 L1",
                34 | 35 => " E0.01",
                _ => " L1",
            };
            let thread = format!("G{thread} X-10 Z-20{data}");
            agree_on_text(&format!("F1 S1000 M03\n{thread} M={code}\n{thread}\nM02\n"));
            agree_on_text(&format!("F1 S1000 M03\nM={code}\n{thread} M23\nX-9 M={code}\nM02\n"));
        }
    }
}

/// The codes of a compound cycle, in every reading.
#[test]
fn every_flank_pattern_and_chamfer_of_a_thread() {
    let readings = |bits: u32| {
        let is = |bit: u32| bits >> bit & 1 == 1;
        let mut setup = Setup::default();
        setup.parameters.m75_pattern = if is(0) { 4 } else { 3 };
        let readings = &mut setup.readings;
        readings.balanced_infeed = if is(1) { BalancedInfeed::EqualArea } else { BalancedInfeed::Refused };
        readings.taper_reference = if is(2) { TaperReference::End } else { TaperReference::Start };
        readings.thread_flank = if is(3) { ThreadFlank::Positive } else { ThreadFlank::Negative };
        readings.feed_length = if is(4) { FeedLength::Diameter } else { FeedLength::Radius };
        setup
    };
    for setup in (0..32).map(readings) {
        for infeed in 32..=34 {
            for pattern in 73..=75 {
                for chamfer in 22..=23 {
                    for words in ["G71 I0.5 U0.1", "G71 A179 Q2", "G72 K-0.5 W0.5", "G72 A91 E0.1"] {
                        let words = format!("{words} X-10 Z-20 D0.7 H2 B60 M{infeed} M{pattern} M{chamfer}");
                        let program = format!("F1.5 S1000 M03\n{words}\nG91 {words}\nM02\n");
                        agree(program.as_bytes(), &setup);
                    }
                }
            }
        }
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
        "9999",
        "1.5",
        "179.999",
        "180",
    ];
    let heads = [
        "",
        "G01 F1 ",
        "G02 F1 ",
        "G04 ",
        "G22 F1 PZ=5 D1 ",
        "G50 ",
        "G75 G01 F1 ",
        "G33 Z-9 F1 ",
        "G33 X-9 F1 M23 S9 M03 ",
        "G32 X-9 Z-9 F1 M23 S9 M03 ",
        "G34 F1 ",
        "G35 X-9 Z-9 F1 ",
        "G71 X-9 Z-9 F1 D1 H1 M74 ",
        "G71 X-9 Z-9 D1 M74 M23 ",
        "G72 X-9 Z-9 F1 H0.05 M75 ",
        "G72 X-9 F1 D1 H1 M74 ",
    ];
    for address in letters.chain(extended) {
        for value in values {
            for head in heads {
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

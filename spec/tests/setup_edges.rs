//! What a set-up may say, at the edges of each field: the last value that is accepted and the first that is refused.

#![allow(clippy::panic)]

use turnspec_oracle::vocabulary::notation::Expectation;
use turnspec_oracle::vocabulary::{Event, Setup};

fn set_up(text: &str) -> Setup {
    Setup::from_toml(text).unwrap_or_else(|fault| panic!("{text}\n{fault}"))
}

/// Refused, and the message names the field.
fn refused(text: &str, field: &str) {
    match Setup::from_toml(text) {
        Ok(_) => panic!("accepted: {text}"),
        Err(fault) => assert!(fault.message.contains(field), "{text}\n{fault}"),
    }
}

/// Accepts `good` and refuses `bad`; each is put in for the `@` of the text.
fn divides(text: &str, field: &str, good: &[&str], bad: &[&str]) {
    good.iter().for_each(|each| drop(set_up(&text.replace('@', each))));
    bad.iter().for_each(|each| refused(&text.replace('@', each), field));
}

/// MACRO-01: G161 to G171 and G205 to G214. MACRO-02: M321 to M325 and M341 to M360. The key is the code as the rules
/// write it, without leading zeros.
#[test]
fn a_macro_code_is_one_of_the_two_tables() {
    divides(
        "[macros]\n@ = 'O1'",
        "is no macro code",
        &["G161", "G171", "G205", "G214", "M321", "M325", "M341", "M360"],
        &[
            "G160", "G172", "G204", "G215", "M320", "M326", "M340", "M361", "G0161", "M0321", "G100", "M100",
            "M161", "T161", "G", "G16",
        ],
    );
}

/// NAME-01: `O([A-Z][A-Z0-9]{0,3}|[0-9]{1,4})`.
#[test]
fn a_macro_calls_a_program_name() {
    divides(
        "[macros]\nG171 = '@'",
        "is no program name",
        &["O1", "O0123", "OA", "OSH12", "OABCD", "O9999", "OZ9"],
        &[
            "", "O", "1000", "P1", "O12345", "OABCDE", "OSH123", "O1A", "O12A4", "OA-1", "OA_B", "O1-2",
            "Oab", "O-", "O%",
        ],
    );
}

/// PROG-05 and SDF-07: the name begins with a letter and has at most 16 letters, digits or hyphens; the extension has three
/// letters or digits.
#[test]
fn a_file_name_is_a_name_and_an_extension() {
    divides(
        "[library]\n'@' = 'M02'",
        "is no file name",
        &["A.SUB", "PULL.SUB", "SHAFT-A.MIN", "P-.1A2", "ABCDEFGHIJKLMN-9.999"],
        &[
            "PULL",
            "PULL.",
            ".SUB",
            "1PULL.SUB",
            "-PULL.SUB",
            "ABCDEFGHIJKLMNOPQ.SUB",
            "1BCDEFGHIJKLMNOPQ.SUB",
            "Pull.SUB",
            "PULL_A.SUB",
            "PULL A.SUB",
            "A.B.SUB",
            "PULL.SU",
            "PULL.SUBS",
            "PULL_A.SU",
            "PULL.S-B",
            "PULL.SuB",
            "PULL.sub",
            "PULL.S_B",
        ],
    );
}

/// SVAR-14: the suffix is the number of a tool, up to `options.tools`, or of a tool group, up to `options.tool_groups`,
/// without sign, blank or leading zero, as `VTLL[3]`.
#[test]
fn interference_data_has_the_suffix_of_its_kind() {
    let text = "[options]\ntools = 20\ntool_groups = 24\n[system_variables]\n'@' = 1";
    let tools = ["VTLIN", "VTLFN", "VTLA1", "VTLA2", "VTLL", "VTLD", "VTLW"];
    let points = ["VTIZN", "VTIZP", "VTIXN", "VTIXP", "VTIPN"];
    for name in tools.into_iter().chain(points) {
        divides(
            text,
            "system_variables",
            &[&format!("{name}[1]"), &format!("{name}[20]")],
            &[&format!("{name}[0]"), &format!("{name}[21]"), name],
        );
    }
    for kind in ["IN", "FN", "A1", "A2", "L", "D", "W"] {
        let name = format!("VGR{kind}");
        divides(
            text,
            "system_variables",
            &[&format!("{name}[1]"), &format!("{name}[24]")],
            &[&format!("{name}[25]")],
        );
    }
    let forms = [
        "VTLL[03]",
        "VTLL[+3]",
        "VTLL[-3]",
        "VTLL[ 3]",
        "VTLL[]",
        "VTLL[3.]",
        "VTLL[256]",
        "VTLL 3]",
        "VTLL[3",
    ];
    divides(text, "is no variable with a number in brackets", &["VTLL[3]"], &forms);
    // The pattern number belongs to the interference points, which tool groups do not have, and points are nothing else.
    let others = [
        "VTLPN[1]", "VGRPN[1]", "VGRZN[1]", "VTLZN[1]", "VTIL[1]", "VTIIN[1]", "VTIA1[1]", "VTL[1]",
        "VZOFX[1]",
    ];
    divides(text, "is no tool interference data", &["VTIPN[1]"], &others);
}

/// The ranges of SVAR-14, in steps of 0.001, the plain numbers whole; and 0, the value of what is not set, of the
/// classification code too.
#[test]
fn interference_data_has_its_range() {
    let plain = |names: &[&str], good: &[&str], bad: &[&str]| {
        for name in names {
            divides(&format!("[system_variables]\n'{name}[2]' = @"), "cannot be", good, bad);
        }
    };
    plain(&["VTLIN", "VGRIN"], &["0", "1", "38"], &["-1", "39", "0.5", "1.5", "37.999"]);
    plain(&["VTLFN", "VGRFN"], &["0", "1", "4"], &["-1", "5", "3.5"]);
    plain(&["VTIPN"], &["0", "1", "2"], &["-1", "3", "1.5"]);
    plain(&["VTLA1", "VGRA1"], &["0", "0.001", "360"], &["-1", "-0.001", "360.001", "361", "0.0001"]);
    plain(
        &["VTLA2", "VGRA2"],
        &["-360", "-0.5", "0", "360"],
        &["-360.001", "-361", "360.001", "361", "0.0001"],
    );
    let sizes = ["VTLL", "VGRL", "VTLD", "VGRD", "VTLW", "VGRW", "VTIZN", "VTIZP", "VTIXN", "VTIXP"];
    plain(&sizes, &["0", "0.001", "9999.999"], &["-1", "-0.001", "10000", "0.0001"]);
}

/// IOV-01 and the table of execution-io.md: which inputs there are, and lists of their values that are not empty.
#[test]
fn an_input_has_a_list_of_its_values() {
    let text = "[inputs.vdin]\n@";
    divides(
        text,
        "inputs.vdin",
        &[
            "1 = [0, 1]",
            "10 = [0, 31]",
            "38 = [1]",
            "1004 = [0, 2147483647]",
            "1235 = [0, 255]",
            "1250 = [255]",
        ],
        &[
            "1 = []",
            "1 = [2]",
            "1 = [0, -1]",
            "1 = [2, 0]",
            "10 = []",
            "10 = [32]",
            "1000 = [-1]",
            "1250 = [256]",
        ],
    );
    let missing = ["0", "9", "19", "20", "25", "30", "39", "999", "1005", "1234", "1251"];
    divides(
        text,
        "is no number of an input",
        &["8 = [0]"],
        &missing.map(|number| format!("{number} = [0]")).each_ref().map(String::as_str),
    );
}

/// IORD-01: the suffix is 0 to 9999, a value 0 or 1; the list is not empty.
#[test]
fn an_io_bit_has_a_list_of_zeros_and_ones() {
    for name in ["vird", "vord"] {
        divides(
            &format!("[inputs.{name}]\n@"),
            &format!("inputs.{name}"),
            &["0 = [0]", "9999 = [1, 0]"],
            &["10000 = [0]", "10000 = []", "10000 = [2]", "1 = []", "1 = [2]", "1 = [0, 2, 1]"],
        );
    }
}

/// The table of execution-io.md: an address has no leading zeros; a number has one text, so that no list replaces another.
#[test]
fn the_number_of_an_input_has_one_text() {
    for name in ["vdin", "vird", "vord"] {
        for key in ["017", "+17", "-17", "", "1.7", "\u{661}7", "65536"] {
            refused(
                &format!("[inputs.{name}]\n17 = [0]\n\"{key}\" = [1]\n"),
                "without sign and leading zeros",
            );
        }
    }
    let setup = set_up("[inputs]\nvird = { 17 = [0], 0 = [1] }\nvdin = { 17 = [1] }\n");
    assert_eq!(
        (&setup.inputs.vird[&17], &setup.inputs.vird[&0], &setup.inputs.vdin[&17]),
        (&vec![0], &vec![1], &vec![1])
    );
}

/// GOTO-03: at least 1.
#[test]
fn a_run_has_a_step_at_least() {
    divides("[limits]\nsteps = @", "limits.steps", &["1"], &["0"]);
}

/// SVAR-07 and LIM-01: machine coordinates, 0 to ±99999.999, in steps of 0.001, one alone or both in order; on turret B
/// as on A.
#[test]
fn a_travel_limit_is_a_coordinate() {
    for axis in ["limits.x", "limits.z", "limits.w", "turret_b.limits.x", "turret_b.limits.z"] {
        for side in ["positive", "negative"] {
            divides(
                &format!("[{axis}]\n{side} = @"),
                &format!("{axis}: "),
                &["99999.999", "-99999.999", "0.001"],
                &["100000", "-100000", "0.0001", "99999.9999"],
            );
        }
        divides(&format!("[{axis}]\npositive = 5\nnegative = @"), axis, &["4.999", "5"], &["5.001"]);
    }
}

/// "Form, default and range of each field are those of the field with the same name outside" (execution-turrets.md), there
/// those of SVAR-03.
#[test]
fn turret_b_has_the_ranges_of_turret_a() {
    for table in ["start", "zero_offset"] {
        for (name, axis) in ["x", "z"]
            .into_iter()
            .flat_map(|axis| [(table.to_owned(), axis), (format!("turret_b.{table}"), axis)])
        {
            divides(
                &format!("[{name}]\n{axis} = @"),
                &format!("{name}.{axis} is"),
                &["99999.999", "-99999.999", "0.001"],
                &["100000", "-100000", "0.0001"],
            );
        }
    }
}

/// A machine coordinate is the program coordinate, within 99999.999, and the zero offset, within 99999.999 too (COORD-03):
/// G22 is stopped at 150000 (TRQ-04), in front of which it goes to 5 mm before its end.
#[test]
fn a_torque_stop_is_a_machine_coordinate() {
    let setup = set_up("zero_offset = { z = 99900 }\ninputs.torque_stops = [150000]");
    let program = "G00 Z50050\nG94 G22 Z50100 D5 L10 F1000 PZ=25\nM02\n";
    let mut trace: Vec<Event> = Vec::new();
    turnspec_oracle::run(program.as_bytes(), &setup, &mut |event: &Event| trace.push(*event));
    let expected = "...\nlinear z=50095 mz=149995\nlinear z=50100 mz=150000\n...\nend code=M02";
    if let Err(divergence) = Expectation::parse(expected).matches(&trace) {
        panic!("{divergence}");
    }
    for field in ["inputs", "turret_b"] {
        divides(
            &format!("[{field}]\ntorque_stops = [@]"),
            field,
            &["199999.998", "-199999.998"],
            &["300000", "-300000"],
        );
    }
}

/// A speed is 0 to 65535 (SPD-01), and the lowest one is not above the highest (CSS-04).
#[test]
fn a_speed_range_is_in_order_within_the_speeds() {
    for table in ["[spindle]", "[[spindle.gear]]"] {
        for (good, bad) in [
            ("minimum = 0\nmaximum = 65535", "minimum = 0\nmaximum = 65536"),
            ("minimum = 0\nmaximum = 10", "minimum = -1\nmaximum = 10"),
            ("minimum = 10\nmaximum = 10", "minimum = 10.001\nmaximum = 10"),
            ("minimum = 65535\nmaximum = 65535", "minimum = 65536\nmaximum = 65536"),
            ("minimum = 0\nmaximum = 0", "minimum = -2\nmaximum = -1"),
        ] {
            divides(&format!("{table}\n@"), "spindle: the range", &[good], &[bad]);
        }
    }
}

/// The words of a fault are its text.
#[test]
fn a_fault_shows_its_message() {
    let fault = Setup::from_toml("[start]\nx = 100000").err().unwrap_or_else(|| panic!("accepted"));
    assert_eq!(fault.to_string(), fault.message);
    assert!(fault.to_string().contains("start.x is 100000"));
}

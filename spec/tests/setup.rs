//! Set-up files: what runs, and what is refused with which words.

#![allow(clippy::panic)]

use turnspec_oracle::vocabulary::{Chamfering, Length, Setup, UnitSystem};

fn refused(text: &str, because: &str) {
    match Setup::from_toml(text) {
        Ok(_) => panic!("accepted: {text}"),
        Err(fault) => assert!(fault.message.contains(because), "{text}\n{fault}"),
    }
}

#[test]
fn an_empty_set_up_is_the_default() {
    assert_eq!(Setup::from_toml("").as_ref(), Ok(&Setup::default()));
}

#[test]
fn values_are_exact_decimals() {
    let setup = Setup::from_toml(
        "unit_system = '1um'\n[start]\nx = 0.1\nz = '-12.345'\n[parameters]\nchamfering = 'basic'",
    );
    let setup = setup.unwrap_or_else(|fault| panic!("{fault}"));
    assert_eq!((setup.start.x, setup.start.z), (Length(100_000), Length(-12_345_000)));
    assert_eq!((setup.unit_system, setup.parameters.chamfering), (UnitSystem::Micrometre, Chamfering::Basic));
}

#[test]
fn faults_are_named() {
    refused("[start", "TOML parse error");
    refused("colour = 1", "unknown field `colour`");
    refused("[start]\ny = 1", "unknown field `y`");
    refused("[start]\nx = true", "a number of millimetres");
    refused("[start]\nx = 'far'", "a number of millimetres");
    refused("[start]\nx = 1e300", "a number of millimetres");
    refused("[start]\nx = nan", "a number of millimetres");
    refused("[start]\nx = 100000", "start.x is 100000");
    refused("[start]\nx = 0.0001", "finer than 0.001");
    refused("[barriers]\ngrip_length = -1", "barriers: sizes");
    refused("[barriers]\ngrip_length = 10000", "barriers: sizes");
    refused("[barriers]\nchuck_x = 10000", "barriers: sizes");
    refused("[options]\noffset_sets = 33", "must be 32, 64 or 96");
    refused("[options]\nuser_task = 3", "must be 1 or 2");
    refused("[limits.x]\npositive = 1\nnegative = 2", "lies below the negative limit");
    refused("[[tool_offset]]\nnumber = 33", "outside 1 to 32");
    refused("[[tool_offset]]\nnumber = 1\n[[tool_offset]]\nnumber = 1", "appears twice");
    refused("[[tool_offset]]\nnumber = 1\nx = 1000", "within 999.999");
    refused("[[spindle.gear]]\ncode = 45", "one of 40 to 44");
    refused("[[spindle.gear]]\ncode = 41\nminimum = 10\nmaximum = 5", "must be in order");
    refused("[stm]\nlimit = 600.1", "must be 0 to 600");
    refused("[parameters]\ntorque_limit_upper = 0", "must be 1 to 100");
    refused("[variables]\nV201 = 1.0", "not one of V1 to V200");
    refused("[variables]\nV1 = inf", "not finite");
    refused("[readings]\nchamfer_leg = 'both'", "unknown variant `both`");
}

//! Every property on the bytes of seeds, on bytes of every kind, and on every kept input.
//!
//! `TURNSPEC_PROPERTY_SEEDS` sets how many seeds are tried for each property (60 by default).

#![allow(clippy::panic)]

use proptest::prelude::*;
use turnspec_properties::{PROPERTIES, Property, bytes_of_seed, property};

fn seeds() -> u64 {
    let variable = std::env::var("TURNSPEC_PROPERTY_SEEDS").ok();
    variable.and_then(|text| text.parse().ok()).unwrap_or(60)
}

fn on_seeds(name: &str) {
    let Property { holds, .. } = property(name).unwrap_or_else(|| panic!("no property {name}"));
    for seed in 0..seeds() {
        let length = if seed % 4 == 0 { 300 } else { 6_000 };
        if let Err(message) = holds(&bytes_of_seed(seed, length)) {
            panic!("seed {seed}: {message}");
        }
    }
}

macro_rules! each_on_seeds {
    ($($name:ident)*) => {
        $(#[test] fn $name() { on_seeds(stringify!($name)); })*

        #[test]
        fn no_property_is_left_out() {
            let names: Vec<&str> = PROPERTIES.iter().map(|property| property.name).collect();
            assert_eq!(names, [$(stringify!($name)),*]);
        }
    };
}

each_on_seeds! {
    structured raw parse round_trip setup trace expression termination perturbation threads contours lap cycles metamorphic
}

/// Bytes that make up programs and set-ups, and some that do not belong there.
fn text() -> impl Strategy<Value = Vec<u8>> {
    let common =
        b"GGGMMXXZZIKLFSTNOVAC0123456789..--=\n\n\n/()[]+*,$% \t\rSINATANDROUNDEQMOD'\"{}:_x".to_vec();
    let byte = prop_oneof![20 => prop::sample::select(common), 1 => any::<u8>()];
    prop::collection::vec(byte, 0..300)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_property_holds_on_text(zeros in prop::sample::select(vec![0_usize, 32]), text in text()) {
        let mut input = vec![0; zeros];
        input.extend(text);
        for Property { name, holds } in PROPERTIES {
            prop_assert!(holds(&input).is_ok(), "{}: {:?}", name, holds(&input));
        }
    }
}

//! The values of set-ups and events as JSON and as text for people; labels and sets of rules.

use turnspec_oracle::vocabulary::{
    Angle, Duration, FeedRate, Label, Length, ProgramText, Reading, ReadingSet, RuleId, RuleSet, Setup,
    Speed, Text,
};

/// A number or decimal text, in the usual unit (the schema of a set-up); whole numbers that JSON writes without sign too.
#[test]
fn a_quantity_of_json_is_a_number_or_text() {
    for (json, millimetres) in [("12", 12), ("0", 0), ("-12", -12), ("12.0", 12), ("\"12\"", 12)] {
        let length = serde_json::from_str::<Length>(json).ok();
        assert_eq!(length, Some(Length(millimetres * 1_000_000)), "{json}");
    }
    assert_eq!(serde_json::from_str::<Angle>("360").ok(), Some(Angle(360_000_000)));
    assert_eq!(serde_json::from_str::<Speed>("65535").ok(), Some(Speed(65_535_000)));
    assert_eq!(serde_json::from_str::<Duration>("600").ok(), Some(Duration(600_000_000)));
    assert_eq!(serde_json::from_str::<FeedRate>("3").ok(), Some(FeedRate(3_000_000_000)));
    let setup = serde_json::from_str::<Setup>(
        r#"{ "start": { "x": 100, "z": -5 }, "spindle": { "maximum": 3000 } }"#,
    );
    let setup = setup.unwrap_or_default();
    assert_eq!((setup.start.x, setup.start.z), (Length(100_000_000), Length(-5_000_000)));
    assert_eq!(setup.spindle.maximum, Speed(3_000_000));
}

/// 2^63 and 2^64 − 1 fit into no quantity, nor do 2^63 nanometres, 9223372036855 mm.
#[test]
fn a_quantity_that_does_not_fit_is_refused() {
    for json in ["9223372036854775808", "18446744073709551615", "9223372036855", "-9223372036855"] {
        let fault = serde_json::from_str::<Length>(json).map_err(|fault| fault.to_string());
        assert!(fault.is_err_and(|fault| fault.contains("a number of millimetres")), "{json}");
    }
    assert_eq!(serde_json::from_str::<Length>("9223372036854").ok(), Some(Length(9_223_372_036_854_000_000)));
}

/// Written text (execution-io.md, section 2): a blank is `\x20`, a single `-` is `\x2D`; a blank itself is none.
#[test]
fn json_has_written_text() {
    for (written, codes) in [("A\\x20B", &b"A B"[..]), ("\\x2D", b"-"), ("\\x0A", b"\n"), ("", b"")] {
        let json = serde_json::to_string(written).unwrap_or_default();
        assert_eq!(serde_json::from_str::<Text>(&json).ok(), Some(Text::new(codes)), "{json}");
        assert_eq!(serde_json::to_string(&Text::new(codes)).unwrap_or_default(), json);
    }
    for json in ["\"A B\"", "\"\\\\x2\"", "7"] {
        assert!(serde_json::from_str::<Text>(json).is_err(), "{json}");
    }
}

/// Written text in quotation marks.
#[test]
fn a_text_for_people_is_written() {
    assert_eq!(format!("{:?}", Text::new(b"A B")), "\"A\\x20B\"");
    assert_eq!(format!("{:?}", ProgramText(b"O1 M02\n".to_vec())), "\"O1 M02\\n\"");
    assert_eq!(format!("{:?}", ProgramText(vec![0xD4])), "\"\\xd4\"");
}

/// A set holds a reading or does not: a second time changes nothing, neither does it in JSON.
#[test]
fn a_reading_is_in_a_set_once() {
    for reading in Reading::ALL {
        let once = ReadingSet::default().with(*reading);
        let twice = once.with(*reading);
        assert_eq!(twice, once);
        assert_eq!(twice.iter().collect::<Vec<_>>(), [*reading]);
        let json = format!("[{0:?}, {0:?}]", reading.as_str());
        assert_eq!(serde_json::from_str::<ReadingSet>(&json).ok(), Some(once), "{json}");
    }
}

/// A set of rules has them in the order of the catalogue, each once, however they come; one too many is left out.
#[test]
fn a_set_of_rules_is_in_the_order_of_the_catalogue() {
    let all: Vec<RuleId> = RuleId::all().collect();
    let [a, b, c, d] = [all[0], all[1], all[700], all[all.len() - 1]];
    let sorted = [a, b, c, d];
    for order in [[a, b, c, d], [d, c, b, a], [b, d, a, c], [c, a, d, b], [d, a, c, b]] {
        let set = RuleSet::of(&order);
        assert_eq!(set.as_slice(), sorted);
        assert_eq!(order.iter().fold(set, |set, rule| set.with(*rule)), set);
        let (left, right) = order.split_at(2);
        assert_eq!(RuleSet::of(left).union(RuleSet::of(right)), set);
        assert_eq!(set.union(RuleSet::of(left)), set);
    }
    assert_eq!(RuleSet::of(&[a]).union(RuleSet::EMPTY).as_slice(), [a]);
    assert_eq!(RuleSet::EMPTY.union(RuleSet::of(&[a, b])).as_slice(), [a, b]);

    let full = RuleSet::of(&all[..40]);
    assert_eq!(full.as_slice(), &all[..RuleSet::CAPACITY]);
    assert_eq!(full.with(d), full);
    assert_eq!(full.with(a), full);
    assert_eq!(full.union(full), full);
}

/// A label holds 24 characters; what is behind them is cut off.
#[test]
fn a_label_holds_24_characters() {
    assert_eq!(Label::new("ABCDEFGHIJKLMNOPQRSTUVWX").as_str(), "ABCDEFGHIJKLMNOPQRSTUVWX");
    assert_eq!(Label::new("ABCDEFGHIJKLMNOPQRSTUVWXYZ").as_str(), "ABCDEFGHIJKLMNOPQRSTUVWX");
}

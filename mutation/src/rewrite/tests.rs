//! Small sources with their mutants.

#![allow(clippy::expect_used)]

use std::collections::BTreeSet;

use super::{Rewritten, rewrite};
use crate::list::{self, Mutant};

/// Mutants as cargo-mutants lists them: what is changed, a text of the source that begins where it stands, and the
/// replacement.
fn mutants(source: &str, each: &[(&str, &str, &str)]) -> Vec<Mutant> {
    let mutant = |(genre, place, replacement): &(&str, &str, &str)| {
        let before = source.split_once(place).expect("the place").0;
        let line = before.matches('\n').count() + 1;
        let column = before.len() - before.rfind('\n').map_or(0, |end| end + 1) + 1;
        serde_json::from_value(serde_json::json!({
            "name": "x", "file": "a.rs", "genre": genre, "replacement": replacement,
            "span": {"start": {"line": line, "column": column}}, "function": null,
        }))
        .expect("a mutant")
    };
    each.iter().map(mutant).collect()
}

fn rewritten(source: &str, each: &[(&str, &str, &str)], without: &[usize]) -> Rewritten {
    let list = mutants(source, each);
    let without: BTreeSet<usize> = without.iter().copied().collect();
    rewrite(source, &list, &list::by_file(&list)["a.rs"], &without).expect("Rust")
}

fn text(source: &str, each: &[(&str, &str, &str)]) -> String {
    let text = rewritten(source, each, &[]).text;
    syn::parse_file(&text).expect("Rust again");
    assert_eq!(text.lines().count(), source.lines().count(), "no line moves");
    text.replace("crate::mutant::on", "on")
}

#[test]
fn each_operator_has_its_copy_of_the_original() {
    assert_eq!(
        text("fn f() { a + b * 2 }", &[("BinaryOperator", "+ b", "-"), ("BinaryOperator", "* 2", "/")]),
        "fn f() { (if on(0) { a - b * 2 } else if on(1) { a + b / 2 } else { a + b * 2 }) }"
    );
    // In brackets it is another chain.
    assert_eq!(
        text("fn f() { a + (b * 2) }", &[("BinaryOperator", "+ (b", "-"), ("BinaryOperator", "* 2", "/")]),
        "fn f() { (if on(0) { a - (b * 2) } else { a + ((if on(1) { b / 2 } else { b * 2 })) }) }"
    );
    // Another operator binds otherwise: a || (b && c).
    assert_eq!(
        text("fn f() { a && b && c }", &[("BinaryOperator", "&& b", "||")]),
        "fn f() { (if on(0) { a || b && c } else { a && b && c }) }"
    );
}

#[test]
fn bodies_begin_with_their_other_values() {
    let mutants = [("FnValue", "-a", "0"), ("FnValue", "-a", "1"), ("UnaryOperator", "-a", "")];
    assert_eq!(
        text("fn f(a: i64) -> i64 {\n    -a\n}", &mutants),
        "fn f(a: i64) -> i64 { if on(0) { return 0; } if on(1) { return 1; }\n    (if on(2) { a } else { -a })\n}"
    );
}

#[test]
fn arms_and_guards_have_switches() {
    let mutants = [
        ("MatchArm", "1 if", ""),
        ("MatchArmGuard", "h =>", "true"),
        ("MatchArmGuard", "h =>", "false"),
        ("MatchArm", "3 =>", ""),
    ];
    assert_eq!(
        text("fn f() { match g { 1 if h => 2, 3 => 4, _ => 5 } }", &mutants),
        "fn f() { match g { 1 if !on(0) && !on(2) && (on(1) || ({ h })) => 2, 3 if !on(3) => 4, _ => 5 } }"
    );
    // Without what `let` binds there is no body.
    let chain = [("MatchArmGuard", "let", "true"), ("MatchArmGuard", "let", "false")];
    let source = "fn f() { match g { _ if let Some(h) = i => h, _ => 5 } }";
    assert_eq!(rewritten(source, &chain, &[]).placed, [1].into());
    assert_eq!(text(source, &chain), "fn f() { match g { _ if !on(1) && let Some(h) = i => h, _ => 5 } }");
}

#[test]
fn fields_keep_the_value_of_the_base() {
    assert_eq!(
        text("fn f() { S { a: 1, b: 2, ..c } }", &[("StructField", "a:", ""), ("StructField", "b:", "")]),
        "fn f() { (if on(0) { S { b : 2 , .. c } } else if on(1) { S { a : 1 , .. c } } else { S { a: 1, b: 2, ..c } }) }"
    );
}

#[test]
fn what_is_worked_out_when_the_program_is_built_is_left() {
    let source = "const A: i64 = 1 + 2;\nconst fn f() -> i64 { 3 }\nfn g() -> impl H { i }";
    let mutants =
        [("BinaryOperator", "+ 2", "-"), ("FnValue", "3 }", "0"), ("FnValue", "i }", "Default::default()")];
    assert_eq!(text(source, &mutants), source);
    assert!(rewritten(source, &mutants, &[]).placed.is_empty());
}

#[test]
fn chains_with_let_are_left_and_what_does_not_compile() {
    let source = "fn f() { if let Some(a) = g && a == 1 {} }";
    let mutants = [("BinaryOperator", "&&", "||"), ("BinaryOperator", "==", "!=")];
    assert_eq!(rewritten(source, &mutants, &[1]).text, source);
    assert_eq!(rewritten(source, &mutants, &[]).placed, [1].into());
}

#[test]
fn copies_and_nodes_are_where_they_are_said_to_be() {
    let source = "fn f() { a + (b * 2) }";
    let all = [("BinaryOperator", "+ (b", "-"), ("BinaryOperator", "* 2", "/")];
    let rewritten = rewritten(source, &all, &[]);
    let at = |range: &std::ops::Range<usize>| &rewritten.text[range.clone()];
    let copies: Vec<&str> = rewritten.copies.iter().map(|(range, _)| at(range)).collect();
    assert_eq!(copies, ["a - (b * 2)", "b / 2"]);
    let inner = &rewritten.nodes[1];
    assert!(at(&inner.0).starts_with("(if") || at(&inner.0).contains("b * 2"), "{}", at(&inner.0));
    assert_eq!((&rewritten.nodes[0].1, &inner.1), (&vec![0], &vec![1]));
}

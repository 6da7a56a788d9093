//! A source with all of its mutants: each change stands beside the text that it replaces, behind a switch.
//!
//! `a < b` becomes `(if crate::mutant::on(7) { a <= b } else { a < b })`. A changed copy is else the original text: only one
//! mutant is ever on, so that a copy needs none of the others, and the size stays in proportion to the depth of nesting.
//! Nothing is moved to another line.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use proc_macro2::{LineColumn, TokenStream};
use quote::{ToTokens, quote};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use crate::list::{Genre, Mutant, Place};

/// A rewritten source, and where in it what stands.
pub struct Rewritten {
    /// The text.
    pub text: String,
    /// The mutants that are in it.
    pub placed: BTreeSet<usize>,
    /// The changed copies: their bytes in the text, and the mutant.
    pub copies: Vec<(Range<usize>, usize)>,
    /// The expressions, functions and arms with mutants: their bytes in the text, and the mutants.
    pub nodes: Vec<(Range<usize>, Vec<usize>)>,
}

/// Rewrites a source. `mutants` are the numbers of the mutants of this file by where they begin, `without` those that
/// do not compile.
///
/// # Errors
/// When the source is no Rust.
pub fn rewrite(
    source: &str,
    list: &[Mutant],
    mutants: &BTreeMap<Place, Vec<usize>>,
    without: &BTreeSet<usize>,
) -> Result<Rewritten, syn::Error> {
    let file = syn::parse_file(source)?;
    let mut rewriter =
        Rewriter { list, mutants, without, edits: Vec::new(), nodes: Vec::new(), in_chain: false };
    rewriter.visit_file(&file);
    Ok(rewriter.render(source))
}

/// A text that is inserted at a byte of the source, in pieces: the changed copies in it know their mutant.
struct Edit {
    at: usize,
    pieces: Vec<(String, Option<usize>)>,
}

struct Rewriter<'a> {
    list: &'a [Mutant],
    mutants: &'a BTreeMap<Place, Vec<usize>>,
    without: &'a BTreeSet<usize>,
    /// In the order of the visit: in front of a node outside in, behind it inside out.
    edits: Vec<Edit>,
    nodes: Vec<(Range<usize>, Vec<usize>)>,
    /// Whether the expression to be visited is an operand of a chain that has its copies.
    in_chain: bool,
}

fn on(number: usize) -> String {
    format!("crate::mutant::on({number})")
}

/// The switches of the mutants, each with what stands before and behind it.
fn switches(numbers: &[usize], before: &str, behind: &str) -> String {
    numbers.iter().map(|number| format!("{before}{}{behind}", on(*number))).collect()
}

fn plain(text: impl Into<String>) -> (String, Option<usize>) {
    (text.into(), None)
}

impl Rewriter<'_> {
    /// The mutants of a genre that begin at a place.
    fn at(&self, place: LineColumn, genre: Genre) -> Vec<usize> {
        let place = Place { line: place.line, column: place.column + 1 };
        let numbers = self.mutants.get(&place).map(Vec::as_slice).unwrap_or_default();
        let wanted = |number: &&usize| self.list[**number].genre == genre && !self.without.contains(number);
        numbers.iter().filter(wanted).copied().collect()
    }

    fn insert(&mut self, at: usize, pieces: Vec<(String, Option<usize>)>) {
        self.edits.push(Edit { at, pieces });
    }

    /// Copies in front of an expression, one a mutant; the closing bracket comes by `close`.
    fn open(&mut self, range: &Range<usize>, copies: Vec<(usize, TokenStream)>) {
        let mut pieces = vec![plain("(")];
        for (number, copy) in &copies {
            pieces.push(plain(format!("if {} {{ ", on(*number))));
            pieces.push((copy.to_string(), Some(*number)));
            pieces.push(plain(" } else "));
        }
        pieces.push(plain("{ "));
        self.insert(range.start, pieces);
        self.nodes.push((range.clone(), copies.into_iter().map(|(number, _)| number).collect()));
    }

    fn close(&mut self, range: &Range<usize>) {
        self.insert(range.end, vec![plain(" })")]);
    }

    /// `visit` between the copies and the bracket that closes them.
    fn around(
        &mut self,
        node: &impl Spanned,
        copies: Vec<(usize, TokenStream)>,
        visit: impl FnOnce(&mut Self),
    ) {
        if copies.is_empty() {
            return visit(self);
        }
        let range = node.span().byte_range();
        self.open(&range, copies);
        visit(self);
        self.close(&range);
    }

    fn render(self, source: &str) -> Rewritten {
        let mut edits = self.edits;
        edits.sort_by_key(|edit| edit.at);
        let mut text = String::with_capacity(source.len() * 2);
        let mut copies: Vec<(Range<usize>, usize)> = Vec::new();
        let mut done = 0;
        for edit in &edits {
            text.push_str(&source[done..edit.at]);
            done = edit.at;
            for (piece, number) in &edit.pieces {
                let start = text.len();
                text.push_str(piece);
                copies.extend(number.map(|number| (start..text.len(), number)));
            }
        }
        text.push_str(&source[done..]);
        let shifted = |at: usize, inclusive: bool| {
            let before = edits.iter().take_while(|edit| if inclusive { edit.at <= at } else { edit.at < at });
            at + before.flat_map(|edit| &edit.pieces).map(|(piece, _)| piece.len()).sum::<usize>()
        };
        let nodes: Vec<_> = self
            .nodes
            .into_iter()
            .map(|(range, numbers)| (shifted(range.start, false)..shifted(range.end, true), numbers))
            .collect();
        let placed = nodes.iter().flat_map(|(_, numbers)| numbers).copied().collect();
        Rewritten { text, placed, copies, nodes }
    }

    /// Another value at the beginning of a body.
    fn body(&mut self, signature: &syn::Signature, block: &syn::Block) {
        let Some(first) = block.stmts.first() else { return };
        let opaque = matches!(&signature.output, syn::ReturnType::Type(_, of) if matches!(**of, syn::Type::ImplTrait(_)));
        if opaque {
            return;
        }
        let mutants = self.at(first.span().start(), Genre::FnValue);
        let mut pieces = Vec::new();
        for number in &mutants {
            pieces.push(plain(format!(" if {} {{ return ", on(*number))));
            pieces.push((self.list[*number].replacement.clone(), Some(*number)));
            pieces.push(plain("; }"));
        }
        if !mutants.is_empty() {
            let open = block.brace_token.span.open().byte_range();
            self.nodes.push((block.span().byte_range(), mutants));
            self.insert(open.end, pieces);
        }
    }

    /// The mutants of the operators of a chain, each a copy of the whole chain: another operator may bind otherwise.
    fn chain(&self, whole: &syn::ExprBinary) -> Vec<(usize, TokenStream)> {
        let mut copies = Vec::new();
        for operator in operators(whole) {
            let place = operator.span().start();
            for number in self.at(place, Genre::BinaryOperator) {
                let Ok(other) = self.list[number].replacement.parse() else { continue };
                copies.push((number, with_operator(whole, place, &other)));
            }
        }
        copies
    }
}

/// The operators of a chain: those outside of brackets.
fn operators(whole: &syn::ExprBinary) -> Vec<&syn::BinOp> {
    let mut found = Vec::new();
    if let syn::Expr::Binary(left) = &*whole.left {
        found.extend(operators(left));
    }
    found.push(&whole.op);
    if let syn::Expr::Binary(right) = &*whole.right {
        found.extend(operators(right));
    }
    found
}

/// The text of a chain, with another operator at a place.
fn with_operator(whole: &syn::ExprBinary, place: LineColumn, other: &TokenStream) -> TokenStream {
    let side = |side: &syn::Expr| match side {
        syn::Expr::Binary(part) => with_operator(part, place, other),
        _ => side.to_token_stream(),
    };
    let (left, right) = (side(&whole.left), side(&whole.right));
    let own = whole.op.to_token_stream();
    let operator = if whole.op.span().start() == place { other } else { &own };
    quote!(#left #operator #right)
}

/// Whether `let` stands in a chain of conditions, which can only stand there.
fn holds_let(expression: &syn::Expr) -> bool {
    match expression {
        syn::Expr::Let(_) => true,
        syn::Expr::Binary(binary) => holds_let(&binary.left) || holds_let(&binary.right),
        _ => false,
    }
}

impl<'ast> Visit<'ast> for Rewriter<'_> {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if item.sig.constness.is_none() {
            self.body(&item.sig, &item.block);
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if item.sig.constness.is_none() {
            self.body(&item.sig, &item.block);
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let (None, Some(block)) = (item.sig.constness, &item.default) {
            self.body(&item.sig, block);
        }
        visit::visit_trait_item_fn(self, item);
    }

    // What is worked out when the program is built knows no switch.
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_type_array(&mut self, _: &'ast syn::TypeArray) {}
    fn visit_pat(&mut self, _: &'ast syn::Pat) {}

    fn visit_expr_repeat(&mut self, expression: &'ast syn::ExprRepeat) {
        self.visit_expr(&expression.expr);
    }

    fn visit_expr_binary(&mut self, expression: &'ast syn::ExprBinary) {
        let in_chain = std::mem::take(&mut self.in_chain);
        let stands_alone = !in_chain && !holds_let(&expression.left) && !holds_let(&expression.right);
        let copies = if stands_alone { self.chain(expression) } else { Vec::new() };
        self.around(expression, copies, |own| {
            for side in [&expression.left, &expression.right] {
                own.in_chain = (in_chain || stands_alone) && matches!(**side, syn::Expr::Binary(_));
                own.visit_expr(side);
            }
        });
        self.in_chain = false;
    }

    fn visit_expr_unary(&mut self, expression: &'ast syn::ExprUnary) {
        let operand = &expression.expr;
        let copies = self
            .at(expression.op.span().start(), Genre::UnaryOperator)
            .into_iter()
            .map(|number| (number, operand.to_token_stream()))
            .collect();
        self.around(expression, copies, |own| visit::visit_expr_unary(own, expression));
    }

    fn visit_expr_struct(&mut self, expression: &'ast syn::ExprStruct) {
        let mut copies = Vec::new();
        for (place, field) in expression.fields.iter().enumerate() {
            for number in self.at(field.span().start(), Genre::StructField) {
                let mut copy = expression.clone();
                copy.fields = expression
                    .fields
                    .iter()
                    .enumerate()
                    .filter(|(other, _)| *other != place)
                    .map(|(_, f)| f.clone())
                    .collect();
                if !copy.fields.is_empty() && copy.rest.is_some() {
                    copy.fields.push_punct(syn::token::Comma::default());
                }
                copies.push((number, copy.to_token_stream()));
            }
        }
        self.around(expression, copies, |own| visit::visit_expr_struct(own, expression));
    }

    // An arm with a switch covers nothing: if that is missed, the error is about the whole.
    fn visit_expr_match(&mut self, expression: &'ast syn::ExprMatch) {
        let arms = expression.arms.iter().flat_map(|arm| self.at(arm.span().start(), Genre::MatchArm));
        let arms: Vec<usize> = arms.collect();
        if !arms.is_empty() {
            self.nodes.push((expression.span().byte_range(), arms));
        }
        visit::visit_expr_match(self, expression);
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        let deleted = self.at(arm.span().start(), Genre::MatchArm);
        let mut all = deleted.clone();
        if let Some((_, guard)) = &arm.guard {
            let chain = holds_let(guard);
            let of = |text| {
                let mutants = self.at(guard.span().start(), Genre::MatchArmGuard).into_iter();
                mutants.filter(|number| self.list[*number].replacement == text).collect::<Vec<_>>()
            };
            // What `let` binds would be missing.
            let always = if chain { Vec::new() } else { of("true") };
            let never = of("false");
            let refused = switches(&deleted, "!", " && ") + &switches(&never, "!", " && ");
            let range = guard.span().byte_range();
            if chain {
                self.insert(range.start, vec![plain(refused)]);
                self.visit_expr(guard);
            } else {
                let met = switches(&always, "", " || ");
                self.insert(range.start, vec![plain(format!("{refused}({met}({{ "))]);
                self.visit_expr(guard);
                self.insert(range.end, vec![plain(" }))")]);
            }
            all.extend(always.into_iter().chain(never));
        } else if !deleted.is_empty() {
            let refused = switches(&deleted, "!", " && ");
            let refused = refused.trim_end_matches(" && ");
            self.insert(arm.pat.span().byte_range().end, vec![plain(format!(" if {refused}"))]);
        }
        if !all.is_empty() {
            self.nodes.push((arm.span().byte_range(), all));
        }
        self.visit_expr(&arm.body);
    }
}

#[cfg(test)]
mod tests;

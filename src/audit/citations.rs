//! Where the sources cite a rule: in code by its constant (`G50_02`), in comments by its id, as a list
//! (`E100L-G50-02, -03`) or as a range (`E100L-CSS-01 to -05`).

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::Serialize;
use turnspec_oracle::vocabulary::RuleId;

use super::source::{Item, Kind, around, items};
use super::{Fault, Tree};

/// A place in the sources that cites a rule.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, JsonSchema)]
pub struct Place {
    /// The file, relative to the tree.
    pub file: String,
    /// The line of the item, or of the citation in the head of a file.
    pub line: usize,
    /// The function, type or table; empty in the head of a file, which speaks of the whole file.
    pub item: String,
    /// Whether the item is a function.
    pub function: bool,
}

/// The citations in a folder of the tree, rule by rule; tests, imports and the paths that are passed over do
/// not count.
///
/// # Errors
/// Names the file that cannot be read.
pub fn scan(tree: &Tree, folder: &str, passed_over: &[&str]) -> Result<BTreeMap<RuleId, Vec<Place>>, Fault> {
    let mut found: BTreeMap<RuleId, BTreeSet<Place>> = BTreeMap::new();
    for file in tree.below(folder, "rs")? {
        if passed_over.iter().any(|prefix| file.starts_with(prefix)) {
            continue;
        }
        for (rule, place) in citations(&file, &tree.read(&file)?) {
            found.entry(rule).or_default().insert(place);
        }
    }
    Ok(found.into_iter().map(|(rule, places)| (rule, functions_first(places))).collect())
}

/// Functions before tables and types; the head of a file only where nothing else in the file cites the rule.
fn functions_first(places: BTreeSet<Place>) -> Vec<Place> {
    let (functions, others): (Vec<Place>, Vec<Place>) = places.into_iter().partition(|place| place.function);
    let (tables, heads): (Vec<Place>, Vec<Place>) =
        others.into_iter().partition(|place| !place.item.is_empty());
    let mut found: Vec<Place> = functions.into_iter().chain(tables).collect();
    for head in heads {
        if found.iter().all(|place| place.file != head.file) {
            found.push(head);
        }
    }
    found
}

/// The citations of one file.
fn citations(file: &str, text: &str) -> BTreeSet<(RuleId, Place)> {
    let items = items(text);
    let constants = constants();
    let mut found = BTreeSet::new();
    for (number, line) in (1..).zip(text.lines()) {
        let item = around(&items, number);
        if item.is_some_and(|item| item.test || item.kind == Kind::Import) {
            continue;
        }
        let (code, comment) = line.split_once("//").unwrap_or((line, ""));
        let names = code.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_');
        let rules = names.filter_map(|name| constants.get(name).copied()).chain(in_comment(comment));
        found.extend(rules.map(|rule| (rule, place(file, number, item))));
    }
    found
}

fn place(file: &str, line: usize, item: Option<&Item>) -> Place {
    let function = item.is_some_and(|item| item.kind == Kind::Function);
    let (line, item) = item.map_or((line, String::new()), |item| (item.line, item.name.clone()));
    Place { file: file.to_owned(), line, item, function }
}

/// The constants that stand for the rules.
fn constants() -> BTreeMap<String, RuleId> {
    RuleId::all().filter_map(|id| Some((id.as_str().split_once('-')?.1.replace('-', "_"), id))).collect()
}

/// The rules that a line of a comment names.
#[must_use]
pub fn in_comment(line: &str) -> Vec<RuleId> {
    let mut rules = Vec::new();
    let mut subject = "";
    let mut last = 0;
    let mut range = false;
    for word in line.split([' ', ',', ';', '(', ')', ':', '.']).filter(|word| !word.is_empty()) {
        let full = word.rsplit_once('-').filter(|(name, _)| name.contains('-'));
        let full = full.and_then(|(name, digits)| Some((name, digits.parse::<u32>().ok()?)));
        if let Some((name, number)) = full {
            (subject, last) = (name, number);
            rules.extend(numbered(subject, number..=number));
            range = false;
        } else if let Some(number) = continued(word).filter(|_| !subject.is_empty()) {
            let first = if range { last + 1 } else { number };
            rules.extend(numbered(subject, first..=number));
            last = number;
            range = false;
        } else {
            range = word == "to";
        }
    }
    rules
}

fn numbered(subject: &str, numbers: impl Iterator<Item = u32>) -> Vec<RuleId> {
    numbers.take(100).filter_map(|number| RuleId::parse(&format!("{subject}-{number:02}"))).collect()
}

/// The number of `-04`, which continues a list.
fn continued(word: &str) -> Option<u32> {
    word.strip_prefix('-').filter(|digits| digits.len() == 2)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{citations, in_comment};

    fn ids(line: &str) -> Vec<&'static str> {
        in_comment(line).into_iter().map(|rule| rule.as_str()).collect()
    }

    #[test]
    fn lists_and_ranges_are_read() {
        assert_eq!(ids("/ E100L-G50-01, -02; and"), ["E100L-G50-01", "E100L-G50-02"]);
        assert_eq!(ids("(E100L-CSS-01 to -03)."), ["E100L-CSS-01", "E100L-CSS-02", "E100L-CSS-03"]);
        assert_eq!(ids("Rules: E100L-ABS-01, E100L-DIA-01"), ["E100L-ABS-01", "E100L-DIA-01"]);
        assert_eq!(ids("one-sided, -04 x-1 E100L-ABS-99 to -4000000000"), Vec::<&str>::new());
    }

    #[test]
    fn a_citation_has_its_function() {
        let text = "//! E100L-G50-01.\nuse x::{G50_02};\n/// E100L-ABS-01.\nfn f() {\n    g(DIA_01) // E100L-ABS-02\n}\n\
                    #[cfg(test)]\nmod tests {\n    fn t() { G50_02 }\n}\n";
        let found = citations("a.rs", text);
        let found: Vec<_> =
            found.iter().map(|(rule, place)| (rule.as_str(), place.line, place.item.as_str())).collect();
        let expected = [("E100L-ABS-01", 4, "f"), ("E100L-ABS-02", 4, "f"), ("E100L-DIA-01", 4, "f")];
        let mut sorted = found.clone();
        sorted.sort_unstable();
        assert_eq!(sorted[..3], expected);
        assert_eq!(sorted[3..], [("E100L-G50-01", 1, "")]);
    }
}

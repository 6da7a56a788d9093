//! The items of a Rust source file and the lines that they span, read from its layout.
//!
//! Sources of this project are formatted by rustfmt, which the checks demand. An item therefore begins at a
//! line with its keyword and ends at the last line before the next one of the same indentation that is not
//! its closing bracket. That is enough to tell the function around a line; nothing else is asked.

/// An item of a source file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Item {
    /// What it is.
    pub kind: Kind,
    /// Its name; of a method, behind the name of its type: `Frame::new`.
    pub name: String,
    /// Line of its keyword, from 1.
    pub line: usize,
    /// First line of the comments and attributes in front of it.
    pub start: usize,
    /// Last line.
    pub end: usize,
    /// The doc comment in front of it, without the slashes.
    pub docs: Vec<String>,
    /// Name of the macro that it stands in, if it does.
    pub within: Option<String>,
    /// Whether it is compiled for tests only.
    pub test: bool,
}

/// What an item is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A function.
    Function,
    /// An implementation block.
    Implementation,
    /// A module with its text.
    Module,
    /// A macro call with items or a table in it.
    Macro,
    /// An import.
    Import,
    /// A type, constant or other item.
    Other,
}

struct Open {
    item: Item,
    indentation: usize,
}

/// The comments and attributes that stand in front of the next item.
#[derive(Default)]
struct Front {
    start: Option<usize>,
    docs: Vec<String>,
    test: bool,
}

/// The items of a source text, in the order in which they end.
#[must_use]
pub fn items(text: &str) -> Vec<Item> {
    let mut done = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    let mut front = Front::default();
    for (number, line) in (1..).zip(text.lines()) {
        let words = line.trim_start();
        if words.is_empty() {
            front = Front::default();
            continue;
        }
        let indentation = line.len() - words.len();
        let continues = words.starts_with(['}', ']', ')', '{']) || words == "where";
        while let Some(top) =
            open.pop_if(|top| indentation < top.indentation || indentation == top.indentation && !continues)
        {
            done.push(top.item);
        }
        if words.starts_with("//!") {
            // The head of a file or module belongs to no item.
            front = Front::default();
        } else if let Some(comment) = words.strip_prefix("//") {
            front.start.get_or_insert(number);
            front.docs.extend(comment.strip_prefix('/').map(|text| text.trim().to_owned()));
        } else if words.starts_with("#[") {
            front.start.get_or_insert(number);
            front.test |= words.starts_with("#[cfg(test)]");
        } else if let Some((kind, name)) = header(words).filter(|_| may_hold_items(&open)) {
            let front = std::mem::take(&mut front);
            open.push(Open { item: item(kind, name, number, front, &open), indentation });
        } else {
            front = Front::default();
        }
        for each in &mut open {
            each.item.end = number;
        }
    }
    done.extend(open.into_iter().rev().map(|open| open.item));
    done
}

/// The innermost item around a line: a function if there is one, else the closest thing.
#[must_use]
pub fn around(items: &[Item], line: usize) -> Option<&Item> {
    let around = || items.iter().filter(|item| (item.start..=item.end).contains(&line));
    let innermost =
        |kind: fn(Kind) -> bool| around().filter(|item| kind(item.kind)).max_by_key(|item| item.start);
    innermost(|kind| kind == Kind::Function).or_else(|| innermost(|_| true))
}

fn item(kind: Kind, name: &str, line: usize, front: Front, open: &[Open]) -> Item {
    let parent = open.last().map(|open| &open.item);
    let name = match parent {
        Some(parent) if parent.kind == Kind::Implementation && kind == Kind::Function => {
            format!("{}::{name}", parent.name)
        }
        _ => name.to_owned(),
    };
    Item {
        kind,
        name,
        line,
        start: front.start.unwrap_or(line),
        end: line,
        docs: front.docs,
        within: parent.filter(|parent| parent.kind == Kind::Macro).map(|parent| parent.name.clone()),
        test: front.test || parent.is_some_and(|parent| parent.test),
    }
}

/// Whether the innermost open item is none, or one that other items stand in.
fn may_hold_items(open: &[Open]) -> bool {
    open.last().is_none_or(|top| !matches!(top.item.kind, Kind::Import | Kind::Other))
}

/// What a line begins, if it begins an item.
fn header(words: &str) -> Option<(Kind, &str)> {
    let mut rest = words;
    if let Some(after) = rest.strip_prefix("pub") {
        rest = match after.strip_prefix('(') {
            Some(scope) => scope.split_once(')')?.1.trim_start(),
            None => after.strip_prefix(' ')?,
        };
    }
    if let Some(after) = rest.strip_prefix("impl").filter(|after| after.starts_with(['<', ' '])) {
        return Some((Kind::Implementation, implemented(after)));
    }
    if let Some(name) = macro_call(rest) {
        return Some((Kind::Macro, name));
    }
    if let Some(name) =
        ["const fn ", "async fn ", "fn "].iter().find_map(|keyword| rest.strip_prefix(keyword))
    {
        return Some((Kind::Function, identifier(name)));
    }
    let (keyword, name) = rest.split_once(' ')?;
    let kind = match keyword {
        "mod" if rest.ends_with('{') => Kind::Module,
        "use" => Kind::Import,
        "struct" | "enum" | "union" | "trait" | "const" | "static" | "type" | "macro_rules!" => Kind::Other,
        _ => return None,
    };
    Some((kind, identifier(name)))
}

/// `name` of `name! {` and of `name!(…);` over several lines.
fn macro_call(words: &str) -> Option<&str> {
    let (name, rest) = words.split_once('!')?;
    let plain = !name.is_empty() && name.chars().all(|letter| letter.is_alphanumeric() || letter == '_');
    (plain && matches!(rest, " {" | "(")).then_some(name)
}

/// The type of an implementation: the last path segment, without parameters.
fn implemented(header: &str) -> &str {
    let mut rest = header;
    if rest.starts_with('<') {
        let mut depth = 0_usize;
        let close = rest.char_indices().find(|(_, letter)| {
            depth = match letter {
                '<' => depth + 1,
                '>' => depth.saturating_sub(1),
                _ => depth,
            };
            depth == 0
        });
        rest = close.and_then(|(place, _)| rest.get(place + 1..)).unwrap_or_default();
    }
    let target = rest.rsplit_once(" for ").map_or(rest, |(_, target)| target).trim_start();
    let path = target.split(['<', ' ', '{']).next().unwrap_or_default();
    path.rsplit("::").next().unwrap_or_default()
}

fn identifier(text: &str) -> &str {
    let end = text.find(|letter: char| !letter.is_alphanumeric() && letter != '_').unwrap_or(text.len());
    text.split_at(end).0
}

#[cfg(test)]
mod tests {
    use super::{Kind, around, items};

    const TEXT: &str = "//! Module.

use a::{
    B, C,
};

/// Doc of one.
#[must_use]
pub(super) const fn one(
    x: u8,
) -> u8
where
    u8: Copy,
{
    // Inside.
    let inner = |y| match y {
        _ => x,
    };
    inner(x)
}

pub const TABLE: [u8; 2] = [
    1,
    2,
];

impl<'a, T: Into<Vec<u8>>> From<T> for path::Thing<'a> {
    /// Doc of from.
    fn from(value: T) -> Self { Self }

    fn other() {
        done!();
    }
}

theorems! {
    /// A theorem.
    fn holds() {
    }
}

#[cfg(test)]
mod tests {
    fn tested() {
    }
}
";

    fn name_at(line: usize) -> Option<String> {
        around(&items(TEXT), line).map(|item| item.name.clone())
    }

    #[test]
    fn the_item_around_a_line_is_found() {
        for (line, name) in [
            (4, "a"),
            (7, "one"),
            (15, "one"),
            (20, "one"),
            (23, "TABLE"),
            (25, "TABLE"),
            (27, "Thing"),
            (28, "Thing::from"),
            (29, "Thing::from"),
            (32, "Thing::other"),
            (37, "holds"),
            (44, "tested"),
        ] {
            assert_eq!(name_at(line).as_deref(), Some(name), "line {line}");
        }
        assert_eq!(name_at(1), None);
        assert_eq!(name_at(6), None);
        assert_eq!(around(&items("//! Head.\nfn f() {}\n"), 1), None);
    }

    #[test]
    fn docs_macros_and_tests_are_told() {
        let items = items(TEXT);
        let find = |name: &str| items.iter().find(|item| item.name == name).expect("an item");
        assert_eq!(find("one").docs, ["Doc of one."]);
        assert_eq!(find("one").kind, Kind::Function);
        assert_eq!(find("holds").within.as_deref(), Some("theorems"));
        assert_eq!(find("holds").docs, ["A theorem."]);
        assert!(find("tested").test && !find("one").test);
    }

    #[test]
    fn no_text_is_too_strange() {
        for text in
            ["", "}", "impl<", "impl", "pub(", "fn", "fn ", "!", "x! {", "    fn a() {\n}\n  }\nfn", "pub"]
        {
            let _ = items(text);
        }
    }
}

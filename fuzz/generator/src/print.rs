//! From structure to text, with the freedom of spelling that the grammar leaves: blanks, comments, leading
//! and trailing zeros, signs, equal signs, continuation lines, CR LF.

use turnspec_oracle::vocabulary::Feature;

use crate::choices::Choices;
use crate::number::Number;
use crate::print_expression::{self, variable};
use crate::profile::Profile;
use crate::program::{Block, Item, Line, Program, Statement, Value, Word};

/// The longest block, in characters (E100L-FMT-05).
pub const LONGEST: usize = 158;

/// How freely a program is spelled.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// How often, in a hundred, an item is spelled in an unusual way.
    pub variation: usize,
    /// How often, in a hundred, a blank between items is left out.
    pub glue: usize,
    /// Whether lines end with CR LF.
    pub carriage_return: bool,
    /// Whether the tape code has the equal sign, brackets and `$` (EIA does not, E100L-TAPE-01).
    pub all_characters: bool,
    /// What spellings may need of an implementation.
    pub profile: Profile,
}

impl Style {
    /// The plainest spelling.
    pub const PLAIN: Self =
        Self { variation: 0, glue: 0, carriage_return: false, all_characters: true, profile: Profile::FULL };

    /// A style of a program.
    pub fn choose(choices: &mut Choices<'_, '_>, all_characters: bool, profile: Profile) -> Self {
        Self {
            variation: choices.pick(&[0, 3, 3, 10, 30]),
            glue: choices.pick(&[0, 0, 20, 100]),
            carriage_return: choices.chance(10) && profile.allows(Feature::TapeCode),
            all_characters,
            profile,
        }
    }
}

/// The texts of the library of a program in seven-bit characters.
pub fn library(program: &Program, style: Style, choices: &mut Choices<'_, '_>) -> Vec<(String, Vec<u8>)> {
    let texts = program.library.iter();
    texts.map(|(name, program)| (name.clone(), lines(program, style, choices))).collect()
}

/// The text of a program in seven-bit characters.
pub fn program(program: &Program, style: Style, choices: &mut Choices<'_, '_>) -> Vec<u8> {
    lines(&program.lines, style, choices)
}

fn lines(lines: &[Line], style: Style, choices: &mut Choices<'_, '_>) -> Vec<u8> {
    let mut text = Vec::new();
    for line in lines {
        match line {
            Line::Raw(bytes) => text.extend_from_slice(bytes),
            Line::Block(block) => text.extend_from_slice(block_text(block, style, choices).as_bytes()),
        }
        if style.carriage_return {
            text.push(b'\r');
        }
        text.push(b'\n');
    }
    if choices.chance(5) {
        text.pop();
    }
    text
}

/// The plainest text of a program in seven-bit characters.
#[must_use]
pub fn plainest(lines: &Program) -> Vec<u8> {
    program(lines, Style::PLAIN, &mut Choices::new(&mut arbitrary::Unstructured::new(&[])))
}

/// The plainest texts of its library.
#[must_use]
pub fn plainest_library(program: &Program) -> Vec<(String, Vec<u8>)> {
    library(program, Style::PLAIN, &mut Choices::new(&mut arbitrary::Unstructured::new(&[])))
}

/// The plainest text of a block, without end of block.
#[must_use]
pub fn plain(block: &Block) -> String {
    let mut bytes = arbitrary::Unstructured::new(&[]);
    Printer { style: Style::PLAIN, choices: &mut Choices::new(&mut bytes) }.block(block)
}

/// The text of a block without end of block; the plainest one when it would be too long otherwise.
pub(crate) fn block_text(block: &Block, style: Style, choices: &mut Choices<'_, '_>) -> String {
    let text = Printer { style, choices }.block(block);
    let length = text.chars().filter(|character| !matches!(character, '\r' | '\n')).count();
    if length <= LONGEST { text } else { plain(block) }
}

/// Writes one block.
pub(crate) struct Printer<'p, 'c, 'd> {
    pub(crate) style: Style,
    pub(crate) choices: &'p mut Choices<'c, 'd>,
}

impl Printer<'_, '_, '_> {
    /// Whether to leave the usual spelling here.
    pub(crate) fn vary(&mut self) -> bool {
        self.choices.chance(self.style.variation)
    }

    fn block(&mut self, block: &Block) -> String {
        let mut text = String::new();
        let slash_first = block.delete && (block.sequence.is_none() || self.choices.chance(50));
        if self.vary() {
            text.push_str("  ");
        }
        if slash_first {
            text.push('/');
        }
        if let Some(name) = &block.sequence {
            text.push('N');
            text.push_str(name);
            if block.delete && !slash_first {
                text.push('/');
            } else if !block.items.is_empty() || block.statement.is_some() || self.vary() {
                text.push_str(self.separator());
            }
        }
        if let Some(statement) = &block.statement {
            text.push_str(&self.statement(statement));
            let loose = matches!(statement, Statement::Macro(..));
            if !(block.items.is_empty() || loose && self.choices.chance(self.style.glue)) {
                text.push_str(self.separator());
            }
        }
        for (place, item) in block.items.iter().enumerate() {
            if place > 0 {
                let gap = self.gap(&text);
                text.push_str(&gap);
            }
            text.push_str(&self.item(item));
        }
        if self.vary() {
            let list = [" ", "\t", "(END OF BLOCK)", " (a; b) "];
            let allowed = if self.style.all_characters { list.len() } else { 3 };
            text.push_str(self.spelling(&list[..allowed]));
        }
        text
    }

    /// One of the texts that the profile allows, a blank if there is none.
    pub(crate) fn spelling(&mut self, list: &[&'static str]) -> &'static str {
        let profile = self.style.profile;
        let allowed = |text: &&&str| {
            let plain = text.chars().all(|character| matches!(character, ' '..='~' | '\n'));
            (plain || profile.allows(Feature::TapeCode))
                && (!text.contains('(') || profile.allows(Feature::Comment))
                && (!text.contains('$') || profile.allows(Feature::ProgramName))
        };
        let list: Vec<_> = list.iter().filter(allowed).copied().collect();
        if list.is_empty() { " " } else { self.choices.pick(&list) }
    }

    /// What stands between two items.
    fn gap(&mut self, text: &str) -> String {
        if self.vary() {
            let list =
                ["  ", "\t", "(REMARK)", " (see drawing 7/2) ", "\n$", "\r\n$ ", " \u{7F}", "\u{8} ", "()"];
            let allowed = if self.style.all_characters { list.len() } else { 3 };
            return self.spelling(&list[..allowed]).to_owned();
        }
        let needs_blank = run_may_go_on(text);
        if !needs_blank && self.choices.chance(self.style.glue) { String::new() } else { " ".to_owned() }
    }

    pub(crate) fn separator(&mut self) -> &'static str {
        if self.vary() { self.spelling(&["\t", "(X)", "  ", "\u{8}"]) } else { " " }
    }

    fn item(&mut self, item: &Item) -> String {
        match item {
            Item::Word(word) => self.word(word),
            Item::Assignment(target, value) => {
                let equal = if self.vary() { self.spelling(&[" = ", "= ", "\t="]) } else { "=" };
                format!("{}{equal}{}", variable(self, target), print_expression::text(self, value))
            }
            Item::Comment(position, text) => {
                let equal = if self.vary() { self.spelling(&[" = ", "= ", "\t="]) } else { "=" };
                format!("VUACM[{}]{equal}{}", print_expression::text(self, position), self.string(text))
            }
            Item::Calrg => "CALRG".to_owned(),
            Item::Raw(text) => (*text).to_owned(),
        }
    }

    fn word(&mut self, word: &Word) -> String {
        let address = word.address;
        match &word.value {
            Value::Plain(number) => {
                let extended = address.len() == 2;
                let written = self.number(*number, address);
                let may_equal = self.style.all_characters && self.style.profile.allows(Feature::Expression);
                if extended || may_equal && self.vary() {
                    let equal = if self.vary() { self.choices.pick(&[" = ", "= ", " ="]) } else { "=" };
                    return format!("{address}{equal}{written}");
                }
                format!("{address}{written}")
            }
            Value::Expression(expression) => {
                let equal = if self.vary() { self.spelling(&["= ", " =", "=\t"]) } else { "=" };
                format!("{address}{equal}{}", print_expression::text(self, expression))
            }
        }
    }

    /// A plain number; a G, M or T code is usually written with two digits at least, a G code with three at most and
    /// without sign (E100L-GCODE-01).
    fn number(&mut self, number: Number, address: &str) -> String {
        let (code, g, extended) = (matches!(address, "G" | "M" | "T"), address == "G", address.len() == 2);
        let (mut whole, mut fraction) = number.digits();
        let most = if g { 3 } else { 8 };
        if whole == "0" && !fraction.is_empty() && (fraction.len() == 8 || self.vary()) {
            whole.clear();
        }
        if code && whole.len() < 2 && !self.vary() {
            whole.insert(0, '0');
        }
        while whole.len() + fraction.len() < most && self.vary() {
            whole.insert(0, '0');
        }
        while number.point && whole.len() + fraction.len() < most && self.vary() {
            fraction.push('0');
        }
        let sign = match number.mantissa {
            ..0 => "-",
            _ if !g && self.vary() => "+",
            _ => "",
        };
        let point = if number.point { "." } else { "" };
        let text = format!("{sign}{whole}{point}{fraction}");
        if !extended && self.vary() { self.loosen(&text) } else { text }
    }

    /// Puts blanks between the characters of a number (E100L-FMT-07).
    fn loosen(&mut self, text: &str) -> String {
        let mut loose = String::new();
        for character in text.chars() {
            if self.choices.chance(40) {
                loose.push(' ');
            }
            loose.push(character);
        }
        loose
    }
}

/// Whether a letter after this text would be read into its last name or number: after a mnemonic, a variable
/// or a hexadecimal constant.
fn run_may_go_on(text: &str) -> bool {
    let run = text.len() - text.trim_end_matches(|character: char| character.is_ascii_alphanumeric()).len();
    let (before, run_text) = text.split_at(text.len() - run);
    let hex = run > 0 && before.ends_with('$');
    let letters = run_text.chars().take_while(char::is_ascii_alphabetic).count();
    let common = text.trim_end_matches(|character: char| character.is_ascii_digit()).ends_with('V');
    hex || common || letters > 1 || text.ends_with(|character: char| character.is_ascii_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::run_may_go_on;

    #[test]
    fn a_blank_stands_where_names_would_run_together() {
        for text in ["CALRG", "K5CALRG", "X=V5", "X=VPAI", "X=$12", "V5=V007", "X=DIA1"] {
            assert!(run_may_go_on(text), "{text}");
        }
        for text in ["G01", "X-5.3", "X=SIN[30]", "X=5+3", "SB=300", ""] {
            assert!(!run_may_go_on(text), "{text}");
        }
    }
}

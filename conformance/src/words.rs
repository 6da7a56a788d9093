//! What words a program text has: enough to tell what an implementation needs for it, far from a parser.

use std::collections::BTreeSet;

use turnspec_oracle::vocabulary::TapeCode;

/// The words of a program.
#[derive(Debug, Default)]
pub struct Words {
    /// G codes.
    pub g: BTreeSet<u32>,
    /// M codes.
    pub m: BTreeSet<u32>,
    /// Addresses of one letter.
    pub letters: BTreeSet<char>,
    /// Extended addresses, statements and other names of several letters.
    pub names: BTreeSet<String>,
    /// System variables, without subscript.
    pub system_variables: BTreeSet<String>,
    /// A common variable.
    pub variable: bool,
    /// A function with its argument.
    pub function: bool,
    /// AND, OR, EOR, NOT.
    pub boolean: bool,
    /// An operator, a function, a bracket, or a variable as a value.
    pub expression: bool,
    /// A parenthesis.
    pub comment: bool,
    /// A slash that begins a block or follows its sequence name.
    pub slash: bool,
    /// A sequence name.
    pub sequence: bool,
    /// A program name, a file header, a percent sign.
    pub program_name: bool,
    /// G50 in a block with an axis word.
    pub zero_shift: bool,
}

impl Words {
    /// Reads a program text. Text in EIA code is not read.
    #[must_use]
    pub fn of(program: &[u8], code: TapeCode) -> Self {
        let text: String = match code {
            TapeCode::Ascii => program.iter().map(|byte| char::from(*byte)).collect(),
            TapeCode::Iso => program.iter().map(|byte| char::from(byte & 0x7F)).collect(),
            TapeCode::Eia => String::new(),
        };
        let mut words = Self { comment: text.contains('('), ..Self::default() };
        let mut shift = (false, false);
        for line in without_comments(&text).lines() {
            let line = line.trim_start();
            match line.strip_prefix('$') {
                Some(header) if header.contains('%') => words.program_name = true,
                Some(continuation) => words.items(continuation, &mut shift),
                None => {
                    shift = (false, false);
                    let items = words.beginning(line);
                    words.items(items, &mut shift);
                }
            }
            words.zero_shift |= shift == (true, true);
        }
        words
    }

    /// Adds the words of another text.
    pub fn join(&mut self, other: Self) {
        self.g.extend(other.g);
        self.m.extend(other.m);
        self.letters.extend(other.letters);
        self.names.extend(other.names);
        self.system_variables.extend(other.system_variables);
        self.variable |= other.variable;
        self.function |= other.function;
        self.boolean |= other.boolean;
        self.expression |= other.expression;
        self.comment |= other.comment;
        self.slash |= other.slash;
        self.sequence |= other.sequence;
        self.program_name |= other.program_name;
        self.zero_shift |= other.zero_shift;
    }

    /// Program name, slash and sequence name; the rest of the line.
    fn beginning<'t>(&mut self, line: &'t str) -> &'t str {
        if line.starts_with(['O', ':', '%']) {
            self.program_name = true;
            return "";
        }
        let rest = self.slash(line);
        let Some(name) = rest.strip_prefix('N').filter(|_| !rest.starts_with("NOEX")) else { return rest };
        self.sequence = true;
        let end = name.find(|each: char| !each.is_ascii_alphanumeric()).unwrap_or(name.len());
        self.slash(name.get(end..).unwrap_or_default().trim_start())
    }

    fn slash<'t>(&mut self, text: &'t str) -> &'t str {
        match text.strip_prefix('/') {
            Some(rest) => {
                self.slash = true;
                rest.trim_start()
            }
            None => text,
        }
    }

    fn items(&mut self, mut rest: &str, shift: &mut (bool, bool)) {
        if let Some(selection) = rest.trim_start().strip_prefix("PSELECT") {
            // Files and program names are no words; the number of repetitions may be an expression.
            self.names.insert("PSELECT".to_owned());
            rest = selection.splitn(4, ',').nth(3).unwrap_or_default();
        }
        let mut before = ' ';
        while let Some(next) = rest.chars().next() {
            let length = if next.is_ascii_uppercase() {
                let letters = run(rest, |each| each.is_ascii_uppercase());
                self.name(letters, rest.get(letters.len()..).unwrap_or_default(), before, shift)
            } else if next == '\'' {
                // A character string.
                2 + run(rest.get(1..).unwrap_or_default(), |each| each != '\'').len()
            } else if next == '$' {
                // A hexadecimal number.
                1 + run(rest.get(1..).unwrap_or_default(), |each| each.is_ascii_hexdigit()).len()
            } else {
                let operand_before = before.is_ascii_alphanumeric() || matches!(before, ']' | '.');
                self.expression |=
                    matches!(next, '[' | '*') || matches!(next, '+' | '-' | '/') && operand_before;
                next.len_utf8()
            };
            let (taken, after) = rest.split_at_checked(length).unwrap_or((rest, ""));
            // Blanks do not count, and the sign of a word is no operator.
            if next.is_ascii_uppercase() && length == 1 {
                before = ' ';
            } else if !next.is_whitespace() {
                before = taken.chars().last().unwrap_or(' ');
            }
            rest = after;
        }
    }

    /// Takes a name; how many characters belong to it.
    fn name(&mut self, letters: &str, after: &str, before: char, shift: &mut (bool, bool)) -> usize {
        let digits = run(after, |each| each.is_ascii_digit());
        let number = digits.parse().ok();
        match (letters, number) {
            ("G", Some(code)) => {
                self.g.insert(code);
                shift.0 |= code == 50;
            }
            ("M", Some(code)) => {
                self.m.insert(code);
            }
            ("V", Some(_)) => {
                self.variable = true;
                self.expression |= before == '=';
            }
            ("AND" | "OR" | "EOR" | "NOT", _) => {
                self.boolean = true;
                self.expression = true;
                return letters.len();
            }
            (_, None) if letters.len() == 1 => {
                self.letters.extend(letters.chars());
                shift.1 |= ["X", "Z", "C", "W"].contains(&letters);
                return 1;
            }
            _ if letters.len() == 1 => {
                self.letters.extend(letters.chars());
                shift.1 |= ["X", "Z", "C", "W"].contains(&letters);
            }
            _ if letters.starts_with('V') && letters != "VSET" => {
                self.system_variables.insert(letters.to_owned());
                self.expression |= before == '=';
                // A plain number as subscript is no expression.
                let subscript =
                    after.strip_prefix('[').map_or("", |rest| run(rest, |each| each.is_ascii_digit()));
                let closed = after.get(1 + subscript.len()..).is_some_and(|rest| rest.starts_with(']'));
                return letters.len() + if closed { subscript.len() + 2 } else { 0 };
            }
            _ => {
                let rest = after.get(digits.len()..).unwrap_or_default();
                if rest.starts_with('[') {
                    self.function = true;
                } else {
                    self.names.insert(letters.to_owned());
                    self.expression |= before == '=';
                }
            }
        }
        letters.len() + digits.len()
    }
}

/// The text without what stands in parentheses; an open parenthesis takes the rest.
fn without_comments(text: &str) -> String {
    let mut inside = false;
    text.chars()
        .filter(|each| {
            let keep = !inside && *each != '(';
            inside = match each {
                '(' => true,
                ')' => false,
                _ => inside,
            };
            keep
        })
        .collect()
}

/// The characters at the beginning that satisfy a condition, all of them ASCII.
fn run(text: &str, condition: impl Fn(char) -> bool) -> &str {
    text.get(..text.find(|each| !condition(each)).unwrap_or(text.len())).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::TapeCode;

    use super::Words;

    fn words(text: &str) -> Words {
        Words::of(text.as_bytes(), TapeCode::Ascii)
    }

    #[test]
    fn codes_and_addresses_are_found_with_and_without_blanks() {
        let found = words("N1 G01X-5 Z=10F0.2M08\nT010203 SB=400");
        assert!(found.g.contains(&1) && found.m.contains(&8) && found.names.contains("SB"));
        assert_eq!(found.letters.iter().collect::<String>(), "FTXZ");
        assert!(found.sequence && !found.expression && !found.variable && !found.slash);
        assert!(words("V1=$A1C").letters.is_empty());
    }

    #[test]
    fn an_expression_is_told_from_a_plain_value() {
        for text in ["V1=-5", "X-5", "X=-.5", "VTOFX[3]=1", "V5=$1F", "/X5", "N1/X5"] {
            assert!(!words(text).expression, "{text}");
        }
        for text in [
            "X=V1",
            "V1=V2-1",
            "X=[5]",
            "V1=SIN[30]",
            "V1=5/2",
            "V1=2*3",
            "V1=1 AND 3",
            "V1=3 - 1",
            "VTOFX[V1+1]=1",
        ] {
            assert!(words(text).expression, "{text}");
        }
        assert!(words("V1=SQRT[4]").function && words("V1=ATAN2[1,2]").function);
        assert!(!words("VTOFX[3]=1").function && words("V1=1 EOR 2").boolean);
    }

    #[test]
    fn comments_hide_words() {
        let found = words("(G96 V1=2\nM03) G00 X1");
        assert!(found.comment && !found.g.contains(&96) && found.g.contains(&0) && found.m.is_empty());
    }

    #[test]
    fn beginnings_of_blocks_are_told_apart() {
        assert!(words("/X1").slash && words("N1 /X1").slash && !words("V1=4/2").slash);
        assert!(
            words("OABC\nX1").program_name && words("%\n").program_name && words("$A.MIN%\n").program_name
        );
        assert!(!words("X1\n$ Z2").program_name);
    }

    #[test]
    fn a_zero_shift_is_g50_with_an_axis() {
        assert!(words("G50 X5").zero_shift && words("X5 G50").zero_shift && words("G50\n$Z5").zero_shift);
        assert!(!words("G50 S2000\nX5").zero_shift);
    }

    #[test]
    fn any_bytes_are_read() {
        for code in [TapeCode::Ascii, TapeCode::Iso, TapeCode::Eia] {
            let bytes: Vec<u8> = (0..=255).chain((0..=255).rev()).collect();
            assert!(Words::of(&bytes, code).variable || code != TapeCode::Ascii || bytes.len() == 512);
        }
    }
}

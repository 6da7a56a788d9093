//! The rule texts: embedded, read, and ready to be shown or run.
//!
//! A rule is a heading `### E100L-G50-01 · title`, a list of `- key: value` lines, a statement, and examples:
//! a fence `nc`, optional fences such as `sub PULL.SUB` with files of the library, an optional fence `toml`, a fence `trace`, with the paragraph in front of them and, if a drawing
//! is wanted, an image behind them.

use crate::vocabulary::{AlarmName, ProgramText, RuleId, Setup, SetupError};

/// The text of a rule.
#[derive(Clone, Debug, PartialEq)]
pub struct RuleText {
    /// Its id.
    pub id: RuleId,
    /// Its title.
    pub title: String,
    /// The file that it stands in, under `spec/rules/`.
    pub file: &'static str,
    /// Line of its heading.
    pub line: usize,
    /// Section of the manual.
    pub source: String,
    /// `manual`, `interpretation` or `unspecified`.
    pub basis: String,
    /// `core`, `option` or `listed`.
    pub level: String,
    /// The alarms that it demands.
    pub alarms: Vec<AlarmName>,
    /// The statement, as markdown.
    pub statement: String,
    /// The examples.
    pub examples: Vec<Example>,
}

/// An executable example.
#[derive(Clone, Debug, PartialEq)]
pub struct Example {
    /// What it shows, and how its trace follows from the rule.
    pub introduction: String,
    /// The program.
    pub program: Vec<u8>,
    /// The files of the library, by name.
    pub library: Vec<(String, ProgramText)>,
    /// The set-up without the library, as TOML; empty for the default one.
    pub setup: String,
    /// The expected trace in compact notation.
    pub trace: String,
    /// Line of the program's fence.
    pub line: usize,
    /// The drawing of it, if one is wanted.
    pub drawing: Option<Drawing>,
}

/// The drawing of an example: the image behind its trace, `![caption](path)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Drawing {
    /// What it shows; the sequence names in it say which points it is about.
    pub caption: String,
    /// Its path, from the file with the rule.
    pub path: String,
}

impl Drawing {
    fn parse(line: &str) -> Option<Self> {
        let (caption, path) = line.strip_prefix("![")?.strip_suffix(')')?.split_once("](")?;
        Some(Self { caption: caption.to_owned(), path: path.to_owned() })
    }
}

impl Example {
    /// The set-up that the example runs on, with the library.
    ///
    /// # Errors
    /// When the set-up text is faulty.
    pub fn setup(&self) -> Result<Setup, SetupError> {
        let mut setup = Setup::from_toml(&self.setup)?;
        setup.library.extend(self.library.iter().cloned());
        setup.validate()?;
        Ok(setup)
    }
}

macro_rules! chapters {
    ($($name:literal)*) => {
        /// The files with rules, in the order of the book, with their texts.
        pub const CHAPTERS: &[(&str, &str)] = &[$(($name, include_str!(concat!("../rules/", $name)))),*];
    };
}

chapters! {
    "e100l/programs.md"
    "e100l/blocks.md"
    "e100l/expressions.md"
    "e100l/functions.md"
    "e100l/variables.md"
    "e100l/control-statements.md"
    "e100l/local-variables.md"
    "e100l/coordinates.md"
    "e100l/motion.md"
    "e100l/arcs.md"
    "e100l/chamfers.md"
    "e100l/angles.md"
    "e100l/compensation.md"
    "e100l/compensation-waiting.md"
    "e100l/compensation-entry.md"
    "e100l/compensation-corners.md"
    "e100l/compensation-arcs.md"
    "e100l/cutter-compensation.md"
    "e100l/torque.md"
    "e100l/threads.md"
    "e100l/threads-continuous.md"
    "e100l/thread-common.md"
    "e100l/thread-cycles.md"
    "e100l/thread-infeed.md"
    "e100l/grooving.md"
    "e100l/tapping.md"
    "e100l/driven-cycles.md"
    "e100l/driven-return.md"
    "e100l/driven-drilling.md"
    "e100l/synchronised-tapping.md"
    "e100l/driven-threads.md"
    "e100l/key-ways.md"
    "e100l/contour-generation.md"
    "e100l/contour-centre.md"
    "e100l/contour-side.md"
    "e100l/coordinate-conversion.md"
    "e100l/lap-contours.md"
    "e100l/lap-common.md"
    "e100l/lap-calls.md"
    "e100l/lap-bar-turning.md"
    "e100l/lap-copying.md"
    "e100l/lap-high-speed.md"
    "e100l/lap-bar-copying.md"
    "e100l/preparatory.md"
    "e100l/spindle.md"
    "e100l/tools.md"
    "e100l/miscellaneous.md"
    "e100l/c-axis.md"
    "e100l/barriers.md"
    "e100l/subprograms.md"
    "e100l/modal-calls.md"
    "e100l/macros.md"
    "e100l/communication.md"
    "e100l/communication-put.md"
    "e100l/io-variables.md"
    "e100l/user-alarms.md"
    "e100l/schedules.md"
    "e100l/schedules-select.md"
    "e100l/two-turrets.md"
    "e100l/two-saddles.md"
    "e100l/synchronisation.md"
    "e100l/acceleration.md"
}

/// Every rule of the OSP-E100L, in the order of the book.
///
/// # Errors
/// The first place where a text does not have the form of a rule.
pub fn e100l() -> Result<Vec<RuleText>, String> {
    let mut rules = Vec::new();
    for (file, text) in CHAPTERS {
        rules.append(&mut Reader::new(file, text).chapter()?);
    }
    Ok(rules)
}

struct Reader<'a> {
    file: &'static str,
    lines: std::iter::Peekable<std::iter::Enumerate<std::str::Lines<'a>>>,
}

impl<'a> Reader<'a> {
    fn new(file: &'static str, text: &'a str) -> Self {
        Self { file, lines: text.lines().enumerate().peekable() }
    }

    fn fault(&self, line: usize, what: &str) -> String {
        format!("spec/rules/{}:{}: {what}", self.file, line + 1)
    }

    fn chapter(&mut self) -> Result<Vec<RuleText>, String> {
        let mut rules = Vec::new();
        while let Some((number, line)) = self.lines.next() {
            if let Some(heading) = line.strip_prefix("### ") {
                rules.push(self.rule(number, heading)?);
            }
        }
        Ok(rules)
    }

    fn rule(&mut self, number: usize, heading: &str) -> Result<RuleText, String> {
        let (id, title) =
            heading.split_once(" · ").ok_or_else(|| self.fault(number, "heading without ` · `"))?;
        let id = RuleId::parse(id).ok_or_else(|| self.fault(number, "unknown rule id"))?;
        let mut rule = RuleText {
            id,
            title: title.to_owned(),
            file: self.file,
            line: number + 1,
            source: String::new(),
            basis: String::new(),
            level: String::new(),
            alarms: Vec::new(),
            statement: String::new(),
            examples: Vec::new(),
        };
        self.properties(&mut rule)?;
        self.body(&mut rule)?;
        rule.statement = rule.statement.trim().to_owned();
        Ok(rule)
    }

    fn properties(&mut self, rule: &mut RuleText) -> Result<(), String> {
        while let Some((number, line)) =
            self.lines.next_if(|(_, line)| line.starts_with("- ") || line.is_empty())
        {
            let Some(property) = line.strip_prefix("- ") else {
                if rule.source.is_empty() {
                    continue;
                } else {
                    break;
                };
            };
            let (key, value) =
                property.split_once(": ").ok_or_else(|| self.fault(number, "property without `: `"))?;
            match key {
                "source" => value.clone_into(&mut rule.source),
                "basis" if ["manual", "interpretation", "unspecified"].contains(&value) => {
                    value.clone_into(&mut rule.basis)
                }
                "level" if ["core", "option", "listed"].contains(&value) => value.clone_into(&mut rule.level),
                "alarms" => {
                    for name in value.split(", ") {
                        let alarm = AlarmName::ALL.iter().find(|alarm| alarm.as_str() == name);
                        rule.alarms.push(*alarm.ok_or_else(|| self.fault(number, "unknown alarm"))?);
                    }
                }
                _ => return Err(self.fault(number, "unknown property or value")),
            }
        }
        if rule.source.is_empty() || rule.basis.is_empty() || rule.level.is_empty() {
            return Err(self.fault(rule.line - 1, "a rule needs source, basis and level"));
        }
        Ok(())
    }

    /// Statement and examples: the last paragraph before a program is its introduction.
    fn body(&mut self, rule: &mut RuleText) -> Result<(), String> {
        let mut prose = String::new();
        while let Some((number, line)) =
            self.lines.next_if(|(_, line)| !line.starts_with("### ") && !line.starts_with("## "))
        {
            match line {
                "```nc" => {
                    let paragraphs = prose.trim_end();
                    let cut = paragraphs.rfind("\n\n").map_or(0, |place| place + 2);
                    let (statement, introduction) = paragraphs.split_at(cut);
                    rule.statement.push_str(statement);
                    let program = unescape(&self.fence(number)?);
                    let introduction = introduction.trim().to_owned();
                    rule.examples.push(Example {
                        introduction,
                        program,
                        library: Vec::new(),
                        setup: String::new(),
                        trace: String::new(),
                        line: number + 1,
                        drawing: None,
                    });
                    prose.clear();
                }
                "```toml" | "```trace" => {
                    let text = self.fence(number)?;
                    let Some(example) = rule.examples.last_mut().filter(|example| example.trace.is_empty())
                    else {
                        return Err(self.fault(number, "a set-up or trace without program"));
                    };
                    *(if line == "```toml" { &mut example.setup } else { &mut example.trace }) = text;
                }
                _ if library_file(line).is_some() => {
                    let text = ProgramText(unescape(&self.fence(number)?));
                    let Some(example) = rule.examples.last_mut().filter(|example| example.trace.is_empty())
                    else {
                        return Err(self.fault(number, "a library file without program"));
                    };
                    example.library.extend(library_file(line).map(|name| (name.to_owned(), text)));
                }
                _ if line.starts_with("![") => {
                    let wanting = |example: &&mut Example| {
                        !example.trace.is_empty() && example.drawing.is_none() && prose.trim().is_empty()
                    };
                    let Some(example) = rule.examples.last_mut().filter(wanting) else {
                        return Err(self.fault(number, "a drawing that is not directly behind a trace"));
                    };
                    let drawing = Drawing::parse(line);
                    example.drawing =
                        Some(drawing.ok_or_else(|| self.fault(number, "a drawing without caption or path"))?);
                }
                _ => {
                    prose.push_str(line);
                    prose.push('\n');
                }
            }
        }
        rule.statement.push_str(&prose);
        match rule.examples.iter().find(|example| example.trace.is_empty()) {
            Some(example) => Err(self.fault(example.line - 1, "a program without trace")),
            None => Ok(()),
        }
    }

    fn fence(&mut self, start: usize) -> Result<String, String> {
        let mut text = String::new();
        for (_, line) in self.lines.by_ref() {
            if line == "```" {
                return Ok(text);
            }
            text.push_str(line);
            text.push('\n');
        }
        Err(self.fault(start, "a fence that does not end"))
    }
}

/// The file name of a fence such as `sub PULL.SUB`.
fn library_file(line: &str) -> Option<&str> {
    let (kind, name) = line.strip_prefix("```")?.split_once(' ')?;
    ["sub", "ssb", "msb", "min"].contains(&kind).then_some(name)
}

/// `\xHH` stands for a byte.
fn unescape(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some((plain, escaped)) = rest.split_once("\\x") {
        bytes.extend_from_slice(plain.as_bytes());
        let code = escaped.get(..2).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(code.unwrap_or(b'\\'));
        rest = escaped.get(if code.is_some() { 2 } else { 0 }..).unwrap_or_default();
    }
    bytes.extend_from_slice(rest.as_bytes());
    bytes
}

#[cfg(test)]
#[allow(clippy::expect_used, clippy::panic)]
mod tests {
    use super::{Drawing, Reader, RuleText, unescape};

    const RULE: &str = "# Chapter\n\n### E100L-G50-02 · Shift\n\n- source: section 4\n- basis: manual\n\
                        - level: core\n- alarms: offset_with_g50, axis_missing\n\nFirst.\n\nSecond.\n";

    fn read(text: &str) -> Result<Vec<RuleText>, String> {
        Reader::new("e100l/test.md", text).chapter()
    }

    /// The fault of the rule with a piece replaced, without the name of the file.
    fn fault(piece: &str, replacement: &str) -> String {
        let fault = read(&RULE.replace(piece, replacement)).err().unwrap_or_default();
        fault.strip_prefix("spec/rules/e100l/test.md:").unwrap_or_default().to_owned()
    }

    #[test]
    fn escapes_are_bytes() {
        assert_eq!(unescape("X\\x0910\n"), b"X\t10\n");
    }

    #[test]
    fn what_is_no_byte_stays_as_it_is() {
        assert_eq!(unescape("A\\xZZ\\x4"), b"A\\ZZ\\4");
    }

    #[test]
    fn a_rule_is_read_with_its_place() {
        let rules = read(RULE).expect("a rule");
        let [rule] = rules.as_slice() else { panic!("one rule") };
        assert_eq!((rule.id.as_str(), rule.title.as_str(), rule.line), ("E100L-G50-02", "Shift", 3));
        assert_eq!(
            (rule.source.as_str(), rule.basis.as_str(), rule.level.as_str()),
            ("section 4", "manual", "core")
        );
        let alarms: Vec<&str> = rule.alarms.iter().map(|alarm| alarm.as_str()).collect();
        assert_eq!(alarms, ["offset_with_g50", "axis_missing"]);
        assert_eq!(rule.statement, "First.\n\nSecond.");
    }

    #[test]
    fn the_last_paragraph_before_a_program_introduces_it() {
        let text = format!("{RULE}\nThird:\n\n```nc\nM02\n```\n\n```toml\nW\n```\n```trace\nend\n```\n");
        let rules = read(&text).expect("a rule");
        let rule = &rules[0];
        assert_eq!(rule.statement, "First.\n\nSecond.");
        let example = &rule.examples[0];
        assert_eq!((example.introduction.as_str(), example.line), ("Third:", 16));
        assert_eq!((example.program.as_slice(), example.setup.as_str()), (b"M02\n".as_slice(), "W\n"));
        assert_eq!(example.trace, "end\n");
    }

    #[test]
    fn a_drawing_belongs_to_the_example_before_it() {
        let text = format!(
            "{RULE}\n```nc\nM02\n```\n```trace\nend\n```\n\n![At N2](drawings/a.svg)\n\nNext.\n\n\
             ```nc\nM30\n```\n```trace\nend\n```\n"
        );
        let rules = read(&text).expect("a rule");
        let [first, second] = rules[0].examples.as_slice() else { panic!("two examples") };
        let drawing = Drawing { caption: "At N2".to_owned(), path: "drawings/a.svg".to_owned() };
        assert_eq!((first.drawing.as_ref(), second.drawing.as_ref()), (Some(&drawing), None));
        assert_eq!(second.introduction, "Next.");
        assert_eq!(rules[0].statement, "First.");
    }

    #[test]
    fn faults_name_the_line() {
        assert_eq!(fault(" · ", " - "), "3: heading without ` · `");
        assert_eq!(fault("G50-02", "NONE-02"), "3: unknown rule id");
        assert_eq!(fault("basis: ", "basis "), "6: property without `: `");
        assert_eq!(fault("basis: manual", "basis: rumour"), "6: unknown property or value");
        assert_eq!(fault("level: core", "level: odd"), "7: unknown property or value");
        assert_eq!(fault("axis_missing", "nothing"), "8: unknown alarm");
        for property in ["source: section 4\n- ", "basis: manual\n- ", "level: core\n- "] {
            assert_eq!(fault(property, ""), "3: a rule needs source, basis and level");
        }
    }

    #[test]
    fn faults_of_examples_name_the_line() {
        let behind = |text: &str| fault("Second.", text);
        assert_eq!(behind("```nc\nM02\n"), "12: a fence that does not end");
        assert_eq!(behind("```nc\nM02\n```"), "12: a program without trace");
        assert_eq!(behind("```trace\nend\n```"), "12: a set-up or trace without program");
        let example = "```nc\nM02\n```\n```trace\nend\n```\n";
        assert_eq!(behind("![a](b)"), "12: a drawing that is not directly behind a trace");
        assert_eq!(
            behind(&format!("{example}Why.\n![a](b)")),
            "19: a drawing that is not directly behind a trace"
        );
        assert_eq!(
            behind(&format!("{example}![a](b)\n![a](b)")),
            "19: a drawing that is not directly behind a trace"
        );
        assert_eq!(behind(&format!("{example}![a]")), "18: a drawing without caption or path");
    }
}

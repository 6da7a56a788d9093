//! Fits the text of a rule into a terminal.

/// The most characters of a line.
const WIDTH: usize = 96;

/// Lines of at most 96 characters, broken at blanks only; rows of a table and indented lines stay whole.
pub fn wrap(text: &str) -> Vec<String> {
    text.trim().lines().flat_map(wrap_line).collect()
}

fn wrap_line(line: &str) -> Vec<String> {
    if line.is_empty() || line.starts_with(['|', ' ']) {
        return vec![line.to_owned()];
    }
    let mut lines = Vec::new();
    let (mut current, mut width) = (String::new(), 0);
    for word in line.split_whitespace() {
        let length = word.chars().count();
        if width > 0 && width + 1 + length > WIDTH {
            lines.push(std::mem::take(&mut current));
            width = 0;
        }
        if width > 0 {
            current.push(' ');
            width += 1;
        }
        current.push_str(word);
        width += length;
    }
    lines.push(current);
    lines
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, wrap};

    #[test]
    fn no_word_is_lost_and_no_line_is_too_long() {
        let text = "a short line\n\n".to_owned() + &"word — ".repeat(60);
        let lines = wrap(&text);
        assert!(lines.iter().all(|line| line.chars().count() <= WIDTH));
        assert_eq!(lines.first().map(String::as_str), Some("a short line"));
        assert!(lines.join(" ").split_whitespace().eq(text.split_whitespace()));
    }

    #[test]
    fn tables_and_long_words_stay_whole() {
        let row = format!("| {} |", "cell ".repeat(40));
        assert_eq!(wrap(&row), [row.as_str()]);
        let word = "x".repeat(2 * WIDTH);
        assert_eq!(wrap(&format!("a {word} b")), ["a", word.as_str(), "b"]);
    }
}

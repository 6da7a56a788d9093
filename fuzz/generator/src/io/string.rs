//! Strings of PUT and of VUACM, and rows of codes.

use crate::builder::Builder;
use crate::program::{Caret, Text};

/// The characters of a string (E100L-GPUT-09).
const CHARACTERS: &[u8] = b"ABCXYZTOOLNUM 0123456789 .=-+/(),:;<>?@[]\\^_!\"#$&*";

/// Strings that look like something else.
const WORDS: &[&str] = &[
    "TOOL OFFSET DATA",
    "N=",
    " X=",
    "(A/B)",
    "$41",
    "-L",
    "M02",
    "GOTO N1",
    "/",
    ";",
    "[",
    "N5 X",
    " ",
    "END",
    "(OPEN",
];

impl Builder<'_, '_, '_> {
    /// A string of at most so many characters, of one at least.
    pub(super) fn text(&mut self, most: usize) -> Text {
        let caret = self.choices.weighted(&[(70, Caret::None), (15, Caret::Before), (15, Caret::Behind)]);
        let word = self.choices.pick(WORDS);
        let mut characters = if word.len() <= most && self.choices.chance(50) {
            word.to_owned()
        } else {
            (0..=self.choices.below(most)).map(|_| char::from(self.choices.pick(CHARACTERS))).collect()
        };
        // A first `^` would be the mark of lower case.
        if caret == Caret::None && characters.starts_with('^') {
            characters.replace_range(..1, "V");
        }
        Text { caret, characters }
    }

    /// A string for a part of the comment: no first `-` or `$` that has a function there.
    pub(super) fn comment_text(&mut self, most: usize) -> (Text, usize) {
        if self.choices.chance(15) {
            let codes = self.codes(most.min(4));
            let text = codes.iter().fold("$".to_owned(), |text, code| text + &format!("{code:02X}"));
            return (Text { caret: Caret::None, characters: text }, codes.len());
        }
        let mut text = self.text(most);
        if text.caret == Caret::None && text.characters.starts_with(['-', '$']) {
            text.characters.replace_range(..1, "K");
        }
        let length = text.characters.len();
        (text, length)
    }

    /// Up to so many codes, of one at least, none of them an end code.
    pub(super) fn codes(&mut self, most: usize) -> Vec<u8> {
        let count = if self.choices.chance(8) { most } else { 1 + self.choices.below(most.min(4)) };
        (0..count)
            .map(|_| match self.choices.below(4) {
                0 => self.choices.pick(&[0x0D, 0x0A, 0x41, 0x7F, 0x5C, 0x2D]),
                1 => self.choices.pick(&[0x01, 0x1F, 0x20, 0x21, 0x7E, 0x80, 0xB6, 0xFF]),
                _ => u8::try_from(self.choices.within(0x26, 0xFF)).unwrap_or(0x41),
            })
            .collect()
    }
}

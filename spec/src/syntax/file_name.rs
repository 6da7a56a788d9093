//! Names of files in PSELECT (E100L-SDF-07, E100L-SDF-10).

use super::cursor::{Cursor, is_alphanumeric, is_blank_after};

/// The name of a file in full.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FileName {
    device: String,
    /// Name and extension.
    pub file: String,
}

impl FileName {
    /// Device, name and extension of a file as it is written; what is left out has a default, the device MD1. None if it
    /// is malformed, or a part without default is left out.
    pub fn read(written: &str, name: Option<&str>, extension: &str) -> Option<Self> {
        let (device, rest) = written.split_once(':').unwrap_or(("MD1", written));
        let (given, extension) = rest.split_once('.').unwrap_or((rest, extension));
        let name = if given.is_empty() { name? } else { given };
        let fits = is_three(device) && is_three(extension) && is_name(name);
        fits.then(|| Self { device: device.to_owned(), file: format!("{name}.{extension}") })
    }

    /// Whether the file is on the device that the files of the library are on.
    pub fn is_on_md1(&self) -> bool {
        self.device == "MD1"
    }

    /// Device, name and extension.
    pub fn full(&self) -> String {
        format!("{}:{}", self.device, self.file)
    }

    /// Its extension.
    pub fn extension(&self) -> &str {
        self.file.rsplit('.').next().unwrap_or_default()
    }
}

/// Takes what stands here up to a blank, a comma or the end of the block; none if nothing does.
pub fn written(cursor: &mut Cursor) -> Option<String> {
    let mut text = String::new();
    while let Some(code) = cursor.peek().filter(|code| *code != b',' && !is_blank_after(Some(*code))) {
        text.push(char::from(code));
        cursor.advance(1);
    }
    (!text.is_empty()).then_some(text)
}

fn is_three(part: &str) -> bool {
    part.len() == 3 && part.bytes().all(is_alphanumeric)
}

/// E100L-PROG-05.
fn is_name(name: &str) -> bool {
    let fits = |code: u8| is_alphanumeric(code) || code == b'-';
    name.len() <= 16 && name.starts_with(|first: char| first.is_ascii_uppercase()) && name.bytes().all(fits)
}

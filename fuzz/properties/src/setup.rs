//! Set-up files: any text is read or refused with its place; what was read is valid and can be written.

use turnspec_generator::Case;
use turnspec_oracle::vocabulary::Setup;

use crate::{Verdict, require};

/// Any text through the reader of set-up files: it does not panic. What it takes is valid, and written as
/// TOML or as JSON it reads back as the same set-up. What it refuses it refuses with a byte span inside the
/// text, at borders of characters, or, when the text is a set-up but its values are impossible, with the name
/// of a field at the beginning of the message. The text is the input itself, and a set-up of the generator
/// (valid by construction, so that it must be taken) before and after a few characters of it are changed.
///
/// Rules: none (the form of the set-up file)
pub(crate) fn setup_files_read_back(input: &[u8]) -> Verdict {
    any_text(&String::from_utf8_lossy(input))?;
    let setup = Case::from_raw(input).setup;
    let text = write(&setup)?;
    require(Setup::from_toml(&text).as_ref() == Ok(&setup), || format!("does not read back:\n{text}"))?;
    let edits = input.get(Case::SETUP_BYTES..).unwrap_or_default();
    any_text(&String::from_utf8_lossy(&edited(text.into_bytes(), edits)))
}

fn write(setup: &Setup) -> Result<String, String> {
    toml::to_string(setup).map_err(|error| format!("cannot write {setup:?}: {error}"))
}

/// The text with a few of its bytes changed or left out, as triples of bytes say.
fn edited(mut text: Vec<u8>, edits: &[u8]) -> Vec<u8> {
    for edit in edits.chunks_exact(3).take(4) {
        let [high, low, byte] = edit else { continue };
        let place = usize::from(u16::from_be_bytes([*high, *low])) % text.len().max(1);
        match (byte, text.get_mut(place)) {
            (0x80.., Some(_)) => drop(text.remove(place)),
            (_, Some(old)) => *old = *byte,
            (_, None) => text.push(*byte),
        }
    }
    text
}

fn any_text(text: &str) -> Verdict {
    match Setup::from_toml(text) {
        Ok(setup) => taken(&setup),
        Err(error) => {
            let fault = match &error.span {
                Some(span) => span.start <= span.end && text.get(span.clone()).is_some(),
                None => toml::from_str::<Setup>(text).is_ok() && names_a_field(&error.message),
            };
            require(fault, || format!("refused without a place: {error:?}\n{text}"))
        }
    }
}

fn taken(setup: &Setup) -> Verdict {
    require(setup.validate().is_ok(), || format!("taken and not valid: {setup:?}"))?;
    let text = write(setup)?;
    require(Setup::from_toml(&text).as_ref() == Ok(setup), || format!("does not read back:\n{text}"))?;
    let json = serde_json::to_string(setup).map_err(|error| format!("cannot write {setup:?}: {error}"))?;
    let again: Setup = serde_json::from_str(&json).map_err(|error| format!("{error}\n{json}"))?;
    require(again == *setup, || format!("does not read back:\n{json}"))
}

/// Whether a message begins with the path of a field.
fn names_a_field(message: &str) -> bool {
    let path = message.split([' ', ':']).next().unwrap_or_default();
    let Ok(table) = toml::Table::try_from(Setup::default()) else { return false };
    let mut here = Some(&toml::Value::Table(table));
    for name in path.split('.') {
        here = here.and_then(|value| value.get(name));
    }
    here.is_some()
}

#[cfg(test)]
mod tests {
    use super::{any_text, names_a_field, taken};
    use turnspec_oracle::vocabulary::{Length, Setup};

    #[test]
    fn fields_are_known_by_their_path() {
        assert!(names_a_field("options.offset_sets is 33") && names_a_field("limits.x: out of range"));
        assert!(
            !names_a_field("colour is red") && !names_a_field("options.colour: red") && !names_a_field("")
        );
    }

    #[test]
    fn refusals_of_both_kinds_are_met() {
        assert_eq!(any_text("[start]\nx = 'far'"), Ok(()));
        assert_eq!(any_text("[start]\nx = 0.0001"), Ok(()));
        assert!(Setup::from_toml("[start]\nx = 0.0001").is_err_and(|error| error.span.is_none()));
    }

    #[test]
    fn an_impossible_setup_is_noticed() {
        let mut setup = Setup::default();
        setup.start.x = Length(1);
        assert!(taken(&setup).is_err());
    }
}

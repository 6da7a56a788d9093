//! PUT: characters into the WRITE area (E100L-GPUT-07 to E100L-GPUT-11).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{AlarmName, PutReal};

use crate::engine::Interpreter;
use crate::engine::fault::Fault;
use crate::engine::system::SystemVariable;
use crate::engine::words::{Operand, Parsed};

use super::number::dimension;
use super::{AREA, Put, Target};

impl Interpreter<'_> {
    /// Carries out PUT.
    pub(super) fn put_characters(&mut self, parsed: &Parsed, put: Put) -> Result<(), Fault> {
        let text = match put {
            // As many blanks as the length says (E100L-GPUT-08).
            Put::Blanks(length) => vec![b' '; length.into()],
            Put::Text(characters) => parsed.text(characters).to_vec(),
            Put::Number(target, length) => {
                let number = self.written_number(parsed, target)?;
                if number.len() > usize::from(length) {
                    return Fault::raise(AlarmName::FieldTooSmall, GPUT_07);
                }
                // At the right of its field, as in the lines that the manual prints (E100L-GPUT-12).
                format!("{number:>0$}", usize::from(length)).into_bytes()
            }
        };
        let area = &mut self.communication;
        if area.written.len() + text.len() > AREA {
            return Fault::raise(AlarmName::WriteAreaFull, GPUT_11);
        }
        area.written.extend_from_slice(&text);
        area.dimensional |= matches!(put, Put::Number(target, _) if target.is_dimensional());
        Ok(())
    }

    /// The number of a variable as PUT writes it.
    fn written_number(&mut self, parsed: &Parsed, target: Target) -> Result<String, Fault> {
        let value = match target {
            Target::Common(number) => {
                Operand::Real(self.state.common.get(usize::from(number)).copied().unwrap_or_default())
            }
            Target::Local(name) => Operand::Real(self.task.read_local(name)?),
            Target::System { variable, suffix } => {
                let suffix = self.left_suffix(parsed, variable, suffix)?;
                if target.is_dimensional() {
                    let shortest = self.setup.readings.put_real == PutReal::Shortest;
                    let (amount, angle) = (self.amount(variable, suffix), variable.is_angle());
                    return Ok(dimension(amount, angle, self.setup.unit_system, shortest));
                }
                self.read_variable(variable, suffix)?
            }
        };
        // The shortest decimal that reads back as the same number, without exponent.
        Ok(match value {
            Operand::Real(value) => value.to_string(),
            Operand::Integer(value) => value.to_string(),
        })
    }
}

impl Target {
    /// Whether it is a length or an angle.
    fn is_dimensional(self) -> bool {
        use SystemVariable as V;
        match self {
            Self::Common(_) | Self::Local(_) => false,
            Self::System { variable, .. } => match variable {
                V::OffsetNumber | V::ToolNumber | V::Restart | V::Pi | V::FullTurn => false,
                V::Input | V::Output | V::InputBit | V::OutputBit | V::Comment => false,
                _ => !variable.is_plain(),
            },
        }
    }
}

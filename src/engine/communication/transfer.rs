//! Carrying out READ, WRITE, GET and PUT (execution of input and output, chapter 4).

use turnspec_oracle::vocabulary::rule_ids::*;
use turnspec_oracle::vocabulary::{Action, AlarmName, EndCode, Label, ReadingSet, RuleSet, Sink, Text};

use crate::engine::Interpreter;
use crate::engine::assignment::Origin;
use crate::engine::fault::Fault;
use crate::engine::words::Parsed;

use super::number::received;
use super::{AREA, Target, Transfer};

impl Interpreter<'_> {
    /// Carries out a statement that exchanges characters.
    pub(in crate::engine) fn transfer(
        &mut self,
        parsed: &Parsed,
        transfer: Transfer,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        match transfer {
            Transfer::Read(channel) => self.receive(channel)?,
            Transfer::Write(channel) => self.send(channel, sink),
            Transfer::Get(target, length) => self.get_number(parsed, target, length, sink)?,
            Transfer::Put(put) => self.put_characters(parsed, put)?,
        }
        if parsed.has_assignment {
            self.state.base = None;
        }
        if self.compensation.acts() {
            self.finish_block(sink)?;
        }
        Ok(())
    }

    /// READ: the next text of a device, up to its end code (E100L-RDWR-01, E100L-RDWR-04).
    fn receive(&mut self, channel: u8) -> Result<(), Fault> {
        let texts = self.setup.devices.get(device(channel).as_str());
        let received = self.communication.received.get_mut(usize::from(channel));
        let text = texts.zip(received.as_deref()).and_then(|(texts, received)| texts.get(*received));
        let (Some(text), Some(received)) = (text, received) else {
            return Fault::raise(AlarmName::DeviceNoData, RDWR_05);
        };
        *received += 1;
        let end_code = match self.setup.parameters.end_code {
            EndCode::Percent => b'%',
            EndCode::Null => 0,
        };
        let text = text.0.split(|code| *code == end_code).next().unwrap_or_default();
        if text.len() > AREA {
            return Fault::raise(AlarmName::ReadTooLong, RDWR_05);
        }
        // The WRITE area is another one, and stays as it is (E100L-RDWR-03).
        self.communication.unread = text;
        Ok(())
    }

    /// WRITE: what the WRITE area holds (E100L-RDWR-02).
    fn send(&mut self, channel: u8, sink: &mut impl Sink) {
        let area = &mut self.communication;
        let text = Text::new(&area.written);
        area.written.clear();
        let dimensional = std::mem::take(&mut area.dimensional);
        let readings = if dimensional { self.known.put_real } else { ReadingSet::default() };
        let end_code = self.setup.parameters.end_code;
        let action = Action::Output { device: device(channel), text, end_code };
        self.emit_with(sink, const { RuleSet::of(&[RDWR_02, RDWR_04]) }, readings, action);
    }

    /// GET: a number from the READ area into a variable, or over a field (E100L-GPUT-01 to E100L-GPUT-05).
    /// One behind the other, as the manual's example takes a tool offset out of a message (E100L-GPUT-06).
    fn get_number(
        &mut self,
        parsed: &Parsed,
        target: Option<Target>,
        length: Option<u8>,
        sink: &mut impl Sink,
    ) -> Result<(), Fault> {
        let suffix = match target {
            Some(Target::System { variable, suffix }) => self.left_suffix(parsed, variable, suffix)?,
            _ => None,
        };
        let unread = self.communication.unread;
        let origin = if length.is_some() { Origin::Field } else { Origin::Rest };
        let length = length.map_or(unread.len(), usize::from);
        let Some((field, rest)) = unread.split_at_checked(length) else {
            return Fault::raise(AlarmName::ReadPointer, GPUT_05);
        };
        // Without a variable the pointer moves over the characters, whatever they are (E100L-GPUT-02).
        let Some(target) = target else {
            self.communication.unread = rest;
            return Ok(());
        };
        let value = received(field).ok_or_else(|| Fault::new(AlarmName::ReceivedNumber, GPUT_05))?;
        self.communication.unread = rest;
        match target {
            Target::Common(number) => self.assign_common(number, value, origin, sink),
            Target::System { variable, .. } => return self.assign(variable, suffix, value, origin, sink),
            Target::Local(name) => return self.assign_local(name, value.real() + 0.0, origin, sink),
        }
        Ok(())
    }
}

/// The device on a channel.
fn device(channel: u8) -> Label {
    let mut label = const { Label::new("CN") };
    label.push(b'0' + channel);
    label
}

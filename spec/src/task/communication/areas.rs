//! The READ area and the WRITE area, each with its pointer (E100L-RDWR-03, E100L-GPUT-04, E100L-GPUT-11).

use std::collections::BTreeMap;

use crate::fault::{Outcome, fail};
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, EndCode, Setup};

/// How many characters an area holds.
const CAPACITY: usize = 160;

/// The two areas, and how many texts each device has sent.
#[derive(Clone, Debug, Default)]
pub struct Areas {
    received: Vec<u8>,
    read_pointer: usize,
    /// The characters up to the write pointer.
    put: Vec<u8>,
    /// Whether a dimensional variable is among them.
    dimensional: bool,
    sent: BTreeMap<u8, usize>,
}

impl Areas {
    /// E100L-RDWR-01, E100L-RDWR-04, E100L-RDWR-05: the next text of a device, up to its end code.
    pub fn read(&mut self, channel: u8, setup: &Setup) -> Outcome<()> {
        let sent = self.sent.entry(channel).or_default();
        let texts = setup.devices.get(&format!("CN{channel}"));
        let Some(text) = texts.and_then(|texts| texts.get(*sent)) else {
            return fail(AlarmName::DeviceNoData, RDWR_05);
        };
        *sent += 1;
        let end_code = match setup.parameters.end_code {
            EndCode::Percent => b'%',
            EndCode::Null => 0,
        };
        let received: Vec<u8> = text.0.iter().copied().take_while(|code| *code != end_code).collect();
        if received.len() > CAPACITY {
            return fail(AlarmName::ReadTooLong, RDWR_05);
        }
        self.received = received;
        self.read_pointer = 0;
        Ok(())
    }

    /// E100L-GPUT-03, E100L-GPUT-05: so many characters from the read pointer on, or all that are left.
    pub fn field(&self, length: Option<usize>) -> Outcome<&[u8]> {
        let left = self.received.get(self.read_pointer..).unwrap_or_default();
        match left.get(..length.unwrap_or(left.len())) {
            Some(field) => Ok(field),
            None => fail(AlarmName::ReadPointer, GPUT_05),
        }
    }

    /// E100L-GPUT-04: the read pointer moves on.
    pub fn pass(&mut self, length: usize) {
        self.read_pointer += length;
    }

    /// E100L-GPUT-11: characters behind those that were put before.
    pub fn append(&mut self, codes: &[u8], dimensional: bool) -> Outcome<()> {
        if self.put.len() + codes.len() > CAPACITY {
            return fail(AlarmName::WriteAreaFull, GPUT_11);
        }
        self.put.extend_from_slice(codes);
        self.dimensional |= dimensional;
        Ok(())
    }

    /// E100L-RDWR-02: the characters that were put, and whether a dimensional variable is among them; the area is
    /// empty then.
    pub fn send(&mut self) -> (Vec<u8>, bool) {
        (std::mem::take(&mut self.put), std::mem::take(&mut self.dimensional))
    }

    /// The reset sets both pointers to the beginning.
    pub fn reset(&mut self) {
        self.read_pointer = 0;
        self.send();
    }
}

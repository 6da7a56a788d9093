//! A loop that reads one text a pass.

use turnspec_oracle::vocabulary::{EndCode, ProgramText};

use crate::builder::Builder;
use crate::control::compare;
use crate::expression::{Operator, Variable};
use crate::program::Statement;

/// How wide the fields of a record are.
const WIDTH: i64 = 4;

impl Builder<'_, '_, '_> {
    /// READ, GET of a number, GET of the rest or over it, as often as the device has texts.
    pub(super) fn records(&mut self) {
        let count = self.choices.within(1, 4);
        let Some(channel) = self.free_device() else { return self.receive() };
        let behind = self.choices.chance(50);
        let end = self.state.setup.parameters.end_code;
        for _ in 0..count {
            let mut text =
                format!("{:4}{:4}", self.choices.within(0, 9_999), self.choices.within(-99, 99)).into_bytes();
            if self.choices.chance(30) {
                text.push(if end == EndCode::Null { 0 } else { b'%' });
            }
            self.state.setup.devices.entry(format!("CN{channel}")).or_default().push(ProgramText(text));
        }
        let counter = Variable::Common(self.choices.within(121, 200) as u8);
        self.set(&counter, 0);
        let first = self.new_name();
        self.set_label(first.clone());
        self.begin();
        self.statement(Statement::Read(channel as i64), Vec::new());
        let targets = [101, 102].map(|least| self.choices.within(least, 118) as u8);
        let [one, other] = targets.map(Variable::Common);
        self.statement(Statement::Get(Some(one.clone()), Some(WIDTH)), Vec::new());
        let last = if behind {
            Statement::Get(Some(other.clone()), None)
        } else {
            Statement::Get(None, Some(WIDTH))
        };
        self.statement(last, Vec::new());
        self.forget(&one);
        if behind {
            self.forget(&other);
        }
        self.forget(&counter);
        self.count(&counter, Operator::Add);
        self.statement(Statement::If(compare(Operator::Lt, &counter, count), first), Vec::new());
        self.known(&counter, count);
        self.state.io.taken[channel] += usize::try_from(count).unwrap_or_default();
        self.state.io.unread.clear();
    }

    /// A device all of whose texts were read.
    fn free_device(&mut self) -> Option<usize> {
        let first = self.choices.below(10);
        let devices = &self.state.setup.devices;
        let texts = |channel: usize| devices.get(&format!("CN{channel}")).map_or(0, Vec::len);
        (0..10)
            .map(|place| (first + place) % 10)
            .find(|channel| texts(*channel) == self.state.io.taken[*channel])
    }
}

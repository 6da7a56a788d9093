//! Faults that depend on modes, on the set-up or on what was assigned.

use super::Fault;
use crate::builder::Builder;
use crate::oneshot::Stop;
use crate::program::{Block, Item, Line};

impl Builder<'_, '_, '_> {
    /// Adds blocks with this fault.
    pub(super) fn state_fault(&mut self, fault: Fault) -> bool {
        let setup = &self.state.setup;
        let (w_axis, torque_limit) = (setup.options.w_axis, setup.parameters.torque_limit_upper);
        let (confirmed, user_task) = (setup.inputs.turret_clamp_confirmed, setup.options.user_task);
        match fault {
            Fault::SequenceNameDuplicate => self.duplicate_name(),
            Fault::AxisMissing if !w_axis => {
                let list = ["G00 W5", "G50 W5", "G29 PW=5", "G22 W5 D1 L1 F1 PW=5", "G01 X1 W2 F1"];
                let text = self.choices.pick(&list);
                self.blocks(&[text])
            }
            Fault::TorqueLimitRange if torque_limit < 100 => self.blocks(&["G29 PZ=100"]),
            Fault::TorqueReachedEarly => self.torque_skip(Stop::Early),
            Fault::TorqueNotReached => self.torque_skip(Stop::Never),
            Fault::CAxisNotJoined if self.state.joined => self.blocks(&["M109", "G00 C5"]),
            Fault::CAxisNotJoined => {
                let text = self.choices.pick(&["G00 C5", "G01 X1 C5 F1", "G91 C1", "G00 QA=2"]);
                self.blocks(&[text])
            }
            Fault::CAxisClamped => {
                let text = self.choices.pick(&["G00 C5 M147", "M147 G01 C5 F1", "G00 C1 Z1 M147"]);
                self.blocks(&["M110", text])
            }
            Fault::MToolNotJoined => {
                let text = self.choices.pick(&["M13", "M14 SB=100", "M13 G00 X1"]);
                self.blocks(&["M109 M152", text])
            }
            Fault::NoFeed if !self.state.feed => {
                let text = self.choices.pick(&["G01 X1", "G01 Z-1", "G02 X5 Z5 L50", "G91 G01 X1 Z1"]);
                self.blocks(&[text])
            }
            Fault::TurretClamp if !confirmed => self.blocks(&["G91 G01 Z0 F1", "G00 M203"]),
            Fault::StmOver if crate::setup::is_over_time(&self.state.setup) => {
                let text = self.choices.pick(&["S5 T0101 M08", "M65", "G97 S5", "T1", "M65 S10"]);
                self.blocks(&["M124", text, "S5 T0101 M08"])
            }
            Fault::RealOverflow => {
                let start = "V1=99999999*99999999";
                let square = "V1=V1*V1";
                let last = self.choices.pick(&["V1=V1*V1", "X=V1*V1", "V2=V1/[1/V1]"]);
                self.blocks(&[start, square, square, square, square, last])
            }
            Fault::FunctionDomain if user_task == 2 && self.choices.chance(30) => {
                let quarter = (90.0 * self.state.units.function_angle()) as i64;
                let turns = self.choices.pick(&[1, -1, 3, 5]);
                self.blocks(&[&format!("V1=TAN[{}]", quarter * turns)])
            }
            Fault::UserTaskLevel if user_task == 1 => {
                let text =
                    self.choices.pick(&["V1=SIN[30]", "V1=1 AND 1", "V1=NOT 0", "X=ABS[5]", "V1=[1/0] OR 1"]);
                self.blocks(&[text])
            }
            Fault::NoProgramEnd => true,
            _ => false,
        }
    }

    /// A sequence name that an earlier block has.
    fn duplicate_name(&mut self) -> bool {
        let known: Vec<String> = self.state.names.iter().cloned().collect();
        let name =
            if known.is_empty() { "7".to_owned() } else { known[self.choices.below(known.len())].clone() };
        let times = if known.is_empty() { 2 } else { 1 };
        for _ in 0..times {
            let delete = self.choices.chance(20);
            let items = vec![Item::m(65)];
            let sequence = Some(name.clone());
            self.lines.push(Line::Block(Block { delete, sequence, items, ..Block::default() }));
        }
        true
    }
}

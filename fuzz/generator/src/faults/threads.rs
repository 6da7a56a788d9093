//! Faults of thread cutting.

use turnspec_oracle::vocabulary::{BalancedInfeed, Feature};

use super::Fault;
use super::thread_texts as texts;
use crate::builder::Builder;
use crate::compensation::Side;
use crate::program::Item;
use crate::state::{Axis, Mode};

const MM: i64 = 1_000_000;

impl Builder<'_, '_, '_> {
    /// A fault of any family, mostly one of threads, LAP or contours where the program is to have them.
    pub(crate) fn any_fault(&mut self) -> Fault {
        if self.threads && self.choices.chance(75) {
            return self.choices.weighted(texts::FAULTS);
        }
        let own = self.some_cutter_fault().or_else(|| self.some_lap_fault());
        let own = own.or_else(|| self.some_contour_fault());
        own.unwrap_or_else(|| self.cycle_fault_or_other())
    }

    /// Adds blocks with this fault.
    pub(super) fn thread_fault(&mut self, fault: Fault) -> bool {
        if !self.threads || !self.allows(Feature::Thread) || self.choices.chance(10) {
            return false;
        }
        if !self.state.compensation.is_on() && !self.ready_for_threads() {
            return false;
        }
        match fault {
            Fault::CompensationNotAllowed => self.thread_in_compensation(),
            Fault::Unspecified if self.choices.chance(12) => self.thread_beside_compensation(),
            _ if self.state.compensation.is_on() => false,
            Fault::AngleUnderdetermined if self.may_be_open() => false,
            _ if let Some(list) = self.behind_an_angle(fault) => self.one_of(list),
            Fault::Unspecified if self.choices.chance(15) => self.one_of(texts::OPENING_TAPERS),
            Fault::Unspecified => {
                if self.choices.chance(40) {
                    self.state.setup.readings.balanced_infeed = BalancedInfeed::Refused;
                }
                self.one_of(texts::NOT_DESCRIBED)
            }
            Fault::ThreadInConstantSpeed => self.one_of(texts::CONSTANT_SPEED),
            Fault::ThreadLeadRange => self.lead_out_of_range(),
            Fault::NoFeed => self.one_of(texts::WITHOUT_LEAD),
            Fault::AngleNoIntersection => self.level_angle(),
            Fault::StepLimit if self.allows(Feature::ControlStatement) => {
                self.choices.chance(60) && self.too_many_passes()
            }
            Fault::StepLimit => false,
            Fault::TravelLimitNegative | Fault::TravelLimitPositive => self.thread_beyond_limit(fault),
            Fault::CoordinateRange => self.thread_out_of_range(),
            Fault::Barrier => self.thread_into_barrier(),
            _ => match texts::FORMS.iter().find(|(known, _)| *known == fault) {
                Some((_, list)) => self.one_of(list),
                None => false,
            },
        }
    }

    /// Texts of a fault behind a block with A alone, now and then where there may be one.
    fn behind_an_angle(&mut self, fault: Fault) -> Option<&'static [&'static str]> {
        if !self.may_be_open() {
            return None;
        }
        let often = match fault {
            Fault::AngleLookahead => 75,
            Fault::AngleNoIntersection => 50,
            _ => 20,
        };
        let (_, list) = texts::BEHIND_AN_ANGLE.iter().find(|(known, _)| *known == fault)?;
        self.choices.chance(often).then_some(*list)
    }

    /// A thread while compensation is in force.
    fn thread_in_compensation(&mut self) -> bool {
        if !self.state.compensation.is_on() {
            self.in_force("");
        }
        self.one_of(texts::IN_COMPENSATION)
    }

    /// A thread in the block that ends compensation, lengths in it, and a displacement that is left over.
    fn thread_beside_compensation(&mut self) -> bool {
        if !self.state.compensation.is_on() {
            self.in_force("");
        }
        self.state.compensation.side = Side::Off;
        self.one_of(texts::BESIDE_COMPENSATION)
    }

    fn lead_out_of_range(&mut self) -> bool {
        // 0.001 mm by many threads, 1001 mm; leads that leave the range before their end.
        let units = self.state.units;
        let small = units.write_length(2 * units.finest()).text();
        let great = units.write_length(1_000 * MM + 2 * units.finest()).text();
        let lead = units.write_length(2 * MM).text();
        let shrinks = units.write_length(-MM).text();
        let amount = units.write_length(MM).text();
        let (x, z) = (units.write_length(-5 * MM).text(), units.write_length(-9 * MM).text());
        let way = format!("G91 X{x} Z{z}");
        let text = match self.choices.below(10) {
            0 => format!("G33 {way} F{small} J9"),
            1 => format!("G71 {way} D{amount} H{amount} F{small} J999 M74"),
            2 => format!("G34 {way} F{great}"),
            3 => format!("G32 {way} F{great}"),
            4 => format!("G33 {way} F{lead} E{shrinks}"),
            5 => format!("G35 {way} F{lead} E{amount}"),
            6 => format!("G71 {way} F{lead} E{shrinks} D{amount} H{amount} M74"),
            7 => format!("G32 {way} F{lead} E{shrinks}"),
            8 => format!("G72 {way} F{lead} E{shrinks} D{amount} H{amount} M74"),
            _ => format!("G34 {way} F{lead} E{}", units.write_length(90_000 * MM).text()),
        };
        self.blocks(&[&text])
    }

    /// A taper at an angle that does not reach the end.
    fn level_angle(&mut self) -> bool {
        let turn = self.choices.pick(&[0, 180, -180]) * MM;
        let units = self.state.units;
        let [along, square] = [turn, turn + 90 * MM].map(|angle| units.write_angle(angle).text());
        let text = match self.choices.below(6) {
            0 => format!("G33 G91 X-5 Z-9 F2 A{square}"),
            1 => format!("G32 G91 X-9 Z-5 F2 A{along}"),
            2 => format!("G71 G91 X-5 Z-9 F2 A{square} D1 H1 M74"),
            3 => format!("G72 G91 X-9 Z-5 F2 A{along} D1 H1 M74"),
            4 => format!("G34 G91 Z5 F2 A{square}"),
            _ => format!("G35 G91 X5 F2 A{along}"),
        };
        self.blocks(&[&text])
    }

    /// A cycle with more passes than the run has steps.
    fn too_many_passes(&mut self) -> bool {
        let Some((_, list)) = texts::FORMS.iter().find(|(fault, _)| *fault == Fault::StepLimit) else {
            return false;
        };
        self.state.setup.limits.steps =
            self.state.setup.limits.steps.min(self.choices.within(8, 60).unsigned_abs());
        self.one_of(list)
    }

    /// A limit close to the present position, and a thread of which one motion lies beyond it.
    fn thread_beyond_limit(&mut self, fault: Fault) -> bool {
        if self.state.is_eia() || !self.allows(Feature::SystemVariable) {
            return false;
        }
        let axis = if self.choices.chance(50) { Axis::X } else { Axis::Z };
        let positive = fault == Fault::TravelLimitPositive;
        let name = format!("V{}VL{}", if positive { 'P' } else { 'N' }, axis.address());
        let away = if positive { 3 * MM } else { -3 * MM };
        let limit = self.state.units.write_length((self.state.machine[axis as usize] + away) / 1_000 * 1_000);
        self.raw(format!("{name}={}", limit.text()).as_bytes());
        let sign = if positive { 1 } else { -1 };
        let ways = [(Axis::X, self.state.sign(Axis::X)), (Axis::Z, 1)];
        let [x, z] = ways.map(|(other, turned)| {
            let way = if other == axis {
                sign * self.choices.pick(&[4, 20])
            } else {
                self.choices.pick(&[-2, -9, 2])
            };
            self.state.units.write_length(turned * way * MM).text()
        });
        let amount = self.state.units.write_length(MM).text();
        let text = match self.choices.below(4) {
            0 => format!("G33 G91 X{x} Z{z} F{amount}"),
            1 => format!("G32 G91 X{x} Z{z} F{amount}"),
            2 => format!("G34 G91 X{x} Z{z} F{amount}"),
            _ => format!("G71 G91 X{x} Z{z} D{amount} H{amount} F{amount} M74"),
        };
        self.blocks(&[&text])
    }

    fn thread_out_of_range(&mut self) -> bool {
        let far = if self.state.units.system.is_inch() { 250_000 * MM } else { 99_999_999_000 };
        let far = self.state.units.write_length(if self.choices.chance(50) { far } else { -far }).text();
        let text = match self.choices.below(3) {
            0 => format!("G33 X-5 Z{far} F2"),
            1 => format!("G34 Z{far} F2"),
            _ => format!("G32 X{far} Z-5 F2"),
        };
        self.blocks(&["G91", &text, &text])
    }

    /// A pass or a length through a jaw beside the present point.
    fn thread_into_barrier(&mut self) -> bool {
        if !self.allows(Feature::Barrier) || !self.jaw_beside() {
            return false;
        }
        self.state.mode = Mode::ThreadAlong;
        self.state.incremental = true;
        let units = self.state.units;
        let code = self.choices.pick(&[31, 33, 34]);
        let (x, z) = (units.write_length(2 * MM), units.write_length(-30 * MM));
        let lead = units.write_length(MM);
        let items = vec![
            Item::g(91),
            Item::g(code),
            Item::plain("X", x),
            Item::plain("Z", z),
            Item::plain("F", lead),
            Item::m(25),
        ];
        self.push(items);
        true
    }
}

//! Blocks of G73, G74 and G183 with any amounts: how many pecks they have, how deep, and where the tool goes between them.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{
    ChipDischarge, CycleReturn, Event, Length, Part, PeckRetract, Position, Setup,
};

use crate::cycles::{blocks_are_whole, infeed};
use crate::differential::show;
use crate::shape::{motion, trace};
use crate::{Verdict, require};

/// Micrometres to nanometres.
const MICRO: i64 = 1_000;

/// The cycle start, X and Z in micrometres.
const START: i64 = 100_000;

/// A block of G73, G74 or G183 in the unit system of 1 mm; amounts in micrometres.
#[derive(Clone, Debug)]
pub(crate) struct Bore {
    code: Code,
    /// Along X, and in the positive direction.
    along_x: bool,
    forward: bool,
    approach: i64,
    /// From the cutting start to the bottom.
    depth: i64,
    step: i64,
    between: Option<i64>,
    retract: i64,
    setup: Setup,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Code {
    Groove,
    Drill,
}

impl<'a> Arbitrary<'a> for Bore {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let depth: i64 = bytes.int_in_range(2..=30_000)?;
        let step = match bytes.int_in_range(0..=4)? {
            0 => depth / bytes.int_in_range(1..=9)?,
            1 => depth + bytes.int_in_range(-1..=1)?,
            _ => bytes.int_in_range(depth / 20 + 1..=depth)?,
        };
        let step = step.max(depth / 20 + 1);
        let mut setup = Setup::default();
        let readings = &mut setup.readings;
        readings.peck_retract = *bytes.choose(&[PeckRetract::Diameter, PeckRetract::Radius])?;
        readings.chip_discharge = *bytes.choose(&[ChipDischarge::CuttingStart, ChipDischarge::CycleStart])?;
        let parameters = &mut setup.parameters;
        parameters.cycle_return = *bytes.choose(&[CycleReturn::CuttingStart, CycleReturn::CycleStart])?;
        let retract = *bytes.choose(&[100, 0, 500, 333, depth, 99_999])?;
        (parameters.grooving_retract, parameters.drilling_retract) =
            (Length(retract * MICRO), Length(retract * MICRO));
        Ok(Self {
            code: *bytes.choose(&[Code::Groove, Code::Drill])?,
            along_x: bytes.arbitrary()?,
            forward: bytes.arbitrary()?,
            approach: *bytes.choose(&[0, 1_000, 2_500, 1])?,
            depth,
            step,
            between: if bytes.arbitrary()? { Some(bytes.int_in_range(1..=2 * depth)?) } else { None },
            retract,
            setup,
        })
    }
}

/// A motion of a bore: what it does, its number, and how deep it ends, from the cutting start.
type Shown = (Part, u32, i64);

impl Bore {
    /// The bore, and the same with one increment more in one of its amounts.
    pub(crate) fn nudged(self) -> [Self; 4] {
        let with = |change: fn(&mut Self)| {
            let mut bore = self.clone();
            change(&mut bore);
            bore
        };
        [
            self.clone(),
            with(|bore| bore.depth += 1),
            with(|bore| bore.step += 1),
            with(|bore| bore.between = bore.between.map(|between| between + 1)),
        ]
    }

    fn direction(&self) -> i64 {
        if self.forward { 1 } else { -1 }
    }

    fn case(&self) -> Case {
        let length = |amount: i64| format!("{}", amount as f64 / 1_000.0);
        let (axis, approach) = if self.along_x { ("X", "I") } else { ("Z", "K") };
        let between = self.between.map(|between| format!(" L{}", length(between))).unwrap_or_default();
        let words = format!("{approach}{} D{}{between}", length(self.approach), length(self.step));
        let (start, away) = (length(START), self.direction() * self.depth);
        let program = match self.code {
            Code::Groove => {
                let code = if self.along_x { "G73" } else { "G74" };
                let bottom = length(START + away + self.direction() * self.approach);
                format!("G00 X{start} Z{start}\n{code} {axis}{bottom} {words} F0.1\nM02\n")
            }
            Code::Drill => format!(
                "M110\nM146\nG94 F100\nG00 X{start} Z{start}\nG183 R{} {words}\nG180\nX{start} Z{start}\nM02\n",
                length(away)
            ),
        };
        Case { setup: self.setup.clone(), program: program.into_bytes() }
    }

    /// Statements 1 to 5.
    pub(crate) fn holds(&self) -> Verdict {
        let case = self.case();
        let events = trace(&case);
        blocks_are_whole(&events)
            .and_then(|()| self.judge(&events))
            .map_err(|message| format!("{message}\n{}", show(&case)))
    }

    /// A depth of a motion, from the cutting start, in nanometres.
    fn depth_of(&self, position: Position) -> i64 {
        let level = START + self.direction() * self.approach;
        self.direction() * (infeed(self.along_x, position) - level * MICRO)
    }

    fn judge(&self, events: &[Event]) -> Verdict {
        let motions: Vec<_> =
            events.iter().filter_map(motion).filter(|motion| motion.part.is_some()).collect();
        let shown: Vec<Shown> = motions
            .iter()
            .filter_map(|motion| Some((motion.part?, motion.pass?, self.depth_of(motion.machine))))
            .collect();
        let cuts: Vec<i64> =
            shown.iter().filter(|(part, ..)| *part == Part::Cut).map(|(.., depth)| *depth).collect();
        let pecks = (self.depth + self.step - 1) / self.step;
        require(cuts.len() as i64 == pecks, || format!("{} pecks, not {pecks}", cuts.len()))?;
        require(motions.len() as i64 <= 3 * pecks + 4, || format!("{} motions", motions.len()))?;
        let mut before = 0;
        for depth in &cuts {
            let step = depth - before;
            require((1..=self.step * MICRO).contains(&step), || format!("a peck of {step} nm: {cuts:?}"))?;
            before = *depth;
        }
        require(before == self.depth * MICRO, || format!("pecks of {before} nm: {cuts:?}"))?;
        self.returns(&shown, pecks)
    }

    /// Statement 4.
    fn returns(&self, shown: &[Shown], pecks: i64) -> Verdict {
        let radius = self.along_x && self.setup.readings.peck_retract == PeckRetract::Radius;
        let retract = self.retract * MICRO * if radius { 2 } else { 1 };
        let to_start =
            self.code == Code::Groove || self.setup.readings.chip_discharge == ChipDischarge::CycleStart;
        let out = if to_start { -self.approach * MICRO } else { 0 };
        let every = self.between.map(|between| (between + self.step - 1) / self.step);
        let mut place = 0;
        for number in 1..pecks {
            let done = number * self.step * MICRO;
            let back = (done - retract).max(0);
            let own: Vec<Shown> = shown
                .iter()
                .copied()
                .filter(|(part, pass, _)| {
                    let number = number as u32;
                    match part {
                        Part::Retract | Part::Withdraw => *pass == number,
                        Part::Reentry => *pass == number + 1,
                        _ => false,
                    }
                })
                .collect();
            let discharges = every.is_some_and(|every| number % every == 0);
            place += own.len();
            let last = own.last().map_or(done, |(.., depth)| *depth);
            require(last == back, || format!("back to {last}, not {back}, behind peck {number}"))?;
            let withdrawn = own.iter().find(|(part, ..)| *part == Part::Withdraw);
            require(withdrawn.is_none() || discharges, || {
                format!("the tool withdraws behind peck {number}")
            })?;
            let level = withdrawn.map(|(.., depth)| *depth);
            require(!discharges || level == Some(out), || {
                format!("out to {level:?}, not {out}, behind peck {number}")
            })?;
        }
        let cuts = shown.iter().filter(|(part, ..)| *part == Part::Cut).count();
        require(shown.len() == place + cuts, || "motions that belong to no peck".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use arbitrary::Unstructured;
    use turnspec_oracle::vocabulary::{Event, Part, Setup};

    use super::{Bore, Code};
    use crate::bytes_of_seed;
    use crate::cycles::blocks_are_whole;
    use crate::shape::trace;

    fn bore(code: Code) -> Bore {
        Bore {
            code,
            along_x: false,
            forward: false,
            approach: 2_000,
            depth: 10_000,
            step: 3_000,
            between: Some(6_000),
            retract: 100,
            setup: Setup::default(),
        }
    }

    /// What is wrong with the trace of a bore after a change of its n-th motion of a part.
    fn verdict(
        code: Code,
        part: Part,
        n: usize,
        change: impl Fn(&mut Vec<Event>, usize),
    ) -> Result<(), String> {
        let bore = bore(code);
        let mut events = trace(&bore.case());
        let is_it =
            |event: &Event| crate::shape::motion(event).is_some_and(|motion| motion.part == Some(part));
        let place =
            events.iter().enumerate().filter(|(_, event)| is_it(event)).nth(n).map(|(place, _)| place);
        change(&mut events, place.expect("there is such a motion"));
        blocks_are_whole(&events).and_then(|()| bore.judge(&events))
    }

    fn lower(event: &mut Event, by: i64) {
        use turnspec_oracle::vocabulary::Action;
        if let Action::Rapid { motion } | Action::Linear { motion, .. } = &mut event.action {
            motion.machine.z.0 += by;
        }
    }

    #[test]
    fn holes_that_are_wrong_are_noticed() {
        for code in [Code::Groove, Code::Drill] {
            assert_eq!(verdict(code, Part::Cut, 0, |_, _| ()), Ok(()));
            let wrong = |part, n, change: &dyn Fn(&mut Vec<Event>, usize)| {
                verdict(code, part, n, change).expect_err(&format!("{code:?}, {part:?} {n}: it is noticed"))
            };
            let moved = |by: i64| move |events: &mut Vec<Event>, place: usize| lower(&mut events[place], by);
            assert!(wrong(Part::Cut, 1, &moved(-1)).contains("nm deeper"));
            assert!(wrong(Part::Cut, 3, &moved(-1)).contains("pecks of"));
            assert!(wrong(Part::Cut, 3, &moved(1)).contains("pecks of"));
            assert!(wrong(Part::Retract, 0, &moved(1)).contains("back to"));
            assert!(wrong(Part::Withdraw, 0, &moved(1)).contains("out to"));
            assert!(wrong(Part::Return, 0, &moved(1)).contains("ends"));
            let removed = |events: &mut Vec<Event>, place: usize| {
                events.remove(place);
            };
            assert!(wrong(Part::Cut, 3, &removed).contains("pecks, not"));
            assert!(wrong(Part::Reentry, 0, &removed).contains("back to"));
        }
    }

    #[test]
    fn many_pecks_are_tried() {
        let bores = (0..300).filter_map(|seed| {
            arbitrary::Arbitrary::arbitrary(&mut Unstructured::new(&bytes_of_seed(seed, 512))).ok()
        });
        let bores: Vec<Bore> = bores.collect();
        let discharged = bores.iter().filter(|bore| bore.between.is_some_and(|between| between < bore.depth));
        assert!(discharged.count() > 40);
        assert!(bores.iter().filter(|bore| bore.depth % bore.step == 0).count() > 30);
        bores.iter().for_each(|bore| assert_eq!(bore.holds(), Ok(())));
    }
}

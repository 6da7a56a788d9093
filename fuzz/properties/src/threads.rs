//! Threads: every pass is whole, and the passes of G71 and G72 are as many and as deep as the patterns say.

use arbitrary::{Arbitrary, Result, Unstructured};
use turnspec_generator::Case;
use turnspec_oracle::vocabulary::{
    Action, AlarmName, BalancedInfeed, Event, LeadAxis, Part, Position, Setup, Side, ThreadFlank,
};

use crate::differential::show;
use crate::shape::{is_of_thread, motion, trace};
use crate::thread_counts::{Heights, Pattern};
use crate::{Verdict, require};

/// Micrometres to nanometres.
const MICRO: i64 = 1_000;

/// The cycle start of the cycles, X and Z in micrometres.
const START: (i64, i64) = (100_000, 100_000);

/// Of a program of the generator, and of the cycles below:
///
/// 1. **Whole passes.** The motions of a pass are `approach`, `cut`, up to two `exit`, `retract`, `return`, in this order;
///    those of the parts between that lead nowhere are left out. All passes of a block end in one point. `pass` counts
///    without a gap. A lead is 0.001 to 1000 mm.
///
/// Of a block of G71 or G72 with any D, H, allowance, pattern, flank, infeed angle, number of starts and readings, and of
/// the same block with one increment more in D, in H and in the allowance:
///
/// 2. **Number.** The number of passes is that which the thresholds of the pattern give, counted on whole micrometres; so
///    an increment changes it only when it crosses one of them. Where the pattern is refused, there is no pass.
/// 3. **Bound.** With r = H/D and U the allowance there are at most 5 + max(r, r²) + H/(2U) depths (without the last term
///    when U is zero), and for each of them Q passes.
/// 4. **Depth.** Depths grow from pass to pass and end at H; their steps sum to H. With an allowance the last but one is at
///    H − U. No step of M73 and M74 is deeper than D.
/// 5. **Starts.** All starts of a depth have its level and its flank, start k the angle (k − 1)·360/Q.
/// 6. **Flank.** The last pass is not shifted; the others are toward the side that code and reading say, less and less.
///
/// Rules: E100L-G33-04, E100L-G71-02, E100L-G71-03, E100L-G71-07, E100L-G71-10, E100L-G72-02, E100L-TINF-02, E100L-TINF-03,
/// E100L-TINF-04, E100L-TINF-05, E100L-TINF-06, E100L-TINF-07, E100L-TMOD-02, E100L-TMOD-03, E100L-TMOD-04, E100L-TMUL-01,
/// E100L-TMUL-02
pub(crate) fn threads_are_whole(input: &[u8]) -> Verdict {
    let mut bytes = Unstructured::new(input);
    if let Ok(cycle) = Cycle::arbitrary(&mut bytes) {
        for cycle in cycle.nudged() {
            cycle.holds()?;
        }
    }
    let Ok(case) = Case::arbitrary(&mut Unstructured::new(input)) else { return Ok(()) };
    passes_are_whole(&trace(&case)).map_err(|message| format!("{message}\n{}", show(&case)))
}

/// The order of the motions of a pass; a part that no thread has comes behind all of them.
fn rank(part: Part) -> u32 {
    match part {
        Part::Approach => 0,
        Part::Cut => 1,
        Part::Exit => 2,
        Part::Retract => 3,
        Part::Return => 4,
        _ => 5,
    }
}

/// Statement 1.
fn passes_are_whole(events: &[Event]) -> Verdict {
    for saddle in [None, Some(Side::A), Some(Side::B)] {
        let own = events.iter().filter(|event| event.saddle == saddle);
        let mut before: Option<(u32, Part, u32)> = None;
        let mut back: Option<(u32, Position)> = None;
        for event in own {
            let passed = motion(event)
                .filter(|_| is_of_thread(event))
                .and_then(|motion| Some((motion.part?, motion.pass?, motion.machine)));
            if let Action::Thread { lead, spindle: None, .. } = event.action {
                let range = 1_000_000..=1_000_000_000_000;
                require(range.contains(&lead.0), || format!("a lead out of range: {event:?}"))?;
            }
            let Some((part, pass, end)) = passed else {
                before = None;
                continue;
            };
            let last = before.filter(|(block, ..)| *block == event.block.start);
            follows(last.map(|(_, part, pass)| (part, pass)), (part, pass))
                .map_err(|message| format!("{message}: {event:?}"))?;
            if part == Part::Return {
                let again =
                    last.is_some() && pass > 1 && back.is_some_and(|(block, _)| block == event.block.start);
                require(!again || back == Some((event.block.start, end)), || {
                    format!("a pass ends elsewhere: {event:?}")
                })?;
                back = Some((event.block.start, end));
            } else if part == Part::Approach && last.is_none() {
                back = None;
            }
            before = Some((event.block.start, part, pass));
        }
    }
    Ok(())
}

/// Whether a motion may stand behind the one before it in its block.
fn follows(before: Option<(Part, u32)>, (part, pass): (Part, u32)) -> Verdict {
    match before {
        Some((last, number)) if last != Part::Return => {
            let exits = part == Part::Exit && last == Part::Exit;
            require(rank(last) < rank(part) || exits, || format!("{last:?} before {part:?}"))?;
            require(number == pass, || "a pass changes its number".to_owned())
        }
        _ => {
            require(part == Part::Approach, || format!("a pass begins with {part:?}"))?;
            let next = before.is_none_or(|(_, number)| pass == 1 || pass == number || pass == number + 1);
            require(next, || "a pass is left out".to_owned())
        }
    }
}

/// A block of G71 or G72 in the unit system of 1 mm; amounts in micrometres.
#[derive(Clone, Debug)]
struct Cycle {
    face: bool,
    outside: bool,
    heights: Heights,
    pattern: Pattern,
    /// M32 to M34.
    flank: u16,
    /// In thousandths of a degree.
    angle: i64,
    starts: i64,
    setup: Setup,
}

impl<'a> Arbitrary<'a> for Cycle {
    fn arbitrary(bytes: &mut Unstructured<'a>) -> Result<Self> {
        let mut setup = Setup::default();
        setup.parameters.m75_pattern = *bytes.choose(&[3, 4])?;
        setup.readings.balanced_infeed = *bytes.choose(&[
            BalancedInfeed::EqualArea,
            BalancedInfeed::EqualArea,
            BalancedInfeed::Refused,
        ])?;
        setup.readings.thread_flank = *bytes.choose(&[ThreadFlank::Negative, ThreadFlank::Positive])?;
        let height = bytes.int_in_range(200..=9_000)?;
        let allowance = *bytes.choose(&[0, 0, height / 10, height / 3, height - 1, 40])?.min(&(height - 1));
        let target = height - allowance;
        let step = match bytes.int_in_range(0..=6)? {
            // On the thresholds of the patterns and beside them.
            0 => target / bytes.int_in_range(1..=8)?,
            1 => ((height * height - target * target) as f64).sqrt() as i64 + bytes.int_in_range(-1..=1)?,
            2 => (target as f64 / f64::from(bytes.int_in_range(1..=9_u8)?).sqrt()) as i64,
            3 => target + bytes.int_in_range(-1..=1)?,
            _ => bytes.int_in_range(height / 12..=height + 500)?,
        };
        Ok(Self {
            face: bytes.arbitrary()?,
            outside: bytes.arbitrary()?,
            heights: Heights { step: step.max(height / 12), height, allowance },
            pattern: *bytes.choose(&[Pattern::Halving, Pattern::Steps, Pattern::Areas])?,
            flank: *bytes.choose(&[32, 33, 34])?,
            angle: *bytes.choose(&[0, 60_000, 55_000, 90_000, 1])?,
            starts: *bytes.choose(&[1, 1, 2, 3])?,
            setup,
        })
    }
}

/// What a pass of a cycle shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Shown {
    pass: i64,
    /// How far the level lies from that of the last pass, and the start of the thread from the cycle start.
    above: i64,
    shift: i64,
    start: i64,
}

impl Cycle {
    /// The cycle, and the same with one increment more in one of its amounts.
    fn nudged(self) -> [Self; 4] {
        let with = |change: fn(&mut Heights)| {
            let mut cycle = self.clone();
            change(&mut cycle.heights);
            cycle
        };
        [
            self.clone(),
            with(|heights| heights.step += 1),
            with(|heights| heights.height += 1),
            with(|heights| heights.allowance += i64::from(heights.allowance + 1 < heights.height)),
        ]
    }

    /// The level of the last pass and the end along the lead axis.
    fn target(&self) -> (i64, i64) {
        let (lead, level) = if self.face { START } else { (START.1, START.0) };
        (if self.outside { level - 60_000 } else { level + 60_000 }, lead - 80_000)
    }

    fn case(&self) -> Case {
        let (level, end) = self.target();
        let length = |amount: i64| format!("{}", amount as f64 / 1_000.0);
        let (x, z) = if self.face { (end, level) } else { (level, end) };
        let (code, allowance) = if self.face { ("G72", "W") } else { ("G71", "U") };
        let Heights { step, height, allowance: rest } = self.heights;
        let program = format!(
            "G00 X{} Z{}\n{code} X{} Z{} D{} H{} {allowance}{} B{} Q{} F1.5 M{} M{}\nM02\n",
            length(START.0),
            length(START.1),
            length(x),
            length(z),
            length(step),
            length(height),
            length(rest),
            length(self.angle),
            self.starts,
            self.flank,
            self.pattern.code(),
        );
        Case { setup: self.setup.clone(), program: program.into_bytes() }
    }

    /// Statements 1 to 6.
    fn holds(&self) -> Verdict {
        let case = self.case();
        let events = trace(&case);
        passes_are_whole(&events)
            .and_then(|()| self.judge(&events))
            .map_err(|message| format!("{message}\n{}", show(&case)))
    }

    fn judge(&self, events: &[Event]) -> Verdict {
        let shown: Vec<Shown> = events.iter().filter_map(|event| self.shown(event)).collect();
        let alarm = events.iter().find_map(|event| match event.action {
            Action::Alarm(alarm) => Some(alarm.name),
            _ => None,
        });
        let Some(count) = self.heights.passes(self.pattern, self.flank == 33, &self.setup) else {
            let refused = matches!(alarm, Some(AlarmName::ThreadData | AlarmName::Unspecified));
            return require(refused && shown.is_empty(), || format!("the pattern is not refused: {alarm:?}"));
        };
        require(alarm.is_none(), || format!("an alarm: {alarm:?}"))?;
        let most = self.heights.most_passes();
        require(count <= most, || format!("{count} depths, more than {most}"))?;
        require(shown.len() as i64 == count * self.starts, || {
            format!("{} passes, not {count} times {}", shown.len(), self.starts)
        })?;
        let mut depths = Vec::new();
        for (group, number) in shown.chunks(self.starts as usize).zip(1..) {
            for (one, start) in group.iter().zip(0..) {
                let angle = (2 * start * 360_000_000 + self.starts) / (2 * self.starts);
                let like = Shown { pass: number, start: angle, ..group[0] };
                require(*one == like, || format!("start {start} of depth {number}: {one:?}"))?;
            }
            depths.push(group[0]);
        }
        self.depths(&depths)?;
        self.flanks(&depths)
    }

    /// What an event shows, if it cuts.
    fn shown(&self, event: &Event) -> Option<Shown> {
        let Action::Thread { motion, axis, start, .. } = event.action else { return None };
        let (level, end) = self.target();
        let (lead, reached) = match axis {
            LeadAxis::Z => (motion.program.z.0, motion.program.x.0),
            LeadAxis::X => (motion.program.x.0, motion.program.z.0),
        };
        let above = if self.outside { reached - level * MICRO } else { level * MICRO - reached };
        Some(Shown {
            pass: motion.pass.map_or(0, i64::from),
            above,
            shift: lead - end * MICRO,
            start: start.unwrap_or_default().0,
        })
    }

    /// Statement 4.
    fn depths(&self, shown: &[Shown]) -> Verdict {
        let Heights { step, height, allowance } = self.heights;
        let depths: Vec<i64> = shown.iter().map(|shown| height * MICRO - shown.above).collect();
        let mut before = 0;
        for depth in &depths {
            require(*depth > before, || format!("the depths do not grow: {depths:?}"))?;
            let finishing = allowance > 0 && *depth == height * MICRO;
            let deepest = if self.pattern == Pattern::Areas || finishing { i64::MAX } else { step };
            let steps = depth - before;
            require(steps <= deepest.saturating_mul(MICRO), || format!("a step of {steps} nm: {depths:?}"))?;
            before = *depth;
        }
        require(before == height * MICRO, || format!("the last depth is not H: {depths:?}"))?;
        let last_but_one = depths.iter().rev().nth(1).copied();
        require(allowance == 0 || last_but_one == Some((height - allowance) * MICRO), || {
            format!("the last but one is not H - U: {depths:?}")
        })
    }

    /// Statement 6.
    fn flanks(&self, shown: &[Shown]) -> Verdict {
        let negative = self.setup.readings.thread_flank == ThreadFlank::Negative;
        let mut before = i64::MAX;
        for one in shown {
            let left = match self.flank {
                32 => true,
                33 => one.pass % 2 != 0,
                _ => false,
            };
            let sign = if left == negative { -1 } else { 1 };
            let size = sign * one.shift;
            let tangent = (self.angle as f64 / 2_000.0).to_radians().tan();
            let wanted = one.above as f64 * tangent * if self.face { 2.0 } else { 0.5 };
            require((size as f64 - wanted).abs() <= 1.0, || {
                format!("a shift of {size} nm, not {wanted}: {one:?}")
            })?;
            require(size <= before, || format!("a shift that grows: {one:?}"))?;
            before = size;
        }
        require(shown.last().is_none_or(|last| last.shift == 0), || "the last pass is shifted".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use arbitrary::Unstructured;
    use turnspec_oracle::vocabulary::{Action, Event, Part, Setup};

    use super::{Cycle, passes_are_whole};
    use crate::bytes_of_seed;
    use crate::shape::trace;
    use crate::thread_counts::{Heights, Pattern};

    fn cycle() -> Cycle {
        Cycle {
            face: false,
            outside: true,
            heights: Heights { step: 1_000, height: 3_000, allowance: 200 },
            pattern: Pattern::Steps,
            flank: 33,
            angle: 60_000,
            starts: 2,
            setup: Setup::default(),
        }
    }

    /// What is wrong with the trace of a cycle after a change.
    fn verdict(change: impl Fn(&mut Vec<Event>)) -> Result<(), String> {
        let mut events = trace(&cycle().case());
        change(&mut events);
        passes_are_whole(&events).and_then(|()| cycle().judge(&events))
    }

    /// The place of the cut of the n-th pass.
    fn cut(events: &[Event], n: usize) -> usize {
        let cuts = |event: &Event| matches!(event.action, Action::Thread { .. });
        events.iter().enumerate().filter(|(_, event)| cuts(event)).nth(n).map_or(0, |(place, _)| place)
    }

    fn moved(event: &mut Event, x: i64, z: i64) {
        if let Action::Thread { motion, .. } = &mut event.action {
            motion.program.x.0 += x;
            motion.program.z.0 += z;
        }
    }

    #[test]
    fn passes_that_are_wrong_are_noticed() {
        assert_eq!(verdict(|_| ()), Ok(()));
        let changed = |change: &dyn Fn(&mut Vec<Event>)| verdict(change).expect_err("it is noticed");
        let without = |n: usize, events: &mut Vec<Event>| {
            let place = cut(events, n);
            events.drain(place - 1..place + 3);
        };
        assert!(changed(&|events| without(7, events)).contains("passes, not"));
        assert!(changed(&|events| without(2, events)).contains("passes, not"));
        let last = |events: &mut Vec<Event>| {
            for n in [6, 7] {
                let place = cut(events, n);
                moved(&mut events[place], 1, 0);
            }
        };
        assert!(changed(&last).contains("not H"));
        let deeper = |events: &mut Vec<Event>| {
            for n in [0, 1] {
                let place = cut(events, n);
                moved(&mut events[place], -100_000, 0);
            }
        };
        assert!(changed(&deeper).contains("a step of"));
        let flank = |events: &mut Vec<Event>| {
            for n in [2, 3] {
                let place = cut(events, n);
                moved(&mut events[place], 0, -5_000);
            }
        };
        assert!(changed(&flank).contains("a shift of"));
        let start = |events: &mut Vec<Event>| {
            let place = cut(events, 1);
            if let Action::Thread { start, .. } = &mut events[place].action {
                *start = None;
            }
        };
        assert!(changed(&start).contains("start 1 of depth 1"));
        let lead = |events: &mut Vec<Event>| {
            let place = cut(events, 1);
            if let Action::Thread { lead, .. } = &mut events[place].action {
                lead.0 = 999_999;
            }
        };
        assert!(changed(&lead).contains("lead out of range"));
    }

    #[test]
    fn passes_out_of_order_are_noticed() {
        let part = |n: usize, part: Part| {
            verdict(move |events| {
                let place = cut(events, n) + 1;
                if let Action::Linear { motion, .. } = &mut events[place].action {
                    motion.part = Some(part);
                }
            })
        };
        assert!(part(0, Part::Cut).is_err_and(|message| message.contains("before")));
        let without_approach = |events: &mut Vec<Event>| {
            let place = cut(events, 1) - 1;
            events.remove(place);
        };
        assert!(verdict(without_approach).is_err_and(|message| message.contains("begins with")));
        assert!(verdict(|events| events.swap(2, 3)).is_err());
        let elsewhere = |events: &mut Vec<Event>| {
            let place = cut(events, 2) + 2;
            if let Action::Rapid { motion } = &mut events[place].action {
                motion.machine.z.0 += 1;
            }
        };
        assert!(verdict(elsewhere).is_err_and(|message| message.contains("elsewhere")));
    }

    #[test]
    fn most_cycles_are_cut() {
        let cycles = (0..300).filter_map(|seed| {
            let bytes = bytes_of_seed(seed, 64);
            <Cycle as arbitrary::Arbitrary>::arbitrary(&mut Unstructured::new(&bytes)).ok()
        });
        let passes = |cycle: &Cycle| cycle.heights.passes(cycle.pattern, cycle.flank == 33, &cycle.setup);
        let counts: Vec<Option<i64>> = cycles.map(|cycle| passes(&cycle)).collect();
        let cut = counts.iter().flatten().count();
        assert!(counts.len() > 250 && cut * 10 > counts.len() * 6, "{cut} of {}", counts.len());
    }
}

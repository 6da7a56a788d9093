//! What an implementation needs for a program: one criterion a feature, judged by the words of the program,
//! the set-up and the trace.
//!
//! Words behind the block that ends the run do not count, unless the program has statements that lead there.

use std::collections::BTreeSet;

use turnspec_oracle::vocabulary::{
    Action, Event, Feature, FrameCause, Limit, MachineType, Setup, SpindleName, TapeCode, UnitSystem,
};

use crate::words::Words;

/// The features that a program needs. `trace` is what the control does with it.
#[must_use]
pub fn features_of(program: &[u8], setup: &Setup, trace: &[Event]) -> BTreeSet<Feature> {
    let end = trace.last().map_or(program.len(), |event| event.block.end as usize);
    let mut words = Words::of(program, setup.tape.code);
    if setup.library.is_empty() && !["GOTO", "IF", "CALL"].iter().any(|name| words.names.contains(*name)) {
        words = Words::of(program.get(..end).unwrap_or(program), setup.tape.code);
    }
    for text in setup.library.values() {
        words.join(Words::of(&text.0, setup.tape.code));
    }
    let evidence = Evidence { words, setup, trace };
    CRITERIA
        .iter()
        .filter(|criterion| (criterion.holds)(&evidence))
        .map(|criterion| criterion.feature)
        .collect()
}

/// When a program needs a feature.
pub struct Criterion {
    /// The feature.
    pub feature: Feature,
    /// The criterion in words.
    pub text: &'static str,
    holds: fn(&Evidence) -> bool,
}

macro_rules! criteria {
    ($($feature:ident $text:literal $holds:expr;)*) => {
        /// The criterion of every feature.
        pub const CRITERIA: &[Criterion] =
            &[$(Criterion { feature: Feature::$feature, text: $text, holds: $holds }),*];
    };
}

criteria! {
    Absolute "G90" |has| has.g(&[90]);
    Alarm "the trace ends in an alarm" |has| has.kind(|action| matches!(action, Action::Alarm(_)));
    AnyAngle "address A; a rule of ANG" |has| has.letter('A') || has.area(&["ANG"]);
    Arc "G02, G03; an `arc` event" |has| has.g(&[2, 3]) || has.kind(|action| matches!(action, Action::Arc { .. }));
    Aux "an `aux` event" |has| has.kind(|action| matches!(action, Action::Aux { .. }));
    Barrier "M21, M25" |has| has.m(&[21, 25]);
    BlockDelete "a slash in front of a block or behind its sequence name" |has| has.words.slash;
    Boolean "AND, OR, EOR, NOT" |has| has.words.boolean;
    CAxis "address C; M109, M110; a rule of CAX, CFEED" |has| has.letter('C') || has.m(&[109, 110])
        || has.area(&["CAX", "CFEED"]);
    Chamfer "G75" |has| has.g(&[75]);
    Comment "a parenthesis" |has| has.words.comment;
    Coolant "a `coolant` event" |has| has.kind(|action| matches!(action, Action::Coolant { .. }));
    Communication "READ, WRITE, GET, PUT" |has| ["READ", "WRITE", "GET", "PUT"].iter().any(|name| has.name(name));
    ContourGeneration "G101 to G103, G132, G133, G136, G137; a rule of CGF, CGS, CSC" |has|
        has.g(&[101, 102, 103, 132, 133, 136, 137]) || has.area(&["CGF", "CGS", "CSC"]);
    ControlStatement "GOTO, IF" |has| has.name("GOTO") || has.name("IF");
    CuttingSpeed "G96" |has| has.g(&[96]);
    DrivenCycle "G178 to G190; a rule of MCYC" |has| has.words.g.iter().any(|code| matches!(code, 178..=190))
        || has.area(&["MCYC"]);
    Dwell "G04" |has| has.g(&[4]);
    Expression "an operator, a function, a bracket other than a plain subscript, a variable as a value"
        |has| has.words.expression;
    Feed "address F; G94, G95" |has| has.letter('F') || has.g(&[94, 95]);
    Function "a name with brackets that is no variable" |has| has.words.function;
    Gear "M40 to M44; gears in the set-up" |has| has.m(&[40, 41, 42, 43, 44]) || !has.setup.spindle.gear.is_empty();
    Grooving "G73, G74, G77, G78; a rule of GRV, TAP" |has| has.g(&[73, 74, 77, 78]) || has.area(&["GRV", "TAP"]);
    Incremental "G91" |has| has.g(&[91]);
    Lap "G80 to G88; a rule of LAP" |has| has.g(&[80, 81, 82, 83, 84, 85, 86, 87, 88]) || has.area(&["LAP"]);
    Limits "travel limits in the set-up; a rule of LIM" |has| [has.setup.limits.x, has.setup.limits.z, has.setup.limits.w].iter().any(|limit| *limit != Limit::default())
        || has.area(&["LIM"]);
    InputOutput "a variable VDIN, VDOUT, VIRD, VORD" |has| ["VDIN", "VDOUT", "VIRD", "VORD"]
        .iter()
        .any(|name| has.system_variable(name));
    Linear "G01; a `linear` event" |has| has.g(&[1]) || has.kind(|action| matches!(action, Action::Linear { .. }));
    LocalVariable "a rule of LVAR" |has| has.area(&["LVAR"]);
    MTool "address SB; a command to the spindle `tool`" |has| has.name("SB") || has.spindle(SpindleName::Tool);
    MacroCode "G161 to G171, G205 to G214, M321 to M325, M341 to M360" |has|
        has.words.g.iter().any(|code| matches!(code, 161..=171 | 205..=214))
        || has.words.m.iter().any(|code| matches!(code, 321..=325 | 341..=360));
    ModalCall "MODIN, MODOUT, G161 to G170" |has| has.name("MODIN") || has.name("MODOUT")
        || has.words.g.iter().any(|code| matches!(code, 161..=170));
    OptionalStop "M01" |has| has.m(&[1]);
    ProgramName "a program name, a file header, a percent sign" |has| has.words.program_name;
    RadiusCompensation "G17, G18, G119, G40 to G42; a rule of NRC, CRC" |has| has.g(&[17, 18, 119, 40, 41, 42])
        || has.area(&["NRC", "CRC"]);
    Rapid "G00; a `rapid` event" |has| has.g(&[0]) || has.kind(|action| matches!(action, Action::Rapid { .. }));
    Rounding "G76" |has| has.g(&[76]);
    Schedule "PSELECT, VSET, END; a `select` event" |has| ["PSELECT", "VSET", "END"].iter().any(|name| has.name(name))
        || has.kind(|action| matches!(action, Action::Select { .. }));
    SequenceName "a sequence name" |has| has.words.sequence;
    Spindle "address S; M03, M04, M05, M19; a command to the spindle `main`" |has| has.letter('S')
        || has.m(&[3, 4, 5, 19]) || has.spindle(SpindleName::Main);
    Subprogram "CALL, RTS; a `call` event" |has| has.name("CALL") || has.name("RTS")
        || has.kind(|action| matches!(action, Action::Call { .. }));
    SystemVariable "a variable with a name" |has| !has.words.system_variables.is_empty();
    TapeCode "another code than `ascii` in the set-up" |has| has.setup.tape.code != TapeCode::Ascii;
    Thread "G31 to G35, G71, G72; a `thread` event; a rule of THRD" |has| has.g(&[31, 32, 33, 34, 35, 71, 72])
        || has.kind(|action| matches!(action, Action::Thread { .. })) || has.area(&["THRD"]);
    TimeOver "the check enabled in the set-up" |has| has.setup.stm.enabled;
    Tool "address T; a `tool` event" |has| has.letter('T') || has.kind(|action| matches!(action, Action::Tool { .. }));
    Torque "G22, G28, G29" |has| has.g(&[22, 28, 29]);
    Turret "G13, G14; a rule of TUR, TUNC" |has| has.g(&[13, 14]) || has.area(&["TUR", "TUNC"]);
    TwoSaddles "a machine of type `2S` in the set-up" |has| has.setup.machine.r#type == MachineType::TwoSaddles;
    TwoTurrets "a machine of type `1S-2T` in the set-up; M100; a rule of MIRR, M100" |has|
        has.setup.machine.r#type == MachineType::TwoTurrets || has.m(&[100]) || has.area(&["MIRR", "M100"]);
    Units "another unit system than `1mm` in the set-up" |has| has.setup.unit_system != UnitSystem::Millimetre;
    UserAlarm "a rule of VUACM" |has| has.area(&["VUACM"]);
    Variable "a variable with a number; variables in the set-up" |has| has.words.variable
        || !has.setup.variables.is_empty();
    WAxis "address W; the axis in the set-up" |has| has.letter('W') || has.setup.options.w_axis;
    ZeroShift "G50 in a block with X, Z, C or W; a variable VZSH…; a `frame` event of the zero shift" |has|
        has.words.zero_shift || has.system_variable("VZSH") || has.kind(|action| {
            matches!(action, Action::Frame { cause: FrameCause::ZeroShift, .. })
        });
}

/// What the criteria look at.
struct Evidence<'a> {
    words: Words,
    setup: &'a Setup,
    trace: &'a [Event],
}

impl Evidence<'_> {
    fn g(&self, codes: &[u32]) -> bool {
        codes.iter().any(|code| self.words.g.contains(code))
    }

    fn m(&self, codes: &[u32]) -> bool {
        codes.iter().any(|code| self.words.m.contains(code))
    }

    fn letter(&self, letter: char) -> bool {
        self.words.letters.contains(&letter)
    }

    fn name(&self, name: &str) -> bool {
        self.words.names.contains(name)
    }

    fn system_variable(&self, beginning: &str) -> bool {
        self.words.system_variables.iter().any(|name| name.starts_with(beginning))
    }

    fn kind(&self, of: impl Fn(&Action) -> bool) -> bool {
        self.trace.iter().any(|event| of(&event.action))
    }

    fn spindle(&self, name: SpindleName) -> bool {
        self.kind(|action| matches!(action, Action::Spindle(spindle) if spindle.spindle == name))
    }

    /// Whether an event cites a rule of one of the areas.
    fn area(&self, areas: &[&str]) -> bool {
        let rules = self.trace.iter().flat_map(|event| event.rules.as_slice());
        rules.filter_map(|rule| rule.as_str().split('-').nth(1)).any(|area| areas.contains(&area))
    }
}

#[cfg(test)]
mod tests {
    use turnspec_oracle::vocabulary::{Event, Feature, Setup};

    use super::{CRITERIA, features_of};

    fn names(program: &str) -> Vec<&'static str> {
        let (mut trace, setup) = (Vec::new(), Setup::default());
        turnspec_oracle::run(program.as_bytes(), &setup, &mut |event: &Event| trace.push(*event));
        features_of(program.as_bytes(), &setup, &trace).into_iter().map(Feature::as_str).collect()
    }

    #[test]
    fn every_feature_has_one_criterion() {
        let features: Vec<Feature> = CRITERIA.iter().map(|criterion| criterion.feature).collect();
        assert_eq!(features, Feature::ALL);
    }

    #[test]
    fn features_follow_from_words_and_trace() {
        assert_eq!(names("M02\n"), Vec::<&str>::new());
        assert_eq!(names("X1\nM02\n"), ["rapid"]);
        assert_eq!(names("N1 G01 X1 F0.1\nM02\n"), ["feed", "linear", "sequence-name"]);
        assert_eq!(names("G01 X1\nM02\n"), ["alarm", "linear"]);
        assert_eq!(names("V1=VRSTT+1\nM02\n"), ["expression", "system-variable", "variable"]);
    }

    #[test]
    fn words_behind_the_end_do_not_count() {
        assert_eq!(names("M02\nG02 X1\n"), Vec::<&str>::new());
    }
}

//! Generated programs come near the barriers: how many motions are tested, how many programs end, which alarms.

use std::collections::BTreeMap;

use turnspec_generator::{Case, case_from_seed};
use turnspec_oracle::vocabulary::rule_ids::{BARR_01, BARR_08};
use turnspec_oracle::vocabulary::{Action, AlarmName, Event, Setup};

const PROGRAMS: u64 = 12_000;

/// What the programs of many seeds did.
#[derive(Default)]
struct Reached {
    /// Programs with barrier data.
    with_data: u64,
    /// Programs in which a motion was tested, and those of them that ended.
    tested: [u64; 2],
    /// Tested motions by their kind.
    motions: BTreeMap<&'static str, u64>,
    /// Alarms by barrier and by the kind of motion mode.
    alarms: BTreeMap<String, u64>,
}

impl Reached {
    fn add(&mut self, case: &Case) {
        let (mut tested, mut ended) = (false, false);
        turnspec_oracle::run(&case.program, &case.setup, &mut |event: &Event| {
            let cites = |rule| event.rules.as_slice().contains(&rule);
            ended |= matches!(event.action, Action::End { .. });
            let kind = match event.action {
                Action::Rapid { motion } if motion.tip.is_some() => "compensated rapid",
                Action::Rapid { .. } if cites(BARR_08) => "rapid",
                Action::Linear { motion, .. } if motion.tip.is_some() => "compensated linear",
                Action::Linear { .. } => "linear",
                Action::Arc { motion, .. } if motion.tip.is_some() => "compensated arc",
                Action::Arc { .. } => "arc",
                Action::Alarm(alarm) => {
                    if alarm.name == AlarmName::Barrier {
                        *self.alarms.entry(alarm.detail.to_string()).or_default() += 1;
                    }
                    return;
                }
                _ => return,
            };
            if cites(BARR_01) {
                tested = true;
                *self.motions.entry(kind).or_default() += 1;
            }
        });
        self.with_data += u64::from(case.setup.barriers != Setup::default().barriers);
        self.tested[0] += u64::from(tested);
        self.tested[1] += u64::from(tested && ended);
    }
}

/// Of a hundred programs about twelve have barriers; in most of them motions are tested, and most of those end.
#[test]
fn programs_with_barriers_are_many_and_seldom_run_into_them() {
    let mut reached = Reached::default();
    (0..PROGRAMS).map(case_from_seed).for_each(|case| reached.add(&case));
    let [tested, ended] = reached.tested;
    println!(
        "{PROGRAMS} programs, {} with barriers, {tested} tested, {ended} of them ended",
        reached.with_data
    );
    println!("motions {:?}, alarms {:?}", reached.motions, reached.alarms);
    assert!((PROGRAMS / 10..PROGRAMS / 7).contains(&reached.with_data), "{}", reached.with_data);
    assert!(tested * 2 > reached.with_data, "{tested} tested");
    assert!(ended * 100 > tested * 70, "{ended} of {tested} ended");
    for kind in ["rapid", "linear", "arc", "compensated rapid", "compensated linear", "compensated arc"] {
        assert!(reached.motions.get(kind).is_some_and(|count| *count > 20), "{kind}");
    }
    for barrier in ["chuck", "tailstock"] {
        assert!(reached.alarms.get(barrier).is_some_and(|count| *count > 5), "{barrier}");
    }
}

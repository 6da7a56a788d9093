//! What a set-up may say: ranges, numbers of entries, limits in order.

use std::collections::BTreeSet;

use super::{
    AxisAmounts, Barriers, Limit, MachineType, Options, PlaneAmounts, Setup, SetupError, SpindleSetup,
    StmCheck,
};
use crate::vocabulary::Length;

type Checked = Result<(), SetupError>;

impl Setup {
    /// Checks the values: ranges, numbers of entries, limits in order.
    ///
    /// # Errors
    /// Names the first field that is impossible.
    pub fn validate(&self) -> Checked {
        self.options()?;
        self.parameters()?;
        amounts("start", &self.start)?;
        amounts("zero_offset", &self.zero_offset)?;
        let offsets = self.tool_offset.iter().map(|each| (each.number, each.x, each.z));
        entries("tool_offset", self.options.offset_sets, offsets)?;
        let radii = self.nose_radius.iter().map(|each| (each.number, each.x, each.z));
        entries("nose_radius", self.options.offset_sets, radii)?;
        self.turret_b()?;
        self.limits()?;
        barriers(&self.barriers)?;
        self.droop()?;
        spindle(&self.spindle)?;
        stm(&self.stm)?;
        torque_stops("inputs.torque_stops", &self.inputs.torque_stops)?;
        self.variables()?;
        self.macros()?;
        self.library()?;
        self.devices()?;
        self.system_variables()?;
        self.inputs()
    }

    /// E100L-AX4-01, and what holds of the data of A.
    fn turret_b(&self) -> Checked {
        let (b, sets) = (&self.turret_b, self.options.offset_sets);
        for (name, amounts) in [("turret_b.start", b.start), ("turret_b.zero_offset", b.zero_offset)] {
            plane_amounts(name, amounts)?;
        }
        entries(
            "turret_b.tool_offset",
            sets,
            b.tool_offset.iter().map(|each| (each.number, each.x, each.z)),
        )?;
        entries(
            "turret_b.nose_radius",
            sets,
            b.nose_radius.iter().map(|each| (each.number, each.x, each.z)),
        )?;
        limit("turret_b.limits.x", b.limits.x)?;
        limit("turret_b.limits.z", b.limits.z)?;
        torque_stops("turret_b.torque_stops", &b.torque_stops)?;
        require(self.machine.r#type != MachineType::TwoSaddles || !self.options.w_axis, || {
            "options.w_axis: a machine of two saddles (machine.type) has no W axis".to_owned()
        })
    }

    fn options(&self) -> Checked {
        let options = &self.options;
        require([32, 64, 96].contains(&options.offset_sets), || {
            format!("options.offset_sets is {}, must be 32, 64 or 96", options.offset_sets)
        })?;
        require([1, 2].contains(&options.user_task), || {
            format!("options.user_task is {}, must be 1 or 2", options.user_task)
        })?;
        require([0, 3, 4].contains(&options.lap), || {
            format!("options.lap is {}, must be 0, 3 or 4", options.lap)
        })?;
        require([12, 20, 96].contains(&options.tools), || {
            format!("options.tools is {}, must be 12, 20 or 96", options.tools)
        })?;
        require([12, 20, 24].contains(&options.tool_groups), || {
            format!("options.tool_groups is {}, must be 12, 20 or 24", options.tool_groups)
        })
    }

    fn parameters(&self) -> Checked {
        let parameters = &self.parameters;
        require((1..=100).contains(&parameters.torque_limit_upper), || {
            format!("parameters.torque_limit_upper is {}, must be 1 to 100", parameters.torque_limit_upper)
        })?;
        require(parameters.torque_monitor_delay <= 9999, || {
            format!(
                "parameters.torque_monitor_delay is {}, must be 0 to 9999",
                parameters.torque_monitor_delay
            )
        })?;
        let tolerance = parameters.circular_radius_tolerance;
        require((0..=1_000_000).contains(&tolerance.0), || {
            format!("parameters.circular_radius_tolerance is {tolerance}, must be 0 to 1")
        })?;
        let rate = parameters.thread_chamfer_feed;
        require((1..=9999).contains(&rate), || {
            format!("parameters.thread_chamfer_feed is {rate}, must be 1 to 9999")
        })?;
        require([3, 4].contains(&parameters.m75_pattern), || {
            format!("parameters.m75_pattern is {}, must be 3 or 4", parameters.m75_pattern)
        })?;
        for (name, amount) in [
            ("grooving_retract", parameters.grooving_retract),
            ("drilling_retract", parameters.drilling_retract),
        ] {
            require((0..=99_999_000).contains(&amount.0), || {
                format!("parameters.{name} is {amount}, must be 0 to 99.999")
            })?;
        }
        let percent = parameters.centre_override;
        require((1..=1000).contains(&percent), || {
            format!("parameters.centre_override is {percent}, must be 1 to 1000")
        })?;
        require(parameters.lap_relief <= 9999, || {
            format!("parameters.lap_relief is {}, must be 0 to 9999", parameters.lap_relief)
        })?;
        require(parameters.lap_clearance <= 99_999, || {
            format!("parameters.lap_clearance is {}, must be 0 to 99999", parameters.lap_clearance)
        })?;
        require((1..=126).contains(&parameters.call_depth), || {
            format!("parameters.call_depth is {}, must be 1 to 126", parameters.call_depth)
        })
    }

    /// A program name (E100L-NAME-01) behind each macro code.
    fn macros(&self) -> Checked {
        for (code, name) in &self.macros {
            let number = code.get(1..).and_then(|digits| digits.parse::<u16>().ok());
            let known = match (code.get(..1), number) {
                (Some("G"), Some(number)) => matches!(number, 161..=171 | 205..=214),
                (Some("M"), Some(number)) => matches!(number, 321..=325 | 341..=360),
                _ => false,
            };
            require(known && code.len() == 4, || format!("macros: {code:?} is no macro code"))?;
            require(is_program_name(name.as_str()), || format!("macros.{code}: {name} is no program name"))?;
        }
        Ok(())
    }

    /// A file name (E100L-PROG-05) before each text.
    fn library(&self) -> Checked {
        for (name, text) in &self.library {
            require(is_file_name(name), || {
                format!(
                    "library: {name:?} is no file name: a letter, at most 15 more letters, digits or hyphens, a point \
                     and three letters or digits"
                )
            })?;
            require(u32::try_from(text.0.len()).is_ok(), || format!("library: {name} holds 4 GiB or more"))?;
        }
        Ok(())
    }

    fn devices(&self) -> Checked {
        let known = |name: &str| matches!(name.as_bytes(), [b'C', b'N', b'0'..=b'9']);
        match self.devices.keys().find(|name| !known(name)) {
            Some(name) => fault(format!("devices: {name:?} is not one of CN0 to CN9")),
            None => Ok(()),
        }
    }

    /// E100L-SVAR-14: a name with a suffix, and zero or a value in its range.
    fn system_variables(&self) -> Checked {
        for (name, value) in &self.system_variables {
            let Some((variable, number)) = suffixed(name) else {
                return fault(format!("system_variables: {name:?} is no variable with a number in brackets"));
            };
            let Some((largest, (low, high), whole)) = interference_data(variable, &self.options) else {
                return fault(format!("system_variables: {variable:?} is no tool interference data"));
            };
            require((1..=largest).contains(&number), || {
                format!("system_variables: {name} is outside 1 to {largest}")
            })?;
            let fits = value.0 == 0 || (low..=high).contains(&value.0);
            let step = if whole { 1_000_000 } else { 1000 };
            require(fits && value.0 % step == 0, || format!("system_variables: {name} cannot be {value}"))?;
        }
        Ok(())
    }

    /// E100L-IOV-01, E100L-IORD-01: numbers of inputs, and lists of values that they can have.
    fn inputs(&self) -> Checked {
        for (number, values) in &self.inputs.vdin {
            let highest = match number {
                1..=8 | 11..=18 | 21..=24 | 31..=38 => 1,
                10 => 31,
                1000..=1004 => i32::MAX,
                1235..=1250 => 255,
                _ => return fault(format!("inputs.vdin: {number} is no number of an input")),
            };
            let fits = !values.is_empty() && values.iter().all(|value| (0..=highest).contains(value));
            require(fits, || format!("inputs.vdin.{number}: must be a list of 0 to {highest}, not empty"))?;
        }
        for (name, bits) in [("vird", &self.inputs.vird), ("vord", &self.inputs.vord)] {
            for (address, values) in bits {
                let fits = *address <= 9999 && !values.is_empty() && values.iter().all(|value| *value <= 1);
                require(fits, || {
                    format!("inputs.{name}.{address}: must be a list of 0 and 1, not empty, for 0 to 9999")
                })?;
            }
        }
        Ok(())
    }

    fn limits(&self) -> Checked {
        require(self.limits.steps > 0, || "limits.steps is 0, must be at least 1".to_owned())?;
        for (axis, limit) in [("x", self.limits.x), ("z", self.limits.z), ("w", self.limits.w)] {
            self::limit(&format!("limits.{axis}"), limit)?;
        }
        Ok(())
    }

    fn droop(&self) -> Checked {
        let largest = if self.unit_system.is_inch() { 10_000 } else { 1000 };
        let droops = [self.droop.x, self.droop.z, self.droop.c];
        require(droops.iter().all(|droop| *droop <= largest), || format!("droop must be 0 to {largest}"))
    }

    fn variables(&self) -> Checked {
        for (name, value) in &self.variables {
            let number = name.strip_prefix('V').and_then(|digits| digits.parse::<u8>().ok());
            let known =
                number.is_some_and(|number| (1..=200).contains(&number) && *name == format!("V{number}"));
            require(known, || format!("variables: {name:?} is not one of V1 to V200"))?;
            require(value.is_finite(), || format!("variables: {name} is not finite"))?;
        }
        Ok(())
    }
}

fn fault<T>(message: impl Into<String>) -> Result<T, SetupError> {
    Err(SetupError { message: message.into(), span: None })
}

fn require(holds: bool, message: impl Fn() -> String) -> Checked {
    if holds { Ok(()) } else { fault(message()) }
}

/// Name and number of `VTLL[3]`.
fn suffixed(text: &str) -> Option<(&str, u8)> {
    let (name, number) = text.strip_suffix(']')?.split_once('[')?;
    let digits = number.bytes().all(|byte| byte.is_ascii_digit()) && !number.starts_with('0');
    number.parse().ok().filter(|_| digits).map(|number| (name, number))
}

/// The largest suffix of tool interference data, the range in millionths, and whether it is a whole number
/// (E100L-SVAR-14).
fn interference_data(name: &str, options: &Options) -> Option<(u8, (i64, i64), bool)> {
    let (kind, number) = match (name.strip_prefix("VTL"), name.strip_prefix("VGR"), name.strip_prefix("VTI"))
    {
        (Some(kind), ..) => (kind, options.tools),
        (_, Some(kind), _) => (kind, options.tool_groups),
        (.., Some("ZN" | "ZP" | "XN" | "XP")) => ("L", options.tools),
        (.., Some("PN")) => ("PN", options.tools),
        _ => return None,
    };
    let (low, high, whole) = match kind {
        "IN" => (1_000_000, 38_000_000, true),
        "FN" => (0, 4_000_000, true),
        "PN" if name.starts_with("VTI") => (0, 2_000_000, true),
        "A1" => (0, 360_000_000, false),
        "A2" => (-360_000_000, 360_000_000, false),
        "L" | "D" | "W" => (0, 9_999_999_000, false),
        _ => return None,
    };
    Some((number, (low, high), whole))
}

/// `O` and one to four letters and digits, digits only behind a digit.
fn is_program_name(name: &str) -> bool {
    let Some(run) = name.strip_prefix('O') else { return false };
    let alphanumeric = run.bytes().all(|byte| byte.is_ascii_uppercase() || byte.is_ascii_digit());
    let letter_first = run.starts_with(|first: char| first.is_ascii_uppercase());
    (1..=4).contains(&run.len())
        && alphanumeric
        && (letter_first || run.bytes().all(|byte| byte.is_ascii_digit()))
}

fn is_file_name(name: &str) -> bool {
    let Some((stem, extension)) = name.rsplit_once('.') else { return false };
    let fits = |byte: u8| byte.is_ascii_uppercase() || byte.is_ascii_digit() || byte == b'-';
    stem.starts_with(|first: char| first.is_ascii_uppercase())
        && stem.len() <= 16
        && stem.bytes().all(fits)
        && extension.len() == 3
        && extension.bytes().all(|byte| fits(byte) && byte != b'-')
}

fn within(value: Length, limit: i64) -> bool {
    value.0.unsigned_abs() <= limit.unsigned_abs()
}

fn in_steps(value: Length) -> bool {
    value.0 % 1000 == 0
}

fn amounts(name: &str, amounts: &AxisAmounts) -> Checked {
    let axes = [("x", amounts.x), ("z", amounts.z), ("w", amounts.w), ("c", Length(amounts.c.0))];
    for (axis, amount) in axes {
        require(within(amount, Setup::COORDINATE), || {
            format!("{name}.{axis} is {amount}, must be within 99999.999")
        })?;
        require(in_steps(amount), || format!("{name}.{axis} is {amount}, finer than 0.001"))?;
    }
    Ok(())
}

fn plane_amounts(name: &str, amounts: PlaneAmounts) -> Checked {
    self::amounts(name, &AxisAmounts { x: amounts.x, z: amounts.z, ..AxisAmounts::default() })
}

fn limit(name: &str, limit: Limit) -> Checked {
    for value in [limit.positive, limit.negative].into_iter().flatten() {
        require(within(value, Setup::COORDINATE) && in_steps(value), || {
            format!("{name}: {value} must be within 99999.999 in steps of 0.001")
        })?;
    }
    match (limit.positive, limit.negative) {
        (Some(positive), Some(negative)) => require(negative <= positive, || {
            format!("{name}: the positive limit {positive} lies below the negative limit {negative}")
        }),
        _ => Ok(()),
    }
}

fn torque_stops(name: &str, stops: &[Length]) -> Checked {
    require(stops.iter().all(|stop| within(*stop, 2 * Setup::COORDINATE)), || {
        format!("{name}: a coordinate is out of range")
    })
}

fn entries(name: &str, sets: u8, table: impl Iterator<Item = (u8, Length, Length)>) -> Checked {
    let mut seen = BTreeSet::new();
    for (number, x, z) in table {
        require((1..=sets).contains(&number), || format!("{name} number {number} is outside 1 to {sets}"))?;
        require(seen.insert(number), || format!("{name} number {number} appears twice"))?;
        for (axis, amount) in [("x", x), ("z", z)] {
            require(within(amount, 999_999_000) && in_steps(amount), || {
                format!(
                    "{name} number {number}: {axis} is {amount}, must be within 999.999 in steps of 0.001"
                )
            })?;
        }
    }
    Ok(())
}

fn barriers(barriers: &Barriers) -> Checked {
    let b = barriers;
    let jaw = [b.jaw_length, b.jaw_height, b.grip_length, b.grip_height];
    let lengths = [b.rear_length, b.middle_length, b.front_length];
    let diameters = [b.rear_diameter, b.middle_diameter, b.front_diameter, b.centre_diameter];
    let mut sizes = jaw.iter().chain(&lengths).chain(&diameters);
    let places = [b.chuck_x, b.chuck_z, b.workpiece_end];
    let fits = |value: &Length| within(*value, 9_999_999_000) && in_steps(*value);
    require(sizes.all(|size| size.0 >= 0 && fits(size)) && places.iter().all(fits), || {
        "barriers: sizes must be 0 to 9999.999, positions within 9999.999, in steps of 0.001".to_owned()
    })
}

fn spindle(spindle: &SpindleSetup) -> Checked {
    let ranges = spindle.gear.iter().map(|gear| (gear.minimum, gear.maximum));
    for (minimum, maximum) in ranges.chain([(spindle.minimum, spindle.maximum)]) {
        require(minimum.0 >= 0 && maximum.0 <= 65_535_000 && minimum <= maximum, || {
            format!("spindle: the range {minimum} to {maximum} must be in order within 0 to 65535")
        })?;
    }
    let mut seen = BTreeSet::new();
    for gear in &spindle.gear {
        require((40..=44).contains(&gear.code) && seen.insert(gear.code), || {
            format!("spindle.gear code {} must be one of 40 to 44, each once", gear.code)
        })?;
    }
    Ok(())
}

fn stm(stm: &StmCheck) -> Checked {
    require((0..=600_000_000).contains(&stm.limit.0) && stm.limit.0 % 100_000 == 0, || {
        format!("stm.limit is {}, must be 0 to 600 in steps of 0.1", stm.limit)
    })?;
    require([stm.s, stm.t, stm.m].iter().all(|time| time.0 >= 0), || "stm: a time is negative".to_owned())
}

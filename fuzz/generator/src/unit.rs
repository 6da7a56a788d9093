//! What a written 1 means (E100L-DEC-01): from a wanted amount to the number to write, and from the number
//! written to the amount that the control understands.

use turnspec_oracle::vocabulary::{InchConversion, Setup, UnitSystem};

use crate::number::{Number, round_ratio};

/// The value of a word as the generator knows it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Written {
    /// A plain number, exactly.
    Plain(Number),
    /// An expression, to within rounding errors.
    Estimated(Estimate),
}

/// The estimated value of an expression.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Estimate {
    /// A whole number.
    Integer(i32),
    /// A real number.
    Real(f64),
}

impl Estimate {
    /// The value as a real number.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        match self {
            Self::Integer(value) => f64::from(value),
            Self::Real(value) => value,
        }
    }
}

/// The unit system of a set-up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Units {
    /// The system.
    pub system: UnitSystem,
    conversion: InchConversion,
}

impl Units {
    /// The units of a set-up.
    #[must_use]
    pub fn of(setup: &Setup) -> Self {
        Self { system: setup.unit_system, conversion: setup.readings.inch_conversion }
    }

    /// Nanometres of a written 1 of a length, or of a feed per revolution.
    #[must_use]
    pub fn length_unit(self) -> i64 {
        match self.system {
            UnitSystem::Micrometre => 1_000,
            UnitSystem::TenMicrometre => 10_000,
            UnitSystem::Millimetre => 1_000_000,
            UnitSystem::TenThousandthInch => 2_540,
            UnitSystem::Inch => 25_400_000,
        }
    }

    /// Nanometres of the finest length that is written: 0.001 mm or 0.0001 inch.
    #[must_use]
    pub fn finest(self) -> i64 {
        if self.system.is_inch() { 2_540 } else { 1_000 }
    }

    /// Decimals with which the finest length is written.
    #[must_use]
    pub fn length_decimals(self) -> u8 {
        match self.system {
            UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 0,
            UnitSystem::TenMicrometre => 1,
            UnitSystem::Millimetre => 3,
            UnitSystem::Inch => 4,
        }
    }

    /// Micro-degrees of a written 1 of an angle address.
    #[must_use]
    pub fn angle_unit(self) -> i64 {
        match self.system {
            UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 1_000,
            UnitSystem::TenMicrometre => 10_000,
            UnitSystem::Millimetre | UnitSystem::Inch => 1_000_000,
        }
    }

    /// Nanometres per minute of a written 1 of a feed per minute.
    #[must_use]
    pub fn minute_unit(self) -> i64 {
        match self.system {
            UnitSystem::Micrometre => 100_000,
            UnitSystem::TenMicrometre | UnitSystem::Millimetre => 1_000_000,
            UnitSystem::TenThousandthInch => 254_000,
            UnitSystem::Inch => 25_400_000,
        }
    }

    /// Hundredths of a second of a written 1 of a dwell.
    #[must_use]
    pub fn dwell_unit(self) -> i64 {
        match self.system {
            UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 1,
            UnitSystem::TenMicrometre => 10,
            UnitSystem::Millimetre | UnitSystem::Inch => 100,
        }
    }

    /// By what the angles of functions exceed degrees (E100L-FUNC-02).
    #[must_use]
    pub fn function_angle(self) -> f64 {
        match self.system {
            UnitSystem::Millimetre | UnitSystem::Inch => 1.0,
            UnitSystem::TenMicrometre => 100.0,
            UnitSystem::Micrometre => 1_000.0,
            UnitSystem::TenThousandthInch => 10_000.0,
        }
    }

    /// The number to write for about this length, in nanometres.
    #[must_use]
    pub fn write_length(self, length: i64) -> Number {
        let mantissa = round_ratio(length.into(), self.finest().into());
        Number::decimal(clamp(mantissa), self.length_decimals())
    }

    /// The number to write for this angle, in micro-degrees.
    #[must_use]
    pub fn write_angle(self, angle: i64) -> Number {
        let decimals = match self.angle_unit() {
            1_000 => 0,
            10_000 => 1,
            _ => 3,
        };
        Number::decimal(clamp(round_ratio(angle.into(), 1_000)), decimals)
    }

    /// The length, in nanometres, that the control makes of a word (E100L-INCH-02).
    #[must_use]
    pub fn length(self, written: Written) -> i64 {
        let increment = match (self.system.is_inch(), self.conversion) {
            (true, InchConversion::InchIncrement) => 2_540,
            _ => 1_000,
        };
        scaled(written, self.length_unit(), increment, self.system.is_inch())
    }

    /// The length, in nanometres, that the control makes of an assignment (E100L-TYPE-05).
    #[must_use]
    pub fn assigned_length(self, written: Written) -> i64 {
        scaled(written, self.length_unit(), 1_000, self.system.is_inch())
    }

    /// The angle, in micro-degrees, that the control makes of a word.
    #[must_use]
    pub fn angle(self, written: Written) -> i64 {
        scaled(written, self.angle_unit(), 1_000, false)
    }
}

/// The value of a word times its unit, at its increment: rounded half away from zero, or cut toward zero when
/// whole numbers are cut and it is one.
fn scaled(written: Written, unit: i64, increment: i64, cut_whole: bool) -> i64 {
    let (unit, wide) = (i128::from(unit), i128::from(increment));
    let steps = match written {
        Written::Plain(number) => {
            let scale = 10_i128.pow(u32::from(number.decimals));
            let (numerator, denominator) = (i128::from(number.mantissa) * unit, scale * wide);
            if cut_whole && !number.point {
                numerator / denominator
            } else {
                round_ratio(numerator, denominator)
            }
        }
        Written::Estimated(Estimate::Integer(value)) => {
            let numerator = i128::from(value) * unit;
            if cut_whole { numerator / wide } else { round_ratio(numerator, wide) }
        }
        Written::Estimated(Estimate::Real(value)) => (value * unit as f64 / wide as f64).round() as i128,
    };
    i64::try_from(steps * wide).unwrap_or_default()
}

/// At most eight digits.
fn clamp(mantissa: i128) -> i64 {
    i64::try_from(mantissa.clamp(-99_999_999, 99_999_999)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{Units, Written};
    use crate::number::Number;
    use turnspec_oracle::vocabulary::{Setup, UnitSystem};

    fn units(system: UnitSystem) -> Units {
        Units::of(&Setup { unit_system: system, ..Setup::default() })
    }

    #[test]
    fn metric_lengths_come_back_as_they_were_wanted() {
        for system in [UnitSystem::Micrometre, UnitSystem::TenMicrometre, UnitSystem::Millimetre] {
            let units = units(system);
            for length in [0, 1_000, -12_345_000, 99_999_999_000] {
                assert_eq!(units.length(Written::Plain(units.write_length(length))), length);
            }
        }
    }

    #[test]
    fn whole_inches_are_cut_and_real_ones_rounded() {
        let units = units(UnitSystem::TenThousandthInch);
        // 2 increments are 0.00508 mm; the number without a point is cut, 3.0 (0.00762 mm) is rounded.
        assert_eq!(units.length(Written::Plain(Number::whole(2))), 5_000);
        assert_eq!(units.length(Written::Plain(Number::whole(3))), 7_000);
        assert_eq!(units.length(Written::Plain(Number::whole(3).with_point())), 8_000);
    }
}

//! Numbers as PUT writes them (E100L-GPUT-07).

use crate::fault::{Outcome, fail};
use crate::quantity::{self, whole};
use crate::task::Number;
use crate::task::read::Amount;
use crate::vocabulary::rule_ids::*;
use crate::vocabulary::{AlarmName, PutReal, UnitSystem};

/// The characters of a number: plain numbers as short as they read back, dimensional ones with the decimals of the
/// increment.
pub fn number(amount: Amount, system: UnitSystem, reading: PutReal) -> String {
    let decimals = match (amount, system) {
        (Amount::Number(Number::Integer(integer)), _) => return integer.to_string(),
        (Amount::Number(Number::Real(real)), _) => return (real + 0.0).to_string(),
        (_, UnitSystem::Micrometre | UnitSystem::TenThousandthInch) => 0,
        (_, UnitSystem::TenMicrometre) => 1,
        (Amount::Length(_), UnitSystem::Inch) => 4,
        (_, UnitSystem::Millimetre | UnitSystem::Inch) => 3,
    };
    let scaled = amount.exact(system) * whole(10_i64.pow(decimals));
    decimal(quantity::round_narrow(&scaled), decimals, reading)
}

/// A number of units of the last decimal; a digit stands before the point.
fn decimal(units: i64, decimals: u32, reading: PutReal) -> String {
    let scale = 10_u64.pow(decimals);
    let sign = if units < 0 { "-" } else { "" };
    let (digits, fraction) = (units.unsigned_abs() / scale, units.unsigned_abs() % scale);
    if decimals == 0 || fraction == 0 && reading == PutReal::Shortest {
        return format!("{sign}{digits}");
    }
    let width = usize::try_from(decimals).unwrap_or_default();
    let written = format!("{sign}{digits}.{fraction:0width$}");
    match reading {
        PutReal::Fixed => written,
        PutReal::Shortest => written.trim_end_matches('0').to_owned(),
    }
}

/// A number at the right end of a field.
pub fn field(number: &str, length: usize) -> Outcome<Vec<u8>> {
    if number.len() > length {
        return fail(AlarmName::FieldTooSmall, GPUT_07);
    }
    Ok(format!("{number:>length$}").into_bytes())
}

#[cfg(test)]
mod tests {
    use super::{Amount, Number, PutReal, UnitSystem, number};

    /// E100L-GPUT-07: rounded half away from zero; a sign only before what is not zero.
    #[test]
    fn decimals_are_those_of_the_increment() {
        use UnitSystem::{Inch, Micrometre, Millimetre, TenMicrometre, TenThousandthInch};
        for (amount, system, fixed, shortest) in [
            (Amount::Length(-5_000), Millimetre, "-0.005", "-0.005"),
            (Amount::Length(100_000_000), Millimetre, "100.000", "100"),
            (Amount::Length(5_000_000), Micrometre, "5000", "5000"),
            (Amount::Length(-45_000), TenMicrometre, "-4.5", "-4.5"),
            (Amount::Length(-1_000), Inch, "0.0000", "0"),
            (Amount::Length(-1_270), Inch, "-0.0001", "-0.0001"),
            (Amount::Length(1_000), TenThousandthInch, "0", "0"),
            (Amount::Angle(-90_500_000), Inch, "-90.500", "-90.5"),
            (Amount::Angle(500), TenThousandthInch, "1", "1"),
            (Amount::Number(Number::Real(-0.0)), Millimetre, "0", "0"),
            (
                Amount::Number(Number::Real(1e21)),
                Millimetre,
                "1000000000000000000000",
                "1000000000000000000000",
            ),
        ] {
            assert_eq!(number(amount, system, PutReal::Fixed), fixed);
            assert_eq!(number(amount, system, PutReal::Shortest), shortest);
        }
    }
}

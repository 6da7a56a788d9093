//! E100L-DEC-01: what a written 1 means in each unit system, which a parameter selects (E100L-INCH-01).

use crate::quantity::{Exact, ratio, whole};
use crate::vocabulary::UnitSystem;

/// Nanometres of a written 1 of a length, or of a feed per revolution.
pub fn length(system: UnitSystem) -> Exact {
    whole(match system {
        UnitSystem::Micrometre => 1_000,
        UnitSystem::TenMicrometre => 10_000,
        UnitSystem::Millimetre => 1_000_000,
        UnitSystem::TenThousandthInch => 2_540,
        UnitSystem::Inch => 25_400_000,
    })
}

/// Largest length of E100L-ADDR-01 in nanometres: 99999.999 mm or 9999.9999 inch.
pub fn largest_length(system: UnitSystem) -> i64 {
    if system.is_inch() { 99_999_999 * 2_540 } else { 99_999_999 * 1_000 }
}

/// Nanometres of a written 1 of a feed per minute.
pub fn feed_per_minute(system: UnitSystem) -> Exact {
    whole(match system {
        UnitSystem::Micrometre => 100_000,
        UnitSystem::TenMicrometre | UnitSystem::Millimetre => 1_000_000,
        UnitSystem::TenThousandthInch => 254_000,
        UnitSystem::Inch => 25_400_000,
    })
}

/// Micro-degrees of a written 1 of an angle address.
pub fn angle(system: UnitSystem) -> Exact {
    whole(match system {
        UnitSystem::Micrometre | UnitSystem::TenThousandthInch => 1_000,
        UnitSystem::TenMicrometre => 10_000,
        UnitSystem::Millimetre | UnitSystem::Inch => 1_000_000,
    })
}

/// Seconds of a written 1 of a dwell.
pub fn seconds(system: UnitSystem) -> Exact {
    match system {
        UnitSystem::Micrometre | UnitSystem::TenThousandthInch => ratio(1, 100),
        UnitSystem::TenMicrometre => ratio(1, 10),
        UnitSystem::Millimetre | UnitSystem::Inch => whole(1),
    }
}

/// Micrometres per minute of a written 1 of a cutting speed: 1 m/min or 1 foot/min (E100L-CSS-01).
pub fn cutting_speed(system: UnitSystem) -> Exact {
    whole(if system.is_inch() { 304_800 } else { 1_000_000 })
}

/// E100L-FUNC-02: by what the angles of functions exceed degrees.
pub fn function_angle_factor(system: UnitSystem) -> f64 {
    match system {
        UnitSystem::Millimetre | UnitSystem::Inch => 1.0,
        UnitSystem::TenMicrometre => 100.0,
        UnitSystem::Micrometre => 1_000.0,
        UnitSystem::TenThousandthInch => 10_000.0,
    }
}

/// E100L-FUNC-15: parts of 1 at which DROUND, DFIX and DFUP work.
pub fn unit_scale(system: UnitSystem) -> u32 {
    match system {
        UnitSystem::Millimetre => 1_000,
        UnitSystem::Inch => 10_000,
        _ => 1,
    }
}

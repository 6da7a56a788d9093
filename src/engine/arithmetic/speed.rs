//! Spindle speeds (E100L-SPD-01, E100L-CSS-01, E100L-SMAX-01, E100L-SMAX-02).

use turnspec_oracle::vocabulary::SpeedLimit;

/// Why a spindle speed is what it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SpeedChoice {
    /// Thousandths of a revolution per minute.
    pub value: i64,
    /// The limit that acted.
    pub limit: Option<SpeedLimit>,
}

impl SpeedChoice {
    /// The choice under the clamp of `G50 S`, if there is one.
    #[must_use]
    pub fn clamped(self, clamp: Option<i64>) -> Self {
        match clamp {
            Some(clamp) if self.value > clamp => Self { value: clamp, limit: Some(SpeedLimit::Clamp) },
            _ => self,
        }
    }
}

/// The speed that a whole number of revolutions per minute means, in thousandths. At most 65 535 of them are
/// written; any number below 2^53 fits.
#[must_use]
pub fn thousandths(revolutions: i64) -> i64 {
    revolutions * 1000
}

/// The cutting speed that a whole number means, in micrometres per minute; `unit` is that of a written 1. At
/// most 65 535 of a unit of at most 1 m/min.
#[must_use]
pub fn surface(number: i64, unit: i64) -> i64 {
    number * unit
}

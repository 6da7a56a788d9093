//! How a number becomes whole (E100L-DEC-03, E100L-FUNC-12 to -14).

/// How a number becomes whole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Rounding {
    /// To the nearest, ties away from zero.
    HalfAway,
    /// Toward zero.
    Cut,
    /// Away from zero.
    Up,
}

impl Rounding {
    /// Whether a cut quotient goes one away from zero: by whether its rest is at least half the divisor, and
    /// whether there is a rest.
    #[inline]
    #[must_use]
    pub fn goes_away(self, reaches_half: bool, has_rest: bool) -> bool {
        match self {
            Self::HalfAway => reaches_half,
            Self::Cut => false,
            Self::Up => has_rest,
        }
    }

    /// The whole number that comes of a cut quotient and its rest, which is less than the divisor in size and
    /// has the sign of the value. Without a rest the quotient may be any; with one it is not an extreme.
    #[inline]
    #[must_use]
    pub fn settle(self, quotient: i64, rest: i64, divisor: i64) -> i64 {
        let size = rest.unsigned_abs();
        let away = self.goes_away(size >= divisor.unsigned_abs() - size, rest != 0);
        if away { quotient + rest.signum() } else { quotient }
    }

    /// The quotient of any value by a positive divisor.
    #[inline]
    #[must_use]
    pub fn divide_narrow(self, value: i64, divisor: i64) -> i64 {
        self.settle(value / divisor, value % divisor, divisor)
    }

    /// The quotient of any value by a positive divisor, in 128 bits.
    #[inline]
    #[must_use]
    pub fn divide(self, value: i128, divisor: i128) -> i128 {
        let (quotient, rest) = (value / divisor, value % divisor);
        let size = rest.unsigned_abs();
        let away = self.goes_away(size >= divisor.unsigned_abs() - size, rest != 0);
        if away { quotient + rest.signum() } else { quotient }
    }
}

//! The digits of a written number (E100L-DEC-02, E100L-DEC-04, E100L-TYPE-02, E100L-TYPE-03).

/// A number while it is read from left to right, its sign aside.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Digits {
    /// The digits as one whole number, below 10^8; those beyond the eighth do not matter.
    pub number: i64,
    /// How many of them stand behind the point.
    pub scale: u32,
    /// Whether there is a point.
    pub point: bool,
    /// Digits written, leading and trailing zeros included.
    pub count: u32,
}

impl Digits {
    /// Most digits of a number.
    pub const MOST: u32 = 8;

    /// One more digit, 0 to 9.
    #[must_use]
    pub fn digit(self, digit: u8) -> Self {
        let count = self.count.saturating_add(1);
        if count > Self::MOST {
            return Self { count, ..self };
        }
        Self {
            number: self.number * 10 + i64::from(digit),
            scale: self.scale + u32::from(self.point),
            count,
            ..self
        }
    }
}

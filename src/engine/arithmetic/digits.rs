//! A plain number, character by character (E100L-DEC-02, E100L-TYPE-02, E100L-TYPE-03).

/// The digits of a number that is being read, without its sign.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Digits {
    /// The first eight digits as one whole number, below 10^8.
    pub value: i64,
    /// How many of those stand after the point.
    pub scale: u8,
    /// Digits written, those beyond the eighth included.
    pub written: u32,
    /// Whether there is a point.
    pub point: bool,
}

impl Digits {
    /// Most digits that a number may have; a control refuses more.
    pub const MOST: u32 = 8;

    /// Takes the next digit, 0 to 9. Beyond the eighth it is counted and nothing else.
    #[inline]
    pub fn push(&mut self, digit: u8) {
        self.written = self.written.saturating_add(1);
        if self.written <= Self::MOST {
            self.value = self.value * 10 + i64::from(digit);
            self.scale += u8::from(self.point);
        }
    }

    /// Takes a point; false when there is one already.
    #[inline]
    pub fn push_point(&mut self) -> bool {
        !std::mem::replace(&mut self.point, true)
    }
}

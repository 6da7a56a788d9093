//! Products of twice the width.

/// The product of two numbers as high and low half; halves compare as the products do.
#[must_use]
pub fn product(a: u128, b: u128) -> (u128, u128) {
    const LOW: u128 = u64::MAX as u128;
    let (a_high, a_low, b_high, b_low) = (a >> 64, a & LOW, b >> 64, b & LOW);
    let low = a_low * b_low;
    let (middle_a, middle_b) = (a_high * b_low, a_low * b_high);
    let middle = (low >> 64) + (middle_a & LOW) + (middle_b & LOW);
    let high = a_high * b_high + (middle_a >> 64) + (middle_b >> 64) + (middle >> 64);
    (high, (low & LOW) | (middle << 64))
}

//! Decisions from a byte stream: every choice of the generator goes through here, so that the same bytes
//! give the same program. When the bytes run out every choice is its first, plainest alternative.

use arbitrary::Unstructured;

/// A source of decisions.
pub struct Choices<'c, 'd> {
    bytes: &'c mut Unstructured<'d>,
}

impl<'c, 'd> Choices<'c, 'd> {
    /// Decisions from these bytes.
    pub fn new(bytes: &'c mut Unstructured<'d>) -> Self {
        Self { bytes }
    }

    /// Whether the bytes have run out.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// A whole number in `low..=high`; `low` when the range is empty.
    pub fn within(&mut self, low: i64, high: i64) -> i64 {
        if low >= high {
            return low;
        }
        self.bytes.int_in_range(low..=high).unwrap_or(low)
    }

    /// A whole number below `count`; 0 when `count` is 0.
    pub fn below(&mut self, count: usize) -> usize {
        if count <= 1 {
            return 0;
        }
        self.bytes.int_in_range(0..=count - 1).unwrap_or(0)
    }

    /// True `percent` times in a hundred; false when the bytes have run out.
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) + percent >= 100
    }

    /// One of the entries of a list that is not empty.
    pub fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    /// One of the entries, each as often as its weight says.
    pub fn weighted<T: Copy>(&mut self, list: &[(usize, T)]) -> T {
        let mut place = self.below(list.iter().map(|(weight, _)| weight).sum());
        for (weight, entry) in list {
            if place < *weight {
                return *entry;
            }
            place -= weight;
        }
        list[0].1
    }

    /// The higher of two draws: a place that is usually late.
    pub fn late(&mut self, count: usize) -> usize {
        self.below(count).max(self.below(count))
    }

    /// Brings a list into another order.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for place in (1..list.len()).rev() {
            let other = self.below(place + 1);
            list.swap(place, other);
        }
    }
}

//! Numbers a + b√h with rational a, b and h: where lines and circles meet levels and each other. Numbers with different
//! roots are compared too, exactly.

use std::cmp::Ordering;

use dashu_int::IBig;

use crate::quantity::{Exact, narrow, round, whole};
use crate::real::{self, Interval};

/// Different numbers of a contour differ before so many binary places behind the point.
const MOST_BITS: usize = 512;

/// a + b√h; h is not negative, and zero where b is.
#[derive(Clone, Debug)]
pub struct Number {
    a: Exact,
    b: Exact,
    h: Exact,
}

impl From<Exact> for Number {
    fn from(a: Exact) -> Self {
        Self { a, b: Exact::ZERO, h: Exact::ZERO }
    }
}

impl Number {
    /// a + b√h; the root of a negative number is 0.
    pub fn new(a: Exact, b: Exact, h: Exact) -> Self {
        if b.is_zero() || h <= Exact::ZERO { Self::from(a) } else { Self { a, b, h } }
    }

    /// The number and a rational one.
    pub fn plus(&self, other: &Exact) -> Self {
        Self { a: &self.a + other, ..self.clone() }
    }

    /// The number times a rational one.
    pub fn times(&self, factor: &Exact) -> Self {
        Self::new(&self.a * factor, &self.b * factor, self.h.clone())
    }

    /// Its value, if it has no root.
    pub fn rational(&self) -> Option<&Exact> {
        self.b.is_zero().then_some(&self.a)
    }

    /// The whole number nearest to it, a tie away from zero.
    pub fn nearest(&self) -> i64 {
        narrow(&self.nearest_whole())
    }

    fn nearest_whole(&self) -> IBig {
        if self.b.is_zero() {
            return round(&self.a);
        }
        real::nearest_whole(|precision| {
            let root = Interval::of(&self.h, precision).sqrt();
            Interval::of(&self.a, precision).add(&Interval::of(&self.b, precision).mul(&root))
        })
    }

    /// A rational number between two different ones, the lesser one first.
    pub fn between(&self, greater: &Self) -> Exact {
        let mut between = self.a.clone();
        for bits in (0..MOST_BITS).step_by(16) {
            let unit = Exact::from(IBig::ONE << bits);
            let above = self.times(&unit).nearest_whole() + IBig::ONE;
            let below = greater.times(&unit).nearest_whole() - IBig::ONE;
            between = Exact::from(above.clone()) / unit;
            if above <= below {
                break;
            }
        }
        between
    }

    /// The greater one.
    pub fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// The lesser one.
    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Number {}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    /// The sign of A + B√h + C√k: two numbers of different signs are compared by their squares.
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b, h) = (&self.a - &other.a, &self.b, &self.h);
        let (c, k) = (-other.b.clone(), &other.h);
        let (first, second) = (sign_of(&a, b, h), sign_of(&Exact::ZERO, &c, k));
        if first == second || second.is_eq() {
            return first;
        }
        if first.is_eq() {
            return second;
        }
        let excess = &a * &a + b * b * h - &c * &c * k;
        match sign_of(&excess, &(whole(2) * &a * b), h) {
            Ordering::Greater => first,
            Ordering::Equal => Ordering::Equal,
            Ordering::Less => second,
        }
    }
}

/// The sign of a + b√h.
fn sign_of(a: &Exact, b: &Exact, h: &Exact) -> Ordering {
    let of_a = a.cmp(&Exact::ZERO);
    let of_root = if h.is_zero() { Ordering::Equal } else { b.cmp(&Exact::ZERO) };
    if of_a == of_root || of_root.is_eq() {
        return of_a;
    }
    if of_a.is_eq() {
        return of_root;
    }
    match (a * a).cmp(&(b * b * h)) {
        Ordering::Greater => of_a,
        Ordering::Equal => Ordering::Equal,
        Ordering::Less => of_root,
    }
}

#[cfg(test)]
mod tests {
    use super::Number;
    use crate::quantity::{ratio, whole};

    fn number(a: i64, b: i64, h: i64) -> Number {
        Number::new(whole(a), whole(b), whole(h))
    }

    #[test]
    fn numbers_with_different_roots_are_compared_exactly() {
        // Multiples of √2, √3, √8 and √12 by what they are about.
        for (less, greater) in [
            (number(0, 1, 2), number(0, 1, 3)),
            (number(1, 1, 2), number(0, 1, 6)),
            (number(0, -1, 3), number(0, -1, 2)),
            (number(-1, 1, 3), number(0, 1, 2)),
            (number(3, -1, 2), number(0, 1, 3)),
        ] {
            assert!(less < greater, "{less:?} {greater:?}");
            assert!(greater > less);
        }
        assert_eq!(number(1, 2, 2), number(1, 1, 8));
        assert_eq!(number(1, 3, 4), number(7, 5, 0));
        assert_eq!(number(0, -2, 3), number(0, -1, 12));
    }

    #[test]
    fn a_number_between_two_others_is_found() {
        for (less, greater) in [
            (number(0, 1, 2), number(0, 1, 3)),
            (number(7, 0, 0), number(8, 0, 0)),
            (number(-1, -1, 1_000_001), number(-1_001, 0, 0)),
        ] {
            let between = Number::from(less.between(&greater));
            assert!(less < between && between < greater, "{less:?} {greater:?}");
        }
    }

    #[test]
    fn the_nearest_whole_number_is_that_of_the_exact_one() {
        assert_eq!(number(0, 1, 2).nearest(), 1);
        assert_eq!(number(-1, -1, 3).nearest(), -3);
        assert_eq!(Number::new(ratio(1, 2), whole(1), whole(4)).nearest(), 3);
        assert_eq!(number(2, 5, -4).nearest(), 2);
    }
}

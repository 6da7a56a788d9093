//! Numbers a + b√h with rational a, b and h: the coordinates of a point in which a circle meets a straight line, and
//! what is computed from them. Their signs are exact.

use std::cmp::Ordering;

use crate::quantity::Exact;

/// a + b√h. Numbers that are added have the same h, which is not negative.
#[derive(Clone, Debug)]
pub struct Surd {
    a: Exact,
    b: Exact,
    h: Exact,
}

impl Surd {
    /// a + b√h.
    pub fn new(a: Exact, b: Exact, h: &Exact) -> Self {
        Self { a, b, h: h.clone() }
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        Self { a: &self.a + &other.a, b: &self.b + &other.b, h: self.h.clone() }
    }

    /// The number and a rational one.
    pub fn plus_rational(&self, other: &Exact) -> Self {
        Self { a: &self.a + other, ..self.clone() }
    }

    /// The number times a rational one.
    pub fn times(&self, factor: &Exact) -> Self {
        Self { a: &self.a * factor, b: &self.b * factor, h: self.h.clone() }
    }

    /// How it compares with zero: where a and b√h have different signs the greater square decides.
    pub fn sign(&self) -> Ordering {
        let of_a = self.a.cmp(&Exact::ZERO);
        let of_root = if self.h.is_zero() { Ordering::Equal } else { self.b.cmp(&Exact::ZERO) };
        if of_a == of_root || of_root.is_eq() {
            return of_a;
        }
        if of_a.is_eq() {
            return of_root;
        }
        match (&self.a * &self.a).cmp(&(&self.b * &self.b * &self.h)) {
            Ordering::Greater => of_a,
            Ordering::Equal => Ordering::Equal,
            Ordering::Less => of_root,
        }
    }
}

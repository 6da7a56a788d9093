//! Exact signs with one square root (E100L-BARR-09).

use std::cmp::Ordering;

use super::wide::product;

/// The sign of `whole + roots * sqrt(square)`. The square is not negative, the roots are below 2^63 in size.
#[must_use]
pub fn sign(whole: i128, roots: i128, square: i128) -> Ordering {
    let (whole_sign, roots_sign) = (whole.cmp(&0), roots.cmp(&0));
    if roots_sign == Ordering::Equal || square == 0 {
        return whole_sign;
    }
    if whole_sign == Ordering::Equal || whole_sign == roots_sign {
        return roots_sign;
    }
    let (size, roots) = (whole.unsigned_abs(), roots.unsigned_abs());
    match product(size, size).cmp(&product(roots * roots, square.unsigned_abs())) {
        Ordering::Greater => whole_sign,
        Ordering::Equal => Ordering::Equal,
        Ordering::Less => roots_sign,
    }
}

#[cfg(test)]
mod tests {
    use super::{Ordering, sign};

    #[test]
    fn signs_with_a_root() {
        assert_eq!(sign(3, 0, 9), Ordering::Greater);
        assert_eq!(sign(-3, 5, 0), Ordering::Less);
        assert_eq!(sign(0, -1, 2), Ordering::Less);
        assert_eq!(sign(-3, 1, 9), Ordering::Equal);
        assert_eq!(sign(-3, 1, 10), Ordering::Greater);
        assert_eq!(sign(-3, 1, 8), Ordering::Less);
        assert_eq!(sign(3, -1, 10), Ordering::Less);
        assert_eq!(sign(-6, 2, 9), Ordering::Equal);
        // Squares beyond 128 bits.
        let n = (1 << 60) + 1;
        assert_eq!(sign(n * n, -n, n * n), Ordering::Equal);
        assert_eq!(sign(n * n, -n, n * n + 1), Ordering::Less);
        assert_eq!(sign(n * n, -n, n * n - 1), Ordering::Greater);
    }
}

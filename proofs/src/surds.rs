//! Theorems about the exact sign of a whole number and a number of square roots.

use std::cmp::Ordering;

use turnspec::engine::arithmetic::surd::sign;

use crate::draw::{factor, within_wide};
#[cfg(stand_in)]
use crate::kani;

/// Bound of whole numbers in property tests: their squares take more than 128 bits.
const WHOLE: i128 = 1 << 100;
/// Bound of roots and factors in property tests.
const ROOTS: i128 = 1 << 60;

/// A number that roots are taken of.
fn square() -> i128 {
    factor(WHOLE).abs()
}

theorems! {
    /// No sign overflows. Where nothing is taken a root of the whole number decides, and where both have one sign it
    /// is theirs.
    /// Of: `surd::sign`
    /// Assumes: any whole number, roots of at most 2^63 in size, of any number that is not negative.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn no_sign_overflows() {
        let (whole, roots): (i128, i64) = (kani::any(), kani::any());
        let (roots, square) = (i128::from(roots), kani::any());
        kani::assume(square >= 0);
        kani::cover!(whole == i128::MIN && roots > 0, "the least whole number");
        let found = sign(whole, roots, square);
        assert!(square != 0 && roots != 0 || found == whole.cmp(&0));
        assert!(found == whole.cmp(&0) || whole.signum() != roots.signum());
    }

    /// Where the root is a whole number the sign is that of the sum.
    /// Of: `surd::sign`
    /// Assumes: numbers of at most 8 in size for the model checker, whole numbers of at most 2^100, roots of at most
    /// 2^60 in size and number for the property tests.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn whole_roots_are_counted() {
        let (root, roots) = (factor(ROOTS).abs(), factor(ROOTS));
        let whole = if kani::any() { factor(WHOLE) } else { factor(8) - root * roots };
        kani::cover!(whole == -roots * root && whole != 0, "a sum of zero");
        assert!(sign(whole, roots, root * root) == (whole + roots * root).cmp(&0));
    }

    /// The opposite number has the opposite sign.
    /// Of: `surd::sign`
    /// Assumes: numbers of at most 8 in size for the model checker, roots of at most 2^60, other numbers of at most
    /// 2^100 in size for the property tests.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn opposites_have_opposite_signs() {
        let (whole, roots, square) = (factor(WHOLE), factor(ROOTS), square());
        let found = sign(whole, roots, square);
        kani::cover!(found == Ordering::Less && whole > 0, "the roots decide");
        assert!(sign(-whole, -roots, square) == found.reverse());
    }

    /// The number grows with its whole part, and with what so many roots are taken of.
    /// Of: `surd::sign`
    /// Assumes: numbers of at most 8 in size for the model checker, roots of at most 2^60, other numbers of at most
    /// 2^100 in size for the property tests; as many roots or more than none.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn the_number_grows_with_its_parts() {
        let (whole, roots, square) = (factor(WHOLE), factor(ROOTS).abs(), square());
        let (greater, greater_square) = (whole + factor(WHOLE).abs(), square + factor(WHOLE).abs());
        kani::cover!(greater < 0 && square < greater_square, "both grow");
        assert!(sign(whole, roots, square) <= sign(greater, roots, greater_square));
    }

    /// A multiple of the number has its sign.
    /// Of: `surd::sign`
    /// Assumes: numbers of at most 8 in size for the model checker, roots of at most 2^60, other numbers of at most
    /// 2^100 in size for the property tests; multiples by at most 3.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn multiples_have_the_same_sign() {
        let (whole, roots, square) = (factor(WHOLE), factor(ROOTS), square());
        let times = i128::from(kani::any::<u8>() >> 6);
        kani::assume(times > 0);
        kani::cover!(whole > 0 && roots < 0 && times > 1, "against each other");
        assert!(sign(times * whole, times * roots, square) == sign(whole, roots, square));
    }

    /// Twice and three times as many roots are roots of four and nine times the number.
    /// Of: `surd::sign`
    /// Assumes: numbers of at most 8 in size for the model checker, roots of at most 2^60, other numbers of at most
    /// 2^100 in size for the property tests.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn a_factor_goes_under_the_root() {
        let (whole, roots, square) = (factor(WHOLE), factor(ROOTS), square());
        let times = i128::from(kani::any::<u8>() >> 6);
        kani::cover!(whole > 0 && roots < 0 && times > 1, "against each other");
        assert!(sign(whole, times * roots, square) == sign(whole, roots, times * times * square));
    }
}

refutations! {
    /// False: roots count as what they are taken of.
    #[unwind(2)]
    fn roots_are_not_taken() {
        let (whole, roots) = (within_wide(1000), factor(8));
        let square = factor(8).abs();
        assert!(sign(whole, roots, square) == (whole + roots * square).cmp(&0));
    }
}

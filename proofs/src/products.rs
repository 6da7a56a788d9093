//! Theorems about products of twice the width.

use turnspec::engine::arithmetic::wide::product;

#[cfg(stand_in)]
use crate::kani;

/// A factor of products whose values are asserted: both halves at most 7 for the model checker, any for the property
/// tests.
fn factor() -> u128 {
    #[cfg(stand_in)]
    let value = kani::any();
    #[cfg(not(stand_in))]
    let value = u128::from(kani::any::<u8>() >> 5) << 64 | u128::from(kani::any::<u8>() >> 5);
    value
}

theorems! {
    /// No product overflows on the way to its halves; a factor of zero makes it zero.
    /// Of: `wide::product`
    /// Assumes: any factors.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn no_product_overflows() {
        let (a, b) = (kani::any(), kani::any());
        kani::cover!(a == u128::MAX && b == u128::MAX, "the greatest product");
        assert!(product(a, b) == (0, 0) || a != 0 && b != 0);
    }

    /// A factor that is greater by one adds the other factor to the product: with the product by zero this tells all
    /// products.
    /// Of: `wide::product`
    /// Assumes: halves of at most 7 for the model checker, any factors for the property tests.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn one_more_adds_the_other_factor() {
        let (a, b) = (factor(), factor());
        kani::assume(b != u128::MAX);
        let (high, low) = product(a, b);
        let (sum, carried) = low.overflowing_add(a);
        kani::cover!(high != 0 && low != 0, "a product of two halves");
        assert!(product(a, b + 1) == (high + u128::from(carried), sum));
    }

    /// The product by a power of two is the other factor moved to the left, across both halves.
    /// Of: `wide::product`
    /// Assumes: a factor below 2^32 for the model checker, any for the property tests; any power.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn a_power_of_two_moves_the_other_factor() {
        #[cfg(stand_in)]
        let b: u128 = kani::any();
        #[cfg(not(stand_in))]
        let b = u128::from(kani::any::<u32>());
        let power = u32::from(kani::any::<u8>() >> 1);
        kani::cover!(power == 127 && b > 2, "into the high half");
        let high = b.checked_shr(128 - power).unwrap_or(0);
        assert!(product(1 << power, b) == (high, b << power));
    }

    /// The product with a greater factor is no less: halves compare as the products do.
    /// Of: `wide::product`
    /// Assumes: halves of at most 7 for the model checker, any factors for the property tests.
    /// Rules: E100L-BARR-09
    #[unwind(2)]
    fn halves_compare_as_products() {
        let (a, b, more) = (factor(), factor(), factor());
        kani::assume(a <= more);
        kani::cover!(product(a, b).1 > product(more, b).1, "the low halves compare the other way");
        assert!(product(a, b) <= product(more, b));
    }
}

refutations! {
    /// False: products compare as their low halves.
    #[unwind(2)]
    fn the_low_half_decides() {
        let (a, b, more) = (factor(), factor(), factor());
        kani::assume(a <= more);
        assert!(product(a, b).1 <= product(more, b).1);
    }
}

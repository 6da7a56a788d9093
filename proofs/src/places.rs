//! Theorems about places in a program text.

use turnspec::engine::arithmetic::span::offset;

#[cfg(stand_in)]
use crate::kani;

theorems! {
    /// An offset of a trace is the offset of the text, up to 4 GiB, and the largest one beyond.
    /// Of: `span::offset`
    /// Assumes: any offset.
    /// Rules: none (the place of an event)
    #[unwind(2)]
    fn an_offset_is_kept_or_the_largest() {
        let place: usize = kani::any();
        kani::cover!(place > 1 << 32, "beyond 4 GiB");
        kani::cover!(place < 1 << 32, "within 4 GiB");
        let largest = u32::MAX as usize;
        assert!(offset(place) as usize == if place < largest { place } else { largest });
    }

    /// Offsets keep their order, so that no event ends before it begins.
    /// Of: `span::offset`
    /// Assumes: any offsets.
    /// Rules: none (the place of an event)
    #[unwind(2)]
    fn offsets_keep_their_order() {
        let (start, end): (usize, usize) = (kani::any(), kani::any());
        kani::assume(start <= end);
        kani::cover!(offset(start) < offset(end), "a block with text");
        assert!(offset(start) <= offset(end));
    }
}

refutations! {
    /// False: different places have different offsets.
    #[unwind(2)]
    fn offsets_tell_all_places_apart() {
        let (one, other): (usize, usize) = (kani::any(), kani::any());
        assert!(one == other || offset(one) != offset(other));
    }
}

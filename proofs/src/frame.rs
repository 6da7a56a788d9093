//! Theorems about program and machine coordinates.

use turnspec::engine::arithmetic::frame::{between, coordinate, shift_to, to_machine, to_program};
use turnspec_oracle::integer::{Amounts, mirror};

use crate::draw::within;
#[cfg(stand_in)]
use crate::kani;

/// Amounts in these statements; those of a control are below 2^38, sums of them below 2^60.
const ROOM: i64 = 1 << 60;

fn amount() -> i64 {
    within(ROOM)
}

fn amounts() -> Amounts {
    Amounts { x: amount(), z: amount(), c: amount(), w: amount() }
}

theorems! {
    /// A program coordinate taken to the machine and back is the same.
    /// Of: `frame::between`, `frame::to_machine`, `frame::to_program`
    /// Assumes: amounts of at most 2^60 in size.
    /// Rules: E100L-COORD-03
    #[unwind(2)]
    fn program_and_machine_correspond() {
        let between = between(amount(), amount(), amount());
        let program = amount();
        kani::cover!(between > 2 * ROOM, "large offsets");
        assert!(to_program(to_machine(program, between), between) == program);
        assert!(to_machine(to_program(program, between), between) == program);
    }

    /// Machine coordinate is program coordinate plus zero offset plus zero shift plus tool offset, exactly.
    /// Of: `frame::between`, `frame::to_machine`
    /// Assumes: amounts of at most 2^60 in size.
    /// Rules: E100L-COORD-03
    #[unwind(2)]
    fn offsets_add_up() {
        let (program, offset, shift, tool) = (amount(), amount(), amount(), amount());
        kani::cover!(offset < 0 && shift > 0, "offsets of both signs");
        assert!(to_machine(program, between(offset, shift, tool)) == program + offset + shift + tool);
    }

    /// The mirror image of a mirror image is the coordinate itself, and without a mirror nothing changes.
    /// Of: `integer::mirror::x`
    /// Assumes: any but the least coordinate of 64 bits.
    /// Rules: E100L-MIRR-05
    #[unwind(2)]
    fn mirroring_twice_changes_nothing() {
        let x: i64 = kani::any();
        kani::assume(x != i64::MIN);
        kani::cover!(x < 0, "a negative coordinate");
        assert!(mirror::x(mirror::x(x, true), true) == x);
        assert!(mirror::x(x, true) == -x && mirror::x(x, false) == x);
    }

    /// The order of the offsets does not matter.
    /// Of: `frame::between`
    /// Assumes: amounts of at most 2^60 in size.
    /// Rules: E100L-COORD-03
    #[unwind(2)]
    fn offsets_commute() {
        let (offset, shift, tool) = (amount(), amount(), amount());
        kani::cover!(offset != shift && shift != tool, "different offsets");
        assert!(between(offset, shift, tool) == between(shift, offset, tool));
        assert!(between(offset, shift, tool) == between(tool, shift, offset));
    }

    /// An offset that is added and one of the opposite sign that is subtracted lead to the same place.
    /// Of: `frame::between`
    /// Assumes: amounts of at most 2^60 in size.
    /// Rules: E100L-COORD-03
    #[unwind(2)]
    fn a_subtracted_offset_is_an_opposite_one() {
        let (offset, shift, tool) = (amount(), amount(), amount());
        kani::cover!(tool != 0, "a tool offset");
        let (added, subtracted) = (between(offset, shift, tool), between(offset, shift, -tool));
        assert!(added - subtracted == 2 * tool);
    }

    /// Beyond every range a coordinate stays at the end of 64 bits: it never comes out on the other side.
    /// Of: `frame::between`, `frame::to_machine`, `frame::to_program`
    /// Assumes: any amounts.
    /// Rules: E100L-ADDR-01
    #[unwind(2)]
    fn no_coordinate_wraps() {
        let (place, between): (i64, i64) = (kani::any(), kani::any());
        kani::cover!(place == i64::MAX && between == i64::MAX, "beyond 64 bits");
        let (machine, program) = (to_machine(place, between), to_program(place, between));
        assert!(between < 0 || machine >= place && program <= place);
        assert!(between > 0 || machine <= place && program >= place);
    }

    /// After a zero shift the present point has the coordinate of its word, and the machine has not moved.
    /// Of: `frame::shift_to`, `frame::to_program`
    /// Assumes: amounts of at most 2^58 in size.
    /// Rules: E100L-G50-01, E100L-G50-02, E100L-G50-03
    #[unwind(8)]
    fn a_zero_shift_names_the_present_point() {
        let [machine, offset, shift, tool, word] = [(); 5].map(|()| within(ROOM >> 2));
        let program = to_program(machine, between(offset, shift, tool));
        kani::cover!(program != word, "the shift changes");
        let shifted = shift_to(shift, program, word);
        assert!(to_program(machine, between(offset, shifted, tool)) == word);
        assert!(shifted - shift == program - word);
    }

    /// An incremental word leads from the reference point, an absolute one wherever it is; both meet where the
    /// reference is zero.
    /// Of: `frame::coordinate`
    /// Assumes: amounts of at most 2^60 in size.
    /// Rules: E100L-ABS-01, E100L-ABS-02
    #[unwind(2)]
    fn incremental_words_count_from_the_reference() {
        let (reference, word) = (amount(), amount());
        kani::cover!(reference < 0 && word > 0, "both signs");
        assert!(coordinate(reference, word, true) - reference == word);
        assert!(coordinate(reference, word, false) == word && coordinate(0, word, true) == word);
    }

    /// The sum of the oracle's amounts never overflows, and subtracting takes back what adding did.
    /// Of: `Amounts::plus`
    /// Assumes: amounts of at most 2^60 in size.
    /// Rules: E100L-COORD-03
    #[unwind(2)]
    fn amounts_add_and_subtract() {
        let (one, other) = (amounts(), amounts());
        kani::cover!(one.x == ROOM && other.x == ROOM, "the largest amounts");
        assert!(one.plus(other, 1) == other.plus(one, 1));
        assert!(one.plus(other, 1).plus(other, -1) == one);
    }

    /// Engine and oracle make the same machine coordinate of a program coordinate.
    /// Of: `frame::between`, `frame::to_machine`, `Amounts::plus`
    /// Assumes: amounts of at most 2^58 in size.
    /// Rules: E100L-COORD-03
    #[unwind(8)]
    fn both_chain_offsets_alike() {
        let [program, offset, shift, tool] = [(); 4].map(|()| within(ROOM >> 2));
        let sign = if kani::any() { 1 } else { -1 };
        kani::cover!(sign < 0 && tool != 0, "a subtracted tool offset");
        let on_x = |x| Amounts { x, ..Amounts::default() };
        let total = on_x(offset).plus(on_x(shift), 1).plus(on_x(tool), sign);
        let oracle = on_x(program).plus(total, 1);
        assert!(oracle == on_x(to_machine(program, between(offset, shift, sign * tool))));
    }
}

refutations! {
    /// False: the sign of the tool offset does not matter.
    #[unwind(2)]
    fn the_sign_of_an_offset_does_not_matter() {
        let (offset, tool) = (amount(), amount());
        assert!(between(offset, 0, tool) == between(offset, 0, -tool));
    }

    /// False: a zero shift moves the machine coordinate of a program point nowhere.
    #[unwind(2)]
    fn a_zero_shift_moves_nothing() {
        let (program, shift) = (amount(), amount());
        assert!(to_machine(program, between(0, shift, 0)) == program);
    }
}

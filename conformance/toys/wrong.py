#!/usr/bin/env python3
"""The control of `right.py` with three bugs, each of which has been made in earnest somewhere.

The conformance kit has to find all three. A bug is one method, and its comment names the rule that it breaks.
"""

from right import Control, main


class Wrong(Control):
    """Right, but for the three methods below."""

    def target(self, axis, word):
        """ABS-03: takes an incremental X for a travel of the radius, so that the diameter changes by twice it."""
        if axis == "x" and self.modes["dimension"] == 91:
            return self.position["x"] + 2 * word
        return super().target(axis, word)

    def side_of_centre(self, is_major):
        """CIRC-17, CIRC-18: forgets that the sense decides; a clockwise arc gets the centre of the other one."""
        return -1 if is_major else 1

    def feed_in_force(self):
        """FEED-03: leaves F in the unit that it was written in when G94 or G95 changes the mode."""
        feed = super().feed_in_force()
        _, written_in = self.feed
        return {**feed, "unit": "mm/min" if written_in == 94 else "mm/rev"}


if __name__ == "__main__":
    main(Wrong)

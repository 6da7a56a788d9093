"""What a set-up says: start, offsets, nose radii, limits and parameters."""
from decimal import Decimal as D

from events import Unsupported

KNOWN = {"control", "start", "zero_offset", "tool_offset", "nose_radius", "limits", "parameters", "switches"}
KNOWN_PARAMETERS = {"chamfering", "circular_radius_tolerance"}


class Setup:
    def __init__(self, table):
        parameters = table.get("parameters", {})
        unknown = sorted(set(table) - KNOWN)
        unknown += [f"parameters.{key}" for key in sorted(set(parameters) - KNOWN_PARAMETERS)]
        if unknown:
            raise Unsupported(f"set-up: {unknown[0]}")
        self.table = table
        self.start = pair_of(table.get("start", {}))
        self.chamfering = parameters.get("chamfering", "any_angle")
        self.tolerance = D(str(parameters.get("circular_radius_tolerance", "0.02")))

    def switch(self, name):
        return self.table.get("switches", {}).get(name, False)

    def entry(self, name, index):
        """(z, x) of an entry; number 0 is none."""
        entries = (entry for entry in self.table.get(name, []) if index and entry["number"] == index)
        return pair_of(next(entries, {}))

    def frame(self, offset):
        """Machine coordinate less program coordinate (COORD-03), X as a diameter."""
        zero, tool = pair_of(self.table.get("zero_offset", {})), self.entry("tool_offset", offset)
        return (zero[0] + tool[0], zero[1] + tool[1])

    def nose(self, number):
        """R and v (NRC-04, NRC-05)."""
        v = self.entry("nose_radius", number)
        return max(abs(v[0]), abs(v[1])), v

    def limit(self, axis, side):
        limit = self.table.get("limits", {}).get(axis, {}).get(side)
        return None if limit is None else D(str(limit))

    def beyond_negative(self, axis, coordinate):
        limit = self.limit(axis, "negative")
        return limit is not None and coordinate < limit

    def beyond_positive(self, axis, coordinate):
        limit = self.limit(axis, "positive")
        return limit is not None and coordinate > limit


def pair_of(table):
    if not set(table) <= {"number", "x", "z"}:
        raise Unsupported("another axis")
    return (D(str(table.get("z", 0))), D(str(table.get("x", 0))))

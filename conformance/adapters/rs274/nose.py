"""The nose radius entries of an E100L as tools of LinuxCNC.

An entry is the way from the imaginary tip to the nose centre; a lathe tool of LinuxCNC has a diameter and one of
nine orientations. They say the same when the tip is the corner of two tangents to the nose, a point of the nose on
an axis through its centre, or the centre. Tool and entry have the same number.
"""

from decimal import Decimal

from shared import NotShared

# The orientation by the signs of the way from the tip to the centre, in X and in Z.
ORIENTATIONS = {
    (1, -1): 1, (1, 1): 2, (-1, 1): 3, (-1, -1): 4, (0, -1): 5, (1, 0): 6, (0, 1): 7, (-1, 0): 8, (0, 0): 9,
}
# The digits of a T word: nose radius entry, tool, tool offset.
NOSE_PLACE, OFFSET_PLACE = 10_000, 100

# rs274 by itself reads the tool table in inches.
INCH = Decimal("25.4")


class Noses:
    """The entries of a set-up: how far a nose centre is from its tip in X (a radius) and Z."""

    def __init__(self, setup):
        self.has_six_digits = setup["options"]["nose_radius_compensation"]
        self.sets = setup["options"]["offset_sets"]
        self.offsets = {entry["number"] for entry in setup["tool_offset"] if any(amounts(entry))}
        self.entries = {entry["number"]: amounts(entry) for entry in setup["nose_radius"]}

    def of_word(self, text):
        """The number of the entry that a T word selects, if the rest of the word has no effect on positions."""
        value = int(text)
        number, offset = value // NOSE_PLACE, value % OFFSET_PLACE
        if not self.has_six_digits or max(number, offset) > self.sets or offset in self.offsets:
            raise NotShared(f"T{text}: a tool offset, a number without entry, or four digits")
        orientation(self.to_centre(number))
        return number

    def to_centre(self, number):
        return self.entries.get(number, (Decimal(0), Decimal(0)))

    def table(self, numbers):
        """The tool table with these entries. Number 0 is no tool, and has no radius."""
        lines = [tool(number, self.to_centre(number)) for number in sorted(numbers) if number]
        return "".join(lines)


def amounts(entry):
    return Decimal(str(entry["x"])), Decimal(str(entry["z"]))


def tool(number, way):
    diameter = 2 * max(map(abs, way)) / INCH
    return f"T{number} P{number} D{diameter:.20f} Q{orientation(way)}\n"


def orientation(way):
    if len({abs(amount) for amount in way if amount}) > 1:
        raise NotShared(f"a nose radius entry of X {way[0]} Z {way[1]}")
    return ORIENTATIONS[tuple((amount > 0) - (amount < 0) for amount in way)]

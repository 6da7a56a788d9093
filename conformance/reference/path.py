"""The programmed path: where P is, where a block leads it, and the elements of the block.

It knows nothing of compensation. Points of elements are (z, x) with x a radius; the position is (z, X as a
diameter) in machine coordinates, since a new frame moves nothing.
"""
from decimal import Decimal as D

from corner import Element
from events import Alarm, RANGE, Unsupported
from plane import add, cross, dot, exact_sign, latch, left, length, sign, sub, unit

LINES = {"G00": "rapid", "G01": "linear"}
HALF = D("0.5")


class Path:
    def __init__(self, setup):
        self.setup, self.offset = setup, 0
        self.machine = setup.start
        self.base = None        # corner of a basic chamfer block, for the words of the next block in G91

    def frame(self):
        return self.setup.frame(self.offset)

    def select_offset(self, offset):
        """Whether the frame changes with an offset number; a T word forgets the base point."""
        before, self.offset, self.base = self.frame(), offset, None
        return self.frame() != before

    def present(self):
        """P in program coordinates, X as a diameter."""
        return sub(self.machine, self.frame())

    def move_to(self, point, frame):
        self.machine = add(point, frame)

    def elements(self, block, modes):
        """The elements of a block with X or Z, and the rules of its form."""
        base, self.base = self.base, None
        if block.shot:
            target, rules = self.target(block, modes, base)
            return self.chamfer(block, target), rules
        if modes["motion"] in LINES:
            target, rules = self.target(block, modes, base)
            return [self.line(LINES[modes["motion"]], target, block)], rules
        return [self.arc(block, modes)], ["CIRC-12"] if "L" in block.words else []

    def line(self, kind, target, block):
        axes = [letter for letter in "XZ" if letter in block.words]
        return Element(kind, radius(self.present()), radius(target), axes=axes)

    def target(self, block, modes, base=None):
        """Of X and Z; words of G91 count from the base point of a chamfer block before (CHAM-13), if there is one."""
        present, incremental = self.present(), modes["dimension"] == "G91"
        origin = (base or present) if incremental else (0, 0)
        z, x = (origin[k] + block.words[letter] if letter in block.words else present[k]
                for k, letter in enumerate("ZX"))
        return (z, x), ["CHAM-13"] if base and incremental else []

    def arc(self, block, modes):
        target, _ = self.target(block, modes)
        start, end, sigma = radius(self.present()), radius(target), 1 if modes["motion"] == "G03" else -1
        if "L" in block.words:
            self.refuse(start == end, block, "unspecified", "CIRC-07", "circle")
            return Element("arc", start, end, self.centre_of_radius(block, start, end, sigma), sigma)
        if "X" not in block.words or "Z" not in block.words:
            raise Unsupported("arc with one coordinate")
        centre = add(start, (block.words.get("K", 0), block.words.get("I", 0)))
        self.refuse(start == end, block, "unspecified", "CIRC-07", "circle")
        difference = abs(length(sub(start, centre)) - length(sub(end, centre)))
        self.refuse(sign(difference - self.setup.tolerance) > 0, block, "arc_radius_mismatch", "CIRC-11")
        return Element("arc", start, end, centre, sigma)

    def centre_of_radius(self, block, start, end, sigma):
        """CIRC-16 and CIRC-17."""
        chord, size = sub(end, start), block.words["L"]
        square = size * size - dot(chord, chord) / 4
        decided = exact_sign(lambda: size * size * 4 - dot(chord, chord))
        self.refuse(decided < 0, block, "arc_radius_too_small", "CIRC-16")
        middle = add(start, chord, HALF)
        return latched(add(middle, left(unit(chord)), sigma * square.sqrt()) if decided else middle)

    def chamfer(self, block, target):
        """G75 and G76 in the basic form: CHAM-03, CHAM-07, CHAM-08 and CHAM-11."""
        size, along_x = block.words["L"], "X" in block.words
        start, corner = radius(self.present()), radius(target)
        travel = sub(corner, start)[1 if along_x else 0]
        self.refuse(travel == 0, block, "chamfer_axes", "CHAM-08")
        self.refuse(abs(travel) < abs(size), block, "chamfer_too_short", "CHAM-07")
        back = -abs(size) if travel > 0 else abs(size)
        across = (size, 0) if along_x else (0, size)
        b, d = add(corner, (0, back) if along_x else (back, 0)), add(corner, across)
        self.base = diameter(corner)
        self.in_range(block, diameter(corner), "X" if along_x else "Z")
        first = [self.line("linear", diameter(b), block)] if b != start else []
        if block.shot == "G75":
            return first + [Element("linear", b, d)]
        sense = exact_sign(lambda: cross(sub(corner, start), across))
        return first + [Element("arc", b, d, add(b, across), sense)]

    def in_range(self, block, point, letters="XZ"):
        """`coordinate_range` of the axes of a point (X as a diameter)."""
        beyond = any(abs(c) > RANGE for c, letter in zip(point, "ZX") if letter in letters)
        self.refuse(beyond, block, "coordinate_range", "ADDR-01")

    @staticmethod
    def refuse(condition, block, name, rule, detail=None):
        if condition:
            raise Alarm(name, rule, block.place, detail)


def radius(point):
    return (point[0], point[1] / 2)


def diameter(point):
    return (point[0], 2 * point[1])


def latched(point):
    """(z, x) with z and 2x to the nanometre."""
    return (latch(point[0]), latch(2 * point[1]) / 2)

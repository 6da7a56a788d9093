"""Events and alarms, motions whose end is found later, and how both are written in compact notation."""
from decimal import Decimal as D
from typing import NamedTuple

from plane import add, latch, latched_length, sub

#: Largest X and Z of a program, in mm (ADDR-01).
RANGE = D("99999.999")


class Event(NamedTuple):
    kind: str
    fields: dict
    rules: list
    place: tuple        # line and sequence name

    def text(self):
        words = [self.kind] + [f"{key}={value}" for key, value in self.fields.items()] + [f"line={self.place[0]}"]
        return " ".join(words + (["rules=" + "+".join(dict.fromkeys(self.rules))] if self.rules else []))


class Alarm(Exception):
    """An alarm with the rule that it cites, the place that it is found at, and its detail."""

    def __init__(self, name, rule, place, detail=None):
        super().__init__(name)
        self.name, self.rule, self.place, self.detail = name, rule, place, detail

    def event(self):
        detail = {"detail": self.detail} if self.detail else {}
        return Event("alarm", {"name": self.name} | detail, [self.rule], self.place)


class Unsupported(Exception):
    """The program leaves the subset."""


class Motion:
    """A motion: P in the program coordinates of its block (z, X as a diameter), and later where the tip goes.

    `moves` says whether it has a motion of X or Z, `v` is the way from tip to centre, `compensated` whether G41 or
    G42 is in force in its block.
    """

    def __init__(self, kind, point, place, frame, setup, v, compensated, moves=True):
        self.kind, self.point, self.place, self.frame, self.setup = kind, point, place, frame, setup
        self.v, self.compensated, self.moves = v, compensated, moves
        self.nose = self.tip = None
        self.fields, self.rules = {}, []

    def end_at(self, corner):
        """The nose centre, given relative to P, and with it the tip: NRC-07, NRC-29, NRC-80."""
        self.nose = (latch(self.point[0] + corner[0]), latch(self.point[1] + 2 * corner[1]))
        self.tip = tip_of(self.nose, self.v)
        if max(abs(coordinate) for coordinate in self.tip) > RANGE:
            raise Alarm("coordinate_range", "ADDR-01", self.place)
        z, x = add(self.tip, self.frame)
        for axis, coordinate in (("x", x), ("z", z)):
            if self.setup.beyond_negative(axis, coordinate):
                raise Alarm("travel_limit_negative", "NRC-80", self.place)
            if self.setup.beyond_positive(axis, coordinate):
                raise Alarm("travel_limit_positive", "NRC-80", self.place)

    def event(self, axes):
        """The event, and the machine position of the axes after it, which are at `axes` before."""
        if self.compensated and not self.moves:
            self.tip = sub(axes, self.frame)
            self.nose = add(self.tip, (self.v[0], 2 * self.v[1]))
        target = add(self.tip or self.point, self.frame) if self.tip or self.moves else axes
        fields = pair("", self.point) | pair("m", target)
        if self.compensated:
            fields |= pair("t", self.tip) | pair("n", self.nose)
        if self.kind == "linear" and "c" not in self.fields:
            dz, dx = sub(target, axes)
            fields["path"] = number(latched_length((dz, dx / 2)))
        return Event(self.kind, fields | self.fields, self.general_rules() + self.rules, self.place), target

    def general_rules(self):
        if not self.compensated:
            return []
        return ["NRC-07", "NRC-42"] if self.kind == "linear" else ["NRC-07"]


def tip_of(nose, v):
    return (nose[0] - v[0], nose[1] - 2 * v[1])


def pair(prefix, point):
    return {prefix + "x": number(point[1]), prefix + "z": number(point[0])}


def number(value):
    """As decimal text without exponent, superfluous zeros and minus zero."""
    return format(value.normalize(), "f") if value else "0"

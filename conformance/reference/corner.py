"""Where the nose centre is at the end of an element, alone (contact) or in the corner with the next one.

Rules NRC-02, NRC-26, NRC-30 to NRC-33, NRC-48, NRC-49, NRC-51 to NRC-53, NRC-62 and NRC-63. Corners are given
relative to P, the programmed point in which the elements meet.
"""
from plane import add, cross, dot, exact_sign, left, length, scaled, sign, sub, unit


class Element:
    """A line, or an arc about `centre` with sense `sigma` (+1 G03, -1 G02).

    `axes` are those whose range and limits are tested: they have a word in the block, or are computed. In compensation it has a side `s` (+1 G41, -1 G42), the nose radius `radius` and the way `v` from tip to centre.
    """

    def __init__(self, kind, start, end, centre=None, sigma=0, axes="XZ"):
        self.kind, self.start, self.end, self.centre, self.sigma = kind, start, end, centre, sigma
        self.axes = axes
        self.s = self.radius = self.v = None

    def compensate(self, s, radius, v):
        self.s, self.radius, self.v = s, radius, v
        return self

    def offset(self):
        return self.s * self.radius

    def tangent(self, point):
        """The direction of travel, not of unit length."""
        if self.centre is None:
            return sub(self.end, self.start)
        return scaled(left(sub(point, self.centre)), self.sigma)

    def offset_radius(self, point):
        """NRC-48, with the radius at this end."""
        return length(sub(point, self.centre)) - self.sigma * self.offset()

    def too_small(self):
        """The offset radius is negative at an end, or the end has no tangent."""
        return self.centre is not None and any(self.too_small_at(point) for point in (self.start, self.end))

    def too_small_at(self, point):
        if point == self.centre:
            return True
        arm, inside = sub(point, self.centre), self.sigma * self.s > 0
        return inside and exact_sign(lambda: dot(arm, arm) - self.radius * self.radius) < 0


def contact(element, at_start=False):
    """P + s R left(t), relative to that end (NRC-02)."""
    point = element.start if at_start else element.end
    return scaled(left(unit(element.tangent(point))), element.offset())


def corner(i, j):
    """The nose centre where i ends and j starts, and the rules; None without common point (NRC-53)."""
    ti, tj = i.tangent(i.end), j.tangent(j.start)
    rules = ["NRC-11"] if i.radius != j.radius else []
    if exact_sign(lambda: cross(ti, tj)) == 0:
        return parallel(i, j, exact_sign(lambda: dot(ti, tj)) > 0, rules)
    lines = i.centre is None and j.centre is None
    if i.s != j.s:
        rules.append("NRC-62" if lines else "NRC-63")
    if lines:
        return two_lines(i, j), rules + ["NRC-26"]
    if i.centre and j.centre:
        return two_arcs(i, j), rules + ["NRC-52"]
    arc, at, line = (i, i.end, j) if i.centre else (j, j.start, i)
    return line_and_arc(line, arc, at), rules + ["NRC-51"]


def parallel(i, j, same, rules):
    """Tangents that are parallel: NRC-30 to NRC-33, NRC-49, NRC-53."""
    lines = i.centre is None and j.centre is None
    if i.offset() == (j.offset() if same else -j.offset()):
        rule = "NRC-31" if not same else "NRC-30" if lines else "NRC-49"
    elif lines:
        rule = "NRC-33" if same else "NRC-32"
    else:
        return None, rules
    return contact(i), rules + [rule]


def two_lines(i, j):
    """NRC-26."""
    di, dj = unit(i.tangent(i.end)), unit(j.tangent(j.start))
    along = sub(scaled(dj, i.offset()), scaled(di, j.offset()))
    return scaled(along, 1 / cross(di, dj))


def line_and_arc(line, arc, at):
    """NRC-51; `at` is P as a point of the arc."""
    m, travel = sub(arc.centre, at), line.tangent(line.end)
    d = unit(travel)
    q = scaled(left(d), line.offset())
    w, r = sub(q, m), arc.offset_radius(at)
    b = dot(w, d)
    root = root_of(b * b - dot(w, w) + r * r)
    nearer = -exact_sign(lambda: dot(m, travel))
    return None if root is None else add(q, d, nearer * root - b)


def two_arcs(i, j):
    """NRC-52."""
    mi, mj = sub(i.centre, i.end), sub(j.centre, j.start)
    between = sub(mj, mi)
    ri, rj, distance, e = i.offset_radius(i.end), j.offset_radius(j.start), length(between), unit(between)
    g = (ri * ri - rj * rj + distance * distance) / (2 * distance)
    root = root_of(ri * ri - g * g)
    side = -exact_sign(lambda: dot(left(between), mi))
    return None if root is None else add(add(mi, e, g), left(e), side * root)


def root_of(square):
    decided = sign(square)
    return None if decided < 0 else square.sqrt() if decided > 0 else square * 0

"""Where the nose centre is at the corner of two elements: rules NRC-02, NRC-26 to NRC-33 and NRC-48 to NRC-53.

Points and vectors are (z, x) in mm, x a radius. Numbers have 300 digits; what is smaller than 1e-200 is zero,
far below what a nonzero expression of these coordinates can be.
"""
from decimal import Decimal as D, ROUND_HALF_UP, getcontext

getcontext().prec = 300
TINY, NM = D("1e-200"), D("1e-6")


def sign(value):
    return 0 if abs(value) < TINY else 1 if value > 0 else -1


def latch(value):
    """To the nanometre, half away from zero."""
    return value.quantize(D("1e-200")).quantize(NM, ROUND_HALF_UP)


def add(a, b, factor=1):
    return (a[0] + factor * b[0], a[1] + factor * b[1])


def sub(a, b):
    return add(a, b, -1)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def left(a):
    return (-a[1], a[0])


def length(a):
    return dot(a, a).sqrt()


def unit(a):
    return add((D(0), D(0)), a, 1 / length(a))


class Element:
    """A line, or an arc about `centre`, on side `s` (+1 G41, -1 G42) with radius R (NRC-02)."""

    def __init__(self, kind, start, end, centre=None, sigma=0):
        self.kind, self.start, self.end, self.centre, self.sigma = kind, start, end, centre, sigma
        self.s = self.R = self.v = None

    def tangent(self, point):
        if self.centre is None:
            return sub(self.end, self.start)
        return add((D(0), D(0)), left(sub(point, self.centre)), self.sigma)

    def offset_radius(self, point):
        """NRC-48, with the radius at this end."""
        return length(sub(point, self.centre)) - self.s * self.sigma * self.R

    def too_small(self):
        return self.centre and any(sign(self.offset_radius(p)) < 0 for p in (self.start, self.end))


def contact(element, at_start=False):
    """P + s R left(t): the nose centre in contact at an end, relative to that end."""
    point = element.start if at_start else element.end
    return add((D(0), D(0)), left(unit(element.tangent(point))), element.s * element.R)


def corner(i, j):
    """Nose centre where i ends and j starts, relative to P, and the rules; None without common point."""
    ti, tj = i.tangent(i.end), j.tangent(j.start)
    lines = i.centre is None and j.centre is None
    rules = ["NRC-11"] if i.R != j.R else []
    touch = contact(i)
    if sign(cross(ti, tj)) == 0:
        same = sign(dot(ti, tj)) > 0
        if sign(i.s * i.R - (1 if same else -1) * j.s * j.R) == 0:
            return touch, rules + ["NRC-31" if not same else "NRC-30" if lines else "NRC-49"]
        return (touch, rules + ["NRC-33" if same else "NRC-32"]) if lines else (None, rules)
    if i.s != j.s:
        rules.append("NRC-62" if lines else "NRC-63")
    if lines:
        di, dj = unit(ti), unit(tj)
        a = add(add((D(0), D(0)), dj, i.s * i.R), di, -j.s * j.R)
        return add((D(0), D(0)), a, 1 / cross(di, dj)), rules + ["NRC-26"]
    if i.centre and j.centre:
        mi, mj = sub(i.centre, i.end), sub(j.centre, j.start)
        ri, rj, d = i.offset_radius(i.end), j.offset_radius(j.start), length(sub(mj, mi))
        e = unit(sub(mj, mi))
        g = (ri * ri - rj * rj + d * d) / (2 * d)
        square, side = ri * ri - g * g, -sign(dot(left(e), mi))
        base, direction, rules = add(mi, e, g), left(e), rules + ["NRC-52"]
    else:
        arc, at, line = (i, i.end, j) if i.centre else (j, j.start, i)
        m, d = sub(arc.centre, at), unit(line.tangent(line.end))
        q = add((D(0), D(0)), left(d), line.s * line.R)
        w, r = sub(q, m), arc.offset_radius(at)
        b = dot(w, d)
        square, side = b * b - dot(w, w) + r * r, sign(b)
        base, direction, rules = add(q, d, -b), d, rules + ["NRC-51"]
    if sign(square) < 0:
        return None, rules
    root = D(0) if sign(square) == 0 else square.sqrt()
    return add(base, direction, side * root), rules

"""Numbers a + b·√q with rational a, b and q, as the points of circles have them: compared and rounded exactly."""
from fractions import Fraction as Q
from functools import total_ordering
from math import isqrt

from exact import NANOMETRE, sign


def sign_of_root(a, b, q):
    """Of a + b·√q."""
    if sign(a) * sign(b) >= 0 or not q:
        return sign(a) or (sign(b) if q else 0)
    return sign(a) * sign(a * a - b * b * q)


def sign_of_roots(a, b, p, c, q):
    """Of a + b·√p + c·√q."""
    first, second = sign_of_root(a, b, p), sign(c) if q else 0
    if first * second >= 0:
        return first or second
    return first * sign_of_root(a * a + b * b * p - c * c * q, 2 * a * b, p)


@total_ordering
class Root:
    def __init__(self, a, b=Q(0), q=Q(0)):
        self.a, self.b, self.q = (Q(a), b, q) if b and q else (Q(a), Q(0), Q(0))

    def minus(self, other):
        """The sign of the difference to a root or a fraction."""
        other = other if isinstance(other, Root) else Root(other)
        return sign_of_roots(self.a - other.a, self.b, self.q, -other.b, other.q)

    def __eq__(self, other):
        return self.minus(other) == 0

    def __lt__(self, other):
        return self.minus(other) < 0

    def times(self, factor):
        return Root(self.a * factor, self.b * factor, self.q)

    def plus(self, amount):
        return Root(self.a + amount, self.b, self.q)

    def latch(self):
        """Rounded to the nanometre, half away from zero."""
        if self.minus(0) < 0:
            return -self.times(-1).latch()
        # A whole number of nanometres that is at most two too small.
        square = self.b * self.b * self.q / NANOMETRE**2
        root = isqrt(int(square)) * (1 if self.b > 0 else -1)
        count = int(self.a / NANOMETRE + root) - 2
        while self.minus((count + Q(1, 2)) * NANOMETRE) >= 0:
            count += 1
        return count * NANOMETRE

"""Numbers whose sign and rounding are certain, and vectors of the plane (z, x), x a radius, in mm.

Coordinates are exact decimals; square roots and quotients of them have 60 digits at first, far more than the
errors of one corner take. Where these cannot tell a number from zero, or from the middle between two nanometres,
`Undecided` asks for the whole computation with 1000 digits. Then what lies below 1e-900 is zero: such a number has
at most four square roots, hence at most 16 conjugates; times twice the square of a distance, in half nanometres,
it is an algebraic integer with conjugates below 1e40, whose product is a whole number. Unless it is zero it is
above 1e-650.
"""
from decimal import Decimal as D, Inexact, ROUND_HALF_UP, getcontext, localcontext

NANOMETRE = D("1e-6")
#: Digits, and what is too small to be told from zero with them.
ACCURACIES = ((60, D("1e-25")), (1000, D("1e-900")))
ZERO = (D(0), D(0))


class Undecided(Exception):
    """More digits are needed."""


def with_enough_digits(compute):
    """The result of `compute`, with the digits that its decisions need."""
    for digits, _ in ACCURACIES:
        with localcontext() as context:
            context.prec = digits
            try:
                return compute()
            except Undecided:
                continue
    raise AssertionError("the last accuracy decides everything")


def tiny():
    return dict(ACCURACIES)[getcontext().prec]


def last():
    return getcontext().prec == ACCURACIES[-1][0]


def sign(value):
    """Of a number that roots and quotients have made inexact."""
    if abs(value) > tiny():
        return 1 if value > 0 else -1
    if not last():
        raise Undecided
    return 0


def exact_sign(compute):
    """Of a sum of products of coordinates, which 60 digits hold without rounding."""
    with localcontext() as context:
        context.traps[Inexact] = True
        value = compute()
    return (value > 0) - (value < 0)


def latch(value):
    """To the nanometre, half away from zero."""
    rounded = value.quantize(NANOMETRE, ROUND_HALF_UP)
    if NANOMETRE / 2 - abs(value - rounded) > tiny():
        return rounded
    if not last():
        raise Undecided
    return value.quantize(tiny()).quantize(NANOMETRE, ROUND_HALF_UP)


def add(a, b, factor=1):
    return (a[0] + factor * b[0], a[1] + factor * b[1])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1])


def scaled(a, factor):
    return (a[0] * factor, a[1] * factor)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def left(a):
    return (-a[1], a[0])


def length(a):
    return dot(a, a).sqrt()


def unit(a):
    return (a[0] / length(a), a[1] / length(a))


def latched_length(a):
    """To the nanometre, half up, of a vector between coordinates: decided on squares, which are exact."""
    square = dot(a, a)
    rounded, half = square.sqrt().quantize(NANOMETRE), NANOMETRE / 2
    if exact_sign(lambda: square - (rounded + half) * (rounded + half)) >= 0:
        return rounded + NANOMETRE
    below = rounded > 0 and exact_sign(lambda: square - (rounded - half) * (rounded - half)) < 0
    return rounded - NANOMETRE if below else rounded

"""Exact numbers of thread cutting: fractions, rounded where the rules say so, half away from zero.

Roots are rounded by whole-number roots of their squares. The tangent of an angle in degrees is 0 or a whole number
at multiples of 45 degrees and irrational at all other rational angles (Niven), so that enough digits always tell on
which side of the middle a product with it lies.
"""
from fractions import Fraction as Q
from functools import lru_cache
from math import factorial, isqrt

#: In mm; of leads in mm per revolution; in degrees.
NANOMETRE, PICOMETRE, MICRO_DEGREE = Q(1, 10**6), Q(1, 10**9), Q(1, 10**6)
#: Digits of the tangent at the first attempt.
DIGITS = 40


def rounded(value, unit):
    count = abs(value) / unit
    return (1 if value > 0 else -1) * unit * ((2 * count + 1) // 2)


def latch(value):
    return rounded(value, NANOMETRE)


def rounded_root(square, unit):
    return unit * ((isqrt(4 * square // unit**2) + 1) // 2)


def sign(value):
    return (value > 0) - (value < 0)


def roots_below(a, b, bound):
    """Whether the roots of two numbers together are less than a bound."""
    rest = bound**2 - a - b
    return bound > 0 and rest > 0 and 4 * a * b < rest**2


def rounded_mean_of_roots(a, b, unit):
    """Half the sum of the roots of two numbers, rounded."""
    count = (isqrt(a // unit**2) + isqrt(b // unit**2)) // 2
    while not roots_below(a, b, (2 * count + 1) * unit):
        count += 1
    return count * unit


def rounded_product_with_tangent(value, angle, unit):
    """`value` times the tangent of an angle in degrees that is no odd multiple of 90."""
    if angle % 45 == 0:
        return rounded(value * (-1 if angle % 180 == 135 else angle % 180 // 45), unit)
    digits = DIGITS
    while True:
        low, high = (rounded(value * bound, unit) for bound in tangent(angle, digits))
        if low == high:
            return low
        digits *= 2


@lru_cache
def tangent(angle, digits):
    """Two bounds of the tangent of an angle that is no multiple of 45 degrees."""
    angle = (angle + 90) % 180 - 90
    if angle < 0:
        low, high = tangent(-angle, digits)
        return -high, -low
    if angle > 45:
        low, high = tangent(90 - angle, digits)
        return 1 / high, 1 / low
    x, error = angle * pi(digits) / 180, Q(1, 10**digits)
    sine, cosine = (series(x, first, digits) for first in (1, 0))
    return (sine - 4 * error) / (cosine + 4 * error), (sine + 4 * error) / (cosine - 4 * error)


def series(x, first, digits):
    """The sine (`first` 1) or cosine (0) of 0 < x < 1, wrong by less than twice the last digit."""
    total, unit = Q(0), Q(1, 10**(digits + 5))
    for n in range(first, digits + 10, 2):
        total += rounded((-1)**(n // 2) * x**n / factorial(n), unit)
    return total


@lru_cache
def pi(digits):
    """By Machin's formula, wrong by less than the last digit."""
    def arctangent_of_inverse(n):
        terms = (Q((-1)**k, (2 * k + 1) * n**(2 * k + 1)) for k in range(digits + 5))
        return sum(rounded(term, Q(1, 10**(digits + 5))) for term in terms)
    return 16 * arctangent_of_inverse(5) - 4 * arctangent_of_inverse(239)

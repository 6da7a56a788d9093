"""How deep the passes of G71 and G72 go: TINF-02 to TINF-07, and the finishing pass.

D is the first step, H the height, T = H less the finishing allowance; all depths are counted from the stock.
"""
from fractions import Fraction as Q
from math import ceil
from typing import NamedTuple

from exact import NANOMETRE, latch, rounded_mean_of_roots, rounded_root, roots_below


class Depth(NamedTuple):
    value: Q            # latched
    rules: tuple        # why it is as deep as that; none of the finishing pass


class Refused(Exception):
    """The manual gives no formula; the rule that says so."""


def depths(pattern, by_turns, d, h, t, m75_pattern, equal_area):
    """All depths of a cycle. `by_turns`: M33 is in force; `equal_area`: the reading `balanced_infeed`."""
    values, rule = roughing(pattern, by_turns, d, h, t, m75_pattern, equal_area)
    rough = [Depth(value, ("TINF-01", rule)) for value in values]
    return rough + ([Depth(h, ())] if t < h else [])


def roughing(pattern, by_turns, d, h, t, m75_pattern, equal_area):
    """The depths up to T, and their rule."""
    if pattern == "M73":
        return halving(d, t), "TINF-02"
    if pattern == "M74":
        return steps(d, t), "TINF-03"
    if m75_pattern == 3 and d**2 >= h**2 - t**2:
        return (two_flanks(d, t), "TINF-05") if by_turns else (one_flank(d, t), "TINF-04")
    rule = "TINF-06" if m75_pattern == 3 else "TINF-07"
    if not equal_area:
        raise Refused(rule)
    area = h**2 - t**2 if m75_pattern == 3 else max(d**2, h**2 - t**2)
    return equal_areas(d, t, area, by_turns), rule


def halving(d, t):
    """M73: steps of D up to T - D, then the rest by halves."""
    whole = [n * d for n in range(1, (t - d) // d + 1)]
    if t > d and (not whole or whole[-1] < t - d):
        whole.append(t - d)
    return [latch(value) for value in whole + [t - d / 2, t - d / 4, t - d / 8, t]]


def steps(d, t):
    """M74."""
    return [n * d for n in range(1, ceil(t / d))] + [t]


def one_flank(d, t):
    """M75 along one flank: the root of n times D."""
    values, n = [], 1
    while n * d**2 < t**2:
        values.append(rounded_root(n * d**2, NANOMETRE))
        n += 1
    return values + [t]


def two_flanks(d, t):
    """M75 by turns: an odd pass is the mean of its neighbours."""
    values, n = [], 1
    while True:
        below, above = ((n - 1) * d**2, (n + 1) * d**2) if n % 2 else (n * d**2, n * d**2)
        if not roots_below(below, above, 2 * t):
            return values + [t]
        values.append(rounded_mean_of_roots(below, above, NANOMETRE))
        n += 1


def equal_areas(d, t, area, by_turns):
    """The sequence that the reading `equal_area` cuts."""
    last = 1 + ceil((t**2 - d**2) / area) if d < t else 1

    def square(n):
        if n in (0, last):
            return t**2 if n else Q(0)
        return d**2 + (n - 1) * (t**2 - d**2) / (last - 1)

    def depth(n):
        below, above = (n - 1, n + 1) if by_turns and n % 2 else (n, n)
        return rounded_mean_of_roots(square(below), square(above), NANOMETRE)

    return [depth(n) for n in range(1, last)] + [t]

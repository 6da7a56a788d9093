"""One pass of G31, G32, G33, G71 or G72: where it goes (section 5 of "How thread cutting runs").

Points of a pass are (lead coordinate, level coordinate): Z and X when the lead is along Z, X and Z when it is along
X. All numbers are fractions; X is a diameter.
"""
from fractions import Fraction as Q
from typing import NamedTuple

from exact import PICOMETRE, latch, rounded_product_with_tangent, rounded_root, sign, NANOMETRE
from events import Alarm

#: Least and greatest lead, in mm per revolution.
LEADS = (Q(1, 1000), Q(1000))


class Machine(NamedTuple):
    """What set-up and modes say about every pass."""
    k: Q                # what a difference of 1 along X counts
    withdrawal: Q       # mm/min
    from_start: bool    # the reading `taper_reference`
    toward_end: bool    # the reading `thread_shift`
    chamfer: bool       # M23
    speed: Q            # of the spindle, in rpm; 0 while it does not turn


class Pass(NamedTuple):
    place: tuple
    axis: str           # of the lead: x or z
    start: tuple        # the cycle start
    end: Q              # of the lead coordinate
    level: Q
    side: int
    taper: tuple        # ("amount", difference of levels) or ("angle", degrees)
    shift: Q
    flank: Q
    lead: Q
    change: Q
    chamfer: Q          # L; None without


class Step(NamedTuple):
    part: str
    kind: str
    end: tuple
    lead: Q = None
    rules: tuple = ()


def count(axis, letter, machine):
    """What a difference of 1 counts along the lead axis or the other one (`letter`: x if that axis is X)."""
    return machine.k if axis == letter else Q(1)


def lead_at(lead, change, distance):
    return rounded_root(lead**2 + 2 * change * distance, PICOMETRE) if change else lead


def check_lead_at_end(lead, change, distance, place):
    if change and not LEADS[0]**2 <= lead**2 + 2 * change * distance <= LEADS[1]**2:
        raise Alarm("thread_lead_range", "G33-09", place)


def steps_of(given, machine):
    """The motions of a pass, those without travel included, and the rules of what all but the return have in
    common."""
    def undefined(detail, rule="G33-04"):
        return Alarm("unspecified", rule, given.place, detail)

    along = count(given.axis, "x", machine)
    (s, ys), t = given.start, given.end
    way = sign(t - s)
    b = s + (way * given.shift if machine.toward_end else given.shift)
    if way == 0 or way * (t - b) <= 0:
        raise undefined("length")
    taper = taper_of(given, t - b)
    first, last = (given.level, given.level + taper) if machine.from_start else (given.level - taper, given.level)
    if min(given.side * (ys - level) for level in (first, last)) <= 0 or given.side == 0:
        raise undefined("side")
    distance = abs(t - b) * along
    check_lead_at_end(given.lead, given.change, distance, given.place)
    rules = ["G33-05" if given.taper[0] == "amount" else "G33-06"] if taper else []
    rules += ["G33-07"] if given.shift else []
    run_out = (given.lead if given.chamfer is None else given.chamfer) if machine.chamfer else 0
    if run_out > distance:
        raise undefined("chamfer", "TCHM-02")
    if run_out and not machine.speed:
        raise undefined("speed", "TCHM-03")
    b, t = b + given.flank, t + given.flank
    cut, exits = (t, last), []
    if run_out:
        c = latch(t - way * run_out / along)
        cut = (c, latch(first + taper * abs(c - b) / abs(t - b)))
        exits = exits_of(given, machine, (b, t, last), cut)
    end = exits[-1].end if exits else cut
    return [Step("approach", "rapid", (b, first)), Step("cut", "thread", cut, given.lead), *exits,
            Step("retract", "linear", (end[0], ys), rules=("TCHM-03",)), Step("return", "rapid", (s, ys))], rules


def taper_of(given, length):
    """The level at the end less the level at the start."""
    how, value = given.taper
    if how == "amount":
        return value
    if value % 180 == (90 if given.axis == "z" else 0):
        raise Alarm("angle_no_intersection", "G33-06", given.place)
    if given.axis == "z":
        return rounded_product_with_tangent(2 * length, value, NANOMETRE)
    # 1/tan(a) is tan(90 - a).
    return rounded_product_with_tangent(length / 2, 90 - value, NANOMETRE)


def exits_of(given, machine, thread, cut):
    """TCHM-04. `thread`: start and end of the lead coordinate, and the level at the end."""
    (b, t, last), (c, yc), ys = thread, cut, given.start[1]
    along = count(given.axis, "x", machine)
    lead = lead_at(given.lead, given.change, abs(c - b) * along)
    withdrawn = machine.withdrawal * abs(t - c) * along / (machine.speed * lead)
    rise = withdrawn / count(given.axis, "z", machine)
    level = yc + given.side * rise
    rules = ("TCHM-01", "TCHM-02", "TCHM-03", "TCHM-04")
    if given.side * (ys - level) > 0:
        if given.side * (level - last) < 0:
            raise Alarm("unspecified", "TCHM-04", given.place, "taper")
        return [Step("exit", "thread", (t, latch(level)), lead, rules)]
    reached = latch(c + (t - c) * given.side * (ys - yc) / rise)
    second = lead_at(given.lead, given.change, abs(reached - b) * along)
    return [Step("exit", "thread", (reached, ys), lead, rules), Step("exit", "thread", (t, ys), second, rules)]

"""Bar turning, mode I: what is tested before the first pass, and its passes ("How LAP runs", sections 7 and 9)."""
from fractions import Fraction as Q

from events import Alarm, Event
from exact import NANOMETRE, latch, rounded_root, sign
from lap_contour import Contour, Element, as_root
from machining import number

LIFT = Q(1, 5)
EVERY = ["LAP-01", "LAP-09", "LAP-18", "LAPC-01", "AP1-01"]


class Plane:
    """The axes of a contour: indices of infeed and cutting axis in (x, z), and their senses."""

    def __init__(self, transverse, sigma, gamma):
        self.infeed, self.cutting = (1, 0) if transverse else (0, 1)
        self.transverse = transverse
        self.factors = (Q(gamma, 2), Q(sigma)) if transverse else (Q(sigma, 2), Q(gamma))
        self.sigma, self.gamma = sigma, gamma

    def height(self, coordinate):
        return coordinate * self.factors[self.infeed]

    def point(self, xz):
        """(run, height) of a point in program coordinates."""
        return (xz[self.cutting] * self.factors[self.cutting], self.height(xz[self.infeed]))

    def coordinate(self, axis, value):
        """The latched program coordinate of a run or a height."""
        return as_root(value).times(1 / self.factors[axis]).latch()

    def element(self, start, motion, shift):
        """Of a recorded motion, moved by the allowances."""
        points = [self.point(moved(point, shift)) for point in (start, motion.end)]
        if motion.centre is None:
            return Element(*points, feed=motion.feed)
        same = self.gamma * self.sigma == (-1 if self.transverse else 1)
        return Element(*points, self.point(moved(motion.centre, shift)), (motion.sense == "cw") == same, motion.feed)


def moved(point, shift):
    return (point[0] + shift[0], point[1] + shift[1])


class Cycle:
    """A call that has read its contour: `motions` are those recorded, `words` those of the call."""

    def __init__(self, call, transverse, motions, present, setup, feed, kept):
        self.call, self.words, self.setup = call, call.words, setup
        self.feed, self.kept = feed, kept
        self.start, self.motions = present, motions
        self.trace, self.passes, self.others = [], 0, []
        self.plane = self.tested_plane(transverse)
        self.contour = self.tested_contour()
        self.rules = EVERY + (["AP1-14"] if transverse else []) + (["LAP-21"] if any(self.shift) else [])

    def refuse(self, condition, name, rule, detail=None):
        if condition:
            raise Alarm(name, rule, self.call.place, detail)

    def tested_plane(self, transverse):
        start, first, last = self.start, self.motions[0].end, self.motions[-1].end
        i, k = (1, 0) if transverse else (0, 1)
        wrong = ("XA", "XB") if transverse else ("ZA", "ZB")
        found = next((letter for letter in self.words if letter in wrong), None)
        self.refuse(found, "word_without_function", "LAPC-02", found)
        sigma = sign(start[i] - first[i])
        self.refuse(not sigma, "lap_start_point", "LAP-20", "XZ"[i])
        gamma = sign(last[k] - first[k])
        self.refuse(not gamma, "unspecified", "LAP-20", "direction")
        self.refuse(gamma * (first[k] - start[k]) < 0, "lap_start_point", "LAP-20", "XZ"[k])
        allowance = self.words.get("UW"[i], Q(0))
        self.refuse(sigma * (start[i] - first[i]) <= allowance, "lap_allowance", "LAP-20", "UW"[i])
        above = start[i]
        for letter in ("ZA", "ZB") if transverse else ("XA", "XB"):
            if letter in self.words:
                self.refuse(sigma * (above - self.words[letter]) <= 0, "lap_data", "LAPC-04", letter)
                above = self.words[letter]
        return Plane(transverse, sigma, gamma)

    def tested_contour(self):
        plane, shift = self.plane, [Q(0), Q(0)]
        for axis, letter in enumerate("UW"):
            amount = self.words.get(letter, Q(0))
            shift[axis] = amount * (plane.sigma if axis == plane.infeed else -plane.gamma)
        self.shift = shift
        starts = [motion.end for motion in self.motions]
        contour = Contour([plane.element(start, motion, shift) for start, motion in zip(starts, self.motions[1:])])
        self.refuse(contour.goes_back(), "unspecified", "AP1-02", "direction")
        self.refuse(contour.descents() > 10, "descending_slopes", "AP1-13")
        return contour

    def data(self, level):
        """Depth and feed below a level, and whether they are others than D and F."""
        depth, feed = self.words["D"], self.feed
        for letter in "AB":
            changed = self.words.get("XZ"[self.plane.infeed] + letter)
            if changed is not None and self.plane.sigma * (level - changed) <= 0:
                depth, feed = self.words.get("D" + letter, depth), self.words.get("F" + letter, feed)
        return depth, feed, (depth, feed) != (self.words["D"], self.feed)

    def run(self):
        """The events of the cycle, and where the tool is then."""
        first = self.contour.start()
        upper, self.at = self.start[self.plane.infeed], self.start
        while True:
            depth, feed, other = self.data(upper)
            level = upper - self.plane.sigma * depth
            last = self.plane.height(level) <= first.height
            Pass(self, upper, level, feed, other, last).run()
            if last:
                break
            upper = level
        self.go_home()
        return self.trace, self.at

    def count_pass(self, other):
        """A pass begins; `other`: with another depth or feed than D and F."""
        self.passes += 1
        self.others = ["LAPC-02", "LAPC-03"] if other else []

    def go_home(self):
        if "M85" in self.call.m:
            return
        rules, axes = ["AP1-09", "LAP-06"], [(0, 1)]
        if self.motions[0].code == "G01":
            axes = [(self.plane.infeed,), (self.plane.cutting,)]
        for moving in axes:
            to = [self.start[axis] if axis in moving else self.at[axis] for axis in (0, 1)]
            self.emit("rapid", to, "home", None, rules)

    def emit(self, kind, to, part, number_of_pass, rules, feed=None, element=None):
        to = tuple(to)
        if to == self.at:
            return
        fields = {"x": number(to[0]), "z": number(to[1])}
        if kind == "arc":
            centre = [element.centre[0] / self.plane.factors[self.plane.cutting],
                      element.centre[1] / self.plane.factors[self.plane.infeed]]
            centre = centre if self.plane.transverse else centre[::-1]
            same = self.plane.gamma * self.plane.sigma == (-1 if self.plane.transverse else 1)
            fields |= {"sense": "cw" if element.clockwise == same else "ccw"}
            fields |= {"cx": number(centre[0]), "cz": number(centre[1])}
        if kind != "rapid":
            fields["f"] = number(feed) + "mm/rev"
        if kind == "linear":
            dx, dz = (to[0] - self.at[0]) / 2, to[1] - self.at[1]
            fields["path"] = number(rounded_root(dx * dx + dz * dz, NANOMETRE))
        fields |= ({"pass": str(number_of_pass)} if number_of_pass else {}) | {"part": part}
        self.trace.append(Event(kind, fields, self.rules + rules, self.call.place))
        self.at = to


class Pass:
    """A pass with its upper level and its level, coordinates of the infeed axis; of a recess when it has no infeed."""

    def __init__(self, cycle, upper, level, feed, other, last=False, recess=False):
        self.cycle, self.plane, self.contour = cycle, cycle.plane, cycle.contour
        self.upper, self.level, self.feed = upper, level, feed
        self.last, self.recess, self.recesses = last, recess, []
        self.other = other
        self.height, self.upper_height = self.plane.height(level), self.plane.height(upper)
        self.top, self.ended = None, None   # greatest height of the path; height where it ended at the end of the contour

    def emit(self, kind, to, part, rules, feed=None, element=None):
        self.cycle.emit(kind, to, part, self.cycle.passes, self.cycle.others + rules, feed, element)

    def run(self):
        self.cycle.count_pass(self.other)
        begin = self.contour.start()
        if self.last:
            infeed = self.program(begin)
        else:
            infeed = self.with_infeed(self.infeed_point())
        kind = "linear" if self.cycle.motions[0].code == "G01" else "rapid"
        self.emit(kind, infeed, "infeed", ["LAP-05", "AP1-02", "AP1-03"] + (["AP1-08"] if self.last else []), self.feed)
        if self.last:
            self.follow(begin)
        else:
            self.rise(self.height)
            self.cut_to(self.contour.up(begin, self.height), "AP1-04")
        self.relieve()
        self.lift_over_path()
        self.finish_recesses()
        if self.recesses:
            self.lift()
        if not self.last:
            for axis in (self.plane.cutting, self.plane.infeed):
                self.go(axis, infeed[axis], "return", ["AP1-07"])

    def infeed_point(self):
        """On the line from S to the start of the rough contour, at the level: the coordinate of the cutting axis."""
        start, begin = self.cycle.start, self.program(self.contour.start())
        i, k = self.plane.infeed, self.plane.cutting
        return latch(start[k] + (begin[k] - start[k]) * (self.level - start[i]) / (begin[i] - start[i]))

    def with_infeed(self, cutting):
        return self.pair(self.level, cutting)

    def pair(self, infeed, cutting):
        return (cutting, infeed) if self.plane.transverse else (infeed, cutting)

    def program(self, point):
        """The latched program coordinates of a point of the contour."""
        return self.pair(self.plane.coordinate(self.plane.infeed, point.height),
                         self.plane.coordinate(self.plane.cutting, point.run))

    def rise(self, height):
        height = as_root(height)
        self.top = height if self.top is None else max(self.top, height)

    def cut_to(self, met, rule):
        """Along the level to the point in which it meets the contour, and along that from there; without one to the
        end of the contour."""
        end = met or self.contour.end()
        self.emit("linear", self.with_infeed(self.plane.coordinate(self.plane.cutting, end.run)), "cut",
                  ["AP1-11" if self.recess else rule], self.feed)
        if met:
            self.follow(met)
        else:
            self.ended = as_root(self.height)

    def follow(self, point):
        """The run along the contour; over a recess it goes on behind it."""
        self.rise(point.height)
        high = self.contour.above(point, self.upper_height)
        fallen = self.contour.down(point, self.height)
        if fallen and not (high and self.contour.at_or_behind(high, fallen)):
            self.contour_to(point, fallen, "AP1-10")
            self.recesses.append(fallen)
            self.cut_to(self.contour.behind(fallen, self.height), "AP1-10")
            return
        self.contour_to(point, high or self.contour.end())
        if not high:
            self.ended = as_root(self.contour.end().height)

    def contour_to(self, point, to, last_rule=None):
        self.rise(self.contour.highest(point, to))
        parts = self.contour.along(point, to)
        for index, (element_index, end) in enumerate(parts):
            element = self.contour.elements[element_index]
            rule = "AP1-08" if self.last else "AP1-05"
            if last_rule and index == len(parts) - 1:
                rule = last_rule
            rules = ["AP1-11" if self.recess else rule, "LAP-08" if element.feed is None else "LAP-07"]
            to_program = self.pair(self.plane.coordinate(self.plane.infeed, end[1]),
                                   self.plane.coordinate(self.plane.cutting, end[0]))
            feed = element.feed or (self.feed if self.cycle.setup.by_call else self.cycle.kept or self.feed)
            self.emit("arc" if element.centre else "linear", to_program, "contour", rules, feed, element)

    def relieve(self):
        relief = self.cycle.setup.relief
        double = self.recess and not self.recesses
        amounts = [relief, relief]
        if double:
            amounts[0] = 2 * relief
        to = list(self.cycle.at)
        to[self.plane.infeed] += self.plane.sigma * amounts[self.plane.infeed]
        to[self.plane.cutting] -= self.plane.gamma * amounts[self.plane.cutting]
        self.emit("rapid", to, "relief", ["AP1-06"] + (["AP1-11"] if self.recess else []) + (["AP1-12"] if double else []))

    def lift_over_path(self):
        """When the pass has ended, at the end of the contour, below its highest point."""
        if self.ended is not None and self.ended < self.top:
            top = self.top.times(1 / self.plane.factors[self.plane.infeed]).plus(self.plane.sigma * LIFT).latch()
            self.raise_to(top, ["AP1-06"])

    def lift(self):
        self.raise_to(self.upper + self.plane.sigma * LIFT, ["AP1-12"])

    def raise_to(self, coordinate, rules):
        if self.plane.sigma * (coordinate - self.cycle.at[self.plane.infeed]) > 0:
            self.go(self.plane.infeed, coordinate, "clear", rules)

    def go(self, axis, coordinate, part, rules):
        to = list(self.cycle.at)
        to[axis] = coordinate
        self.emit("rapid", to, part, rules)

    def finish_recesses(self):
        for index, recess in enumerate(self.recesses):
            if index:
                self.lift()
            self.go(self.plane.cutting, self.plane.coordinate(self.plane.cutting, recess.run), "return", ["AP1-11"])
            self.go(self.plane.infeed, self.level, "return", ["AP1-11"])
            depth, feed, other = self.cycle.data(self.level)
            deeper = Pass(self.cycle, self.level, self.level - self.plane.sigma * depth, feed, other, recess=True)
            self.cycle.count_pass(other)
            deeper.follow(recess)
            deeper.relieve()
            deeper.lift_over_path()
            deeper.finish_recesses()

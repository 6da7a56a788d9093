"""The run of a program with LAP: blocks in their order, definitions that are passed over, calls that read one."""
from fractions import Fraction as Q
from typing import NamedTuple

from events import Alarm, Event, Unsupported
from exact import NANOMETRE, rounded_root
from lap_cycle import Cycle
from lap_words import DEFINITIONS, DIMENSIONS, MOTIONS, read
from machining import number
from thread_setup import pair_of

TOLERANCE = Q("0.02")


class Setup:
    def __init__(self, table):
        parameters, readings = dict(table.get("parameters", {})), dict(table.get("readings", {}))
        self.relief = Q(parameters.pop("lap_relief", 100), 1000)
        self.by_call = readings.pop("contour_feed", "kept") == "call"
        self.start = pair_of(table.get("start", {}))
        if parameters or readings or not set(table) <= {"control", "parameters", "readings", "start"}:
            raise Unsupported("set-up")
        if not set(table.get("start", {})) <= {"x", "z"}:
            raise Unsupported("start")


class Recorded(NamedTuple):
    """A motion of a definition; the centre as (x, z), X a diameter."""
    code: str
    end: tuple
    centre: tuple = None
    sense: str = None
    feed: Q = None


class State(NamedTuple):
    """Motion and dimension mode, and the present point (x, z)."""
    motion: str
    dimension: str
    at: tuple

    def of(self, block):
        """The state with the modes that a block selects, and with its target."""
        motion = next((g for g in block.g if g in MOTIONS), self.motion)
        dimension = next((g for g in block.g if g in DIMENSIONS), self.dimension)
        base = self.at if dimension == "G91" else (0, 0)
        to = tuple(base[axis] + block.words[letter] if letter in block.words else self.at[axis]
                   for axis, letter in enumerate("XZ"))
        return State(motion, dimension, to)


class Run:
    def __init__(self, program, table):
        self.setup = Setup(table)
        self.blocks = [read(number, line) for number, line in enumerate(program.removesuffix("\n").split("\n"), 1)]
        self.state = State("G00", "G90", self.setup.start)
        self.trace, self.feed, self.kept = [], None, None

    def run(self):
        index = 0
        while index < len(self.blocks):
            block = self.blocks[index]
            index += 1
            if block is None:
                continue
            if block.call:
                self.call(block)
            elif set(block.g) & set(DEFINITIONS):
                block.allow(DEFINITIONS, "")
                index = self.behind_definition(index)
            elif "M02" in block.m:
                block.allow((), "", ("M02",))
                if self.state.motion != "G00":
                    self.mode(block.place, "motion", "G00", self.state.motion)
                self.trace.append(Event("end", {"code": "M02"}, [], block.place))
                return
            else:
                self.move(block)
        raise Unsupported("no M02")

    def behind_definition(self, index):
        for end in range(index, len(self.blocks)):
            if self.blocks[end] and "G80" in self.blocks[end].g:
                return end + 1
        raise Unsupported("no G80")

    def move(self, block):
        """A block of G00 or G01."""
        block.allow(("G00", "G01"), "XZF")
        before, self.state = self.state, self.state.of(block)
        if before.motion != self.state.motion:
            self.mode(block.place, "motion", self.state.motion, before.motion)
        self.feed = block.words.get("F", self.feed)
        if not block.has("XZ"):
            return
        x, z = self.state.at
        fields = {"x": number(x), "z": number(z)}
        if self.state.motion == "G01":
            dx, dz = (x - before.at[0]) / 2, z - before.at[1]
            if self.feed is None:
                raise Alarm("no_feed", "G01-03", block.place)
            fields |= {"f": number(self.feed) + "mm/rev", "path": number(rounded_root(dx * dx + dz * dz, NANOMETRE))}
        self.trace.append(Event("linear" if self.state.motion == "G01" else "rapid", fields, [], block.place))

    def mode(self, place, group, code, previous):
        self.trace.append(Event("mode", {"group": group, "code": code, "previous": previous}, [], place))

    def call(self, block):
        block.allow(("G85", "G84"), ("D", "F", "U", "W", "XA", "XB", "ZA", "ZB", "DA", "DB", "FA", "FB"), ("M85",))
        changes = block.has(("XA", "XB", "ZA", "ZB", "DA", "DB", "FA", "FB"))
        if changes != ("G84" in block.g) or not block.words.get("D") or "G85" not in block.g:
            raise Unsupported("words of a call")
        for side in "AB":
            named = block.has(("X" + side, "Z" + side))
            if block.has(("D" + side, "F" + side)) and not named or block.words.get("D" + side) == 0:
                raise Unsupported("words of a call")
        if changes and not block.has(("XA", "XB", "ZA", "ZB")):
            raise Unsupported("words of a call")
        self.feed = block.words.get("F", self.feed)
        if "M85" in block.m:
            self.trace.append(Event("aux", {"code": "M85"}, ["LAPC-08"], block.place))
        kept = self.kept
        transverse, motions = self.read_definition(block)
        cycle = Cycle(block, transverse, motions, self.state.at, self.setup, self.feed, kept)
        if self.feed is None:
            raise Unsupported("no feed")
        events, at = cycle.run()
        self.trace += events
        self.state = self.state._replace(at=at)

    def read_definition(self, call):
        """Whether the contour is transverse, and its motions."""
        names = [index for index, block in enumerate(self.blocks) if block and block.place[1] == call.call]
        if len(names) != 1 or len(self.blocks[names[0]].g) != 1 or self.blocks[names[0]].g[0] not in DEFINITIONS:
            raise Unsupported("the contour that is named")
        state, motions, feed = self.state, [], None
        for block in self.blocks[names[0] + 1:]:
            if block is None:
                continue
            if block.call:
                raise Unsupported("a call in a definition")
            block.allow(MOTIONS + ("G80", "G90"), "XZIKEFS")
            before, state = state, state.of(block)
            feed = block.words.get("E", feed)
            if block.has("XZIK"):
                self.record(motions, block, before, state, feed)
            if "G80" in block.g:
                self.kept = feed or self.kept
                if len(motions) < 2:
                    raise Alarm("contour_malformed", "LAP-01", block.place, "empty")
                return self.blocks[names[0]].g[0] == "G82", motions
        raise Unsupported("no G80")

    def record(self, motions, block, before, state, feed):
        """A motion without travel is none, unless it is the first."""
        if state.motion in ("G02", "G03"):
            if not motions:
                raise Alarm("contour_malformed", "LAP-05", block.place, "first")
            motions.append(arc(block, before.at, state, feed))
            return
        if block.has("IK"):
            raise Unsupported("I and K of a line")
        if state.motion == "G00" and motions:
            raise Alarm("contour_malformed", "LAP-04", block.place, "G00")
        if state.at != before.at or not motions:
            motions.append(Recorded(state.motion, state.at, feed=feed))


def arc(block, start, state, feed):
    """By its centre, I a radius; its end on the circle (CIRC-11)."""
    if not block.has("X") or not block.has("Z") or not block.words.get("I") and not block.words.get("K"):
        raise Unsupported("an arc without end or centre")
    centre = (start[0] + 2 * block.words.get("I", Q(0)), start[1] + block.words.get("K", Q(0)))
    squares = [((x - centre[0]) / 2) ** 2 + (z - centre[1]) ** 2 for x, z in (start, state.at)]
    if squares[0] != squares[1] or state.at == start:
        raise Unsupported("an arc whose ends are not on one circle")
    return Recorded(state.motion, state.at, centre, "cw" if state.motion == "G02" else "ccw", feed)


def trace_of(program, table):
    run = Run(program, table)
    try:
        run.run()
    except Alarm as alarm:
        run.trace.append(alarm.event())
    return run.trace

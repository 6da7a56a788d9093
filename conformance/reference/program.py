"""A part program from its first line to its end, and the motions of its blocks (step 7 of the chapter on execution).

The subset: G00 to G04, G17, G18, G40 to G42, G75 and G76 in the basic form, G90, G91, G94, G95, G119, the words
X Z C I K L F S T and some M codes, in the 1 mm system and G97, without variables and expressions.
"""
from decimal import Decimal as D

from checks import Check
from corner import Element
from events import Alarm, Motion, number
from functions import Functions
from path import diameter, radius
from plane import ZERO, add, with_enough_digits
from setup import Setup
from words import GROUPS, read

SIDES = {"G41": 1, "G42": -1}
UNITS = {"G94": "mm/min", "G95": "mm/rev"}


def trace_of(program, setup):
    """The events of a program with a set-up (a table as in a set-up file); `Unsupported` outside the subset."""
    return with_enough_digits(lambda: Control(Setup(setup)).run(program))


class Control(Functions):
    def __init__(self, setup):
        super().__init__(setup)
        self.c = D(0)           # program coordinate of C, in degrees
        self.left_over = False  # whether compensation has ended without a motion that takes T to P

    def run(self, program):
        line = 0
        try:
            for line, text in enumerate(program.split("\n"), 1):
                block = read(line, text, self.setup.switch("block_delete"))
                if block and self.carry_out(block):
                    return self.waiting.trace
            raise Alarm("no_program_end", "PROG-02", (line, ""))
        except Alarm as alarm:
            self.waiting.drop(alarm)
        return self.waiting.trace

    def carry_out(self, block):
        """A block; whether it ends the program."""
        modes = self.modes | {group: block.selected(group) for group in GROUPS if block.selected(group)}
        self.waiting.holding = self.modes["compensation"] != "G40"
        check = Check(block, self.modes, modes, self.setup)
        check.all(self.joined)
        self.codes_and_words(block)
        self.step_motion(block, check)
        end = next((m for m in block.m if m in ("M02", "M30")), None)
        if end:
            self.finish(block, end)
            return True
        self.stops(block)
        if not check.begins and check.now != "G40" and not block.moves():
            self.waiting.count(self.extra_motion(block))
        self.waiting.holding = False
        if not self.waiting.motion:
            self.waiting.release()
        return False

    def step_motion(self, block, check):
        if block.shot == "G04":
            self.dwell(block)
        elements, rules = self.path.elements(block, self.modes) if block.moves() else ([], [])
        if check.ends:
            self.end_compensation(block, elements, rules)
        elif check.begins:
            self.start_up(block, elements, rules)
        elif block.moves() and check.now == "G40":
            self.uncompensated(block, elements, rules + (["NRC-71"] if self.left_over else []), self.left_over)
        elif block.moves():
            self.compensated(block, elements, rules)
        elif "C" in block.words:
            self.waiting.emit(self.motion_of_c(block))

    def dwell(self, block):
        time = block.words["F"]
        if not D("0.01") <= time <= D("9999.99"):
            raise Alarm("address_range", "DWELL-02", block.place)
        self.emit("dwell", block, {"time": number(time)})

    def start_up(self, block, elements, rules):
        """NRC-14 to NRC-24."""
        here = radius(self.path.present())
        first = elements[0] if elements else Element(self.straight(), here, here)
        motion = self.tested(block, first, "NRC-19")
        motion.rules += rules + ["NRC-14"] + (["NRC-20"] if first.start == first.end else [])
        imaginary = None
        if block.has("IK"):
            direction = (block.words.get("K", D(0)), block.words.get("I", D(0)))
            imaginary = self.compensate(Element("linear", direction, ZERO))
        self.left_over = False
        self.path.move_to(motion.point, motion.frame)
        self.waiting.start_up(motion, imaginary)
        self.compensated(block, elements[1:], rules)

    def compensated(self, block, elements, rules):
        for element in elements:
            motion = self.tested(block, element)
            motion.rules += rules
            self.path.move_to(motion.point, motion.frame)
            if element.start == element.end:
                self.waiting.repetition(motion)
                continue
            motion.rules += {"rapid": ["NRC-41"], "arc": ["NRC-48", "NRC-60"]}.get(element.kind, [])
            self.waiting.element(motion, self.compensate(element))

    def compensate(self, element):
        return element.compensate(SIDES[self.modes["compensation"]], *self.setup.nose(self.nose))

    def end_compensation(self, block, elements, rules):
        motion = None
        if elements:
            self.tested(block, elements[0], "NRC-72")
        elif "C" in block.words:
            motion = self.motion_of_c(block)
        direction = (block.words.get("K", D(0)), block.words.get("I", D(0))) if block.has("IK") else None
        self.waiting.cancel(block.moves(), direction)
        self.left_over = not elements
        if motion:
            self.waiting.emit(motion)
        self.uncompensated(block, elements, rules + ["NRC-66"], True)

    def uncompensated(self, block, elements, rules, both_axes):
        """The tip goes to P; `both_axes`: it comes from where compensation has left it."""
        for element in elements:
            beside = self.waiting.axes != self.path.machine
            motion = self.tested(block, element, beside=self.left_over and beside)
            motion.rules += rules
            self.limit(block, motion, "XZ" if both_axes else element.axes)
            self.path.move_to(motion.point, motion.frame)
            self.waiting.emit(motion)
            if self.left_over:
                self.left_over, rules = False, [rule for rule in rules if rule != "NRC-71"]

    def limit(self, block, motion, letters):
        """LIM-01 and LIM-02."""
        machine = list(add(motion.point, motion.frame))
        for letter, k in (("X", 1), ("Z", 0)):
            if letter not in letters:
                continue
            if self.setup.beyond_negative(letter.lower(), machine[k]):
                raise Alarm("travel_limit_negative", "LIM-02", block.place)
            if self.setup.beyond_positive(letter.lower(), machine[k]):
                if motion.kind == "arc":
                    raise Alarm("travel_limit_positive", "LIM-01", block.place)
                machine[k] = self.setup.limit(letter.lower(), "positive")
        motion.point = (machine[0] - motion.frame[0], machine[1] - motion.frame[1])

    def tested(self, block, element, not_linear=None, beside=False):
        """The motion of an element after its own tests. `not_linear`: the rule that forbids an arc here; `beside`:
        the tip is not on P, so that an arc cannot begin."""
        point = diameter(element.end)
        self.path.in_range(block, point, element.axes)
        if element.centre and not_linear:
            raise Alarm("compensation_not_linear", not_linear, block.place)
        if element.centre and beside:
            raise Alarm("unspecified", "NRC-71", block.place, "arc")
        motion = self.motion(element.kind, point, block)
        if "C" in block.words:
            self.turn(block, motion)
        if element.kind != "rapid" and self.feed is None:
            raise Alarm("no_feed", "G01-03", block.place)
        if element.centre:
            z, x = diameter(element.centre)
            motion.fields |= {"sense": "ccw" if element.sigma > 0 else "cw", "cx": number(x), "cz": number(z)}
        return motion

    def motion(self, kind, point, block, moves=True):
        v, compensated = self.setup.nose(self.nose)[1], self.modes["compensation"] != "G40"
        motion = Motion(kind, point, block.place, self.path.frame(), self.setup, v, compensated, moves)
        if kind != "rapid" and self.feed is not None:
            motion.fields["f"] = number(self.feed) + UNITS[self.modes["feed_unit"]]
        return motion

    def straight(self):
        return "rapid" if self.modes["motion"] == "G00" else "linear"

    def extra_motion(self, block):
        return self.motion(self.straight(), self.path.present(), block)

    def motion_of_c(self, block):
        motion = self.motion(self.straight(), self.path.present(), block, moves=False)
        self.turn(block, motion)
        if motion.kind == "linear" and self.feed is None:
            raise Alarm("no_feed", "G01-03", block.place)
        return motion

    def turn(self, block, motion):
        if not self.joined:
            raise Alarm("c_axis_not_joined", "CAX-02", block.place)
        base = self.c if self.modes["dimension"] == "G91" else 0
        self.c = (base + block.words["C"] + 360) % 360
        motion.fields["c"] = number(self.c)

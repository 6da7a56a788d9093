#!/usr/bin/env python3
"""A small control that is right about what it knows, to be read before you write a bigger one.

It reads one case from standard input and writes the trace to standard output, as `../PROTOCOL.md` says. It
knows positioning, lines and arcs, G90 and G91, G94 and G95, dwell, the main spindle in G97 and its clamp, coolant,
stop and end, on a machine in millimetres. Whatever else a program asks for makes it leave with status 3: it never
guesses. What it has is declared in `right.toml`.

It was written from the rule texts in `spec/rules/e100l/` alone. The ids beside the code (E100L- left out) are
the headings there; `execution.md` among them gives the order in which everything happens. Numbers are exact
fractions, X is a diameter wherever it is not said to be a radius.

From top to bottom: a case is run, a block is read, checked, carried out; then arcs, and exact numbers.
"""

import json
import re
import sys
from fractions import Fraction
from math import isqrt

END, ALARM, UNSUPPORTED = 0, 1, 3


class Unsupported(Exception):
    """The program needs something that this control does not have."""


class Alarm(Exception):
    """The control refuses to go on. The rule is for the reader, the name and the detail are for the trace."""

    def __init__(self, name, rule, detail=None):
        super().__init__(f"{name} ({rule})")
        self.name, self.detail = name, detail


def main(control=None):
    """Runs the case on standard input with this control, or with one that behaves otherwise."""
    case = json.load(sys.stdin)
    control = (control or Control)(case["setup"])
    sys.exit(control.run(case["program"]))


# The set-up. Decimal text or a JSON number, both exact: str() of a number is the text that it was read from.

def number(value):
    return Fraction(str(value))


def demand_known_machine(setup):
    """Leaves what would change the meaning of our words; the rest of a set-up cannot be noticed here."""
    if setup["control"] != "e100l" or setup["unit_system"] != "1mm" or setup["tape"]["code"] != "ascii":
        raise Unsupported("another control, unit system or tape code")
    if any(setup["limits"].get(axis) for axis in "xz"):
        raise Unsupported("travel limits")
    if setup["options"]["w_axis"]:
        raise Unsupported("a W axis")


# The words that are known, and the groups of codes (GTAB-01, MTAB-01).

ADDRESSES = set("GMXZIKLFS")
COORDINATE_LIMIT = Fraction("99999.999")
G_GROUPS = {
    0: "motion", 1: "motion", 2: "motion", 3: "motion", 4: "one-shot", 50: "one-shot", 64: "droop", 65: "droop",
    90: "dimension", 91: "dimension", 94: "feed_unit", 95: "feed_unit", 97: "cutting_speed",
}
M_GROUPS = {
    0: "program", 1: "program", 2: "program", 30: "program",
    3: "spindle", 4: "spindle", 5: "spindle", 19: "spindle", 8: "coolant", 9: "coolant",
}
SPINDLE_STATES = {3: "clockwise", 4: "counter_clockwise", 5: "stop", 19: "orient"}
POWER_ON = {"motion": 0, "dimension": 90, "feed_unit": 95, "droop": 64}     # in the order of the reset


class Control:
    """The state of the control, and what it does with a program."""

    def __init__(self, setup):
        self.setup = setup
        self.modes = dict(POWER_ON)
        self.feed = None                # (number as written, code of the feed mode it was written in)
        self.speed = 0                  # S, rpm; SPD-04: 0 after power-on
        self.clamp = None               # S of G50, rpm
        self.spindle = "stop"
        self.names = set()              # sequence names met so far
        self.place = {"line": 1}        # line and sequence name of the present block

    # A program is run block by block (PROG-02): read, check, carry out.

    def run(self, program):
        """Runs a program; the exit status."""
        try:
            demand_known_machine(self.setup)
            self.offset = {axis: number(self.setup["zero_offset"][axis]) for axis in "xz"}
            # The machine stands still when a frame changes: its position is the state (COORD-03).
            self.position = {axis: number(self.setup["start"][axis]) - self.offset[axis] for axis in "xz"}
            for line, text, is_continued in lines_of(program):
                self.place = {"line": line}
                if is_continued:
                    raise Unsupported("a file header, or a block of several lines")
                if self.block(text):
                    return END
            self.place = {"line": program.count("\n") + 1}
            raise Alarm("no_program_end", "PROG-02")
        except Alarm as alarm:
            self.emit("alarm", name=alarm.name, **({"detail": alarm.detail} if alarm.detail else {}))
            return ALARM
        except Unsupported as reason:
            print(f"line {self.place['line']}: {reason}", file=sys.stderr)
            return UNSUPPORTED

    def emit(self, kind, **fields):
        print(json.dumps({"kind": kind, **fields, "block": self.place}))

    def block(self, text):
        """One block; whether it ended the program."""
        if len(text.replace("\r", "")) > 158:
            raise Alarm("block_too_long", "FMT-05")
        name, rest = read_name(text)
        if name:
            self.place["sequence"] = name
        items = read_words(text, rest)
        if name in self.names:
            raise Alarm("sequence_name_duplicate", "SEQ-03")
        if name:
            self.names.add(name)
        words = evaluate(items)
        self.check(words)
        return self.carry_out(words)

    # Checks come before anything of the block is carried out (execution, chapter 5).

    def check(self, words):
        motion = next((code for code in words.g if code < 4), self.modes["motion"])
        if 97 in words.g and ("S" not in words or 50 in words.g):
            raise Alarm("cutting_speed_missing", "CSS-03")
        if 4 in words.g:
            if "F" not in words:
                raise Alarm("word_missing", "DWELL-01")
            taken = ""
        elif 50 in words.g:
            if "X" in words or "Z" in words:
                raise Unsupported("zero shift")
            if "S" not in words:
                raise Alarm("word_missing", "G50-01")
            taken = ""
        elif motion < 2:
            taken = "XZ"
        else:
            self.check_arc(words)
            taken = ("X", "Z", "I", "K", "L", "CALRG")
        for address in words:
            if address not in taken and address not in "FS":
                raise Alarm("word_without_function", "ADDR-01", address)

    def check_arc(self, words):
        if not any(address in words for address in ("X", "Z", "I", "K", "L", "CALRG")):
            return                                              # no motion in this block
        if "L" in words:
            if "I" in words or "K" in words:
                raise Alarm("arc_radius_and_centre", "CIRC-15")
            if words["L"] <= 0:
                raise Alarm("arc_radius_not_positive", "CIRC-13")
            if "X" not in words or "Z" not in words:
                raise Alarm("arc_radius_needs_both", "CIRC-14")
            return
        if "CALRG" in words:
            raise Alarm("unspecified", "CIRC-18", "CALRG")
        if not words.get("I") and not words.get("K"):
            raise Alarm("arc_without_centre", "CIRC-06")
        if "X" not in words and "Z" not in words:
            raise Alarm("unspecified", "CIRC-07", "circle")

    # The order of effects in a block (FMT-09): G, F, clamp, S, M, motion or dwell, stop or end.

    def carry_out(self, words):
        for code in words.g:
            self.select(code)
        if "F" in words and 4 not in words.g:
            if not Fraction("0.001") <= words["F"] <= COORDINATE_LIMIT:
                raise Alarm("address_range", "ADDR-01")
            self.feed = rounded(words["F"], 9), self.modes["feed_unit"]
        if 50 in words.g:
            self.clamp = words["S"]                             # SMAX-02
            self.report_spindle(clamp=text_of(self.clamp))
        elif "S" in words:
            self.speed = words["S"]                             # SPD-01, SPD-02
            self.report_spindle()
        for code in words.m:
            self.miscellaneous(code)
        if 4 in words.g:
            self.dwell(words["F"])
        elif 50 in words.g:
            pass                                                # no motion
        elif self.modes["motion"] < 2:
            self.line(words)
        else:
            self.arc(words)
        return self.stop_or_end(words.m)

    def select(self, code):
        """A modal code that changes its group is reported (GCODE-02)."""
        group = G_GROUPS[code]
        if group in self.modes and self.modes[group] != code:
            previous, self.modes[group] = self.modes[group], code
            self.emit("mode", group=group, code=f"G{code:02}", previous=f"G{previous:02}")

    def miscellaneous(self, code):
        if M_GROUPS[code] == "spindle":                         # MCODE-05, MCODE-08
            self.spindle = SPINDLE_STATES[code]
            self.report_spindle()
        elif M_GROUPS[code] == "coolant":
            self.emit("coolant", on=code == 8)

    def report_spindle(self, **fields):
        """A standing spindle shows 0, a turning one at most the clamp (SMAX-01)."""
        speed = self.speed if self.spindle in ("clockwise", "counter_clockwise") else 0
        if self.clamp is not None and speed > self.clamp and self.setup["readings"]["speed_clamp"] == "always":
            speed, fields["limit"] = self.clamp, "clamp"
        self.emit("spindle", spindle="main", state=self.spindle, speed=text_of(speed), **fields)

    def dwell(self, time):
        if not Fraction("0.01") <= time <= Fraction("9999.99"):
            raise Alarm("address_range", "DWELL-02")
        self.emit("dwell", time=text_of(rounded(time, 6)))

    def stop_or_end(self, codes):
        """What waits for the motion of its block; whether the program is over."""
        if 0 in codes:
            self.emit("stop")
        if 1 in codes and self.setup["switches"]["optional_stop"]:
            self.emit("optional_stop")
        end = next((code for code in codes if code in (2, 30)), None)
        if end is None:
            return False
        for code in POWER_ON.values():                          # MCODE-04: the reset, then the end
            self.select(code)
        self.emit("end", code=f"M{end:02}")
        return True

    # Motion. An axis without a word stays (G00-01, G01-01).

    def line(self, words):
        if "X" not in words and "Z" not in words:
            return
        end = self.end_point(words)
        self.demand_reachable(end, words)
        if self.modes["motion"] == 0:
            self.move("rapid", end)
        else:
            feed = self.feed_in_force()
            k = Fraction(1, 2) if self.setup["readings"]["feed_length"] == "radius" else 1      # G01-04
            dx, dz = (end["x"] - self.position["x"]) * k, end["z"] - self.position["z"]
            self.move("linear", end, feed=feed, path=text_of(latched(0, 1, dx * dx + dz * dz)))

    def end_point(self, words):
        return {axis: self.target(axis, words[axis.upper()]) if axis.upper() in words else self.position[axis]
                for axis in "xz"}

    def target(self, axis, word):
        """ABS-01: the word is a coordinate. ABS-02, ABS-03: it is a travel, that of X a diameter too."""
        return word if self.modes["dimension"] == 90 else self.position[axis] + word

    def demand_reachable(self, end, words):
        for axis in "xz":
            if axis.upper() in words and abs(end[axis]) > COORDINATE_LIMIT:
                raise Alarm("coordinate_range", "ADDR-01")

    def feed_in_force(self):
        """FEED-03: the number stays, and is read in the unit of the mode now in force."""
        if self.feed is None:
            raise Alarm("no_feed", "G01-03")
        value, _ = self.feed
        return {"value": text_of(value), "unit": "mm/min" if self.modes["feed_unit"] == 94 else "mm/rev"}

    def move(self, kind, end, **fields):
        program = {axis: text_of(end[axis]) for axis in "xz"}
        machine = {axis: text_of(end[axis] + self.offset[axis]) for axis in "xz"}               # COORD-03
        self.emit(kind, program=program, machine=machine, **fields)
        self.position = end

    # Arcs. Points of the plane are (z, x) with x as a radius, as in `arcs.md`.

    def arc(self, words):
        if not any(address in words for address in ("X", "Z", "I", "K", "L")):
            return
        end = self.end_point(words)
        centre = self.centre(words, end)
        self.demand_reachable(end, words)
        sense = "clockwise" if self.modes["motion"] == 2 else "counter_clockwise"               # CIRC-02
        self.move("arc", end, sense=sense, centre_x=text_of(centre["x"]), centre_z=text_of(centre["z"]),
                  feed=self.feed_in_force())

    def centre(self, words, end):
        """The centre in program coordinates, X as a diameter."""
        if ("X" not in words or "Z" not in words) and self.setup["readings"]["arc_one_coordinate"] != "start":
            raise Unsupported("an arc with one coordinate (CIRC-08)")
        if end == self.position:
            raise Alarm("unspecified", "CIRC-07", "circle")
        start, stop = plane(self.position), plane(end)
        if "L" in words:
            return self.centre_by_radius(start, stop, words["L"], "CALRG" in words)
        z, x = start[0] + words.get("K", 0), start[1] + words.get("I", 0)       # CIRC-04, CIRC-05, CIRC-06
        tolerance = number(self.setup["parameters"]["circular_radius_tolerance"])
        if roots_differ_by_more(square((z, x), start), square((z, x), stop), tolerance):
            raise Alarm("arc_radius_mismatch", "CIRC-11")
        return {"z": z, "x": 2 * x}

    def centre_by_radius(self, start, stop, radius, is_major):
        """CIRC-17, CIRC-18: M = m + side * h * left(e), m the middle of the chord, h the distance from it."""
        chord = square(start, stop)
        if chord > 4 * radius * radius:
            raise Alarm("arc_radius_too_small", "CIRC-16")
        side = self.side_of_centre(is_major)
        dz, dx = stop[0] - start[0], stop[1] - start[1]
        ratio = radius * radius / chord - Fraction(1, 4)                        # (h / chord), squared
        return {"z": latched((start[0] + stop[0]) / 2, -side * dx, ratio),
                "x": latched(start[1] + stop[1], 2 * side * dz, ratio)}

    def side_of_centre(self, is_major):
        """1 when the centre lies to the left of the chord, seen from its start; -1 to the right."""
        left_is_minor = 1 if self.modes["motion"] == 3 else -1
        return -left_is_minor if is_major else left_is_minor


# Text to words (execution, chapters 2 and 3). Ignored characters may stand inside a number (FMT-07).

IGNORED = "[ \r\x7f\x08]*"
SEQUENCE = re.compile(r"N(?!OEX)([A-Z][A-Z0-9]{0,4}|[0-9]{1,5})(?=[ \t\r\x7f\x08(]|$)")
DIGITS = f"(?:[0-9]{IGNORED})"
WORD = re.compile(f"([A-Z])(?![A-Z]){IGNORED}(?:={IGNORED})?"
                  f"((?:[+-]{IGNORED})?(?:{DIGITS}+(?:\\.{IGNORED}{DIGITS}*)?|\\.{IGNORED}{DIGITS}+))")
CALRG = re.compile("CALRG(?![A-Z0-9])")
TAPE_MARK = re.compile(f"{IGNORED}(?:%{IGNORED})+")
BLANK = re.compile(f"[\t \r\x7f\x08]+|\\([^)]*\\)")


def lines_of(program):
    """The number and the text of every line that is no tape mark, and whether it goes on in another line."""
    lines = program.split("\n")
    for ordinal, (text, after) in enumerate(zip(lines, lines[1:] + [""]), 1):
        if not TAPE_MARK.fullmatch(text) or after.startswith("$"):
            yield ordinal, text, text.startswith("$") or after.startswith("$")


def read_name(text):
    """The sequence name of a block, if it has one, and the place after it (SEQ-01, SEQ-02)."""
    place = blanks(text, 0)
    found = SEQUENCE.match(text, place)
    return ("N" + found[1], found.end()) if found else (None, place)


def read_words(text, place):
    """The words from a place on, as address and text of the number."""
    items, place = [], blanks(text, place)
    while place < len(text):
        if found := WORD.match(text, place):
            items.append((found[1], plain_number(found[1], re.sub(IGNORED, "", found[2]))))
        elif found := CALRG.match(text, place):
            items.append(("CALRG", "1"))
        else:
            raise Unsupported(f"{text[place:]!r}")
        place = blanks(text, found.end())
    return items


def blanks(text, place):
    """The place after blanks and comments (CMT-01)."""
    while found := BLANK.match(text, place):
        place = found.end()
    if text.startswith("(", place):
        raise Alarm("comment_unclosed", "CMT-01")
    return place


def plain_number(address, text):
    if address not in ADDRESSES:
        raise Unsupported(f"address {address}")
    if sum(character.isdigit() for character in text) > 8:
        raise Alarm("too_many_digits", "DEC-04 for F, else TYPE-02 and TYPE-03")
    if address == "G" and not re.fullmatch("[0-9]{1,3}", text):
        raise Alarm("number_malformed", "GCODE-01")
    return text


# Words to values, from left to right (execution, chapter 4).

class Words(dict):
    """The value of each address but G and M, in written order, and the codes of G and M."""

    def __init__(self):
        super().__init__()
        self.g, self.m = [], []


def evaluate(items):
    words = Words()
    for address, text in items:
        value = Fraction(text)
        if address == "G":
            add_g_code(words.g, int(value))
        elif address == "M":
            add_m_code(words.m, value)
        elif address in words:
            raise Alarm("duplicate_address", "FMT-06")
        else:
            words[address] = in_range(address, value)
    return words


def add_g_code(codes, code):
    if code not in G_GROUPS:
        raise Unsupported(f"G{code:02}")
    if {90, 91} <= {code, *codes}:
        raise Alarm("absolute_and_incremental", "ABS-04")
    if any(G_GROUPS[other] == G_GROUPS[code] for other in codes):
        raise Alarm("g_codes_conflict", "GCODE-04")
    codes.append(code)


def add_m_code(codes, value):
    if len(codes) == 8:
        raise Alarm("too_many_m", "FMT-06")
    if not 0 <= value <= 511:
        raise Alarm("address_range", "MCODE-01")
    code = int(rounded(value, 0))
    if code not in M_GROUPS:
        raise Unsupported(f"M{code:02}")
    if any(M_GROUPS[other] == M_GROUPS[code] for other in codes):
        raise Alarm("m_codes_conflict", "MCODE-01")
    codes.append(code)


def in_range(address, value):
    """The range is tested on the exact value, which is rounded then (ADDR-01, DEC-03)."""
    if address == "S":
        if not 0 <= value <= 65535:
            raise Alarm("address_range", "SPD-01")
        return rounded(value, 0)
    if address in ("F", "CALRG"):
        return value
    if abs(value) > COORDINATE_LIMIT:
        raise Alarm("address_range", "ADDR-01")
    return rounded(value, 3)


# Exact numbers. To latch is to round once, half away from zero, to the nanometre.

def rounded(value, decimals):
    scale = 10 ** decimals
    steps = (abs(value) * scale * 2 + 1) // 2
    return Fraction(int(steps) if value >= 0 else -int(steps), scale)


def latched(rational, factor, radicand):
    """rational + factor * sqrt(radicand), latched; a root that is no fraction can never be a tie."""
    radicand = Fraction(radicand)
    product, scale = radicand.numerator * radicand.denominator, radicand.denominator
    digits = 1 if is_square(product) else 10 ** 60
    return rounded(rational + factor * Fraction(isqrt(product * digits ** 2), scale * digits), 6)


def is_square(value):
    return isqrt(value) ** 2 == value


def roots_differ_by_more(a, b, tolerance):
    """Whether |sqrt(a) - sqrt(b)| > tolerance, decided without a root."""
    rest = a + b - tolerance * tolerance
    return rest > 0 and rest * rest > 4 * a * b


def plane(position):
    """(z, x), x as a radius."""
    return position["z"], position["x"] / 2


def square(a, b):
    """The square of the distance of two points."""
    return (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2


def text_of(value):
    """Decimal text without superfluous zeros; every value here ends within nine decimals."""
    whole, fraction = divmod(abs(int(value * 10 ** 9)), 10 ** 9)
    digits = f"{whole}.{fraction:09}".rstrip("0").rstrip(".")
    return "-" + digits if value < 0 else digits


if __name__ == "__main__":
    main()

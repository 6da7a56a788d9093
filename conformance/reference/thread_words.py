"""Reading the blocks of a program that cuts threads, and their checks, as far as the subset goes.

Values are fractions of mm, degrees and so on. Every fault of writing leaves the subset.
"""
import re
from fractions import Fraction as Q

from events import Alarm, Unsupported
from exact import PICOMETRE, rounded

WORD = re.compile(r"([A-Z])\s*=?\s*([+-]?\d+\.?\d*|[+-]?\.\d+)\s*")
PASSES, LEGS, COMPOUND = ("G31", "G32", "G33"), ("G34", "G35"), ("G71", "G72")
GROUPS = {
    "motion": ("G00", "G01", *PASSES, *LEGS),
    "dimension": ("G90", "G91"),
    "feed_unit": ("G94", "G95"),
    "cutting_speed": ("G96", "G97"),
    "one_shot": ("G04", "G50", *COMPOUND),
}
M_GROUPS = {
    "spindle": ("M03", "M04", "M05"), "coolant": ("M08", "M09"), "program": ("M00", "M01", "M02", "M30"),
    "thread_chamfer": ("M22", "M23"), "thread_lead": ("M26", "M27"), "thread_infeed": ("M32", "M33", "M34"),
    "thread_pattern": ("M73", "M74", "M75"),
}
LARGEST = Q(99999999, 1000)
RANGES = dict.fromkeys("XZIKLABE", (-LARGEST, LARGEST)) | dict.fromkeys("DUHW", (0, LARGEST)) | {
    "C": (Q(-359999, 1000), Q(359999, 1000)), "J": (1, 9999), "Q": (0, 9999), "S": (0, 65535)}
UNITS = dict.fromkeys("XZIKLABCDUHW", Q(1, 1000)) | {"E": PICOMETRE, "Q": 1}
#: Check 5: what a block takes beside F and S.
TAKES = {"G00": "XZ", "G01": "XZ", "G31": "XZIAKELJC", "G33": "XZIAKELJC", "G32": "XZKAIELJC", "G34": "XZAEJC",
         "G35": "XZAEJC", "G71": "XZIABDUHLEJQ", "G72": "XZKABDWHLEJQ", "G04": "", "G50": "XZ"}


class Block:
    """A block that counts. `unit`: what a written 1 means, in mm, degrees and mm per revolution."""

    def __init__(self, place, items, unit):
        self.place = place
        self.g = [code_of("G", value) for letter, value in items if letter == "G"]
        self.m = [code_of("M", value) for letter, value in items if letter == "M"]
        self.words = {letter: Q(value) * (1 if letter in "JQS" else unit)
                      for letter, value in items if letter not in "GM"}
        self.shot = self.selected("one_shot")
        if unit != 1 and {"G04", "G94"} & set(self.g):
            raise Unsupported("times and feeds per minute in other units")
        self.check_codes(len(items))
        self.check_ranges()

    def selected(self, group, groups=GROUPS):
        return next((code for code in self.g + self.m if code in groups[group]), None)

    def check_codes(self, items):
        for codes, groups in ((self.g, GROUPS), (self.m, M_GROUPS)):
            found = [name for code in codes for name, group in groups.items() if code in group]
            if len(found) != len(codes) or len(set(found)) != len(found):
                raise Unsupported("G and M codes")
        if items != len(self.g) + len(self.m) + len(self.words) or not set(self.words) <= set(RANGES) | {"F"}:
            raise Unsupported("addresses")

    def check_ranges(self):
        for letter, value in self.words.items():
            if letter in RANGES and not RANGES[letter][0] <= value <= RANGES[letter][1]:
                raise Alarm("address_range", "ADDR-01", self.place)
            if letter in UNITS:
                self.words[letter] = rounded(value, UNITS[letter])

    def has(self, letters):
        return any(letter in self.words for letter in letters)

    def cuts(self, motion):
        """Whether it is a thread block in a motion mode."""
        return not self.shot and motion in PASSES + LEGS and self.has("XZCAIKLEJ")


def blocks_of(program):
    """The blocks of a program, and None for each line that is none."""
    lines = []
    for number, text in enumerate(program.removesuffix("\n").split("\n"), 1):
        if text.startswith("$") and lines:
            lines[-1][1] += " " + text[1:]
        else:
            lines.append([number, text])
    return [read(number, text) for number, text in lines]


def read(line, text):
    text = re.sub(r"\(.*?\)", "", text)
    if text.lstrip()[:1] in ("$", "%") or "/" in text or "\t" in text:
        raise Unsupported("line")
    match = re.match(r"\s*(?:(N\w+)\s+)?(.*)$", text)
    name, body = match[1] or "", match[2]
    items, at = [], 0
    while at < len(body):
        word = WORD.match(body, at)
        if not word or sum(c.isdigit() for c in word[2]) > 8:
            raise Unsupported(body)
        items.append((word[1], word[2]))
        at = word.end()
    # Ranges are tested when the run arrives at the block.
    return (line, name), items


def code_of(letter, value):
    if not value.isdigit():
        raise Unsupported("code")
    return "%s%02d" % (letter, int(value))


def check(block, modes, m_codes, first, any_angle):
    """Checks 2 to 5. `modes` are those after the block's own words, `m_codes` those before; `first`: the block has no
    cycle to follow; `any_angle`: chamfering is set to that."""
    def refuse(condition, name, rule, detail=None):
        if condition:
            raise Alarm(name, rule, block.place, detail)

    words, motion = block.words, modes["motion"]
    cuts = block.cuts(motion)
    selects_speed = block.selected("cutting_speed") and ("S" not in words or block.shot == "G50")
    refuse(selects_speed, "cutting_speed_missing", "CSS-03")
    code = next((g for g in block.g if g in PASSES + LEGS + COMPOUND), None)
    refuse(modes["cutting_speed"] == "G96" and (code or cuts), "thread_in_constant_speed", "THRD-01", code or motion)
    refuse(block.shot == "G04" and "F" not in words, "word_missing", "DWELL-01")
    refuse(block.shot == "G50" and not block.has("XZS"), "word_missing", "G50-01")
    if block.shot in COMPOUND:
        check_compound(block, words, m_codes, refuse)
    elif cuts and motion in PASSES:
        check_pass(motion, words, first, refuse)
    elif cuts:
        check_leg(words, refuse, any_angle)
    if cuts:
        refuse(words.get("J", Q(1)).denominator > 1, "unspecified", "THRD-06", "J")
        refuse(words.get("C", 0) < 0, "address_range", "THRD-07")
    if not cuts and not block.shot and motion in ("G00", "G01") and block.has("ACW"):
        raise Unsupported("C, W or an angle")
    takes = TAKES[block.shot or motion] + "FS"
    useless = next((letter for letter in words if letter not in takes), None)
    refuse(useless, "word_without_function", "ADDR-01", useless)


def check_compound(block, words, m_codes, refuse):
    """Check 3."""
    shot = block.shot
    along, allowance = shot == "G71", "U" if shot == "G71" else "W"
    refuse("X" not in words or "Z" not in words, "word_missing", "G71-01" if along else "G72-01")
    refuse("D" not in words or "H" not in words, "word_missing", "G71-09")
    refuse("A" in words and ("I" if along else "K") in words, "angle_overdetermined", "G71-04")
    refuse(words.get("L", 0) < 0, "address_range", "ADDR-01")
    refuse(words.get("J", Q(1)).denominator > 1, "unspecified", "THRD-06", "J")
    left = words["H"] - words.get(allowance, 0)
    refuse(words["D"] == 0, "thread_data", "G71-09", "D")
    refuse(words["H"] == 0, "thread_data", "G71-09", "H")
    refuse(not 0 <= words.get("B", 0) < 180, "thread_data", "G71-09", "B")
    refuse(left <= 0, "thread_data", "G71-09", allowance)
    pattern = block.selected("thread_pattern", M_GROUPS) or m_codes["thread_pattern"]
    refuse(pattern == "M73" and left < words["D"], "thread_data", "G71-09", "M73")


def check_pass(motion, words, first, refuse):
    """Check 4 of G31, G32 and G33."""
    face = motion == "G32"
    refuse(first and ("X" not in words or "Z" not in words), "word_missing", "G32-01" if face else "G33-01")
    refuse("X" not in words and "Z" not in words, "word_missing", "G32-04" if face else "G33-03")
    refuse("A" in words and ("K" if face else "I") in words, "angle_overdetermined", "G33-06")
    refuse(words.get("L", 0) < 0, "address_range", "ADDR-01")


def check_leg(words, refuse, any_angle):
    """Check 4 of G34 and G35."""
    given = [letter for letter in "XZ" if letter in words]
    if any_angle and "A" in words and not given:
        raise Unsupported("A alone")
    refuse("A" in words and len(given) == 2, "angle_overdetermined", "DTAP-01")
    refuse("A" in words and not given, "angle_underdetermined", "DTAP-01")
    refuse(not given, "word_missing", "G34-01")
    refuse(words.get("E", 0) < 0, "address_range", "G34-02")

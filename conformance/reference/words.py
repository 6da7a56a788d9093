"""Reading a line: its sequence name, words and values, as far as the subset goes.

Numbers are rounded to 0.001 (DEC-03); G and M words have whole numbers. Every fault of writing leaves the subset,
so that a block that is read is one without fault up to its checks.
"""
import re
from decimal import Decimal as D, ROUND_HALF_UP

from events import Unsupported

INCREMENT = D("0.001")
LENGTHS = "XZIKL"
GROUPS = {
    "motion": ("G00", "G01", "G02", "G03"),
    "plane": ("G17", "G18", "G119"),
    "dimension": ("G90", "G91"),
    "feed_unit": ("G94", "G95"),
    "compensation": ("G40", "G41", "G42"),
}
#: One-shot codes; G50 only with S, or as far as it is refused.
ONE_SHOTS = ("G04", "G50", "G75", "G76")
CHAMFERS = ("G75", "G76")
M_CODES = {"M00": "stop", "M01": "stop", "M02": "stop", "M30": "stop", "M03": "spindle", "M04": "spindle",
           "M05": "spindle", "M08": "coolant", "M09": "coolant", "M109": "c_axis", "M110": "c_axis"}
WORD = re.compile(r"([A-Z])\s*=?\s*([+-]?\d+\.?\d*|[+-]?\.\d+)\s*")


class Block:
    """A block that counts: its place, its codes in written order, and its other words."""

    def __init__(self, place, items):
        self.place = place
        self.g = [code("G", value) for letter, value in items if letter == "G"]
        self.m = [code("M", value) for letter, value in items if letter == "M"]
        self.words = {letter: value_of(letter, value) for letter, value in items if letter not in "GM"}
        self.letters = list(self.words)
        self.shot = next((g for g in self.g if g in ONE_SHOTS), None)
        self.check_groups(len(items))

    def check_groups(self, items):
        known = [g for codes in GROUPS.values() for g in codes] + list(ONE_SHOTS)
        groups = [set(codes) for codes in GROUPS.values()] + [set(ONE_SHOTS)]
        crowded = any(sum(g in codes for g in self.g) > 1 for codes in groups)
        kinds = [M_CODES.get(m) for m in self.m]
        if not set(self.g) <= set(known) or crowded or None in kinds or len(set(kinds)) < len(kinds):
            raise Unsupported("G and M codes")
        if items != len(self.g) + len(self.m) + len(self.words) or not set(self.words) <= set("XZCIKLFST"):
            raise Unsupported("addresses")

    def has(self, letters):
        return any(letter in self.words for letter in letters)

    def selected(self, group):
        return next((g for g in self.g if g in GROUPS[group]), None)

    def moves(self):
        """Whether the block has an X/Z motion."""
        return self.has("XZ") and self.shot in (None, *CHAMFERS)


def read(line, text, delete):
    """The block of a line, None if there is none. `delete`: blocks with a slash are skipped."""
    text = re.sub(r"\(.*?\)", "", text)
    if text.lstrip()[:1] in ("$", "%") or "\t" in text:
        raise Unsupported("line")
    match = re.match(r"\s*(/?)\s*(?:(N\w+)\s*)?(/?)(.*)$", text)
    slash, name, body = match[1] or match[3], match[2] or "", match[4]
    if slash and delete or not body.strip() or re.fullmatch(r"\s*[O:]\w+\s*", body):
        return None
    items, at = [], len(body) - len(body.lstrip())
    while at < len(body):
        word = WORD.match(body, at)
        if not word or sum(c.isdigit() for c in word[2]) > 8:
            raise Unsupported(body)
        items.append((word[1], word[2]))
        at = word.end()
    return Block((line, name), items)


def code(letter, value):
    if not value.isdigit():
        raise Unsupported("code")
    return "%s%02d" % (letter, int(value))


def value_of(letter, text):
    value = D(text)
    if letter in LENGTHS + "C":
        value = value.quantize(INCREMENT, ROUND_HALF_UP)
        if abs(value) > (D("359.999") if letter == "C" else D("99999.999")):
            raise Unsupported("address_range")
    elif letter in "ST" and (value != int(value) or value < 0):
        raise Unsupported(letter)
    return value

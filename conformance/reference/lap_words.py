"""Reading the blocks of a program with LAP, as far as the subset goes: every fault of writing leaves it."""
import re
from fractions import Fraction as Q

from events import Unsupported
from exact import rounded
from thread_words import LARGEST, code_of

WORD = re.compile(r"(?:([XZDF][AB])\s*=|([A-Z])\s*=?)\s*([+-]?\d+\.?\d*|[+-]?\.\d+)\s*")
CALL = re.compile(r"G\s*=?\s*0*(8[5-8])\s+(N\w+)\s*(.*)$")
MOTIONS, DEFINITIONS = ("G00", "G01", "G02", "G03"), ("G81", "G82")
DIMENSIONS = ("G90", "G91")
INCREMENT = Q(1, 1000)
LENGTHS = ("X", "Z", "I", "K", "D", "U", "W", "XA", "XB", "ZA", "ZB", "DA", "DB")


class Block:
    """`call` is the contour that a call names."""

    def __init__(self, place, items, call=None):
        self.place, self.call = place, call
        self.g = [code_of("G", value) for letter, value in items if letter == "G"]
        self.m = [code_of("M", value) for letter, value in items if letter == "M"]
        self.words = {letter: Q(value) for letter, value in items if letter not in "GM"}
        if len(self.g) + len(self.m) + len(self.words) < len(items):
            raise Unsupported("a word twice")
        for letter, value in self.words.items():
            if letter in LENGTHS:
                if abs(value) > LARGEST or letter in ("D", "U", "W", "DA", "DB") and value < 0:
                    raise Unsupported("address_range")
                self.words[letter] = rounded(value, INCREMENT)
            elif letter[0] in "FE" and not INCREMENT <= value <= LARGEST:
                raise Unsupported("feed")

    def has(self, letters):
        return any(letter in self.words for letter in letters)

    def allow(self, codes, letters, m_codes=()):
        """Everything else leaves the subset."""
        if not (set(self.g) <= set(codes) and set(self.words) <= set(letters) and set(self.m) <= set(m_codes)):
            raise Unsupported(" ".join(self.g + self.m + list(self.words)))


def read(line, text):
    """The block of a line, None if it is none."""
    text = re.sub(r"\(.*?\)", "", text).strip()
    if not text or re.fullmatch(r"[O:]\w+", text):
        return None
    if text[0] in "$%" or "/" in text or "[" in text:
        raise Unsupported("line")
    match = re.match(r"(?:(N\w+)\s+)?(.*)$", text)
    place, body, call = (line, match[1] or ""), match[2], None
    head = CALL.match(body)
    if head:
        call, body = head[2], head[3]
    items, at = [("G", head[1])] if head else [], 0
    while at < len(body):
        word = WORD.match(body, at)
        if not word or sum(c.isdigit() for c in word[3]) > 8:
            raise Unsupported(body)
        items.append((word[1] or word[2], word[3]))
        at = word.end()
    return Block(place, items, call)

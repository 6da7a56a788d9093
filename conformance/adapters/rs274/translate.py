"""An E100L program in the words of rs274, token by token.

The translation renames words and knows nothing of what they do: modes, travels, arcs and feeds are worked out
by rs274. What the two dialects do not share is refused (`LEDGER.md` lists it, and what is levelled here).
"""

import re
from decimal import Decimal

from shared import NotShared

G_CODES = {0, 1, 2, 3, 4, 40, 41, 42, 90, 91, 94, 95, 97}
MOTIONS, ARCS, COMPENSATION, COMPENSATED = {0, 1, 2, 3}, {2, 3}, {40, 41, 42}, {41, 42}
M_CODES = {0, 1, 2, 3, 4, 5, 8, 9, 30}
PROGRAM_ENDS = {2, 30}

# Lathe in the Z-X plane, X as a diameter, millimetres, no compensation: what an E100L is built as. The modes
# are those of its power-on. rs274 refuses feed per revolution while the spindle speed is 0, so that it gets one
# that its four decimals print as 0.
PRELUDE = "G7 G18 G21 G40 G90 G95 S0.00001"

BLANKS = re.compile(r"(?:[ \t\r\x7f\x08]+|\([^)]*\))*")
COMMENT = re.compile(r"\(([^)]*)\)")
SEQUENCE = re.compile(r"N(?!OEX)([A-Z][A-Z0-9]{0,4}|[0-9]{1,5})(?=[ \t\r\x7f\x08/(]|$)")
IGNORED = "[ \r\x7f\x08]*"
WORD = re.compile(rf"([A-Z])(?![A-Z]){IGNORED}=?{IGNORED}([+-]?{IGNORED}(?:[0-9]{IGNORED}|\.{IGNORED})+)")
# A comment of rs274 that comes out among the calls, in its place among those that wait for a corner.
MARK = "(@{})"
MAJOR_ARC = re.compile("CALRG(?![A-Z0-9])")
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)")


class Block:
    """One block: its line, its sequence name, its words, and its text for rs274."""

    def __init__(self, line, text, noses):
        self.line = line
        place = BLANKS.match(text).end()
        self.is_optional, place = slash(text, place)
        self.sequence, place = sequence_name(text, place)
        if not self.is_optional:
            self.is_optional, place = slash(text, place)
        self.words = words(text, place)
        self.comments = [comment[1] for comment in COMMENT.finditer(text)]
        self.noses = [noses.of_word(number) for address, number in self.words if address == "T"]
        self.motion_codes = [code for code in self.g_codes() if code in MOTIONS]
        if self.compensation_codes() and ARCS.isdisjoint(self.motion_codes) and any(a in "IK" for a, _ in self.words):
            raise NotShared("an imaginary point beside G40, G41 or G42")

    def text(self, is_compensated):
        """The lines for rs274, each with the mark that tells its calls; a tool is changed in a line before."""
        change = [f"T{nose}" for nose in self.noses] + ["M6"] * bool(self.noses)
        rest = [f"G{code}" for code in self.motion_codes]
        rest += [word(*each, self.words) for each in self.words if not is_written_apart(*each)]
        if not is_compensated:
            rest = [text for text in rest if text not in ("G41", "G42")]
        lines = [parts for parts in (change, rest) if parts]
        texts = [" ".join([f"N{self.line}", *parts, *self.remarks(), MARK.format(self.line)]) for parts in lines]
        return "\n".join(("/" if self.is_optional else "") + text for text in texts or [" ".join(self.remarks())])

    def remarks(self):
        return [f"(- {plain(comment)})" for comment in self.comments]

    def g_codes(self):
        return [int(number) for address, number in self.words if address == "G"]

    def compensation_codes(self):
        return COMPENSATION.intersection(self.g_codes())

    def moves(self):
        """Whether the block has a word that asks for motion."""
        return any(address in "XZIKL" for address, _ in self.words)

    def ends_program(self):
        return any(address == "M" and int(number) in PROGRAM_ENDS for address, number in self.words)


def translate(program, setup, noses):
    """The blocks as far as they are shared, and why the rest is not; `None` if all of them are."""
    blocks, not_shared = [], None
    for line, text in enumerate(program.split("\n"), 1):
        try:
            block = Block(line, text, noses)
        except NotShared as reason:
            not_shared = f"line {line}: {reason}"
            break
        blocks.append(block)
        if block.ends_program() and not is_skipped(block, setup):
            break                                               # nothing behind it is read
    bring_motion_codes(blocks, setup)
    return blocks, not_shared


def bring_motion_codes(blocks, setup):
    """Takes the motion code of a block without a coordinate to the next block that has one: on the E100L it is a mode,
    rs274 carries it out at once. Two of them in a block stay, for both to refuse."""
    waiting = []
    for block in blocks:
        if is_skipped(block, setup) or len(block.motion_codes) > 1:
            continue
        if block.moves():
            block.motion_codes = block.motion_codes or waiting
            waiting = []
        elif block.motion_codes:
            waiting, block.motion_codes = block.motion_codes, []


def is_skipped(block, setup):
    return block.is_optional and setup["switches"]["block_delete"]


def demand_shared_machine(setup):
    if setup["control"] != "e100l" or setup["unit_system"] != "1mm" or setup["tape"]["code"] != "ascii":
        raise NotShared("another control, unit system or tape code")
    if any(setup["limits"].get(axis) for axis in "xz") or setup["options"]["w_axis"]:
        raise NotShared("travel limits, or a W axis")


def has_compensation(blocks):
    return any(COMPENSATED.intersection(block.g_codes()) for block in blocks)


def program_text(blocks, setup, is_compensated):
    """The program for rs274, with G41 and G42 or without: the machine is prepared, then brought to the place
    where it starts."""
    x, z = (Decimal(str(setup["start"][axis])) - Decimal(str(setup["zero_offset"][axis])) for axis in "xz")
    return "\n".join([PRELUDE, f"G0 X{x} Z{z}", *(block.text(is_compensated) for block in blocks), ""])


def slash(text, place):
    is_there = text.startswith("/", place)
    return is_there, BLANKS.match(text, place + is_there).end()


def sequence_name(text, place):
    found = SEQUENCE.match(text, place)
    if not found:
        return None, place
    return "N" + found[1], BLANKS.match(text, found.end()).end()


def words(text, place):
    found_words = []
    while place < len(text):
        if found := WORD.match(text, place):
            found_words.append((found[1], shared_number(found[1], re.sub(IGNORED, "", found[2]))))
        elif found := MAJOR_ARC.match(text, place):
            found_words.append(("CALRG", ""))
        else:
            raise NotShared(repr(text[place:]))
        place = BLANKS.match(text, found.end()).end()
    if found_words.count(("CALRG", "")) > 1:
        raise NotShared("CALRG twice")
    if ("CALRG", "") in found_words and not any(address == "L" for address, _ in found_words):
        raise NotShared("CALRG without L")
    return found_words


def shared_number(address, text):
    """The number, if both would take it for the same value."""
    if not NUMBER.fullmatch(text) or sum(character.isdigit() for character in text) > 8:
        raise NotShared(f"number {text}")
    decimals = len(text.partition(".")[2].rstrip("0"))
    if address == "G":
        if not re.fullmatch("[0-9]{1,3}", text) or int(text) not in G_CODES:
            raise NotShared(f"G{text}")
        return str(int(text))
    elif address == "M":
        if Decimal(text) not in M_CODES:
            raise NotShared(f"M{text}")
        return str(int(Decimal(text)))
    elif address in "XZIKL":
        if decimals > 3:
            raise NotShared(f"{address}{text}: a fraction of the increment")
    elif address == "S":
        if decimals or Decimal(text) == 0:
            raise NotShared(f"S{text}: a fraction of the unit, or no speed")
    elif address == "T":
        if not re.fullmatch("[0-9]{1,6}", text):
            raise NotShared(f"T{text}")
    elif address != "F":
        raise NotShared(f"address {address}")
    return text


def is_written_apart(address, number):
    """A tool, the mark of a major arc, a motion code."""
    return address in ("CALRG", "T") or address == "G" and int(number) in MOTIONS


def word(address, number, others):
    """A word for rs274: a dwell has its time in P, an arc its radius in R, and the major arc has R negative."""
    if address == "F" and any(other == "G" and int(code) == 4 for other, code in others):
        return f"P{number}"
    if address == "L":
        return f"R{-Decimal(number) if ('CALRG', '') in others else number}"
    return address + number


def plain(comment):
    """The text of a comment without what a comment of rs274 must not hold."""
    return "".join(character if " " <= character < "\x7f" and character != "(" else "." for character in comment)

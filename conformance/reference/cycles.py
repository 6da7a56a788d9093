"""Random programs with thread cycles, each with a set-up: the same seed gives the same ones.

Most words are such that the cycle is cut to its end; some are not. Lengths are whole micrometres.
"""
from typing import NamedTuple

from dice import Dice
from pieces import mm

READINGS = {"taper_reference": ("start", "end"), "thread_shift": ("toward_end", "coordinate"),
            "thread_flank": ("negative", "positive"), "feed_length": ("radius", "diameter"),
            "speed_clamp": ("always", "cutting_speed")}
INFEEDS, PATTERNS = ("M32", "M33", "M34"), ("M73", "M74", "M75", "M75")
#: Angles of the tip in thousandths of a degree.
TIPS = (0, 60_000, 55_000, 90_000, 29_500, 1, 60_000, 179_999)
STARTS = (2, 3, 7, 0, 1)
#: Blocks that end the program with an alarm, whatever is in force.
FAULTS = ("G71 X10 Z10 D1", "G72 Z-10 D1 H2", "G71 X10 Z10 D0 H2", "G71 X10 Z10 D1 H2 B180", "G33 X10 Z10 C-1",
          "G71 X10 Z10 D1 H2 U2 M74", "G71 X10 Z10 D2 H2 U0.5 M73", "G71 X10 Z10 I1 A170 D1 H2", "G33 X10", "G34 E1",
          "G72 X10 Z10 D1 H2 L-1 M74", "G71 X10 Z10 D1 H2 J1.5 M74", "G34 X10 Z10 A45", "G00 X10 Q2", "G35 X10 E-1",
          "G71 X10 Z10 D1 H2 Q10000", "G96 S100 G71 X10 Z10 D1 H2 M74", "G71 X10 Z10 D1 H2 F0.001 J2 M74")


class Cycle(NamedTuple):
    program: str
    setup: str      # TOML


def cycles(count, seed):
    dice = Dice(seed)
    return [Generator(Dice(dice.bits())).cycle() for _ in range(count)]


class Generator:
    def __init__(self, dice):
        self.dice, self.lines = dice, []

    def cycle(self):
        self.block(f"G00 X{mm(self.size(40_000, 90_000))} Z{mm(self.size(40_000, 90_000))} F{mm(self.size(1000, 6000))} "
                   f"S{self.dice.between(20, 3000)}{self.maybe(*[' M03'] * 6, ' M04', '')}")
        for _ in range(self.dice.between(1, 3)):
            if self.dice.once_in(3):
                self.to_start()
            self.dice.weighted({self.compound: 6, self.passes: 2, self.legs: 1})()
        if self.dice.once_in(12):
            self.block(self.dice.one_of(FAULTS))
        self.block("M02")
        return Cycle("\n".join(self.lines) + "\n", self.setup())

    def block(self, text):
        self.lines.append(f"N{len(self.lines) + 1} {text}")

    def size(self, least, most):
        """Whole, tenths, or any number of micrometres."""
        return self.dice.between(least, most) // (step := self.dice.one_of((1000, 100, 1))) * step

    def maybe(self, *texts):
        return self.dice.one_of(texts)

    def word(self, letter, least, most, once_in=2):
        return f" {letter}{mm(self.size(least, most))}" if self.dice.once_in(once_in) else ""

    def change(self, least, most, once_in):
        """E, that small that few leads leave their range."""
        return f" E{mm(self.dice.between(least, most))}" if self.dice.once_in(once_in) else ""

    def to_start(self):
        self.block(f"G00 G90 X{mm(self.size(40_000, 90_000))} Z{mm(self.size(40_000, 90_000))}")
        if self.dice.once_in(5):
            self.block(f"G50 {self.maybe('X', 'Z')}{mm(self.size(30_000, 90_000))}")

    def compound(self):
        """A block with G71 or G72 from a point that the lines before have left at X and Z of 30 mm and more."""
        dice, face = self.dice, self.dice.once_in(3)
        x, z = self.size(2000, 26_000), self.size(2000, 26_000)
        if dice.once_in(6):
            x, z = self.size(91_000, 99_000) if not face else x, z if not face else self.size(91_000, 99_000)
        height = self.size(1000, 4000)
        step = max(1, height * 10 // dice.between(11, 90)) if not dice.once_in(8) else height + dice.between(0, 300)
        text = f"{'G72' if face else 'G71'} G90 X{mm(x)} Z{mm(z)} D{mm(step)} H{mm(height)}"
        if dice.once_in(2):
            text += f" {'W' if face else 'U'}{mm(max(1, height // dice.between(4, 30)))}"
        if dice.once_in(2):
            text += f" B{mm(dice.one_of(TIPS))}"
        text += self.taper("K" if face else "I") + self.word("L", 0, 5000, 3) + self.change(-60, 300, 4)
        text += self.word("F", 1000, 6000) + self.maybe("", "", f" J{dice.between(1, 9)}")
        text += self.maybe("", "", f" Q{dice.one_of(STARTS)}")
        self.block(text + f" {dice.one_of(PATTERNS)} {dice.one_of(INFEEDS)}" + self.maybe("", " M22", " M23"))

    def taper(self, letter):
        how = self.dice.one_of((None, None, "amount", "angle"))
        if how == "amount":
            return f" {letter}{mm(self.size(-2000, 2000))}"
        if how == "angle":
            quarter = 0 if self.dice.once_in(10) else 90_000 if letter == "K" else 180_000
            return f" A{mm(self.size(-3000, 3000) + quarter + self.dice.one_of((0, 180_000, -180_000)))}"
        return ""

    def passes(self):
        """A block with G31, G32 or G33, and some that follow it."""
        dice, code = self.dice, self.dice.one_of(("G31", "G32", "G33"))
        taper, shift = ("K", "I") if code == "G32" else ("I", "K")
        text = f"{code} {self.maybe('G90', 'G90', 'G91')}"
        text += self.word("X", -9000, 26_000, 1) + self.word("Z", -9000, 26_000, 1) + self.taper(taper)
        text += self.word(shift, -3000, 3000) + self.word("L", 0, 5000, 3) + self.change(-60, 300, 4)
        self.block(text + self.word("F", 1000, 6000) + self.word("C", 0, 359_999) + self.maybe("", " M22", " M23"))
        for _ in range(dice.between(0, 3)):
            text = f"{'Z' if code == 'G32' else 'X'}{mm(self.size(-9000, 26_000))}" + self.word("L", 0, 3000, 4)
            text += self.word(shift, 0, 3000, 4) + self.word("C", 0, 359_999, 4)
            self.block(text + self.maybe("", "", "", f" J{dice.between(2, 5)}"))

    def legs(self):
        """Blocks with G34 and G35; they end where the next cycle can begin."""
        for _ in range(self.dice.between(1, 3)):
            code, x, z = self.maybe("G34", "G35"), self.size(30_000, 60_000), self.size(30_000, 60_000)
            angle = mm(self.size(170_000, 179_000))
            where = self.maybe(f"X{mm(x)} Z{mm(z)}", f"Z{mm(z)}", f"X{mm(x)} Z{mm(z)} M27", f"Z{mm(z)} A{angle}")
            text = f"{code} G90 {where}" + self.change(0, 60, 3) + self.word("C", 0, 359_999)
            self.block(text + self.word("F", 1000, 6000))

    def setup(self):
        dice = self.dice
        text = "[parameters]\n" + f"thread_chamfer_feed = {dice.one_of((640, 640, 100, 9999, 17))}\n"
        text += f"m75_pattern = {dice.one_of((3, 3, 4))}\n[readings]\n"
        text += f'balanced_infeed = "{dice.one_of(("equal_area",) * 7 + ("refused",))}"\n'
        text += "".join(f'{name} = "{dice.one_of(values)}"\n' for name, values in READINGS.items())
        text += f"[zero_offset]\nz = {mm(dice.one_of((0, 0, 100_000, -1)))}\n[limits]\n"
        text += f"steps = {dice.one_of((1000,) * 9 + (20,))}\n"
        if dice.once_in(8):
            text += f"[limits.x]\nnegative = {mm(dice.between(-12, 4) * 1000)}\npositive = 95\n"
        return text

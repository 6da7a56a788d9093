"""Random programs in compensation, each with a set-up: the same seed gives the same ones."""
from typing import NamedTuple

from dice import Dice
from pieces import IDLE, Pieces, mm

#: Nose radii in micrometres.
NOSES = (800, 400, 1200, 801, 397, 200, 0)


#: Blocks that are refused in compensation, or whose codes are.
FAULTS = ("G50 X100", "G18 X50", "G17", "G01 X10 I5", "G40 G03 X30 Z30 K-2", "G40 G02 I-2 K0", "G02 X20 Z20",
          "G40 G00 X100 I0 K0", "G75 X50", "G00 G76 X20 L1", "G03 X30 Z30 L0.001", "G02 X50 Z50 I1 L5",
          "G40 G01 G76 X-900 L3", "G01 C45", "G91 G02 X0.02 Z0 I0.01")


class Contour(NamedTuple):
    program: str
    setup: str      # TOML


def contours(count, seed):
    dice = Dice(seed)
    return [Generator(Dice(dice.bits())).contour() for _ in range(count)]


class Generator(Pieces):
    def contour(self):
        self.block(f"G00 X{mm(self.x)} Z{mm(self.z)} {self.tool(1)}")
        self.block("G01 F0.2")
        self.motion = "G01"
        for last in self.dice.weighted({(True,): 3, (False, True): 1}):
            self.start_up()
            for _ in range(self.dice.between(4, 12)):
                self.piece()
            if last and self.dice.once_in(20):
                self.block(self.dice.one_of(FAULTS))
            if not (last and self.dice.once_in(4)):
                self.cancel()
        self.lines.append(self.dice.one_of(("M02", "M30", "M02", "M08 M02")))
        return Contour("\n".join(self.lines) + "\n", self.setup())

    def setup(self):
        dice, text = self.dice, '[parameters]\nchamfering = "basic"\n'
        for number in range(1, 5):
            size = dice.one_of(NOSES)
            z, x = dice.one_of((size, size, -size)), dice.one_of((size, size, -size))
            if dice.once_in(8):
                x //= 2
            text += f"[[nose_radius]]\nnumber = {number}\nx = {mm(x)}\nz = {mm(z)}\n"
        for number, (z, x) in list(enumerate(self.offsets))[1:]:
            text += f"[[tool_offset]]\nnumber = {number}\nx = {mm(x)}\nz = {mm(z)}\n"
        text += f"[zero_offset]\nz = {mm(dice.one_of((0, 0, 200_000, -1)))}\n"
        if dice.once_in(2):
            text += "[switches]\nblock_delete = true\noptional_stop = true\n"
        if dice.once_in(10):
            text += f"[limits.x]\npositive = {mm(dice.between(180, 400) * 1000)}\n"
        if dice.once_in(10):
            text += f"[limits.z]\nnegative = {mm(dice.between(-200, 0) * 1000)}\n"
        return text

    # Beginning and ending.

    def start_up(self):
        self.side = self.dice.one_of(("G41", "G42"))
        code = self.dice.one_of(("G00", "G01"))
        how = self.dice.weighted({"axes": 6, "alone": 2, "imaginary": 3, "present": 1, "chamfer": 1})
        if how == "alone":
            self.block(f"{self.modes(code)} {self.side}".strip())
        elif how == "chamfer":
            self.chamfer(self.side)
        elif how == "present":
            self.to(self.z, self.x, f" {self.side}", code, both=True)
        else:
            words = f" {self.side}" + (self.imaginary() if how == "imaginary" else "")
            self.to(self.z - self.size(), self.x + self.size(), words, code)
        for _ in range(self.dice.weighted({0: 30, 1: 8, 2: 1})):
            self.block(self.dice.one_of(IDLE))
        if not self.dice.once_in(30):
            self.line()

    def cancel(self):
        how = self.dice.weighted({"axes": 5, "alone": 3, "imaginary": 3, "present": 1, "chamfer": 1, "dwell": 1})
        code = self.dice.one_of(("G00", "G01"))
        if how == "alone":
            words = self.imaginary() if self.dice.once_in(3) else ""
            self.block(f"{self.modes(code)} G40{words}".strip())
        elif how == "dwell":
            self.block(f"{self.modes(code)} G40 G04 F1".strip())
        elif how == "chamfer":
            self.chamfer("G40")
        elif how == "present":
            self.to(self.z, self.x, " G40", code, both=True)
        else:
            words = " G40" + (self.imaginary() if how == "imaginary" else "")
            self.to(self.z + self.size(), self.x + self.size(), words, code)
        self.side = None
        for _ in range(self.dice.between(0, 2)):
            self.line()

    def imaginary(self):
        """I and K; at times neither has a direction."""
        i, k = self.dice.between(-9, 9) * 500, self.dice.between(-9, 9) * 500
        return self.dice.one_of((f" I{mm(i)} K{mm(k)}", f" I{mm(i)}", f" K{mm(k)}"))

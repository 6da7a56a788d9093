"""Pieces of a contour, chosen at random: lines, arcs, chamfers, returns, repetitions, blocks without motion.

Coordinates are whole micrometres, X as a diameter. The generator keeps to what the control accepts as far as the
programmed path goes, so that most programs come to their end; whether the nose can follow is left to chance.
"""
from math import gcd, isqrt

#: Rotations of an arm by rational angles, as (cosine, sine, divisor).
TURNS = ((0, 1, 1), (-1, 0, 1), (0, -1, 1), (3, 4, 5), (4, -3, 5), (-3, 4, 5), (5, 12, 13), (-4, -3, 5), (24, 7, 25))
IDLE = ("M08", "M09", "G04 F0.5", "S800", "M00", "M01", "F0.15", "M03 S500", "G94 F120", "G95 F0.1")
#: Lines that are no blocks; the last is one where block delete is off.
NO_BLOCKS = ("", "(REMARK)", "/ M08")


def mm(micrometres):
    """Decimal text in mm."""
    whole, rest = divmod(abs(micrometres), 1000)
    text = f"{whole}.{rest:03}".rstrip("0").rstrip(".") if rest else str(whole)
    return "-" + text if micrometres < 0 else text


def centre(k, i):
    return "".join(f" {letter}{mm(value)}" for letter, value in (("I", i), ("K", k)) if value)


class Pieces:
    def __init__(self, dice):
        self.dice = dice
        self.z, self.x = dice.between(60, 140) * 1000, dice.between(40, 160) * 1000
        self.base = None                # corner of the chamfer before, which words in G91 count from
        self.motion, self.incremental, self.side = "", False, None
        self.way = (-1000, 0)           # last direction of travel: Z, and X as a diameter
        self.lines, self.number = [], 0
        self.offset = dice.between(0, 2)
        self.offsets = [(0, 0)] + [(dice.between(-9999, 9999), dice.between(-9, 9) * 100) for _ in range(2)]

    # Writing.

    def block(self, text):
        self.number += 1
        self.lines.append(f"N{self.number} {text}".rstrip())

    def to(self, z, x, words="", code=None, both=False):
        """A straight block to a point, with the words that it needs or both."""
        code = code or self.dice.weighted({"G01": 6, "G00": 1})
        prefix = self.modes(code)
        base_z, base_x = (self.base or (self.z, self.x)) if self.incremental else (0, 0)
        text = prefix + words
        if both or x != self.x or self.incremental and self.base and x != base_x:
            text += f" X{mm(x - base_x)}"
        if both or z != self.z or self.incremental and self.base and z != base_z:
            text += f" Z{mm(z - base_z)}"
        self.block(text.strip())
        if (z, x) != (self.z, self.x):
            self.way = (z - self.z, x - self.x)
        self.z, self.x, self.base = z, x, None

    def modes(self, code):
        """The motion code if it changes, now and then otherwise; sometimes a change between G90 and G91."""
        text = code if code != self.motion or self.dice.once_in(4) else ""
        self.motion = code
        if self.dice.once_in(12):
            self.incremental = not self.incremental
            text += " G91" if self.incremental else " G90"
        return text

    def tool(self, lowest):
        """The T word with a nose number from `lowest` up; it forgets the corner of a chamfer."""
        self.base = None
        return f"T{self.dice.between(lowest, 4):02}01{self.offset:02}"

    # Choosing.

    def piece(self):
        weights = {"line": 20, "arc": 10, "tangent_arc": 8, "radius_arc": 6, "chamfer": 6, "onward": 6, "reversal": 3,
                   "repeated": 4, "idle": 9, "short": 4, "acute": 4, "other_side": 1, "other_tool": 2}
        getattr(self, self.dice.weighted(weights))()

    def size(self):
        return self.dice.between(2, 60) * self.dice.one_of((100, 500, 1000, 257))

    def signed(self, size):
        return size if self.dice.once_in(2) else -size

    def line(self):
        """Along an axis, a taper, or one with the sides of a triangle in whole numbers (Z, and X as a diameter)."""
        any_taper = (self.dice.between(1, 9), self.dice.between(1, 9))
        z, x = self.dice.one_of(((1, 0), (0, 2), (1, 0), (0, 2), any_taper, any_taper, (3, 8), (12, 10), (255, 64)))
        scale = max(1, self.size() // max(z, x))
        z, x = self.forward(self.signed(z * scale), self.signed(x * scale))
        self.to(self.z + z, self.x + x)

    def forward(self, z, x):
        """A travel that mostly turns by no more than a right angle."""
        back = 4 * z * self.way[0] + x * self.way[1] < 0
        return (-z, -x) if back and not self.dice.once_in(8) else (z, x)

    def onward(self):
        """Straight on: a point on a line."""
        factor = self.dice.between(1, 2)
        self.to(self.z + factor * self.way[0], self.x + factor * self.way[1])

    def reversal(self):
        """Back on a line, on the same side or the other."""
        self.line()
        words = ""
        if not self.dice.once_in(3):
            self.side = "G41" if self.side == "G42" else "G42"
            words = f" {self.side}"
        self.to(self.z - self.way[0], self.x - self.way[1], words)

    def acute(self):
        """Back beside a line, at times so close that the corner lies out of range."""
        self.line()
        aside = self.signed(1 if self.dice.once_in(12) else self.dice.between(1, 40) * 50)
        z, x = (0, aside) if abs(self.way[0]) > abs(self.way[1]) else (aside, 0)
        self.to(self.z - self.way[0] + z, self.x - self.way[1] + x)

    def short(self):
        self.to(self.z + self.signed(self.dice.between(0, 700)), self.x + self.signed(self.dice.between(1, 1400)))

    def repeated(self):
        for _ in range(self.dice.weighted({1: 3, 2: 1})):
            self.to(self.z, self.x, both=True)

    def idle(self):
        for _ in range(self.dice.weighted({1: 5, 2: 2, 3: 1})):
            self.block(self.dice.one_of(IDLE))
            if self.dice.once_in(4):
                self.lines.append(self.dice.one_of(NO_BLOCKS))
            if self.dice.once_in(8):
                self.block("")

    def other_side(self):
        self.side = "G41" if self.side == "G42" else "G42"
        if self.dice.once_in(2):
            self.block(self.side)
        else:
            self.to(self.z - self.size(), self.x + self.signed(self.size()), f" {self.side}")

    def other_tool(self):
        """Another nose, now and then with another offset, in which P has other coordinates."""
        if self.dice.once_in(4):
            before, self.offset = self.offsets[self.offset], self.dice.between(0, 2)
            after = self.offsets[self.offset]
            self.z, self.x = self.z + before[0] - after[0], self.x + before[1] - after[1]
        self.block(self.tool(0))

    def arc(self):
        """About a centre whose arm lies on an axis or is a triangle in whole numbers; its end is rounded to the grid."""
        size = self.dice.between(3, 30) * self.dice.one_of((100, 500, 1000, 1000))
        k, i = self.dice.one_of(((size, 0), (0, size), (3 * size // 5, 4 * size // 5)))
        k, i = self.signed(k), self.signed(i)
        onward = 2 * i * self.way[0] - k * self.way[1] >= 0     # G03 goes on, left of the arm to P
        self.about(k, i, onward != self.dice.once_in(12))

    def tangent_arc(self):
        """About a centre square to the last direction, mostly going on in it."""
        k, i = -self.way[1], 2 * self.way[0]
        divisor = gcd(k, i) or 1
        k, i = k // divisor, i // divisor
        factor = self.signed(max(1, self.dice.between(1, 30) * 500 // (isqrt(k * k + i * i) or 1)))
        self.about(k * factor, i * factor, (factor > 0) != self.dice.once_in(12))

    def about(self, k, i, left):
        """An arc about P + (k, i), and at times the same way back on the other side."""
        cosine, sine, divisor = self.dice.one_of(TURNS)
        if not (k or i):
            return
        start = (self.z, self.x)
        z = self.z + k - (cosine * k - sine * i) // divisor
        x = self.x + 2 * (i - (sine * k + cosine * i) // divisor)
        self.curve(z, x, centre(k, i), "G03" if left else "G02")
        if self.side and self.dice.once_in(15):
            self.side = "G41" if self.side == "G42" else "G42"
            k, i = start[0] + k - z, start[1] // 2 + i - x // 2
            if (start[1] - x) % 2 == 0:
                self.curve(*start, f"{centre(k, i)} {self.side}", "G02" if left else "G03")
            start = (z, x)
        self.tangent_at_end(k, i, *start)

    def tangent_at_end(self, k, i, start_z, start_x):
        """The direction at the end becomes the last one, for pieces that go on tangentially."""
        sigma = 1 if self.motion == "G03" else -1
        z, x = -sigma * (self.x - start_x - 2 * i), 4 * sigma * (self.z - start_z - k)
        divisor = gcd(z, x) or 1
        factor = max(1, self.dice.between(2, 20) * 1000 * divisor // (abs(z) + abs(x) or 1))
        self.way = (z // divisor * factor, x // divisor * factor)

    def radius_arc(self):
        z, x = self.forward(self.signed(self.size()), self.signed(self.size()))
        z, x = self.z + z, self.x + x
        half = isqrt((z - self.z) ** 2 // 4 + (x - self.x) ** 2 // 16) + 1
        self.curve(z, x, f" L{mm(half + self.dice.between(0, 20) * 500)}", self.dice.one_of(("G02", "G03")))

    def curve(self, z, x, words, code):
        """G02 or G03; its words count from the present point in G91."""
        prefix = self.modes(code)
        base_z, base_x = (self.z, self.x) if self.incremental else (0, 0)
        self.block(f"{prefix} X{mm(x - base_x)} Z{mm(z - base_z)}{words}".strip())
        self.way = (z - self.z, x - self.x)
        self.z, self.x, self.base = z, x, None

    def chamfer(self, words=""):
        """G75 or G76 in the basic form, and as a rule the line on the other axis behind it."""
        run, size = self.signed(self.dice.between(6, 30) * 1000), self.signed(self.dice.between(1, 5) * 1000)
        if self.dice.once_in(10):
            size = abs(run) if size > 0 else -abs(run)
        along_x, shot = self.dice.once_in(2), self.dice.one_of(("G75", "G76"))
        corner = (self.z, self.x + 2 * run) if along_x else (self.z + run, self.x)
        self.to(*corner, f" {words} {shot} L{mm(size)}".replace("  ", " "), "G01")
        end = (corner[0] + size, corner[1]) if along_x else (corner[0], corner[1] + 2 * size)
        self.z, self.x, self.base = *end, corner
        self.way = (size, 0) if along_x else (0, 2 * size)
        if not self.dice.once_in(4):
            self.onward()

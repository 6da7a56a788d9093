"""Random programs that rough a contour in mode I: levels, walls, slopes, arcs and recesses, longitudinal and transverse."""
from typing import NamedTuple

from dice import Dice

#: Of a hundred contours that many run back somewhere, so that they are refused.
ODD = 4


class Program(NamedTuple):
    program: str
    setup: str


def contours(count, seed):
    dice = Dice(seed)
    return [contour(dice) for _ in range(count)]


def text(milli):
    """Thousandths as a number with decimal point."""
    sign = "-" if milli < 0 else ""
    return f"{sign}{abs(milli) // 1000}.{abs(milli) % 1000:03}"


class Writer:
    """A contour in amounts: heights against the infeed, runs in the sense of the cut, thousandths, heights not halved."""

    def __init__(self, dice):
        self.dice = dice
        self.transverse = dice.once_in(3)
        self.sigma, self.gamma = dice.one_of((1, 1, -1)), dice.one_of((-1, -1, 1))
        self.fine = dice.once_in(2)     # whether amounts are no round numbers
        # The origin, far enough that nothing is out of range.
        self.height, self.run = self.amount(20, 60), self.amount(0, 20)
        self.lines, self.top = [], self.height

    def amount(self, low, high):
        """Thousandths between whole numbers."""
        return self.dice.between(low * 1000, high * 1000) if self.fine else 1000 * self.dice.between(low, high)

    def words(self, height=None, run=None):
        """The words of a point, without those that are not to change."""
        infeed, cutting = ("Z", "X") if self.transverse else ("X", "Z")
        found = {}
        if height is not None:
            found[infeed] = infeed + text(self.sigma * height)
        if run is not None:
            found[cutting] = cutting + text(self.gamma * run)
        return " ".join(found[letter] for letter in "XZ" if letter in found)

    def element(self):
        dice = self.dice
        kind = dice.weighted({"level": 4, "wall": 4, "slope": 4, "fall": 4, "drop": 2, "arc": 5, "bow": 1})
        if dice.once_in(100 // ODD * 6):
            self.line(self.height + self.amount(-4, 4), self.run - self.amount(1, 3))
        elif kind == "level":
            self.line(None, self.run + self.amount(1, 12))
        elif kind == "wall":
            self.line(self.height + self.amount(1, 9), None)
        elif kind == "drop":
            self.line(self.height - self.amount(1, 9), None)
        elif kind == "bow":
            self.bow()
        elif kind == "arc":
            self.quarter()
        else:
            rise = self.amount(1, 9)
            self.line(self.height + (rise if kind == "slope" else -rise), self.run + self.amount(1, 9))

    def line(self, height, run, code="G01"):
        if height is not None and run is None and self.lines and self.lines[-1][1] is not None and \
                (height - self.height) * self.lines[-1][1] < 0:
            run = self.run + 1000       # no wall that is run up and down again
        self.lines.append((f"{code} {self.words(height, run)}", height - self.height if run is None else None))
        self.go(height, run)

    def go(self, height, run):
        self.height = self.height if height is None else height
        self.run = self.run if run is None else run
        self.top = max(self.top, self.height)

    def quarter(self):
        """From a level to a wall or the other way round."""
        radius, rises, from_level = self.amount(1, 5), self.dice.once_in(2), self.dice.once_in(2)
        self.arc(rises, radius * (1 if rises else -1), radius, (0, radius) if from_level else (radius, 0))

    def bow(self):
        """Over or under a centre: ends of 3-4-5 triangles."""
        unit, over = self.dice.between(100, 900), self.dice.once_in(2)
        self.arc(not over, 0, 6 * unit, (3 * unit, -4 * unit if over else 4 * unit), over)

    def arc(self, rises, rise, run, centre, over=None):
        """`rise` and `run` as lengths; `centre` as run and height from the start, for a quarter the height unsigned."""
        if over is None:
            # From a level the centre is over a rising start, from a wall it lies beside it.
            centre = (centre[0], centre[1] if rises else -centre[1])
            over = (centre[1] < 0) if centre[1] else rises
        clockwise = over
        same = self.gamma * self.sigma == (-1 if self.transverse else 1)
        code = "G02" if clockwise == same else "G03"
        double = 1 if self.transverse else 2        # heights of X are diameters
        along = 2 if self.transverse else 1
        height, to = self.height + double * rise, self.run + along * run
        infeed, cutting = ("K", "I") if self.transverse else ("I", "K")
        middle = {infeed: infeed + text(self.sigma * centre[1]), cutting: cutting + text(self.gamma * centre[0])}
        words = " ".join(middle[letter] for letter in "IK")
        self.lines.append((f"{code} {self.words(height, to)} {words}", None))
        self.go(height, to)
        self.top = max(self.top, height + double * run)


def contour(dice):
    writer = Writer(dice)
    first = f"{dice.one_of(('G00', 'G00', 'G01'))} {writer.words(writer.height, writer.run)}"
    start = (writer.height, writer.run)
    for _ in range(dice.between(1, 14)):
        writer.element()
    definition = ["NAT1 G82" if writer.transverse else "NAT1 G81", first]
    definition += [line + (f" E{text(dice.between(1, 900))}" if dice.once_in(6) else "") for line, _ in writer.lines]
    definition.append("G80" if dice.once_in(2) else definition.pop() + " G80")
    above = max(writer.top, start[0] + 1000) + writer.amount(0, 5) - writer.amount(0, 9)
    depth = max(100, (above - start[0]) // dice.between(1, 12)) if dice.once_in(2) else writer.amount(1, 9)
    call = [f"G85 NAT1 D{text(depth)}", f"F{text(dice.between(1, 900))}"]
    if dice.once_in(2):
        call.append(f"U{text(dice.between(0, 900))}")
    if dice.once_in(2):
        call.append(f"W{text(dice.between(0, 900))}")
    if dice.once_in(3):
        call += changes(dice, writer, start[0], above)
    if dice.once_in(6):
        call.append("M85")
    approach = [f"G00 {writer.words(above, start[1] - writer.amount(0, 4))}", " ".join(call), "G00 X900 Z900", "M02"]
    lines = definition + approach if dice.once_in(2) else approach + definition
    setup = ""
    if dice.once_in(3):
        setup += f"[parameters]\nlap_relief = {dice.between(0, 900)}\n"
    if dice.once_in(3):
        setup += '[readings]\ncontour_feed = "call"\n'
    return Program("\n".join(lines) + "\n", setup)


def changes(dice, writer, low, high):
    """Condition change points between the heights of start and AP start."""
    axis = "Z" if writer.transverse else "X"
    first, second = (low + (high - low) * part // 10 for part in (dice.between(5, 9), dice.between(1, 4)))
    words = ["G84"]
    for letter, height in (("A", first), ("B", second)):
        if letter == "A" and words != ["G84"] or dice.once_in(3):
            continue
        words.append(f"{axis}{letter}={text(writer.sigma * height)}")
        if dice.once_in(2):
            words.append(f"D{letter}={text(dice.between(500, 5000))}")
        if dice.once_in(2):
            words.append(f"F{letter}={text(dice.between(1, 900))}")
    return words if len(words) > 1 else []

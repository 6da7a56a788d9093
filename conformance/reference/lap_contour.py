"""The geometry of a LAP contour ("How LAP runs", section 8): elements, pieces, and the points that a level meets.

Points have a height h, against the infeed, and a run s, in the sense of the cut; lengths in mm, X halved. Heights and
runs are fractions or roots.
"""
from fractions import Fraction as Q
from typing import NamedTuple

from exact import sign
from roots import Root


class Element(NamedTuple):
    """A line, or an arc about a centre (s, h); `clockwise` seen with s to the right and h up."""
    start: tuple
    end: tuple
    centre: tuple = None
    clockwise: bool = False
    feed: Q = None

    def forward(self):
        """Whether it does not go back along the cutting axis."""
        if self.centre is None:
            return self.end[0] >= self.start[0]
        over = all((point[1] - self.centre[1]) * (1 if self.clockwise else -1) >= 0 for point in (self.start, self.end))
        return over and self.end[0] > self.start[0]

    def square(self):
        """Of the radius, which is that of the start."""
        return sum((a - b) ** 2 for a, b in zip(self.start, self.centre))

    def pieces(self, index):
        if self.centre is None or not self.start[0] < self.centre[0] < self.end[0]:
            return [Piece(index, self, self.start, self.end)]
        top = (self.centre[0], Root(self.centre[1], Q(1 if self.clockwise else -1), self.square()))
        return [Piece(index, self, self.start, top), Piece(index, self, top, self.end)]


class Piece(NamedTuple):
    """A part of an element along which the height changes in one sense; ends are (s, h)."""
    element: int
    of: Element
    start: tuple
    end: tuple

    def sense(self):
        """1 if it rises, -1 if it falls."""
        return (self.end[1] > self.start[1]) - (self.end[1] < self.start[1])

    def run_at(self, level):
        """The run of the point at a level between the heights of the ends."""
        for run, height in (self.start, self.end):
            if height == level:
                return run
        if self.of.centre is None:
            (s0, h0), (s1, h1) = self.start, self.end
            return s0 + (s1 - s0) * (level - h0) / (h1 - h0)
        centre = self.of.centre
        square = max(self.of.square() - (level - centre[1]) ** 2, Q(0))
        side = -1 if self.start[0] < centre[0] else 1
        run = Root(centre[0], Q(side), square)
        return min(max(run, Root(self.start[0])), Root(self.end[0]))


class Point(NamedTuple):
    """A point of the contour: the piece, its height there and its run; the end of a piece is the start of the next."""
    piece: int
    height: Q
    run: Q


class Contour:
    def __init__(self, elements):
        self.elements = elements
        self.pieces = [piece for index, element in enumerate(elements) for piece in element.pieces(index)]

    def start(self):
        return Point(0, self.pieces[0].start[1], self.pieces[0].start[0])

    def end(self):
        run, height = self.pieces[-1].end
        return Point(len(self.pieces), height, run)

    def goes_back(self):
        vertical = [element.start[0] == element.end[0] for element in self.elements]
        walls = [sign(element.end[1] - element.start[1]) if up else 0 for element, up in zip(self.elements, vertical)]
        return not all(element.forward() for element in self.elements) or \
            any(a * b < 0 for a, b in zip(walls, walls[1:]))

    def descents(self):
        senses = [piece.sense() for piece in self.pieces if piece.sense()]
        return sum(now < 0 <= before for before, now in zip([1] + senses, senses))

    def point(self, index, level):
        """Of a piece at a level."""
        piece = self.pieces[index]
        if piece.end[1] == level and piece.start[1] != level:
            return Point(index + 1, level, piece.end[0])
        return Point(index, level, piece.run_at(level))

    def at_or_behind(self, point, other):
        """Whether `other` comes not before `point`."""
        if point.piece != other.piece or point.piece == len(self.pieces):
            return other.piece >= point.piece
        return (Root(0) if self.pieces[point.piece].sense() == 0 else
                other.height >= point.height if self.pieces[point.piece].sense() > 0 else
                other.height <= point.height)

    def up(self, point, level):
        """The first point at or behind a point that is not below a level."""
        if point.height >= level:
            return point
        for index in range(point.piece, len(self.pieces)):
            if self.pieces[index].end[1] >= level:
                return self.point(index, level)
        return None

    def down(self, point, level):
        """The first point at or behind a point, not below a level, behind which the contour falls below it at once."""
        for index in range(point.piece, len(self.pieces)):
            piece = self.pieces[index]
            start = point.height if index == point.piece else piece.start[1]
            if start >= level > piece.end[1]:
                return point if index == point.piece and start == level else Point(index, level, piece.run_at(level))
        return None

    def above(self, point, level):
        """The first point behind a point, not below a level, before which there is a point below it."""
        if point.height < level:
            return self.up(point, level)
        fallen = self.down(point, level)
        return fallen and self.behind(fallen, level)

    def behind(self, fallen, level):
        """The first point not below a level behind the one in which the contour has fallen below it."""
        for index in range(fallen.piece + 1, len(self.pieces)):
            if self.pieces[index].end[1] >= level:
                return self.point(index, level)
        return None

    def along(self, point, to):
        """The parts of elements from one point to another: the element, and the end of the part as (s, h)."""
        parts = []
        for index in range(point.piece, min(to.piece + 1, len(self.pieces))):
            piece = self.pieces[index]
            if index == to.piece and (to.height, to.run) == (piece.start[1], piece.start[0]):
                break
            end = (to.run, to.height) if index == to.piece else piece.end
            if parts and parts[-1][0] == piece.element:
                parts.pop()
            parts.append((piece.element, end))
        return parts

    def highest(self, point, to):
        """The greatest height from one point to another."""
        ends = [self.pieces[index].end[1] for index in range(point.piece, to.piece)]
        return max([as_root(point.height), as_root(to.height)] + [as_root(end) for end in ends])


def as_root(value):
    return value if isinstance(value, Root) else Root(value)

"""Where rs274 goes, as the positions of an event: without compensation the programmed point, in compensation the tip.

In compensation rs274 prints where the tip goes and nothing of what was programmed. The programmed points come from
the same program without G41 and G42; the nose centre lies from the tip as far as the tool table says. At an outside
corner rs274 inserts a motion of its own round the programmed point: that one has no programmed point, and says in
`detail` what it is, as does the motion before it.
"""

from decimal import Decimal

# rs274 prints four decimals; what comes of some of them may be off by this much.
NEAR = Decimal("0.0003")

INSERTED, BEFORE_INSERTED = "inserted round the corner", "ends before an inserted corner"


class Path:
    """The motions so far. Points are X, as a radius, and Z."""

    def __init__(self, noses, programmed):
        self.noses = noses
        self.programmed = programmed
        self.nose = 0
        self.is_compensated = False
        self.previous = self.corner = None

    def positions(self, line, end, centre=None):
        """The fields of a motion of the block in a line."""
        if not self.is_compensated:
            self.previous = self.corner = None
            return {"program": point(end), **centre_fields(centre)}
        way = self.noses.to_centre(self.nose)
        end_of_nose = plus(end, way)
        centre_of_nose = centre and plus(centre, way)
        fields = {"tip": point(end), "nose": point(end_of_nose), **centre_fields(centre_of_nose)}
        target = self.programmed.get(line)
        if self.is_inserted(target, end_of_nose, centre_of_nose, max(map(abs, way))):
            self.previous["detail"] = BEFORE_INSERTED
            return {**fields, "detail": INSERTED}
        if target:
            fields["program"] = point(target)
        self.previous, self.corner = fields, target
        return fields

    def is_inserted(self, target, end, centre, radius):
        """Whether a motion goes round the programmed point at which the one before it ends."""
        if not self.corner or not radius:
            return False
        if centre:
            return distance(centre, self.corner) < NEAR
        return target != self.corner and abs(distance(end, self.corner) - radius) < NEAR


def plus(start, way):
    return start[0] + way[0], start[1] + way[1]


def distance(one, other):
    return ((one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2).sqrt()


def point(place):
    return {"x": str(2 * place[0]), "z": str(place[1])}


def centre_fields(centre):
    return {"centre_x": str(2 * centre[0]), "centre_z": str(centre[1])} if centre else {}

#!/usr/bin/env python3
"""Writes a corpus of compensated contours, with the reference's own traces, for a campaign against rs274.

The start-up lies on the extension of the first element and cancelling is a motion of its own, as both manuals
advise, so that the corners between are reached. Everything is on the grid of the E100L: directions come from
Pythagorean triples. What the corpus expects is only what the reference does, so that it proves nothing by itself.

    contours.py --count 500 --turnspec turnspec > contours/contours.json
"""

import argparse
import json
import random
import subprocess
from fractions import Fraction

FORMAT = "0.2.0"
TRIPLES = [(1, 0, 1), (0, 1, 1), (3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13)]
UNITS = [(Fraction(a * p, c), Fraction(b * q, c)) for a, b, c in TRIPLES for p in (1, -1) for q in (1, -1)]
# A multiple of this times a unit vector is on the grid.
STEP = Fraction(65, 100)
RADII = ["0.2", "0.4", "0.8", "1.2"]
SHAPES = [(1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1), (0, 0)]
FEATURES = ["arc", "coolant", "feed", "linear", "radius-compensation", "rapid", "tool"]
# Positions first, so that a divergence is named by the point that differs.
FIELDS = [("program", "x", "x"), ("program", "z", "z"), ("tip", "x", "tx"), ("tip", "z", "tz"), ("nose", "x", "nx"),
          ("nose", "z", "nz"), (None, "sense", "sense"), (None, "centre_x", "cx"), (None, "centre_z", "cz"),
          (None, "on", "on"), (None, "code", "code"), (None, "name", "name")]
SENSES = {"clockwise": "cw", "counter_clockwise": "ccw"}


def main():
    options = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=500)
    options.add_argument("--turnspec", default="turnspec", help="the command of the reference")
    options = options.parse_args()
    dice = random.Random(options.seed)
    cases = [case(number, dice, options.turnspec) for number in range(options.count)]
    print(json.dumps({"format": FORMAT, "cases": cases}, indent=1))


def case(number, dice, turnspec):
    radius, (x, z) = Fraction(dice.choice(RADII)), dice.choice(SHAPES)
    setup = {"nose_radius": [{"number": 1, "x": float(radius * x), "z": float(radius * z)}]}
    program = contour(dice)
    task = {"protocol": 1, "id": "contour", "control": "e100l", "program": program, "setup": setup}
    answer = subprocess.run([turnspec, "answer"], input=json.dumps(task), capture_output=True, text=True, check=False)
    return {
        "id": f"e100l/contour-{number:05}", "title": "A compensated contour", "rules": ["E100L-NRC-13"], "control": "e100l",
        "features": FEATURES, "flags": ["constructed"], "source": "", "basis": "manual", "repairs": "",
        "program": program, "setup": setup, "expect": [line(json.loads(text)) for text in answer.stdout.splitlines()],
        "stated": [], "derivation": "",
    }


def contour(dice):
    """A start on the extension of the first element, lines and arcs, and the way out."""
    side = dice.choice([41, 42])
    inside = 1 if side == 41 else -1
    place, heading = (Fraction(dice.randint(-50, 50)), Fraction(dice.randint(60, 120))), dice.choice(UNITS)
    before = along(place, heading, -STEP * dice.randint(8, 16))
    lines = [f"G00 {words(before)} T010101", f"G{side} G01 {words(place)} F0.2"]
    for number in range(dice.randint(2, 6)):
        if number:
            heading = turned(dice, heading, inside)
        if dice.random() < 0.35:
            text, place, heading = arc(dice, place, heading)
        else:
            place = along(place, heading, STEP * dice.randint(6, 30))
            text = f"G01 {words(place)}"
        lines.append(text)
        if dice.random() < 0.15:
            lines.append(dice.choice(["M08", "M09", "", "(REMARK)"]))
    return "\n".join([*lines, "G40 G00 X300 Z300", "M02", ""])


def turned(dice, heading, inside):
    """Straight on, or into another direction, more often to the side of the tool."""
    if dice.random() < 0.25:
        return heading
    other = dice.choice([unit for unit in UNITS if cross(heading, unit) and unit != heading])
    return mirrored(other, heading) if cross(heading, other) * inside < 0 and dice.random() < 0.8 else other


def mirrored(unit, axis):
    """A direction on the other side of another one, if it is among ours; else the square one on that side."""
    way = 2 * (unit[0] * axis[0] + unit[1] * axis[1])
    image = (way * axis[0] - unit[0], way * axis[1] - unit[1])
    square = (-axis[1], axis[0]) if cross(axis, unit) < 0 else (axis[1], -axis[0])
    return image if image in UNITS else square


def arc(dice, place, heading):
    """An arc that leaves in a direction: its block, its end and the direction there."""
    sense = dice.choice([2, 3])
    turn = 1 if sense == 3 else -1
    to_centre = (-turn * heading[1], turn * heading[0])
    radius = STEP * dice.randint(2, 20)
    centre = along(place, to_centre, radius)
    outward = dice.choice([unit for unit in UNITS if unit != (-to_centre[0], -to_centre[1])])
    end = along(centre, outward, radius)
    text = f"G0{sense} {words(end)} I{number_text(centre[1] - place[1])} K{number_text(centre[0] - place[0])}"
    return text, end, (-turn * outward[1], turn * outward[0])


def along(place, direction, length):
    return place[0] + direction[0] * length, place[1] + direction[1] * length


def cross(one, other):
    return one[0] * other[1] - one[1] * other[0]


def words(place):
    return f"X{number_text(2 * place[1])} Z{number_text(place[0])}"


def number_text(value):
    return f"{float(value):.3f}"


def line(event):
    """An event in compact notation, as far as rs274 has something to say about it."""
    parts = [event["kind"]]
    for group, key, name in FIELDS:
        fields = event.get(group) if group else event
        value = fields.get(key) if isinstance(fields, dict) else None
        if value is not None and not (name == "name" and event["kind"] != "alarm"):
            parts.append(f"{name}={SENSES.get(value, str(value).lower() if isinstance(value, bool) else value)}")
    return " ".join([*parts, f"line={event['block']['line']}", "rules=" + "+".join(event["rules"])])


if __name__ == "__main__":
    main()

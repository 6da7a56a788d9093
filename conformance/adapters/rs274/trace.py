"""The canonical calls that rs274 prints, as events of a trace.

A call is the order to a machine, such as `STRAIGHT_FEED(5.0000, 0.0000, -10.0000, …)`. X is a radius there.
"""

import re
from decimal import Decimal

CALL = re.compile(r"\s*\d+\s+N(\d+|\.+)\s+(\w+)\((.*)\)\s*")
FAULT_PLACE = re.compile(r"/?\s*N(\d+)\b")

SPINDLE = {
    "START_SPINDLE_CLOCKWISE": "clockwise",
    "START_SPINDLE_COUNTERCLOCKWISE": "counter_clockwise",
    "STOP_SPINDLE_TURNING": "stop",
}
# Orders that no event of ours stands for; comments are among them.
WITHOUT_EVENT = {"COMMENT", "MIST_OFF", "SET_SPINDLE_MODE", "USE_LENGTH_UNITS", "SELECT_PLANE", "ON_RESET"}
# The first order of the reset that rs274 makes of M2 and M30.
RESET = "SET_G5X_OFFSET"


class UnknownCall(Exception):
    """A call that the shared words cannot lead to."""


class Machine:
    """What the orders so far have made of the machine, and the events that they stand for."""

    def __init__(self, blocks, optional_stop):
        self.blocks = {block.line: block for block in blocks}
        self.optional_stop = optional_stop
        self.spindle, self.speed = "stop", "0"
        self.feed, self.feed_unit = "0", "mm/min"
        self.is_resetting = self.has_ended = False
        self.code_of_end = "M02"
        self.events = []

    def take(self, line_of_output):
        """Takes one line of the output; calls of the prelude bear no number and leave no event."""
        found = CALL.fullmatch(line_of_output)
        if not found:
            raise UnknownCall(line_of_output)
        number, name, arguments = found.groups()
        block = None if number.startswith(".") else self.blocks[int(number)]
        event = self.event(name, [text.strip() for text in arguments.split(",")], block)
        if event and block:
            self.events.append({**event, "block": place(block)})

    def event(self, name, arguments, block):
        if block and name == RESET:
            self.is_resetting = True
        if self.is_resetting:
            return self.reset(name)
        if name in SPINDLE:
            self.spindle = SPINDLE[name]
            return self.spindle_event()
        if name == "SET_SPINDLE_SPEED":
            self.speed = arguments[1]
            return self.spindle_event()
        if name == "SET_FEED_MODE":
            self.feed_unit = "mm/rev" if arguments[1] == "1" else "mm/min"
        elif name == "SET_FEED_RATE":
            self.feed = arguments[0]
        elif name in ("FLOOD_ON", "FLOOD_OFF"):
            return {"kind": "coolant", "on": name == "FLOOD_ON"}
        elif name == "DWELL":
            return {"kind": "dwell", "time": arguments[0]}
        elif name == "PROGRAM_STOP":
            return {"kind": "stop"}
        elif name == "OPTIONAL_PROGRAM_STOP":
            return {"kind": "optional_stop"} if self.optional_stop else None
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"):
            return self.motion(name, arguments) if block and block.moves() else None
        elif block and name not in WITHOUT_EVENT:
            raise UnknownCall(name)
        return None

    def motion(self, name, arguments):
        feed = {"value": self.feed, "unit": self.feed_unit}
        if name == "ARC_FEED":
            end_z, end_x, centre_z, centre_x, turns = arguments[:5]
            return {
                "kind": "arc",
                "program": {"x": diameter(end_x), "z": end_z},
                "sense": "clockwise" if turns.startswith("-") else "counter_clockwise",
                "centre_x": diameter(centre_x),
                "centre_z": centre_z,
                "feed": feed,
            }
        position = {"x": diameter(arguments[0]), "z": arguments[2]}
        if name == "STRAIGHT_TRAVERSE":
            return {"kind": "rapid", "program": position}
        return {"kind": "linear", "program": position, "feed": feed}

    def spindle_event(self):
        speed = "0" if self.spindle == "stop" else self.speed
        return {"kind": "spindle", "spindle": "main", "state": self.spindle, "speed": speed}

    def reset(self, name):
        """Of the reset only the end counts; M30 shows by the change of the pallet."""
        if name == "PALLET_SHUTTLE":
            self.code_of_end = "M30"
        if name != "PROGRAM_END":
            return None
        self.has_ended = True
        return {"kind": "end", "code": self.code_of_end}

    def alarm(self, messages):
        """The event of the fault that rs274 reports: its message, and the block if it names one."""
        message, *rest = messages
        found = FAULT_PLACE.match(rest[0]) if rest else None
        block = self.blocks.get(int(found[1])) if found and not message.startswith("File ended") else None
        return {"kind": "alarm", "name": "rs274", "detail": message, **({"block": place(block)} if block else {})}


def place(block):
    return {"line": block.line, **({"sequence": block.sequence} if block.sequence else {})}


def diameter(radius):
    return str(2 * Decimal(radius))

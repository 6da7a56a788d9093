"""The canonical calls that rs274 prints, as events of a trace.

A call is the order to a machine, such as `STRAIGHT_FEED(5.0000, 0.0000, -10.0000, …)`. X is a radius there.
"""

import re
from decimal import Decimal

CALL = re.compile(r"\s*\d+\s+N[\d.]+\s+(\w+)\((.*)\)\s*")
# The comment that the translation put into each block.
MARK = re.compile(r'"@(\d+)"')
COMPENSATION = re.compile('"interpreter: cutter radius compensation (on|off)')
FAULT_PLACE = re.compile(r"/?\s*N(\d+)\b")

SPINDLE = {
    "START_SPINDLE_CLOCKWISE": "clockwise",
    "START_SPINDLE_COUNTERCLOCKWISE": "counter_clockwise",
    "STOP_SPINDLE_TURNING": "stop",
}
TOOL_CALLS = {"SELECT_TOOL", "START_CHANGE", "CHANGE_TOOL"}
# Orders that no event of ours stands for; the plane is among them.
WITHOUT_EVENT = {"MIST_OFF", "SET_SPINDLE_MODE", "USE_LENGTH_UNITS", "SELECT_PLANE", "ON_RESET"}
# The first order of the reset that rs274 makes of M2 and M30.
RESET = "SET_G5X_OFFSET"


class UnknownCall(Exception):
    """A call that the shared words cannot lead to."""


class Machine:
    """What the orders so far have made of the machine, and the events that they stand for."""

    def __init__(self, blocks, optional_stop, path):
        self.blocks = {block.line: block for block in blocks}
        self.optional_stop = optional_stop
        self.path = path
        self.block = None
        self.spindle, self.speed = "stop", "0"
        self.feed, self.feed_unit = "0", "mm/min"
        self.tool = 0
        self.is_changing = self.is_resetting = self.has_ended = False
        self.code_of_end = "M02"
        self.events = []
        self.programmed = {}

    def take(self, line_of_output):
        """Takes one line of the output; calls of the prelude come before the first mark and leave no event."""
        found = CALL.fullmatch(line_of_output)
        if not found:
            raise UnknownCall(line_of_output)
        name, arguments = found.groups()
        event = self.event(name, [text.strip() for text in arguments.split(",")])
        if event and self.block:
            event["block"] = place(self.block)
            self.events.append(event)

    def event(self, name, arguments):
        if self.block and name == RESET:
            self.is_resetting = True
        if self.is_resetting:
            return self.reset(name)
        if name in SPINDLE:
            return self.spindle_call(name)
        if name in TOOL_CALLS:
            return self.tool_call(name, arguments)
        if name == "COMMENT":
            return self.comment(arguments[0])
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
            return self.motion(name, arguments) if self.block else None
        elif self.block and name not in WITHOUT_EVENT:
            raise UnknownCall(name)
        return None

    def comment(self, text):
        """A mark says whose calls follow; rs274 itself tells in comments when compensation begins and ends."""
        if mark := MARK.fullmatch(text):
            self.block = self.blocks[int(mark[1])]
        elif state := COMPENSATION.match(text):
            self.path.is_compensated = state[1] == "on"

    def tool_call(self, name, arguments):
        """A change of tools, during which rs274 stops the spindle; the E100L does not."""
        self.is_changing = name == "START_CHANGE"
        if name == "SELECT_TOOL":
            self.tool = int(arguments[0])
        elif name == "CHANGE_TOOL":
            self.path.nose = self.tool

    def motion(self, name, arguments):
        if name == "ARC_FEED":
            end_z, end_x, centre_z, centre_x = map(Decimal, arguments[:4])
            turn = "clockwise" if arguments[4].startswith("-") else "counter_clockwise"
            event = {"kind": "arc", "sense": turn}
            event = self.moved(event, (end_x, end_z), (centre_x, centre_z))
        else:
            end = Decimal(arguments[0]), Decimal(arguments[2])
            event = self.moved({"kind": "rapid" if name == "STRAIGHT_TRAVERSE" else "linear"}, end)
        if event["kind"] != "rapid":
            event["feed"] = {"value": self.feed, "unit": self.feed_unit}
        return event

    def moved(self, event, end, centre=None):
        """The event with the positions of the motion, which remain those that the path knows."""
        positions = self.path.positions(self.block.line, end, centre)
        positions.update(event)
        if not self.path.is_compensated:
            self.programmed[self.block.line] = end
        return positions

    def spindle_call(self, name):
        if self.is_changing:
            return None
        self.spindle = SPINDLE[name]
        return self.spindle_event()

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

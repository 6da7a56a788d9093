"""What a block does beside its motion: modes, feed, tool, M codes and stops (steps 1 to 6 and 8)."""
from decimal import Decimal as D

from events import Alarm, Event
from path import Path
from waiting import Waiting
from words import GROUPS

POWER_ON = {"motion": "G00", "plane": "G18", "dimension": "G90", "feed_unit": "G95", "compensation": "G40"}
RESET_ORDER = ("motion", "dimension", "feed_unit", "compensation", "plane")
RULES_OF_MODES = {"compensation": ["NRC-01"], "plane": ["CRC-01"]}
RULES_OF_RESET = {"compensation": ["NRC-01"], "plane": ["CRC-04"]}


class Functions:
    def __init__(self, setup):
        self.setup, self.path, self.waiting = setup, Path(setup), Waiting(setup.start)
        self.modes, self.feed, self.nose = dict(POWER_ON), None, 0
        self.joined = False     # whether the C axis is joined (M110)

    def codes_and_words(self, block):
        for g in block.g:
            group = next((group for group, codes in GROUPS.items() if g in codes), None)
            if group and self.modes[group] != g:
                self.select(block, group, g, RULES_OF_MODES.get(group, []))
        if "F" in block.words and block.shot != "G04":
            self.feed = block.words["F"]
            if not D("0.001") <= self.feed <= D("99999.999"):
                raise Alarm("address_range", "ADDR-01", block.place)
        if "S" in block.words:
            self.emit("spindle", block)
        if "T" in block.words:
            self.tool(block, int(block.words["T"]))
        for m in block.m:
            self.miscellaneous(block, m)

    def select(self, block, group, code, rules):
        previous, self.modes[group] = self.modes[group], code
        if {code, previous} == {"G41", "G42"}:
            rules = rules + ["NRC-61"]
        self.emit("mode", block, {"group": group, "code": code, "previous": previous}, rules)

    def tool(self, block, word):
        self.nose, tool, offset = word // 10000, word // 100 % 100, word % 100
        self.emit("tool", block, {"tool": str(tool), "offset": str(offset), "nose": str(self.nose)})
        if self.path.select_offset(offset):
            self.emit("frame", block, {"cause": "tool_offset"})

    def miscellaneous(self, block, m):
        if m in ("M03", "M04", "M05"):
            self.emit("spindle", block)
        elif m in ("M08", "M09"):
            self.emit("coolant", block, {"on": "true" if m == "M08" else "false"})
        elif m in ("M109", "M110"):
            self.emit("aux", block, {"code": m})
            self.joined = m == "M110"
            if m == "M109" and self.modes["plane"] != "G18":
                self.select(block, "plane", "G18", ["CRC-03"])

    def stops(self, block):
        if "M00" in block.m:
            self.emit("stop", block)
        if "M01" in block.m and self.setup.switch("optional_stop"):
            self.emit("optional_stop", block)

    def finish(self, block, code):
        self.waiting.finish()
        for group in RESET_ORDER:
            if self.modes[group] != POWER_ON[group]:
                self.select(block, group, POWER_ON[group], RULES_OF_RESET.get(group, []))
        self.emit("end", block, {"code": code})

    def emit(self, kind, block, fields=None, rules=()):
        self.waiting.emit(Event(kind, fields or {}, list(rules), block.place))

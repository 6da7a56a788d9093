"""What is refused before anything of a block is carried out: the checks of the chapter on execution.

They use the modes that the block's own words select. The first that fails is the alarm.
"""
from events import Alarm, Unsupported
from words import CHAMFERS


class Check:
    """The checks of a block; `before` and `modes` are the modes without and with its own words."""

    def __init__(self, block, before, modes, setup):
        self.block, self.words, self.place, self.setup = block, block.words, block.place, setup
        self.before, self.now, self.plane = before["compensation"], modes["compensation"], modes["plane"]
        self.mode = modes["motion"]
        self.arc = self.mode in ("G02", "G03")
        self.begins, self.ends = self.before == "G40" != self.now, self.now == "G40" != self.before

    def refuse(self, condition, name, rule, detail=None):
        if condition:
            raise Alarm(name, rule, self.place, detail)

    def all(self, joined):
        alone = len(self.block.g) + len(self.block.m) + len(self.words) == 1
        self.refuse("M110" in self.block.m and not alone, "not_alone", "MCODE-24")
        self.one_shot()
        self.motion()
        self.without_function()
        self.plane_and_compensation(joined)
        if self.block.shot == "G50" and self.block.has("XZC"):
            raise Unsupported("zero shift")

    def one_shot(self):
        shot, words = self.block.shot, self.words
        self.refuse(shot == "G04" and "F" not in words, "word_missing", "DWELL-01")
        self.refuse(shot == "G50" and not self.block.has("XZCS"), "word_missing", "G50-01")
        if shot in CHAMFERS:
            self.chamfer(shot)

    def chamfer(self, shot):
        self.refuse(self.mode != "G01", "chamfer_not_linear", "CHAM-05")
        self.refuse(self.setup.chamfering == "off", "chamfer_disabled", "CHAM-01")
        self.refuse(not self.words.get("L"), "word_missing", {"G75": "CHAM-02", "G76": "CHAM-10"}[shot])
        if self.setup.chamfering != "basic":
            raise Unsupported("any-angle chamfer")
        self.refuse(("X" in self.words) == ("Z" in self.words), "chamfer_axes", "CHAM-08")

    def motion(self):
        """Check 4, of arcs; a motion block has a word of the motion and no one-shot code but G75 and G76."""
        words, block = self.words, self.block
        if not self.arc or block.shot or not block.has("XZCIKL"):
            return
        if "L" in words:
            self.refuse(block.has("IK"), "arc_radius_and_centre", "CIRC-15")
            self.refuse(words["L"] <= 0, "arc_radius_not_positive", "CIRC-13")
            self.refuse("X" not in words or "Z" not in words, "arc_radius_needs_both", "CIRC-14")
            return
        self.refuse(not words.get("I") and not words.get("K"), "arc_without_centre", "CIRC-06")
        self.refuse(not block.has("XZ"), "unspecified", "CIRC-07", "circle")

    def without_function(self):
        """Check 5."""
        shot = self.block.shot
        if shot:
            taken = {"G04": "F", "G50": "XZCS"}.get(shot, "XZL")
        else:
            taken = "XZIKL" if self.arc else "XZCIK" if self.begins or self.ends else "XZC"
        useless = next((letter for letter in self.block.letters if letter not in taken + "FST"), None)
        self.refuse(useless, "word_without_function", "ADDR-01", useless)

    def plane_and_compensation(self, joined):
        """Check 6."""
        g, words, linear = self.block.g, self.words, "compensation_not_linear"
        planes = {"G17", "G18", "G119"} & set(g)
        side = next((code for code in g if code in ("G41", "G42")), None)
        self.refuse(planes - {"G18"} and not joined, "c_axis_not_joined", "CRC-02")
        self.refuse(planes and self.before != "G40" and not self.ends, "plane_change_in_compensation", "CRC-13")
        if side and self.plane != "G18":
            raise Unsupported("cutter radius compensation")
        self.refuse((self.begins or self.ends) and self.arc, linear, "NRC-19" if self.begins else "NRC-72")
        nowhere = self.block.has("IK") and not words.get("I") and not words.get("K")
        rule = "NRC-24" if self.begins else "NRC-70"
        self.refuse((self.begins or self.ends) and nowhere, "compensation_imaginary_point", rule)
        shot = self.block.shot
        fixed = shot == "G50" and self.block.has("XZC") and self.now != "G40"
        self.refuse(fixed, "compensation_not_allowed", "NRC-81")
        self.refuse(self.begins and shot in ("G04", "G50"), "unspecified", "NRC-20", "start_up")

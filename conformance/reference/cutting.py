"""A part program that cuts threads, from its first line to its end ("How thread cutting runs", and what it stands on).

The subset: G00, G01, G04, G31 to G35, G50, G71, G72, G90, G91, G94 to G97, the words of these, S and the M codes of
threads, in the metric systems on machines without W axis, without tools, variables and expressions.
"""
from fractions import Fraction as Q

from depths import Refused, depths
from events import Alarm
from exact import MICRO_DEGREE, NANOMETRE, latch, rounded, rounded_product_with_tangent, sign
from machining import POWER_ON, Machining, number
from passes import Machine, Pass, check_lead_at_end, steps_of
from thread_setup import ThreadSetup
from thread_words import COMPOUND, LEGS, PASSES, Block, blocks_of, check


def trace_of(program, setup):
    """The events of a program with a set-up (a table as in a set-up file); `Unsupported` outside the subset."""
    return Control(ThreadSetup(setup)).run(program)


class Control(Machining):
    def run(self, program):
        line = 0
        try:
            for (line, name), items in blocks_of(program):
                self.count_step((line, ""))
                if items:
                    block = Block((line, name), items, self.setup.unit)
                    if self.carry_out(block):
                        return self.trace
            raise Alarm("no_program_end", "PROG-02", (line + 1, ""))
        except Alarm as alarm:
            self.trace.append(alarm.event())
        return self.trace

    def carry_out(self, block):
        """A block; whether it ends the program."""
        modes = self.modes | {group: block.selected(group) for group in POWER_ON if block.selected(group)}
        motion_code = block.selected("motion")
        check(block, modes, self.m, bool(motion_code) or self.cycle is None, self.setup.any_angle)
        for code in block.g:
            self.g_code(block, code)
        cuts = block.cuts(self.modes["motion"])
        self.feed_words(block, lead=block.shot in COMPOUND or not block.shot and self.modes["motion"] in PASSES + LEGS)
        self.g50(block)
        if "S" in block.words and block.shot != "G50":
            self.speed = block.words["S"]
            self.emit("spindle", block)
        for code in block.m:
            self.m_code(block, code)
        if block.shot == "G04":
            self.emit("dwell", block, {"time": number(block.words["F"])})
        elif block.shot in COMPOUND:
            self.compound(block)
        elif cuts and self.modes["motion"] in PASSES:
            self.single(block)
        elif cuts:
            self.leg(block)
        elif not block.shot and block.has("XZ"):
            self.straight(block)
        return self.stop_or_end(block)

    def leg(self, block):
        lead, words = self.lead(block), block.words
        axis, change = "x" if "M27" in block.m else "z", words.get("E", Q(0))
        change = -change if self.modes["motion"] == "G35" else change
        start = Q(0) if self.chain else words.get("C", Q(0))
        self.chain = True
        (x, z), (sx, sz), axes = self.target(block), self.present(), [letter for letter in "XZ" if letter in words]
        if "A" in words:
            angle, axes = words["A"], "XZ"
            if angle % 180 == (0 if z is None else 90):
                raise Alarm("angle_no_intersection", "DTAP-04", block.place)
            if z is None:
                z = latch(sz + rounded_product_with_tangent((x - sx) / 2, 90 - angle, NANOMETRE))
            else:
                x = latch(sx + rounded_product_with_tangent(2 * (z - sz), angle, NANOMETRE))
        end = (sx if x is None else x, sz if z is None else z)
        length = self.setup.k * abs(end[0] - sx) if axis == "x" else abs(end[1] - sz)
        if not length:
            raise Alarm("unspecified", "G34-04", block.place, "length")
        check_lead_at_end(lead, change, length, block.place)
        rules = ["G34-01", "G34-04"] + (["G34-03"] if "F" not in words else []) + (["G34-05"] if start else [])
        rules += ["G33-09", "G34-02"] if change else []
        self.move(block, "thread", end, self.thread_fields(lead, axis, change, start), rules + self.divided(), axes)

    def single(self, block):
        """G31, G32, G33."""
        lead, words, mode = self.lead(block), block.words, self.modes["motion"]
        face, follows = mode == "G32", self.cycle is not None
        taper_letter, shift_letter = ("K", "I") if face else ("I", "K")
        kept = self.cycle or {"taper": ("amount", Q(0)), "shift": Q(0), "L": None, "E": Q(0), "pass": 0,
                              "C": words.get("C", Q(0))}
        (x, z), kept = self.target(block), dict(kept)
        kept |= {"x": x} if x is not None else {}
        kept |= {"z": z} if z is not None else {}
        if taper_letter in words:
            kept["taper"] = ("amount", words[taper_letter] * (1 if face else 2))
        elif "A" in words:
            kept["taper"] = ("angle", words["A"])
        kept["shift"] = words.get(shift_letter, kept["shift"])
        kept |= {letter: words[letter] for letter in "LE" if letter in words}
        kept["pass"] += 1
        self.cycle = kept
        sx, sz = self.present()
        start, end, level = ((sx, sz), kept["x"], kept["z"]) if face else ((sz, sx), kept["z"], kept["x"])
        given = Pass(block.place, "x" if face else "z", start, end, level, sign(start[1] - level), kept["taper"],
                     kept["shift"], Q(0), lead, kept["E"], kept["L"])
        own = {"G31": ["G33-04", "G33-02"], "G32": ["G32-02"], "G33": ["G33-04"]}[mode]
        own += [("G32-04" if face else "G33-03")] if follows else []
        thread = ["G32-03" if face else "G33-08"] + (["G33-10"] if kept["C"] else [])
        self.cut(block, given, kept["pass"], kept["C"], own, {"thread": thread})

    def compound(self, block):
        """G71 and G72 (section 6)."""
        lead, words, face = self.lead(block), block.words, block.shot == "G72"
        self.chain = False
        (x, z), (sx, sz) = self.target(block), self.present()
        start, end, level = ((sx, sz), x, z) if face else ((sz, sx), z, x)
        side = sign(start[1] - level)
        if not side:
            raise Alarm("unspecified", "G33-04", block.place, "side")
        h, b, starts = words["H"], words.get("B", Q(0)), max(1, int(words.get("Q", 1)))
        amount = words.get("K", Q(0)) if face else 2 * words.get("I", Q(0))
        taper = ("angle", words["A"]) if "A" in words else ("amount", amount)
        infeed = self.m["thread_infeed"]
        try:
            all_depths = depths(self.m["thread_pattern"], infeed == "M33", words["D"], h,
                                h - words.get("W" if face else "U", 0), self.setup.m75_pattern, self.setup.equal_area)
        except Refused as refused:
            raise Alarm("unspecified", str(refused), block.place, "M75") from None
        own = ["G72-01", "G72-02"] if face else ["G71-01", "G71-03"]
        own += ["TMUL-02"] if starts > 1 else []
        change = words.get("E", Q(0))
        for n, depth in enumerate(all_depths, 1):
            above = h - depth.value
            minus = (infeed == "M32" or infeed == "M33" and n % 2 == 1) == self.setup.flank_negative
            flank = rounded_product_with_tangent(above * (2 if face else Q(1, 2)), b / 2, NANOMETRE)
            flank = -flank if minus else flank
            for k in range(starts):
                if n > 1 or k > 0:
                    self.count_step(block.place)
                angle = rounded(Q(360 * k, starts), MICRO_DEGREE)
                work = [] if face else ["G71-02", "TINF-08"]
                work += list(depth.rules) or ["G72-03" if face else "G71-07"]
                if flank:
                    work += ["TMOD-01", "TMOD-02", "TMOD-04" if infeed == "M33" else "TMOD-03"]
                thread = ["G32-03" if face else "G33-08"] + (["TMUL-01"] if angle else [])
                extra = {"work": work, "thread": thread + (["G71-05"] if change else []), "taper": ["G71-04"],
                         "approach": ["G71-10"], "exit": ["G72-03" if face else "G71-06"]}
                if n == len(all_depths) and k == starts - 1:
                    extra["return"] = ["G72-03" if face else "G71-08"]
                given = Pass(block.place, "x" if face else "z", start, end, level + side * above, side, taper, Q(0),
                             flank, lead, change, words.get("L"))
                self.cut(block, given, n, angle, own, extra)

    def cut(self, block, given, ordinal, start, own, extra):
        """A pass; `extra`: the rules of its parts, beside its own."""
        speed, clamped = self.spindle_speed()
        machine = Machine(self.setup.k, self.setup.withdrawal, self.setup.taper_from_start, self.setup.toward_end,
                          self.m["thread_chamfer"] == "M23", speed)
        steps, common = steps_of(given, machine)
        tapers = "G33-05" in common or "G33-06" in common
        work = extra.get("work", []) + common + (extra.get("taper", []) if tapers else [])
        cutting = extra["thread"] + self.divided() + (["G33-09"] if given.change else [])
        for step in steps:
            end = step.end if given.axis == "x" else step.end[::-1]
            if end == self.present():
                continue
            rules = own + list(step.rules) + (work if step.part != "return" else []) + extra.get(step.part, [])
            fields = {"pass": str(ordinal), "part": step.part}
            if step.kind == "thread":
                rules += cutting + (clamped if step.part == "exit" else [])
                fields |= self.thread_fields(step.lead, given.axis, given.change, start)
            elif step.kind == "linear":
                fields["f"] = number(self.setup.withdrawal) + "mm/min"
            self.move(block, step.kind, end, fields, rules)

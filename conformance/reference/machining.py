"""What a block does beside cutting threads: modes, F and J, zero shift, S, M codes, G00 and G01; and how a motion is
tested and made.
"""
from fractions import Fraction as Q

from events import Alarm, Event
from exact import NANOMETRE, PICOMETRE, rounded, rounded_root
from passes import LEADS
from thread_words import GROUPS, LARGEST, LEGS, M_GROUPS

POWER_ON = {"motion": "G00", "dimension": "G90", "feed_unit": "G95", "cutting_speed": "G97"}
M_POWER_ON = {"thread_chamfer": "M22", "thread_infeed": "M32", "thread_pattern": "M73", "spindle": "M05"}
MODE_RULES = {"G31": "G33-02", "G32": "G32-01", "G33": "G33-01", "G34": "G34-01", "G35": "G34-01"}
UNITS = {"G94": "mm/min", "G95": "mm/rev"}
ZERO = (Q(0), Q(0))


def number(value):
    """As decimal text without superfluous zeros."""
    whole = value * 10**9
    if whole.denominator > 1:
        raise AssertionError("a number that was not rounded")
    text = f"{abs(whole.numerator):010}"
    return ("-" if value < 0 else "") + f"{text[:-9]}.{text[-9:]}".rstrip("0").rstrip(".")


class Machining:
    def __init__(self, setup):
        self.setup, self.trace = setup, []
        self.modes, self.m = dict(POWER_ON), dict(M_POWER_ON)
        self.machine, self.shift = setup.start, ZERO        # (x, z)
        self.feed = None        # value, J, and whether it counts per revolution
        self.speed, self.clamp = Q(0), None
        self.cycle, self.chain, self.steps = None, False, 0

    def count_step(self, place):
        self.steps += 1
        if self.steps > self.setup.steps:
            raise Alarm("step_limit", "GOTO-03", place)

    def g_code(self, block, code):
        group = next(group for group, codes in GROUPS.items() if code in codes)
        if group == "motion":
            self.cycle = None
            self.chain = self.chain and code in LEGS
        if group != "one_shot" and self.modes[group] != code:
            self.select(block, group, code, [MODE_RULES[code]] if code in MODE_RULES else [])

    def select(self, block, group, code, rules=()):
        previous, self.modes[group] = self.modes[group], code
        self.emit("mode", block, {"group": group, "code": code, "previous": previous}, rules)

    def feed_words(self, block, lead):
        words, per_revolution = block.words, lead or self.modes["feed_unit"] == "G95"
        if "F" in words and block.shot != "G04":
            if not Q(1, 1000) <= words["F"] <= LARGEST:
                raise Alarm("address_range", "ADDR-01", block.place)
            self.feed = (words["F"], words.get("J", Q(1)), per_revolution)
        elif "J" in words and self.feed:
            self.feed = (self.feed[0], words["J"], self.feed[2])

    def g50(self, block):
        if block.shot != "G50":
            return
        if block.has("XZ"):
            self.shift = tuple(shift + present - block.words.get(letter, present)
                               for letter, shift, present in zip("XZ", self.shift, self.present()))
            self.emit("frame", block, {"cause": "zero_shift"})
        if "S" in block.words:
            self.clamp = block.words["S"]
            self.emit("spindle", block)

    def m_code(self, block, code):
        group = next(group for group, codes in M_GROUPS.items() if code in codes)
        if group == "program":
            return
        self.m[group] = code
        if group in ("spindle", "coolant"):
            self.emit(group, block)
        else:
            self.emit("aux", block, {"code": code, "group": group})

    def stop_or_end(self, block):
        if "M00" in block.m:
            self.emit("stop", block)
        end = next((code for code in block.m if code in ("M02", "M30")), None)
        if end:
            for group in POWER_ON:
                if self.modes[group] != POWER_ON[group]:
                    self.select(block, group, POWER_ON[group])
            if self.shift != ZERO:
                self.emit("frame", block, {"cause": "zero_shift"})
            self.emit("end", block, {"code": end})
        return bool(end)

    # Motions.

    def frame(self):
        return tuple(zero + shift for zero, shift in zip(self.setup.zero, self.shift))

    def present(self):
        return tuple(machine - frame for machine, frame in zip(self.machine, self.frame()))

    def target(self, block):
        base = self.present() if self.modes["dimension"] == "G91" else ZERO
        return tuple(b + block.words[letter] if letter in block.words else None for b, letter in zip(base, "XZ"))

    def straight(self, block):
        """G00 and G01."""
        end = tuple(p if t is None else t for t, p in zip(self.target(block), self.present()))
        rapid = self.modes["motion"] == "G00"
        feed = {}
        if not rapid:
            if self.feed is None:
                raise Alarm("no_feed", "G01-03", block.place)
            feed = {"f": number(rounded(self.feed[0], PICOMETRE)) + UNITS[self.modes["feed_unit"]]}
        self.move(block, "rapid" if rapid else "linear", end, feed, cut_back=True)

    def move(self, block, kind, end, fields, rules=(), axes="XZ", cut_back=False):
        machine = []
        if any(abs(end["XZ".index(letter)]) > LARGEST for letter in axes):
            raise Alarm("coordinate_range", "ADDR-01", block.place)
        for letter, e, frame in zip("xz", end, self.frame()):
            machine.append(e + frame)
            low, high = self.setup.limits(letter) if letter.upper() in axes else (None, None)
            if low is not None and machine[-1] < low:
                raise Alarm("travel_limit_negative", "LIM-02", block.place)
            if high is not None and machine[-1] > high:
                if not cut_back:
                    raise Alarm("travel_limit_positive", "LIM-01", block.place)
                machine[-1] = high
        (mx, mz), (x, z) = machine, (m - frame for m, frame in zip(machine, self.frame()))
        fields = {"x": number(x), "z": number(z), "mx": number(mx), "mz": number(mz)} | fields
        if kind == "linear":
            dx, dz = ((a - b) for a, b in zip(machine, self.machine))
            fields["path"] = number(rounded_root((self.setup.k * dx)**2 + dz**2, NANOMETRE))
        self.machine = tuple(machine)
        self.emit(kind, block, fields, rules)

    def lead(self, block):
        """Section 4, 2."""
        if self.feed is None or not self.feed[2]:
            raise Alarm("no_feed", "THRD-04", block.place)
        lead = rounded(rounded(self.feed[0], PICOMETRE) / self.feed[1], PICOMETRE)
        if not LEADS[0] <= lead <= LEADS[1]:
            raise Alarm("thread_lead_range", "THRD-04", block.place)
        return lead

    def spindle_speed(self):
        """N."""
        if self.m["spindle"] == "M05":
            return Q(0), []
        if self.clamp is not None and self.setup.clamp_always and self.speed > self.clamp:
            return rounded(self.clamp, Q(1, 1000)), ["SMAX-01"]
        return rounded(self.speed, Q(1, 1000)), []

    def divided(self):
        return ["THRD-06"] if self.feed[1] != 1 else []

    @staticmethod
    def thread_fields(lead, axis, change, start):
        fields = {"lead": number(lead), "axis": axis}
        fields |= {"change": number(change)} if change else {}
        return fields | ({"start": number(start)} if start else {})

    def emit(self, kind, block, fields=None, rules=()):
        self.trace.append(Event(kind, fields or {}, list(rules), block.place))

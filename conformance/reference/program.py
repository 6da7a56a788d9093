"""A part program in compensation: what each block does, what waits for later blocks, and when it is released.

The subset: G00 to G04, G17, G18, G40 to G42, G75 and G76 (basic form), G90, G91, G94, G95, G119,
X Z C I K F S T M; 1 mm system, no variables, no expressions, G97.
"""
import re
from decimal import Decimal as D

from corner import Element, add, contact, corner, cross, latch, length, sign, sub, unit

LINES = ("rapid", "linear")


class Alarm(Exception):
    """name, rule, place (line, sequence name), detail"""


class Unsupported(Exception):
    """The program leaves the subset."""


class Motion:
    """A motion event: P in program coordinates (z, X as a diameter), the frame, and later the tip."""

    def __init__(self, run, kind, point, place, axes=True):
        self.kind, self.point, self.place, self.axes = kind, point, place, axes
        self.frame, self.limits, self.v = run.frame(), run.limits, run.nose()[1]
        self.nose = self.tip = None
        self.compensated = run.modes["compensation"] != "G40"
        self.fields, self.rules = ({} if kind == "rapid" else {"f": run.feed}), []

    def settle(self, relative, v):
        """The nose centre, given relative to P, and with it the tip (NRC-07)."""
        self.nose = (latch(self.point[0] + relative[0]), latch(self.point[1] + 2 * relative[1]))
        self.tip = (self.nose[0] - v[0], self.nose[1] - 2 * v[1])
        if max(abs(c) for c in self.tip) > D("99999.999"):
            raise Alarm("coordinate_range", "ADDR-01", self.place)
        for axis, c in (("x", self.tip[1] + self.frame[1]), ("z", self.tip[0] + self.frame[0])):
            limit = self.limits.get(axis, {})
            if c < D(str(limit.get("negative", -10**9))):
                raise Alarm("travel_limit_negative", "NRC-80", self.place)
            if c > D(str(limit.get("positive", 10**9))):
                raise Alarm("travel_limit_positive", "NRC-80", self.place)


def number(value):
    text = format(value.normalize() + 0, "f")
    return "0" if text == "-0" else text


class Run:
    def __init__(self, program, setup):
        if "readings" in setup:
            raise Unsupported("readings")
        self.setup, self.trace, self.held = setup, [], []
        self.modes = {"motion": "G00", "plane": "G18", "dimension": "G90", "feed_unit": "G95",
                      "compensation": "G40"}
        self.limits, self.feed, self.noses, self.offsets = setup.get("limits", {}), None, 0, 0
        start = setup.get("start", {})
        self.machine = (self.of(start, "z"), self.of(start, "x"))   # machine position of P
        self.axes = self.machine                                    # machine position of the tip
        self.joined, self.leaving, self.c = False, False, D(0)
        self.last = self.pending = self.after = None
        self.idle = 0
        try:
            for line, text in enumerate(program.splitlines(), 1):
                if self.block(line, re.sub(r"\(.*?\)", "", text)):
                    return
            raise Alarm("no_program_end", "PROG-02", (line + 1, ""))
        except Alarm as alarm:
            name, rule, place = alarm.args[:3]
            detail = {"detail": alarm.args[3]} if len(alarm.args) > 3 else {}
            self.trace.append(("alarm", {"name": name} | detail, [rule], place))

    @staticmethod
    def of(table, key):
        return D(str(table.get(key, 0)))

    def entry(self, table, index):
        found = next((e for e in self.setup.get(table, []) if e["number"] == index), {}) if index else {}
        return (self.of(found, "z"), self.of(found, "x"))

    def frame(self):
        zero = self.setup.get("zero_offset", {})
        return add((self.of(zero, "z"), self.of(zero, "x")), self.entry("tool_offset", self.offsets))

    def nose(self):
        """R and v (NRC-04, NRC-05)."""
        v = self.entry("nose_radius", self.noses)
        return max(abs(v[0]), abs(v[1])), v

    # Holding and releasing.

    def emit(self, kind, fields, rules, place):
        (self.held if self.pending or self.compensating else self.trace).append((kind, fields, rules, place))

    def release(self):
        held, self.held = self.held, []
        for event in held:
            self.trace.append(self.shown(event[0]) if isinstance(event[0], Motion) else event)

    def shown(self, m):
        """The event of a motion whose end is known; the axes go there."""
        point, fields = m.point, {}
        if m.compensated and not m.axes:
            m.tip = sub(self.axes, m.frame)
            m.nose = add(m.tip, (m.v[0], 2 * m.v[1]))
        target = add(m.tip or point, m.frame) if m.tip or m.axes else self.axes
        fields.update(x=number(point[1]), z=number(point[0]), mx=number(target[1]), mz=number(target[0]))
        if m.compensated:
            fields.update(tx=number(m.tip[1]), tz=number(m.tip[0]), nx=number(m.nose[1]), nz=number(m.nose[0]))
        if m.kind == "linear" and "c" not in m.fields:
            dz, dx = sub(target, self.axes)
            fields["path"] = number(latch(length((dz, dx / 2))))
        self.axes = target
        rules = (["NRC-07"] if m.compensated else []) + m.rules
        if m.compensated and m.kind == "linear":
            rules.append("NRC-42")
        return m.kind, fields | m.fields, rules, m.place

    def settle(self, relative, v, rules):
        """The end of the pending motion is known: it and what is held behind it are released."""
        self.pending.settle(relative, v)
        self.pending.rules += rules
        self.pending = None
        self.release()

    def end_in_contact(self, rule):
        """The pending motion ends where nothing follows."""
        if self.after == "start":
            raise Alarm("unspecified", "NRC-15", self.pending.place, "start_up")
        if self.after == "repeat":
            self.settle(contact(self.last), self.last.v, ["NRC-46"])
        else:
            self.settle(contact(self.last), self.last.v, [rule])

    def meet(self, element):
        """An element follows: the pending motion ends in the corner with it."""
        if element.too_small():
            raise Alarm("compensation_arc_too_small", "NRC-48", self.place)
        if self.pending is None and self.last is not None:      # NRC-46: the extra motion
            motion, place = self.extra, self.extra.place
            relative, rules = self.common(self.last, element, place)
            old = contact(self.last)
            if any(latch(p) != latch(q) for p, q in zip((relative[0], 2 * relative[1]), (old[0], 2 * old[1]))):
                if motion.kind == "linear" and not motion.fields["f"]:
                    raise Alarm("no_feed", "G01-03", place)
                motion.settle(relative, self.last.v)
                motion.rules = ["NRC-46"] + rules
                self.held.insert(0, (motion,))
            self.release()
        elif self.after == "start" and self.imaginary is None:
            self.settle(contact(element, True), self.pending.v,
                        ["NRC-15", "NRC-18"] if element.centre else ["NRC-15"])
        elif self.pending:
            i = self.imaginary if self.after == "start" else self.last
            relative, rules = self.common(i, element, self.pending.place)
            extra = {"start": ["NRC-23"], "repeat": ["NRC-46"]}.get(self.after, [])
            self.settle(relative, self.pending.v if self.after == "start" else i.v,
                        extra + rules + (["NRC-43"] if self.idle else []))

    def common(self, i, j, place):
        relative, rules = corner(i, j)
        if relative is None:
            raise Alarm("compensation_no_intersection", "NRC-53", place)
        return relative, rules

    # Blocks.

    def block(self, line, text):
        text = text.replace("$", " ")
        name = re.match(r"\s*(N\w+)", text)
        self.place = place = (line, name.group(1) if name else "")
        body = text[name.end():] if name else text
        if not body.strip() or re.fullmatch(r"\s*[O:]\w+\s*", body) or body.strip().startswith("/"):
            return False
        words = re.findall(r"([A-Z])\s*=?\s*([+-]?[\d.]+)", body)
        if "".join(a + b for a, b in words) != re.sub(r"[\s=]", "", body):
            raise Unsupported(body)
        if not {a for a, _ in words} <= set("GMXZCIKLFST") or ("M", "100") in words:
            raise Unsupported(body)
        g = ["G%02d" % int(v) for a, v in words if a == "G"]
        m = ["M%02d" % int(v) for a, v in words if a == "M"]
        w = {a: D(v) for a, v in words if a not in "GM"}
        before = self.modes["compensation"]
        modes = dict(self.modes)
        groups = {"motion": "G00 G01 G02 G03", "plane": "G17 G18 G119", "dimension": "G90 G91",
                  "feed_unit": "G94 G95", "compensation": "G40 G41 G42"}
        shots = [c for c in g if c in ("G04", "G28", "G50", "G75", "G76")]
        for code in g:
            group = next((k for k, codes in groups.items() if code in codes.split()), None)
            if group:
                modes[group] = code
            elif code not in shots and code != "G22":
                raise Unsupported(code)
        if any(len(set(codes.split()) & set(g)) > 1 for codes in groups.values()):
            raise Unsupported("two codes of a group")
        now = modes["compensation"]
        start, cancel = before == "G40" != now, now == "G40" != before
        self.compensating = before != "G40"     # events of this block are held
        self.check(g, w, modes, shots, start, cancel, before)
        if "G50" in g and {"X", "Z", "C"} & set(w) or {"G22", "G28"} & set(g):
            raise Unsupported("one-shot code")
        for code in g:
            for group, codes in groups.items():
                if code in codes.split() and self.modes[group] != code:
                    self.mode(group, code)
        if "F" in w and "G04" not in g:
            self.feed = number(w["F"]) + ("mm/rev" if modes["feed_unit"] == "G95" else "mm/min")
        if "S" in w:
            self.emit("spindle", {}, [], place)
        if "T" in w:
            self.tool(int(w["T"]))
        for code in m:
            self.miscellaneous(code)
        self.side = {"G40": 0, "G41": 1, "G42": -1}[now]
        self.motion(w, g, shots, start, cancel)
        stop = next((c for c in m if c in ("M02", "M30")), None)
        if stop:
            self.finish(stop)
            return True
        if {"M00", "M01"} & set(m):
            on = "M00" in m or self.setup.get("switches", {}).get("optional_stop")
            if on:
                self.emit("stop" if "M00" in m else "optional_stop", {}, [], place)
        self.finish_block(before, now, modes["motion"])
        return False

    def finish_block(self, before, now, motion_mode):
        """A block without X and Z motion counts (NRC-22, NRC-43, NRC-44)."""
        if before != "G40" and now != "G40" and not self.moved:
            self.idle += 1
            kind = "rapid" if motion_mode == "G00" else "linear"
            z, x = sub(self.machine, self.frame())
            self.extra = Motion(self, kind, (z, x), self.place)     # NRC-46, should it be needed
            if self.pending and self.idle == 2:
                if self.after == "start":
                    raise Alarm("compensation_start_up", "NRC-22", self.pending.place)
                self.end_in_contact("NRC-44")
        self.compensating = False
        if not self.pending:
            self.release()

    def check(self, g, w, modes, shots, start, cancel, before):
        place, arc = self.place, modes["motion"] in ("G02", "G03")
        if ("I" in w or "K" in w) and not arc and not ((start or cancel) and not shots):
            raise Alarm("word_without_function", "ADDR-01", place, "I" if "I" in w else "K")
        if {"G17", "G119"} & set(g) and not self.joined:
            raise Alarm("c_axis_not_joined", "CRC-02", place)
        planes = {"G17", "G18", "G119"} & set(g)
        if planes and before != "G40" != modes["compensation"]:
            raise Alarm("plane_change_in_compensation", "CRC-13", place)
        sides = [c for c in g if c in ("G41", "G42")]
        if sides and modes["plane"] != "G18":
            raise Alarm("not_modelled", "CRC-14", place, sides[0])
        if (start or cancel) and arc:
            raise Alarm("compensation_not_linear", "NRC-19" if start else "NRC-72", place)
        if (start or cancel) and ("I" in w or "K" in w) and not w.get("I") and not w.get("K"):
            raise Alarm("compensation_imaginary_point", "NRC-24" if start else "NRC-70", place)
        if "G50" in g and {"X", "Z", "C", "W"} & set(w) and modes["compensation"] != "G40":
            raise Alarm("compensation_not_allowed", "NRC-81", place)
        if start and set(shots) - {"G75", "G76"}:
            raise Alarm("unspecified", "NRC-20", place, "start_up")
        if "G22" in g and (before != "G40" or modes["compensation"] != "G40" or self.leaving):
            raise Alarm("unspecified", "NRC-81", place, "G22")

    def mode(self, group, code, plane_rule="CRC-01"):
        rules = {"compensation": ["NRC-01"], "plane": [plane_rule]}.get(group, [])
        if {code, self.modes[group]} == {"G41", "G42"}:
            rules = rules + ["NRC-61"]
        self.emit("mode", {"group": group, "code": code, "previous": self.modes[group]}, rules, self.place)
        self.modes[group] = code

    def tool(self, value):
        nose, number_, offset = value // 10000, value // 100 % 100, value % 100
        self.emit("tool", {"tool": str(number_), "offset": str(offset), "nose": str(nose)}, [], self.place)
        old = self.entry("tool_offset", self.offsets)
        self.noses, self.offsets = nose, offset
        if self.entry("tool_offset", offset) != old:
            self.emit("frame", {"cause": "tool_offset"}, [], self.place)

    def miscellaneous(self, code):
        if code in ("M00", "M01", "M02", "M30"):
            return
        kind = {"M03": "spindle", "M04": "spindle", "M05": "spindle", "M08": "coolant", "M09": "coolant"}
        self.emit(kind.get(code, "aux"), {} if code in kind else {"code": code}, [], self.place)
        if code in ("M109", "M110"):
            self.joined = code == "M110"
            if code == "M109" and self.modes["plane"] != "G18":
                self.mode("plane", "G18", "CRC-03")

    def motion(self, w, g, shots, start, cancel):
        """Step 7."""
        self.moved = bool({"X", "Z"} & set(w)) and not set(shots) - {"G75", "G76"}
        self.cites = ["NRC-14"] if start else []
        if "G04" in shots:
            self.emit("dwell", {"time": number(w["F"])}, [], self.place)
        elements = self.elements(w, shots) if self.moved else []
        if cancel:
            for e in elements:
                self.event(e)       # its own tests come before the end of the pending motion
            if "C" in w and not self.moved and not self.joined:
                raise Alarm("c_axis_not_joined", "CAX-02", self.place)
            if self.pending:
                self.cancel(w)
            self.compensating = False
            self.release()
            self.last, self.after, self.leaving = None, None, True
        if not self.moved and not start:
            if "C" in w and not set(shots):
                self.c_motion(w)
            return
        point = sub(self.machine, self.frame())
        if self.side == 0:
            for e in elements:
                self.plain(e, cancel)
            return
        self.leaving = False
        if start:
            self.begin(w, elements, point)
            elements = elements[1:]
        for e in elements:
            if e.start == e.end:
                self.repeat(e)
            else:
                self.compensated(e)

    def cancel(self, w):
        """NRC-66, NRC-69, NRC-71: the pending motion before a block with G40."""
        if self.after == "element" and ("I" in w or "K" in w):
            line = Element("linear", (D(0), D(0)), (w.get("K", D(0)), w.get("I", D(0))))
            line.s, line.R, line.v = self.last.s, self.last.R, self.last.v
            relative, rules = self.common(self.last, line, self.pending.place)
            self.settle(relative, self.last.v, ["NRC-69"] + rules + (["NRC-43"] if self.idle else []))
        else:
            self.end_in_contact("NRC-66" if self.moved else "NRC-71")

    def plain(self, e, cancel):
        """A motion in G40: the tip goes to P (NRC-06, NRC-66, NRC-71)."""
        if self.leaving and not cancel and e.centre and self.axes != self.machine:
            raise Alarm("unspecified", "NRC-71", self.place, "arc")
        m = self.event(e)
        if self.leaving and not cancel:
            m.rules.append("NRC-71")
        elif cancel:
            m.rules.append("NRC-66")
        self.leaving, cancel = False, False
        z, x = add(m.point, m.frame)
        for axis, c in (("x", x), ("z", z)):
            if c < D(str(self.limits.get(axis, {}).get("negative", -10**9))):
                raise Alarm("travel_limit_negative", "LIM-02", self.place)
        x = min(x, D(str(self.limits.get("x", {}).get("positive", 10**9))))
        z = min(z, D(str(self.limits.get("z", {}).get("positive", 10**9))))
        self.machine, m.point = (z, x), sub((z, x), m.frame)
        self.trace.append(self.shown(m))

    def event(self, e):
        m = Motion(self, e.kind, (e.end[0], 2 * e.end[1]), self.place)
        if e.kind != "rapid" and self.feed is None:
            raise Alarm("no_feed", "G01-03", self.place)
        if e.centre:
            m.fields.update(sense="ccw" if e.sigma > 0 else "cw", cx=number(2 * e.centre[1]), cz=number(e.centre[0]))
        return m

    def begin(self, w, elements, point):
        """The start-up block (NRC-14 to NRC-24)."""
        kind = "rapid" if self.modes["motion"] == "G00" else "linear"
        here = (point[0], point[1] / 2)
        e = elements[0] if elements else Element(kind, here, here)
        if e.centre:
            raise Alarm("compensation_not_linear", "NRC-19", self.place)
        m = self.event(e)
        m.rules += self.cites + (["NRC-20"] if e.start == e.end else [])
        self.imaginary, (R, v) = None, self.nose()
        if "I" in w or "K" in w:
            self.imaginary = Element("linear", (w.get("K", D(0)), w.get("I", D(0))), (D(0), D(0)))
            self.imaginary.s, self.imaginary.R, self.imaginary.v = self.side, R, v
        self.hold(m, "start", v)

    def hold(self, motion, after, v):
        self.machine = add(motion.point, motion.frame)
        motion.v = v
        self.pending, self.after, self.idle = motion, after, 0
        self.held.append((motion,))

    def compensated(self, e):
        R, v = self.nose()
        e.s, e.R, e.v = self.side, R, v
        m = self.event(e)
        m.rules += {"rapid": ["NRC-41"], "arc": ["NRC-48", "NRC-60"]}.get(e.kind, [])
        self.meet(e)
        self.last = e
        self.hold(m, "element", v)

    def repeat(self, e):
        """NRC-45: a block repeats the present point."""
        m = self.event(e)
        if self.after == "start" and self.pending:
            raise Alarm("compensation_start_up", "NRC-21", self.pending.place)
        if self.pending:
            self.end_in_contact("NRC-45")
        self.release()
        self.hold(m, "repeat", self.last.v)

    def c_motion(self, w):
        if not self.joined:
            raise Alarm("c_axis_not_joined", "CAX-02", self.place)
        kind = "rapid" if self.modes["motion"] == "G00" else "linear"
        m = Motion(self, kind, sub(self.machine, self.frame()), self.place, axes=False)
        m.fields["c"] = number(w["C"] % 360)
        if self.compensating or self.pending:
            self.held.append((m,))
        else:
            self.trace.append(self.shown(m))

    def elements(self, w, shots):
        """The motion of the block, as if there were no compensation."""
        z, x = sub(self.machine, self.frame())
        base = (z, x) if self.modes["dimension"] == "G91" else (D(0), D(0))
        ez = base[0] + w["Z"] if "Z" in w else z
        ex = base[1] + w["X"] if "X" in w else x
        if max(abs(ez), abs(ex)) > D("99999.999"):
            raise Alarm("coordinate_range", "ADDR-01", self.place)
        start, end = (z, x / 2), (ez, ex / 2)
        code = self.modes["motion"]
        if shots:
            if self.setup.get("parameters", {}).get("chamfering") != "basic":
                raise Unsupported("any-angle chamfer")
            return self.chamfer(start, end, w["L"], shots[0], "X" in w)
        if code in ("G00", "G01"):
            return [Element(LINES[int(code[2])], start, end)]
        if "L" in w:
            raise Unsupported("arc by radius")
        centre = (z + w.get("K", D(0)), x / 2 + w.get("I", D(0)))
        if abs(length(sub(start, centre)) - length(sub(end, centre))) > D("0.02"):
            raise Alarm("arc_radius_mismatch", "CIRC-11", self.place)
        return [Element("arc", start, end, centre, 1 if code == "G03" else -1)]

    def chamfer(self, start, end, size, code, along_x):
        """G75 and G76 in the basic form (CHAM-03)."""
        u = unit(sub(end, start))
        other = (D(1), D(0)) if along_x else (D(0), D(1))
        b, d = add(end, u, -abs(size)), add(end, other, size)
        first = [Element("linear", start, b)] if b != start else []
        if code == "G75":
            return first + [Element("linear", b, d)]
        centre = add(b, other, size)
        return first + [Element("arc", b, d, centre, sign(cross(u, sub(d, end))))]

    def finish(self, code):
        """M02 and M30: what is pending ends in contact, then the reset (NRC-44)."""
        if self.pending:
            self.end_in_contact("NRC-44")
        self.pending, self.compensating = None, False
        self.release()
        for group, value in (("motion", "G00"), ("dimension", "G90"), ("feed_unit", "G95"),
                             ("compensation", "G40"), ("plane", "G18")):
            if self.modes[group] != value:
                self.mode(group, value, "CRC-04")
        self.trace.append(("end", {"code": code}, [], self.place))

"""What waits for later blocks: the motion whose end is not known yet, and the events that are held behind it.

States, endings and their order are those of the section "Radius compensation" of the chapter on execution.
"""
from corner import Element, contact, corner
from events import Alarm, Event
from plane import ZERO, latch

START, ELEMENT, REPETITION = "start-up", "element", "repetition"


class Waiting:
    def __init__(self, axes):
        self.trace, self.held = [], []
        self.axes = axes                    # machine position of the tip
        self.motion = self.kind = None      # the motion that waits, and what it is
        self.last = None                    # the last element
        self.imaginary = None               # imaginary line of the start-up
        self.extra = None                   # the extra motion of NRC-46, should it have to be made
        self.idle = 0                       # blocks without X/Z motion since the motion waits
        self.holding = False                # the events of the present block are held, whatever waits

    # Events.

    def emit(self, event):
        self.held.append(event)
        if not self.motion and not self.holding:
            self.release()

    def release(self):
        held, self.held = self.held, []
        for event in held:
            if not isinstance(event, Event):
                event, self.axes = event.event(self.axes)
            self.trace.append(event)

    def drop(self, alarm):
        self.held = []
        self.trace.append(alarm.event())

    # What begins to wait.

    def start_up(self, motion, imaginary):
        self.last, self.imaginary = None, imaginary
        self.wait(motion, START)

    def element(self, motion, element):
        """An element: it ends the motion before, then waits itself."""
        self.meet(element, motion.place)
        self.last = element
        self.wait(motion, ELEMENT)

    def repetition(self, motion):
        """NRC-21, NRC-45."""
        if self.motion and self.kind == START:
            raise Alarm("compensation_start_up", "NRC-21", self.motion.place)
        if self.motion:
            self.end_in_contact("NRC-45")
        self.release()
        motion.v = self.last.v
        self.wait(motion, REPETITION)

    def wait(self, motion, kind):
        self.motion, self.kind, self.idle = motion, kind, 0
        self.held.append(motion)

    # How it ends.

    def end(self, relative, v, rules):
        self.motion.v = v
        self.motion.end_at(relative)
        self.motion.rules += rules
        self.motion = None
        self.release()

    def end_in_contact(self, rule):
        """Nothing follows that the motion could meet; `rule` says why. A repetition stays where it is."""
        if self.kind == START:
            raise Alarm("unspecified", "NRC-15", self.motion.place, "start_up")
        stays = self.kind == REPETITION
        self.end(contact(self.last), self.last.v, ["NRC-46" if stays else rule])

    def meet(self, element, place):
        """An element follows."""
        if element.too_small():
            raise Alarm("compensation_arc_too_small", "NRC-48", place)
        if self.motion is None:
            self.return_to_corner(element)
        elif self.kind == START and self.imaginary is None:
            rules = ["NRC-15", "NRC-18"] if element.centre else ["NRC-15"]
            self.end(contact(element, at_start=True), self.motion.v, rules)
        else:
            self.end_in_corner(element)

    def end_in_corner(self, element):
        before = self.imaginary if self.kind == START else self.last
        relative, rules = common_point(before, element, self.motion.place)
        cited = {START: ["NRC-23"], REPETITION: ["NRC-46"]}.get(self.kind, [])
        self.end(relative, before.v, cited + rules + self.one_idle())

    def one_idle(self):
        return ["NRC-43"] if self.idle else []

    def return_to_corner(self, element):
        """The extra motion of NRC-46, unless the tool is there already."""
        motion = self.extra
        relative, rules = common_point(self.last, element, motion.place)
        if latched(relative) != latched(contact(self.last)):
            if motion.kind == "linear" and "f" not in motion.fields:
                raise Alarm("no_feed", "G01-03", motion.place)
            motion.v = self.last.v
            motion.end_at(relative)
            motion.rules = ["NRC-46"] + rules
            self.held.insert(0, motion)
        self.release()

    # Blocks that are no elements.

    def count(self, extra):
        """A block without X/Z motion; `extra` is the extra motion that it would have to make."""
        self.idle, self.extra = self.idle + 1, extra
        if self.motion and self.idle == 2:
            if self.kind == START:
                raise Alarm("compensation_start_up", "NRC-22", self.motion.place)
            self.end_in_contact("NRC-44")

    def cancel(self, moves, direction):
        """NRC-66, NRC-69, NRC-71: a block ends compensation; `direction` is that of its I and K, if it has any."""
        if self.motion and self.kind == ELEMENT and direction:
            line = Element("linear", ZERO, direction).compensate(self.last.s, self.last.radius, self.last.v)
            relative, rules = common_point(self.last, line, self.motion.place)
            self.end(relative, self.last.v, ["NRC-69"] + rules + self.one_idle())
        elif self.motion:
            self.end_in_contact("NRC-66" if moves else "NRC-71")
        self.last, self.holding = None, False
        self.release()

    def finish(self):
        """The end of the program."""
        if self.motion:
            self.end_in_contact("NRC-44")
        self.holding = False
        self.release()


def common_point(i, j, place):
    relative, rules = corner(i, j)
    if relative is None:
        raise Alarm("compensation_no_intersection", "NRC-53", place)
    return relative, rules


def latched(relative):
    return latch(relative[0]), latch(2 * relative[1])

"""Whether expected lines in compact notation fit a trace, as far as this implementation computes it.

Fields that it does not compute and rules of other areas than its own do not count.
"""
import json
import re
import tomllib
from typing import Callable, NamedTuple

from events import Unsupported

EXAMPLE = re.compile(r"```nc\n(.*?)```\n(?:\s*```toml\n(.*?)```\n)?\s*```trace\n(.*?)```", re.S)
#: What a motion has not unless it is computed so.
MOTIONS = ("rapid", "linear", "arc", "thread")
OPTIONAL = ("tx", "tz", "nx", "nz", "pass", "part", "change", "start")


class Subject(NamedTuple):
    """What is computed, of which there are several."""
    trace_of: Callable  # from program and set-up; `Unsupported` outside the subset
    areas: tuple        # the areas of its rules, as in NRC-


def differs(line, event, areas):
    """Why an expected line does not fit an event; None if it does."""
    words = line.split()
    if words[0] != event.kind:
        return f"{event.kind} instead of {words[0]}"
    known = {"line": str(event.place[0]), "block": event.place[1]}
    known |= (dict.fromkeys(OPTIONAL, "-") if event.kind in MOTIONS else {}) | event.fields
    for key, value in (word.split("=", 1) for word in words[1:]):
        if key == "rules":
            missing = [rule for rule in rules_of(value.split("+"), areas) if rule not in event.rules]
            if missing:
                return f"rules {missing} not in {event.rules}"
        elif key in known and known[key] != value:
            return f"{key}={known[key]} instead of {value}"
    return None


def rules_of(ids, areas):
    """The ids of some areas, without the control."""
    short = (rule.removeprefix("E100L-") for rule in ids)
    return [rule for rule in short if rule.startswith(areas)]


def compare(lines, trace, areas):
    """Why the expected lines do not fit the trace; a line `...` stands for any number of events."""
    place = 0
    for index, line in enumerate(lines):
        if line == "...":
            following = lines[index + 1:]
            if not following:
                return None
            while place < len(trace) and differs(following[0], trace[place], areas):
                place += 1
            continue
        if place == len(trace):
            return f"`{line}`: the trace ends"
        reason = differs(line, trace[place], areas)
        if reason:
            return f"`{line}`: {reason}"
        place += 1
    return None if place == len(trace) else f"more events: {trace[place].text()}"


class Counts:
    """Of examples or cases: how many agree, leave the subset, differ."""

    def __init__(self, subject):
        self.subject = subject
        self.agree = self.outside = self.differ = 0

    def add(self, where, program, setup, lines):
        try:
            reason = compare(lines, self.subject.trace_of(program, setup), self.subject.areas)
        except Unsupported:
            self.outside += 1
            return
        if reason:
            self.differ += 1
            print(f"{where}: {reason}")
        else:
            self.agree += 1

    def __str__(self):
        return f"{self.agree} agree, {self.outside} outside the subset, {self.differ} differ"


def check_chapter(subject, path):
    """The examples of a chapter of the rules."""
    counts = Counts(subject)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for found in EXAMPLE.finditer(text):
        lines = [line.strip() for line in found[3].splitlines() if line.strip() and not line.startswith("#")]
        where = f"{path}:{text.count(chr(10), 0, found.start()) + 1}"
        counts.add(where, found[1], tomllib.loads(found[2] or ""), lines)
    print(f"{path}: {counts}")
    return counts


def check_cases(subject, paths):
    """Case files: their `expect` lines against their `program` and `setup`."""
    counts = Counts(subject)
    for path in paths:
        with open(path, encoding="utf-8") as file:
            case = json.load(file)
        counts.add(path, case["program"], case.get("setup", {}), case["expect"])
    print(f"cases: {counts}")
    return counts

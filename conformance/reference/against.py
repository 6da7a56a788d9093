"""Runs random programs through implementations and compares their traces, event by event, with those computed here.

Kinds, places, alarms with their details, rules of the areas and all fields that are computed here must be equal,
coordinates to the nanometre; a motion must not show what it has not, as tip and nose out of compensation.
"""
import json
import os
import shlex
import subprocess
import tempfile
import tomllib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from decimal import Decimal as D, InvalidOperation

from compare import MOTIONS, OPTIONAL, rules_of
from events import number

TIME_LIMIT = 60
NAMES = {"program": "", "machine": "m", "tip": "t", "nose": "n"}
SENSES = {"clockwise": "cw", "counter_clockwise": "ccw", "counterclockwise": "ccw"}


def check_random(subject, noun, chosen, seed, commands):
    """Whether each command agrees on all programs; prints what they reach, and the first difference in full.
    `noun`: what one of them is."""
    expected = [subject.trace_of(each.program, tomllib.loads(each.setup)) for each in chosen]
    print_reached(noun, expected)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for command in commands:
            answers = list(pool.map(lambda each: answer(command, each), chosen))
            reasons = [difference(*traces, subject.areas) for traces in zip(expected, answers)]
            print(f"{command}: {reasons.count(None)} of {len(chosen)} {noun}s agree")
            first = next((index for index, reason in enumerate(reasons) if reason), None)
            if first is not None:
                program, setup = chosen[first]
                print(f"{noun} {first + 1} of seed {seed} differs:\n{program}set-up:\n{setup}{reasons[first]}")
                return False
    return True


def print_reached(noun, traces):
    """How many traces end without alarm, and how many have each kind of event, alarm and rule."""
    reached = Counter()
    for trace in traces:
        reached.update({f"{event.kind} {event.fields.get('name', '')}".strip() for event in trace})
        reached.update({rule for event in trace for rule in event.rules})
    print(f"{len(traces)} {noun}s, {reached['end']} of them reach their end; how many reach what:")
    print(", ".join(f"{key} {reached[key]}" for key in sorted(reached)))


def answer(command, chosen):
    """The events that an implementation writes, as objects; or, as text, why there are none."""
    with tempfile.TemporaryDirectory() as directory:
        files = {"program": os.path.join(directory, "program.min"), "setup": os.path.join(directory, "setup.toml")}
        for name, path in files.items():
            with open(path, "w", encoding="ascii") as file:
                file.write(getattr(chosen, name))
        words = [word.format(**files) for word in shlex.split(command)]
        try:
            done = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=TIME_LIMIT)
            events = [json.loads(line) for line in done.stdout.splitlines()]
        except (OSError, ValueError, subprocess.TimeoutExpired) as fault:
            return f"no trace: {fault}"
    return events if done.returncode in (0, 1) else f"exit status {done.returncode}: {done.stderr}"


def difference(expected, got, areas):
    """The first difference of two traces in words, with its block; None if they agree."""
    if isinstance(got, str):
        return got
    for index, event in enumerate(expected):
        if index == len(got):
            return f"expected: {event.text()}\ngot: the end of the trace"
        reason = event_difference(event, got[index], areas)
        if reason:
            return f"{reason}\nexpected: {event.text()}\ngot: {json.dumps(got[index])}"
    return f"expected: the end of the trace\ngot: {json.dumps(got[len(expected)])}" if len(got) > len(expected) else None


def event_difference(event, got, areas):
    found, fields = compact(got), dict(event.fields)
    fields |= {"kind": event.kind, "line": str(event.place[0]), "block": event.place[1]}
    if event.kind in MOTIONS:
        fields = dict.fromkeys(OPTIONAL) | fields
    if event.kind == "alarm":
        fields = {"detail": None} | fields
    for key, value in fields.items():
        if found.get(key) != value:
            return f"line {event.place[0]}, {key}: expected {value}, got {found.get(key)}"
    rules = set(rules_of(got.get("rules") or [], areas))
    if rules != set(rules_of(event.rules, areas)):
        return f"line {event.place[0]}: expected rules {sorted(rules_of(event.rules, areas))}, got {sorted(rules)}"
    return None


def compact(got):
    """The fields of an event in compact notation."""
    fields = {key: plain(value) for key, value in got.items() if not isinstance(value, (dict, list))}
    for name, prefix in NAMES.items():
        point = got.get(name)
        fields |= {prefix + axis: plain(value) for axis, value in point.items()} if isinstance(point, dict) else {}
    block, feed = got.get("block") or {}, got.get("feed")
    fields |= {"line": plain(block.get("line")), "block": block.get("sequence") or ""}
    fields |= {"f": plain(feed["value"]) + feed["unit"]} if feed else {}
    fields |= {short: fields.get(name) for name, short in (("centre_x", "cx"), ("centre_z", "cz")) if name in fields}
    return fields | {"sense": SENSES.get(fields.get("sense"), fields.get("sense"))}


def plain(value):
    """Numbers without superfluous digits, the rest as text."""
    if isinstance(value, bool):
        return str(value).lower()
    try:
        return None if value is None else number(D(str(value)))
    except InvalidOperation:
        return value

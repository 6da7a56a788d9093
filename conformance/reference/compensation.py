#!/usr/bin/env python3
"""Tool nose radius compensation of the OSP-E100L, computed from the rule text alone.

    compensation.py PROGRAM [SETUP.toml]     prints the trace of a program in compact notation
    compensation.py --check CHAPTER.md...    compares the examples of the rule texts with it

A third opinion beside the oracle and the engine, for the subset of programs that program.py names. In
examples it compares the fields that it computes, and of the rules those of compensation and planes.
"""
import re
import sys
import tomllib

from program import Run, Unsupported


def text_of(event):
    kind, fields, rules, place = event
    words = [kind] + [f"{k}={v}" for k, v in fields.items()] + [f"line={place[0]}"]
    return " ".join(words + ([f"rules={'+'.join(dict.fromkeys(rules))}"] if rules else []))


def differs(line, event):
    """Why an expected line does not fit; fields outside this subset and rules of other areas do not count."""
    kind, fields, rules, place = event
    words = line.split()
    if words[0] != kind:
        return f"{kind} instead of {words[0]}"
    for key, value in (word.split("=", 1) for word in words[1:]):
        if key == "rules":
            ids = [r.removeprefix("E100L-") for r in value.split("+")]
            missing = [r for r in ids if r[:3] in ("NRC", "CRC") and r not in rules]
            if missing:
                return f"rules {missing} not in {rules}"
            continue
        known = {"line": str(place[0]), "block": place[1]} | fields
        if value == "-" and key in known or value != "-" and key in known and known[key] != value:
            return f"{key}={known[key]} instead of {value}"
    return None


def compare(expected, trace):
    lines = [line.strip() for line in expected.splitlines() if line.strip() and line.strip()[0] != "#"]
    place = 0
    for index, line in enumerate(lines):
        if line == "...":
            if index + 1 == len(lines):
                return None
            while place < len(trace) and differs(lines[index + 1], trace[place]):
                place += 1
            continue
        if place == len(trace):
            return f"`{line}`: the trace ends"
        reason = differs(line, trace[place])
        if reason:
            return f"`{line}`: {reason}"
        place += 1
    return None if place == len(trace) else f"more events: {text_of(trace[place])}"


EXAMPLE = re.compile(r"```nc\n(.*?)```\n(?:\s*```toml\n(.*?)```\n)?\s*```trace\n(.*?)```", re.S)


def check(path):
    text = open(path, encoding="utf-8").read()
    counts = {"agree": 0, "outside": 0, "differ": 0}
    for found in EXAMPLE.finditer(text):
        try:
            trace = Run(found[1], tomllib.loads(found[2] or "")).trace
            reason = compare(found[3], trace)
        except Unsupported:
            counts["outside"] += 1
            continue
        counts["differ" if reason else "agree"] += 1
        if reason:
            print(f"{path}:{text.count(chr(10), 0, found.start()) + 1}: {reason}")
    print(path, counts)
    return counts["differ"]


if __name__ == "__main__":
    if sys.argv[1:2] == ["--check"]:
        sys.exit(1 if sum(check(path) for path in sys.argv[2:]) else 0)
    setup_text = open(sys.argv[2], encoding="utf-8").read() if len(sys.argv) > 2 else ""
    for shown in Run(open(sys.argv[1], encoding="utf-8").read(), tomllib.loads(setup_text)).trace:
        print(text_of(shown))

#!/usr/bin/env python3
"""Nose radius compensation of the OSP-E100L, computed from the rule text alone: see README.md."""
import argparse
import sys
import tomllib

from against import check_contours
from compare import check_cases, check_chapter
from events import Unsupported
from program import trace_of


def arguments():
    parser = argparse.ArgumentParser(prog="compensation.py", description=__doc__)
    parser.add_argument("program", nargs="?", help="a part program whose trace is printed")
    parser.add_argument("--setup", metavar="FILE", help="its set-up file")
    parser.add_argument("--check", metavar="CHAPTER", nargs="+", help="compare the examples of rule chapters")
    parser.add_argument("--cases", metavar="FILE", nargs="+", help="compare the expected events of conformance cases")
    parser.add_argument("--contours", metavar="COUNT", type=int, help="compare random contours with an implementation")
    parser.add_argument("--seed", type=int, default=1, help="the seed of the contours (default 1)")
    parser.add_argument("--with", metavar="COMMAND", action="append", dest="commands", default=[],
                        help="command of an implementation that writes its trace as JSON Lines; {program} and {setup} "
                             "stand for the paths of the files; may be repeated")
    return parser


def main():
    parser = arguments()
    given = parser.parse_args()
    if (given.contours is None) != (not given.commands):
        parser.error("--contours and --with belong together")
    if not (given.program or given.check or given.cases or given.commands):
        parser.error("nothing to do")
    agree = []
    if given.program:
        show(given.program, given.setup)
    for path in given.check or []:
        agree.append(not check_chapter(path).differ)
    if given.cases:
        agree.append(not check_cases(given.cases).differ)
    if given.commands:
        agree.append(check_contours(given.contours, given.seed, given.commands))
    return 0 if all(agree) else 1


def show(program, setup):
    """Prints the trace of a program in compact notation."""
    with open(program, encoding="ascii") as file:
        text = file.read()
    table = {}
    if setup:
        with open(setup, "rb") as file:
            table = tomllib.load(file)
    for event in trace_of(text, table):
        print(event.text())


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, Unsupported) as fault:
        print(f"compensation.py: {fault}", file=sys.stderr)
        sys.exit(2)

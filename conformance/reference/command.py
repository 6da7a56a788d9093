"""The command line of a subject: a trace, examples of rules, conformance cases, random programs."""
import argparse
import sys
import tomllib

from against import check_random
from compare import check_cases, check_chapter
from events import Unsupported


def arguments(name, description, noun):
    parser = argparse.ArgumentParser(prog=name, description=description)
    parser.add_argument("program", nargs="?", help="a part program whose trace is printed")
    parser.add_argument("--setup", metavar="FILE", help="its set-up file")
    parser.add_argument("--check", metavar="CHAPTER", nargs="+", help="compare the examples of rule chapters")
    parser.add_argument("--cases", metavar="FILE", nargs="+", help="compare the expected events of conformance cases")
    parser.add_argument(f"--{noun}s", dest="count", metavar="COUNT", type=int,
                        help=f"compare random {noun}s with an implementation")
    parser.add_argument("--seed", type=int, default=1, help=f"the seed of the {noun}s (default 1)")
    parser.add_argument("--with", metavar="COMMAND", action="append", dest="commands", default=[],
                        help="command of an implementation that writes its trace as JSON Lines; {program} and {setup} "
                             "stand for the paths of the files; may be repeated")
    return parser


def run(name, description, subject, noun, random):
    """Carries out the command; the exit status. `random`: the random programs by count and seed, `noun`: what one
    of them is."""
    try:
        return carry_out(arguments(name, description, noun), subject, noun, random)
    except (OSError, Unsupported) as fault:
        print(f"{name}: {fault}", file=sys.stderr)
        return 2


def carry_out(parser, subject, noun, random):
    given = parser.parse_args()
    if (given.count is None) != (not given.commands):
        parser.error(f"--{noun}s and --with belong together")
    if not (given.program or given.check or given.cases or given.commands):
        parser.error("nothing to do")
    agree = []
    if given.program:
        show(subject, given.program, given.setup)
    for path in given.check or []:
        agree.append(not check_chapter(subject, path).differ)
    if given.cases:
        agree.append(not check_cases(subject, given.cases).differ)
    if given.commands:
        agree.append(check_random(subject, noun, random(given.count, given.seed), given.seed, given.commands))
    return 0 if all(agree) else 1


def show(subject, program, setup):
    """Prints the trace of a program in compact notation."""
    with open(program, encoding="ascii") as file:
        text = file.read()
    table = {}
    if setup:
        with open(setup, "rb") as file:
            table = tomllib.load(file)
    for event in subject.trace_of(text, table):
        print(event.text())

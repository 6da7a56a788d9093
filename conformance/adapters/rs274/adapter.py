#!/usr/bin/env python3
"""Runs the words that the E100L shares with LinuxCNC's interpreter `rs274` on that interpreter.

Reads one case, writes the trace (`../../PROTOCOL.md`). `translate.py` makes the program one of rs274, `nose.py` its
tool table, `trace.py` and `path.py` make events of what it prints; `LEDGER.md` explains where the two controls differ.
"""

import json
import os
import subprocess
import sys
import tempfile

from nose import Noses
from path import Path
from shared import NotShared
from trace import Machine
from translate import demand_shared_machine, has_compensation, program_text, translate

END, ALARM, UNSUPPORTED, BROKEN = 0, 1, 3, 4


def main():
    case = json.load(sys.stdin)
    try:
        sys.exit(run(case["program"], case["setup"]))
    except NotShared as reason:
        print(reason, file=sys.stderr)
        sys.exit(UNSUPPORTED)


def run(program, setup):
    demand_shared_machine(setup)
    noses = Noses(setup)
    blocks, not_shared = translate(program, setup, noses)
    programmed = {}
    if has_compensation(blocks):
        programmed = interpreted(blocks, setup, noses, is_compensated=False)[0].programmed
    machine, messages = interpreted(blocks, setup, noses, is_compensated=True, programmed=programmed)
    reached_the_rest = not machine.has_ended and (not messages or messages[0].startswith("File ended"))
    if not_shared and reached_the_rest:
        raise NotShared(not_shared)
    if not machine.has_ended:
        machine.events.append(machine.alarm(messages))
    for event in machine.events:
        print(json.dumps(event))
    return END if machine.has_ended else ALARM


def interpreted(blocks, setup, noses, is_compensated, programmed=None):
    """The machine after the calls that rs274 prints for the blocks, and its messages."""
    text = program_text(blocks, setup, is_compensated)
    table = noses.table({nose for block in blocks for nose in block.noses})
    calls, messages = output(text, table, setup["switches"]["block_delete"])
    machine = Machine(blocks, setup["switches"]["optional_stop"], Path(noses, programmed or {}))
    for call in calls:
        machine.take(call)
    return machine, messages


def output(text, table, block_delete):
    """What rs274 prints. It keeps the tools in a file of the home directory, so that each run has one of its own."""
    with tempfile.TemporaryDirectory(prefix="rs274-") as home:
        program, tools = os.path.join(home, "program.ngc"), os.path.join(home, "tool.tbl")
        for path, content in ((program, text), (tools, table)):
            with open(path, "w", encoding="latin-1") as file:
                file.write(content)
        command = ["rs274", "-t", tools, *(["-b"] if block_delete else []), "-g", program]
        environment = {**os.environ, "HOME": home}
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, encoding="latin-1", check=False
        )
    if done.returncode < 0:
        print(f"rs274 ends by signal {-done.returncode}", file=sys.stderr)
        sys.exit(BROKEN)
    messages = [line.removeprefix("executing") for line in done.stderr.splitlines()]
    return done.stdout.splitlines(), [line for line in messages if line]


if __name__ == "__main__":
    main()

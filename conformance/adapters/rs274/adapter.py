#!/usr/bin/env python3
"""Runs the words that the E100L shares with LinuxCNC's interpreter `rs274` on that interpreter.

Reads one case, writes the trace (`../../PROTOCOL.md`). `translate.py` makes the program one of rs274,
`trace.py` makes events of what it prints; `LEDGER.md` explains where the two controls differ.
"""

import json
import os
import subprocess
import sys

from trace import Machine
from translate import NotShared, demand_shared_machine, program_text, translate

END, ALARM, UNSUPPORTED, BROKEN = 0, 1, 3, 4

# Now and then rs274 dies of a bus error at its start when several of it run at once: that is no answer.
ATTEMPTS = 8


def main():
    case = json.load(sys.stdin)
    try:
        sys.exit(run(case["program"], case["setup"]))
    except NotShared as reason:
        print(reason, file=sys.stderr)
        sys.exit(UNSUPPORTED)


def run(program, setup):
    demand_shared_machine(setup)
    blocks, not_shared = translate(program, setup)
    machine = Machine(blocks, setup["switches"]["optional_stop"])
    calls, messages = interpreted(program_text(blocks, setup), setup["switches"]["block_delete"])
    for call in calls:
        machine.take(call)
    reached_the_rest = not machine.has_ended and (not messages or messages[0].startswith("File ended"))
    if not_shared and reached_the_rest:
        raise NotShared(not_shared)
    if not machine.has_ended:
        machine.events.append(machine.alarm(messages))
    for event in machine.events:
        print(json.dumps(event))
    return END if machine.has_ended else ALARM


def interpreted(text, block_delete):
    """The calls that rs274 prints for a program, and its messages."""
    program = os.memfd_create("program")
    os.write(program, text.encode("latin-1"))
    command = ["rs274", *(["-b"] if block_delete else []), "-g", f"/proc/{os.getpid()}/fd/{program}"]
    for _ in range(ATTEMPTS):
        done = subprocess.run(command, capture_output=True, text=True, encoding="latin-1", check=False)
        if done.returncode >= 0:
            messages = [line.removeprefix("executing") for line in done.stderr.splitlines()]
            return done.stdout.splitlines(), [line for line in messages if line]
    print(f"rs274 ends by signal {-done.returncode}", file=sys.stderr)
    sys.exit(BROKEN)


if __name__ == "__main__":
    main()

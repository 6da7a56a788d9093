#!/usr/bin/env python3
"""LAP of the OSP-E100L, bar turning in mode I, computed from the rule text alone: see README.md."""
import sys

from command import run
from compare import Subject
from lap_program import trace_of
from lap_random import contours

AREAS = ("LAP-", "LAPC-", "AP1-")

if __name__ == "__main__":
    sys.exit(run("lap.py", __doc__, Subject(trace_of, AREAS), "contour", contours))

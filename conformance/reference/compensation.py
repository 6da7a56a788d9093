#!/usr/bin/env python3
"""Nose radius compensation of the OSP-E100L, computed from the rule text alone: see README.md."""
import sys

from command import run
from compare import Subject
from contours import contours
from program import trace_of

if __name__ == "__main__":
    sys.exit(run("compensation.py", __doc__, Subject(trace_of, ("NRC-", "CRC-")), "contour", contours))

#!/usr/bin/env python3
"""Thread cutting of the OSP-E100L, computed from the rule text alone: see README.md."""
import sys

from command import run
from compare import Subject
from cutting import trace_of
from cycles import cycles

AREAS = ("THRD-", "TCHM-", "G32-", "G33-", "G34-", "G71-", "G72-", "TMOD-", "TINF-", "TMUL-")

if __name__ == "__main__":
    sys.exit(run("threads.py", __doc__, Subject(trace_of, AREAS), "cycle", cycles))

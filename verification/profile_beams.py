#!/usr/bin/env python3
"""Beams whose shape a table gives: force at rest, peaks, first displacement limit point. Writes profile.csv and profiles/spatula.csv."""
import math
import sys

import spatula  # first: one thread
import tables
from collocation import shapecheck
from collocation.digits import LEVELS
from collocation.path import Path
from collocation.shapes import Profile, Spatula
from collocation.suite import Suite, run

REMARKS = (
    "Beams of varying section and rest curve, computed without finite elements by verification/profile_beams.py. Their shapes: profiles/NAME.csv, s from the tip",
    "to the grip, angle of the underside free of stress; all are monotone cubics between the knots (Fritsch-Butland, scipy's PchipInterpolator)",
    "Numbers and names as in spatula.csv, good to the digits printed.",
)
SAMPLE = ("The first spatula of spatula.csv at 24 knots, written by verification/profile_beams.py.",)
KNOTS = (0, 120, 200, 230, 240, 246, 252, 258, 264, 270, 276, 282, 290, 305, 320, 335, 350, 365, 380, 390, 410, 500, 700, 990)
DEFINING = {"profile": "name", "grip_rotation": "rotation"}
COLUMNS = (*DEFINING, *spatula.VALUES)
CASES = [Profile(name="taper"), Profile(name="curved"), Profile(name="curved", rotation="fixed"), Profile(name="spatula", rotation="fixed")]


def sampled(shape=Spatula()):
    """The rows of profiles/spatula.csv."""
    for S in KNOTS:
        at = shape.form(float(S))
        yield {"s_nm": S, "width_nm": at.width, "height_nm": at.height, "angle_deg": math.degrees(at.angle), "roundness": at.roundness}


def check_sample():
    found = list(tables.differences("profiles/spatula.csv", list(sampled()), 1e-12, 1e-12))
    print(*found, f"profiles/spatula.csv: {len(found)} differences from the formulas", sep="\n")
    return not found


def check_forms():
    return all([shapecheck.check_form(shape) for shape in CASES])


def check_solutions():
    """The last shape, whose sub-intervals are cut by the most knots: solution and work; the curved one: stability."""
    path = Path(CASES[3], **dict(LEVELS[1], want=("peak", "lp1")))
    curved = Path(CASES[2], **dict(LEVELS[1], want=("lp1",)))
    return all([shapecheck.check_solution(path), shapecheck.check_work(path, (200, 250, 300, 350)), shapecheck.check_stable(curved)])


if __name__ == "__main__":
    if "--check" not in sys.argv:
        tables.write("profiles/spatula.csv", SAMPLE, list(sampled()))
    run(__doc__, Suite("profile.csv", REMARKS, CASES, COLUMNS, spatula.compute, defining=DEFINING, paper=CASES[0]),
        (check_sample, check_forms), (check_solutions,))

#!/usr/bin/env python3
"""The force on the end face of the first spatula of spatula.csv along its path. Writes spatula_curve.csv."""
from dataclasses import dataclass

from collocation.curve import held  # first: one thread
from collocation.path import Path
from collocation.shapes import Spatula
from collocation.suite import Suite, run

REMARKS = (
    "The first spatula of spatula.csv, computed without finite elements by verification/spatula_curve.py: force at held displacements of the end face.",
    "As in strip_variants.csv; good to the digits printed.",
)
PATHS = {}                                                            # sub-intervals of a level -> its path


@dataclass(frozen=True)
class Point:
    displacement: float = 0.0            # nm


def compute(point, level, verbose):
    if level["N"] not in PATHS:
        PATHS[level["N"]] = Path(Spatula(), verbose=verbose, **dict(level, want=("peak", "lp1")))
    path = PATHS[level["N"]]
    return {"force_nN": path.s.P(held(path, point.displacement))}


if __name__ == "__main__":
    cases = [Point(25.0 * k) for k in range(15)]
    run(__doc__, Suite("spatula_curve.csv", REMARKS, cases, ("displacement_nm", "force_nN"), compute,
                       defining={"displacement_nm": "displacement"}, paper=Point()))

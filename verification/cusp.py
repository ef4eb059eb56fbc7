#!/usr/bin/env python3
"""The two turning points of the displacement of a strip of 100 nm, a little below the EI at which they meet. Writes cusp.csv."""
import bound_scenes  # first: one thread
from collocation.law import Strip
from collocation.suite import Suite, run

REMARKS = (
    "Displacement limit points before they meet in a cusp, computed without finite elements by verification/cusp.py; as in strip_variants.csv, good to the",
    "digits printed. The square of the difference of the two forces vanishes linearly at the cusp.",
)
COLUMNS = ("length_nm", "bending_stiffness_factor", "lp1_displacement_nm", "lp1_force_nN", "lp2_displacement_nm", "lp2_force_nN")


def compute(strip, level, verbose):
    return {name: number for name, number in bound_scenes.compute(strip, level, verbose).items() if name in COLUMNS}


if __name__ == "__main__":
    cases = [Strip(factor=f) for f in (72.0, 73.0, 73.5, 74.0, 74.3)]
    run(__doc__, Suite("cusp.csv", REMARKS, cases, COLUMNS, compute, quick=cases[3:4]))

#!/usr/bin/env python3
"""Strips laid down under tension: initiation peak and the first two displacement limit points. Writes pretension.csv.

A strip is stretched by the force T, lies flat on the substrate, held at x(0) = 0 and at x(L) = L (1 + T/EA), and is pulled by a grip
that does not move across the pull. At rest H = T all along and x' = 1 + T/EA: an exact equilibrium, as on a flat substrate nothing but
the section force acts along x. From there on H is an unknown. Unknowns, signs and conditions are those of pull_angle.py; u and w count
from where the grip is at rest.
"""
from dataclasses import replace

from collocation import selfcheck  # first: one thread
from collocation.digits import LEVELS
from collocation.law import Strip
from collocation.path import Path
from collocation.suite import DEFINING, Suite, known, run
from collocation.turning import VALUES, turning_points

REMARKS = (
    "Strips laid down under the tension pretension_nN and pulled by a grip that does not move across the pull, computed without finite elements by",
    "verification/pretension.py; the rest as in strip_variants.csv. Every number is good to the digits printed. Empty: does not occur before P has come back to zero,",
    "u has, or the strip is farther than 10 r0 from the substrate.",
)
D = Strip(horizontal="fixed", pretension=0.1)
CASES = [
    *(replace(D, pretension=t) for t in (0.01, 0.1, 0.5, 2.0)), replace(D, factor=0.01), replace(D, factor=100.0),
    replace(D, rotation="fixed"), replace(D, length=200.0, pretension=1.0), replace(D, angle=60.0), replace(D, line_load="axis-gap", pretension=1.0),
]
COLUMNS = ("length_nm", "bending_stiffness_factor", "pretension_nN", "pull_angle_deg", "grip_rotation", "grip_across", "line_load", *VALUES)


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    return turning_points(Path(strip, verbose=verbose, **level), reach=10.0)


def check_none():
    """A tension of a billionth of a nanonewton: the strip of strip_variants.csv that is held across the pull."""
    row = known(replace(D, pretension=0.0))
    now = compute(replace(D, pretension=1e-9), dict(LEVELS[0], want=("peak", "lp1")), False)
    worst = max(abs(now[name] / float(row[name]) - 1.0) for name in VALUES[:4] if row[name])
    print(f"peak and lp1 under 1e-9 nN against strip_variants.csv: differ by {worst:.1e}")
    return worst < 1e-8


def check_work():
    return all([selfcheck.check_work(c) for c in (D, replace(D, pretension=2.0))])


def check_form():
    return selfcheck.check_strong_form(replace(D, pretension=0.5), "peak")


if __name__ == "__main__":
    defining = DEFINING | {"pull_angle_deg": "angle", "grip_across": "horizontal", "pretension_nN": "pretension"}
    suite = Suite("pretension.csv", REMARKS, CASES, COLUMNS, compute, CASES[::3], defining)
    run(__doc__.split("\n")[0], suite, (check_none, check_form), (check_work,))

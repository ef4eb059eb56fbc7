#!/usr/bin/env python3
"""Strips pulled at an angle: initiation peak and the first two displacement limit points. Writes pull_angle.csv.

The angle of the pull to the substrate is 0 along it and away from the strip, 90 degrees upright, 180 degrees back over the
strip. With (dx, dy) the displacement of the grip from where the strip lies flat and free of stress,
    u = dx cos + dy sin,   w = dx sin - dy cos,   (H, V(L)) = P (cos, sin) + Q (sin, -cos),
and P du + Q dw is the work of the grip. Across the pull it is free, Q = 0, or fixed, w = 0. The substrate has no friction, H is
the same all along the strip; its left end is held along the substrate alone: x(0) = 0, V(0) = M(0) = 0. Unknowns are
g = y - h/2, theta, V, M, x - S and H. Beam and adhesion are those of strip_variants.csv at 100 nm but for what the columns say.

Expected of a long strip whose grip is free across: the bonded part slides and is stretched or compressed by H = P cos, the part
that hangs free is stretched by P. The first integral H x' + V y' + M theta' - stored - b Psi is H + H^2/2EA - b Psi(y_eq, 0) in
the one and P + P^2/2EA in the other, so that
    P (1 - cos) + P^2 sin^2 / 2EA = -b Psi(y_eq, 0).
"""
from dataclasses import replace

from collocation import selfcheck  # first: one thread
from scipy.optimize import brentq

from collocation.digits import LEVELS
from collocation.energy import adhesion, refined
from collocation.law import Strip
from collocation.path import Path
from collocation.suite import DEFINING, Suite, known, run
from collocation.turning import VALUES, turning_points

REMARKS = (
    "Strips pulled at an angle, computed without finite elements by verification/pull_angle.py: u and P along the pull, the rest as in strip_variants.csv.",
    "pull_angle_deg: 0 along the substrate and away from the strip, 180 back over it. grip_across: free (no force across the pull), fixed (no displacement across it).",
    "Every number is good to the digits printed. Empty: does not occur before P has come back to zero or u has.",
)
D = Strip()
CASES = [
    *(replace(D, angle=a) for a in (10.0, 30.0, 60.0, 85.0, 120.0, 150.0, 170.0)),
    *(replace(D, angle=a, factor=0.01) for a in (30.0, 60.0, 120.0, 150.0)),
    *(replace(D, angle=a, factor=100.0) for a in (45.0, 135.0)),
    *(replace(D, angle=a, rotation="fixed") for a in (60.0, 135.0)),
    replace(D, angle=60.0, line_load="axis-gap"), replace(D, angle=150.0, length=200.0),
    *(replace(D, angle=a, horizontal="fixed") for a in (60.0, 80.0, 100.0, 120.0, 150.0)),
]
QUICK = CASES[::3]
COLUMNS = ("length_nm", "bending_stiffness_factor", "pull_angle_deg", "grip_rotation", "grip_across", "line_load", *VALUES)


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    return turning_points(Path(strip, verbose=verbose, **level))


def check_upright(tilt=1e-3):
    """On average at 90 degrees -+ tilt: peak and lp1 of strip_variants.csv, where H = 0 is no unknown."""
    row = known(D)
    a, b = (compute(replace(D, angle=90.0 + t), dict(LEVELS[0], want=("peak", "lp1")), False) for t in (-tilt, tilt))
    worst = max(abs(0.5 * (a[name] + b[name]) / float(row[name]) - 1.0) for name in VALUES[:4])
    print(f"peak and lp1, mean of {90.0 - tilt:g} and {90.0 + tilt:g} degrees, against strip_variants.csv: differ by {worst:.1e}")
    return worst < 1e-8


def check_steady(length=1000.0):
    """The force of a long strip where |d ln P / d ln u| is least behind the peak."""
    worst = 0.0
    for angle in (60.0, 90.0, 120.0):
        path = Path(replace(D, length=length, angle=angle), want=("plateau",), most=120)       # beyond every turn
        s, (cos, sin) = path.s, path.s.strip.pull
        steady = brentq(lambda P: P * (1.0 - cos) + (P * sin) ** 2 / (2.0 * s.strip.EA) - adhesion(s), 0.0, 10.0, xtol=1e-16)
        st = refined(path, min(path.points[1:], key=lambda st: abs(s.steepness(st))))
        print(f"steady force at {angle:g} degrees, L = {length:g} nm: {s.P(st):.12g} nN at u = {s.u(st):.6g} nm, "
              f"expected {steady:.12g} nN")
        worst = max(worst, abs(s.P(st) / steady - 1.0))
    print(f"    differs by {worst:.1e} at most")
    return worst < 1e-7


def check_work():
    """Of a grip free across the pull and of one that is not."""
    return all([selfcheck.check_work(c) for c in (replace(D, angle=60.0), replace(D, angle=100.0, horizontal="fixed"))])


def check_form():
    """Strongly stretched, compressed, and held across the pull."""
    strips = replace(D, angle=10.0), replace(D, angle=150.0), replace(D, angle=60.0, horizontal="fixed")
    return all([selfcheck.check_strong_form(c, "peak") for c in strips])


if __name__ == "__main__":
    suite = Suite("pull_angle.csv", REMARKS, CASES, COLUMNS, compute, QUICK, DEFINING | {"pull_angle_deg": "angle", "grip_across": "horizontal"})
    run(__doc__.split("\n")[0], suite, (check_upright, check_form), (check_steady, check_work))

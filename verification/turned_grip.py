#!/usr/bin/env python3
"""Strips whose grip turns their end: initiation peak and the first two displacement limit points. Writes turned_grip.csv.

The grip holds the rotation theta(L) = turned + turn u: it has been turned by an angle at its place, u = 0, and it turns on in proportion
to its displacement. Across the pull it is free or held. The path begins at u = 0 behind the turn, which is reached by way of equilibria
at smaller angles, half a degree apart; P there is no longer zero. Unknowns, signs and the other conditions are those of pull_angle.py.
The work of the grip is that of P on u and of its moment M on theta: along the path d(energy) = (P + M turn) du.
"""
from dataclasses import replace

from collocation import selfcheck  # first: one thread
from collocation.digits import LEVELS
from collocation.energy import energy, work
from collocation.law import Strip
from collocation.path import Path
from collocation.suite import DEFINING, Suite, known, run
from collocation.turning import VALUES, turning_points
from collocation.turns import resolved

REMARKS = (
    "Strips whose grip is turned by grip_turned_deg before it is pulled, and turns by grip_turn_deg_per_nm as it goes, computed without finite elements by",
    "verification/turned_grip.py; the rest as in strip_variants.csv, start_force_nN: P behind the turn, at u = 0. Every number is good to the digits printed.",
    "Empty: does not occur before P has come back to zero, u has, or the strip is farther than 10 r0 from the substrate.",
)
D = Strip(rotation="fixed")
CASES = [
    *(replace(D, turn=t) for t in (0.2, 1.0, -0.5)), replace(D, turn=0.5, horizontal="fixed"), replace(D, turn=0.5, angle=60.0),
    *(replace(D, turned=t) for t in (5.0, 10.0, 30.0, -3.0)), replace(D, turned=10.0, horizontal="fixed"), replace(D, turned=10.0, factor=0.01),
    replace(D, turned=5.0, turn=0.5, length=200.0),
]
COLUMNS = ("length_nm", "bending_stiffness_factor", "grip_turned_deg", "grip_turn_deg_per_nm", "pull_angle_deg", "grip_rotation", "grip_across",
           "line_load", "start_force_nN", *VALUES)


def start(path):
    """P at the beginning of a path, on a mesh that is refined as that of a turning point."""
    s = path.s
    return s.P(resolved(s, path.points[0], lambda st: s.held(st, 0.0), *path.fine))


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    path = Path(strip, verbose=verbose, **level)
    return {"start_force_nN": start(path) if strip.turned else None} | turning_points(path, reach=10.0)


def check_none():
    """A billionth of a degree, before and on the way: the strip of strip_variants.csv whose grip does not turn."""
    row = known(D)
    now = compute(replace(D, turned=1e-9, turn=1e-9), dict(LEVELS[0], want=("peak", "lp1")), False)
    names = [name for name in VALUES[:4] if row[name]]
    worst = max(abs(now[name] / float(row[name]) - 1.0) for name in names)
    print(f"peak and lp1 of a grip that turns by 1e-9 degrees against strip_variants.csv: differ by {worst:.1e}")
    return worst < 1e-8


def check_work():
    """Work of force and moment up to lp1 against the change of energy since the path began."""
    worst = 0.0
    for strip in (replace(D, turn=0.5), replace(D, turned=5.0, turn=-0.5), replace(D, turned=5.0)):
        path = Path(strip, **dict(LEVELS[1], want=("peak", "lp1")))
        done, changed = work(path, nodes=5), energy(path.s, path.found["lp1"]) - energy(path.s, path.points[0])
        print(f"work of the grip up to lp1 of {strip}: {done:.12g} aJ, change of energy {changed:.12g} aJ")
        worst = max(worst, abs(done / changed - 1.0))
    print(f"    differs by {worst:.1e} at most")
    return worst < 1e-8


def check_form():
    return selfcheck.check_strong_form(replace(D, turned=10.0, turn=0.5), "peak")


if __name__ == "__main__":
    defining = DEFINING | {"pull_angle_deg": "angle", "grip_across": "horizontal", "grip_turned_deg": "turned", "grip_turn_deg_per_nm": "turn"}
    suite = Suite("turned_grip.csv", REMARKS, CASES, COLUMNS, compute, CASES[::4], defining)
    run(__doc__.split("\n")[0], suite, (check_none, check_form), (check_work,))

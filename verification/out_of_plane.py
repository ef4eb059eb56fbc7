#!/usr/bin/env python3
"""Where a planar strip pulled straight up loses its stability against leaving the plane first. Writes out_of_plane.csv.

The planar path is that of strip_collocation.py. On it the linearised spatial equations are integrated from one end to the other (collocation/roll.py); the
loss is the displacement at which the moment that rolls the grip vanishes, by the secant rule on equilibria that are each solved on a resolved mesh.
"""
from dataclasses import replace

import numpy as np
from scipy.optimize import brentq, newton

from collocation import selfcheck  # first: one thread
from collocation.digits import LEVELS
from collocation.law import Strip
from collocation.path import Path
from collocation.roll import Roll
from collocation.solver import Failure
from collocation.suite import DEFINING, Suite, run
from collocation.turns import resolved

REMARKS = (
    "The first loss of stability against leaving the plane of strips pulled straight up, grip free to roll, computed without finite elements by",
    "verification/out_of_plane.py; the rest as in strip_variants.csv. Every number is good to the digits printed.",
)
D = Strip()
CASES = [
    *(replace(D, width=b) for b in (1.0, 40.0, 100.0)), replace(D, width=2.0, length=200.0), replace(D, width=20.0, height=5.0),
    replace(D, width=60.0, height=20.0), replace(D, width=2.0, young=20.0), replace(D, width=30.0, poisson=0.45), replace(D, width=40.0, law="exponential"),
]
COLUMNS = ("length_nm", "bending_stiffness_factor", "height_nm", "width_nm", "youngs_modulus_GPa", "poissons_ratio", "law", "line_load", "far_face",
           "loss_displacement_nm", "loss_force_nN")


class Watched(Path):
    """A path that ends at its first loss of stability out of the plane, or at its first displacement limit point."""

    def look_for_turn(self):
        super().look_for_turn()
        if "lp1" not in self.found and Roll(self.s.strip, self.points[-1]).margin() < 0.0:
            self.want = ()


class Between:
    """The equilibria of a path between some of its points, by u, each on a mesh that resolves it."""

    def __init__(self, path, points):
        self.s, self.fine = path.s, path.fine
        self.known = {path.s.u(st): st for st in points}

    def near(self, u, halvings=8):
        """An equilibrium at u on a mesh of a neighbour, by way of others where that is too far."""
        from_u = min(self.known, key=lambda known: abs(known - u))
        try:
            return self.s.held(self.known[from_u], u)
        except (Failure, np.linalg.LinAlgError):
            if not halvings:
                raise
            middle = 0.5 * (from_u + u)
            self.known[middle] = self.near(middle, halvings - 1)
            return self.near(u, halvings - 1)

    def at(self, u):
        st = resolved(self.s, self.near(u), lambda near: self.s.held(near, u), *self.fine)
        self.known[u] = st
        return st


def compute(strip, level, verbose):
    path = Watched(strip, verbose=verbose, **dict(level, want=("lp1",)))
    s = path.s
    if path.want:
        raise Failure(f"{strip}: stable up to its first displacement limit point")
    points, lost = path.points, len(path.points) - 1
    between = Between(path, points[lost - 2:])
    u = brentq(lambda u: Roll(strip, between.near(u)).margin(), s.u(points[lost - 1]), s.u(points[lost]), rtol=1e-7)
    margin = lambda u: Roll(strip, between.at(u)).margin()
    u = newton(margin, u, x1=u * (1.0 + 1e-6), tol=1e-13 * u, rtol=1e-13)
    st = between.at(u)
    full, scalar, _ = Roll(strip, st).ends()
    unit = Roll(strip, st).unit()
    if abs(full - scalar) > 1e-9 * unit:
        raise Failure(f"{strip}: the whole system and the scalar problem differ, {full} {scalar}")
    return {"loss_displacement_nm": u, "loss_force_nN": s.P(st)}


def check_modes():
    """A strip 1 nm wide at its first displacement limit point."""
    strip = replace(D, width=1.0)
    path = Path(strip, **dict(LEVELS[0], want=("lp1",)))
    modes = Roll(strip, path.found["lp1"]).modes()
    print(f"b = 1 nm: {modes} negative eigenvalues out of the plane at lp1")
    return modes == 18


if __name__ == "__main__":
    run(__doc__, Suite("out_of_plane.csv", REMARKS, CASES, COLUMNS, compute, defining=DEFINING | {"law": "law"}), checks=[check_modes])

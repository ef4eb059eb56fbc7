"""Snap-through of circular arches on two hinges, pressed down at the crown; by shooting and a continuation of its own.

Half of a symmetric arch: S = 0 is the left hinge (x = y = 0, M = 0), S = 1 the crown, where x and θ = 0 are held and y is
driven. Unknowns: the rotation of the hinge and the section forces H and V, three numbers; x(1) and θ(1) are two conditions.
That leaves a curve in three dimensions. It is followed by tangent steps and shortest Newton corrections, and where V or y(1)
turns along it, the place is the root of a component of the tangent.
"""

from functools import lru_cache

import numpy as np
import tables
from rod import Rod, newton
from scipy.optimize import brentq

# The unknowns in units in which they are of order one.
UNITS = np.array([1.0, 10.0, 10.0])


class Arch:
    """A half arch of length 1 and EI = 1 that rises over the angle `opening`."""

    def __init__(self, opening, axial):
        self.opening = opening
        self.rod = Rod(axial, axial * (5.0 / 6.0) / 2.4, (-opening, 0.0, 0.0))
        self.half_span = np.sin(opening) / opening
        self.rise = (1.0 - np.cos(opening)) / opening

    def at(self, unknown):
        """Misses of the two conditions, lowering of the crown, and the derivatives of all three by the unknowns."""
        rotation, horizontal, vertical = unknown * UNITS
        state, by = self.rod.end(rotation, 0.0, horizontal, vertical)
        values = np.array([state[0] - self.half_span, state[2], self.rise - state[1]])
        slopes = np.array([by[0], by[2], -by[1]])[:, [0, 2, 3]] * UNITS
        return values, slopes

    def tangent(self, slopes, along):
        """Unit tangent of the curve in the direction of `along`."""
        tangent = np.cross(slopes[0], slopes[1])
        tangent /= np.linalg.norm(tangent)
        return tangent if tangent @ along > 0.0 else -tangent

    def corrected(self, start, normal):
        """The point of the curve in the plane through `start` across `normal`."""

        def equations(unknown):
            values, slopes = self.at(unknown)
            return np.append(values[:2], normal @ (unknown - start)), np.vstack([slopes[:2], normal])

        point = newton(equations, start, most=8)
        values, slopes = self.at(point)
        return point, values[2], slopes

    def rounded(self, point, tangent):
        """The equilibrium near a point of the path at which the rotation of the hinge or the lowering of the crown,
        whichever changes faster there, is a multiple of 1/1000; with its lowering."""
        values, slopes = self.at(point)
        by_rotation = abs(tangent[0]) > abs(slopes[2] @ tangent)
        wanted = round(point[0] if by_rotation else values[2], 3)

        def equations(unknown):
            values, slopes = self.at(unknown)
            if by_rotation:
                values, slopes = np.append(values[:2], unknown[0]), np.vstack([slopes[:2], [1.0, 0.0, 0.0]])
            return values - np.array([0.0, 0.0, wanted]), slopes

        found = newton(equations, point)
        return found, self.at(found)[0][2]

    def path(self, end, most=2000):
        """Points (unknowns, lowering, tangent) from rest until the lowering exceeds `end`, and the turning points."""
        point = np.array([self.opening, 0.0, 0.0])
        _, slopes = self.at(point)
        tangent = self.tangent(slopes, np.array([0.0, 0.0, -1.0]))
        points, turns, step, lowering = [(point, 0.0, tangent)], [], 0.01, 0.0
        while lowering < end and len(points) < most:
            try:
                moved, moved_lowering, moved_slopes = self.corrected(point + step * tangent, tangent)
            except (RuntimeError, np.linalg.LinAlgError):
                step *= 0.4
                continue
            moved_tangent = self.tangent(moved_slopes, tangent)
            if moved_tangent @ tangent < np.cos(0.12):
                step *= 0.5
                continue
            for kind, pick in (("load", lambda t, s: -t[2]), ("displacement", lambda t, s: s[2] @ t)):
                if pick(tangent, slopes) * pick(moved_tangent, moved_slopes) < 0.0:
                    turns.append(self.turn(kind, pick, point, tangent, step, len(points)))
            grow = 1.5 if moved_tangent @ tangent > np.cos(0.05) else 1.0
            point, lowering, slopes, tangent, step = moved, moved_lowering, moved_slopes, moved_tangent, step * grow
            points.append((point, lowering, tangent))
        turns.sort(key=lambda turn: turn["order"])
        return points, turns

    def turn(self, kind, pick, point, tangent, step, number):
        """The turning point within a step."""

        def slope(part):
            _, _, slopes = self.corrected(point + part * step * tangent, tangent)
            return pick(self.tangent(slopes, tangent), slopes)

        part = brentq(slope, 0.0, 1.0, xtol=1e-14, rtol=1e-14)
        found, lowering, _ = self.corrected(point + part * step * tangent, tangent)
        return {"order": number + part, "kind": kind, "lowering": lowering, "unknown": found}


ARCHES = [("shallow", 0.4, 400.0), ("steep", 0.7, 400.0)]


def force(unknown):
    """Load on the half arch, positive downwards: minus the section force V, which holds the hinge's side up."""
    return -unknown[2] * UNITS[2]


@lru_cache
def traced(opening, axial):
    """The arch, the points of its path to 2.2 times its rise, and the turning points."""
    arch = Arch(opening, axial)
    return arch, *arch.path(2.2 * arch.rise)


def describe(name, opening, axial):
    return {"arch": name, "opening": opening, "axial": axial, "shear": axial * (5.0 / 6.0) / 2.4}


def compute_turns():
    rows = []
    for name, opening, axial in ARCHES:
        _, _, turns = traced(opening, axial)
        for turn in turns:
            rows.append(describe(name, opening, axial) | {
                "kind": turn["kind"], "lowering": turn["lowering"], "load": force(turn["unknown"]),
                "hinge_rotation": turn["unknown"][0],
            })
    return rows


def compute_curves():
    """Points of every curve, evenly along it."""
    rows = []
    for name, opening, axial in ARCHES:
        arch, points, _ = traced(opening, axial)
        for k in range(1, 25):
            point, _, tangent = points[round(k / 24 * (len(points) - 1))]
            point, lowering = arch.rounded(point, tangent)
            rows.append(describe(name, opening, axial) | {
                "lowering": lowering, "load": force(point), "hinge_rotation": point[0],
            })
    return rows


REMARKS = [
    "Circular arches on two hinges pressed down at the crown, by shooting (verification/arch.py). Half arch: L = 1, EI = 1.",
    "opening: half the angle of the arch, rad; axial = EA L²/EI, shear = GA_s L²/EI; lowering of the crown in L;",
    "load: what the half arch carries, in EI/L² (half the load of the arch); hinge_rotation: θ at the hinge, rad.",
]
TURNS = REMARKS + ["Turning points in path order. Good to 1e-10: roots of the tangent's components, integration error 1e-13."]
CURVES = REMARKS + ["Points of the path in path order. Good to 1e-10."]

if __name__ == "__main__":
    tables.run(__doc__, [("arch_turns.csv", TURNS, compute_turns), ("arch_curve.csv", CURVES, compute_curves)], relative=2e-9, absolute=1e-10)

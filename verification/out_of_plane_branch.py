#!/usr/bin/env python3
"""The branches on which strips pulled straight up leave their plane, by Gauss collocation. Writes out_of_plane_branch.csv.

A grip that is held at a small roll is pulled up from rest until its torque vanishes: there a grip that is free to roll is
in equilibrium out of the plane, on the branch. From there on the branch is walked with the roll free. --check recomputes
everything, --check --quick one case up to its peak.
"""

from dataclasses import dataclass, replace

import space  # first: one thread
import tables
from scipy.optimize import brentq
from space.gauss import Failure
from space.grip import Case, Peel
from space.path import Walk
from space.peel import COARSE, FINE, integrals, refined, values, walk, weights
from space.tables import rows, run

TABLE = "out_of_plane_branch.csv"
REMARKS = (
    "Branches on which strips pulled straight up, grip free to roll, leave their plane: Gauss collocation of the strong form",
    "(out_of_plane_branch.py). Strip: L = 100 nm, h = 10 nm, E = 2 GPa, nu = 0.2, k = 5/6, full law. held: the equilibrium at",
    "which a grip that is held at this roll takes no torque; peak: first extremum of P on the branch behind it; fold: first",
    "maximum of u; u_1: at this displacement in nm. Estimated error: as in space_peels.csv.",
)


@dataclass(frozen=True)
class Free(Case):
    """A strip that leaves its plane although nothing moves it out of it."""

    def leaves_its_plane(self):
        return True


CASES = {
    "wide_40": (Free("wide_40", width_nm=40.0, displacements_nm="0.5;1;2;5;10;20;40"), 0.3),
    "wide_60": (Free("wide_60", width_nm=60.0, displacements_nm="0.5;1;5;20"), 0.3),
    "narrow_1": (Free("narrow_1", width_nm=1.0, displacements_nm="0.6;0.8;1;2;5"), 3.0),
}
QUICK = ("wide_40",)


class Branch(Peel):
    """A strip in a grip that lets it roll, from an equilibrium on the branch on."""

    def __init__(self, case, first):
        super().__init__(case)
        self.first = first

    def start(self, N, s, step=0.1):
        return self.first


def without_torque(case, roll_deg):
    """The strip held at a roll, and its equilibrium without torque."""
    held = Peel(replace(case, roll="fixed", grip_roll_deg=roll_deg))
    problem = held.problem
    path = Walk(problem, held.start(*COARSE), held.lift, weights(problem), 0.02, *COARSE)
    torque = lambda st: held.reactions(st)["torque"]
    while torque(path.points[-1]) > 0.0:
        if len(path.points) > 400:
            raise Failure(f"{case.case}: the torque at a roll of {roll_deg} degrees does not vanish")
        path.advance(largest=0.05)
    a, b = path.points[-2:]
    low, high = (held.u_row(held.displacement(st)) for st in (a, b))
    near = lambda u: refined(problem, a if abs(u - low) < abs(u - high) else b, held.u, u, FINE[1], passes=1)
    root = brentq(lambda u: torque(near(u)), low, high, xtol=1e-13, rtol=1e-14)
    return held, near(root)


def compute(name, case, quick):
    case, roll = case
    held, first = without_torque(case, roll)
    peel = Branch(case, first)
    out, worst, points = [], [0.0, 0.0, 0.0], 0

    def add(point, states):
        nonlocal out, points
        out += rows(name, *(values(peel, point, st) for st in states))
        return [max(a, b) for a, b in zip(worst, integrals(peel, states[-1]))]

    # on the branch the torque is zero: the place at which it is, with the roll free, is that of the roll
    place = peel.u_row(held.displacement(first))
    worst = add("held", [refined(peel.problem, first, peel.u, place, fine) for fine in FINE])
    for point, solved in walk(peel, quick):
        if point == "start":
            continue
        worst = add(point, [solved(fine) for fine in FINE])
        points += 1
    print(
        f"{name}: {points} states; first integral varies by {worst[0]:.0e}, n_x and n_z by {worst[1]:.0e}, "
        f"m_y + (r x n)_y by {worst[2]:.0e} of their size",
        flush=True,
    )
    return out


if __name__ == "__main__":
    run(__doc__.split("\n")[0], TABLE, REMARKS, CASES, compute, QUICK)

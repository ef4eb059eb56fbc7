#!/usr/bin/env python3
"""Strips in space that their adhesive holds along the ground as well, by Gauss collocation of the strong form. Writes space_held.csv.

The cases are in space_held_cases.csv; the law and what the ends hold in space/held.py and in README.md. --check recomputes everything,
--check --quick two cases up to a lift of 1 nm.
"""

import numpy as np

import space  # first: one thread
import tables
from space.beam import SIZE, first_integral
from space.held import HeldCase, HeldPeel
from space.peel import FINE, values, walk
from space.tables import rows, run

TABLE = "space_held.csv"
REMARKS = (
    "Strips in space that their adhesive holds along the ground, by Gauss collocation (space_held.py): space_held_cases.csv.",
    "start: P = 0; peak: first maximum of P; u_1, lift_1: at this displacement or lift of the grip in nm. Estimated",
    "error: three times the difference of two meshes with different orders, and 2e-12 of what the value is made of.",
)
CASES = {row["case"]: HeldCase.of(row) for row in tables.read("space_held_cases.csv")}
QUICK = ("oblique_60_60", "oblique_mixed")


def spread(peel, st):
    """How far the first integral of a solution is from constant, over its size."""
    beam = peel.problem.beam.at(st.places().ravel())
    whole = first_integral(beam, st.inner().reshape(SIZE, -1))
    return np.ptp(whole) / np.abs(whole).max()


def compute(name, case, quick):
    peel = HeldPeel(case)
    out, worst, points = [], 0.0, 0
    for point, solved in walk(peel, quick, ("peak",)):
        states = [solved(fine) for fine in FINE]
        found = rows(name, *(values(peel, point, st) for st in states))
        out += [row for row in found if float(row["value"]) or point != "start"]
        worst, points = max(worst, spread(peel, states[-1])), points + 1
    main = [row for row in out if row["quantity"].endswith(("displacement_nm", "force_nN")) and float(row["value"])]
    largest = max(float(row["estimated_error"]) / abs(float(row["value"])) for row in main)
    kept = "no potential" if case.shear_work_J_m2 else f"first integral varies by {worst:.0e} of its size"
    print(
        f"{name}: {points} states; {kept}; u and P: relative errors of at most {largest:.0e}",
        flush=True,
    )
    return out


def loads():
    """Force and moment of the law against central differences of its energy, at places and turns at random."""
    case = CASES["oblique_60_60"]
    law = case.law().at(np.array([30.0]))
    rng = np.random.default_rng(5)
    worst = 0.0
    for _ in range(50):
        z = np.zeros((SIZE, 1))
        # open all across: where a face closes there is a corner
        z[0:3, 0] = np.array([30.0, law.y0 + 3.0, 0.0]) + rng.uniform(-1.0, 1.0, 3)
        z[3:7, 0] = np.array([0.5**0.5, -(0.5**0.5), 0.0, 0.0]) + 0.02 * rng.uniform(-1.0, 1.0, 4)
        _, force, moment = law.loads(z)
        along = rng.uniform(-1.0, 1.0, 6)
        w, v = z[3, 0], z[4:7, 0]
        # q changes by (0, phi) o q/2
        turn = np.concatenate([[-along[3:] @ v], along[3:] * w + np.cross(along[3:], v)]) * 0.5
        change = np.concatenate([along[:3], turn, np.zeros(6)])[:, None]
        energy = lambda k: float(law.loads(z + k * 1e-3 * change)[0][0])
        slope = (45.0 * (energy(1) - energy(-1)) - 9.0 * (energy(2) - energy(-2)) + energy(3) - energy(-3)) / 60e-3
        exact = sum(along[i] * float(force[i][0]) + along[3 + i] * float(moment[i][0]) for i in range(3))
        worst = max(worst, abs(slope - exact) / max(1.0, abs(exact)))
    print(f"force and moment of the law against differences of its energy: {worst:.0e}")
    return [] if worst < 1e-9 else ["the loads of the law"]


if __name__ == "__main__":
    run(__doc__.split("\n")[0], TABLE, REMARKS, CASES, compute, QUICK, (loads,))

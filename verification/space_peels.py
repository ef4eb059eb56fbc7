#!/usr/bin/env python3
"""Adhesive strips peeled in space, by Gauss collocation of the strong form. Writes space_peels.csv.

The cases are in space_cases.csv, what the ends hold in space/grip.py and in README.md. --check recomputes everything,
--check --quick three cases up to a lift of 1 nm.
"""

import space  # first: one thread
import tables
from space.grip import Case, Peel
from space.peel import FINE, integrals, values, walk
from space.selfcheck import energies, law_of_section, runge_kutta
from space.tables import rows, run

TABLE = "space_peels.csv"
REMARKS = (
    "Adhesive strips peeled in space, by Gauss collocation of the strong form (space_peels.py): space_cases.csv.",
    "start: P = 0, all turns imposed; peak: first maximum of P; fold: first maximum of u; u_1, lift_1: at this",
    "displacement or lift of the grip in nm. Estimated error: three times the difference of two meshes with different",
    "orders, and 2e-12 of what the value is made of.",
)
CASES = {row["case"]: Case.of(row) for row in tables.read("space_cases.csv")}
QUICK = ("sideways", "rolled", "disc")


def compute(name, case, quick):
    peel = Peel(case)
    out, worst, points = [], [0.0, 0.0, 0.0], 0
    for point, solved in walk(peel, quick):
        states = [solved(fine) for fine in FINE]
        out += rows(name, *(values(peel, point, st) for st in states))
        if point != "start" or case.leaves_its_plane():
            worst = [max(a, b) for a, b in zip(worst, integrals(peel, states[-1]))]
        points += 1
    main = [row for row in out if row["quantity"].endswith(("displacement_nm", "force_nN")) and float(row["value"])]
    largest = max(float(row["estimated_error"]) / abs(float(row["value"])) for row in main)
    print(
        f"{name}: {points} states; first integral varies by {worst[0]:.0e}, n_x and n_z by {worst[1]:.0e}, "
        f"m_y + (r x n)_y by {worst[2]:.0e} "
        f"of their size; u and P: relative errors of at most {largest:.0e}",
        flush=True,
    )
    return out


def planar():
    """Cases that stay in their plane, against the tables of planar strips of width 1 nm."""
    now = {(row["case"], row["quantity"]): float(row["value"]) for row in tables.read(TABLE)}
    given = {"length_nm": "100", "bending_stiffness_factor": "1", "grip_rotation": "free", "line_load": "full"}
    worst = 0.0
    for name, table, also in (
        ("upright", "strip.csv", {"far_face": "true"}),
        ("along_60", "pull_angle.csv", {"pull_angle_deg": "60", "grip_across": "free"}),
    ):
        row = next(row for row in tables.read(table) if all(row[k] == v for k, v in (given | also).items()))
        for point, column in (("peak", "peak"), ("fold", "lp1")):
            for quantity, width in (("displacement_nm", 1.0), ("force_nN", 10.0)):
                found = now[name, f"{point}_{quantity}"] / (width * float(row[f"{column}_{quantity}"])) - 1.0
                worst = max(worst, abs(found))
    print(f"peak and fold of upright and along_60 against strip.csv and pull_angle.csv: differ by {worst:.1e}")
    return [] if worst < 1e-10 else ["planar strips"]


if __name__ == "__main__":
    checks = (law_of_section, planar, lambda: energies(CASES), lambda: runge_kutta(CASES["rolled"]))
    run(__doc__.split("\n")[0], TABLE, REMARKS, CASES, compute, QUICK, checks)

#!/usr/bin/env python3
"""Benchmarks of beams in space without adhesion, by Gauss collocation of the strong form. Writes space_benchmarks.csv.

The beams are in space_benchmark_beams.csv, the end conditions in space/clamped.py and in README.md. --check recomputes
everything, --check --quick four beams.
"""

import math

import space  # first: one thread
import numpy as np
import tables
from space.beam import SIZE, first_integral
from space.clamped import KINDS
from space.tables import rows, run

TABLE = "space_benchmarks.csv"
REMARKS = (
    "Benchmarks of beams in space, by Gauss collocation of the strong form (space_benchmarks.py).",
    "Beams: space_benchmark_beams.csv. tip_x_at_300: at load 300. Estimated error: three times the difference of two",
    "meshes with different orders, and 2e-12 of the size of the beam.",
)
CASES = {case["case"]: case for case in tables.read("space_benchmark_beams.csv")}
MESHES = {"helix": ((44, 7), (60, 8)), None: ((12, 7), (18, 8))}
QUICK = ("bend_k_5/6_J_1/6", "end_screw", "twisted_1e4", "lateral_100")


def compute(name, case, _quick):
    coarse, fine = MESHES.get(case["kind"], MESHES[None])
    first, _, _ = KINDS[case["kind"]](case, coarse)
    second, st, problem = KINDS[case["kind"]](case, fine)
    integral = first_integral(problem.beam, st.inner().reshape(SIZE, -1))
    arm = np.cross(st.z[0:3], st.z[7:10], axis=0) + st.z[10:13]
    largest = max(np.abs(st.z[10:13]).max(), 1e-300)
    shift, twist = np.ptp(st.z[7:10], axis=1).max(), np.ptp(arm, axis=1).max() / largest
    norm = np.abs((st.z[3:7] ** 2).sum(axis=0) - 1.0).max()
    print(
        f"{name}: first integral {integral[0]:.6g} spreads {np.ptp(integral):.0e}, n {shift:.0e}, "
        f"m + r x n {twist:.0e} of m, q.q {norm:.0e}",
        flush=True,
    )
    return rows(name, first, second)


def closed_forms():
    """End moments: a circle about (0, 0.6, 0.8), and a helix about (0.6, 0, 0.8). End force:
    elastica_cantilever.csv."""
    now = {(row["case"], row["quantity"]): float(row["value"]) for row in tables.read(TABLE)}
    worst = {}

    def hold(what, difference):
        worst[what] = max(worst.get(what, 0.0), abs(difference))

    for turns in (0.25, 0.5, 1.0, 2.0):
        a = 2.0 * math.pi * turns
        s, v = math.sin(a) / a, (1.0 - math.cos(a)) / a
        circle = (s, 0.8 * v, -0.6 * v)
        screw = (0.36 + 0.64 * s, 0.8 * v, 0.48 * (1.0 - s))
        for case, expected in (("end_moment", circle), ("end_screw", screw)):
            for c, value in zip("xyz", expected):
                hold(case, now[case, f"tip_{c}_at_{turns:g}"] - value)
    for row in tables.read("elastica_cantilever.csv"):
        load = float(row["load"])
        if ("end_force", f"tip_x_at_{load:g}") in now:
            up = float(row["tip_y"])
            hold("end_force", now["end_force", f"tip_x_at_{load:g}"] - float(row["tip_x"]))
            hold("end_force", now["end_force", f"tip_y_at_{load:g}"] - 0.6 * up)
            hold("end_force", now["end_force", f"tip_z_at_{load:g}"] - 0.8 * up)
    x = 4.493409457909064
    hold("twisted_rigid", now["twisted_rigid", "moment"] - 2.0 * x)
    hold(
        "frame_rigid",
        now["frame_rigid_in_plane", "moment_closing"]
        / (math.pi / 240.0 * math.sqrt(71240.0 * 0.54 * 71240.0 / 2.62 * 2.16))
        - 1.0,
    )
    print("against closed forms, largest difference: " + ", ".join(f"{k} {v:.0e}" for k, v in worst.items()))
    return [f"closed form of {k}: differs by {v:.1e}" for k, v in worst.items() if v > 1e-9]


if __name__ == "__main__":
    run(__doc__.split("\n")[0], TABLE, REMARKS, CASES, compute, QUICK, (closed_forms,))

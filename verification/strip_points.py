#!/usr/bin/env python3
"""One strip at six bending stiffnesses and three line loads: peak, plateau, limit points, work. Writes strip_points.csv."""
from dataclasses import replace

from collocation.energy import energy, plateau, work  # first: one thread
from collocation.law import Strip
from collocation.path import TURNS, Path
from collocation.suite import Suite, run

REMARKS = (
    "Strips of 200 nm, computed without finite elements by verification/strip_points.py. As in strip_variants.csv; every number is good to the digits printed.",
    "peak = initiation peak, lp1 = snap-off (first displacement limit point), lp2 = the next one. plateau = P where |d ln P / d ln u| is least between peak",
    "and lp1, empty where that is nowhere below 0.01. work = integral of P du from rest to lp1; energy = change of stored and adhesion energy from rest to lp1,",
    "with the potential of the full law where the load (force-only) has none: there the two differ. Where it has one, work is that energy (strip_collocation.py",
    "checks that they agree). plateau and the work of force-only have fewer digits: differences along the path, an integral over it. Empty lp1:",
    "axis-gap, EI x 1e-4: its free end turns over near the snap-off, paths on different meshes go different ways there.",
)
VALUES = ("peak_displacement_nm", "peak_force_nN", "plateau_force_nN", "lp1_displacement_nm", "lp1_force_nN", "lp2_displacement_nm",
          "lp2_force_nN", "work_aJ", "energy_aJ")
LENGTH = 200.0
FACTORS = (1e-4, 1e-3, 1e-2, 1e-1, 1.0, 10.0)
CASES = [replace(Strip(), length=LENGTH, line_load=load, factor=f) for load in ("full", "force-only", "axis-gap") for f in FACTORS]
NODES = 5                                                             # solutions on every step of the path, for the work


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    path = Path(strip, verbose=verbose, **level)
    out = dict.fromkeys(VALUES)
    for kind in TURNS:
        if kind in path.found:
            st = path.found[kind]
            out[f"{kind}_displacement_nm"], out[f"{kind}_force_nN"] = path.s.u(st), path.s.P(st)
    out["plateau_force_nN"] = plateau(path)
    if "lp1" in path.found:
        out["energy_aJ"] = energy(path.s, path.found["lp1"])
        out["work_aJ"] = work(path, NODES) if strip.line_load == "force-only" else out["energy_aJ"]
    return out


if __name__ == "__main__":
    columns = ("length_nm", "bending_stiffness_factor", "line_load", *VALUES)
    run(__doc__, Suite("strip_points.csv", REMARKS, CASES, columns, compute))

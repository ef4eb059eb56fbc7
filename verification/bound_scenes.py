#!/usr/bin/env python3
"""200 drawn strips on which error bounds are judged: initiation peak and the first two displacement limit points. Writes bound_scenes.csv."""

from collocation.suite import Suite, run  # first: one thread
import numpy as np
from collocation.law import Strip
from collocation.path import TURNS, Path

REMARKS = (
    "Strips drawn and computed without finite elements by verification/bound_scenes.py: logarithmically uniform in length, EI factor, height, Hamaker constant and",
    "equilibrium distance, the rotation of the grip by the toss of a coin (numpy's PCG64, fixed seed). As in strip_variants.csv; good to the digits printed.",
)
SEED = 20260731
RANGES = (("length", 30.0, 3000.0), ("factor", 1e-4, 1e2), ("height", 3.0, 30.0), ("hamaker", 0.01, 1.0), ("r0", 0.2, 1.0))


def scenes(count=200):
    """The strips; four digits of every number. A_H is drawn in aJ."""
    generator = np.random.Generator(np.random.PCG64(SEED))
    for _ in range(count):
        drawn = {name: float(f"{least * (most / least) ** generator.random():.4g}") for name, least, most in RANGES}
        drawn["hamaker"] = float(f"{drawn['hamaker']:.4g}e-18")
        yield Strip(rotation="fixed" if generator.random() < 0.5 else "free", **drawn)


def compute(strip, level, verbose):
    path = Path(strip, verbose=verbose, **level)
    out = {}
    for kind in TURNS:
        st = path.found.get(kind)
        out[f"{kind}_displacement_nm"] = None if st is None else path.s.u(st)
        out[f"{kind}_force_nN"] = None if st is None else path.s.P(st)
    return out


COLUMNS = ("length_nm", "bending_stiffness_factor", "height_nm", "hamaker_constant_J", "equilibrium_distance_nm", "grip_rotation",
           "peak_displacement_nm", "peak_force_nN", "lp1_displacement_nm", "lp1_force_nN", "lp2_displacement_nm", "lp2_force_nN")

if __name__ == "__main__":
    cases = list(scenes())
    run(__doc__, Suite("bound_scenes.csv", REMARKS, cases, COLUMNS, compute, quick=cases[::25]))

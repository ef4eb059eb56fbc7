#!/usr/bin/env python3
"""Initiation peaks over many decades of bending stiffness, rigid in shear or not, and towards EI = 0. Writes strip_peaks.csv."""
import math
from dataclasses import replace

from collocation import rigid  # first: one thread
from collocation.law import Strip
from collocation.path import Path
from collocation.suite import Suite, run

REMARKS = (
    "Initiation peaks, computed without finite elements by verification/strip_peaks.py; as in strip_variants.csv, good to the digits printed.",
    "shear_correction = inf: rigid in shear; factor inf: a rigid body. 1000 nm: from where the moment of the adhesion matters to where the strip is rigid; 50 nm: towards EI = 0",
    "(full: below EI = 7.4e-7 EI0 the free end does not stay down, published.csv).",
)
SHEAR = Strip().shear_correction
STIFF = [replace(Strip(), length=1000.0, factor=10.0 ** k, shear_correction=kappa)
         for kappa, most in ((math.inf, 12), (SHEAR, 8)) for k in range(-2, most + 1)]
RIGID = [replace(Strip(), length=1000.0, factor=math.inf, shear_correction=math.inf)]
SOFT = [replace(Strip(), length=50.0, factor=f, line_load=load)
        for load, factors in (("full", (1e-6, 1e-5, 1e-4)), ("force-only", (1e-6, 1e-5, 1e-4)), ("axis-gap", (1e-5, 3e-5, 1e-4)))
        for f in factors]


def compute(strip, level, verbose):
    if math.isinf(strip.factor):
        u, P = rigid.peak(strip)
        return {"peak_displacement_nm": u, "peak_force_nN": P}
    path = Path(strip, verbose=verbose, **dict(level, want=("peak",)))
    peak = path.found.get("peak")
    return {"peak_displacement_nm": peak and path.s.u(peak), "peak_force_nN": peak and path.s.P(peak)}


if __name__ == "__main__":
    columns = ("length_nm", "bending_stiffness_factor", "line_load", "shear_correction", "peak_displacement_nm", "peak_force_nN")
    run(__doc__, Suite("strip_peaks.csv", REMARKS, STIFF + RIGID + SOFT, columns, compute))

#!/usr/bin/env python3
"""Uniform strips without finite elements: initiation peak and the first two displacement limit points. Writes strip_variants.csv.

Without arguments every case is computed on two paths with different meshes, degrees, steps and refinements, and written to the
digits on which both agree. With --check each is computed on one path, the finer one, and compared with the committed table to
1e-9 or one unit of the last digit printed; exit 1 on a mismatch.
"""
from dataclasses import replace

from collocation import selfcheck  # first: one thread
from collocation.law import Strip
from collocation.path import TURNS, Path
from collocation.suite import DEFINING, Suite, run

REMARKS = (
    "Uniform strips, computed without finite elements by verification/strip_collocation.py (Chebyshev collocation of the strong form).",
    "Every number is good to the digits printed: two paths on different meshes, two refinements of each point. digits_relative: the least of the row.",
    "Empty: does not occur before the force has come back to zero, or could not be confirmed. peak = initiation peak (first local maximum of P).",
    "lp1 = first displacement limit point, lp2 = the next one. hamaker_constant in J, width 1 nm unless the column says otherwise.",
)
VALUES = ("peak_displacement_nm", "peak_force_nN", "peak_end_rotation_rad", "lp1_displacement_nm", "lp1_force_nN",
          "lp2_displacement_nm", "lp2_force_nN")
COLUMNS = list(DEFINING)[:5] + list(VALUES) + list(DEFINING)[5:]

D = Strip()
CASES = [
    # the five asked for first
    replace(D, rotation="fixed"), replace(D, horizontal="fixed"), replace(D, line_load="force-only"),
    replace(D, line_load="axis-gap"), replace(D, far_face=False),
    # grips
    replace(D, rotation="fixed", length=200.0, factor=0.1), replace(D, rotation="fixed", length=60.0, factor=0.01),
    replace(D, rotation="fixed", factor=100.0),
    replace(D, horizontal="fixed", factor=0.01), replace(D, horizontal="fixed", length=200.0, factor=0.1),
    replace(D, horizontal="fixed", rotation="fixed"), replace(D, horizontal="fixed", rotation="fixed", factor=0.01),
    # line loads
    replace(D, line_load="force-only", factor=0.1), replace(D, line_load="force-only", factor=0.01),
    replace(D, line_load="axis-gap", factor=0.1), replace(D, line_load="axis-gap", factor=0.01),
    replace(D, line_load="axis-gap", factor=1e-3), replace(D, line_load="axis-gap", far_face=False),
    replace(D, line_load="force-only", far_face=False), replace(D, line_load="force-only", rotation="fixed"),
    replace(D, far_face=False, factor=0.01), replace(D, far_face=False, factor=0.1, length=200.0),
    replace(D, far_face=False, rotation="fixed"),
    # section and material
    replace(D, height=5.0), replace(D, height=20.0), replace(D, young=0.5), replace(D, young=10.0),
    replace(D, poisson=0.0), replace(D, poisson=0.45), replace(D, shear_correction=1.0), replace(D, width=3.0),
    replace(D, hamaker=0.3e-19), replace(D, hamaker=5e-19), replace(D, r0=0.2), replace(D, r0=1.0),
    # lengths and stiffnesses
    replace(D, length=50.0), replace(D, length=50.0, factor=0.01), replace(D, length=400.0), replace(D, length=3000.0),
    replace(D, factor=10.0), replace(D, factor=100.0), replace(D, factor=1000.0), replace(D, factor=0.1),
    replace(D, length=400.0, factor=1e-3), replace(D, length=3000.0, factor=0.01),
    replace(D, factor=1e4), replace(D, factor=1e-5), replace(D, factor=1e-6),
    # two departures at once
    replace(D, line_load="axis-gap", rotation="fixed"), replace(D, line_load="axis-gap", horizontal="fixed"),
    replace(D, line_load="force-only", horizontal="fixed"), replace(D, far_face=False, horizontal="fixed"),
    replace(D, rotation="fixed", factor=1e-3), replace(D, horizontal="fixed", factor=100.0),
    replace(D, horizontal="fixed", length=1000.0), replace(D, line_load="axis-gap", factor=1e-4),
    replace(D, line_load="force-only", factor=1e-3), replace(D, height=2.0, length=60.0),
    replace(D, line_load="axis-gap", height=5.0, young=0.5, hamaker=5e-19, r0=0.3, poisson=0.3, width=2.0, length=150.0),
    # those of the first table, with what it leaves empty
    replace(D), replace(D, length=200.0), replace(D, length=200.0, factor=0.1), replace(D, factor=0.01),
    replace(D, factor=1e-3), replace(D, factor=1e-4), replace(D, length=200.0, factor=10.0), replace(D, length=1000.0),
    replace(D, length=1000.0, factor=0.01),
]
QUICK = CASES[:12] + [CASES[i] for i in (20, 32, 38, 41)]


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    path = Path(strip, verbose=verbose, **level)
    out = dict.fromkeys(VALUES)
    for kind in TURNS:
        if kind in path.found:
            st = path.found[kind]
            out[f"{kind}_displacement_nm"], out[f"{kind}_force_nN"] = path.s.u(st), path.s.P(st)
    if "peak" in path.found:
        out["peak_end_rotation_rad"] = 0.0 if strip.rotation == "fixed" else float(path.found["peak"].zn[-1, 1])
    return out


if __name__ == "__main__":
    run(__doc__.split("\n")[0], Suite("strip_variants.csv", REMARKS, CASES, COLUMNS, compute, QUICK), selfcheck.ALL)

#!/usr/bin/env python3
"""Spatulae without finite elements: force at rest, initiation peak, largest force, first displacement limit point. Writes spatula.csv."""
from dataclasses import replace

from collocation import selfcheck, shapecheck  # first: one thread
from collocation.digits import LEVELS
from collocation.curve import held
from collocation.path import Path
from collocation.shapes import Spatula
from collocation.solver import Solver
from collocation.suite import Suite, run
from collocation.turns import locate

REMARKS = (
    "Spatulae, computed without finite elements by verification/spatula.py. As in strip_variants.csv; every number is good to the digits printed.",
    "Lengths in nm; section, rest curve and their formulas: verification/README.md. case: what differs from the first row. u and P belong to the end face,",
    "which is moved vertically. rest = equilibrium at u = 0, initiation = first maximum of P on the path, peak = largest P from rest up to lp1 (to the end of",
    "the path where there is none), lp1 = first displacement limit point. Empty rest: the end face would lie in the substrate at u = 0, the path begins where",
    "its gap is that of equilibrium. Far face false: a pole at a rotation of 90 degrees, to which peak and lp1 belong.",
)
VALUES = ("rest_force_nN", "initiation_displacement_nm", "initiation_force_nN", "peak_displacement_nm", "peak_force_nN",
          "peak_end_moment_nN_nm", "lp1_displacement_nm", "lp1_force_nN")
DEFINING = {"case": "case", "grip_rotation": "rotation", "line_load": "line_load", "far_face": "far_face", "pad_length_nm": "pad_length",
            "neck_length_nm": "neck_length", "shaft_length_nm": "shaft_length", "bend_length_nm": "bend_length",
            "tip_width_nm": "tip_width", "neck_width_nm": "neck_width", "shaft_diameter_nm": "shaft_diameter",
            "pad_thickness_nm": "pad_thickness", "shaft_angle_deg": "shaft_angle", "tip_rounding_length_nm": "tip_rounding_length",
            "tip_rounding_width_nm": "tip_rounding_width", "youngs_modulus_GPa": "young", "poissons_ratio": "poisson",
            "hamaker_constant_J": "hamaker", "equilibrium_distance_nm": "r0"}
COLUMNS = ("case", *VALUES, *list(DEFINING)[1:])
FORCE, WIDTH = 6.7, 200.8778303675                                   # nN and the tip width at which the peak is that, nm

D = Spatula()
CASES = [
    D, replace(D, rotation="free"),
    *(replace(D, tip_rounding_length=length) for length in (100.0, 40.0)),
    *(replace(D, shaft_angle=angle) for angle in (0.0, 30.0, 60.0, 90.0)),
    *(replace(D, pad_length=length) for length in (120.0, 400.0)),
    *(replace(D, pad_thickness=thickness) for thickness in (5.0, 20.0)),
    *(replace(D, tip_width=width) for width in (100.0, 300.0, 50.0, WIDTH)),
    replace(D, shaft_diameter=100.0), replace(D, neck_length=50.0), replace(D, neck_length=30.0, bend_length=80.0),
    replace(D, hamaker=0.5e-19), replace(D, hamaker=3e-19), replace(D, r0=0.3), replace(D, young=0.5), replace(D, young=10.0),
    replace(D, line_load="force-only"), replace(D, far_face=False),
]


def compute(spatula, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    path = Path(spatula, verbose=verbose, **dict(level, want=("peak", "lp1")))
    out = dict.fromkeys(VALUES)
    rest = held(path, path.s.first)
    top = max((rest, path.found.get("top", rest)), key=path.s.P)
    for name, st in (("initiation", path.found.get("peak")), ("peak", top), ("lp1", path.found.get("lp1"))):
        if st is not None:
            out[f"{name}_displacement_nm"], out[f"{name}_force_nN"] = 0.0 if st is rest else path.s.u(st), path.s.P(st)
    out["peak_end_moment_nN_nm"] = 0.0 if spatula.rotation == "free" else float(top.zn[-1, 3])
    if path.s.first == 0.0:
        out["rest_force_nN"] = path.s.P(rest)
    return out


def check_width():
    """The tip width at which the peak is FORCE, by the secant method on the peak alone."""
    path = Path(D, **dict(LEVELS[1], want=("peak", "lp1")))
    st, widths = path.found["top"], [D.tip_width]
    misses = [path.s.P(st) - FORCE]
    step = 1.0
    while abs(step) > 1e-10:
        widths.append(widths[-1] + step)
        s = Solver(replace(D, tip_width=widths[-1]))
        st = locate(s, st, "P", *path.fine)
        misses.append(s.P(st) - FORCE)
        step = -misses[-1] * (widths[-1] - widths[-2]) / (misses[-1] - misses[-2])
    print(f"tip width at which the peak is {FORCE} nN: {widths[-1]:.10f} nm")
    return abs(widths[-1] - WIDTH) < 1e-9


def check_forms():
    some = (D, replace(D, neck_length=30.0, bend_length=80.0, tip_rounding_length=40.0))
    return all([shapecheck.check_form(spatula) for spatula in some])


def check_default():
    """Solution and work of the first spatula."""
    path = Path(D, **dict(LEVELS[1], want=("peak", "lp1")))
    return shapecheck.check_solution(path) and shapecheck.check_work(path, (0, 50, 100, 120, 125, 130, 135, 150, 200, 300, 350))


def check_stable():
    """Paths are stable up to lp1: also those whose shape free of stress reaches into the substrate."""
    some = (D, replace(D, shaft_angle=0.0), replace(D, shaft_angle=90.0), replace(D, neck_length=30.0, bend_length=80.0))
    return all([shapecheck.check_stable(Path(spatula, **dict(LEVELS[1], want=("lp1",)))) for spatula in some])


if __name__ == "__main__":
    suite = Suite("spatula.csv", REMARKS, CASES, COLUMNS, compute, CASES[:4], DEFINING, D)
    run(__doc__.split("\n")[0], suite, (selfcheck.check_balance, check_forms), (check_default, check_stable, check_width))

#!/usr/bin/env python3
"""Strips of rubber, which are stretched by tens of percent: initiation peak and the first two displacement limit points. Writes stretched.csv.

The force along the axis is that of a neo-Hookean material, with lambda = 1 + Gamma_1 and the small-strain EA:
    neo-hookean        N = EA (lambda - lambda^-2)/3     under tension alone,
    neo-hookean-wide   N = EA (lambda - lambda^-3)/4     of a width that stays what it is.
Bending and shear are linear. The strips adhere by the exponential law, and slide (shear strength 0, as in pull_angle.py) or are held along the
substrate (as in sheared.py).

Expected of a long strip that is held: what hangs free is stretched to lambda(P), and stores w(P), so that
    P (lambda - cos) - w = w_adh b.
One that slides is stretched by P cos already where it adheres: with f(P) = P lambda(P) - w(P),  f(P) - f(P cos) = w_adh b.
"""
from dataclasses import replace

from collocation import selfcheck  # first: one thread
import mpmath as mp
import numpy as np
from scipy.optimize import brentq

from collocation.digits import LEVELS
from collocation.energy import adhesion
from collocation.law import POWER, Strip, stretched
from collocation.path import Path
from collocation.slip import grip, settled
from collocation.suite import DEFINING, Suite, run
from collocation.turning import VALUES, turning_points
from sheared import integral, path_of

REMARKS = (
    "Strips of rubber under the exponential law, computed without finite elements by verification/stretched.py; the rest as in sheared.csv.",
    "stretch: how the force along the strip follows its stretch. shear_strength_GPa: 0 where the strip slides along the substrate.",
    "Every number is good to the digits printed. Empty: does not occur before P has come back to zero, u has, or the strip is off.",
)
D = Strip(law="exponential", far_face=False, shear_strength=0.0, stretching="neo-hookean", young=0.05, poisson=0.49)
CASES = [
    *(replace(D, angle=a) for a in (90.0, 60.0, 30.0, 120.0)),
    *(replace(D, angle=a, stretching="neo-hookean-wide") for a in (60.0, 30.0)),
    *(replace(D, angle=a, shear_strength=0.08) for a in (60.0, 30.0, 120.0)),
    replace(D, angle=60.0, shear_strength=0.08, stretching="neo-hookean-wide"),
    replace(D, angle=60.0, shear_strength=0.08, young=0.02),
    replace(D, angle=60.0, shear_strength=0.08, rotation="fixed"),
    replace(D, angle=90.0, horizontal="fixed"),
]
QUICK = [CASES[i] for i in (2, 9)]
COLUMNS = ("length_nm", "youngs_modulus_GPa", "poissons_ratio", "stretch", "shear_strength_GPa", "grip_rotation", "grip_across", "far_face",
           "pull_angle_deg", "law", *VALUES)


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    if strip.shear_strength == 0.0:
        return turning_points(Path(replace(strip, shear_strength=None), verbose=verbose, **level))
    return turning_points(path_of(strip, level, verbose=verbose), integral)


def check_law():
    """Strain and energy under N against the energy that is differentiated by mpmath."""
    mp.mp.dps = 40
    worst = 0.0
    for law, n in POWER.items():
        c = replace(D, stretching=law)
        energy = lambda l: c.EA * (l ** 2 + mp.mpf(2) / (n - 1) * l ** (1 - n) - 1 - mp.mpf(2) / (n - 1)) / (2 * (n + 1))
        for force in (-0.3, -1e-3, 1e-5, 0.02, 0.4, 3.0):
            strain, slope, stored = (float(x) for x in stretched(c, np.float64(force)))
            l = mp.findroot(lambda l: mp.diff(energy, l) - force, 1 + strain)
            second = mp.diff(energy, l, 2)
            worst = max(worst, abs(float((l - 1 - strain) / (l - 1))), abs(float(1 / second / slope - 1)), abs(float((energy(l) - stored) / c.EA)))
    print(f"strain, its slope and energy against mpmath: worst difference {worst:.1e}")
    return worst < 1e-10


def check_steady(length=300.0):
    """The force of a long strip that is held, of which half is off, against the one expected."""
    worst = 0.0
    for angle, law in ((45.0, "neo-hookean"), (90.0, "neo-hookean-wide")):
        strip = replace(D, factor=0.1, length=length, angle=angle, shear_strength=0.08, stretching=law)
        half = lambda s, st: float(st.at(np.array([0.5 * length]))[0, 0]) > 20.0
        path = path_of(strip, LEVELS[0], want=("never",), stop=half)
        s, (cos, _) = path.s, path.s.strip.pull
        left = lambda P: P * (1.0 + stretched(s.strip, P)[0] - cos) - stretched(s.strip, P)[2] - adhesion(s)
        expected = brentq(left, 1e-6, 10.0, xtol=1e-16)
        up = grip(s, "u")
        st, _ = settled(s, path.points[-1], up, up @ path.points[-1].zn[-1], *LEVELS[0]["fine"])
        print(f"steady force at {angle:g} degrees, {law}: {s.P(st):.12g} nN at u = {s.u(st):.6g} nm, expected {expected:.12g} nN")
        worst = max(worst, abs(s.P(st) / expected - 1.0))
    print(f"    differs by {worst:.1e} at most")
    return worst < 1e-8


if __name__ == "__main__":
    defining = DEFINING | {"law": "law", "pull_angle_deg": "angle", "grip_across": "horizontal", "shear_strength_GPa": "shear_strength",
                           "stretch": "stretching"}
    suite = Suite("stretched.csv", REMARKS, CASES, COLUMNS, compute, QUICK, defining, paper=D)
    run(__doc__.split("\n")[0], suite, (check_law,), (check_steady,))

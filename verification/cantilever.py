"""Cantilevers that stretch and shear under a dead end force across their axis, by shooting.

S = 0 is clamped (x = y = θ = 0), S = 1 carries V = P along y and nothing else (H = 0, M = 0). One unknown, the moment at the
clamp; the force grows from zero in steps.
"""

import numpy as np
import tables
from rod import Rod, newton


def tip(rod, load):
    """x, y, θ of the tip under the end force `load`, and the moment at the clamp."""
    moment = 0.0
    for part in np.linspace(0.0, 1.0, 2 + int(abs(load))):
        def at_clamp(unknown):
            state, by = rod.end(0.0, unknown[0], 0.0, part * load)
            return state[3:], by[3:, 1:2]

        moment = newton(at_clamp, [moment])[0]
    state, _ = rod.end(0.0, moment, 0.0, load)
    return state[0], state[1], state[2], moment


def row(case, rod, load):
    x, y, rotation, moment = tip(rod, load)
    k0, k1, k2 = rod.curvature
    return {
        "case": case, "axial": rod.axial, "shear": rod.shear, "k0": k0, "k1": k1, "k2": k2, "load": load,
        "tip_x": x, "tip_y": y, "tip_rotation": rotation, "clamp_moment": moment,
    }


def slender(slenderness):
    """A rectangle of height L/slenderness with ν = 0.2 and shear correction 5/6: EA = 12 s², GA_s = 12 s² (5/6)/2.4."""
    axial = 12.0 * slenderness**2
    return Rod(axial, axial * (5.0 / 6.0) / 2.4)


def compute():
    stretchy = Rod(100.0, 30.0)
    rows = [row("stretch and shear", stretchy, load) for load in (1.0, 4.0, 10.0, 16.0)]
    rows += [row("shear", Rod(1e6, 5.0), load) for load in (0.5, 2.0, 8.0)]
    rows += [row("slenderness", slender(10.0**k), 1.0) for k in range(6)]
    rows.append(row("clothoid", Rod(100.0, 30.0, (-1.0, 4.0, 0.0)), 4.0))
    rows.append(row("cubic", Rod(400.0, 150.0, (2.0, -3.0, 6.0)), -6.0))
    return rows


REMARKS = [
    "Cantilevers with an end force P across the axis, by shooting (verification/cantilever.py). L = 1, EI = 1.",
    "axial = EA L²/EI, shear = GA_s L²/EI, k0 k1 k2: rest curvature k0 + k1 S + k2 S², load = P L²/EI, clamp_moment in EI/L.",
    "Good to 11 digits: the integration's error is 1e-13 a step, Newton's last update below 1e-12.",
]

if __name__ == "__main__":
    tables.run(__doc__, [("cantilever.csv", REMARKS, compute)], relative=1e-10, absolute=1e-12)

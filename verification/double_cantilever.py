#!/usr/bin/env python3
"""Double cantilever beams with an initial crack: the largest force. Writes double_cantilever.csv.

One arm on the plane of symmetry, which carries half of the work and half of the opening. The arm is a geometrically exact beam without
horizontal force: y' = (1 + eps) sin(theta) + gamma cos(theta), theta' = M/EI, V' = b T(y), M' = -x' V, with eps = V sin(theta)/EA and
gamma = V cos(theta)/GAs. The interface is the exponential law T = sigma y/d exp(1 - y/d), d = w/(e sigma), over 0 < S < L - a, and nothing
beyond. V = M = 0 at S = 0, M = 0 and y = u at the load. scipy's solve_bvp solves it on both sides of the tip at once, from opening to
opening; the peak is the largest P over u, by Brent's method.

Printed beside it: linear elastic fracture mechanics of slender arms, P = sqrt(b G EI)/a.
"""
import numpy as np
import tables
from scipy.integrate import solve_bvp
from scipy.optimize import minimize_scalar

# Alfano and Crisfield (2001), Table I: N, mm; the release rate is that of the whole joint
LENGTH, HEIGHT, WIDTH, MODULUS, SHEAR, RELEASE = 100.0, 1.5, 20.0, 135.3e3, 5.2e3, 0.28
AREA = WIDTH * HEIGHT
BENDING, AXIAL, SHEARING = MODULUS * WIDTH * HEIGHT**3 / 12, MODULUS * AREA, 5 / 6 * SHEAR * AREA
CASES = [(strength, crack) for crack in (30.0, 50.0) for strength in (5.0, 10.0, 30.0, 57.0)]
# of the residual, relative as in solve_bvp
TOLERANCE = 1e-6
NAME = "double_cantilever.csv"
REMARKS = (
    "The largest force on double cantilever beams with an initial crack, computed without finite elements by verification/double_cantilever.py.",
    "One arm: 100 x 20 x 1.5 mm, 135.3 GPa, G 5.2 GPa, shear correction 5/6; the exponential law with half of 280 J/m2. Good to 1e-7.",
)


class Arm:
    """One arm; y in units of d."""

    def __init__(self, strength, crack):
        self.strength, self.tip, self.crack = strength, LENGTH - crack, crack
        self.scale = 0.5 * RELEASE / (np.e * strength)
        # dense next to the tip, at z = 1 of the part that adheres; every solution begins on this mesh
        self.mesh = 1 - (1 - np.linspace(0, 1, 1500)) ** 2
        self.last = None

    def slopes(self, _, v):
        """Those of y, theta, V, M along the part that adheres, and along the crack."""
        out = np.empty_like(v)
        for part, length in ((0, self.tip), (4, self.crack)):
            y, theta, V, M = v[part : part + 4]
            sin, cos = np.sin(theta), np.cos(theta)
            stretch, slide = 1 + V * sin / AXIAL, V * cos / SHEARING
            out[part] = length * (stretch * sin + slide * cos) / self.scale
            out[part + 1] = length * M / BENDING
            out[part + 2] = length * WIDTH * self.strength * y * np.exp(1 - np.maximum(y, -5)) if part == 0 else 0
            out[part + 3] = -length * V * (stretch * cos - slide * sin)
        return out

    def force(self, u):
        """P at the opening u of the arm."""

        def ends(a, b):
            return np.array([a[2], a[3], b[7], b[4] - u / self.scale, *(b[:4] - a[4:])])

        # what is at rest solves the linear problem in one step
        guess = np.zeros((8, self.mesh.size)) if self.last is None else self.last(self.mesh)
        found = solve_bvp(self.slopes, ends, self.mesh, guess, tol=TOLERANCE, max_nodes=100_000)
        assert found.success, found.message
        self.last = found.sol
        return found.y[6, -1]


def peak(strength, crack):
    """The largest force."""
    arm = Arm(strength, crack)
    slender = crack**2 * np.sqrt(RELEASE * WIDTH / BENDING) / 3
    openings, forces = [0.05 * slender], [arm.force(0.05 * slender)]
    while len(forces) < 2 or forces[-1] > forces[-2]:
        openings.append(openings[-1] + 0.05 * slender)
        forces.append(arm.force(openings[-1]))
    found = minimize_scalar(lambda u: -arm.force(u), bracket=tuple(openings[-3:]), tol=1e-5)
    return -found.fun


def rows():
    for strength, crack in CASES:
        force, slender = peak(strength, crack), np.sqrt(WIDTH * RELEASE * BENDING) / crack
        print(f"{strength} MPa, crack of {crack} mm: {force:.9g} N; slender arms {slender:.4g} N")
        yield {"strength_MPa": strength, "crack_mm": crack, "peak_N": force}


if __name__ == "__main__":
    tables.run(__doc__.split("\n")[0], [(NAME, REMARKS, lambda: list(rows()))], relative=1e-7)

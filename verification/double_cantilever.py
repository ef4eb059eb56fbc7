#!/usr/bin/env python3
"""Double cantilever beams and T-peels with an initial crack: forces. Writes double_cantilever.csv, t_peel.csv and unhealed.csv.

One arm on the plane of symmetry, which carries half of the work and half of the opening. The arm is a geometrically exact beam without
horizontal force: y' = (1 + eps) sin(theta) + gamma cos(theta), theta' = M/EI, V' = b T(y), M' = -x' V, with eps = V sin(theta)/EA and
gamma = V cos(theta)/GAs. The interface is the exponential law T = sigma y/d exp(1 - y/d), d = w/(e sigma), over 0 < S < L - a, and nothing
beyond. V = M = 0 at S = 0, M = 0 and y = u at the load. scipy's solve_bvp solves it on both sides of the tip at once, from opening to
opening; the peak is the largest P over u, by Brent's method. A T-peel is the same, of films: they turn upright, and the force becomes
steady where P + P^2/2EA = w b of an arm.

Arms that do not heal are opened first, and brought back a way. There the opening is y + (h/2)(1 - cos theta), whose moment about the axis
counts as well, M' = b T (h/2) sin(theta) - x' V. Where it is less than it was, T falls in a straight line to nothing where it is closed.

Printed beside it: linear elastic fracture mechanics of slender arms, P = sqrt(b G EI)/a.
"""
from dataclasses import dataclass

import numpy as np
import tables
from scipy.integrate import solve_bvp
from scipy.optimize import minimize_scalar



@dataclass(frozen=True)
class Beam:
    """One arm: N, mm; the release rate is that of the whole joint."""

    length: float
    height: float
    width: float
    modulus: float
    shear: float
    release: float

    @property
    def bending(self):
        return self.modulus * self.width * self.height**3 / 12

    @property
    def axial(self):
        return self.modulus * self.width * self.height

    @property
    def shearing(self):
        return 5 / 6 * self.shear * self.width * self.height


# Alfano and Crisfield (2001), Table I
LAMINATE = Beam(length=100.0, height=1.5, width=20.0, modulus=135.3e3, shear=5.2e3, release=0.28)
# scenes/t-peel.toml
FILM = Beam(length=15.0, height=0.075, width=25.0, modulus=3.5e3, shear=3.5e3 / 2.7, release=0.2)
FILM_STRENGTH, FILM_CRACK, FILM_OPENINGS = 0.5, 5.0, (0.5, 1.0, 2.0, 4.0, 5.5, 7.0, 9.0)
# of which arms, their strength and crack, the opening, the openings to which it comes back, and the step from opening to opening
BACK = [
    (LAMINATE, 5.0, 30.0, 3.0, (1.5, 0.3), 0.3),
    (FILM, FILM_STRENGTH, FILM_CRACK, 2.0, (1.5, 0.5), 0.1),
    (FILM, FILM_STRENGTH, FILM_CRACK, 5.0, (3.0, 1.0), 0.1),
]
CASES = [(strength, crack) for crack in (30.0, 50.0) for strength in (5.0, 10.0, 30.0, 57.0)]
# of the residual, relative as in solve_bvp
TOLERANCE = 1e-6
NAME, FILM_NAME, BACK_NAME = "double_cantilever.csv", "t_peel.csv", "unhealed.csv"
REMARKS = (
    "The largest force on double cantilever beams with an initial crack, computed without finite elements by verification/double_cantilever.py.",
    "One arm: 100 x 20 x 1.5 mm, 135.3 GPa, G 5.2 GPa, shear correction 5/6; the exponential law with half of 280 J/m2. Good to 1e-7.",
)
FILM_REMARKS = (
    "Forces of a T-peel at openings of one arm, computed without finite elements by verification/double_cantilever.py.",
    "One arm: 15 x 25 x 0.075 mm, 3.5 GPa, nu 0.35, shear correction 5/6, crack 5 mm; the exponential law, half of 200 J/m2, 0.5 MPa. Good to 1e-7.",
)
BACK_REMARKS = (
    "Forces of arms that were opened to opened_mm and brought back to opening_mm, where nothing heals, by verification/double_cantilever.py.",
    "The arms of the double cantilever beam and of the T-peel, of the other tables, with the moment of the adhesion about the axis. Good to 1e-7.",
)


class Arm:
    """One arm; y in units of d. Its law has a lever arm about the axis where it is `tilted`."""

    def __init__(self, beam, strength, crack, tilted=False):
        self.lever = 0.5 * beam.height if tilted else 0.0
        # the largest opening so far over z, where nothing heals
        self.farthest = None
        self.beam, self.strength, self.tip, self.crack = beam, strength, beam.length - crack, crack
        self.scale = 0.5 * beam.release / (np.e * strength)
        # dense next to the tip, at z = 1 of the part that adheres; every solution begins on this mesh
        self.mesh = 1 - (1 - np.linspace(0, 1, 1500)) ** 2
        self.last, self.at = None, 0.0

    def traction(self, z, y, theta):
        """T over the strength."""
        opening = y + self.lever * (1 - np.cos(theta)) / self.scale
        virgin = opening * np.exp(1 - np.maximum(opening, -5))
        if self.farthest is None:
            return virgin
        far = self.farthest(z)
        return np.where((opening > 0) & (opening < far), opening * np.exp(1 - far), virgin)

    def stay_spent(self):
        """From here on its law goes by how far it is open."""
        at = self.last
        self.farthest = lambda z: at(z)[0] + self.lever * (1 - np.cos(at(z)[1])) / self.scale

    def slopes(self, z, v):
        """Those of y, theta, V, M along the part that adheres, and along the crack."""
        out = np.empty_like(v)
        for part, length in ((0, self.tip), (4, self.crack)):
            y, theta, V, M = v[part : part + 4]
            sin, cos = np.sin(theta), np.cos(theta)
            stretch, slide = 1 + V * sin / self.beam.axial, V * cos / self.beam.shearing
            out[part] = length * (stretch * sin + slide * cos) / self.scale
            out[part + 1] = length * M / self.beam.bending
            line = self.beam.width * self.strength * self.traction(z, y, theta) if part == 0 else 0
            out[part + 2] = length * line
            out[part + 3] = length * (line * self.lever * sin - V * (stretch * cos - slide * sin))
        return out

    def force(self, u):
        """P at the opening u of the arm."""

        def ends(a, b):
            return np.array([a[2], a[3], b[7], b[4] - u / self.scale, *(b[:4] - a[4:])])

        # what is at rest solves the linear problem in one step
        guess = np.zeros((8, self.mesh.size)) if self.last is None else self.last(self.mesh)
        # what does not heal goes back nearly in proportion
        guess = guess * (u / self.at if self.farthest is not None else 1)
        found = solve_bvp(self.slopes, ends, self.mesh, guess, tol=TOLERANCE, max_nodes=100_000 if self.farthest is None else 6000)
        # T of what does not heal has a kink where the opening is zero, next to which no mesh is fine enough: there the residual counts by its length
        missed = np.sum(found.rms_residuals * np.diff(found.x))
        assert found.success or self.farthest is not None and missed < TOLERANCE, (found.message, missed)
        self.last, self.at = found.sol, u
        return found.y[6, -1]


def peak(strength, crack):
    """The largest force."""
    arm = Arm(LAMINATE, strength, crack)
    slender = crack**2 * np.sqrt(LAMINATE.release * LAMINATE.width / LAMINATE.bending) / 3
    openings, forces = [0.05 * slender], [arm.force(0.05 * slender)]
    while len(forces) < 2 or forces[-1] > forces[-2]:
        openings.append(openings[-1] + 0.05 * slender)
        forces.append(arm.force(openings[-1]))
    found = minimize_scalar(lambda u: -arm.force(u), bracket=tuple(openings[-3:]), tol=1e-5)
    return -found.fun


def rows():
    for strength, crack in CASES:
        force, slender = peak(strength, crack), np.sqrt(LAMINATE.width * LAMINATE.release * LAMINATE.bending) / crack
        print(f"{strength} MPa, crack of {crack} mm: {force:.9g} N; slender arms {slender:.4g} N")
        yield {"strength_MPa": strength, "crack_mm": crack, "peak_N": force}


def film_rows():
    """From opening to opening, in steps that the Newton method of solve_bvp follows."""
    arm, at = Arm(FILM, FILM_STRENGTH, FILM_CRACK), 0.0
    for opening in FILM_OPENINGS:
        for u in np.linspace(at, opening, 1 + max(1, round((opening - at) / 0.1)))[1:]:
            force = arm.force(u)
        at = opening
        print(f"T-peel, opening of an arm of {opening} mm: {force:.10g} N")
        yield {"opening_mm": opening, "force_N": force}
    work = 0.5 * FILM.release * FILM.width
    steady = FILM.axial * (np.sqrt(1 + 2 * work / FILM.axial) - 1)
    print(f"steady force P + P^2/2EA = w b: {steady:.10g} N")


def back_rows():
    """Opened in steps, and brought back in steps."""
    for beam, strength, crack, opened, back, step in BACK:
        arm = Arm(beam, strength, crack, tilted=True)
        for u in np.linspace(0, opened, 1 + round(opened / step))[1:]:
            force = arm.force(u)
        known = {"length_mm": beam.length, "strength_MPa": strength, "crack_mm": crack, "opened_mm": opened}
        print(f"{beam.length} mm, {strength} MPa, crack of {crack} mm, opened to {opened} mm: {force:.10g} N")
        yield known | {"opening_mm": opened, "force_N": force}
        arm.stay_spent()
        at = opened
        for opening in back:
            for u in np.linspace(at, opening, 1 + max(1, round((at - opening) / step)))[1:]:
                force = arm.force(u)
            at = opening
            print(f"    back to {opening} mm: {force:.10g} N, {force / opening:.10g} N/mm")
            yield known | {"opening_mm": opening, "force_N": force}


if __name__ == "__main__":
    written = [(NAME, REMARKS, rows), (FILM_NAME, FILM_REMARKS, film_rows), (BACK_NAME, BACK_REMARKS, back_rows)]
    tables.run(__doc__.split("\n")[0], [(name, remarks, lambda rows=rows: list(rows())) for name, remarks, rows in written], relative=1e-7)

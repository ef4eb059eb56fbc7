#!/usr/bin/env python3
"""Steady peeling of a tape whose adhesive resists its opening, straight up at a constant velocity of the grip. Writes opening_rate.csv.

By solve_bvp of scipy along the tape, in the frame that moves with the front; no elements, no steps in time. Reissner's beam with EA, GA_s, EI, all of it
a half space's exponential law of work w and strength s on the bonded face, which is a height h/2 below the axis and open by
    d = y + (h/2)(1 - cos theta),   y the lift of the axis:
    a(d) = s t exp(1 - t),  t = d/r,  r = w/(s e);   traction a(d) (1 + <dd/dt>/v0)^n, of what opens.
The front comes along the tape at c, V = c (1 + P/EA) being the velocity of the grip, for what is peeled stands upright and is stretched by P. Steadily
dd/dt = c dd/dS. What was bonded has no force along the substrate. With Q = P at the grip,
    y' = (1 + G1) sin + G2 cos,  x' = (1 + G1) cos - G2 sin,  G1 = Q sin/EA,  G2 = Q cos/GA,  theta' = M/EI,
    Q' = b a g,   M' = -x' Q + b a g (h/2) sin theta.
Expected of every row: P + P^2/(2 EA) = b (w + integral of a (g - 1) over the opening), the balance of power, which is checked on every run; without a
rate (V = 0) the same with w alone.
"""
from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import solve_bvp

import tables

REMARKS = (
    "Steady force of a tape peeled straight up at a constant velocity of the grip, whose adhesive resists its opening; by verification/opening_rate.py.",
    "Exponential law; reference and exponent: traction times (1 + rate of opening/reference)^exponent. Velocity 0: at rest. Good to the digits printed.",
)
COLUMNS = ("height_um", "youngs_modulus_GPa", "poissons_ratio", "width_mm", "work_J_per_m2", "strength_MPa", "reference_um_per_s", "exponent",
           "velocity_um_per_s", "force_N")
DIGITS = 7
TOLERANCE = 1e-6


@dataclass(frozen=True)
class Tape:
    """In um, s, N: N/um = 1e6 N/m, so that 1 GPa is 1e-3 N/um^2, and 1 J/m2 = 1e-6 N/um."""
    height: float = 50.0
    young: float = 2.0
    poisson: float = 0.35
    width: float = 25.0
    work: float = 100.0
    strength: float = 0.5
    reference: float = 10.0
    exponent: float = 0.4
    velocity: float = 1000.0

    @property
    def b(self):
        return 1e3 * self.width

    @property
    def axial(self):
        return 1e-3 * self.young * self.b * self.height

    @property
    def shear(self):
        # 5/6 of G A
        return 5.0 / 6.0 * self.axial / (2.0 * (1.0 + self.poisson))

    @property
    def bending(self):
        return self.axial * self.height ** 2 / 12.0

    @property
    def range(self):
        return 1e-6 * self.work / (1e-6 * self.strength * np.e)

    @property
    def bend(self):
        """The length over which the tape bends up at rest, um."""
        return np.sqrt(self.bending / (1e-6 * self.work * self.b))

    def units(self):
        """Of y, theta, Q, M and the power, and of the force."""
        force = 1e-6 * self.work * self.b
        return np.array([[self.bend], [1.0], [force], [force * self.bend], [force]]), force

    def attraction(self, d):
        t = d / self.range
        return 1e-6 * self.strength * t * np.exp(1.0 - t)

    def growth(self, rate):
        return (1.0 + np.maximum(rate, 0.0) / self.reference) ** self.exponent


def slopes(tape, z, force):
    """Derivatives along S of y, theta, Q, M and of the power of the adhesive over c b."""
    y, theta, q, m, _ = z
    sin, cos = np.sin(theta), np.cos(theta)
    stretch, slide = q * sin / tape.axial, q * cos / tape.shear
    dx, dy = (1.0 + stretch) * cos - slide * sin, (1.0 + stretch) * sin + slide * cos
    turn = m / tape.bending
    half = 0.5 * tape.height
    opening, opens = y + half * (1.0 - cos), dy + half * sin * turn
    c = tape.velocity / (1.0 + force / tape.axial)
    attraction = tape.attraction(opening)
    load = tape.b * attraction * np.where(attraction > 0.0, tape.growth(c * opens), 1.0)
    return np.vstack([dy, turn, load, -dx * q + load * half * sin, (load - tape.b * attraction) * opens])


def steady(tape, length, lift, guess=None, tolerance=TOLERANCE):
    """The solution, in units of the tape. It is as long as this, lies at rest on its left and is lifted by so much on its right."""
    unit, whole = tape.units()

    def rhs(_, z, p):
        return slopes(tape, z * unit, p[0] * whole) * tape.bend / unit

    def ends(left, right, p):
        return np.array([left[0], left[1], left[4], right[3], right[0] - lift, right[2] - p[0]])

    if guess is None:
        s = np.linspace(0.0, length, 400)
        peeled = np.maximum(s - (length - lift), 0.0)
        angle = 0.5 * np.pi * (1.0 - np.exp(-peeled))
        height = np.concatenate([[0.0], np.cumsum(0.5 * (np.sin(angle[1:]) + np.sin(angle[:-1])) * np.diff(s))])
        there = peeled > 0.0
        guess = (s, np.vstack([height, angle, 1.0 * there, there * 0.5 * np.pi * np.exp(-peeled), 0.0 * s]), [1.0])
    s, z, p = guess
    found = solve_bvp(rhs, ends, s, z, p=p, tol=tolerance, max_nodes=100_000)
    if not found.success:
        raise RuntimeError(f"{tape}: {found.message}")
    return found


def solved(tape, length, lift, tolerance):
    """By the velocity, from rest on."""
    found = steady(replace(tape, velocity=0.0), length, lift, tolerance=1e-4)
    if tape.velocity > 0.0:
        first = 1e-2 * tape.reference
        for velocity in np.geomspace(first, tape.velocity, 2 + int(4 * np.log10(tape.velocity / first))):
            found = steady(replace(tape, velocity=velocity), length, lift, (found.x, found.y, found.p), 1e-4)
    return steady(tape, length, lift, (found.x, found.y, found.p), tolerance)


def compute(tape):
    """Force, N, to the digits on which two lengths and tolerances agree."""
    one, other = solved(tape, 26.0, 13.0, TOLERANCE), solved(tape, 30.0, 16.0, 10.0 * TOLERANCE)
    whole = tape.units()[1]
    force = float(one.p[0]) * whole
    differs = abs(other.p[0] / one.p[0] - 1.0)
    work = force + force ** 2 / (2.0 * tape.axial)
    balance = abs(work / (tape.b * 1e-6 * tape.work + whole * one.y[4, -1]) - 1.0)
    print(f"{tape}: {force:.9g} N, two lengths differ by {differs:.1e}, balance {balance:.1e}")
    if differs > 0.5 * 10.0 ** -DIGITS or balance > 10.0 ** -DIGITS:
        raise RuntimeError(f"{tape}: differs by {differs:.1e}, balance {balance:.1e}")
    return force


D = Tape()
CASES = [
    replace(D, velocity=0.0),
    *(replace(D, velocity=10.0 ** k) for k in range(0, 6)),
    *(replace(D, exponent=1.0, velocity=v) for v in (1.0, 10.0, 100.0)),
    *(replace(D, exponent=0.2, velocity=v) for v in (100.0, 1e5)),
    *(replace(D, height=25.0, velocity=v) for v in (100.0, 1e4)),
    replace(D, strength=2.0, velocity=1000.0),
]


def rows():
    for tape in CASES:
        values = (tape.height, tape.young, tape.poisson, tape.width, tape.work, tape.strength, tape.reference, tape.exponent, tape.velocity)
        yield dict(zip(COLUMNS, (*values, float(f"{compute(tape):.{DIGITS}g}"))))


if __name__ == "__main__":
    tables.run(__doc__.split("\n")[0], [("opening_rate.csv", REMARKS, lambda: list(rows()))], relative=3e-7)

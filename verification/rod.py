"""Reissner's planar beam as an initial value problem, for shooting. No finite elements.

Without distributed loads the section forces H (along x) and V (along y) are constant, and with N = H cos θ + V sin θ,
Q = V cos θ - H sin θ

  x' = (1 + N/EA) cos θ - Q/GA sin θ,   y' = (1 + N/EA) sin θ + Q/GA cos θ,   θ' = κ0(S) + M/EI,   M' = H y' - V x'.

The last is moment equilibrium of a piece of the axis: dM + dx V - dy H = 0. Units are those of L = 1 and EI = 1.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

# A step of Dormand and Prince's code of order 8 is accepted at this error, relative and absolute.
RELATIVE, ABSOLUTE = 1e-13, 1e-14
TINY = 1e-40


@dataclass(frozen=True)
class Rod:
    """A rod of length 1 with EI = 1; curvature: κ0 = k0 + k1 S + k2 S²."""

    axial: float
    shear: float
    curvature: tuple = (0.0, 0.0, 0.0)

    def slopes(self, s, state, horizontal, vertical):
        """Right sides for state = (x, y, θ, M), each a number or an array."""
        _, _, rotation, moment = state
        cos, sin = np.cos(rotation), np.sin(rotation)
        stretch = 1.0 + (horizontal * cos + vertical * sin) / self.axial
        slide = (vertical * cos - horizontal * sin) / self.shear
        dx, dy = stretch * cos - slide * sin, stretch * sin + slide * cos
        k0, k1, k2 = self.curvature
        turn = k0 + s * (k1 + s * k2) + moment
        return np.array([dx, dy, turn, horizontal * dy - vertical * dx])

    def end(self, rotation, moment, horizontal, vertical):
        """State at S = 1 from x = y = 0, θ and M at S = 0, and its derivatives by these four numbers (rows: the state).

        The derivatives come from complex steps: the system is integrated once for each number with an imaginary part of
        1e-40 on it, which costs no digits.
        """
        number = np.array([rotation, moment, horizontal, vertical], dtype=float)
        moved = number[:, None] + 1j * TINY * np.eye(4)
        start = np.array([np.zeros(4), np.zeros(4), moved[0], moved[1]], dtype=complex)
        found = solve_ivp(
            lambda s, y: self.slopes(s, y.reshape(4, 4), moved[2], moved[3]).ravel(),
            (0.0, 1.0),
            start.ravel(),
            method="DOP853",
            rtol=RELATIVE,
            atol=ABSOLUTE,
        )
        state = found.y[:, -1].reshape(4, 4)
        return state[:, 0].real, state.imag / TINY


def newton(equations, start, tolerance=1e-12, most=30):
    """Root of a function that returns values and a square matrix of derivatives; stops at the first update that is small."""
    unknown = np.array(start, dtype=float)
    for _ in range(most):
        value, slope = equations(unknown)
        update = np.linalg.solve(slope, value)
        unknown -= update
        if np.max(np.abs(update)) < tolerance * (1.0 + np.max(np.abs(unknown))):
            return unknown
    raise RuntimeError(f"Newton's method did not converge: last update {np.max(np.abs(update)):.1e}")

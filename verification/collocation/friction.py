"""Friction between the bottom face of a strip and a flat substrate.

The bottom face's point of a section is at x_b = x + (h/2) sin theta, its gap is d = y - (h/2) cos theta. A traction t (GPa, per
undeformed area) resists x_b: the virtual work b t (dx + (h/2) cos theta dtheta) per length gives
    H' = b t,   M' = ... + b t (h/2) cos theta.
Each point is tied to an anchor a(S), at rest S itself, by a spring that holds up to a limit; with e = x_b - a
    t = k e  up to  |t| = tau(d),   then  t = sign(e) tau(d)  and the anchor comes along:  a = x_b - t/k.
    tau(d) = tau0 w + mu q(p),   w = 1 - z^3 (10 - 15 z + 6 z^2),   z = clamp((d - d_eq)/(d_c - d_eq), 0, 1),
    q = p^3/(p^2 + p_s^2) where p > 0, else 0,   p = T(d) of the half space,   p_s = 0.1 |T(d_c)|,
d_eq = 15^(-1/6) r0 where T = 0, d_c = 5^(-1/6) r0 where it attracts most. By default k = -T'(d_eq).
While no point slides back, a = S in this formula gives the same t ("deformation form"): sign(e) min(k |x_b - S|, tau).
"""
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Friction:
    tau0: float                          # GPa
    mu: float = 0.0
    stiffness: float | None = None       # GPa/nm; None: that of the half space across the substrate at d_eq

    def k(self, c):
        if self.stiffness is not None:
            return self.stiffness
        return c.K / c.r0 ** 2 * (15.0 ** (10 / 6) / 5.0 - 15.0 ** (4 / 6))

    def gaps(self, c):
        """d_eq, d_c."""
        return c.r0 * 15.0 ** (-1 / 6), c.r0 * 5.0 ** (-1 / 6)

    def limit(self, c, d, near):
        """tau(d) and its derivative. near(c, d): W, T, dT/dd of the half space."""
        a, b = self.gaps(c)
        z = np.clip((d - a) / (b - a), 0.0, 1.0)
        tau = self.tau0 * (1.0 - z ** 3 * (10.0 - 15.0 * z + 6.0 * z * z))
        slope = -self.tau0 * 30.0 * (z * (1.0 - z)) ** 2 / (b - a)
        if self.mu:
            _, T, dT = near(c, d)
            p = np.maximum(T, 0.0)
            s2 = (0.1 * near(c, b)[1]) ** 2
            tau = tau + self.mu * p ** 3 / (p * p + s2)
            slope = slope + self.mu * p * p * (p * p + 3.0 * s2) / (p * p + s2) ** 2 * np.where(T > 0.0, dT, 0.0)
        return tau, slope

    def stretched(self, c, z):
        """e, and the gap d."""
        return z[..., 4] + 0.5 * c.height * np.sin(z[..., 1]) - c.slid, z[..., 0] + c.height * np.sin(0.5 * z[..., 1]) ** 2

    def traction(self, c, z, near):
        """t and its derivatives to g, theta, w."""
        e, d = self.stretched(c, z)
        tau, slope = self.limit(c, d, near)
        k, arm, rise = self.k(c), 0.5 * c.height * np.cos(z[..., 1]), 0.5 * c.height * np.sin(z[..., 1])
        sticks, sign = k * np.abs(e) <= tau, np.sign(e)
        return (np.where(sticks, k * e, sign * tau), np.where(sticks, 0.0, sign * slope),
                np.where(sticks, k * arm, sign * slope * rise), np.where(sticks, k, 0.0))

    def corners(self, c, z, near):
        """Functions of a state whose zeros are where a formula changes."""
        e, d = self.stretched(c, z)
        a, b = self.gaps(c)
        return self.k(c) * np.abs(e) - self.limit(c, d, near)[0], d - a, d - b

    def slip(self, c, z, near):
        """How far the anchor has come from where `slid` has it, and tau."""
        e, d = self.stretched(c, z)
        tau = self.limit(c, d, near)[0]
        return e - np.clip(e, -tau / self.k(c), tau / self.k(c)), tau

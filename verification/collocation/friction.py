"""Friction between the bottom face of a strip and a flat substrate.

The bottom face's point of a section is at x_b = x + (h/2) sin theta, its gap is d = y - (h/2) cos theta. A traction t (GPa, per
undeformed area) resists x_b: the virtual work b t (dx + (h/2) cos theta dtheta) per length gives
    H' = b t,   M' = ... + b t (h/2) cos theta.
Each point carries a share s of what it can, after Dahl (1968), with the upper sign where x_b grows:
    t = s tau(d),   ds = (1 -+ s) dx_b/delta,   s = 0 at rest,
    tau = w (tau0 + mu (q(p) - q(0))),   w = (1 + 1/81)/(1 + (d/d_max)^24),   q = (p + (p^2 + p_s^2)^(1/2))/2,   p = T(d) of the half space,
    p_s = min(|T(d_max)|/10, tau0/mu),   d_max = 5^(-1/6) r0, where the half space attracts most.
By default delta = tau0/(-T'(d_eq)). From x_b0 and s0 on, and until the point turns back,
    s = +-1 - (+-1 - s0) exp(-|x_b - x_b0|/delta):
with x_b0 = S and s0 = 0 this is exact while it has never turned ("one-way form").
"""
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, kw_only=True)
class Friction:
    tau0: float                          # GPa
    mu: float = 0.0
    presliding: float | None = None      # delta, nm; None: the stick is as stiff as the half space across the substrate at d_eq

    def delta(self, c):
        return self.tau0 * c.r0 ** 2 / (c.K * (15.0 ** (10 / 6) / 5.0 - 15.0 ** (4 / 6))) if self.presliding is None else self.presliding

    def farthest(self, c):
        """d_max."""
        return c.r0 * 5.0 ** (-1 / 6)

    def limit(self, c, d, near):
        """tau(d) and its derivative. near(c, d): W, T, dT/dd of the half space."""
        far = (d / self.farthest(c)) ** 24
        w = (82 / 81) / (1.0 + far)
        slope = -24.0 * w * far / (d * (1.0 + far))
        if not self.mu:
            return w * self.tau0, slope * self.tau0
        _, p, dp = near(c, d)
        onset = min(0.1 * abs(near(c, self.farthest(c))[1]), self.tau0 / self.mu)
        root = np.sqrt(p * p + onset ** 2)
        held = self.tau0 + 0.5 * self.mu * (p + root - onset)
        return w * held, slope * held + w * 0.5 * self.mu * (1.0 + p / root) * dp

    def face(self, c, z):
        """x_b - x_b0, and the gap d."""
        return z[..., 4] + 0.5 * c.height * np.sin(z[..., 1]) - c.slid, z[..., 0] + c.height * np.sin(0.5 * z[..., 1]) ** 2

    def share(self, c, way):
        """s and ds/dx_b, x_b - x_b0 on."""
        sense = np.where(way < 0.0, -1.0, 1.0)
        x = np.abs(way) / self.delta(c)
        left = np.exp(-x)
        return c.share * left - sense * np.expm1(-x), (1.0 - sense * c.share) * left / self.delta(c)

    def traction(self, c, z, near):
        """t and its derivatives to g, theta, w."""
        way, d = self.face(c, z)
        (tau, slope), (s, rate) = self.limit(c, d, near), self.share(c, way)
        arm, rise = 0.5 * c.height * np.cos(z[..., 1]), 0.5 * c.height * np.sin(z[..., 1])
        return tau * s, slope * s, slope * s * rise + tau * rate * arm, tau * rate

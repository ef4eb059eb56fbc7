"""The stability of a planar equilibrium against leaving its plane, by shooting: no energy is discretised.

Of the strong form of the spatial Simo-Reissner beam with directors d1 (axis), d2 = -e_z (width) and d3 (height),
    r' = R (e1 + G),  q' = 1/2 q o (0, K),  n' = Psi_y e_y,  m' = -r' x n + b Psi_a d2 x e_y + h Psi_c d3 x e_y   (a = b d2.e_y, c = h d3.e_y),
the part out of the plane, linearised at a planar state (theta, V, M; no force along x or z, no moment about y), is
    dK1 = (c mx + M (s wx - c wy))/GJ,   dK3 = (-s mx + M (c wx + s wy))/EI3,   wx' = c dK1 - s dK3,   wy' = s dK1 + c dK3,
    zeta' = (y' - V/GA) wx - x' wy,   mx' = V zeta' + b^2 Psi_aa wx - h Psi_c (c wx + s wy),     c = cos theta, s = sin theta,
for the rotation vector (wx, wy, 0), the shift zeta and the moment mx about x. From wx = 1, wy = 0 (a turn about the normal is free), mx = 0 at the left
end it is integrated to the right one: a neighbouring equilibrium is there where mx(L) = 0. How many negative eigenvalues there are says Sturm's count of
the zeros of phi in the scalar problem phi' = beta phi + alpha p, p' = kappa phi - beta p, phi = 1, p = 0 on the left (see `scalar`).
Psi_aa is Psi_yy/12 of the planar density, which is averaged over the width.
"""
import math
from functools import lru_cache

import numpy as np

from .law import _near, potential
from .system import Rule
from .turns import divided

PARTS = 3                                                             # of each sub-interval of the planar solution
POINTS = 12                                                           # of collocation on each part
STIFF = 2.0                                                           # most decay lengths of the roll on a part


@lru_cache(maxsize=100000)
def rectangle(b, h):
    """Saint-Venant's torsion constant of a rectangle: the series itself, the rest of it as an integral."""
    a, t = max(b, h), min(b, h)
    n = np.arange(1.0, 802.0, 2.0)[::-1]
    sum = float(np.sum(np.tanh(0.5 * n * math.pi * a / t) / n ** 5)) + 0.125 / (n[0] + 1.0) ** 4
    return a * t ** 3 * (1.0 / 3.0 - 64.0 * t / (math.pi ** 5 * a) * sum)


def lateral(c, b, S):
    """GJ and EI3 of a section between a rectangle and an ellipse."""
    h, q = c.height, c.form(S).roundness if hasattr(c, "form") else 0.0
    J = np.vectorize(rectangle, otypes=[float])(b, h)
    J = J + q * (math.pi * (b * h) ** 3 / (16.0 * (b * b + h * h)) - J)
    I3 = h * b ** 3 / 12.0 * (1.0 + (12.0 * math.pi / 64.0 - 1.0) * q)
    return c.young / (2.0 * (1.0 + c.poisson)) * J, c.young * I3


def lever(c, g, th):
    """h Psi_c of the width b."""
    if c.law == "body-force" and c.line_load == "full":
        half = 0.5 * c.height
        r1, r2 = g + 2.0 * half * np.sin(0.5 * th) ** 2, g + half * (1.0 + np.cos(th))
        (W1, T1, _), (W2, T2, _) = _near(c, r1), _near(c, r2)
        if not c.far_face:
            W2, T2 = np.zeros_like(W1), np.zeros_like(T1)
        edge = c.height * np.cos(th)                                  # Psi = b h [W(y - edge/2) - W(y + edge/2)]/edge
        return c.width * c.height ** 2 * (0.5 * (T1 + T2) / edge - (W1 - W2) / edge ** 2)
    P = potential(c, g, th)                                           # Psi_theta = -h sin Psi_c
    si = np.sin(th)
    level = np.abs(si) < 1e-9
    return -c.width * np.where(level, P[5], P[2] / np.where(level, 1.0, si))


class Roll:
    """The roll of a planar equilibrium `st` of a strip; of a strip as wide as `width`, whose planar equilibrium per width is the same."""

    def __init__(self, strip, st, width=None):
        self.X = divided(st.X, self.parts(strip, st, width))
        R = Rule(POINTS)
        S = self.X[:-1, None] + np.diff(self.X)[:, None] * R.t
        z = st.at(S.ravel()).reshape(*S.shape, -1)
        g, th, V, M = (z[..., k] for k in range(4))
        c = strip.at(S)
        b = width or c.width
        scale = b / c.width
        V, M, EA, GA = V * scale, M * scale, c.EA * scale, c.GA * scale
        co, si = np.cos(th), np.sin(th)
        x1 = (1.0 + V * si / EA) * co - V * co / GA * si
        y1 = (1.0 + V * si / EA) * si + V * co / GA * co
        GJ, EI3 = lateral(c, b, S)
        aa = b ** 3 / 12.0 * potential(c, g, th)[3]
        hc = scale * lever(c, g, th)
        drop = y1 - V / GA
        self.full = self.matrix([[M * si * co * (1 / GJ - 1 / EI3), -M * (co * co / GJ + si * si / EI3), co * co / GJ + si * si / EI3],
                                 [M * (si * si / GJ + co * co / EI3), M * si * co * (1 / EI3 - 1 / GJ), si * co * (1 / GJ - 1 / EI3)],
                                 [V * drop + aa - hc * co, -V * x1 - hc * si, np.zeros_like(V)]])
        beta = M * si * co * (1 / GJ - 1 / EI3)
        kappa = V * drop + aa - hc * co - M * M * (si * si / GJ + co * co / EI3)
        self.scalar = self.matrix([[beta, co * co / GJ + si * si / EI3], [kappa, -beta]])

    @staticmethod
    def parts(strip, st, width):
        """Of each sub-interval: PARTS, or more where the roll grows or decays on a shorter length."""
        S, z = st.points(), st.inner()
        c = strip.at(S)
        b = width or c.width
        GJ, EI3 = lateral(c, b, S)
        stiff = np.sqrt(b ** 3 / 12.0 * np.abs(potential(c, z[..., 0], z[..., 1])[3]) / np.minimum(GJ, EI3)).max(axis=1)
        return np.maximum(PARTS, np.ceil(np.diff(st.X) * stiff / STIFF)).astype(int)

    @staticmethod
    def matrix(rows):
        return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)

    def shot(self, A):
        """(y at all points from left to right) of y' = A y, y(0) = (1, 0, ...); rescaled on the way, so that only signs and ratios count."""
        R, h, d = Rule(POINTS), np.diff(self.X), A.shape[-1]
        N, n = A.shape[:2]
        big = np.eye(n * d) - (h[:, None, None, None, None] * np.einsum("ij,eiab->eiajb", R.A, A)).reshape(N, n * d, n * d)
        K = np.linalg.solve(big, A.reshape(N, n * d, d)).reshape(N, n, d, d)
        inner = np.eye(d) + h[:, None, None, None] * np.einsum("ij,ejab->eiab", R.A, K)
        over = np.eye(d) + h[:, None, None] * np.einsum("j,ejab->eab", R.w, K)
        y, out = np.eye(d)[0], []
        for e in range(N):
            out.append(inner[e] @ y)
            y = over[e] @ y
            size = np.abs(y).max()
            y, out[-1] = y / size, out[-1] / size
            out.append(y[None])
        return np.concatenate(out)

    def ends(self):
        """Moment about x over roll at the grip, by the whole system and by the scalar problem, and the zeros of the roll."""
        full, scalar = self.shot(self.full), self.shot(self.scalar)
        zeros = int(np.sum(scalar[:-1, 0] * scalar[1:, 0] < 0.0))
        return full[-1, 2] / full[-1, 0], scalar[-1, 1] / scalar[-1, 0], zeros

    def modes(self):
        """Negative eigenvalues with a free grip."""
        _, at, zeros = self.ends()
        return zeros + (at < 0.0)

    def margin(self):
        """Falls continuously along anything, through zero where the first mode becomes unstable: of the whole system."""
        at, _, zeros = self.ends()
        return math.atan(at / self.unit()) - math.pi * zeros

    def unit(self):
        return 1.0 / float(np.abs(self.full[..., 0, 2]).max()) / self.X[-1]

"""A cohesive law that holds along the substrate as well, after Xu and Needleman (1994).

The bottom face's point of a section has slipped by t = w + (h/2) sin theta, w = x - S. With Psi = Psi_pull + Psi_push of the cohesive law, what
attracts an open face and what repels a pressed one,
    Psi(x, y, theta) = Psi_pull B(t) + Psi_push,   B = exp(-t^2/delta^2),   delta = (2/e)^(1/2) work/shear_strength:
that of the law alone and  E = Psi_pull C(t),  C = B - 1.  So
    H' = b E_w,   V' = ... + b E_y,   M' = ... + b E_theta.
Where the face is just closed the stiffness of Psi_pull begins: a corner.
"""
import math

import numpy as np

from . import laws


def scale(c):
    """delta, nm."""
    return math.sqrt(2.0 / math.e) * laws.work(c) / c.shear_strength


def stiffness(c):
    """Along the substrate at rest, nN/nm^3."""
    return 2.0 * laws.work(c) / scale(c) ** 2


def pull(c, g, th):
    """Psi_pull with its gradient (y, theta) and Hessian (yy, yt, tt)."""
    t, a, da = laws.opening(c, g, th)
    s, slope, left = laws.COHESIVE[c.law](t)
    is_open = t > 0.0
    s, slope, left = np.where(is_open, s, 0.0), np.where(is_open, slope, 0.0), np.where(is_open, left, laws.COHESIVE[c.law].whole)
    f, k = laws.strength(c) * s, laws.strength(c) / laws.span(c) * slope
    return -laws.strength(c) * laws.span(c) * left, f, f * a, k, k * a, k * a * a + f * da


def excess(c, z):
    """E with its gradient (y, theta, w) and Hessian, rows and columns in the same order."""
    P, Py, Pt, Pyy, Pyt, Ptt = pull(c, z[..., 0], z[..., 1])
    half = 0.5 * c.height
    arm, rise = half * np.cos(z[..., 1]), half * np.sin(z[..., 1])
    t, d2 = z[..., 4] + rise, scale(c) ** 2
    C = np.expm1(-t * t / d2)
    C1 = -2.0 * t / d2 * (C + 1.0)
    C2 = (4.0 * t * t / d2 - 2.0) / d2 * (C + 1.0)
    gradient = Py * C, Pt * C + P * C1 * arm, P * C1
    yt, yw, tw = Pyt * C + Py * C1 * arm, Py * C1, Pt * C1 + P * C2 * arm
    tt = Ptt * C + 2.0 * Pt * C1 * arm + P * (C2 * arm * arm - C1 * rise)
    return P * C, gradient, ((Pyy * C, yt, yw), (yt, tt, tw), (yw, tw, P * C2))


def field(c, z, smooth, jac):
    """z' and its derivatives to z = g, theta, V, M, w, H, from those of the cohesive law alone at H."""
    _, (Ey, Et, Ew), second = excess(c, z)
    b = c.width
    f = np.empty_like(z)
    f[..., :5] = smooth[0] if jac else smooth
    f[..., 2] += b * Ey
    f[..., 3] += b * Et
    f[..., 5] = b * Ew
    if not jac:
        return f
    J = np.zeros(z.shape + (6,))
    J[..., :5, :5], J[..., :5, 5] = smooth[1], smooth[2]
    for row, slopes in zip((2, 3, 5), second):
        for column, slope in zip((0, 1, 4), slopes):
            J[..., row, column] += b * slope
    return f, J, None

"""A cohesive law that holds along the substrate as well, after Xu and Needleman (1994) and van den Bosch, Schreurs and Geers (2006).

The bottom face's point of a section has slipped by t = w + (h/2) sin theta, w = x - S. With Psi = Psi_pull + Psi_push of the cohesive law, what
attracts an open face and what repels a pressed one,
    Psi(x, y, theta) = Psi_pull B(t) + Psi_push,   B = exp(-t^2/delta^2),   delta = (2/e)^(1/2) work/shear_strength:
that of the law alone and  E = Psi_pull C(t),  C = B - 1.  So
    H' = b E_w,   V' = ... + b E_y,   M' = ... + b E_theta.
With a work of slip of its own, k times that of opening, delta is that of this work, and the traction along the substrate k times as large:
    H' = b k E_w,   M' = ... + b (E_theta + (k - 1) E_w (h/2) cos theta),
which has no potential.
With an exponent n of Benzeggagh and Kenane all that is but Psi_push is as many times as large as
    F = 1 + 2 (T - 1) (1 - AB),   T = (1 - m + m/k) (1 + (k - 1) m^n),   m = k q/(p + k q),   p = -ln A,   q = t^2/delta^2,   A = -Psi_pull/work.
Where the face is just closed the stiffness of Psi_pull begins: a corner.
"""
import math

import numpy as np

from . import laws


def shear_work(c):
    """Of slip, nN/nm."""
    return laws.work(c) if c.shear_work is None else c.shear_work


def ratio(c):
    """k."""
    return shear_work(c) / laws.work(c)


def scale(c):
    """delta, nm."""
    return math.sqrt(2.0 / math.e) * shear_work(c) / c.shear_strength


def stiffness(c):
    """Along the substrate at rest, nN/nm^3."""
    return 2.0 * shear_work(c) / scale(c) ** 2


def pull(c, g, th):
    """Psi_pull with its gradient (y, theta) and Hessian (yy, yt, tt)."""
    t, a, da = laws.opening(c, g, th)
    s, slope, left = laws.COHESIVE[c.law](t)
    is_open = t > 0.0
    s, slope, left = np.where(is_open, s, 0.0), np.where(is_open, slope, 0.0), np.where(is_open, left, laws.COHESIVE[c.law].whole)
    f, k = laws.strength(c) * s, laws.strength(c) / laws.span(c) * slope
    return -laws.strength(c) * laws.span(c) * left, f, f * a, k, k * a, k * a * a + f * da


def excess(c, z):
    """E, what stands in place of its gradient (y, theta, w), and the derivatives of that, rows and columns in the same order."""
    P, Py, Pt, Pyy, Pyt, Ptt = pull(c, z[..., 0], z[..., 1])
    half = 0.5 * c.height
    arm, rise = half * np.cos(z[..., 1]), half * np.sin(z[..., 1])
    t, d2 = z[..., 4] + rise, scale(c) ** 2
    C = np.expm1(-t * t / d2)
    C1 = -2.0 * t / d2 * (C + 1.0)
    C2 = (4.0 * t * t / d2 - 2.0) / d2 * (C + 1.0)
    k = ratio(c)
    gradient = Py * C, Pt * C + k * P * C1 * arm, k * P * C1
    wt = k * (Pt * C1 + P * C2 * arm)
    tt = Ptt * C + (1.0 + k) * Pt * C1 * arm + k * P * (C2 * arm * arm - C1 * rise)
    rows = ((Pyy * C, Pyt * C + Py * C1 * arm, Py * C1),
            (Pyt * C + k * Py * C1 * arm, tt, Pt * C1 + k * P * C2 * arm),
            (k * Py * C1, wt, k * P * C2))
    if c.mixing is not None and k != 1.0:
        pulled, zero = (gradient[0] + Py, gradient[1] + Pt, gradient[2]), np.zeros_like(P)
        slopes = ((Pyy, Pyt, zero), (Pyt, Ptt, zero), (zero, zero, zero))
        more, (by_p, by_q) = mixed(c, -P / laws.work(c), t * t / d2)
        # p = -ln(-P/work), q = t^2/d2
        steep = by_p / np.where(P < 0.0, -P, 1.0)
        change = steep * Py, steep * Pt + by_q * 2.0 * t / d2 * arm, by_q * 2.0 * t / d2
        gradient = tuple(of + all_ * more for of, all_ in zip(gradient, pulled))
        rows = tuple(tuple(of + (of + own) * more + pulled[i] * change[j] for j, (of, own) in enumerate(zip(rows[i], slopes[i]))) for i in range(3))
    return P * C, gradient, rows


def mixed(c, A, q):
    """F - 1 of what is left of the law by opening, A, and by slip, exp(-q), and its changes with p and q."""
    k, n = ratio(c), c.mixing
    some = A > 0.0
    p = np.where(some, -np.log(np.where(some, np.minimum(A, 1.0), 1.0)), np.inf)
    here = some & (p + q > 0.0)
    p, q = np.where(here, p, 1.0), np.where(here, q, 1.0)
    m = k * q / (p + k * q)
    lower, upper = 1.0 - m + m / k, 1.0 + (k - 1.0) * m ** n
    T, T1 = lower * upper, (1.0 / k - 1.0) * upper + lower * (k - 1.0) * n * m ** (n - 1.0)
    gone, left = -np.expm1(-p - q), np.exp(-p - q)
    by_m = 2.0 * T1 * gone * k / (p + k * q) ** 2
    more, by_p, by_q = 2.0 * (T - 1.0) * gone, -by_m * q + 2.0 * (T - 1.0) * left, by_m * p + 2.0 * (T - 1.0) * left
    return np.where(here, more, 0.0), (np.where(here, by_p, 0.0), np.where(here, by_q, 0.0))


def beyond(c, z):
    """By how much what stands in place of the gradient of E (y, theta, w) is more than that."""
    P, Py, Pt, *_ = pull(c, z[..., 0], z[..., 1])
    arm = 0.5 * c.height * np.cos(z[..., 1])
    t, d2 = z[..., 4] + 0.5 * c.height * np.sin(z[..., 1]), scale(c) ** 2
    C = np.expm1(-t * t / d2)
    C1 = -2.0 * t / d2 * (C + 1.0)
    return tuple(found - true for found, true in zip(excess(c, z)[1], (Py * C, Pt * C + P * C1 * arm, P * C1)))


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

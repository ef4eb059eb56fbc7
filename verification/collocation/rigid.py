"""The strip in the limit EI, GA_s -> infinity: a rigid body lifted at its end."""
import numpy as np
from scipy.optimize import brentq, minimize_scalar

from .law import potential

PANELS, DEGREE = 400, 20


def loads(c, gap, theta):
    """Force of the grip and what is left of the moment, for the gap of the left end and the tilt.

    V' = b dPsi/dy and M' = -x' V + b dPsi/dtheta with V(0) = M(0) = 0 and x' = cos(theta): P = V(L), and M(L) has to vanish.
    """
    x, w = np.polynomial.legendre.leggauss(DEGREE)
    h = c.length / PANELS
    S = (h * (np.arange(PANELS)[:, None] + 0.5 * (x + 1.0))).ravel()
    W = np.tile(0.5 * h * w, PANELS)
    _, Py, Pt, *_ = potential(c, gap + S * np.sin(theta), np.full_like(S, theta))
    f = c.width * Py
    return W @ f, -np.cos(theta) * (W @ (f * (c.length - S))) + c.width * (W @ Pt)


def peak(c):
    """u and P at the largest force."""
    def at(theta):
        gap = brentq(lambda g: loads(c, g, theta)[1], 0.4 * c.r0, 5.0 ** (-1 / 6) * c.r0, xtol=1e-16)
        return loads(c, gap, theta)[0], gap

    guess = c.r0 / c.length
    best = minimize_scalar(lambda theta: -at(theta)[0], bracket=(0.1 * guess, 0.3 * guess, guess), tol=1e-10)
    P, gap = at(best.x)
    rest = brentq(lambda g: loads(c, g, 0.0)[0], 0.4 * c.r0, 5.0 ** (-1 / 6) * c.r0, xtol=1e-16)
    return gap + c.length * np.sin(best.x) - rest, P

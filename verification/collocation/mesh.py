"""Meshes that equidistribute the local wave number of a solution."""
import numpy as np

from .law import potential
from .system import State


def rest_state(s, N, n):
    """The strip at rest, on a mesh that is fine at the grip."""
    c = s.strip
    S = c.length - np.geomspace(1e-3, c.length, 4000)[::-1] + 1e-3
    rho = (s.lam0 * np.exp(-(c.length - S) * s.lam0 / 12.0)) + 2.0 / c.length
    X, _ = equidistribute(c.length, np.clip(S, 0, c.length), rho, N)
    zn = np.zeros((N + 1, s.d))
    zn[:, 0] = s.g0
    return State(X, zn, np.zeros((N, n, s.d)))


def mesh(s, st, N, n_eff=12.0, quiet=1e-5):
    """N sub-intervals for st, and how many it calls for.

    Equidistributes an estimate of the local wave number times the (1/n_eff)th power of the local activity.
    """
    c = s.strip
    blind = c.line_load == "axis-gap"
    S = st.points().ravel()
    z = st.inner().reshape(-1, s.d)
    f = st.K.reshape(-1, s.d)
    P = potential(c, z[:, 0], z[:, 1])
    k = c.width * np.abs(P[3])
    lam1 = (k / c.EI) ** 0.25
    lams = np.minimum((k / c.GA) ** 0.5, 3.0 * lam1 + 3.0 * s.lam0)
    lam2 = np.sqrt((np.abs(z[:, 2]) + abs(st.H)) / c.EI)
    si = np.sin(z[:, 1])
    gap = z[:, 0] + (0.0 if blind else c.height * np.sin(0.5 * z[:, 1]) ** 2)
    slope = np.abs(f[:, 0] + (0.0 if blind else 0.5 * c.height * si * f[:, 1]))
    lam3 = slope / np.abs(gap)
    act = np.zeros(len(S))
    for a in (1, 2, 3):
        v = np.abs(f[:, a])
        act = np.maximum(act, v / max(v.max(), 1e-300))
    gate = act * act / (act * act + quiet * quiet)        # what is quieter is noise of the discretisation
    rho = ((lam1 + lam2) * act ** (1.0 / n_eff) + lams * act ** 0.33) * gate + 1.5 * lam3 + 2.0 / c.length
    return equidistribute(c.length, S, rho, N)


def equidistribute(L, S, rho, N):
    """N sub-intervals of [0, L] with the same integral of the density rho (at S) each, and that integral over all."""
    X = np.concatenate([[0.0], S, [L]])
    r = np.concatenate([[rho[0]], rho, [rho[-1]]])
    # no abrupt change of the mesh: the density falls at most by e over a length 2/rho
    for order in (range(1, len(X)), range(len(X) - 2, -1, -1)):
        step = 1 if order.step == 1 else -1
        for i in order:
            dx = abs(X[i] - X[i - step])
            q = r[i - step] / (1.0 + 0.25 * dx * r[i - step])
            if q > r[i]:
                r[i] = q
    cum = np.concatenate([[0.0], np.cumsum(0.5 * (r[1:] + r[:-1]) * np.diff(X))])
    out = np.interp(np.linspace(0.0, cum[-1], N + 1), cum, X)
    out[0], out[-1] = 0.0, L
    return out, cum[-1]

"""Meshes that equidistribute the local wave number of a solution, with nodes where the formulas of the section change."""
import numpy as np
from scipy.optimize import brentq

from . import laws
from .law import field, potential
from .system import Rule, State


def rest_state(s, N, n):
    """The beam free of stress, on a mesh that is fine at the grip and where formulas change. What would lie in the substrate is
    put on it."""
    c = s.strip
    S = np.sort(np.concatenate([e - np.geomspace(1e-3, e, 4000)[::-1] + 1e-3 for e in c.ends[1:]]))
    far = np.min([np.abs(e - S) for e in c.ends[1:]], axis=0)
    rho = (s.lam0 * np.exp(-far * s.lam0 / 12.0)) + 2.0 / c.length
    X, _ = equidistribute(c.ends, np.clip(S, 0, c.length), rho, N)
    zn, lift = placed(s, X)
    S = X[:-1, None] + np.diff(X)[:, None] * Rule(n).t
    z, lifted = (v.reshape(*S.shape, *v.shape[1:]) for v in placed(s, S.ravel()))
    K = field(c.at(S), z, 0.0, jac=False)
    K[..., 2:] = 0.0
    K[..., 0] += (lifted - lift[:-1, None]) @ np.linalg.inv(Rule(n).A).T / np.diff(X)[:, None]
    if not c.pretension:
        return State(X, zn, K)
    strain = c.stretch / c.length
    zn[:, 4] = strain * X
    K[..., 4] = strain
    return State(X, zn, K, c.pretension)


def placed(s, S):
    """The beam free of stress and off the substrate at the places S, and by how much it is lifted for that."""
    z = np.zeros((len(S), s.d))
    z[:, 0], z[:, 1] = s.strip.free(S)
    lift = np.maximum(0.0, s.g0 - s.near(S, z))
    z[:, 0] += lift
    return z, lift


def mesh(s, st, N, n_eff=12.0, quiet=1e-5):
    """N sub-intervals for st (or so many on each piece), and how many each piece calls for.

    Equidistributes an estimate of the local wave number times the (1/n_eff)th power of the local activity.
    """
    blind = s.strip.line_load == "axis-gap"
    S = st.points().ravel()
    c = s.strip.at(S)
    z = st.inner().reshape(-1, s.d)
    f = st.K.reshape(-1, s.d)
    P = potential(c, z[:, 0], z[:, 1])
    k = c.width * np.abs(P[3])
    lam1 = (k / c.EI) ** 0.25
    lams = np.minimum((k / c.GA) ** 0.5, 3.0 * lam1 + 3.0 * s.lam0)
    lam2 = np.sqrt((np.abs(z[:, 2]) + np.abs(z[:, 5] if s.d == 6 else st.H)) / c.EI)
    si, lift = np.sin(z[:, 1]), np.sin(0.5 * z[:, 1]) ** 2
    gap = z[:, 0] + (0.0 if blind else c.height * lift)
    slope = np.abs(f[:, 0] + (0.0 if blind else 0.5 * c.height * si * f[:, 1] + c.rise * lift))
    lam3 = slope * (laws.sharpness(c, z[:, 0], z[:, 1]) if c.law in laws.COHESIVE else 1.0 / np.abs(gap))
    act = np.zeros(len(S))
    for a in (1, 2, 3) if s.d < 6 else (1, 2, 3, 5):
        v = np.abs(f[:, a])
        act = np.maximum(act, v / max(v.max(), 1e-300))
    gate = act * act / (act * act + quiet * quiet)        # what is quieter is noise of the discretisation
    if s.d == 6:
        lam1 = lam1 + np.sqrt(c.slip_stiffness * c.width / c.EA)
    rho = ((lam1 + lam2) * act ** (1.0 / n_eff) + lams * act ** 0.33) * gate + 1.5 * lam3 + 2.0 / s.strip.length
    return equidistribute(s.strip.ends, S, rho, N)


def equidistribute(ends, S, rho, N):
    """Sub-intervals with the same integral of the density rho (at S) each on every piece between ends, and that integral over
    each piece. N: how many on each piece, or over all."""
    X = np.concatenate([[0.0], S, [ends[-1]]])
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
    to = np.interp(ends, X, cum)
    loads = np.diff(to)
    counts = shares(loads, N) if np.ndim(N) == 0 else N
    out = np.concatenate([np.interp(np.linspace(a, b, m + 1)[:-1], cum, X) for a, b, m in zip(to, to[1:], counts)] + [ends[-1:]])
    out[np.append(0, np.cumsum(counts))] = ends
    return out, loads


def shares(loads, N):
    """N sub-intervals shared out among pieces, two at least on each."""
    return [N] if len(loads) == 1 else np.maximum(2, np.rint(N * loads / loads.sum()).astype(int))


def counted(s, X):
    """How many sub-intervals of a mesh lie on each piece."""
    return np.diff(np.searchsorted(X, s.strip.ends))


def pin(s, X, counts):
    """Puts the nodes at the ends of the pieces exactly there."""
    X[np.append(0, np.cumsum(counts))] = s.strip.ends


def with_corners(s, st, X):
    """The mesh with a node wherever the opening of st passes a corner of a piecewise law: the nearest one moves there, or a new
    one is put in."""
    c = s.strip
    corners = laws.COHESIVE[c.law].corners if c.law in laws.COHESIVE else ()
    if c.shear_strength is not None:
        corners = (0.0, *corners)
    if not corners and not c.sticks:
        return X
    S = np.sort(np.concatenate([st.X, st.points().ravel()]))
    t = lambda S: laws.opening(c, *st.at(S)[:, :2].T)[0]
    changes = [lambda S, p=p: t(S) - p for p in corners]
    if c.friction:
        changes += [lambda S: c.friction.face(c.at(S), st.at(S))[0]]
    for change in changes:
        at = change(S)
        for i in np.flatnonzero(at[:-1] * at[1:] < 0.0):
            if c.sticks and abs(at[i + 1] - at[i]) < 1e-7:          # of no account far down the strip
                continue
            place = brentq(lambda x: float(change(np.array([x]))[0]), S[i], S[i + 1], xtol=1e-14, rtol=1e-14)
            j = int(np.searchsorted(X, place))
            k = j if X[j] - place < place - X[j - 1] else j - 1
            if c.sticks and abs(X[k] - place) < 1e-9:
                continue
            close = abs(X[k] - place) < 0.2 * (X[j] - X[j - 1])
            if close and 0 < k < len(X) - 1:
                X[k] = place
            else:
                X = np.insert(X, j, place)
    return X

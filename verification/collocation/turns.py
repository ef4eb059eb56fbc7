"""Points at which the path turns, on a mesh that is refined until the solution is resolved."""
import numpy as np

from .mesh import mesh, with_corners
from .solver import Failure
from .system import Rule, State

MOST_INTERVALS = 200


def locate(s, st, what, N, n, tol):
    """The point near st at which the tangent has no component in what turns, "P" or "u", on a mesh that resolves it."""
    def found(st):
        s.border = direction(s, "P" if what == "u" else "u", len(st.X) - 1)
        return turn(s, s.correct(st, tol=1e-11), what)

    return resolved(s, st, found, N, n, tol)


def resolved(s, st, found, N, n, tol):
    """found(st), a solution near st on the mesh of st, on a mesh that resolves it.

    The mesh starts with N sub-intervals and is halved wherever the Chebyshev coefficients of degree n - 2, n - 1 are above
    tol; then the point is found again.
    """
    X, load = mesh(s, st, N, quiet=1e-8)
    if load.sum() > 1.6 * N:
        X, _ = mesh(s, st, int(load.sum() / 1.6) + 1, quiet=1e-8)
    for _ in range(12):
        X = with_corners(s, st, X)
        st = found(st.moved(s.strip, X, n))
        tail = tails(s, st)
        bad = tail > tol
        if not bad.any() or len(X) > MOST_INTERVALS:
            break
        X = divided(X, np.where(tail > 1e4 * tol, 3, np.where(bad, 2, 1)))
    return st


def divided(X, parts):
    """The mesh with each sub-interval in so many parts."""
    return np.concatenate([np.linspace(p, q, k + 1)[:-1] for p, q, k in zip(X[:-1], X[1:], parts)] + [X[-1:]])


def tails(s, st):
    """Per sub-interval: the last Chebyshev coefficients of z' (times the interval), against the scale of each component."""
    F = Rule(st.n).F
    co = np.abs(np.einsum("mk,ika->ima", F, st.K))[:, -2:].max(axis=1) * np.diff(st.X)[:, None]
    size = np.ptp(np.concatenate([st.zn, st.inner().reshape(-1, s.d)]), axis=0)
    size[0] = min(size[0], s.strip.r0)
    return (co / np.maximum(size, 1e-12)).max(axis=1)


def direction(s, what, N):
    """Of "u" or "P" among the scaled unknowns, length 1."""
    row = s.row(what, N) * s.scale(N)
    return row / np.linalg.norm(row)


def turn(s, st, what):
    """On one mesh: solutions on planes across the tangent at st; secant method for the one where the path turns."""
    N = len(st.X) - 1
    sc = s.scale(N)
    turns = direction(s, what, N)
    T0 = s.tangent(st)
    base = T0 / sc
    mid = base @ st.flat()
    ahead = (T0 * sc)[:s.d * (N + 1)].reshape(N + 1, s.d)
    sig, phi, cur, step = 0.0, turns @ T0, st, 1e-5
    tries = 0
    best = abs(phi), st
    for it in range(40):
        try:
            guess = State(cur.X, cur.zn + ahead * step, cur.K, cur.H)
            new = s.correct(guess, row=base, target=mid + sig + step, tol=3e-13, most=12)
            T = s.tangent(new, like=T0)
        except Failure:
            tries += 1
            if tries > 8:
                raise
            step *= 0.2
            continue
        component = turns @ T
        slope = (component - phi) / step
        sig, phi, cur = sig + step, component, new
        if abs(phi) < best[0]:
            best = abs(phi), new
        elif it > 14 and best[0] < 1e-6:                              # a second direction is nearly free: rounding is all there is
            break
        if slope == 0.0 or abs(phi) < 1e-14:
            break
        step = float(np.clip(-phi / slope, -100.0 * abs(step), 100.0 * abs(step)))
        if abs(step) < (1e-11 if abs(phi) < 1e-9 else 1e-13):
            break
    if best[0] > 1e-6 and not (abs(step) < 1e-10 and best[0] < 1e-4):
        raise Failure(f"{what}: the tangent does not turn here, {best[0]:.2e}")
    return best[1]

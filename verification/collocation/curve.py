"""Solutions of a path between its points."""
import numpy as np

from .mesh import counted, mesh, pin
from .path import interpolated
from .turns import resolved


def solution(path, label):
    """The solution next to what an interpolation along the path gives at a path length."""
    s = path.s
    i = min(int(np.searchsorted(path.labels, label, side="right")) - 1, len(path.points) - 2)
    first = max(i - 1, 1) if i else 0
    near = range(first, min(first + 4, len(path.points)))
    counts = counted(s, path.points[i + 1].X)
    states = [resampled(s, path.points[k], counts) for k in near]
    guess = interpolated(states, [path.labels[k] for k in near], label)
    pin(s, guess.X, counts)
    way = (states[i + 1 - first].flat() - states[i - first].flat()) / s.scale(len(guess.X) - 1)
    s.border = way / np.linalg.norm(way)
    return s.correct(guess, tol=1e-10, most=12)


def resampled(s, st, counts):
    """The same solution on another number of sub-intervals."""
    if np.array_equal(counted(s, st.X), counts):
        return st
    return st.moved(s.strip, mesh(s, st, counts)[0], st.n)


def held(path, u):
    """The first solution of a path at a displacement up to lp1, on a mesh that resolves it."""
    s = path.s
    us = np.array([s.u(st) for st in path.points])
    i = int(np.argmax(us[1:] >= u))
    if us[i + 1] < u:
        raise ValueError(f"u = {u:g} nm is not reached: the path goes to {us.max():g} nm")
    share = (u - us[i]) / (us[i + 1] - us[i])
    near = path.points[i] if share < 1e-9 else solution(path, (1.0 - share) * path.labels[i] + share * path.labels[i + 1])
    return resolved(s, near, lambda st: s.held(st, u), *path.fine)


def passings(path, of, value, corrected):
    """Every solution of a path at which of(state) has a value, in path order, on meshes that resolve them.

    corrected(s, state) is the equilibrium next to a state at which it has the value.
    """
    s = path.s
    above = [of(s, st) - value for st in path.points]
    found = []
    for i, (a, b) in enumerate(zip(above, above[1:])):
        if (a >= 0.0) != (b >= 0.0):
            share = a / (a - b)
            near = solution(path, (1.0 - share) * path.labels[i] + share * path.labels[i + 1])
            found.append(resolved(s, near, lambda st: corrected(s, st), *path.fine))
    return found

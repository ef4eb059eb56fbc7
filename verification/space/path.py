"""Paths of equilibria, their extrema, and critical loads.

Every row acts on the end values x = (z(0), z(L), par): it does not know the mesh, which may change from point to
point. A path is controlled by a row along its own tangent. An extremum of a functional w . x is a root of w . t, t
the tangent, between two points: the derivative is exact, and the root is found to round-off. A critical load is a
root of the number that borders the singular matrix.
"""

import numpy as np
from scipy.optimize import brentq
from scipy.sparse import bmat, csc_matrix
from scipy.sparse.linalg import splu

from .beam import SIZE
from .gauss import Failure, remesh


def row(problem, place, component, value=1.0):
    """A row with one entry: place "left", "right" or "par"."""
    out = np.zeros(2 * SIZE + len(problem.par_scale))
    out[{"left": 0, "right": SIZE, "par": 2 * SIZE}[place] + component] = value
    return out


def held(problem, st, control, target, steps=1, **options):
    """The equilibrium next to st with control . x = target, in equal steps along the tangent."""
    start = control @ problem.end_values(st)
    step = (target - start) / steps
    for k in range(1, steps + 1):
        st = problem.solve(st, control, start + step * k, **options)
        if k < steps:
            st = problem.along(st, step)
    return st


class Walk:
    """A path: points with their tangents, from a state that is an equilibrium. `scale` weighs the end values;
    `toward` sets the sense."""

    def __init__(self, problem, st, toward, weights=None, step=0.1, N=None, s=None):
        self.problem, self.N, self.s = problem, N, s
        scale = np.concatenate([np.full(SIZE, np.inf), problem.scale, problem.par_scale])
        self.weights = 1.0 / scale**2 if weights is None else weights
        self.step = step
        st = problem.solve(st, toward, toward @ problem.end_values(st))
        self.points, self.tangents = [st], [self.normal(problem.tangent_ends())]

    def normal(self, t):
        return t / np.sqrt(self.weights @ t**2)

    def advance(self, largest=0.5):
        """One more point; the step grows or shrinks with the number of Newton's steps."""
        p, st, t = self.problem, self.points[-1], self.tangents[-1]
        control = self.weights * t
        value = control @ p.end_values(st)
        if self.N and len(self.points) % 3 == 0:
            st = remesh(st, self.N, p.scale, self.s)
        for trial in range(14):
            try:
                if trial or st is not p.solved:
                    st = p.solve(st, control, value, tolerance=1e-6)
                new = p.solve(p.along(st, self.step), control, value + self.step, most=7)
                used, found = p.used, self.normal(p.tangent_ends())
                found = found if (self.weights * t) @ found > 0.0 else -found
                if (self.weights * t) @ found < 0.7:
                    raise Failure("sharp bend")
            except Failure:
                self.step *= 0.5
                continue
            self.points.append(new)
            self.tangents.append(found)
            if used <= 4:
                self.step = min(1.4 * self.step, largest)
            elif used >= 6:
                self.step *= 0.7
            return new
        raise Failure("the steps have collapsed")

    def value(self, w, k=-1):
        return w @ self.problem.end_values(self.points[k])

    def slope(self, w, k=-1):
        return w @ self.tangents[k]

    def turned(self, w):
        """Whether w . x has an extremum between the last two points."""
        return self.slope(w, -1) * self.slope(w, -2) < 0.0


def extremum(problem, before, after, tangent, w, weights, fine, passes=2):
    """The state between two points at which w . x is extremal; fine: (N, s) of its mesh."""
    control = weights * tangent
    a, b = control @ problem.end_values(before), control @ problem.end_values(after)
    st = before
    for k in range(passes + 1):
        N, s = fine if k else (len(before.X) - 1, before.K.shape[2])
        known = {}

        def solved(sigma):
            near = min(known, key=lambda v: abs(v - sigma))
            st = known[sigma] = problem.solve(known[near], control, sigma, tolerance=1e-9)
            _, problem.tangent, problem.back = problem.step(st, control, sigma)  # there, not at the last but one step
            return w @ problem.tangent_ends()

        if k == 0:
            known = {a: before, b: after}
        else:
            known = {a: remesh(st, N, problem.scale, s)}
            known[a] = problem.solve(known[a], control, root)
            width = 0.02 * (b - a)
            low, high = root - width, root + width
        if k == 0:
            low, high = a, b
        root = brentq(solved, low, high, xtol=1e-13 * max(abs(a), abs(b - a)), rtol=1e-14)
        st = problem.solve(known[min(known, key=lambda v: abs(v - root))], control, root, tolerance=1e-10)
    return st


def bordered(problem, st, rows, columns):
    """The small matrix G of [A columns; rows 0] [V; G] = [0; 1]: singular where A, the conditions without a control,
    is.

    Also V, the same of the transposed matrix, and the sizes of the unknowns."""
    _, transfer, _, _, B = problem.assemble(st)
    A, sc, _ = problem.matrix(st, transfer, B, np.zeros((0, B.shape[1])))
    k, n = rows.shape
    lu = splu(bmat([[A, csc_matrix(columns)], [csc_matrix(rows), None]], format="csc"))
    rhs = np.zeros((n + k, k))
    rhs[n:] = np.eye(k)
    x, y = lu.solve(rhs), lu.solve(rhs, trans="T")
    return x[n:], x[:n], y[:n], sc


def critical(problem, state_at, low, high, modes=1, seed=1):
    """The load between low and high at which the conditions are singular, the mode there and G. state_at(load): the
    equilibrium.

    The borders are the null vectors at the middle of the interval, which leaves G without a pole there."""
    st = state_at(0.5 * (low + high))
    rng = np.random.default_rng(seed)
    n = SIZE * len(st.X) + len(st.par)
    rows, columns = rng.standard_normal((modes, n)), rng.standard_normal((n, modes))
    for _ in range(3):
        _, V, W, _ = bordered(problem, st, rows, columns)
        rows, columns = np.linalg.qr(V)[0].T, np.linalg.qr(W)[0]
    f = lambda load: bordered(problem, state_at(load), rows, columns)[0][0, 0]
    load = brentq(f, low, high, xtol=1e-14 * abs(high), rtol=1e-14)
    G, V, _, sc = bordered(problem, state_at(load), rows, columns)
    return load, (V.T * sc).T, G

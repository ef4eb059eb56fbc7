"""Collocation at the Gauss points of sub-intervals, and Newton's method with conditions at both ends.

A state is a mesh X, the values z at its nodes (13, N+1), the slopes K at the Gauss points (13, N, s) and a few
parameters `par`. The slopes are eliminated on each sub-interval; what is left couples neighbouring nodes, the two end
conditions and the parameters, and is solved by a sparse factorisation. Gauss collocation keeps q.q to round-off, so
that |q(0)| = 1 is the thirteenth condition.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import splu

from . import beam as beams
from .beam import SIZE, TINY


class Failure(Exception):
    pass


class Rule:
    """Gauss points t of (0, 1), weights b, the matrix A of integrals up to the points, and one of integrals up to any
    place."""

    known = {}

    def __new__(cls, s):
        if s not in cls.known:
            rule = super().__new__(cls)
            x, w = legendre.leggauss(s)
            rule.t, rule.b = 0.5 * (x + 1.0), 0.5 * w
            rule.to_series = np.linalg.inv(legendre.legvander(x, s - 1))
            rule.A = rule.integrals(rule.t)
            cls.known[s] = rule
        return cls.known[s]

    def integrals(self, t):
        """Rows: integrals from 0 to t of the polynomial through values at the Gauss points."""
        s = len(self.t)
        series = legendre.legint(np.eye(s), lbnd=-1.0, scl=0.5, axis=0)
        return legendre.legvander(2.0 * np.asarray(t) - 1.0, s) @ series @ self.to_series


@dataclass
class State:
    X: np.ndarray
    z: np.ndarray
    K: np.ndarray
    par: np.ndarray

    def copy(self):
        return State(self.X, self.z.copy(), self.K.copy(), self.par.copy())

    @property
    def rule(self):
        return Rule(self.K.shape[2])

    def inner(self):
        """z at the Gauss points (13, N, s)."""
        h = np.diff(self.X)
        return self.z[:, :-1, None] + h[:, None] * (self.K @ self.rule.A.T)

    def places(self):
        return self.X[:-1, None] + np.diff(self.X)[:, None] * self.rule.t

    def at(self, S):
        """z at places S, by the polynomials of the sub-intervals."""
        S = np.atleast_1d(S)
        i = np.clip(np.searchsorted(self.X, S, side="right") - 1, 0, len(self.X) - 2)
        h = np.diff(self.X)[i]
        rows = self.rule.integrals((S - self.X[i]) / h)
        return self.z[:, i] + h * np.einsum("cms,ms->cm", self.K[:, i], rows)

    def series(self):
        """Legendre coefficients of the slopes (13, N, s)."""
        return self.K @ self.rule.to_series.T

    def moved(self, X, s=None):
        """The same solution on another mesh or with other Gauss points."""
        rule = Rule(s or self.K.shape[2])
        S = X[:-1, None] + np.diff(X)[:, None] * rule.t
        i = np.clip(np.searchsorted(self.X, S.ravel(), side="right") - 1, 0, len(self.X) - 2)
        t = (S.ravel() - self.X[i]) / np.diff(self.X)[i]
        values = legendre.legvander(2.0 * t - 1.0, self.K.shape[2] - 1) @ self.rule.to_series
        K = np.einsum("cms,ms->cm", self.K[:, i], values).reshape(SIZE, *S.shape)
        return State(X, self.at(X), K, self.par.copy())


def straight(length, N, s, r0, q0, par, tangent=(1.0, 0.0, 0.0)):
    """A state with a constant frame and a straight axis."""
    X = np.linspace(0.0, length, N + 1)
    z = np.zeros((SIZE, N + 1))
    z[0:3] = np.asarray(r0, dtype=float)[:, None] + np.asarray(tangent, dtype=float)[:, None] * X
    z[3:7] = np.asarray(q0, dtype=float)[:, None]
    K = np.zeros((SIZE, N, s))
    K[0:3] = np.asarray(tangent, dtype=float)[:, None, None]
    return State(X, z, K, np.asarray(par, dtype=float))


class Problem:
    """A beam and its end conditions: conditions(z0, zL, par) -> as many numbers as 12 + len(par); |q(0)| = 1 is added.

    scale: the size of the 13 unknowns; par_scale: that of the parameters.
    """

    def __init__(self, beam, conditions, scale, par_scale=()):
        self.beam, self.conditions = beam, conditions
        self.solved = self.tangent = self.back = None
        self.scale, self.par_scale = np.asarray(scale, dtype=float), np.asarray(par_scale, dtype=float)

    def ends(self, st):
        """End conditions and their derivatives by z(0), z(L), par (complex steps)."""
        x = np.concatenate([st.z[:, 0], st.z[:, -1], st.par])
        n = len(x)
        moved = x[:, None] + 1j * TINY * np.eye(n)
        g = list(self.conditions(moved[:SIZE], moved[SIZE : 2 * SIZE], moved[2 * SIZE :]))
        q = moved[3:7]
        g.append(q[0] ** 2 + q[1] ** 2 + q[2] ** 2 + q[3] ** 2 - 1.0)
        g = np.array([v + np.zeros(n) for v in g])
        return g[:, 0].real, g.imag / TINY

    def assemble(self, st):
        """Residual and matrix of the condensed system, and what gives the slopes back."""
        N, s = st.K.shape[1:]
        rule, h = st.rule, np.diff(st.X)
        f, J = beams.linearised(self.beam.at(st.places().ravel()), st.inner().reshape(SIZE, -1))
        F = (st.K - f.reshape(SIZE, N, s)).transpose(1, 2, 0).reshape(N, s * SIZE)
        J = J.reshape(SIZE, SIZE, N, s).transpose(2, 3, 0, 1)  # (N, s, row, column)
        big = -np.einsum("e,ejrc,jl->ejrlc", h, J, rule.A).reshape(N, s * SIZE, s * SIZE)
        big[:, np.arange(s * SIZE), np.arange(s * SIZE)] += 1.0
        right = np.concatenate([J.reshape(N, s * SIZE, SIZE), -F[:, :, None]], axis=2)
        back = np.linalg.solve(big, right)  # dK = back[..., :13] dz_i + back[..., 13]
        total = h[:, None, None] * np.einsum("j,ejrc->erc", rule.b, back.reshape(N, s, SIZE, SIZE + 1))
        transfer, gain = total[:, :, :SIZE] + np.eye(SIZE), total[:, :, SIZE]
        jump = (st.z[:, :-1] + h * (st.K @ rule.b) - st.z[:, 1:]).T + gain
        g, B = self.ends(st)
        return jump, transfer, back, g, B

    def matrix(self, st, transfer, B, extra):
        """The sparse matrix of dz (node by node) and dpar; rows: sub-intervals, end conditions, extra rows."""
        N, p = len(st.X) - 1, len(st.par)
        n = SIZE * (N + 1) + p
        sc = np.concatenate([np.tile(self.scale, N + 1), self.par_scale])
        r = np.arange(SIZE * N).reshape(N, SIZE)
        rows = [np.broadcast_to(r[:, :, None], (N, SIZE, SIZE)).ravel(), r.ravel()]
        cols = [np.broadcast_to(r[:, None, :], (N, SIZE, SIZE)).ravel(), r.ravel() + SIZE]
        inv = 1.0 / self.scale
        data = [(transfer * inv[:, None] * self.scale).ravel(), -np.ones(SIZE * N)]
        where = np.concatenate([np.arange(SIZE), np.arange(SIZE * N, n)])
        border = np.concatenate([B] + ([extra] if len(extra) else [])) * sc[where]
        size = np.maximum(np.abs(border).max(axis=1), 1e-300)
        border = border / size[:, None]
        k = len(border)
        rows.append(np.repeat(np.arange(SIZE * N, SIZE * N + k), len(where)))
        cols.append(np.tile(where, k))
        data.append(border.ravel())
        A = csc_matrix((np.concatenate(data), (np.concatenate(rows), np.concatenate(cols))), shape=(SIZE * N + k, n))
        return A, sc, size

    def step(self, st, control=None, target=0.0):
        """Newton's step and the tangent. control: a row over (z(0), z(L), par) with control . x = target; the tangent
        has control . t = 1."""
        jump, transfer, back, g, B = self.assemble(st)
        extra = np.zeros((0, B.shape[1])) if control is None else control[None, :]
        A, sc, size = self.matrix(st, transfer, B, extra)
        try:
            lu = splu(A)
        except RuntimeError as trouble:
            raise Failure(f"singular: {trouble}") from None
        low = [-g]
        if control is not None:
            low.append([target - control @ self.end_values(st)])
        rhs = np.concatenate([(-jump / self.scale).ravel(), np.concatenate(low) / size])
        one = np.zeros((len(rhs), 2))
        one[:, 0] = rhs
        if control is not None:
            one[-1, 1] = 1.0 / size[-1]
        x = lu.solve(one)
        x += lu.solve(one - A @ x)
        x *= sc[:, None]
        return x[:, 0], x[:, 1], back

    def end_values(self, st):
        return np.concatenate([st.z[:, 0], st.z[:, -1], st.par])

    def apply(self, st, dx, back, share=1.0):
        N, s = st.K.shape[1:]
        dz = dx[: SIZE * (N + 1)].reshape(N + 1, SIZE)
        dK = np.einsum("erc,ec->er", back[:, :, :SIZE], dz[:-1]) + back[:, :, SIZE]
        return State(
            st.X,
            st.z + share * dz.T,
            st.K + share * dK.reshape(N, s, SIZE).transpose(2, 0, 1),
            st.par + share * dx[SIZE * (N + 1) :],
        )

    def size(self, st, dx):
        sc = np.concatenate([np.tile(self.scale, len(st.X)), self.par_scale])
        return np.abs(dx / sc).max()

    def allowed(self, st):
        """Whether a state stays clear of the plane."""
        law = self.beam.at(st.X).law
        if law is None:
            return True
        d = beams.frame(st.z[3:7])
        return bool((st.z[1] - law.lowest(d[1][1], d[2][1]) > 0.3 * law.r0).all())

    def solve(self, st, control=None, target=0.0, tolerance=1e-9, most=12):
        """Newton's method. Gives the state; its tangent is in self.tangent, the number of steps in self.used."""
        last = np.inf
        for it in range(most):
            dx, t, back = self.step(st, control, target)
            size = self.size(st, dx)
            if not np.isfinite(size) or size > 1e3:
                raise Failure("diverged")
            st = self.apply(st, dx, back)
            if not self.allowed(st):
                raise Failure("penetrates")
            if size < tolerance or (it > 2 and size < 1e-6 and size > 0.3 * last):
                self.used, self.solved = it + 1, st
                self.tangent, self.back = t, back
                self.last = size
                return st
            if it > 2 and size > 2.0 * last and size > 1e-3:
                raise Failure("not contracting")
            last = size
        raise Failure(f"no convergence, last step {size:.1e}")

    def tangent_ends(self):
        """The part of the last tangent in (z(0), z(L), par)."""
        N = len(self.back)
        return np.concatenate([self.tangent[:SIZE], self.tangent[SIZE * N :]])

    def along(self, st, sigma):
        """The state moved by sigma along the last tangent."""
        N, s = st.K.shape[1:]
        dz = self.tangent[: SIZE * (N + 1)].reshape(N + 1, SIZE)
        dK = np.einsum("erc,ec->er", self.back[:, :, :SIZE], dz[:-1]).reshape(N, s, SIZE).transpose(2, 0, 1)
        return State(st.X, st.z + sigma * dz.T, st.K + sigma * dK, st.par + sigma * self.tangent[SIZE * (N + 1) :])


def remesh(st, N, scale, s=None, floor=1e-11, smooth=0.4):
    """N sub-intervals on which the last Legendre coefficients of the slopes are alike; their density does not change
    abruptly."""
    h = np.diff(st.X)
    c = np.abs(st.series()) / scale[:, None, None] * h[:, None]
    order = st.K.shape[2]
    e = np.maximum(c[:, :, -1], c[:, :, -2]).max(axis=0)
    rho = (np.maximum(e, floor * max(1.0, c.max()))) ** (1.0 / order) / h
    rho *= N / (rho * h).sum()
    for way in (range(1, len(rho)), range(len(rho) - 2, -1, -1)):
        step = 1 if way.step == 1 else -1
        for i in way:
            rho[i] = max(rho[i], rho[i - step] / (1.0 + smooth * h[i] * rho[i - step]))
    rho = np.maximum(rho, 0.05 * (rho * h).sum() / st.X[-1])
    cum = np.concatenate([[0.0], np.cumsum(rho * h)])
    X = np.interp(np.linspace(0.0, cum[-1], N + 1), cum, st.X)
    X[0], X[-1] = st.X[0], st.X[-1]
    return st.moved(X, s)

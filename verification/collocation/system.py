"""A solution on a mesh of sub-intervals, and one linearisation of the boundary value problem.

Chebyshev collocation with points of the first kind: z' is a polynomial on each sub-interval, z its integral. Left end: V = M = 0
(and w = 0; with friction H = 0). Right end: M = 0 or theta as at rest, or turned from there by an angle and in proportion to the displacement, and across the pull no force, H sin - V cos = 0, or no displacement,
w sin - (y - y_rest) cos = 0; only where the pull is upright and free across is H = 0 and w left out. The displacement of the grip
along the pull is not prescribed: one condition is missing, and the solutions form the path.
"""
import math

import numpy as np
from scipy.linalg import solve_banded

from .law import field


class Rule:
    """n Chebyshev points of the first kind on [0, 1]: integration matrix A, weights w, interpolation of degree n."""
    _made = {}

    def __new__(cls, n):
        if n not in cls._made:
            self = super().__new__(cls)
            k = np.arange(n)
            t = -np.cos((2 * k + 1) * np.pi / (2 * n))
            ang = np.arccos(np.append(t, 1.0))
            # columns: int_{-1}^{t} T_k
            I = np.empty((n + 1, n))
            for j in range(n):
                if j == 0:
                    I[:, 0] = np.append(t, 1.0) + 1.0
                elif j == 1:
                    I[:, 1] = (np.append(t, 1.0) ** 2 - 1.0) / 2.0
                else:
                    prim = lambda a: 0.5 * (np.cos((j + 1) * a) / (j + 1) - np.cos((j - 1) * a) / (j - 1))
                    I[:, j] = prim(ang) - prim(np.pi)
            F = np.cos(np.outer(k, ang[:-1])) * (2.0 / n)     # values -> coefficients (discrete orthogonality)
            F[0] *= 0.5
            A = 0.5 * I @ F
            self.n, self.t, self.A, self.w, self.F = n, 0.5 * (t + 1.0), A[:-1], A[-1], F
            s = np.append(0.0, self.t)                        # the points that carry z: left end and collocation points
            diff = s[:, None] - s[None, :]
            np.fill_diagonal(diff, 1.0)
            self.s, self.bary = s, 1.0 / np.prod(diff * 4.0, axis=1)
            cls._made[n] = self
        return cls._made[n]


class State:
    """A solution (or a guess at one): mesh X, z at its nodes, z' at the collocation points, H."""

    def __init__(self, X, zn, K, H=0.0):
        self.X, self.zn, self.K, self.H = X, zn, K, H

    @property
    def n(self):
        return self.K.shape[1]

    def inner(self):
        h = np.diff(self.X)
        return self.zn[:-1, None, :] + h[:, None, None] * np.matmul(Rule(self.n).A, self.K)

    def points(self):
        return self.X[:-1, None] + np.diff(self.X)[:, None] * Rule(self.n).t

    def at(self, S):
        """z at the places S, by the collocation polynomial."""
        R = Rule(self.n)
        i = np.clip(np.searchsorted(self.X, S, side="right") - 1, 0, len(self.X) - 2)
        s = (S - self.X[i]) / np.diff(self.X)[i]
        zs = np.concatenate([self.zn[:-1, None, :], self.inner()], axis=1)[i]
        dx = s[:, None] - R.s
        hit = np.abs(dx) < 1e-15
        q = R.bary / np.where(hit, 1.0, dx)
        anyhit = hit.any(axis=1)
        q[anyhit] = hit[anyhit]
        return np.einsum("ik,ikd->id", q, zs) / q.sum(axis=1)[:, None]

    def moved(self, c, X, n):
        """The same solution on another mesh."""
        R = Rule(n)
        S = X[:-1, None] + np.diff(X)[:, None] * R.t
        zn = self.at(X)
        zn[-1] = self.zn[-1]
        z = self.at(S.ravel()).reshape(S.shape + (-1,))
        return State(X, zn, field(c.at(S), z, self.H, jac=False), self.H)

    def flat(self):
        v = self.zn.ravel()
        return np.append(v, self.H) if self.zn.shape[1] == 5 else v.copy()


class Banded:
    """A matrix whose entries lie within WIDE of the diagonal."""
    WIDE = 8

    def __init__(self, size):
        self.size, self.bands = size, np.zeros((2 * self.WIDE + 1, size))

    def __setitem__(self, at, values):
        i, j = (np.arange(self.size)[k] for k in at)
        i, j = np.broadcast_arrays(np.reshape(i, (-1, 1)), j)
        self.bands[self.WIDE + i - j, j] = values

    def solve(self, b):
        return solve_banded((self.WIDE, self.WIDE), self.bands, b)


class System:
    """One linearisation of the boundary value problem, condensed to the nodes: rows x unknowns = m x (m + 1)."""

    def __init__(self, c, st):
        N, n, d = st.K.shape
        R = Rule(n)
        h = np.diff(st.X)
        f, J, fH = field(c.at(st.points()), st.inner(), st.H)
        big = -(h[:, None, None, None, None] * R.A[None, :, None, :, None]) * J[:, :, :, None, :]
        for a in range(d):
            k = np.arange(n)
            big[:, k, a, k, a] += 1.0
        cols = d + (2 if d == 5 else 1)
        rhs = np.empty((N, n, d, cols))
        rhs[..., 0] = f - st.K
        rhs[..., 1:d + 1] = J
        if d == 5:
            rhs[..., d + 1] = fH
        sol = np.linalg.solve(big.reshape(N, n * d, n * d), rhs.reshape(N, n * d, cols)).reshape(N, n, d, cols)
        self.sol = sol
        end = h[:, None, None] * np.einsum("k,ikac->iac", R.w, sol)
        gap = st.zn[1:] - st.zn[:-1] - h[:, None] * np.einsum("k,ika->ia", R.w, st.K)
        size = d * (N + 1) + (d == 5)
        top = 3 if d == 6 else 0                                      # the left end above the rest: banded
        A = Banded(size) if d == 6 else np.zeros((size, size))
        r = np.zeros(size)
        for i in range(N):
            rows = slice(top + d * i, top + d * i + d)
            A[rows, d * i:d * i + d] = -np.eye(d) - end[i, :, 1:d + 1]
            A[rows, d * i + d:d * i + 2 * d] = np.eye(d)
            if d == 5:
                A[rows, -1] = -end[i, :, d + 1]
            r[rows] = end[i, :, 0] - gap[i]
        e = d * N
        tip = 1 if c.rotation == "fixed" else 3
        left = [2, 3] + [d - 1] * (d >= 5)                            # V, M, and w or with friction H
        conditions = [(col, st.zn[0, col]) for col in left]
        turned = c.end_rotation + math.radians(c.turned)
        conditions.insert(3 if d == 6 else 2, (e + tip, st.zn[-1, tip] - (turned if tip == 1 else 0.0)))
        row_of = [0, 1, 2, e + 3] if d == 6 else range(e, size)
        for k, (col, val) in zip(row_of, conditions):
            A[k, col] = 1.0
            r[k] = -val
        if c.turn:                                                    # theta - turn u
            cos, sin = c.pull
            row = e + 3 if d == 6 else e + 2
            u = [(e, sin, st.zn[-1, 0] - c.end_gap)] + ([(e + 4, cos, st.zn[-1, 4] - c.stretch)] if d >= 5 else [])
            for col, share, moved in u:
                A[row, col] -= math.radians(c.turn) * share
                r[row] += math.radians(c.turn) * share * moved
        if d >= 5:                                                    # across the pull
            cos, sin = c.pull
            k = size - 2
            if c.horizontal == "fixed":
                A[k, e + 4], A[k, e] = sin, -cos
                r[k] = (st.zn[-1, 0] - c.end_gap) * cos - (st.zn[-1, 4] - c.stretch) * sin
            else:
                A[k, -1 if d == 5 else e + 5], A[k, e + 2] = sin, -cos
                r[k] = st.zn[-1, 2] * cos - (st.H if d == 5 else st.zn[-1, 5]) * sin
        self.A, self.r, self.d, self.N = A, r, d, N
        self.defect = max(np.abs(gap).max(), np.abs(f - st.K).max())

    def solve(self, row, value):
        """Newton step with row . step = value, and the null vector T with row . T = 1. With friction the row is of the grip alone."""
        b = np.column_stack([self.r, np.zeros_like(self.r)])
        b[-1] = value, 1.0
        if self.d == 6:
            self.A[-1, len(row) - 6:] = row[-6:]
            x = self.A.solve(b)
        else:
            self.A[-1] = row
            x = np.linalg.solve(self.A, b)
        return x[:, 0], x[:, 1]

    def apply(self, st, dx, share=1.0):
        """The state after a step dx, which is that share of a Newton step."""
        d, N = self.d, self.N
        dz = dx[:d * (N + 1)].reshape(N + 1, d)
        dK = share * self.sol[..., 0] + np.einsum("ikac,ic->ika", self.sol[..., 1:d + 1], dz[:-1])
        dH = 0.0
        if d == 5:
            dH = dx[-1]
            dK = dK + self.sol[..., d + 1] * dH
        return State(st.X, st.zn + dz, st.K + dK, st.H + dH)


class Failure(Exception):
    pass

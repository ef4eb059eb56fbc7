#!/usr/bin/env python3
"""Peeling of a uniform adhesive strip, without finite elements.

Solves the strong form of Reissner's planar beam on the adhesive half space of Sauer, eqs. (17)-(23), as a boundary value
problem by Chebyshev collocation on many sub-intervals, follows the path of equilibria from rest, and locates the initiation
peak (dP = 0) and the first two displacement limit points (du = 0) on two refined meshes. Writes strip_variants.csv.

Units: nm, nN, aJ; 1 GPa = 1 nN/nm^2, 1e-19 J = 0.1 nN nm.  See README.md beside this file.

The equations. With the potential  Pi = int [EA G1^2/2 + GA G2^2/2 + EI k^2/2 + b Psi(y, theta)] dS - P y(L),
    G1 = x' cos + y' sin - 1,   G2 = -x' sin + y' cos,   k = theta',
    H = N cos - Q sin,  V = N sin + Q cos,  M = EI theta'   (N = EA G1, Q = GA G2; so N = H cos + V sin, Q = -H sin + V cos),
its first variation gives
    H' = 0,   V' = b dPsi/dy = -b T_c,   M' = -x' V + y' H + b dPsi/dtheta = -x' V + y' H - b M_c.
Solved for derivatives, with g = y - h/2 in place of y and w = x - S in place of x, so that nothing cancels:
    g' = (1 + N/EA) sin + (Q/GA) cos,   theta' = M/EI,   V' = -b T_c,   M' = -x' V + y' H - b M_c,   w' = x' - 1.
Left end: V = M = 0 (and w = 0). Right end: M = 0 or theta = 0 (and w = 0 with H unknown, or H = 0). The displacement of
the grip is not prescribed: one condition is missing, and the solutions form the path.
"""
import os

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import argparse
import csv
import math
import sys
import time
from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

HERE = os.path.dirname(os.path.abspath(__file__))
TABLE = os.path.join(HERE, "strip_variants.csv")


# ------------------------------------------------------------------------------------------------------------- the strip
@dataclass(frozen=True)
class Strip:
    length: float = 100.0                # nm
    factor: float = 1.0                  # on EI alone
    rotation: str = "free"               # of the grip: free | fixed
    horizontal: str = "free"             # of the grip: free | fixed
    line_load: str = "full"              # full | force-only | axis-gap
    far_face: bool = True
    height: float = 10.0                 # nm
    width: float = 1.0                   # nm
    young: float = 2.0                   # GPa
    poisson: float = 0.2
    shear_correction: float = 5.0 / 6.0
    hamaker: float = 1e-19               # J
    r0: float = 0.4                      # nm

    @property
    def EI(self):
        return self.young * self.height ** 3 / 12.0 * self.width * self.factor

    @property
    def EA(self):
        return self.young * self.height * self.width

    @property
    def GA(self):
        return self.shear_correction * self.young / (2.0 * (1.0 + self.poisson)) * self.height * self.width

    @property
    def K(self):
        """A_H / (2 pi r0^2), nN/nm."""
        return self.hamaker * 1e18 / (2.0 * math.pi * self.r0 ** 2)

    def __str__(self):
        return (f"L={self.length:g} f={self.factor:g} rot={self.rotation} hor={self.horizontal} {self.line_load} "
                f"far={str(self.far_face).lower()} h={self.height:g} b={self.width:g} E={self.young:g} nu={self.poisson:g} "
                f"k={self.shear_correction:.4g} A_H={self.hamaker:g} r0={self.r0:g}")


# ----------------------------------------------------------------------------------------------------------- the adhesion
def _near(c, r):
    """W, T, T' of one half space at the gap r: W(r) = K [q^8/360 - q^2/6], T = -W'."""
    q = c.r0 / r
    q2 = q * q
    q8 = q2 ** 4
    W = c.K * (q8 / 360.0 - q2 / 6.0)
    T = c.K / c.r0 * q * (q8 / 45.0 - q2 / 3.0)
    dT = c.K / c.r0 ** 2 * q2 * (q2 - q8 / 5.0)
    return W, T, dT


def potential(c, g, th):
    """Psi with its gradient (y, theta) and Hessian (yy, yt, tt); for axis-gap the W(g) - W(g + h) of its traction.

    "force-only" has the same T_c but no M_c; its Psi is that of the full law and is no potential of it.
    """
    co, si = np.cos(th), np.sin(th)
    h, r0 = c.height, c.r0
    if c.line_load == "axis-gap":
        W, T, dT = _near(c, g)
        if c.far_face:
            W2, T2, dT2 = _near(c, g + h)
            W, T, dT = W - W2, T - T2, dT - dT2
        zero = np.zeros_like(W)
        return W, -T, zero, -dT, zero, zero
    r1 = g + h * np.sin(0.5 * th) ** 2           # = y - (h/2) cos, without the cancellation
    if not c.far_face:
        W, T, dT = _near(c, r1)
        a = 0.5 * h * si                          # d r1 / d theta
        ic = 1.0 / co
        d1 = si * ic * ic                         # (1/cos)'
        d2 = ic * (1.0 + 2.0 * si * si * ic * ic)  # (1/cos)''
        return (W * ic, -T * ic, -T * a * ic + W * d1, -dT * ic, -dT * a * ic - T * d1,
                (-dT * a * a - T * 0.5 * h * co) * ic - 2.0 * T * a * d1 + W * d2)
    # both faces: with p = r0/r1, q = r0/r2, m = p q, s = p + q = 2 (y/r0) m, the division by cos is done by hand:
    # Psi = K (h/r0) m s B,  B = (p^2 + q^2)(p^4 + q^4)/360 - 1/6.
    y = g + 0.5 * h
    r2 = y + 0.5 * h * co
    m = r0 * r0 / (r1 * r2)
    s = 2.0 * y / r0 * m
    Q = (r0 / r1) ** 2 + (r0 / r2) ** 2          # s^2 - 2m
    m2 = m * m
    B = Q * (Q * Q - 2.0 * m2) / 360.0 - 1.0 / 6.0
    BQ = (3.0 * Q * Q - 2.0 * m2) / 360.0
    BQQ = Q / 60.0
    Bs = 2.0 * s * BQ
    Bm = -2.0 * BQ - m * Q / 90.0
    Bss = 4.0 * s * s * BQQ + 2.0 * BQ
    x = -2.0 * BQQ - m / 90.0
    Bsm = 2.0 * s * x
    Bmm = -2.0 * x + (2.0 * m - Q) / 90.0
    C = c.K * h / r0
    Gm = C * s * (B + m * Bm)
    Gs = C * m * (B + s * Bs)
    Gmm = C * s * (2.0 * Bm + m * Bmm)
    Gss = C * m * (2.0 * Bs + s * Bss)
    Gms = C * (B + s * Bs + m * Bm + m * s * Bsm)
    # m = r0^2/D with D = r1 r2 = y^2 - (h cos/2)^2
    i = m / (r0 * r0)                             # 1/D
    Dy, Dt = 2.0 * y, 0.5 * h * h * si * co
    Dtt = 0.5 * h * h * (co * co - si * si)
    my, mt = -m * Dy * i, -m * Dt * i
    myy = -2.0 * my * Dy * i - 2.0 * m * i
    myt = -2.0 * my * Dt * i
    mtt = -2.0 * mt * Dt * i - m * Dtt * i
    k = 2.0 / r0
    sy, st = k * (m + y * my), k * y * mt
    syy, syt, stt = k * (2.0 * my + y * myy), k * (mt + y * myt), k * y * mtt
    return (C * m * s * B, Gm * my + Gs * sy, Gm * mt + Gs * st,
            Gmm * my * my + 2.0 * Gms * my * sy + Gss * sy * sy + Gm * myy + Gs * syy,
            Gmm * my * mt + Gms * (my * st + mt * sy) + Gss * sy * st + Gm * myt + Gs * syt,
            Gmm * mt * mt + 2.0 * Gms * mt * st + Gss * st * st + Gm * mtt + Gs * stt)


def rest_gap(c):
    """g at which T_c(y, 0) = 0."""
    f = lambda g: float(potential(c, np.float64(g), np.float64(0.0))[1])
    return brentq(f, 0.4 * c.r0, 5.0 ** (-1 / 6) * c.r0, xtol=1e-17, rtol=1e-15)


# -------------------------------------------------------------------------------------------------- right sides, Jacobian
def field(c, z, H, jac=True):
    """z' and its derivatives to z and H. z[..., :] = g, theta, V, M (, w)."""
    d = z.shape[-1]
    g, th, V, M = z[..., 0], z[..., 1], z[..., 2], z[..., 3]
    co, si = np.cos(th), np.sin(th)
    _, Py, Pt, Pyy, Pyt, Ptt = potential(c, g, th)
    if c.line_load == "force-only":
        Pt = np.zeros_like(Py)
        My, Mt = Pt, Pt
    else:
        My, Mt = Pyt, Ptt
    b, ea, ga = c.width, 1.0 / c.EA, 1.0 / c.GA
    N, Q = H * co + V * si, V * co - H * si
    x1 = (1.0 + N * ea) * co - Q * ga * si
    y1 = (1.0 + N * ea) * si + Q * ga * co
    f = np.empty_like(z)
    f[..., 0] = y1
    f[..., 1] = M / c.EI
    f[..., 2] = b * Py
    f[..., 3] = -x1 * V + y1 * H + b * Pt
    if d == 5:
        f[..., 4] = N * ea * co - Q * ga * si - 2.0 * np.sin(0.5 * th) ** 2
    if not jac:
        return f
    J = np.zeros(z.shape + (d,))
    y_t = x1 + Q * si * ea - N * co * ga
    y_V = si * si * ea + co * co * ga
    xy = si * co * (ea - ga)                      # dy'/dH = dx'/dV
    x_t = -y1 + Q * co * ea + N * si * ga
    J[..., 0, 1] = y_t
    J[..., 0, 2] = y_V
    J[..., 1, 3] = 1.0 / c.EI
    J[..., 2, 0] = b * Pyy
    J[..., 2, 1] = b * Pyt
    J[..., 3, 0] = b * My
    J[..., 3, 1] = -x_t * V + y_t * H + b * Mt
    J[..., 3, 2] = -x1 - xy * V + y_V * H
    if d == 4:
        return f, J, None
    J[..., 4, 1] = x_t
    J[..., 4, 2] = xy
    x_H = co * co * ea + si * si * ga
    fH = np.zeros_like(z)
    fH[..., 0] = xy
    fH[..., 3] = -x_H * V + y1 + xy * H
    fH[..., 4] = x_H
    return f, J, fH


# ------------------------------------------------------------------------------------------------------------ collocation
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
        return State(X, zn, field(c, z, self.H, jac=False), self.H)

    def flat(self):
        v = self.zn.ravel()
        return np.append(v, self.H) if self.zn.shape[1] == 5 else v.copy()


class System:
    """One linearisation of the boundary value problem, condensed to the nodes: rows x unknowns = m x (m + 1)."""

    def __init__(self, c, st):
        N, n, d = st.K.shape
        R = Rule(n)
        h = np.diff(st.X)
        f, J, fH = field(c, st.inner(), st.H)
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
        A = np.zeros((size, size))
        r = np.zeros(size)
        for i in range(N):
            rows = slice(d * i, d * i + d)
            A[rows, d * i:d * i + d] = -np.eye(d) - end[i, :, 1:d + 1]
            A[rows, d * i + d:d * i + 2 * d] = np.eye(d)
            if d == 5:
                A[rows, -1] = -end[i, :, d + 1]
            r[rows] = end[i, :, 0] - gap[i]
        o, e = d * N, d * N
        conditions = [(2, st.zn[0, 2]), (3, st.zn[0, 3])]
        tip = 1 if c.rotation == "fixed" else 3
        conditions.append((e + tip, st.zn[-1, tip]))
        if d == 5:
            conditions += [(4, st.zn[0, 4]), (e + 4, st.zn[-1, 4])]
        for k, (col, val) in enumerate(conditions):
            A[o + k, col] = 1.0
            r[o + k] = -val
        self.A, self.r, self.d, self.N = A, r, d, N
        self.defect = max(np.abs(gap).max(), np.abs(f - st.K).max())

    def solve(self, row, value):
        """Newton step with row . step = value, and the null vector T with row . T = 1."""
        self.A[-1] = row
        b = np.column_stack([self.r, np.zeros_like(self.r)])
        b[-1] = value, 1.0
        x = np.linalg.solve(self.A, b)
        return x[:, 0], x[:, 1]

    def apply(self, st, dx):
        d, N = self.d, self.N
        dz = dx[:d * (N + 1)].reshape(N + 1, d)
        dK = self.sol[..., 0] + np.einsum("ikac,ic->ika", self.sol[..., 1:d + 1], dz[:-1])
        dH = 0.0
        if d == 5:
            dH = dx[-1]
            dK = dK + self.sol[..., d + 1] * dH
        return State(st.X, st.zn + dz, st.K + dK, st.H + dH)


class Failure(Exception):
    pass


class Tracer:
    def __init__(self, c):
        self.c = c
        self.d = 5 if c.horizontal == "fixed" else 4
        self.g0 = rest_gap(c)
        z0 = np.zeros(self.d)
        z0[0] = self.g0
        _, J, _ = field(c, z0, 0.0)
        self.k0 = J[2, 0]                                             # stiffness of the adhesion at rest
        self.lam0 = (self.k0 / c.EI) ** 0.25
        self.ell = 1.0 / self.lam0
        self.iterations = 0
        self.pole = c.line_load != "axis-gap" and not c.far_face      # Psi = W/cos(theta), nothing to make up for the cos
        self.border = self.good = None

    def scale(self, N):
        c = self.c
        M = c.EI * 0.1 * self.lam0
        s = [c.r0, 0.1, 0.1 * c.K / c.r0 * c.width * self.ell, M, self.ell][:self.d]
        v = np.tile(s, N + 1)
        return np.append(v, s[2]) if self.d == 5 else v

    # ---------------------------------------------------------------------------------------------------------- the mesh
    def mesh(self, st, N, n_eff=12.0, quiet=1e-5):
        """Equidistributes an estimate of the local wave number times the (1/n_eff)th power of the local activity."""
        c = self.c
        S = st.points().ravel()
        z = st.inner().reshape(-1, self.d)
        f = st.K.reshape(-1, self.d)
        P = potential(c, z[:, 0], z[:, 1])
        k = c.width * np.abs(P[3])
        lam1 = (k / c.EI) ** 0.25
        lams = np.minimum((k / c.GA) ** 0.5, 3.0 * lam1 + 3.0 * self.lam0)
        lam2 = np.sqrt((np.abs(z[:, 2]) + abs(st.H)) / c.EI)
        co, si = np.cos(z[:, 1]), np.sin(z[:, 1])
        gap = z[:, 0] + (0.0 if c.line_load == "axis-gap" else c.height * np.sin(0.5 * z[:, 1]) ** 2)
        slope = np.abs(f[:, 0] + (0.0 if c.line_load == "axis-gap" else 0.5 * c.height * si * f[:, 1]))
        lam3 = slope / np.abs(gap)
        act = np.zeros(len(S))
        for a in (1, 2, 3):
            v = np.abs(f[:, a])
            act = np.maximum(act, v / max(v.max(), 1e-300))
        gate = act * act / (act * act + quiet * quiet)        # what is quieter is noise of the discretisation
        rho = ((lam1 + lam2) * act ** (1.0 / n_eff) + lams * act ** 0.33) * gate + 1.5 * lam3 + 2.0 / c.length
        return self.equidistribute(S, rho, N)

    def equidistribute(self, S, rho, N):
        L = self.c.length
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
        self.load = cum[-1]
        out = np.interp(np.linspace(0.0, cum[-1], N + 1), cum, X)
        out[0], out[-1] = 0.0, L
        return out

    def rest(self, N, n):
        c = self.c
        S = c.length - np.geomspace(1e-3, c.length, 4000)[::-1] + 1e-3
        rho = (self.lam0 * np.exp(-(c.length - S) * self.lam0 / 12.0)) + 2.0 / c.length
        X = self.equidistribute(np.clip(S, 0, c.length), rho, N)
        zn = np.zeros((N + 1, self.d))
        zn[:, 0] = self.g0
        return State(X, zn, np.zeros((N, n, self.d)))

    # -------------------------------------------------------------------------------------------------------- corrections
    def correct(self, st, row=None, target=None, tol=1e-8, most=8):
        """Newton. With a row: row . z = target. Without: shortest steps in the scaled norm (Moore-Penrose)."""
        sc = self.scale(len(st.X) - 1)
        free = row is None
        if free:
            row = self.border if self.border is not None and len(self.border) == len(sc) else None
            if row is None:
                raise Failure("no border")
        last = np.inf
        most += 8 * self.pole
        for it in range(most):
            sy = System(self.c, st)
            self.iterations += 1
            if free:
                dx, T = sy.solve(row / sc, 0.0)
                t, x = T / sc, dx / sc
                t = t / np.linalg.norm(t)
                x = x - (x @ t) * t
                dx, row = x * sc, t
            else:
                dx, T = sy.solve(row, target - row @ st.flat())
            size = np.abs(dx / sc).max()
            if not np.isfinite(size) or size > 50.0 * (1.0 + self.c.length / self.ell):
                raise Failure("diverged")
            if self.pole:                                             # stay on this side of cos(theta) = 0
                turn = np.abs(dx[1:self.d * len(st.X):self.d])
                dx = dx * min(1.0, float((0.4 * np.abs(np.cos(st.zn[:, 1])) / np.maximum(turn, 1e-300)).min()))
            new = sy.apply(st, dx)
            if new.zn[:, 0].min() < 0.3 * self.c.r0 - (0.0 if self.c.line_load == "axis-gap" else self.c.height):
                raise Failure("penetrates")
            st = new
            if size < tol or (it > 1 and size < 1e-9 and size > 0.3 * last):
                break
            if it >= 2 and size > 2.0 * last and size > 1e-6 and not self.pole:
                raise Failure("not contracting")
            last = size
        else:
            if size > 1e3 * tol:
                raise Failure("too many iterations")
        if free:
            self.border = row
        self.used = it + 1
        return st

    def tangent(self, st, like=None):
        """Null vector of the linearisation, scaled length 1, oriented along `like`."""
        sc = self.scale(len(st.X) - 1)
        row = like if like is not None else self.border
        sy = System(self.c, st)
        _, T = sy.solve(row / sc, 0.0)
        t = T / sc
        t = t / np.linalg.norm(t)
        return t if t @ row > 0 else -t

    def u(self, st):
        return float(st.zn[-1, 0] - self.g0)

    def P(self, st):
        return float(st.zn[-1, 2])

    # --------------------------------------------------------------------------------------------------------- the path
    def path(self, N=32, n=10, goal=2e-2, fine=(24, 16, 1e-11), want=("peak", "lp1", "lp2"), most=400, verbose=False):
        """Follows the path from rest; returns (why it ended, {kind: State}).

        Ends when all wanted points are found, when P has come back to zero (the strip stands on an edge) or u has.
        A turn seen in three successive points counts only once the point itself has been found on the fine mesh.
        """
        c = self.c
        sc = self.scale(N)
        st = self.rest(N, n)
        row = np.zeros_like(sc)
        row[self.d * N] = 1.0                                         # u
        sy = System(c, st)
        _, T = sy.solve(row, 0.0)                                     # T with du = 1
        self.border = self.good = T / sc / np.linalg.norm(T / sc)
        sy.sol[..., 0] = 0.0
        st1 = self.correct(sy.apply(st, T * 0.02 * c.r0))
        X1 = self.mesh(st1, N)
        s1, s0 = st1.moved(c, X1, n), st.moved(c, X1, n)
        hist = [(0.0, s0), (self.distance(s0, s1), s1)]               # (path length, solution): what is extrapolated
        self.track = [(0.0, 0.0, 0.0), (self.u(st1), self.P(st1), st1.zn[-1, 1])]
        found = {}
        ds = hist[1][0]
        while len(self.track) < most:
            got = None
            sig = hist[-1][0]
            tries = 0
            while got is None:
                tries += 1
                use = hist[-(2 if len(self.track) < 6 else 3):]
                x = [q[0] for q in use]
                wts = [np.prod([(sig + ds - x[j]) / (x[i] - x[j]) for j in range(len(x)) if j != i]) for i in range(len(x))]
                mix = lambda get: sum(w * get(q[1]) for w, q in zip(wts, use))
                pX = mix(lambda s: s.X)
                try:
                    if tries > 2:                                     # a sharp bend: along the tangent, on the last mesh
                        pX = hist[-1][1].X.copy()
                    if np.diff(pX).min() <= 0.2 * np.diff(hist[-1][1].X).min():
                        raise Failure("the mesh folds")
                    pX[0], pX[-1] = 0.0, c.length
                    pred = State(pX, mix(lambda s: s.zn), mix(lambda s: s.K), mix(lambda s: s.H))
                    if tries > 2:
                        pred = self.euler(hist[-1][1], hist[-2][1], ds)
                    new = self.correct(pred)
                    err = self.error(pred, new)
                    if err > 5.0 * goal or self.used > (9 if self.pole else 6):
                        raise Failure("prediction too coarse")
                    went = self.distance(hist[-1][1], new)
                    if self.distance(pred, new) > 0.35 * went:        # also keeps the path from turning on its heel
                        raise Failure("off the direction of the path")
                    got = new
                except (Failure, np.linalg.LinAlgError) as why:
                    if verbose:
                        print(f"      retry ds={ds:.3g}: {why}")
                    ds *= 0.4
                    self.border = self.good
                    if ds < 1e-8:
                        return f"stuck at u={self.track[-1][0]:.6g}: {why}", found
            self.good = self.border
            new = got.moved(c, self.mesh(got, N), n)
            step = self.distance(hist[-1][1], new)
            hist = hist[-3:] + [(sig + step, new)]
            if self.load > 1.7 * N or (N > 32 and self.load < 0.8 * N):
                N = max(32, int(self.load / 1.3))
                hist = [(q, s.moved(c, self.mesh(s, N), n)) for q, s in hist]
                way = (hist[-1][1].flat() - hist[-2][1].flat()) / self.scale(N)
                self.border = self.good = way / np.linalg.norm(way)
            self.track.append((self.u(got), self.P(got), got.zn[-1, 1]))
            if verbose:
                print(f"    {len(self.track):4d} u={self.u(got):.8g} P={self.P(got):.8g} th0={got.zn[0,1]:.4f} thL={got.zn[-1,1]:.4f} "
                      f"ds={ds:.3g} err={err:.2g} it={self.used} load={self.load:.3g} H={got.H:.4g}")
            (u0, P0, _), (u1, P1, _), (u2, P2, _) = self.track[-3:]
            kind = None
            if "peak" not in found:
                if P1 > P0 and P1 >= P2:
                    kind, col, gap = "peak", 1, max(P1 - P0, P1 - P2)
            elif "lp1" not in found:
                if u1 > u0 and u1 >= u2:
                    kind, col, gap = "lp1", 0, max(u1 - u0, u1 - u2)
            elif u1 < u0 and u1 <= u2:
                kind, col, gap = "lp2", 0, max(u0 - u1, u2 - u1)
            if kind:
                keep = self.border
                try:
                    at = self.locate(hist[-2][1], kind, *fine)
                    off = ((self.P if col else self.u)(at) - self.track[-2][col]) * (-1.0 if kind == "lp2" else 1.0)
                    if -1e-4 * gap - 1e-7 <= off <= gap:              # a maximum lies above the points around it, and not far
                        found[kind] = at
                    elif verbose:
                        print(f"      {kind} rejected: off by {off:.3g}, points apart {gap:.3g}")
                except (Failure, np.linalg.LinAlgError) as why:
                    if verbose:
                        print(f"      no {kind} here: {why}")
                self.border = keep
            if all(w in found for w in want):
                return "found", found
            if P2 < 0.0:
                return "P back to zero", found
            if "lp1" in found and u2 < 0.02 * self.u(found["lp1"]):
                return "u back to zero", found
            ds = step * float(np.clip((goal / max(err, 1e-12)) ** (1.0 / 3.0) * 0.9, 0.4, 1.6))
        return "bound on points", found

    def euler(self, st, before, ds):
        """A step of length ds along the tangent at st, away from `before`."""
        st = self.correct(st)
        sc = self.scale(len(st.X) - 1)
        old = State(st.X, before.at(st.X), before.K, before.H).flat()
        sy = System(self.c, st)
        _, T = sy.solve(self.border / sc, 0.0)
        if (T / sc) @ ((st.flat() - old) / sc) < 0:
            T = -T
        sy.sol[..., 0] = 0.0
        there = sy.apply(st, T)
        return sy.apply(st, T * (ds / self.distance(st, State(st.X, there.zn, there.K, there.H))))

    def distance(self, a, b):
        """How far two solutions are apart as functions of S, wherever their meshes lie."""
        dz = np.concatenate([a.zn - b.at(a.X), a.at(b.X) - b.zn])
        return math.sqrt(np.mean((dz[:, 0] / self.ell) ** 2) + np.mean((dz[:, 1] / 0.1) ** 2))

    def error(self, a, b):
        dg = np.abs(a.zn[:, 0] - b.zn[:, 0])
        dt = np.abs(a.zn[:, 1] - b.zn[:, 1]).max()
        return max(float((dg / (np.abs(b.zn[:, 0]) + 0.5 * self.c.r0)).max()), dt / (np.abs(b.zn[:, 1]).max() + 1e-3))

    # ---------------------------------------------------------------------------------------------------- special points
    def tails(self, st):
        """Per sub-interval: the last Chebyshev coefficients of z' (times the interval), against the scale of each component."""
        F = Rule(st.n).F
        co = np.abs(np.einsum("mk,ika->ima", F, st.K))[:, -2:].max(axis=1) * np.diff(st.X)[:, None]
        size = np.ptp(np.concatenate([st.zn, st.inner().reshape(-1, self.d)]), axis=0)
        size[0] = min(size[0], self.c.r0)
        return (co / np.maximum(size, 1e-12)).max(axis=1)

    def locate(self, st, kind, N, n, tol, verbose=False):
        """The point near st at which the tangent has no component in P (peak) or u (lp).

        The mesh starts with N sub-intervals and is halved wherever the Chebyshev coefficients of degree n - 2, n - 1 are
        above tol; then the point is found again.
        """
        X = self.mesh(st, N, quiet=1e-8)
        if self.load > 1.6 * N:
            X = self.mesh(st, int(self.load / 1.6) + 1, quiet=1e-8)
        for round_ in range(12):
            st = st.moved(self.c, X, n)
            sc = self.scale(len(X) - 1)
            row = np.zeros_like(sc)
            row[self.d * (len(X) - 1) + (2 if kind != "peak" else 0)] = 1.0
            self.border = row
            st = self.correct(st, tol=1e-11)
            st = self.turn(st, kind, sc, verbose)
            e = self.tails(st)
            bad = e > tol
            if verbose:
                print(f"      {kind} N={len(X) - 1} n={n} worst tail {e.max():.2e} u={self.u(st):.15g} P={self.P(st):.15g}")
            if not bad.any() or len(X) > 200:
                break
            parts = np.where(e > 1e4 * tol, 3, np.where(bad, 2, 1))
            X = np.concatenate([np.linspace(p, q, k + 1)[:-1] for p, q, k in zip(X[:-1], X[1:], parts)] + [X[-1:]])
        self.tail = float(e.max())
        return st

    def turn(self, st, kind, sc, verbose):
        """On one mesh: solutions on planes across the tangent at st; secant method for the one where the path turns."""
        N = len(st.X) - 1
        col = self.d * N + (2 if kind == "peak" else 0)
        T0 = self.tangent(st)
        base = T0 / sc
        mid = base @ st.flat()
        ahead = (T0 * sc)[:self.d * (N + 1)].reshape(N + 1, self.d)
        sig, phi, cur, step = 0.0, T0[col], st, 1e-5
        tries = 0
        best = abs(phi), st
        for it in range(40):
            try:
                new = self.correct(State(cur.X, cur.zn + ahead * step, cur.K, cur.H), row=base, target=mid + sig + step, tol=3e-13, most=12)
                T = self.tangent(new, like=T0)
            except Failure:
                tries += 1
                if tries > 8:
                    raise
                step *= 0.2
                continue
            if verbose:
                print(f"        {kind} it={it} sigma={sig + step:.6g} phi={T[col]:.3e} u={self.u(new):.14g} P={self.P(new):.14g}")
            slope = (T[col] - phi) / step
            sig, phi, cur = sig + step, T[col], new
            if abs(phi) < best[0]:
                best = abs(phi), new
            elif it > 14 and best[0] < 1e-6:                          # a second direction is nearly free: rounding is all there is
                break
            if slope == 0.0 or abs(phi) < 1e-14:
                break
            step = float(np.clip(-phi / slope, -100.0 * abs(step), 100.0 * abs(step)))
            if abs(step) < (1e-11 if abs(phi) < 1e-9 else 1e-13):
                break
        if best[0] > 1e-6 and not (abs(step) < 1e-10 and best[0] < 1e-4):
            raise Failure(f"{kind}: the tangent does not turn here, {best[0]:.2e}")
        return best[1]


# --------------------------------------------------------------------------------------------------------------- the table
LEVELS = (dict(N=32, n=10, goal=2e-2, fine=(24, 16, 1e-11)), dict(N=40, n=12, goal=1.2e-2, fine=(31, 20, 1e-12)))
THIRD = dict(N=48, n=14, goal=3e-3, fine=(36, 18, 1e-11), most=1500)
VALUES = ("peak_displacement_nm", "peak_force_nN", "peak_end_rotation_rad", "lp1_displacement_nm", "lp1_force_nN",
          "lp2_displacement_nm", "lp2_force_nN")
DEFINING = {"length_nm": "length", "bending_stiffness_factor": "factor", "grip_rotation": "rotation", "line_load": "line_load",
            "far_face": "far_face", "height_nm": "height", "youngs_modulus_GPa": "young", "poissons_ratio": "poisson",
            "hamaker_constant_J": "hamaker", "equilibrium_distance_nm": "r0", "width_nm": "width",
            "grip_horizontal": "horizontal", "shear_correction": "shear_correction"}
COLUMNS = list(DEFINING)[:5] + list(VALUES) + list(DEFINING)[5:] + ["digits_relative"]

D = Strip()
CASES = [
    # the five asked for first
    replace(D, rotation="fixed"), replace(D, horizontal="fixed"), replace(D, line_load="force-only"),
    replace(D, line_load="axis-gap"), replace(D, far_face=False),
    # grips
    replace(D, rotation="fixed", length=200.0, factor=0.1), replace(D, rotation="fixed", length=60.0, factor=0.01),
    replace(D, rotation="fixed", factor=100.0),
    replace(D, horizontal="fixed", factor=0.01), replace(D, horizontal="fixed", length=200.0, factor=0.1),
    replace(D, horizontal="fixed", rotation="fixed"), replace(D, horizontal="fixed", rotation="fixed", factor=0.01),
    # line loads
    replace(D, line_load="force-only", factor=0.1), replace(D, line_load="force-only", factor=0.01),
    replace(D, line_load="axis-gap", factor=0.1), replace(D, line_load="axis-gap", factor=0.01),
    replace(D, line_load="axis-gap", factor=1e-3), replace(D, line_load="axis-gap", far_face=False),
    replace(D, line_load="force-only", far_face=False), replace(D, line_load="force-only", rotation="fixed"),
    replace(D, far_face=False, factor=0.01), replace(D, far_face=False, factor=0.1, length=200.0),
    replace(D, far_face=False, rotation="fixed"),
    # section and material
    replace(D, height=5.0), replace(D, height=20.0), replace(D, young=0.5), replace(D, young=10.0),
    replace(D, poisson=0.0), replace(D, poisson=0.45), replace(D, shear_correction=1.0), replace(D, width=3.0),
    replace(D, hamaker=0.3e-19), replace(D, hamaker=5e-19), replace(D, r0=0.2), replace(D, r0=1.0),
    # lengths and stiffnesses
    replace(D, length=50.0), replace(D, length=50.0, factor=0.01), replace(D, length=400.0), replace(D, length=3000.0),
    replace(D, factor=10.0), replace(D, factor=100.0), replace(D, factor=1000.0), replace(D, factor=0.1),
    replace(D, length=400.0, factor=1e-3), replace(D, length=3000.0, factor=0.01),
    replace(D, factor=1e4), replace(D, factor=1e-5), replace(D, factor=1e-6),
    # two departures at once
    replace(D, line_load="axis-gap", rotation="fixed"), replace(D, line_load="axis-gap", horizontal="fixed"),
    replace(D, line_load="force-only", horizontal="fixed"), replace(D, far_face=False, horizontal="fixed"),
    replace(D, rotation="fixed", factor=1e-3), replace(D, horizontal="fixed", factor=100.0),
    replace(D, horizontal="fixed", length=1000.0), replace(D, line_load="axis-gap", factor=1e-4),
    replace(D, line_load="force-only", factor=1e-3), replace(D, height=2.0, length=60.0),
    replace(D, line_load="axis-gap", height=5.0, young=0.5, hamaker=5e-19, r0=0.3, poisson=0.3, width=2.0, length=150.0),
    # those of the first table, with what it leaves empty
    replace(D), replace(D, length=200.0), replace(D, length=200.0, factor=0.1), replace(D, factor=0.01),
    replace(D, factor=1e-3), replace(D, factor=1e-4), replace(D, length=200.0, factor=10.0), replace(D, length=1000.0),
    replace(D, length=1000.0, factor=0.01),
]

def values(t, found):
    out = dict.fromkeys(VALUES)
    for kind, st in found.items():
        out[f"{kind}_displacement_nm"] = t.u(st)
        out[f"{kind}_force_nN"] = t.P(st)
        if kind == "peak":
            out["peak_end_rotation_rad"] = float(st.zn[-1, 1])
    return out


def compute(c, verbose=False):
    """Both levels of one case: ({value: (number, relative difference)}, remarks)."""
    def run(level):
        t = Tracer(c)
        end, found = t.path(verbose=verbose, **level)
        return values(t, found), end

    def same(p, q):
        return all((p[k] is None) == (q[k] is None) and (p[k] is None or abs(p[k] - q[k]) <= 1e-6 * abs(q[k]) + 1e-14) for k in VALUES)

    (a, end), (b, end_b) = run(LEVELS[0]), run(LEVELS[1])
    why = [end, end_b]
    if not same(a, b):                                                # one of the two has gone astray: shorter steps decide
        third, end = run(THIRD)
        why.append(f"third path: {end}")
        a, b = third, b if same(third, b) or not same(third, a) else a
    out = {}
    for k in VALUES:
        p, q = a[k], b[k]
        if p is None or q is None:
            if p is not None or q is not None:
                why.append(f"{k}: not confirmed, {p} {q}")
            continue
        scale = max(abs(q), 1e-300)
        diff = abs(p - q) / scale
        if k == "peak_end_rotation_rad" and c.rotation == "fixed":
            q, diff = 0.0, 0.0
        if diff < 1e-5:
            out[k] = (q, diff)
        else:
            why.append(f"{k}: the levels differ, {p!r} {q!r}")
    return out, why


def digits(diff):
    """Significant digits that are good: three times the difference, never more than 12."""
    return 12 if diff < 3e-13 else max(1, min(12, int(math.floor(-math.log10(3.0 * diff)))))


def significant(x, nd):
    if x == 0.0:
        return "0"
    e = math.floor(math.log10(abs(x)))
    if e < -4:
        return f"{x:.{nd - 1}e}"
    return f"{x:.{max(0, nd - 1 - e)}f}"


def row_of(c, res):
    r = {}
    for col, name in DEFINING.items():
        v = getattr(c, name)
        r[col] = str(v).lower() if isinstance(v, bool) else v if isinstance(v, str) else f"{v:.16g}"
    for k in VALUES:
        r[k] = significant(res[k][0], digits(res[k][1])) if k in res else ""
    r["digits_relative"] = str(min(digits(d) for _, d in res.values())) if res else "0"
    return r


def strip_of(r):
    kw = {}
    for col, name in DEFINING.items():
        if col in r:
            d = getattr(D, name)
            kw[name] = r[col] == "true" if isinstance(d, bool) else r[col] if isinstance(d, str) else float(r[col])
    return Strip(**kw)


def read_table(path):
    with open(path, newline="") as f:
        return list(csv.DictReader(line for line in f if not line.startswith("#")))


HEAD = """\
# Uniform strips, computed without finite elements by verification/strip_collocation.py (Chebyshev collocation of the strong form).
# Every number is good to the digits printed: two paths on different meshes, two refinements of each point. digits_relative: the least of the row.
# Empty: does not occur before the force has come back to zero, or could not be confirmed. peak = initiation peak (first local maximum of P).
# lp1 = first displacement limit point, lp2 = the next one. hamaker_constant in J, width 1 nm unless the column says otherwise.
"""


def write_table(path, rows):
    with open(path, "w", newline="") as f:
        f.write(HEAD)
        w = csv.DictWriter(f, COLUMNS, lineterminator="\n")
        w.writeheader()
        w.writerows(rows)


def unit(text):
    """One unit of the last digit printed."""
    m, _, e = text.lower().partition("e")
    return 10.0 ** (int(e or 0) - (len(m.partition(".")[2])))


def compare(text, x):
    """Relative difference and whether it is within 1e-9 or within one unit of the last digit printed."""
    ref = float(text)
    diff = abs(x - ref)
    return diff / max(abs(ref), 1e-300) if ref else diff, diff <= max(1e-9 * abs(ref), 1.000001 * unit(text))


# -------------------------------------------------------------------------------------------------------------- self checks
def check_law():
    """Psi and its derivatives against mpmath, from contact to far away, flat to upright."""
    import mpmath as mp
    mp.mp.dps = 50
    rng = np.random.default_rng(1)
    worst = 0.0
    for c in (D, replace(D, far_face=False), replace(D, line_load="axis-gap"), replace(D, height=20.0, r0=0.2)):
        h, r0, K = mp.mpf(c.height), mp.mpf(c.r0), mp.mpf(c.K)
        W = lambda r: K * ((r0 / r) ** 8 / 360 - (r0 / r) ** 2 / 6)

        def psi(g, th):
            y = g + h / 2
            if c.line_load == "axis-gap":
                return W(y - h / 2) - (W(y + h / 2) if c.far_face else 0)
            r1, r2 = y - h / 2 * mp.cos(th), y + h / 2 * mp.cos(th)
            return (W(r1) - (W(r2) if c.far_face else 0)) / mp.cos(th)

        for _ in range(40):
            g = float(c.r0 * 10 ** rng.uniform(-0.25, 2.0))
            th = float(rng.choice([rng.uniform(0, 1e-3), rng.uniform(0, 1.5), math.pi / 2 - rng.uniform(0, 1e-3)]))
            if not c.far_face:
                th = min(th, 1.5)
            got = [float(v) for v in potential(c, np.float64(g), np.float64(th))]
            G, Th = mp.mpf(g), mp.mpf(th)
            want = [mp.diff(psi, (G, Th), o) if sum(o) else psi(G, Th) for o in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))]
            r = G + h * mp.sin(Th / 2) ** 2
            q = r0 / r if c.line_load != "axis-gap" else r0 / G
            rr = r0 / q
            base = K * (q ** 8 / 360 + q ** 2 / 6) / mp.cos(Th) if not c.far_face else K * (q ** 8 / 360 + q ** 2 / 6)
            lever = h
            size = [base, base / rr, base * (lever / rr + 1), base / rr ** 2, base * (lever / rr + 1) / rr, base * (lever / rr + 1) ** 2]
            for a, b, s in zip(got, want, size):
                worst = max(worst, float(abs(a - b) / max(abs(b), s * mp.mpf("1e-3"))))
    print(f"law and derivatives against mpmath (50 digits): worst relative difference {worst:.1e}")
    return worst < 1e-11


def check_balance():
    """The right sides against the potential itself, differentiated numerically with mpmath at random states."""
    import mpmath as mp
    mp.mp.dps = 40
    rng = np.random.default_rng(2)
    worst = 0.0
    for c in (D, replace(D, width=3.0, poisson=0.4), replace(D, line_load="axis-gap", horizontal="fixed")):
        EA, GA = mp.mpf(c.EA), mp.mpf(c.GA)

        def stored(xp, yp, th):
            G1 = xp * mp.cos(th) + yp * mp.sin(th) - 1
            G2 = yp * mp.cos(th) - xp * mp.sin(th)
            return EA * G1 ** 2 / 2 + GA * G2 ** 2 / 2

        for _ in range(20):
            z = np.array([rng.uniform(0.24, 5.0), rng.uniform(-1.5, 1.5), rng.normal(), rng.normal(), 0.0])
            H = float(rng.normal())
            f = field(c, z, H, jac=False)
            at = tuple(mp.mpf(float(v)) for v in (f[4] + 1.0, f[0], z[1]))
            P = potential(c, np.float64(z[0]), np.float64(z[1]))
            want = (mp.diff(stored, at, (1, 0, 0)) - H, mp.diff(stored, at, (0, 1, 0)) - z[2],
                    mp.diff(stored, at, (0, 0, 1)) + c.width * float(P[2]) - f[3], c.width * float(P[1]) - f[2], c.EI * f[1] - z[3])
            worst = max(worst, max(float(abs(v)) for v in want) / (1.0 + abs(f[3])))
    print(f"H = dU/dx', V = dU/dy', M' = dU/dtheta + b dPsi/dtheta, V' = b dPsi/dy: worst difference {worst:.1e}")
    return worst < 1e-12


def check_strong_form(c, kind="lp1"):
    """At one point of a path: first integral along S; every sub-interval integrated again by a Runge-Kutta code."""
    t = Tracer(c)
    _, found = t.path(want=("peak",) if kind == "peak" else ("peak", "lp1"), fine=LEVELS[1]["fine"])
    st = found[kind]
    z = np.concatenate([st.zn, st.inner().reshape(-1, t.d)])
    f = field(c, z, st.H, jac=False)
    g, th, V, M = z[:, :4].T
    N, Q = st.H * np.cos(th) + V * np.sin(th), V * np.cos(th) - st.H * np.sin(th)
    x1 = (1 + N / c.EA) * np.cos(th) - Q / c.GA * np.sin(th)
    stored = 0.5 * N ** 2 / c.EA + 0.5 * Q ** 2 / c.GA + 0.5 * M ** 2 / c.EI
    I = st.H * x1 + V * f[:, 0] + M * f[:, 1] - stored - c.width * potential(c, g, th)[0]
    rest = -c.width * float(potential(c, np.float64(t.g0), np.float64(0.0))[0])
    print(f"first integral H x' + V y' + M theta' - stored - b Psi at {kind} of {c}:")
    print(f"    from {I.min():.15g} to {I.max():.15g} along S, spread {np.ptp(I) / abs(I.mean()):.1e}; -b Psi at rest {rest:.15g}")
    worst = 0.0
    S = np.concatenate([np.linspace(p, q, 2 + int((q - p) / t.ell))[:-1] for p, q in zip(st.X[:-1], st.X[1:])] + [st.X[-1:]])
    zs = st.at(S)                                                     # short pieces: an initial value problem loses digits fast
    zs[-1] = st.zn[-1]
    for i in range(len(S) - 1):
        s = solve_ivp(lambda S, y: field(c, y, st.H, jac=False), S[i:i + 2], zs[i], method="DOP853", rtol=3e-14, atol=1e-15)
        worst = max(worst, float((np.abs(s.y[:, -1] - zs[i + 1]) / np.maximum(np.ptp(zs, axis=0), 1e-9))[:4].max()))
    print(f"    integrated again in {len(S) - 1} pieces with DOP853: worst difference at an end {worst:.1e} of the range of a component")
    return np.ptp(I) < 1e-11 * abs(I.mean()) and worst < 1e-11


def main():
    ap = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    ap.add_argument("--check", action="store_true", help="recompute and compare with the committed table (1e-9 relative)")
    ap.add_argument("--quick", action="store_true", help="a subset of the cases, under a minute")
    ap.add_argument("--reference", metavar="CSV", help="compare with another table of the same columns, strip.csv say")
    ap.add_argument("--only", metavar="TEXT", help="cases whose description contains TEXT; prints, writes nothing")
    ap.add_argument("--verbose", action="store_true", help="print every point of every path")
    ap.add_argument("--out", default=TABLE, help="the table to write or to check against")
    a = ap.parse_args()
    t0 = time.time()
    good = True
    if not a.only:
        good &= check_law()
        good &= check_balance()
        good &= check_strong_form(D)
        good &= check_strong_form(replace(D, horizontal="fixed"), "peak")
    if a.reference:
        for r in read_table(a.reference):
            c = strip_of(r)
            res, why = compute(c)
            print(c)
            for k in VALUES:
                if r.get(k):
                    if k not in res:
                        good = False
                        print(f"    {k:24s} {r[k]:>18s}  NOT FOUND {why}")
                        continue
                    rel, ok = compare(r[k], res[k][0])
                    good &= ok
                    print(f"    {k:24s} {r[k]:>18s} {res[k][0]:22.15g}  differs by {rel:.1e}, {abs(res[k][0] - float(r[k])) / unit(r[k]):.2f} "
                          f"of the last digit {'' if ok else ' MISMATCH'}")
        print(f"{'agrees' if good else 'DOES NOT AGREE'}, {time.time() - t0:.0f} s")
        return 0 if good else 1
    cases = [c for c in CASES if not a.only or a.only in str(c)]
    if a.quick:
        cases = cases[:12] + [c for c in cases[12:] if c in (CASES[20], CASES[32], CASES[38], CASES[41])]
    committed = {strip_of(r): r for r in read_table(a.out)} if a.check else {}
    rows = []
    for c in cases:
        s0 = time.time()
        res, why = compute(c, a.verbose)
        r = row_of(c, res)
        rows.append(r)
        print(f"{c}  [{time.time() - s0:.1f} s] {' | '.join(dict.fromkeys(why))}")
        print("    " + "  ".join(f"{k.replace('displacement_nm', 'u').replace('force_nN', 'P').replace('end_rotation_rad', 'theta')}={r[k] or '-'}"
                                 for k in VALUES) + f"  digits={r['digits_relative']}", flush=True)
        if a.check:
            old = committed.get(c)
            if old is None:
                good = False
                print("    NOT IN THE TABLE")
                continue
            for k in VALUES:
                if old[k] and k not in res:
                    good = False
                    print(f"    MISMATCH {k}: {old[k]} in the table, not found now")
                elif old[k]:
                    rel, ok = compare(old[k], res[k][0])
                    if not ok:
                        good = False
                        print(f"    MISMATCH {k}: {old[k]} in the table, {res[k][0]!r} now, {rel:.1e}")
        if "peak_force_nN" not in res:
            good = False
            print("    NO INITIATION PEAK")
    if not (a.check or a.quick or a.only):
        write_table(a.out, rows)
        print(f"wrote {a.out}")
    print(f"{len(rows)} cases, {time.time() - t0:.0f} s, {'all checks passed' if good else 'CHECKS FAILED'}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

"""Newton corrections towards the path of equilibria of one strip, and its tangent."""
import math

import numpy as np

from . import laws
from .law import field, rest_gap
from .system import System


CAP = 0.3


class Failure(Exception):
    pass


class Solver:
    """What belongs to one strip, and the direction (`border`) along which corrections do not go."""

    def __init__(self, strip):
        self.strip = strip
        self.d = 6 if strip.sticks else 4 if strip.horizontal == "free" and strip.angle == 90.0 else 5
        self.tip = strip.at(0.0)
        self.g0 = rest_gap(self.tip)
        self.raised = strip.end_gap                                   # gap of the grip at u = 0
        # u at which the path begins: not where the grip would lie in the substrate
        self.first = 0.0 if self.raised > 0.5 * self.g0 else self.g0 - self.raised
        z0 = np.zeros(self.d)
        z0[0] = self.g0
        _, J, _ = field(self.tip, z0, 0.0)
        self.k0 = J[2, 0]                                             # stiffness of the adhesion at rest
        self.lam0 = (self.k0 / self.tip.EI) ** 0.25
        self.ell = 1.0 / self.lam0
        # Psi = W/cos(theta), nothing to make up for the cos
        self.pole = strip.law == "body-force" and strip.line_load != "axis-gap" and not strip.far_face
        self.border = None

    def scale(self, N):
        """The size of each unknown on N sub-intervals."""
        c = self.tip
        M = c.EI * 0.1 * self.lam0
        force = 0.1 * c.K / c.r0 * c.width * self.ell
        s = [c.r0, 0.1, force, M, self.ell, force][:self.d]
        v = np.tile(s, N + 1)
        return np.append(v, s[2]) if self.d == 5 else v

    def u(self, st):
        """Displacement of the grip along the pull."""
        cos, sin = self.strip.pull
        up = st.zn[-1, 0] - self.raised
        return float(up if self.d == 4 else sin * up + cos * (st.zn[-1, 4] - self.strip.stretch))

    def P(self, st):
        """Force along the pull."""
        cos, sin = self.strip.pull
        return float(st.zn[-1, 2] if self.d == 4 else sin * st.zn[-1, 2] + cos * (st.H if self.d == 5 else st.zn[-1, 5]))

    def power(self, st):
        """Work of the grip per displacement: the force along the pull and, where the grip turns as it goes, the moment."""
        return self.P(st) + math.radians(self.strip.turn) * float(st.zn[-1, 3])

    def row(self, what, N):
        """Derivative of "u" or "P" to the unknowns on N sub-intervals."""
        cos, sin = self.strip.pull
        row = np.zeros(self.d * (N + 1) + (self.d == 5))
        up = self.d * N + (0 if what == "u" else 2)
        row[up] = sin
        if self.d >= 5:
            row[up + 4 if what == "u" else -1 if self.d == 5 else up + 3] = cos
        return row

    def correct(self, st, row=None, target=None, tol=1e-8, most=8):
        """Newton. With a row: row . z = target. Without: shortest steps in the scaled norm (Moore-Penrose)."""
        sc = self.scale(len(st.X) - 1)
        free = row is None
        if free:
            row = self.border
            if row is None or len(row) != len(sc):
                raise Failure("no border")
        last = np.inf
        most += 8 * self.pole
        for it in range(most):
            sy = System(self.strip, st)
            if free:
                dx, T = sy.solve(row / sc, 0.0)
                t, x = T / sc, dx / sc
                t = t / np.linalg.norm(t)
                x = x - (x @ t) * t
                dx, row = x * sc, t
            else:
                dx, T = sy.solve(row, target - row @ st.flat())
            size = np.abs(dx / sc).max()
            if not np.isfinite(size) or size > 50.0 * (1.0 + self.strip.length / self.ell):
                raise Failure("diverged")
            if self.pole:                                             # stay on this side of cos(theta) = 0
                turn = np.abs(dx[1:self.d * len(st.X):self.d])
                dx = dx * min(1.0, float((0.4 * np.abs(np.cos(st.zn[:, 1])) / np.maximum(turn, 1e-300)).min()))
            st = sy.apply(st, dx)
            if (st.zn[:, 0] + self.above(st)).min() < 0.3 * self.strip.r0:
                raise Failure("penetrates")
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

    def above(self, st):
        """By how much a node may be lower than the gap of a level section: the height, where the law sees the tilt or has no pole."""
        blind = self.strip.line_load == "axis-gap" and self.strip.law not in laws.COHESIVE
        return 0.0 if blind else self.strip.at(st.X).height

    def held(self, st, u, tol=1e-11, most=12):
        """The equilibrium next to st at a displacement of the grip."""
        row = self.row("u", len(st.X) - 1)
        return self.correct(st, row=row, target=u - self.u(st) + row @ st.flat(), tol=tol, most=most)

    def near(self, S, z):
        """The gap of the underside at places S."""
        return z[:, 0] + self.strip.at(S).height * np.sin(0.5 * z[:, 1]) ** 2

    def settled(self, st, most=300):
        """The equilibrium at the first displacement that st falls into: Newton steps that change no gap by more than CAP of itself."""
        row = self.row("u", len(st.X) - 1)
        for _ in range(most):
            sy = System(self.strip, st)
            dx, _ = sy.solve(row, self.first - self.u(st))
            dz = dx[:self.d * len(st.X)].reshape(-1, self.d)
            change = np.abs(dz[:, 0] + 0.5 * self.strip.at(st.X).height * np.sin(st.zn[:, 1]) * dz[:, 1])
            share = min(1.0, CAP * float((self.near(st.X, st.zn) / np.maximum(change, 1e-300)).min()))
            st = sy.apply(st, dx * share, share)
            if share == 1.0 and np.abs(dx / self.scale(len(st.X) - 1)).max() < 1e-10:
                return st
        raise Failure("does not settle at rest")

    def tangent(self, st, like=None):
        """Null vector of the linearisation, scaled length 1, oriented along `like`."""
        sc = self.scale(len(st.X) - 1)
        row = like if like is not None else self.border
        _, T = System(self.strip, st).solve(row / sc, 0.0)
        t = T / sc
        t = t / np.linalg.norm(t)
        return t if t @ row > 0 else -t

    def steepness(self, st):
        """d ln P / d ln u of the path at st."""
        N = len(st.X) - 1
        _, T = System(self.strip, st).solve(self.row("P", N), 0.0)    # T with dP = 1: regular where u turns
        return self.u(st) / (self.P(st) * (self.row("u", N) @ T))

    def distance(self, a, b):
        """How far two solutions are apart as functions of S, wherever their meshes lie."""
        dz = np.concatenate([a.zn - b.at(a.X), a.at(b.X) - b.zn])
        along = np.mean((dz[:, 4] / self.ell) ** 2) if self.d == 6 else 0.0
        return math.sqrt(np.mean((dz[:, 0] / self.ell) ** 2) + np.mean((dz[:, 1] / 0.1) ** 2) + along)

    def error(self, predicted, st):
        """How good a prediction was, relative to the gap and to the largest rotation."""
        dg = np.abs(predicted.zn[:, 0] - st.zn[:, 0])
        dt = np.abs(predicted.zn[:, 1] - st.zn[:, 1]).max()
        along = 0.0
        if self.d == 6:
            along = np.abs(predicted.zn[:, 4] - st.zn[:, 4]).max() / (np.abs(st.zn[:, 4]).max() + 0.1 * self.strip.r0)
        return max(float((dg / (np.abs(st.zn[:, 0]) + 0.5 * self.strip.r0)).max()), dt / (np.abs(st.zn[:, 1]).max() + 1e-3), along)

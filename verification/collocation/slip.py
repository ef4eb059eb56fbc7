"""Paths with friction: formulas change at places that move, and where a point slides back its anchor has a history.

Every solution has nodes where formulas change, so that it converges as fast as a smooth one. The path is followed along a direction in
the space of what the grip does (gap, rotation, forces, place), which does not depend on the mesh.
"""
import copy

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from .law import _near, field
from .mesh import mesh, rest_state, with_corners
from .solver import Failure, Solver
from .system import Rule, State, System
from .turns import divided, tails

MOST_INTERVALS = 600
ROUGH = (32, 10, 1e-6)                                                # N, n, tail: between the turns
SLID_BACK = 1e-8                                                      # nm, what counts
FINE = ((30, 16, 1e-11), (39, 20, 1e-12))


class Anchors:
    """How far the anchors have come, a piecewise polynomial of S."""

    def __init__(self, X, values, breaks=()):
        self.X, self.values, self.breaks = X, values, breaks

    def __call__(self, S):
        R = Rule(self.values.shape[1])
        t, shape = R.t, np.shape(S)
        S = np.ravel(S)
        i = np.clip(np.searchsorted(self.X, S, side="right") - 1, 0, len(self.X) - 2)
        s = (S - self.X[i]) / np.diff(self.X)[i]
        k = np.arange(len(t))
        weight = (-1.0) ** k * np.sin((2 * k + 1) * np.pi / (2 * len(t)))
        dx = s[:, None] - t
        hit = np.abs(dx) < 1e-15
        q = weight / np.where(hit, 1.0, dx)
        q[hit.any(axis=1)] = hit[hit.any(axis=1)]
        return ((q * self.values[i]).sum(axis=1) / q.sum(axis=1)).reshape(shape)


def anchored(strip, anchors):
    """The strip with its anchors where they have come to."""
    out = copy.copy(strip)

    def at(S):
        here = copy.copy(strip)
        object.__setattr__(here, "slid", anchors(S))
        return here

    object.__setattr__(out, "at", at)
    object.__setattr__(out, "breaks", anchors.breaks)
    return out


def nodes(s, st, X):
    """The mesh with nodes where formulas change in st and where the anchors have a kink."""
    X = with_corners(s, st, X)
    for place in getattr(s.strip, "breaks", ()):
        j = int(np.searchsorted(X, place))
        if min(X[j] - place, place - X[j - 1]) > 1e-9:
            X = np.insert(X, j, place)
    return X


def settled(s, st, way, value, N, n, tol, most=8):
    """The solution near st with way . (what the grip does) = value, and the tangent of the path there, way . tangent = 1.

    A corner off its node by x costs the order x^2: laid anew around the corners of the last solution the mesh converges like Newton.
    """
    X, load = mesh(s, st, N, quiet=1e-8 if tol < 1e-8 else 1e-5)
    if load.sum() > 1.6 * N:
        X, _ = mesh(s, st, int(load.sum() / 1.6) + 1, quiet=1e-8 if tol < 1e-8 else 1e-5)
    last = None
    for k in range(most):
        Y = nodes(s, st, X)
        st = st.moved(s.strip, Y, n)
        row = along(s, way, len(Y) - 1)
        st = s.correct(st, row=row, target=value, tol=max(1e-11, 1e-3 * tol), most=25)
        bad = (tail := tails(s, st)) > tol
        more = bad.any() and len(X) < MOST_INTERVALS and k < most - 2
        if more:
            X = divided(Y, np.where(tail > 1e4 * tol, 3, np.where(bad, 2, 1)))
        now = np.array([s.u(st), s.P(st)])
        if last is not None and not more and (np.abs(now - last) < 0.01 * tol * np.abs(now) + 1e-14).all():
            break
        last = now
    _, T = System(s.strip, st).solve(along(s, way, len(st.X) - 1), 0.0)
    return st, T


def along(s, way, N):
    row = np.zeros(s.d * (N + 1))
    row[s.d * N:] = way
    return row


def grip(s, what):
    """u or P as a linear form of what the grip does."""
    return s.row(what, 1)[-s.d:]


class Walk:
    """The path from rest. found: peak, lp1, and slide, from where on the whole strip slides; points; back: of every step u, P, S and how
    far a point in contact has slid back there.

    Anchors stay at rest, which is exact, until a point slides back (u = `turned` at the point that shows it). There the path ends, or
    with `carry` they come along after every step from the last point before, number `since`, on; with `history` from the first. Ends, too, where P has fallen to `least` of the peak.
    """

    def __init__(self, strip, fine=FINE[0], rough=ROUGH, want=("peak",), most=400, goal=0.03, history=False, longest=np.inf, stop=None, least=-np.inf, carry=False,
                 verbose=False):
        self.s, self.fine, self.rough, self.want = Solver(strip), fine, rough, want
        self.goal, self.history, self.longest, self.stop, self.verbose = goal, history, longest, stop, verbose
        self.bare, self.least, self.carry = strip, least, carry
        self.found, self.points, self.tangents, self.back = {}, [], [], []
        self.grid = np.linspace(0.0, strip.length, 8001)
        self.slips = np.zeros_like(self.grid)
        self.anchors, self.since, self.turned = None, None, None
        self.end = self.follow(most)

    def size(self):
        """Of what the grip does."""
        return self.s.scale(1)[-self.s.d:]

    def start(self):
        s = self.s
        st = rest_state(s, [48], self.rough[1])
        up = grip(s, "u")
        st, T = settled(s, st, up, up @ st.zn[-1], *self.rough)
        self.points, self.tangents = [st], [T[-s.d:]]
        self.labels = [0.0]

    def follow(self, most):
        self.start()
        s, ds = self.s, 0.02
        while len(self.points) < most:
            try:
                st, T, way, err, ds = self.step(ds)
            except Failure as why:
                return str(why)
            if not self.history and self.turns_back(st)[3] > SLID_BACK:
                self.turned = s.u(st)
                if not self.carry:
                    return "a point slides back"
                self.history = True
                self.commit(self.points[-1])                          # the step once more, with the anchors where they are now
                self.since = len(self.points)
                continue
            self.points.append(st)
            self.tangents.append(T)
            self.labels.append(self.labels[-1] + ds)
            self.back.append(self.turns_back(st))
            self.slips = self.slip_of(st, self.grid)[0]
            if self.verbose:
                print(f"    {len(self.points):4d} u={s.u(st):.8g} P={s.P(st):.8g} gap={st.zn[-1, 0]:.6g} thL={st.zn[-1, 1]:.5f} x0={st.zn[0, 4]:.4g} "
                      f"ds={ds:.3g} err={err:.2g} N={len(st.X)} back={self.back[-1][3]:.1e} at {self.back[-1][2]:.2f}", flush=True)
            self.look(way)
            if self.history:
                self.commit(st)
            if all(w in self.found for w in self.want):
                return "found"
            top = self.found.get("peak", self.found.get("slide"))
            if top is not None and s.P(st) < self.least * s.P(top):
                return "fallen"
            if s.P(st) < 0.0:
                return "P back to zero"
            if self.stop and self.stop(s, st):
                return "stopped"
            ds = min(self.longest, ds * float(np.clip((self.goal / max(err, 1e-12)) ** (1.0 / 3.0) * 0.9, 0.4, 1.6)))
        return "bound on points"

    def step(self, ds):
        s = self.s
        last, size = self.points[-1], self.size()
        way = self.tangents[-1] / size
        way = way / np.linalg.norm(way)
        if len(self.points) > 1 and way @ ((last.zn[-1] - self.points[-2].zn[-1]) / size) < 0.0:
            way = -way
        way = way / size
        for _ in range(14):
            try:
                guess = self.predicted(ds)
                value = way @ last.zn[-1] + ds
                st, T = settled(s, guess, way, value, *self.rough, most=5)
                here = st.at(guess.X)
                err = s.error(guess, State(guess.X, here, None))
                if err > 4.0 * self.goal:
                    raise Failure("prediction too coarse")
                return st, T[-s.d:], way, err, ds
            except (Failure, np.linalg.LinAlgError) as why:
                if self.verbose:
                    print(f"      retry ds={ds:.3g}: {why}")
                ds *= 0.4
        raise Failure(f"stuck at u={s.u(last):.6g}, P={s.P(last):.6g}")

    def predicted(self, ds):
        """Extrapolated on the mesh of the last point, with as many points as there are up to three."""
        s = self.s
        last = self.points[-1]
        use = list(zip(self.labels, self.points))[-3:]
        if ds < 1e-9:
            raise Failure("no step left")
        label = use[-1][0] + ds
        if len(use) == 1:
            return last
        zn = np.zeros_like(last.zn)
        for i, (p, st) in enumerate(use):
            w = np.prod([(label - q) / (p - q) for j, (q, _) in enumerate(use) if j != i])
            zn += w * (last.zn if st is last else st.at(last.X))
        inner = np.zeros((len(last.X) - 1, last.n, s.d))
        S = last.points()
        for i, (p, st) in enumerate(use):
            w = np.prod([(label - q) / (p - q) for j, (q, _) in enumerate(use) if j != i])
            inner += w * st.at(S.ravel()).reshape(inner.shape)
        return State(last.X, zn, field(s.strip.at(S), inner, 0.0, jac=False))

    def slip_of(self, st, S):
        """How far the anchors are from where they were at rest, and tau."""
        c = self.s.strip
        here = c.at(S)
        slip, tau = c.friction.slip(here, st.at(np.ravel(S)).reshape(*np.shape(S), self.s.d), _near)
        return slip + here.slid, tau

    def turns_back(self, st):
        """u, P, S and how far a point in contact has slid back there since the last point of the path."""
        s = self.s
        slips, tau = self.slip_of(st, self.grid)
        back = np.where(tau > 1e-3 * s.strip.friction.tau0, np.minimum(-np.sign(self.slips) * (slips - self.slips), np.abs(self.slips)), 0.0)
        i = int(np.argmax(back))
        return s.u(st), s.P(st), float(self.grid[i]), float(back[i])

    def look(self, way):
        """Turns between the last two points."""
        s = self.s
        a, b = self.points[-2:]
        for kind, what in (("slide", None), ("peak", "P"), ("lp1", "u")):
            if kind in self.found or kind not in self.want:
                continue
            form = what and grip(s, what)
            reads = (lambda st, T: form @ T) if what else lambda st, T: self.sticks(st)
            before, after = (reads(st, T / (way @ T)) for st, T in zip((a, b), self.tangents[-2:]))
            if not before > 0.0 >= after or what and "slide" in self.found:
                continue
            try:
                self.found[kind] = self.turn(a, b, way, reads)
            except (Failure, np.linalg.LinAlgError, ValueError) as why:
                if self.verbose:
                    print(f"      no {kind} here: {why}")

    def sticks(self, st):
        """How far below tau the traction is where it is farthest below: negative where the whole strip slides."""
        c = self.s.strip
        S = np.concatenate([st.X, st.points().ravel()])
        depth = lambda S: -c.friction.corners(c.at(S), st.at(S), _near)[0]
        S = S[np.argsort(S)]
        at = depth(S)
        i = int(np.argmax(at))
        if not 0 < i < len(S) - 1:
            return float(at[i])
        best = minimize_scalar(lambda x: -float(depth(np.array([x]))[0]), bounds=(S[i - 1], S[i + 1]), method="bounded", options={"xatol": 1e-10})
        return max(float(at[i]), -float(best.fun))

    def turn(self, a, b, way, reads):
        """Where reads(solution, tangent) is nought between two points."""
        s = self.s
        known = {float(way @ st.zn[-1]): st for st in (a, b)}
        low, high = min(known), max(known)

        def component(value, tries=6):
            near = min(known, key=lambda q: abs(q - value))
            try:
                st, T = settled(s, known[near], way, value, *self.fine)
            except Failure:                                           # by way of the middle
                if not tries:
                    raise
                component(0.5 * (near + value), tries - 1)
                return component(value, tries - 1)
            known[value] = st
            return float(reads(st, T[-s.d:]))

        if component(low) * component(high) > 0.0:                    # the rough solutions were on the wrong side
            wide = high - low
            low, high = low - 0.1 * wide, high + 0.1 * wide
        value = float(brentq(component, low, high, xtol=1e-14, rtol=1e-14, maxiter=40))
        if value not in known:
            component(value)
        return known[value]

    def commit(self, st):
        """The anchors come along; a kink stays where stick meets slip."""
        values, _ = self.slip_of(st, st.points())
        kinks = [p for p in boundaries(self.s, st)]
        old = self.anchors.breaks if self.anchors else ()
        self.anchors = Anchors(st.X, values, tuple(sorted({*old, *kinks})))
        self.s.strip = anchored(self.bare, self.anchors)


def boundaries(s, st):
    """Where stick meets slip."""
    c = s.strip
    corner = lambda S: c.friction.corners(c.at(S), st.at(S), _near)[0]
    h = np.diff(st.X)
    S = np.sort(np.concatenate([st.X[:-1] + 1e-9 * h, st.X[1:] - 1e-9 * h, st.points().ravel()]))
    at = corner(S)
    changes = np.flatnonzero((at[:-1] <= 0.0) != (at[1:] <= 0.0))
    return [brentq(lambda x: float(corner(np.array([x]))[0]), S[i], S[i + 1], xtol=1e-13) for i in changes]


def boundary(s, st):
    """The boundary of slip farthest from the grip, that of a few nm at the free end aside; 0 where the whole strip slides or nearly so,
    None where nothing does."""
    at = boundaries(s, st)
    c = s.strip
    if c.friction.corners(c.at(st.X[:1]), st.zn[:1], _near)[0][0] > 0.0:
        at = at[1:]                                                   # the free end slides, too
        return at[0] if at else 0.0
    return at[0] if at else None

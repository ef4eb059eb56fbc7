"""Paths with friction: where a point turns back, what it remembers counts.

The path is followed along a direction in the space of what the grip does (gap, rotation, forces, place), which does not depend on the
mesh. Nodes lie where a point has not moved since the last step, and where those steps have left a kink.
"""
import copy

import numpy as np
from scipy.optimize import brentq

from .law import _near, field
from .mesh import mesh, rest_state, with_corners
from .solver import Failure, Solver
from .system import Rule, State, System
from .turns import divided, tails

MOST_INTERVALS = 600
ROUGH = (32, 10, 1e-6)                                                # N, n, tail: between the turns
TURNED_BACK = 1e-9                                                    # nm, what counts
APART = 1e-3                                                          # nm, of kinks
WEAK = 1e-5                                                           # 1/nm, jump of the slope of s
FINE = ((30, 16, 1e-11), (39, 20, 1e-12))


class Memory:
    """x_b - S and s behind the last step, piecewise polynomials of S; kinks: where they are not smooth."""

    def __init__(self, X, values, kinks=()):
        self.X, self.values, self.kinks = X, values, kinks

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
        return np.moveaxis(np.einsum("ik,ikd->id", q, self.values[i]) / q.sum(axis=1)[:, None], -1, 0).reshape(2, *shape)


def remembering(strip, memory):
    """The strip with what its points remember."""
    out = copy.copy(strip)

    def at(S):
        here = copy.copy(strip)
        slid, share = memory(S)
        object.__setattr__(here, "slid", slid)
        object.__setattr__(here, "share", share)
        return here

    object.__setattr__(out, "at", at)
    object.__setattr__(out, "kinks", memory.kinks)
    return out


def remembered(s, st, S):
    """x_b - S and s at places S, and tau there."""
    c = s.strip.at(S)
    way, d = c.friction.face(c, st.at(np.ravel(S)).reshape(*np.shape(S), s.d))
    return way + c.slid, c.friction.share(c, way)[0], c.friction.limit(c, d, _near)[0]


def committed(bare, s, st):
    """The strip behind a step that ends in st."""
    slid, share, _ = remembered(s, st, st.points())
    kinks = list(getattr(s.strip, "kinks", ()))
    for place in unmoved(s, st):
        if all(abs(place - k) > APART for k in kinks):
            kinks.append(place)
    if kinks:
        tau = remembered(s, st, np.array(kinks))[2]
        kinks = [k for k, held in zip(kinks, tau) if held > 1e-9 * bare.friction.tau0]
    return remembering(bare, Memory(st.X, np.stack([slid, share], axis=-1), tuple(sorted(kinks))))


def unmoved(s, st):
    """Where a point has not moved since the last step."""
    c = s.strip
    way = lambda S: c.friction.face(c.at(S), st.at(S))[0]
    S = np.sort(np.concatenate([st.X, st.points().ravel()]))
    at = way(S)
    jump = np.abs(np.diff(at) / np.maximum(np.diff(S), 1e-12) * c.at(0.5 * (S[1:] + S[:-1])).share) / c.friction.delta(c)
    i = np.flatnonzero((at[:-1] * at[1:] < 0.0) & (jump > WEAK))
    return [brentq(lambda x: float(way(np.array([x]))[0]), S[k], S[k + 1], xtol=1e-13) for k in i]


def nodes(s, st, X):
    """The mesh with nodes where the law has a kink in st and where what is remembered has one."""
    X = with_corners(s, st, X)
    for place in getattr(s.strip, "kinks", ()):
        j = int(np.searchsorted(X, place))
        if min(X[j] - place, place - X[j - 1]) > 1e-9:
            X = np.insert(X, j, place)
    return np.delete(X, np.flatnonzero(np.diff(X[:-1]) < 1e-9) + 1)


def settled(s, st, way, value, N, n, tol, most=8):
    """The solution near st with way . (what the grip does) = value, and the tangent of the path there, way . tangent = 1.

    A kink off its node by x costs the order x^2: laid anew around the kinks of the last solution the mesh converges like Newton.
    """
    quiet = 1e-8 if tol < 1e-8 else 1e-5
    X, load = mesh(s, st, N, quiet=quiet)
    if load.sum() > 1.6 * N:
        X, _ = mesh(s, st, int(load.sum() / 1.6) + 1, quiet=quiet)
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
    """The path from rest. found: peak, lp1, and whether one_way; points; turned: u of the first of them at which a point of the strip in
    contact has turned back by more than TURNED_BACK; rubbed: work of the friction up to each, by the trapezoidal rule.

    In the one-way form, or with `history`: what points remember is that of the last point of the path; `longest`: the longest step then.
    Ends, too, where P has fallen to `least` of the peak.
    """

    def __init__(self, strip, fine=FINE[0], rough=ROUGH, want=("peak",), most=400, goal=0.03, history=False, longest=np.inf, stop=None, least=-np.inf,
                 verbose=False):
        self.s, self.fine, self.rough, self.want = Solver(strip), fine, rough, want
        self.goal, self.history, self.longest, self.stop, self.verbose = goal, history, longest, stop, verbose
        self.bare, self.least = strip, least
        self.found, self.one_way, self.points, self.tangents = {}, {}, [], []
        self.grid = np.linspace(0.0, strip.length, 8001)
        self.slid, self.gone, self.held = (np.zeros_like(self.grid) for _ in range(3))
        self.turned, self.rubbed = None, [0.0]
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
        s, ds = self.s, min(0.02, self.longest)
        while len(self.points) < most:
            try:
                st, T, way, err, ds = self.step(ds)
            except Failure as why:
                return str(why)
            self.points.append(st)
            self.tangents.append(T)
            self.labels.append(self.labels[-1] + ds)
            found = set(self.found)
            self.look(way)
            for kind in set(self.found) - found:
                self.one_way[kind] = self.turned is None and self.back(self.found[kind])[0] <= TURNED_BACK
            if self.verbose:
                print(f"    {len(self.points):4d} u={s.u(st):.8g} P={s.P(st):.8g} gap={st.zn[-1, 0]:.6g} thL={st.zn[-1, 1]:.5f} x0={st.zn[0, 4]:.4g} "
                      f"ds={ds:.3g} err={err:.2g} N={len(st.X)} back={self.back(st)[0]:.1e} at {self.back(st)[1]:.2f}", flush=True)
            if all(w in self.found for w in self.want):
                return "found"
            self.watch(st)
            if self.history:
                s.strip = committed(self.bare, s, st)
            if self.turned is not None and "peak" in self.found and not self.history:
                return "turns back"
            if "peak" in self.found and s.P(st) < self.least * s.P(self.found["peak"]):
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

    def back(self, st):
        """How far a point in contact has turned back in st, at most, and where: half of what it has gone more than it is away."""
        slid, _, tau = remembered(self.s, st, self.grid)
        back = 0.5 * (self.gone + np.abs(slid - self.slid) - np.abs(slid))
        back[tau < 1e-3 * self.bare.friction.tau0] = 0.0
        i = int(np.argmax(back))
        return float(back[i]), float(self.grid[i])

    def watch(self, st):
        if self.turned is None and self.back(st)[0] > TURNED_BACK:
            self.turned = self.s.u(st)
        slid, share, tau = remembered(self.s, st, self.grid)
        taken = np.trapezoid(0.5 * (share * tau + self.held) * (slid - self.slid), self.grid)
        self.rubbed.append(self.rubbed[-1] + self.bare.width * float(taken))
        self.gone, self.slid, self.held = self.gone + np.abs(slid - self.slid), slid, share * tau

    def look(self, way):
        """Turns between the last two points."""
        s = self.s
        a, b = self.points[-2:]
        for kind, what in (("peak", "P"), ("lp1", "u"), ("lp2", "u")):
            if kind in self.found or kind not in self.want or kind == "lp2" and "lp1" not in self.found:
                continue
            form = grip(s, what)
            sense = -1.0 if kind == "lp2" else 1.0
            before, after = (sense * float(form @ T / (way @ T)) for T in self.tangents[-2:])
            if not before > 0.0 >= after:
                continue
            try:
                self.found[kind] = self.turn(a, b, way, form)
            except (Failure, np.linalg.LinAlgError, ValueError) as why:
                if self.verbose:
                    print(f"      no {kind} here: {why}")

    def turn(self, a, b, way, form):
        """Where form @ tangent is nought between two points."""
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
            return float(form @ T[-s.d:])

        wide = high - low
        if self.history:                                              # in the last point itself nothing tells which way points go
            low += 1e-4 * wide
            if component(low) <= 0.0:                                 # it turns there, as well as steps tell
                return known[low]
        elif component(low) * component(high) > 0.0:                  # the rough solutions were on the wrong side
            low, high = low - 0.1 * wide, high + 0.1 * wide
        value = float(brentq(component, low, high, xtol=1e-14, rtol=1e-14, maxiter=40))
        if value not in known:
            component(value)
        return known[value]

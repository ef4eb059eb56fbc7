"""The path of equilibria of a beam from rest, with its turning points."""
import math
from dataclasses import replace

import numpy as np

from .mesh import mesh, pin, rest_state
from .solver import Failure, Solver
from .system import State, System
from .turns import locate

TURNS = ("peak", "lp1", "lp2")


def interpolated(states, labels, label):
    """The state at a label from those at others, mesh and all: Lagrange."""
    w = [np.prod([(label - q) / (p - q) for j, q in enumerate(labels) if j != i]) for i, p in enumerate(labels)]
    mix = lambda get: sum(a * get(st) for a, st in zip(w, states))
    return State(mix(lambda s: s.X), mix(lambda s: s.zn), mix(lambda s: s.K), mix(lambda s: s.H))


class Path:
    """Follows the path until all wanted points are found, P has come back to zero (the strip stands on an edge) or u has.

    N sub-intervals of degree n at first; goal: relative error of a prediction; fine: N, n and the tail of a turning point.
    Found, too: "top", the largest maximum of P up to lp1.
    """
    LEAST = 32                                                        # sub-intervals


    def __init__(self, strip, N=32, n=10, goal=2e-2, fine=(24, 16, 1e-11), want=TURNS, most=400, verbose=False):
        self.s = Solver(strip)
        self.n, self.goal, self.fine, self.want, self.most, self.verbose = n, goal, fine, want, most, verbose
        pieces = len(strip.ends) - 1
        self.least = max(2, self.LEAST // pieces)
        self.counts = np.full(pieces, max(self.least, N // pieces))       # sub-intervals on each piece
        self.found = {}                                               # kind -> State
        self.points, self.labels = [], []                             # every State of the path, and how far along it lies
        self.good = None                                              # direction of the path at the last point
        self.end = self.follow()

    def follow(self):
        """Why the path ended."""
        self.start()
        s, ds = self.s, self.hist[1][0]
        while len(self.points) < self.most:
            try:
                got, err, ds = self.advance(ds)
            except Failure as why:
                return str(why)
            step = self.accept(got)
            self.say(f"{len(self.points):4d} u={s.u(got):.8g} P={s.P(got):.8g} th0={got.zn[0, 1]:.4f} thL={got.zn[-1, 1]:.4f} "
                     f"ds={ds:.3g} err={err:.2g} it={s.used} N={self.counts}")
            self.look_for_turn()
            if all(w in self.found for w in self.want):
                return "found"
            if s.P(got) < 0.0 <= s.P(self.points[-2]):
                return "P back to zero"
            if "lp1" in self.found and s.u(got) < 0.02 * s.u(self.found["lp1"]):
                return "u back to zero"
            ds = step * float(np.clip((self.goal / max(err, 1e-12)) ** (1.0 / 3.0) * 0.9, 0.4, 1.6))
        return "bound on points"

    def say(self, text):
        if self.verbose:
            print("   ", text)

    def start(self):
        """Rest, and the first point: a fiftieth of r0 up, or less where the strip is so soft that this is far."""
        s = self.s
        st = self.at_rest()
        N = len(st.X) - 1
        sc = s.scale(N)
        sy = System(s.strip, st)
        _, T = sy.solve(s.row("u", N), 0.0)                           # T with du = 1
        s.border = self.good = T / sc / np.linalg.norm(T / sc)
        sy.sol[..., 0] = 0.0
        first, rise = None, 0.02 * s.strip.r0
        while first is None:
            try:
                first = s.correct(sy.apply(st, T * rise))
            except Failure:
                rise, s.border = 0.3 * rise, self.good
                if rise < 1e-9:
                    raise
        X, _ = mesh(s, first, self.counts)
        a, b = st.moved(s.strip, X, self.n), first.moved(s.strip, X, self.n)
        self.hist = [(0.0, a), (s.distance(a, b), b)]                 # (path length, solution): what is extrapolated
        self.points, self.labels = [a, b], [q[0] for q in self.hist]

    def at_rest(self):
        """The equilibrium at u = 0. What is free of stress need not be one."""
        s = self.s
        st = rest_state(s, self.counts, self.n)
        if s.strip.turned:
            return self.turned(st)
        if System(s.strip, st).defect < 1e-12:
            return st
        for _ in range(3):
            st = s.settled(st)
            _, load = mesh(s, st, self.counts)
            self.counts = self.wanted(load)
            st = st.moved(s.strip, mesh(s, st, self.counts)[0], self.n)
        return s.settled(st)

    def turned(self, st):
        """The equilibrium at u = 0 of a grip that has been turned, by way of those that are turned by less."""
        s, c = self.s, self.s.strip
        shares = np.linspace(0.0, 1.0, 1 + math.ceil(2.0 * abs(c.turned)))
        for share in shares[1:]:
            s.strip = replace(c, turned=float(share) * c.turned)
            st = s.settled(st)
            X, load = mesh(s, st, self.counts)
            self.counts = self.wanted(load)
            st = s.settled(st.moved(c, mesh(s, st, self.counts)[0], self.n))
        s.strip = c
        return s.settled(st)

    def advance(self, ds):
        """The next point, the error of its prediction, and the step with which it was reached."""
        s = self.s
        tries = 0
        while True:
            tries += 1
            try:
                return *self.attempt(ds, tries), ds
            except (Failure, np.linalg.LinAlgError) as why:
                self.say(f"  retry ds={ds:.3g}: {why}")
                ds *= 0.4
                s.border = self.good
                if ds < 1e-8:
                    raise Failure(f"stuck at u={s.u(self.points[-1]):.6g}: {why}") from why

    def attempt(self, ds, tries):
        s = self.s
        last = self.hist[-1][1]
        use = self.hist[-(2 if len(self.points) < 6 else 3):]
        predicted = interpolated([q[1] for q in use], [q[0] for q in use], self.hist[-1][0] + ds)
        if tries > 2:                                                 # a sharp bend: along the tangent, on the last mesh
            predicted = self.euler(last, self.hist[-2][1], ds)
        elif np.diff(predicted.X).min() <= 0.2 * np.diff(last.X).min():
            raise Failure("the mesh folds")
        pin(s, predicted.X, self.counts)
        new = s.correct(predicted)
        err = s.error(predicted, new)
        if err > 5.0 * self.goal or s.used > (9 if s.pole else 6):
            raise Failure("prediction too coarse")
        if s.distance(predicted, new) > 0.35 * s.distance(last, new):  # also keeps the path from turning on its heel
            raise Failure("off the direction of the path")
        return new, err

    def euler(self, st, before, ds):
        """A step of length ds along the tangent at st, away from `before`."""
        s = self.s
        st = s.correct(st)
        sc = s.scale(len(st.X) - 1)
        old = State(st.X, before.at(st.X), before.K, before.H).flat()
        sy = System(s.strip, st)
        _, T = sy.solve(s.border / sc, 0.0)
        if (T / sc) @ ((st.flat() - old) / sc) < 0:
            T = -T
        sy.sol[..., 0] = 0.0
        there = sy.apply(st, T)
        return sy.apply(st, T * (ds / s.distance(st, State(st.X, there.zn, there.K, there.H))))

    def accept(self, got):
        """Appends a point, on a mesh of its own to predict from; more or fewer sub-intervals where it asks for them."""
        s = self.s
        self.good = s.border
        X, load = mesh(s, got, self.counts)
        new = got.moved(s.strip, X, self.n)
        self.points.append(new)
        step = s.distance(self.hist[-1][1], new)
        self.hist = self.hist[-3:] + [(self.hist[-1][0] + step, new)]
        self.labels.append(self.hist[-1][0])
        wanted = self.wanted(load)
        if (wanted != self.counts).any():
            self.counts = wanted
            self.hist = [(q, st.moved(s.strip, mesh(s, st, wanted)[0], self.n)) for q, st in self.hist]
            way = (self.hist[-1][1].flat() - self.hist[-2][1].flat()) / s.scale(wanted.sum())
            s.border = self.good = way / np.linalg.norm(way)
        return step

    def wanted(self, load):
        """Sub-intervals on each piece for the load that a mesh has there."""
        now = self.counts
        change = (load > 1.7 * now) | ((now > self.least) & (load < 0.8 * now))
        return np.where(change, np.maximum(self.least, (load / 1.3).astype(int)), now)

    def look_for_turn(self):
        """A turn seen in three successive points counts only once the point itself has been found on the fine mesh."""
        s = self.s
        keep = s.border
        for kind, what, gap in self.seen():
            value = s.P if what == "P" else s.u
            try:
                at = locate(s, self.hist[-2][1], what, *self.fine)
                off = (value(at) - value(self.points[-2])) * (-1.0 if kind == "lp2" else 1.0)
                if -1e-4 * gap - 1e-7 <= off <= gap:                  # a maximum lies above the points around it, and not far
                    self.found[kind] = at
                    if kind == "peak" and "lp1" not in self.found:
                        self.found["top"] = at
                else:
                    self.say(f"  {kind} rejected: off by {off:.3g}, points apart {gap:.3g}")
            except (Failure, np.linalg.LinAlgError) as why:
                self.say(f"  no {kind} here: {why}")
            s.border = keep

    def seen(self):
        """The turns that the last three points show: their kind, what turns, how far the points are apart in that."""
        s = self.s
        u0, u1, u2 = (s.u(p) for p in self.points[-3:])
        P0, P1, P2 = (s.P(p) for p in self.points[-3:])
        if P1 > P0 and P1 >= P2:
            if "peak" not in self.found:
                yield "peak", "P", max(P1 - P0, P1 - P2)
            elif "lp1" not in self.found and P1 > s.P(self.found["top"]):
                yield "top", "P", max(P1 - P0, P1 - P2)
        if "lp1" not in self.found and u1 > u0 and u1 >= u2:
            yield "lp1", "u", max(u1 - u0, u1 - u2)
        elif "lp1" in self.found and "lp2" not in self.found and u1 < u0 and u1 <= u2:
            yield "lp2", "u", max(u0 - u1, u2 - u1)

#!/usr/bin/env python3
"""Strips that rub on the substrate. Writes friction.csv (initiation peaks), friction_steady.csv and friction_cycle.csv.

The law is that of collocation/friction.py: a traction t on the bottom face against x_b = x + (h/2) sin theta,
    H' = b t,   M' = -x' V + y' H + b dPsi/dtheta + b t (h/2) cos theta,
    t = s tau(d),   ds = (1 -+ s) dx_b/delta,   s = 0 at rest,   d = y - (h/2) cos theta.
The left end is free, H = V = M = 0, and x(0) is an unknown; V, the kinematics and the grip are those of pull_angle.py. Unknowns are
g = y - h/2, theta, V, M, x - S and H.

While no point has turned back, t = sign(e) tau (1 - exp(-|e|/delta)) with e = x_b - S, and no step has an error. Whether one has is looked
at in every point of a path and at the peak, on 8001 places. Where one has, x_b and s behind each step are kept as polynomials on
sub-intervals, and a point turns back where a step ends: an error of the order of the square of the steps, which halved steps take away.
Nodes lie where formulas change: where a point has not moved, and where earlier such places have left a kink in s. Turns are where
the tangent has no component, on meshes that resolve the solution on either side.

Steady peeling: with the first integral I = H x' + V y' + M theta' - stored - b Psi,  I' = b t x_b',  so that from the rest ahead to the arm
    P (1 - cos) + P^2/2EA = w b + D',   D' = b int t (x_b' - 1) dS,
and D' is int b t dx_b, what friction takes for a unit of length that peels, once that is steady.

Cycle: a bar on such an interface has EA e'' = b tau0 s, e = x - S. Pulled from rest, e' = 0 far ahead, EA e'^2/2 = b tau0 (e - delta (1 - exp(-e/delta))):
    P = (2 EA b tau0 (u - delta (1 - exp(-u/delta))))^(1/2).
Back and again every point turns with the grip, s = +-1 - (+-1 - s0) exp(-|e - e0|/delta), and scipy's solve_bvp solves it.
"""
import argparse
import csv
import math
import sys
import time
from dataclasses import replace

from collocation import selfcheck  # first: one thread
import numpy as np
from scipy.integrate import solve_bvp, solve_ivp
from scipy.optimize import brentq

import tables
from collocation.digits import LEVELS, good, off, printed
from collocation.energy import adhesion
from collocation.friction import Friction
from collocation.law import Strip, _near, field, potential
from collocation.mesh import rest_state
from collocation.slip import FINE, Walk, along, committed, grip, settled
from collocation.solver import Solver
from collocation.suite import DEFINING, Suite
from collocation.system import Rule, System

REMARKS = (
    "Strips that rub on the substrate, computed without finite elements by verification/friction.py: u and P along the pull, the rest as in strip_variants.csv.",
    "tau0 (GPa), friction_coefficient: those of Dahl's law in collocation/friction.py, with delta = tau0/(7.5625 GPa/nm). pull_angle_deg, grip_across as in pull_angle.csv.",
    "tail_displacement: x(0) at the peak. At 0 degrees there is no peak: the force to which P tends while the whole strip slides. lp1: the first displacement limit point before",
    "P has fallen to half of the peak, if any; where a point in contact has turned back before, it is looked for in rows 1 and 6 alone (to a twentieth and a fifth of the peak).",
    "one_way_until: u of the first path point (so to a digit or two) at which a point in contact has turned back by more than 1e-9 nm; what lies behind is computed with history,",
    "two step lengths extrapolated. Empty: none up to the last number of the row.",
    "Every other number is good to the digits printed; digits_relative: the fewest of a row.",
)
STEADY_REMARKS = (
    "Steady peeling with friction, by verification/friction.py, with history: a strip of length_nm pulled at pull_angle_deg, grip free, its front (d = d_max) rest_nm from the free end.",
    "force: P there; error_nN: the larger of its difference from P with twice as long steps, and from P where the front was 20 nm farther. one_way: P there by the one-way form, which",
    "does not hold. dissipation: D' = b int t (x_b' - 1) dS, nN; rubbed: b int int t dx_b by the steps of the path, per length of advance. no_slip and frictionless: the roots of",
    "P (1 - cos) + P^2/2EA = w b and of P (1 - cos) + P^2 sin^2/2EA = w b. balance: P (1 - cos) + P^2/2EA - w b - D', nN.",
)
CYCLE_REMARKS = (
    "Pulled along the substrate to u1, back to u = 0 and to u1 again, by verification/friction.py, with history: L = 40 nm, E h = 10 nN/nm, tau0/delta = 7.5625 GPa/nm, no far face.",
    "steps: of each of the three ways; forces at their ends. flat_: of a bar that does not bend; flat_u1 in closed form.",
)
F = Friction
D = Strip(friction=F(tau0=0.05))
CASES = [
    D, replace(D, friction=F(tau0=0.2)), replace(D, friction=F(tau0=0.05, mu=0.3)),
    *(replace(D, angle=a) for a in (60.0, 45.0, 30.0, 20.0, 10.0)),
    *(replace(D, angle=30.0, friction=f) for f in (F(tau0=0.01), F(tau0=0.02), F(tau0=0.2), F(tau0=0.05, mu=0.3))),
    *(replace(D, angle=a) for a in (120.0, 150.0)),
    replace(D, horizontal="fixed"), replace(D, horizontal="fixed", rotation="fixed"), replace(D, rotation="fixed"),
    replace(D, angle=30.0, horizontal="fixed"),
    replace(D, length=200.0, angle=30.0), replace(D, length=200.0, angle=0.0), replace(D, angle=0.0),
    replace(D, angle=0.0, friction=F(tau0=0.05, mu=0.3)),
]
QUICK = [CASES[i] for i in (7, 20)]
CARRIED = (CASES[0], CASES[5])                                        # whose lp1 is looked for with history
VALUES = ("peak_displacement_nm", "peak_force_nN", "tail_displacement_nm", "lp1_displacement_nm", "lp1_force_nN")
COLUMNS = ("length_nm", "pull_angle_deg", "grip_rotation", "grip_across", "tau0_GPa", "friction_coefficient", *VALUES, "one_way_until_nm")
RUBS = {"tau0_GPa": "tau0", "friction_coefficient": "mu"}
STEPS = tuple(0.03 / 8 ** k for k in range(5))                                   # errors of a prediction, for steps half as long each
STEADY = [replace(D, length=220.0, angle=30.0, friction=F(tau0=t)) for t in (0.05, 0.5)]
CYCLES = [(replace(D, length=40.0, height=h, young=10.0 / h, angle=0.0, far_face=False), 0.5, steps)
          for h, steps in ((0.5, 16), (0.5, 64), (0.5, 128), (0.25, 64))]


def least(strip):
    """Down to what share of the peak lp1 is looked for."""
    return 0.05 if strip == CASES[0] else 0.2 if strip == CASES[5] else 0.5


def peak_of(path):
    st = path.found["peak"]
    return dict(zip(VALUES[:3], (path.s.u(st), path.s.P(st), float(st.zn[0, 4]))))


def lp1_of(path):
    st = path.found["lp1"]
    return dict(zip(VALUES[3:], (path.s.u(st), path.s.P(st))))


def sliding(path, fine):
    """The force while the whole strip slides."""
    s, st = path.s, path.points[-1]
    up = grip(s, "u")
    st, _ = settled(s, st, up, up @ st.zn[-1], *fine)
    return {"peak_force_nN": s.P(st)}


def extrapolated(rough, fine):
    """Errors go with the square of the steps; these are half as long in `fine`. Numbers, and how far they are from the finer: eight digits at
    best, as that may be chance."""
    return {k: (fine[k] + (fine[k] - rough[k]) / 3.0, max(3e-9, abs(fine[k] - rough[k]) / 3.0 / abs(fine[k]))) for k in fine}


def converged(compute, goals):
    """Steps halved until the extrapolated numbers have six digits, or to the last."""
    rough, out = compute(goals[0]), {}
    for goal in goals[1:]:
        fine = compute(goal)
        out, rough = extrapolated(rough, fine), fine
        if all(good(difference) >= 6 for _, difference in out.values()):
            break
    return out


def numbers(strip, levels, verbose=False):
    """{column: (number, relative error or how far levels differ)} of a row, and its one_way_until."""
    far = 60.0 * strip.friction.delta(strip)
    both = ("peak", "lp1")
    walks = [Walk(strip, fine=level["fine"], rough=(level["N"], level["n"], 1e-6), goal=2.0 * level["goal"], want=both, least=least(strip),
                  stop=lambda s, st: strip.angle == 0.0 and st.zn[0, 4] > far, verbose=verbose) for level in levels]
    path = walks[-1]
    if strip.angle == 0.0:
        a, b = sliding(walks[0], levels[0]["fine"]), sliding(path, levels[-1]["fine"])
        return {k: (b[k], abs(a[k] / b[k] - 1.0)) for k in b}, path.turned
    carried = lambda goal, want: Walk(strip, goal=goal, want=want, history=True, most=3000, least=least(strip), verbose=verbose)
    out, until = {}, None
    for kind, of, want, goals in (("peak", peak_of, both[:1], STEPS[1:]), ("lp1", lp1_of, both, STEPS[:3])):
        if path.one_way.get(kind):
            a, b = of(walks[0]), of(path)
            out |= {k: (b[k], abs(a[k] / b[k] - 1.0)) for k in b}
            continue
        if path.end != "turns back" or kind == "lp1" and strip not in CARRIED:
            continue
        first = carried(goals[0], want)
        if kind in first.found:
            out |= converged(lambda goal: of(first if goal == goals[0] else carried(goal, want)), goals)
            until = until or min(path.turned or np.inf, path.s.u(path.found["peak"]) if kind == "peak" else first.turned)
    return out, until


class Rubbing(Suite):
    """A suite whose strips have friction."""

    def row(self, strip, verbose):
        found, until = numbers(strip, LEVELS, verbose)
        row = {}
        for column in self.columns:
            value = getattr(strip, self.defining[column]) if column in self.defining else None
            row[column] = repr(value).removesuffix(".0") if isinstance(value, float) else value
            if column in found:
                row[column] = printed(*found[column])
        for column, name in RUBS.items():
            row[column] = repr(getattr(strip.friction, name)).removesuffix(".0")
        row["one_way_until_nm"] = None if until is None else f"{until:.2g}"
        row["digits_relative"] = min(good(difference) for _, difference in found.values())
        return row, []

    def mismatches(self, strip, row, verbose):
        now, until = numbers(strip, LEVELS[1:], verbose)
        for column in VALUES:
            if (column in now) != bool(row[column]):
                yield f"{column}: {row[column] or 'nothing'} in the table, {now.get(column)} now"
            elif column in now and (difference := off(row[column], now[column][0])) is not None:
                yield f"{column}: {row[column]} in the table, {now[column][0]!r} now, differs by {difference:.1e}"
        if (until is None) != (not row["one_way_until_nm"]):
            yield f"one_way_until_nm: {row['one_way_until_nm'] or 'nothing'} in the table, {until} now"

    def strip_of(self, row):
        return replace(super().strip_of(row), friction=Friction(**{name: float(row[column]) for column, name in RUBS.items()}))


def front(s, st):
    """Where d = d_max, nearest to the free end; None where it is nowhere."""
    c = s.strip
    wide = lambda S: c.friction.face(c.at(S), st.at(S))[1] - c.friction.farthest(c)
    at = wide(st.X)
    i = np.flatnonzero((at[:-1] < 0.0) & (at[1:] >= 0.0))
    return brentq(lambda x: float(wide(np.array([x]))[0]), st.X[i[0]], st.X[i[0] + 1]) if len(i) else None


def steady(c, rest=40.0, before=20.0):
    """A row of friction_steady.csv."""
    place = lambda s, st: front(s, st) or c.length
    ends = []
    for goal, history in ((STEPS[0], True), (STEPS[1], True), (STEPS[0], False)):
        path = Walk(c, want=("never",), most=3000, goal=goal, history=history, stop=lambda s, st: place(s, st) < rest)
        s = path.s
        if path.end != "stopped":
            raise ArithmeticError(f"{c}: {path.end}")
        fronts = np.array([place(s, st) for st in path.points])
        P = lambda at: float(np.interp(-at, -fronts, [s.P(st) for st in path.points]))
        ends.append((path, fronts, P(rest), P(rest + before)))
    path, fronts, P, old = ends[1]
    s, st = path.s, path.points[-1]
    z = st.inner()
    here = s.strip.at(st.points())
    f = field(here, z, 0.0, jac=False)
    t = c.friction.traction(here, z, _near)[0]
    D = c.width * float(np.diff(st.X) @ ((t * (f[..., 4] + 0.5 * c.height * np.cos(z[..., 1]) * f[..., 1])) @ Rule(st.n).w))
    i = int(np.flatnonzero(fronts > rest + before)[-1])
    rubbed = (path.rubbed[-1] - path.rubbed[i]) / (fronts[i] - fronts[-1])
    cos, sin = c.pull
    w, P_now = adhesion(s), s.P(st)
    root = lambda part: brentq(lambda P: P * (1.0 - cos) + P * P * part / (2.0 * c.EA) - w, 0.0, 10.0, xtol=1e-15)
    return {"length_nm": c.length, "pull_angle_deg": c.angle, "tau0_GPa": c.friction.tau0, "rest_nm": rest, "force_nN": f"{P:.5f}",
            "error_nN": f"{max(abs(P - ends[0][2]), abs(P - old)):.1e}", "one_way_nN": f"{ends[2][2]:.5f}", "dissipation_nN": f"{D:.5f}", "rubbed_nN": f"{rubbed:.4f}",
            "no_slip_nN": f"{root(1.0):.9f}", "frictionless_nN": f"{root(sin * sin):.9f}", "balance_nN": f"{P_now * (1.0 - cos) + P_now * P_now / (2.0 * c.EA) - w - D:.0e}"}


def flat(c, top):
    """Forces of a bar that does not bend, at u = top, 0 and top again: EA e'' = b tau0 s. Every point turns back when the grip does."""
    delta, tau, EA, L = c.friction.delta(c), c.friction.tau0 * c.width, c.EA, c.length
    S = np.linspace(0.0, L, 2001)
    x, share, out = (lambda S: 0.0 * S), (lambda S: 0.0 * S), []
    guess = np.array([top * np.exp((S - L) / 5.0), top / 5.0 * np.exp((S - L) / 5.0)])
    for sense, end in ((1.0, top), (-1.0, 0.0), (1.0, top)):
        left = lambda S, e, x=x, share=share, sense=sense: (sense - share(S)) * np.exp(np.minimum(-sense * (e - x(S)) / delta, 3.0))
        found = solve_bvp(lambda S, z: np.array([z[1], tau / EA * (sense - left(S, z[0]))]), lambda a, b: np.array([a[1], b[0] - end]), S, guess,
                          tol=1e-9, max_nodes=200000)
        if found.status:
            raise ArithmeticError(found.message)
        out.append(EA * float(found.y[1, -1]))
        x, share = (lambda S, f=found: f.sol(S)[0]), (lambda S, f=found, l=left, sense=sense: sense - l(S, f.sol(S)[0]))
        guess = found.sol(S)
    return out


def cycle(c, top, steps, level=(30, 12, 1e-8)):
    """Forces at u = top, 0 and top again."""
    s = Solver(c)
    st = rest_state(s, [32], level[1])
    up = grip(s, "u")
    rest = up @ st.zn[-1]
    out, u = [], 0.0
    for goal in (top, 0.0, top):
        begin = u
        for j in range(1, steps + 1):
            u = begin + (goal - begin) * j / steps
            st, _ = settled(s, st, up, rest + u, *level)
            s.strip = committed(c, s, st)
        out.append(s.P(st))
    return out


def cycle_row(c, top, steps):
    a = cycle(c, top, steps)
    b = flat(c, top)
    delta = c.friction.delta(c)
    closed = math.sqrt(2.0 * c.EA * c.friction.tau0 * c.width * (top + delta * math.expm1(-top / delta)))
    return {"height_nm": c.height, "tau0_GPa": c.friction.tau0, "u1_nm": top, "steps": steps,
            **{name: f"{q:.10g}" for name, q in zip(("force_u1_nN", "force_back_nN", "force_again_nN"), a)},
            "flat_u1_nN": f"{closed:.10g}", "flat_back_nN": f"{b[1]:.8g}", "flat_again_nN": f"{b[2]:.8g}"}


TINY = 1e-30


def slope(c):
    """z' from the equations as they stand at the head of this file, the gradient of Psi by complex steps."""
    K, h, b, f = c.hamaker * 1e18 / (2.0 * math.pi * c.r0 ** 2), c.height, c.width, c.friction
    W = lambda r: K * ((c.r0 / r) ** 8 / 360.0 - (c.r0 / r) ** 2 / 6.0)
    T = lambda r: K / c.r0 * ((c.r0 / r) ** 9 / 45.0 - (c.r0 / r) ** 3 / 3.0)
    psi = lambda y, th: (W(y - 0.5 * h * np.cos(th)) - W(y + 0.5 * h * np.cos(th))) / np.cos(th)
    EA, EI, GA = c.young * h * b, c.young * h ** 3 / 12.0 * b, c.shear_correction * c.young / (2.0 * (1.0 + c.poisson)) * h * b
    near, far = c.r0 * 15.0 ** (-1 / 6), c.r0 * 5.0 ** (-1 / 6)
    delta = -f.tau0 * TINY / np.imag(T(near + 1j * TINY))
    onset = min(-0.1 * T(far), f.tau0 / f.mu)

    def of(S, z):
        g, th, V, M, w, H = z
        y, co, si = g + 0.5 * h, np.cos(th), np.sin(th)
        d, e = y - 0.5 * h * co, w + 0.5 * h * si
        q = lambda p: 0.5 * (p + math.hypot(p, onset))
        tau = (f.tau0 + f.mu * (q(T(d)) - q(0.0))) * 82.0 / 81.0 / (1.0 + (d / far) ** 24)
        t = math.copysign(tau * (1.0 - math.exp(-abs(e) / delta)), e)
        N, Q = H * co + V * si, V * co - H * si
        x1, y1 = (1.0 + N / EA) * co - Q / GA * si, (1.0 + N / EA) * si + Q / GA * co
        py, pt = np.imag(psi(y + 1j * TINY, th)) / TINY, np.imag(psi(y, th + 1j * TINY)) / TINY
        return [y1, M / EI, b * py, -x1 * V + y1 * H + b * pt + b * t * 0.5 * h * co, x1 - 1.0, b * t]

    return of


def check_again(c=replace(D, angle=30.0, friction=F(tau0=0.05, mu=0.3))):
    """A peak integrated again in short pieces by a Runge-Kutta code, with right sides of their own."""
    path = Walk(c)
    st = path.found["peak"]
    S = np.concatenate([np.linspace(p, q, 2 + int((q - p) / path.s.ell))[:-1] for p, q in zip(st.X[:-1], st.X[1:])] + [st.X[-1:]])
    zs = st.at(S)
    zs[-1] = st.zn[-1]
    worst = 0.0
    for i in range(len(S) - 1):
        end = solve_ivp(slope(c), S[i:i + 2], zs[i], method="DOP853", rtol=3e-14, atol=1e-15).y[:, -1]
        worst = max(worst, float((np.abs(end - zs[i + 1]) / np.maximum(np.ptp(zs, axis=0), 1e-9)).max()))
    print(f"peak of {c}, mu = {c.friction.mu:g}: integrated again in {len(S) - 1} pieces, worst difference {worst:.1e} of the range of a component")
    return worst < 1e-10


def stored(s, st):
    """Elastic and adhesion energy."""
    c, z = s.strip, st.inner()
    g, th, V, M, _, H = (z[..., i] for i in range(6))
    N, Q = H * np.cos(th) + V * np.sin(th), V * np.cos(th) - H * np.sin(th)
    density = 0.5 * N ** 2 / c.EA + 0.5 * Q ** 2 / c.GA + 0.5 * M ** 2 / c.EI + c.width * potential(c, g, th)[0]
    return float(np.diff(st.X) @ (density @ Rule(st.n).w))


def rubbed(s, st, way):
    """b int t dx_b, per way . z."""
    sy = System(s.strip, st)
    _, T = sy.solve(along(s, way, len(st.X) - 1), 0.0)
    sy.sol[..., 0] = 0.0
    z = st.inner()
    dz = sy.apply(st, T).inner() - z
    t = s.strip.friction.traction(s.strip, z, _near)[0]
    return s.strip.width * float(np.diff(st.X) @ ((t * (dz[..., 4] + 0.5 * s.strip.height * np.cos(z[..., 1]) * dz[..., 1])) @ Rule(st.n).w))


def check_work(c=replace(D, angle=45.0), a=0.15, b=0.3, nodes=8):
    """Work of the grip between two displacements against the change of energy and what the friction takes."""
    path = Walk(c, want=("never",), stop=lambda s, st: s.u(st) > a)
    s, st = path.s, path.points[-1]
    up = grip(s, "u")
    rest = up @ path.points[0].zn[-1]
    st, _ = settled(s, st, up, rest + a, *FINE[0])
    first, done, taken = stored(s, st), 0.0, 0.0
    for x, w in zip(*np.polynomial.legendre.leggauss(nodes)):
        st, _ = settled(s, st, up, rest + 0.5 * (a + b) + 0.5 * (b - a) * x, *FINE[0])
        done += 0.5 * (b - a) * w * s.P(st)
        taken += 0.5 * (b - a) * w * rubbed(s, st, up)
    st, _ = settled(s, st, up, rest + b, *FINE[0])
    changed = stored(s, st) - first
    print(f"work of the grip from u = {a} to {b} nm, {c.angle:g} degrees: {done:.10g} aJ, energy {changed:.10g} and friction {taken:.10g}, "
          f"differs by {abs(1.0 - (changed + taken) / done):.1e}")
    return abs(1.0 - (changed + taken) / done) < 1e-7


def check_history(c=replace(D, angle=30.0)):
    """A peak with history against the one-way form, where no point turns back."""
    plain, carried = Walk(c), Walk(c, history=True)
    a, b = (p.s.P(p.found["peak"]) for p in (plain, carried))
    print(f"peak of {c}: {a:.12g} nN, with history in {len(carried.points)} steps {b:.12g}, differs by {abs(b / a - 1.0):.1e}")
    return abs(b / a - 1.0) < 1e-9


def differences(name, rows):
    """What differs between rows and a committed table, a line each; errors and balances are not compared."""
    for old, new in zip(tables.read(name), rows):
        for column, value in new.items():
            if column.startswith(("error", "balance")):
                continue
            tolerance = 3e-8 if name == "friction_steady.csv" else 1e-9
            wrong = off(old[column], float(value), tolerance)
            if wrong is not None:
                yield f"{name}: {column}: {old[column]} in the table, {value} now, differs by {wrong:.1e}"


def main():
    ap = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    ap.add_argument("--check", action="store_true", help="recompute and compare with the committed tables; exit 1 where a row does not agree")
    ap.add_argument("--quick", action="store_true", help="with --check: a few rows")
    ap.add_argument("--table", choices=("peaks", "steady", "cycle"), help="this one only")
    ap.add_argument("--verbose", action="store_true", help="print every point of every path of friction.csv")
    a = ap.parse_args()
    started, wrong = time.time(), 0
    suite = Rubbing("friction.csv", REMARKS, CASES, COLUMNS, None, QUICK, DEFINING | {"pull_angle_deg": "angle", "grip_across": "horizontal"}, paper=Strip())
    if a.table is None:
        wrong += sum(not check() for check in ((check_again,) if a.quick else (check_again, check_work, check_history)))
    if a.table in (None, "peaks"):
        if a.check:
            wrong += suite.check(suite.table, "", a.quick, a.verbose)
        else:
            suite.write(a.verbose)
    few = a.check and a.quick
    for which, name, remarks, row, cases in (("cycle", "friction_cycle.csv", CYCLE_REMARKS, lambda c: cycle_row(*c), CYCLES[:1] if few else CYCLES),
                                             ("steady", "friction_steady.csv", STEADY_REMARKS, steady, [] if few else STEADY)):
        if a.table not in (None, which) or not cases:
            continue
        rows = [row(case) for case in cases]
        if a.check:
            found = list(differences(name, rows))
            wrong += len(found)
            print(*found, sep="\n", end="\n" if found else "")
            print(f"{name}: {len(rows)} rows recomputed, {len(found)} differences", flush=True)
        else:
            tables.write(name, remarks, rows)
            print(f"wrote verification/{name}: {len(rows)} rows", flush=True)
    print(f"{time.time() - started:.0f} s, {'all checks passed' if not wrong else f'{wrong} CHECKS FAILED'}")
    sys.exit(int(wrong > 0))


if __name__ == "__main__":
    main()

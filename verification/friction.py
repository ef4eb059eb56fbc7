#!/usr/bin/env python3
"""Strips that rub on the substrate. Writes friction.csv (initiation peaks), friction_steady.csv and friction_cycle.csv.

The law is that of collocation/friction.py: a traction t on the bottom face against x_b = x + (h/2) sin theta,
    H' = b t,   M' = -x' V + y' H + b dPsi/dtheta + b t (h/2) cos theta,
    |t| <= tau(d),   t = k e below,   e = x_b - a,   d = y - (h/2) cos theta,
the anchor a = S at rest and drawn along where t = tau. The left end is free, H = V = M = 0, and x(0) is an unknown; V, the kinematics and
the grip are those of pull_angle.py. Unknowns are g = y - h/2, theta, V, M, x - S and H.

While no point that has slid turns back in contact, a = S all the time and t = sign(e) min(k |e|, tau): friction.csv and friction_steady.csv
are of such paths. Whether they are is looked at in every point of a path on 8001 places; the displacement at which it first happens
is the column one_way_until. friction_cycle.csv is computed with anchors: after each step they are a polynomial on every sub-interval.
Formulas change at places that move (where stick meets slip, where d passes d_eq and d_c): nodes of the mesh are laid there, again and
again until nothing changes. Turns are where the tangent has no component, on meshes that resolve the solution on either side.

Steady peeling: with the first integral I = H x' + V y' + M theta' - stored - b Psi,  I' = b t x_b',  so that from the rest ahead to the arm
    P (1 - cos) + P^2/2EA = w b + D',   D' = b int t (x_b' - 1) dS,
and D' is int t da, what friction takes for a unit of length that peels.

Cycle: a flat strip on an elastic-perfectly plastic interface has, with lambda^2 = k b/EA and the slip length s,
    u = d + H s/EA + tau0 b s^2/2EA,   P = H + tau0 b s,   H = EA lambda d tanh(lambda (L - s)),   d = tau0/k     (loading curve P = f(u)),
and P = f(u1) - 2 f((u1 - u)/2) on the way back (Masing). For k to infinity f = (2 EA tau0 b u)^(1/2), so that P(0) = (1 - 2^(1/2)) f(u1).
"""
import argparse
import csv
import math
import sys
import time
from dataclasses import replace

from collocation import selfcheck  # first: one thread
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import tables
from collocation.digits import LEVELS, off, printed
from collocation.energy import adhesion
from collocation.friction import Friction
from collocation.law import Strip, _near, field, potential
from collocation.mesh import rest_state
from collocation.slip import FINE, Anchors, Walk, along, anchored, boundaries, boundary, grip, settled
from collocation.solver import Solver
from collocation.suite import DEFINING, Suite
from collocation.system import Rule, System

REMARKS = (
    "Strips that rub on the substrate, computed without finite elements by verification/friction.py: u and P along the pull, the rest as in strip_variants.csv.",
    "tau0 (GPa), friction_coefficient: tau = tau0 w(d) + mu q(p(d)) of collocation/friction.py, with k = -T'(d_eq) = 7.5625 GPa/nm. pull_angle_deg, grip_across as in",
    "pull_angle.csv. tail_displacement: x(0) at the peak; slip_boundary: where stick meets slip there, farthest from the grip; 0: the whole strip slides, and the peak is",
    "where its last point begins to. lp1: the first displacement limit point before P has fallen to half of the peak (at 90 degrees, free: to a twentieth), if any.",
    "one_way_until: u of the first path point (so to three digits at best) at which a point in contact has slid back by more than 1e-8 nm: the path is left there, behind",
    "the last number of the row; empty: none up to where P had fallen. Every other number is good to the digits printed; digits_relative: the fewest of a row.",
)
STEADY_REMARKS = (
    "Steady peeling with friction, by verification/friction.py: a strip of length_nm pulled at pull_angle_deg, grip free, its front 30 nm and a tenth of the length from the free end.",
    "force: P there; error_nN: its difference from P where the front was 60 nm farther. dissipation: D' = int t da per length of advance, nN. no_slip and frictionless: the roots of",
    "P (1 - cos) + P^2/2EA = w b and of P (1 - cos) + P^2 sin^2/2EA = w b. balance: P (1 - cos) + P^2/2EA - w b - D', nN. slip_nm: how far slip reaches ahead of where d = d_c.",
)
CYCLE_REMARKS = (
    "Pulled along the substrate to u1, back to u = 0 and to u1 again, by verification/friction.py, with anchors: L = 40 nm, E h = 10 nN/nm, k = 7.5625 GPa/nm, no far face.",
    "steps: of each of the three ways; forces at their ends. flat_: the elastic-perfectly plastic shear lag, closed form; rigid_: the same for k to infinity.",
)
F = Friction
D = Strip(friction=F(tau0=0.05))
CASES = [
    D, replace(D, friction=F(tau0=0.2)), replace(D, friction=F(tau0=0.05, mu=0.3)),
    *(replace(D, angle=a) for a in (60.0, 45.0, 30.0, 20.0, 10.0)),
    *(replace(D, angle=30.0, friction=f) for f in (F(tau0=0.01), F(tau0=0.02), F(tau0=0.2), F(tau0=0.05, mu=0.3))),
    replace(D, horizontal="fixed"), replace(D, horizontal="fixed", rotation="fixed"), replace(D, rotation="fixed"),
    replace(D, angle=30.0, horizontal="fixed"),
    replace(D, length=200.0, angle=30.0), replace(D, length=200.0, angle=0.0), replace(D, angle=0.0),
    replace(D, angle=0.0, friction=F(tau0=0.05, mu=0.3)),
]
QUICK = [CASES[i] for i in (3, 10, 12)]
VALUES = ("peak_displacement_nm", "peak_force_nN", "tail_displacement_nm", "slip_boundary_nm", "lp1_displacement_nm", "lp1_force_nN")
COLUMNS = ("length_nm", "pull_angle_deg", "grip_rotation", "grip_across", "tau0_GPa", "friction_coefficient", *VALUES, "one_way_until_nm")
RUBS = {"tau0_GPa": "tau0", "friction_coefficient": "mu"}
STEADY = [replace(D, length=300.0, angle=a, friction=F(tau0=t)) for a, t in ((30.0, 0.05), (30.0, 0.5), (90.0, 0.05))]
CYCLES = [(replace(D, length=40.0, height=h, young=10.0 / h, angle=0.0, far_face=False), 0.5, steps) for h, steps in ((0.5, 1), (0.5, 8), (0.25, 1), (0.1, 1))]


def compute(strip, level, verbose):
    """The numbers of one path; None where a thing does not occur."""
    least = 0.05 if strip.angle == 90.0 and strip.horizontal == "free" else 0.5
    path = Walk(strip, fine=level["fine"], rough=(level["N"], level["n"], 1e-6), goal=2.0 * level["goal"], verbose=verbose,
                want=("slide",) if strip.angle == 0.0 else ("slide", "peak", "lp1"), least=least, most=level.get("most", 400))
    out = dict.fromkeys(VALUES)
    s = path.s
    peak = path.found.get("peak", path.found.get("slide"))
    if peak is not None:
        out.update(peak_displacement_nm=s.u(peak), peak_force_nN=s.P(peak), tail_displacement_nm=float(peak.zn[0, 4]))
        at = boundary(s, peak)
        out["slip_boundary_nm"] = 0.0 if at is not None and at < 1e-6 else at
    if "lp1" in path.found:
        out["lp1_displacement_nm"], out["lp1_force_nN"] = s.u(path.found["lp1"]), s.P(path.found["lp1"])
    compute.back = path.turned
    return out


class Rubbing(Suite):
    """A suite whose strips have friction."""

    def row(self, strip, verbose):
        row, remarks = super().row(strip, verbose)
        for column, name in RUBS.items():
            row[column] = repr(getattr(strip.friction, name)).removesuffix(".0")
        row["one_way_until_nm"] = None if compute.back is None else f"{compute.back:.3g}"
        return row, remarks

    def mismatches(self, strip, row, verbose):
        self.values = VALUES
        return super().mismatches(strip, row, verbose)

    def strip_of(self, row):
        return replace(super().strip_of(row), friction=Friction(**{name: float(row[column]) for column, name in RUBS.items()}))


def front(s, st):
    """Where d = d_c, nearest to the free end; None where it is nowhere."""
    c = s.strip
    wide = lambda S: c.friction.corners(c.at(S), st.at(S), _near)[2]
    at = wide(st.X)
    i = np.flatnonzero((at[:-1] < 0.0) & (at[1:] >= 0.0))
    return brentq(lambda x: float(wide(np.array([x]))[0]), st.X[i[0]], st.X[i[0] + 1]) if len(i) else None


def steady(c):
    """A row of friction_steady.csv."""
    place = lambda s, st: (front(s, st) or c.length) - 30.0 - 0.1 * c.length
    path = Walk(c, want=("never",), most=2000, goal=0.03, stop=lambda s, st: place(s, st) < 0.0)
    s = path.s
    if path.end != "stopped":
        raise ArithmeticError(f"{c}: {path.end}")
    up = grip(s, "u")
    before = next(st for st in path.points if place(s, st) < 60.0)
    (old, _), (st, _) = (settled(s, st, up, up @ st.zn[-1], *FINE[0]) for st in (before, path.points[-1]))
    z = st.inner()
    f = field(c, z, 0.0, jac=False)
    t = c.friction.traction(c, z, _near)[0]
    D = c.width * float(np.diff(st.X) @ ((t * (f[..., 4] + 0.5 * c.height * np.cos(z[..., 1]) * f[..., 1])) @ Rule(st.n).w))
    cos, sin = c.pull
    w, P = adhesion(s), s.P(st)
    root = lambda part: brentq(lambda P: P * (1.0 - cos) + P * P * part / (2.0 * c.EA) - w, 0.0, 10.0, xtol=1e-15)
    return {"length_nm": c.length, "pull_angle_deg": c.angle, "tau0_GPa": c.friction.tau0, "force_nN": f"{P:.9f}", "error_nN": f"{abs(P - s.P(old)):.1e}",
            "dissipation_nN": f"{D:.9f}", "no_slip_nN": f"{root(1.0):.9f}", "frictionless_nN": f"{root(sin * sin):.9f}",
            "balance_nN": f"{P * (1.0 - cos) + P * P / (2.0 * c.EA) - w - D:.0e}", "slip_nm": f"{front(s, st) - boundary(s, st):.6f}"}


def loading(c):
    """f of a flat strip."""
    k, tau, EA, b = c.friction.k(c), c.friction.tau0, c.EA, c.width
    lam, d = math.sqrt(k * b / EA), tau / k
    ahead = lambda s: EA * lam * d * math.tanh(lam * (c.length - s))
    end = lambda s: d + ahead(s) * s / EA + tau * b * s * s / (2.0 * EA)

    def f(u):
        if u <= d:
            return EA * lam * math.tanh(lam * c.length) * u
        s = brentq(lambda s: end(s) - u, 0.0, c.length, xtol=1e-15)
        return ahead(s) + tau * b * s

    return f


def cycle(c, top, steps, level=FINE[0]):
    """Forces at u = top, 0 and top again."""
    s = Solver(c)
    st = rest_state(s, [32], level[1])
    up = grip(s, "u")
    rest = up @ st.zn[-1]
    anchors, out, u = None, [], 0.0
    for way, goal in enumerate((top, 0.0, top)):
        begin = u
        for j in range(1, steps + 1):
            to = begin + (goal - begin) * j / steps
            for share in (0.25, 0.5, 0.75, 1.0) if steps < 4 else (1.0,):
                st, _ = settled(s, st, up, rest + u + (to - u) * share, *level)
            u = to
            here = s.strip.at(st.points())
            moved = c.friction.slip(here, st.inner(), _near)[0] + here.slid
            anchors = Anchors(st.X, moved, tuple(sorted({*(anchors.breaks if anchors else ()), *boundaries(s, st)})))
            s.strip = anchored(c, anchors)
        out.append(s.P(st))
    return out


def cycle_row(c, top, steps):
    a, b = (cycle(c, top, steps, level) for level in FINE)
    f = loading(c)
    rigid = math.sqrt(2.0 * c.EA * c.friction.tau0 * c.width * top)
    row = {"height_nm": c.height, "tau0_GPa": c.friction.tau0, "u1_nm": top, "steps": steps}
    for name, p, q in zip(("force_u1_nN", "force_back_nN", "force_again_nN"), a, b):
        row[name] = printed(q, max(abs(p / q - 1.0), 1e-11))
    return row | {"flat_u1_nN": f"{f(top):.12g}", "flat_back_nN": f"{f(top) - 2.0 * f(0.5 * top):.12g}", "rigid_u1_nN": f"{rigid:.12g}",
                  "rigid_back_nN": f"{rigid * (1.0 - math.sqrt(2.0)):.12g}"}


TINY = 1e-30


def slope(c):
    """z' from the equations as they stand at the head of this file, the gradient of Psi by complex steps."""
    K, h, b, f = c.hamaker * 1e18 / (2.0 * math.pi * c.r0 ** 2), c.height, c.width, c.friction
    W = lambda r: K * ((c.r0 / r) ** 8 / 360.0 - (c.r0 / r) ** 2 / 6.0)
    T = lambda r: K / c.r0 * ((c.r0 / r) ** 9 / 45.0 - (c.r0 / r) ** 3 / 3.0)
    psi = lambda y, th: (W(y - 0.5 * h * np.cos(th)) - W(y + 0.5 * h * np.cos(th))) / np.cos(th)
    EA, EI, GA = c.young * h * b, c.young * h ** 3 / 12.0 * b, c.shear_correction * c.young / (2.0 * (1.0 + c.poisson)) * h * b
    near, far = c.r0 * 15.0 ** (-1 / 6), c.r0 * 5.0 ** (-1 / 6)
    k = -np.imag(T(near + 1j * TINY)) / TINY

    def of(S, z):
        g, th, V, M, w, H = z
        y, co, si = g + 0.5 * h, np.cos(th), np.sin(th)
        d, e = y - 0.5 * h * co, w + 0.5 * h * si
        s, p = min(max((d - near) / (far - near), 0.0), 1.0), max(T(d), 0.0)
        tau = f.tau0 * (1.0 - s ** 3 * (10.0 - 15.0 * s + 6.0 * s * s)) + f.mu * p ** 3 / (p * p + (0.1 * T(far)) ** 2)
        t = math.copysign(min(k * abs(e), tau), e)
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
    """A peak with anchors that come along after every step against the one with a = S."""
    plain, carried = Walk(c), Walk(c, history=True)
    a, b = (p.s.P(p.found["peak"]) for p in (plain, carried))
    print(f"peak of {c}: {a:.12g} nN, with anchors in {len(carried.points)} steps {b:.12g}, differs by {abs(b / a - 1.0):.1e}")
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
    suite = Rubbing("friction.csv", REMARKS, CASES, COLUMNS, compute, QUICK, DEFINING | {"pull_angle_deg": "angle", "grip_across": "horizontal"}, paper=Strip())
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

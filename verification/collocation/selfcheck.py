"""The equations against their potential and its numerical derivatives, a solution against what it must satisfy."""
import math
from dataclasses import replace

import mpmath as mp
import numpy as np
from scipy.integrate import solve_ivp

from .digits import LEVELS
from .energy import adhesion, energy, first_integral, work
from .law import Strip, field, potential
from .path import Path
from .shapes import Spatula

PAPER = Strip()


def check_law():
    """Psi and its derivatives against mpmath, from contact to far away, flat to upright."""
    mp.mp.dps = 50
    rng = np.random.default_rng(1)
    worst = 0.0
    for c in (PAPER, replace(PAPER, far_face=False), replace(PAPER, line_load="axis-gap"), replace(PAPER, height=20.0, r0=0.2)):
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
    mp.mp.dps = 40
    rng = np.random.default_rng(2)
    worst = 0.0
    varying = [Spatula(tip_rounding_length=40.0).at(S) for S in (30.0, 270.0, 330.0)]
    for c in (PAPER, replace(PAPER, width=3.0, poisson=0.4), replace(PAPER, line_load="axis-gap", horizontal="fixed"), *varying):
        EA, GA = mp.mpf(c.EA), mp.mpf(c.GA)

        def stored(xp, yp, th):
            G1 = xp * mp.cos(th) + yp * mp.sin(th) - 1
            G2 = yp * mp.cos(th) - xp * mp.sin(th)
            return EA * G1 ** 2 / 2 + GA * G2 ** 2 / 2

        for _ in range(20):
            z = np.array([rng.uniform(0.24, 5.0), rng.uniform(-1.5, 1.5), rng.normal(), rng.normal(), 0.0])
            H = float(rng.normal())
            f = field(c, z, H, jac=False)
            at = tuple(mp.mpf(float(v)) for v in (f[4] + 1.0, f[0] + 0.5 * c.rise, z[1]))
            P = potential(c, np.float64(z[0]), np.float64(z[1]))
            want = (mp.diff(stored, at, (1, 0, 0)) - H, mp.diff(stored, at, (0, 1, 0)) - z[2],
                    mp.diff(stored, at, (0, 0, 1)) + c.width * float(P[2]) - f[3], c.width * float(P[1]) - f[2],
                    c.EI * (f[1] - c.bend) - z[3])
            worst = max(worst, max(float(abs(v)) for v in want) / (1.0 + abs(f[3])))
    print(f"H = dU/dx', V = dU/dy', M' = dU/dtheta + b dPsi/dtheta, V' = b dPsi/dy: worst difference {worst:.1e}")
    return worst < 1e-12


def check_strong_form(c, kind="lp1"):
    """At one point of a path: first integral along S; every sub-interval integrated again by a Runge-Kutta code."""
    path = Path(c, want=("peak",) if kind == "peak" else ("peak", "lp1"), fine=LEVELS[1]["fine"])
    t, st = path.s, path.found[kind]
    I = first_integral(t, st)
    print(f"first integral H x' + V y' + M theta' - stored - b Psi at {kind} of {c}:")
    print(f"    from {I.min():.15g} to {I.max():.15g} along S, spread {np.ptp(I) / abs(I.mean()):.1e}; -b Psi at rest {adhesion(t):.15g}")
    return np.ptp(I) < 1e-11 * abs(I.mean()) and check_again(path, st)


def check_again(path, st):
    """Every sub-interval of a solution integrated again by a Runge-Kutta code."""
    t = path.s
    worst = 0.0
    S = np.concatenate([np.linspace(p, q, 2 + int((q - p) / t.ell))[:-1] for p, q in zip(st.X[:-1], st.X[1:])] + [st.X[-1:]])
    zs = st.at(S)                                                     # short pieces: an initial value problem loses digits fast
    zs[-1] = st.zn[-1]
    for i in range(len(S) - 1):
        last = np.nextafter(S[i + 1], S[i])                           # at its end another piece of a beam may begin
        s = solve_ivp(lambda S, y: field(t.strip.at(min(S, last)), y, st.H, jac=False), S[i:i + 2], zs[i], method="DOP853", rtol=3e-14, atol=1e-15)
        worst = max(worst, float((np.abs(s.y[:, -1] - zs[i + 1]) / np.maximum(np.ptp(zs, axis=0), 1e-9))[:4].max()))
    print(f"    integrated again in {len(S) - 1} pieces with DOP853: worst difference at an end {worst:.1e} of the range of a component")
    return worst < 1e-11


def check_work(c=replace(PAPER, length=200.0)):
    """Integral of P du from rest to lp1 against the change of stored and adhesion energy."""
    path = Path(c, **dict(LEVELS[1], want=("peak", "lp1")))
    done, changed = work(path, nodes=5), energy(path.s, path.found["lp1"])
    off = abs(done / changed - 1.0)
    print(f"work of the grip up to lp1 of {c}: {done:.12g} aJ, change of energy {changed:.12g} aJ, differs by {off:.1e}")
    return off < 1e-8


ALL = (check_law, check_balance, lambda: check_strong_form(PAPER), lambda: check_strong_form(replace(PAPER, horizontal="fixed"), "peak"),
       check_work)

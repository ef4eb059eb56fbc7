#!/usr/bin/env python3
"""Strips under cohesive laws that hold along the substrate: initiation peak and the first two displacement limit points. Writes sheared.csv.

The law is that of collocation/sheared.py, of the strength and the work of adhesion of the van der Waals half space, and with a shear strength:
    Psi(x, y, theta) = Psi_pull(y, theta) exp(-t^2/delta^2) + Psi_push(y, theta),   t = x - S + (h/2) sin theta.
The left end is free, H = V = M = 0; grip and pull are those of pull_angle.py. Unknowns are g = y - h/2, theta, V, M, w = x - S and H.

As Psi depends on w and not on x, the first integral is that with w' in place of x':  I = H w' + V y' + M theta' - stored - b Psi.
Expected of a long strip: ahead of the front it carries nothing, I = w b; the part that hangs free is stretched by P, so that whatever the
shear strength
    P (1 - cos) + P^2 / 2EA = w b,
Kendall's force of a film that does not slip.

With a work of slip of its own there is no potential. What does not change along S is then I less the work that the traction along the substrate does
beyond that of the potential, b (k - 1) times the integral of E_w (w' + (h/2) cos theta theta'). So what is at the end is b (G_n + G_t): the works
of opening and of slip, which meet  G_n/w + G_t/w_t = 1, without an exponent of Benzeggagh and Kenane.
"""
import math
from dataclasses import replace

from collocation import selfcheck  # first: one thread
import mpmath as mp
import numpy as np
from scipy.optimize import brentq

from collocation import laws, sheared
from collocation.digits import LEVELS
from collocation.energy import adhesion
from collocation.law import Strip, field, potential, stretched
from collocation.path import TURNS, Path
from collocation.slip import Walk, grip, settled
from collocation.suite import DEFINING, Suite, run
from collocation.system import Rule
from collocation.turning import VALUES, turning_points

REMARKS = (
    "Strips under cohesive laws with a shear strength, computed without finite elements by verification/sheared.py; the rest as in laws.csv.",
    "shear_strength_GPa: largest traction along the substrate; strength across it is 0.124 GPa. pull_angle_deg, grip_across as in pull_angle.csv.",
    "shear_work_J_per_m2: that of slip where it is not that of opening, 0.0306 J/m2. mixing_exponent: of Benzeggagh and Kenane; empty: linear.",
    "Every number is good to the digits printed. Empty: does not occur before P has come back to zero, u has, or the strip is off.",
)
D = Strip(law="exponential", far_face=False, shear_strength=0.08)
CASES = [
    *(replace(D, angle=a) for a in (90.0, 60.0, 45.0, 30.0, 120.0, 150.0)),
    *(replace(D, angle=60.0, shear_strength=t) for t in (0.02, 0.04, 0.3)),
    *(replace(D, angle=a, factor=f) for a, f in ((60.0, 0.01), (120.0, 0.01), (60.0, 100.0))),
    replace(D, angle=60.0, rotation="fixed"), replace(D, horizontal="fixed"), replace(D, angle=60.0, horizontal="fixed"),
    replace(D, angle=60.0, law="bilinear"), replace(D, law="dugdale"), replace(D, angle=45.0, length=200.0),
    replace(D, angle=0.0),
    *(replace(D, angle=a, shear_work=0.1) for a in (60.0, 90.0, 30.0, 120.0, 0.0)), replace(D, angle=60.0, shear_work=0.015),
    replace(D, angle=45.0, law="bilinear", shear_work=0.06), replace(D, angle=60.0, factor=0.01, shear_work=0.1),
    *(replace(D, angle=a, shear_work=0.1, mixing=2.3) for a in (60.0, 90.0, 30.0, 120.0)), replace(D, angle=60.0, shear_work=0.1, mixing=1.0),
    replace(D, angle=60.0, shear_work=0.015, mixing=2.3), replace(D, angle=45.0, law="bilinear", shear_work=0.06, mixing=2.0),
]
QUICK = [CASES[i] for i in (1, 6, 13, 19, 27)]
COLUMNS = ("length_nm", "bending_stiffness_factor", "law", "shear_strength_GPa", "shear_work_J_per_m2", "mixing_exponent", "grip_rotation", "grip_across", "far_face", "pull_angle_deg", *VALUES)


def integral(s, st):
    """What does not change along S: the first integral of w, at nodes and collocation points or, less the work without a potential, at nodes."""
    if sheared.ratio(s.strip) != 1.0:
        return constant_without_potential(s, st)
    return first(s.strip, np.concatenate([st.zn, st.inner().reshape(-1, 6)]))


def first(c, z):
    """I at z."""
    f = field(c, z, 0.0, jac=False)
    g, th, V, M, _, H = z.T
    N, Q = H * np.cos(th) + V * np.sin(th), V * np.cos(th) - H * np.sin(th)
    stored = stretched(c, N)[2] + 0.5 * Q ** 2 / c.GA + 0.5 * M ** 2 / c.EI
    psi = potential(c, g, th)[0] + sheared.excess(c, z)[0]
    return H * f[:, 4] + V * f[:, 0] + M * f[:, 1] - stored - c.width * psi


def constant_without_potential(s, st):
    """The first integral at the nodes, less the work that the loads do beyond that of a potential."""
    c, z = s.strip, st.inner()
    f = field(c, z, 0.0, jac=False)
    more = sum(of * f[..., i] for of, i in zip(sheared.beyond(c, z), (0, 1, 4)))
    done = c.width * np.append(0.0, np.cumsum(np.diff(st.X) * (more @ Rule(st.n).w)))
    return first(c, st.zn) - done


class Held(Walk):
    """The path of a strip that its adhesive holds: nothing is remembered."""

    def back(self, st):
        return 0.0, 0.0

    def watch(self, st):
        pass


def path_of(strip, level, want=TURNS, verbose=False, **how):
    return Held(strip, fine=level["fine"], rough=(level["N"], level["n"], 1e-6), goal=2.0 * level["goal"], want=want, verbose=verbose, **how)


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    return turning_points(path_of(strip, level, verbose=verbose), integral)


def check_law():
    """The loads and their derivatives against the potential, differentiated by mpmath, for the exponential law."""
    mp.mp.dps = 40
    rng = np.random.default_rng(5)
    worst = 0.0
    for c in (D, replace(D, height=3.0, shear_strength=0.02), replace(D, shear_work=0.1), replace(D, shear_work=0.1, mixing=2.3)):
        h, w, closed = mp.mpf(c.height), mp.mpf(laws.work(c)), mp.mpf(laws.rest(c))
        slipping = w if c.shear_work is None else mp.mpf(c.shear_work)
        reach, delta, k = mp.mpf(laws.span(c)), mp.sqrt(2 / mp.e) * slipping / mp.mpf(c.shear_strength), slipping / w

        def psi(g, th, x):
            t = (g + h / 2 * (1 - mp.cos(th)) - closed) / reach
            left = lambda t: (1 + t) * mp.exp(-t)
            pulled, pushed = (left(t), 0) if t > 0 else (1, left(t) - 1)
            return -w * (pulled * mp.exp(-((x + h / 2 * mp.sin(th)) / delta) ** 2) + pushed)

        def pushes(g, th, x):
            """The part of psi that nothing mixes."""
            t = (g + h / 2 * (1 - mp.cos(th)) - closed) / reach
            return 0 if t > 0 else -w * ((1 + t) * mp.exp(-t) - 1)

        def factor(g, th, x):
            """F, by the shares G_n and G_t of a way of one mode, m and 1 - m of their sum."""
            t = (g + h / 2 * (1 - mp.cos(th)) - closed) / reach
            p, q = (t - mp.log(1 + t) if t > 0 else 0), ((x + h / 2 * mp.sin(th)) / delta) ** 2
            linear = (w * p + slipping * q) / (p + q)
            m = slipping * q / (w * p + slipping * q)
            return 1 + 2 * ((w + (slipping - w) * m ** mp.mpf(c.mixing)) / linear - 1) * (1 - mp.exp(-p - q))

        def load(i, at):
            """Minus the load by y, theta and x: the gradient of psi, its part of the traction along the substrate k times, and all that mixes F times."""
            order = tuple(int(k == i) for k in range(3))
            slip = lambda *at: (k - 1) * mp.diff(psi, at, (0, 0, 1))
            more = 0 if i == 0 else slip(*at) * (h / 2 * mp.cos(at[1]) if i == 1 else 1)
            pushed = mp.diff(pushes, at, order)
            return (mp.diff(psi, at, order) + more - pushed) * (1 if c.mixing is None else factor(*at)) + pushed

        for _ in range(30):
            th, x = rng.uniform(-1.2, 1.2), float(delta) * rng.uniform(-1.5, 1.5)
            x -= 0.5 * c.height * math.sin(th)
            g = float(closed) + laws.span(c) * rng.uniform(-0.3, 3.0) - c.height * math.sin(0.5 * th) ** 2
            z = np.array([g, th, 0.0, 0.0, x, 0.0])
            f, J, _ = field(c, z, 0.0)
            at = mp.mpf(g), mp.mpf(th), mp.mpf(x)
            size = (float(reach), 0.1, float(delta))
            for i, row in enumerate((2, 3, 5)):
                want = float(load(i, at))
                worst = max(worst, abs(f[row] / c.width - want) * size[i] / float(w))
                for j, column in enumerate((0, 1, 4)):
                    want = float(mp.diff(lambda *at: load(i, at), at, tuple(int(k == j) for k in range(3))))
                    worst = max(worst, abs(J[row, column] / c.width - want) * size[i] * size[j] / float(w))
    print(f"loads and Jacobian against the potential (mpmath): worst difference {worst:.1e}")
    return worst < 1e-10


def check_steady(length=300.0):
    """The force of a long soft strip of which half is off, against Kendall's."""
    worst = 0.0
    for angle, strength in ((45.0, 0.08), (60.0, 0.04), (90.0, 0.08), (120.0, 0.08)):
        strip = replace(D, factor=0.01, length=length, angle=angle, shear_strength=strength)
        half = lambda s, st: float(st.at(np.array([0.5 * length]))[0, 0]) > 10.0 * laws.span(strip)
        path = path_of(strip, LEVELS[0], want=("never",), stop=half)
        s, (cos, _) = path.s, path.s.strip.pull
        kendall = brentq(lambda P: P * (1.0 - cos) + P ** 2 / (2.0 * s.strip.EA) - adhesion(s), 0.0, 10.0, xtol=1e-16)
        up = grip(s, "u")
        st, _ = settled(s, path.points[-1], up, up @ path.points[-1].zn[-1], *LEVELS[0]["fine"])
        print(f"steady force at {angle:g} degrees, shear strength {strength:g} GPa, L = {length:g} nm: {s.P(st):.12g} nN at u = {s.u(st):.6g} nm, "
              f"Kendall {kendall:.12g} nN")
        worst = max(worst, abs(s.P(st) / kendall - 1.0))
    print(f"    differs by {worst:.1e} at most")
    return worst < 1e-9


def check_free():
    """The weaker along the substrate, the nearer to the strip that slides, whose peak is that of laws.py: by about the square."""
    free = turning_points(Path(replace(D, shear_strength=None), **dict(LEVELS[0], want=("peak",))))["peak_force_nN"]
    offs = []
    for strength in (0.02, 0.01):
        weak = turning_points(path_of(replace(D, shear_strength=strength), LEVELS[0], want=("peak",)), integral)
        offs.append(weak["peak_force_nN"] / free - 1.0)
        print(f"peak straight up, shear strength {strength:g} GPa: {offs[-1]:+.2e} from the strip that slides")
    return 3.0 < offs[0] / offs[1] < 4.0


if __name__ == "__main__":
    defining = DEFINING | {"law": "law", "pull_angle_deg": "angle", "grip_across": "horizontal", "shear_strength_GPa": "shear_strength", "shear_work_J_per_m2": "shear_work", "mixing_exponent": "mixing"}
    suite = Suite("sheared.csv", REMARKS, CASES, COLUMNS, compute, QUICK, defining, paper=D)
    run(__doc__.split("\n")[0], suite, (check_law,), (check_steady, check_free))

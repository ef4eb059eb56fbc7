#!/usr/bin/env python3
"""Strips under other laws of adhesion: initiation peak and the first two displacement limit points. Writes laws.csv.

The laws are those of collocation/laws.py: Sauer's surface traction, and three cohesive laws of the strength and the work of
adhesion of the van der Waals half space. Beam and grip are those of strip_variants.csv at 100 nm but for what the columns say.

The first integral I = H x' + V y' + M theta' - stored changes along S by  I' = -b (T_c y' + M_c theta').  With a potential it is
b Psi', hence P + P^2/2EA = w b for a long strip pulled upright. The surface traction has T_c y' + M_c theta' = -cos U',
U = W(r1) - W(r2), so that
    P + P^2/2EA = b int cos dU = w b - b int (1 - cos) dU   over the front: less than Kendall's force.
How much less: were the strip a beam of curvature kappa = (2w/EI)^(1/2) from a flat rest on, with small angles and rigid in shear,
theta^2/2 would be kappa (r - r_eq), and the share kappa int (r - r_eq) dU / w = (9/7) r_eq kappa: 0.63 % for this strip.
"""
import math
from dataclasses import replace

from collocation import selfcheck  # first: one thread
import mpmath as mp
import numpy as np

from collocation import laws
from collocation.digits import LEVELS
from collocation.energy import adhesion, energy, first_integral, refined, work
from collocation.law import Strip, field, loads, potential
from collocation.path import Path
from collocation.suite import DEFINING, Suite, run
from collocation.system import Rule
from collocation.turning import VALUES, turning_points

REMARKS = (
    "Strips under other laws of adhesion, computed without finite elements by verification/laws.py; the rest as in strip_variants.csv.",
    "law: body-force; surface-traction, T(r) cos on the faces; exponential, bilinear, dugdale: cohesive laws of the near face, of the same strength and work.",
    "pull_angle_deg: 0 along the substrate and away from the strip, 180 back over it. Every number is good to the digits printed.",
    "Empty: does not occur before P has come back to zero, u has, or the strip is off.",
)
D = Strip(law="surface-traction")
COHESIVE = [replace(D, law=law, far_face=False) for law in laws.COHESIVE]
EXPONENTIAL, BILINEAR, DUGDALE = COHESIVE
CASES = [
    *(replace(c, factor=f) for f in (1.0, 0.01, 100.0) for c in (D, *COHESIVE)),
    *(replace(c, line_load="axis-gap") for c in (BILINEAR, EXPONENTIAL)),
    *(replace(c, line_load="force-only") for c in (D, EXPONENTIAL)),
    *(replace(c, rotation="fixed") for c in (DUGDALE, D)),
    replace(D, far_face=False),
    *(replace(c, young=0.02) for c in (D, BILINEAR, Strip())),
    replace(BILINEAR, length=200.0), replace(EXPONENTIAL, angle=60.0),
]
QUICK = [CASES[i] for i in (0, 2, 11, 13, 15, 16)]
COLUMNS = ("length_nm", "bending_stiffness_factor", "youngs_modulus_GPa", "law", "grip_rotation", "line_load", "far_face", "pull_angle_deg", *VALUES)


def conservative(c):
    return c.line_load == "axis-gap" or c.line_load == "full" and c.law != "surface-traction"


def integral(s, st):
    """What does not change along S: the first integral, or at the nodes that less the work of the line load."""
    if conservative(s.strip):
        return first_integral(s, st)
    c, z = s.strip, st.inner()
    f = field(c, z, st.H, jac=False)
    g, th = z[..., 0], z[..., 1]
    T, M, *_ = loads(c, g, th)
    done = np.diff(st.X) * ((T * f[..., 0] + M * f[..., 1]) @ Rule(st.n).w)
    level = first_integral(s, st)[:len(st.X)] + c.width * potential(c, *st.zn[:, :2].T)[0]
    return level - c.width * np.append(0.0, np.cumsum(done))


def compute(strip, level, verbose):
    """The numbers of one path; None where a point does not occur."""
    return turning_points(Path(strip, verbose=verbose, **level), integral)


def ramp(x, e):
    t = x / e
    if abs(t) >= 1:
        return max(x, mp.mpf(0))
    return e * (mp.mpf(35) / 256 + t / 2 + mp.mpf(35) / 32 * (t ** 2 / 2 - t ** 4 / 4 + t ** 6 / 10 - t ** 8 / 56))


def shape(law):
    """s of a cohesive law without its scale, where its formula changes, and the range in which its maximum lies."""
    rho, e, tail, fall = mp.mpf(1) / 10, mp.mpf(1) / 20, mp.mpf(3) / 10, mp.mpf(2) / 10
    if law == "exponential":
        return lambda t: t * mp.exp(1 - t), [0, mp.inf], None
    if law == "bilinear":
        m = rho / (1 - rho)
        s = lambda t: (t - (1 + m) * ramp(t - rho, e) + m * ramp(t - 1, tail)) / rho
        return s, [0, rho - e, rho + e, 1 - tail, 1 + tail], (rho, rho + e)
    down, half = rho / fall, fall / 2
    s = lambda t: (t - ramp(t - rho, e) - down * ramp(t - 1 + fall, half) + down * ramp(t - 1, half)) / rho
    return s, [0, rho - e, rho + e, 1 - fall - half, 1 - half, 1 + half], None


def scale(law):
    """c: one over the maximum of the shape."""
    s, _, between = shape(law)
    if between is None:
        return mp.mpf(1)
    return 1 / s(mp.findroot(lambda t: mp.diff(s, t), between, solver="anderson"))


def check_constants():
    """c and int_0^inf s by mpmath, as quadrature and maximum, against those in use and against closed forms: with int x^2 R'' = 1/9
    rounding a corner with the change a of the slope adds a e^2/18 to the area of the unrounded law."""
    mp.mp.dps = 30
    c = {law: scale(law) for law in laws.COHESIVE}
    whole = {law: c[law] * mp.quad(*shape(law)[:2]) for law in laws.COHESIVE}
    closed = {"exponential": mp.e, "bilinear": c["bilinear"] * mp.mpf(1633) / 3240, "dugdale": mp.mpf(611) / 720}
    worst = max(max(abs(closed[law] / whole[law] - 1), abs(laws.COHESIVE[law].whole / whole[law] - 1)) for law in laws.COHESIVE)
    worst = max(worst, abs(laws.C / c["bilinear"] - 1))
    for cohesive in COHESIVE:
        law = cohesive.law
        print(f"{law}: c = {mp.nstr(c[law], 17)}, int s = {mp.nstr(whole[law], 17)}, range = {laws.span(cohesive):.15g} nm")
    print(f"    quadrature, closed form and the numbers in use differ by {float(worst):.1e} at most")
    return worst < 1e-15


def check_calibration():
    """Work and strength of the line load as it comes out of the code, against the half space: T = K/r0 (q^9/45 - q^3/3), q^6 = 5."""
    mp.mp.dps = 30
    worst = [0.0, 0.0]
    for c in COHESIVE:
        gap, reach = laws.rest(c), laws.span(c)
        K, r0 = mp.mpf(c.hamaker) * mp.mpf(10) ** 18 / (2 * mp.pi * mp.mpf(c.r0) ** 2), mp.mpf(c.r0)
        q = mp.mpf(15) ** (mp.mpf(1) / 6)
        w, top = K * (q ** 2 / 6 - q ** 8 / 360), K / r0 * (mp.sqrt(5) / 3 - 5 * mp.sqrt(5) * 5 / (45 * 5))
        most = 0.0
        a, b = gap, gap + 1.2 * reach
        for _ in range(12):                                           # the largest traction, on finer and finer grids
            g = np.linspace(a, b, 401)
            pull = potential(c, g, np.zeros_like(g))[1]
            i, most = int(np.argmax(pull)), max(most, float(pull.max()))
            a, b = g[max(i - 1, 0)], g[min(i + 1, 400)]
        at = potential(c, np.float64(gap), np.float64(0.0))
        worst = [max(worst[0], float(abs(-at[0] / w - 1))), max(worst[1], float(abs(most / top - 1)), abs(float(at[1])))]
    print(f"cohesive laws against the half space: work {float(w):.15g} nN/nm to {worst[0]:.1e}, strength {float(top):.15g} GPa to {worst[1]:.1e}")
    return max(worst) < 1e-14


def reference(c):
    """T_c and M_c as they are defined, in mpmath, and the potential as an integral where there is one."""
    h, r0, K = mp.mpf(c.height), mp.mpf(c.r0), mp.mpf(c.K)
    blind = c.line_load == "axis-gap"
    if c.law == "surface-traction":
        T = lambda r: K / r0 * ((r0 / r) ** 9 / 45 - (r0 / r) ** 3 / 3)
        if c.far_face:
            r1, r2 = (lambda g, th, side=side: g + h / 2 - side * h / 2 * mp.cos(th) for side in (1, -1))
            return (lambda g, th: mp.cos(th) * (T(r1(g, th)) - T(r2(g, th))),
                    lambda g, th: h / 2 * mp.sin(th) * mp.cos(th) * (T(r1(g, th)) + T(r2(g, th))), None)
        r1 = lambda g, th: g + h / 2 - h / 2 * abs(mp.cos(th))
        return lambda g, th: abs(mp.cos(th)) * T(r1(g, th)), lambda g, th: h / 2 * mp.sin(th) * mp.cos(th) * T(r1(g, th)), None
    bare, corners, _ = shape(c.law)
    top, w = 2 * mp.sqrt(5) / 9 * K / r0, mp.mpf(15) ** (mp.mpf(1) / 3) / 8 * K
    by = scale(c.law)
    s = lambda t: by * bare(t)
    reach = w / (top * mp.quad(s, corners))
    closed = r0 * mp.mpf(15) ** (mp.mpf(-1) / 6)
    # of the face that lies h/2 side cos theta below the axis: its opening, and its lever
    t = lambda g, th, side: (g + (0 if blind else h / 2 * (1 - side * mp.cos(th))) - closed) / reach
    lever = lambda th, side: 0 if blind else h / 2 * mp.sin(th) * side
    over = lambda th: not blind and mp.cos(th) < 0

    def left(at):
        ends = [at, *(p for p in corners if p > at)]
        return mp.quad(s, ends) if len(ends) > 1 else mp.mpf(0)

    def loads(g, th):
        """s and the lever of every face that carries something: turned over, the bonded one where it is open, the other where it is pressed."""
        bonded, other = (t(g, th, 1), lever(th, 1)), (t(g, th, -1), lever(th, -1))
        faces = [bonded] if not over(th) else [face for face, acts in ((bonded, bonded[0] > 0), (other, other[0] < 0)) if acts]
        return [(s(at), arm) for at, arm in faces]

    def psi(g, th):
        whole = left(t(g, th, 1)) if not over(th) else left(max(t(g, th, 1), 0)) + left(min(t(g, th, -1), 0)) - left(mp.mpf(0))
        return -top * reach * whole

    return lambda g, th: -top * mp.fsum(f for f, _ in loads(g, th)), lambda g, th: -top * mp.fsum(f * arm for f, arm in loads(g, th)), psi


def check_law():
    """T_c, M_c and the Jacobian against their definitions, differentiated numerically; T_c and M_c against -grad Psi."""
    rng = np.random.default_rng(3)
    worst, slope = 0.0, 0.0
    mp.mp.dps = 30
    for c in (D, replace(D, far_face=False), *COHESIVE, replace(BILINEAR, line_load="axis-gap"), replace(DUGDALE, height=20.0, r0=0.2)):
        T, M, psi = reference(c)
        far = 20.0 * c.r0 if psi is None else 1.3 * laws.span(c)
        for k in range(24):
            r = 0.62 * c.r0 + far * rng.uniform(0.0, 1.0) ** 2
            th = rng.uniform(-1.0, 1.0) * (3.1 if k % 2 else 0.3)
            lift = 0.0 if c.line_load == "axis-gap" else 0.5 * c.height * (1.0 - abs(math.cos(th)))
            g = r - lift
            got = [float(v) for v in loads(c, np.float64(g), np.float64(th))]
            at = mp.mpf(float(g)), mp.mpf(float(th))
            want = [-T(*at), -M(*at), *(-mp.diff(what, at, order) for what in (T, M) for order in ((1, 0), (0, 1)))]
            base = laws.strength(c)                                   # what a traction, an arm and a derivative are measured in
            short = 0.1 * c.r0 if psi is None else laws.span(c) * laws.ROUND
            arm = c.height
            size = [base, base * arm, base / short, base * arm / short, base * arm / short, base * arm * arm / short]
            worst = max(worst, max(float(abs(a - b)) / max(float(abs(b)), s) for a, b, s in zip(got, want, size)))
            if psi is not None and k < 4:
                grad = [mp.diff(psi, at, order, h=mp.mpf(10) ** -9) for order in ((1, 0), (0, 1))]
                own = float(potential(c, np.float64(g), np.float64(th))[0])
                slope = max(slope, float(abs(own - psi(*at))) / laws.work(c), *(float(abs(a - b)) / s for a, b, s in zip(got, grad, size)))
    print(f"T_c, M_c and Jacobian against their definitions (mpmath): worst difference {worst:.1e}")
    print(f"Psi against its quadrature, T_c and M_c against its gradient: worst difference {slope:.1e}")
    return worst < 1e-12 and slope < 1e-11


def front(s, st):
    """int cos dU over the strip, by parts; U = W(r1) - W(r2) as Psi cos of the body forces."""
    c = s.strip
    U = lambda z: potential(c, z[..., 0], z[..., 1])[0] * np.cos(z[..., 1])
    z = st.inner()
    inside = np.diff(st.X) @ ((U(z) * np.sin(z[..., 1]) * z[..., 3] / c.EI) @ Rule(st.n).w)
    ends = U(st.zn[[0, -1]]) * np.cos(st.zn[[0, -1], 1])
    return float(c.width * (ends[1] - ends[0] + inside))


def check_steady(length=1000.0):
    """The force of a long strip where |d ln P / d ln u| is least behind the peak, against Kendall's with extension."""
    worst = 0.0
    for c in (EXPONENTIAL, DUGDALE, D, replace(D, factor=0.01)):
        path = Path(replace(c, length=length), want=("plateau",), most=120)           # beyond every turn
        s = path.s
        st = refined(path, min(path.points[1:], key=lambda st: abs(s.steepness(st))))
        force = lambda w: 2.0 * w / (1.0 + math.sqrt(1.0 + 2.0 * w / s.strip.EA))      # P + P^2/2EA = w
        P, kendall = s.P(st), force(adhesion(s))
        expected = kendall if conservative(c) else force(front(s, st))
        print(f"steady force, {c.law}, EI x {c.factor:g}: {P:.12g} nN at u = {s.u(st):.6g} nm, expected {expected:.12g}, differs by "
              f"{abs(P / expected - 1.0):.1e}; {P / kendall - 1.0:+.3e} from Kendall's {kendall:.12g}")
        worst = max(worst, abs(P / expected - 1.0))
    return worst < 1e-7


def check_work():
    """Integral of P du from rest to lp1 against the change of stored and adhesion energy."""
    path = Path(BILINEAR, **dict(LEVELS[0], want=("peak", "lp1")))
    done, changed = work(path, nodes=9), energy(path.s, path.found["lp1"])
    print(f"work of the grip up to lp1 of {BILINEAR}: {done:.12g} aJ, change of energy {changed:.12g} aJ, differs by {abs(done / changed - 1.0):.1e}")
    return abs(done / changed - 1.0) < 1e-8


def check_form():
    """At a peak: first integral, and integrated again."""
    held = True
    for c in (D, DUGDALE):
        path = Path(c, want=("peak",))
        st = path.found["peak"]
        I = integral(path.s, st)
        spread = np.ptp(I) / (adhesion(path.s) + path.s.P(st))
        print(f"first integral at the peak of {c}: spread {spread:.1e}")
        held &= spread < 1e-11 and selfcheck.check_again(path, st)
    return held


if __name__ == "__main__":
    suite = Suite("laws.csv", REMARKS, CASES, COLUMNS, compute, QUICK, DEFINING | {"law": "law", "pull_angle_deg": "angle"}, paper=Strip())
    run(__doc__.split("\n")[0], suite, (check_constants, check_calibration, check_law, check_form), (check_steady, check_work))

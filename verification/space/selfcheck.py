"""The equations against the energy, the law against its definition, a solution against a Runge-Kutta code."""

import mpmath as mp
import numpy as np
from scipy.integrate import solve_ivp

from . import law as laws
from .beam import SIZE, adhesion, right_side, stored
from .grip import Peel
from .peel import FINE, walk

# fourth to tenth order central differences: six values on either side would do; five are enough at this step
WEIGHTS = (5.0 / 6.0, -5.0 / 21.0, 5.0 / 84.0, -5.0 / 504.0, 1.0 / 1260.0)


def law_of_section():
    """Psi and its gradient by the divided difference against the four terms of the definition with 60 digits; an
    ellipse by quadrature."""
    mp.mp.dps = 60
    rng = np.random.default_rng(2)
    worst = 0.0
    for k in range(40):
        law = laws.Rectangle(*rng.uniform(1.0, 50.0, 2))
        tilt, spin = (10.0 ** rng.uniform(-9.0, 0.19, 2)) * rng.choice([-1.0, 1.0], 2)
        e2, e3 = np.sin(tilt), np.cos(tilt) * np.cos(spin)
        y = law.lowest(e2, e3) + 10.0 ** rng.uniform(-0.6, 1.5)
        got = law.gradient(y, e2, e3)
        K, r0 = mp.mpf(law.hamaker) / (2 * mp.pi * law.r0), mp.mpf(law.r0)
        V = lambda r, sign: K * ((r0 / r) ** 7 / 2520 + sign * r0 / r / 6)

        def psi(y, e2, e3, sign=-1):
            a, c = law.width * e2, law.height * e3
            return (
                law.width
                * law.height
                / (a * c)
                * sum(i * j * V(y - i * a / 2 - j * c / 2, sign) for i in (1, -1) for j in (1, -1))
            )

        at = [mp.mpf(float(v)) for v in (y, e2, e3)]
        for n, value in zip(((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), got):
            exact = psi(*at) if sum(n) == 0 else mp.diff(psi, at, n)
            size = abs(psi(*at, 1) if sum(n) == 0 else mp.diff(lambda *x: psi(*x, 1), at, n))
            worst = max(worst, float(abs(value - exact) / size) / max(1.0, y / (y - law.lowest(e2, e3))))
    ellipse = laws.Ellipse(20.0, 10.0)
    y, e2, e3 = 12.0, 0.3, 0.8
    f = (
        lambda r: ellipse.hamaker
        / (2.0 * np.pi * ellipse.r0**3)
        * ((ellipse.r0 / r) ** 9 / 45.0 - (ellipse.r0 / r) ** 3 / 3.0)
    )
    x, w = np.polynomial.legendre.leggauss(60)
    turn = 2.0 * np.pi * np.arange(120) / 120.0
    s = 0.5 * (x + 1.0)[:, None]
    whole = (
        0.5
        * w[:, None]
        * s
        * 50.0
        * (2.0 * np.pi / 120.0)
        * f(y + s * (10.0 * np.cos(turn) * e2 + 5.0 * np.sin(turn) * e3))
    ).sum()
    got = ellipse.gradient(y, e2, e3)
    round_trip = max(
        abs(ellipse.gradient(*(v + 1e-30j * (i == k) for i, v in enumerate((y, e2, e3))))[0].imag / 1e-30 - got[k + 1])
        for k in range(3)
    ) / abs(got[0])
    off = abs(whole / got[0] - 1.0)
    print(
        f"law of a tilted rectangle against its definition (60 digits, 160 values): "
        f"{worst:.1e} of the parts, over y/gap; "
        f"ellipse against quadrature {off:.1e}, its gradient against complex steps {round_trip:.1e}",
        flush=True,
    )
    return [] if worst < 3e-14 and off < 1e-12 and round_trip < 1e-13 else ["the law of a section"]


def energy(peel, st):
    z = st.inner()
    whole = stored(peel.problem.beam, z) + adhesion(peel.problem.beam, z)
    return float(np.diff(st.X) @ (whole @ st.rule.b))


def difference(values, step):
    return sum(w * (values[k + 1] - values[-k - 1]) for k, w in enumerate(WEIGHTS)) / step


def energies(cases):
    """dE/du = P, dE/droll = torque, dE/dyaw = moment of yaw: central differences of the energy."""
    faults = []
    for name, u, turns in (("rolled", 1.0, ("roll",)), ("clamped", 1.0, ("roll", "yaw")), ("sideways", 5.0, ())):
        peel = Peel(cases[name])
        fine = FINE[0]
        for point, solved in walk(peel, True):
            if point == f"u_{u:g}":
                st = solved(fine)
                break
        n = len(WEIGHTS)
        step = 0.02

        def around(move, restore):
            found = {0: None}
            for side in (1, -1):
                now = st
                for k in range(1, n + 1):
                    now = move(now, side * k)
                    found[side * k] = energy(peel, now)
                restore()
            return found

        drop = lambda now, k: peel.problem.solve(now, peel.u, peel.u_row(u + step * k), tolerance=1e-11)
        lines = [("P", difference(around(drop, lambda: None), step), float(st.par[0]))]
        for what in turns:
            by = {"roll": "roll_by", "yaw": "yaw_by"}[what]
            start, small = getattr(peel, by), 0.002

            def turned(now, k):
                setattr(peel, by, start + small * k)
                return peel.problem.solve(now, peel.u, peel.u_row(u), tolerance=1e-11)

            found = difference(around(turned, lambda: setattr(peel, by, start)), small)
            lines.append(
                (
                    "torque" if what == "roll" else "yaw moment",
                    found,
                    peel.reactions(st)["torque" if what == "roll" else "yaw_moment"],
                )
            )
        for what, slope, value in lines:
            print(f"{name} at u = {u:g}: {what} {value:.12g}, derivative of the energy {slope:.12g}", flush=True)
            if abs(slope - value) > 1e-8 * max(1.0, abs(value)):
                faults.append(f"{name}: {what} is not the derivative of the energy")
    return faults


def runge_kutta(case):
    """The peak of a case, integrated again from node to node by a Runge-Kutta code of order 8, with the law itself.
    Not on intervals over which an initial value problem amplifies round-off: those longer than 3 nm, in the part that
    is at rest."""
    peel = Peel(case)
    st = next(solved for name, solved in walk(peel, True) if name == "peak")(FINE[1])
    beam = peel.problem.beam
    pull = lambda y, e2, e3: beam.law.gradient(y, e2, e3)[1:]
    worst = 0.0
    for i in np.flatnonzero(np.diff(st.X) < 3.0):
        end = solve_ivp(
            lambda s, z: right_side(beam, z, pull), st.X[i : i + 2], st.z[:, i], method="DOP853", rtol=1e-12, atol=1e-14
        ).y[:, -1]
        worst = max(worst, float(np.abs((end - st.z[:, i + 1]) / peel.problem.scale).max()))
    print(
        f"peak of {case.case} integrated again from node to node: differs by {worst:.1e} of the sizes of the unknowns",
        flush=True,
    )
    return [] if worst < 1e-10 else ["Runge-Kutta differs from collocation"]

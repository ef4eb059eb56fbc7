"""Patch, lamella and toe: bundles, a dome on springs, bands on rows of setae, peeling with a tension, without finite elements.

A band on rows is a beam under point forces: with w'''' = 0 between them its deflection is w(x) = a + b x + Σ F_j |x - x_j|³/(12 EI), with
Σ F_j = 0 and Σ F_j x_j = 0. A row of setae pulls with -k w. So w, a and b solve one dense linear system. Shear of rows: the same with
u(x) = c - Σ F_j |x - x_j|/(2 EA). Units: µm, µN, MPa (1 µN/µm = 1 N/m).
"""

import math

import numpy as np
from scipy.optimize import brentq, minimize_scalar

import tables

LENGTH, RADIUS, MODULUS, ANGLE = 110.0, 2.1, 1500.0, math.radians(43.0)
DENSITY, PITCH = 0.0144, 25.0 / 3.0
FORCE, REACH = 0.45445, 5.14267
STIFFNESS = FORCE / REACH
COLUMNS, ROWS, WIDTH, THICKNESS = 360, 60, 3000.0, 30.0
BENDING = MODULUS * WIDTH * THICKNESS**3 / 12.0
AXIAL = MODULUS * WIDTH * THICKNESS
INERTIA = math.pi * RADIUS**4 / 4.0
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
CONE = math.radians(30.0)


def scattered(count, half, middle=1.0):
    return middle + half * (2.0 * np.mod(GOLDEN * np.arange(1, count + 1), 1.0) - 1.0)


class Band:
    """A beam with springs at places x; pulled at one of the rows by a force, or by a moment."""

    def __init__(self, count, pitch, bending):
        self.x = pitch * np.arange(count)
        self.scale = 1.0 / (12.0 * bending)
        self.green = np.abs(self.x[:, None] - self.x[None, :]) ** 3 * self.scale

    def deflection(self, springs, at=0, moment=False):
        """Of a unit load, at the rows."""
        matrix, right = self.system(springs, at, moment)
        # rows of very different size
        size = np.abs(matrix).max(axis=1)
        return np.linalg.solve(matrix / size[:, None], right / size)[: len(self.x)]

    def system(self, springs, at=0, moment=False):
        """Of a unit load, for the deflections at the rows, a and b."""
        n = len(self.x)
        matrix = np.zeros((n + 2, n + 2))
        right = np.zeros(n + 2)
        unit = max(self.x[-1], 1.0)
        # unknowns w_j, a, b: w_i + Σ_j G_ij k_j w_j - a - b x_i = load
        matrix[:n, :n] = np.eye(n) + self.green * springs
        matrix[:n, n], matrix[:n, n + 1] = -1.0, -self.x / unit
        matrix[n, :n], matrix[n + 1, :n] = springs, springs * self.x / unit
        if moment:
            # a couple at the end: -dG/dξ, |x - ξ|³' = -3 (x - ξ)², with the sign that lifts the end
            right[:n] = 3.0 * (self.x - self.x[at]) ** 2 * self.scale
            right[n + 1] = -1.0 / unit
        else:
            right[:n] = self.green[:, at]
            right[n], right[n + 1] = 1.0, self.x[at] / unit
        return matrix, right


def losses(band, spring, reach, most):
    """Forces and lifts of the end at which rows of equal strength let go, one after another."""
    springs = np.full(len(band.x), spring)
    out = []
    for _ in range(most):
        w = band.deflection(springs)
        with np.errstate(divide="ignore"):
            load = np.where((springs > 0) & (w > 0), reach / w, np.inf)
        first = int(np.argmin(load))
        out.append((load[first], load[first] * w[0]))
        springs[first] = 0.0
    return out


def arrays():
    cos, tan = math.cos(ANGLE), math.tan(ANGLE)
    plain = 3 * MODULUS * INERTIA * DENSITY * math.sin(ANGLE) / (LENGTH * cos) ** 2 * 1e3
    yield "A1", "modulus kPa", plain
    yield "A1", "modulus kPa along 0.29", plain / (1 + 0.29 * tan)
    yield "A1", "modulus kPa against 0.24", plain / (1 - 0.24 * tan)
    area = math.pi * RADIUS**2
    ka, kb = MODULUS * area / LENGTH, 3 * MODULUS * INERTIA / LENGTH**3
    t = np.array([cos, math.sin(ANGLE)])
    m = np.array([-t[1], t[0]])
    normal = (ka * np.outer(t, t) + kb * np.outer(m, m))[:, 1]
    size = np.linalg.norm(normal)
    yield "A3", "angle of the plane deg", math.degrees(math.atan2(normal[1], normal[0]))
    yield "A3", "distance um", FORCE / size


def patches():
    for name, x in [
        ("uniform", 0.5 + (np.arange(1, 101) - 0.5) / 100),
        ("Weibull 5", (-np.log(1 - (np.arange(1, 101) - 0.5) / 100)) ** 0.2),
        ("golden", 0.5 + np.mod(GOLDEN * np.arange(1, 101), 1.0)),
    ]:
        ordered = np.sort(x)
        yield "P1", f"bundle of 100 {name}", float(max((100 - i) * ordered[i] for i in range(100)) / 100)
    for radius, count in [(2000.0, 61), (20000.0, 121)]:
        place = PITCH * (np.arange(count) - (count - 1) / 2)
        rise = np.sort(((place[:, None] ** 2 + place[None, :] ** 2) / (2 * radius)).ravel())
        # before the loss of a seta the apex is at u_c less its rise; of equal ones the last one counts
        force = STIFFNESS * (np.arange(1, len(rise) + 1) * (REACH - rise) + np.cumsum(rise))
        yield "P4", f"sphere {radius:.0f} um pull-off uN", float(max(force))
    for name, radius, gap in [("seta", RADIUS, PITCH - 2 * RADIUS), ("branch", 0.1, 0.8)]:
        modulus, work = 2000.0, 0.0307
        effective = modulus / (2 * (1 - 0.3**2))
        half = (32 * work * (radius / 2) ** 2 / (math.pi * effective)) ** (1 / 3)
        inertia = math.pi * radius**4 / 4
        yield "P5", f"longest {name} um", (9 * modulus * inertia * gap**2 / (1.5 * work * half)) ** 0.25
    # heights spread evenly: the integral over them, the peak where the first one lets go, or where the attached part is best
    for spread in (1.0, 3.0, 4.5):
        def traction(u, spread=spread):
            low, high = u - spread, min(u + spread, REACH)
            return DENSITY * STIFFNESS * max(high**2 - low**2, 0.0) / (4 * spread) if low < high else 0.0

        best = minimize_scalar(lambda u: -traction(u), bounds=(0.0, REACH), method="bounded", options={"xatol": 1e-12})
        candidates = [-best.fun, traction(REACH - spread)]
        yield "L2", f"peak kPa heights {spread}", max(candidates) * 1e3
        yield "L2", f"work mJ/m2 heights {spread}", DENSITY * (STIFFNESS * REACH**2 / 2 - STIFFNESS * spread**2 / 6) * 1e3


def lamellae():
    spring, strength = COLUMNS * STIFFNESS, COLUMNS * FORCE
    found = losses(Band(ROWS, PITCH, BENDING), spring, REACH, 41)
    for number in (1, 2, 3, 6, 11, 21, 41):
        yield "P2", f"60 rows loss {number} uN", found[number - 1][0]
        yield "P2", f"60 rows loss {number} lift um", found[number - 1][1]
    found = losses(Band(400, PITCH, BENDING), spring, REACH, 51)
    lam = (spring / (4 * BENDING * PITCH)) ** 0.25
    for number in (1, 11, 51):
        yield "P2", f"400 rows loss {number} uN", found[number - 1][0]
        overhang = (number - 1) * PITCH
        yield "P2", f"Winkler loss {number} uN", strength / (2 * lam * PITCH * (1 + lam * overhang))
    w = Band(ROWS, PITCH, BENDING).deflection(np.full(ROWS, spring), moment=True)
    yield "P2", "60 rows moment that lifts the end uN um", REACH / max(w)
    yield "P2", "60 rows moment that presses the end uN um", REACH / max(-w)
    yield "P2", "half-infinite moment uN um", strength / (2 * lam**2 * PITCH)
    alpha = math.acosh(1 + 3 * spring * PITCH / AXIAL / 2)
    yield "P3", "alpha", alpha
    for n in (60, 400, 3000):
        # by a recursion from the far end: force in the band and displacement, scaled as they grow
        u, tension = 1.0, 0.0
        for _ in range(n - 1):
            tension += 3 * spring * u
            u += tension * PITCH / AXIAL
            if u > 1e100:
                u, tension = u * 1e-100, tension * 1e-100
        tension += 3 * spring * u
        yield "P3", f"{n} rows over one", tension / (3 * spring * u)
    for ratio in (1.5, 2.0, 4.0):
        force, lift, zone = softening(spring / PITCH, REACH, ratio * REACH)
        yield "L1", f"peak uN {ratio}", force
        yield "L1", f"lift um {ratio}", lift
        yield "L1", f"zone um {ratio}", zone
    # 278 rows of setae with strengths that scatter, as far as 1100 losses: the peak is among them
    band, rows = Band(278, PITCH, BENDING), 278
    limits = np.sort(REACH * scattered(rows * COLUMNS, 0.2).reshape(rows, COLUMNS), axis=1)
    lost, forces = np.zeros(rows, dtype=int), []
    for event in range(1100):
        if event % 50 == 0:
            matrix, right = band.system(STIFFNESS * (COLUMNS - lost))
            inverse = np.linalg.inv(matrix)
        w = (inverse @ right)[:rows]
        waiting = np.where(lost < COLUMNS, limits[np.arange(rows), np.minimum(lost, COLUMNS - 1)], np.inf)
        load = np.where(w > 0, waiting / np.where(w > 0, w, 1.0), np.inf)
        first = int(np.argmin(load))
        forces.append(load[first])
        lost[first] += 1
        # a spring is one column of the system: the inverse changes by a product of two vectors
        change = -STIFFNESS * np.concatenate([band.green[:, first], [1.0, band.x[first] / band.x[-1]]])
        moved = inverse @ change
        inverse -= np.outer(moved, inverse[first]) / (1.0 + moved[first])
    yield "Z", "peak uN", max(forces)
    yield "Z", "event of the peak", int(np.argmax(forces)) + 1


def softening(foundation, first, last):
    """The largest end force of a half-infinite beam on a foundation that softens: the stiffness of the part behind is put in as a matrix."""
    lam = (foundation / (4 * BENDING)) ** 0.25
    mu = (foundation * first / ((last - first) * BENDING)) ** 0.25
    exponents = mu * np.array([1, -1, 1j, -1j])

    def end(zone):
        # w = last + Σ c e^(r x): w''(0) = 0, w(zone) = first, and w'' + 2λw' + 2λ²w = 0 = w''' - 2λ²w' - 4λ³w at the zone's end
        e = np.exp(exponents * zone)
        r = exponents
        matrix = np.array([r**2 / mu**2, e, (r**2 + 2 * lam * r) * e / mu**2, (r**3 - 2 * lam**2 * r) * e / mu**3])
        right = np.array([0, first - last, -2 * lam**2 * first / mu**2, 4 * lam**3 * first / mu**3])
        c = np.linalg.solve(matrix, right)
        return BENDING * float(np.real(np.sum(r**3 * c))), last + float(np.real(np.sum(c)))

    best = minimize_scalar(lambda z: -end(z)[0], bounds=(1e-3 / mu, 2 / mu), method="bounded", options={"xatol": 1e-10 / mu})
    return *end(best.x), float(best.x)


def toes():
    energy = DENSITY * STIFFNESS * REACH**2 / 2 * WIDTH
    for tension in (0.0, 3000.0, 60000.0):
        for degrees in (10, 30, 90, 150):
            cos = math.cos(math.radians(degrees))

            def excess(p, tension=tension, cos=cos):
                return p * p / (2 * AXIAL) + p * (1 - (1 + tension / AXIAL) * cos) + tension**2 / (2 * AXIAL) - energy

            yield "T1", f"tension {tension:.0f} at {degrees} deg uN", brentq(excess, 0.0, 1e6, xtol=1e-12, rtol=1e-14)
    yield "T1", "peels by itself uN", math.sqrt(2 * AXIAL * energy)
    spring = COLUMNS * STIFFNESS
    band, x = Band(ROWS, PITCH, BENDING), PITCH * np.arange(ROWS)
    line = -np.abs(x[:, None] - x[None, :]) / (2 * AXIAL)
    matrix = np.zeros((ROWS + 1, ROWS + 1))
    matrix[:ROWS, :ROWS], matrix[:ROWS, ROWS], matrix[ROWS, :ROWS] = np.eye(ROWS) + line * 3 * spring, -1.0, 3 * spring
    for sheared, row in [(0, 0), (0, 15), (0, 29), (15, 15), (29, 29)]:
        normal = spring * band.deflection(np.full(ROWS, spring), at=row)
        shear = 3 * spring * np.linalg.solve(matrix, np.append(line[:, sheared], 1.0))[:ROWS]
        lifted = normal > 0
        share = float(np.min(shear[lifted] / normal[lifted]))
        angle = math.degrees(math.atan(math.tan(CONE) * share))
        yield "T2", f"sheared at row {sheared} lifted at row {row} deg", angle
    pad, whole = Band(12, 500.0, 2e11), ROWS * spring
    limit = math.tan(CONE) * 2e6 / 12
    for number, (force, _) in enumerate(losses(pad, whole, limit / whole, 5), 1):
        yield "T3", f"end lifted loss {number} uN", force
    w = pad.deflection(np.full(12, whole), moment=True)
    yield "T3", "moment that lifts the end uN um", limit / whole / max(w)
    yield "T3", "moment that presses the end uN um", limit / whole / max(-w)


def rows():
    return [
        {"case": case, "quantity": quantity, "value": value}
        for part in (arrays, patches, lamellae, toes)
        for case, quantity, value in part()
    ]


REMARKS = ["Patch, lamella and toe by closed forms and Green's functions, written by toe.py; µm, µN, MPa."]

if __name__ == "__main__":
    tables.run(__doc__.splitlines()[0], [("toe.csv", REMARKS, rows)], relative=1e-7)

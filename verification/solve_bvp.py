#!/usr/bin/env python3
"""The strip of 100 nm by scipy.integrate.solve_bvp with an arc length around it: seconds against error, beside those of peel. Writes solve_bvp.csv.

    python verification/solve_bvp.py --peel target/release/peel      # about 3 minutes
    python verification/solve_bvp.py --check                         # errors of the looser tolerances against the table; no peel: 8 s

From rest over the peak and the snap-off to where P has come back to zero (peel: `pivoting`). The strong form is that of collocation/law.py; unknowns g, theta,
V, M over S (nm, rad, nN, nN nm); P is an unknown parameter of solve_bvp:

    V(0) = M(0) = M(L) = 0,   V(L) = P,   d . [(u - u0)/(r0 + |u0|), (P - P0)/(w + |P0|)] = step

where (u0, P0) is the last point, d the direction of the last secant in these scales, w the strip's work of adhesion. All Jacobians are given. A step starts
from the secant, on a mesh drawn anew from the residuals of the last one (solve_bvp itself never takes a node away); its length follows from how far the
secant missed the gaps and from how far the path turned. Peak and snap-off are boundary value problems of their own, z and its derivative dz along the path:

    dz' = J(z) dz,   dV(0) = dM(0) = dM(L) = 0   with   dP = 0, du = 1 (peak)   or   du = 0, dP = 1 (snap-off)

so that they are as good as the tolerance; from the point of the path next to them.
"""
import argparse
import json
import os
import subprocess
import sys
import time

import collocation  # noqa: F401  first: one thread
import numpy as np
from scipy.integrate import solve_bvp

import tables
from collocation.law import Strip, field, potential, rest_gap

REMARKS = (
    "The strip of 100 nm from rest over the peak and the snap-off to P = 0, by verification/solve_bvp.py: scipy's solve_bvp with an arc length, and peel run.",
    "asked: tol of solve_bvp, accuracy.relative of peel. error: the larger of peak_error and snap_off_error, the largest relative error of u and P",
    "there against strip.csv (12 digits: below 2e-12 it is their rounding). seconds: one thread, best of 12 runs (scipy: of as many as 20 s hold);",
    "scipy: CPU, with peak and snap-off; peel: timing.solve_s, with the end of the snap-back and all error bounds too. points: of the path.",
    "nodes: most of any mesh of the path (scipy), elements * order + 1 (peel).",
)
TABLE = "solve_bvp.csv"
SCIPY, PEEL = "scipy solve_bvp", "peel"
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9)
RELATIVES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10)
CHECKED = 1e-7                                                        # --check: tolerances down to this one
FACTOR = 3.0                                                          # --check: on a committed error
RUNS = 12
ENOUGH = 20.0                                                         # seconds: no further run of scipy at a tolerance that took so long

STRIP = Strip()                                                       # the paper's
R0, REST = STRIP.r0, rest_gap(STRIP)
ADHESION = -STRIP.width * float(potential(STRIP, np.float64(REST), np.float64(0.0))[0])
G, THETA, V, M = range(4)
FIRST = 0.01                                                          # nm: the first point of the path
MISS = 0.2                                                            # of a gap: what the secant may miss it by
TURN = 15.0                                                           # degrees a step should turn by at most; it is done again from WRONG on
WRONG = 50.0
HALVINGS = 6
MOST_POINTS, MOST_NODES = 1000, 100000


def slope(z):
    """z' at H = 0: collocation.law.field without the second derivatives that it computes on the way, most of its time. z[component, place]."""
    c, (g, th, V_, M_) = STRIP, z
    co, si, h = np.cos(th), np.sin(th), c.height
    r1 = g + h * np.sin(0.5 * th) ** 2
    y = g + 0.5 * h
    r2 = y + 0.5 * h * co
    m = R0 * R0 / (r1 * r2)                                           # p q of law.py, and its s = p + q, Q = p^2 + q^2
    s = 2.0 / R0 * y * m
    Q = s * s - 2.0 * m
    B = Q * (Q * Q - 2.0 * m * m) / 360.0 - 1.0 / 6.0
    BQ = (3.0 * Q * Q - 2.0 * m * m) / 360.0
    k = c.width * c.K * h / R0
    Gs = k * m * (B + 2.0 * s * s * BQ)
    G_m = k * s * (B - m * (2.0 * BQ + m * Q / 90.0)) + Gs * 2.0 / R0 * y
    i = m * m / (R0 * R0)
    adhesion_y = -2.0 * y * i * G_m + Gs * 2.0 / R0 * m
    adhesion_theta = -0.5 * h * h * si * co * i * G_m
    stretch, shear = 1.0 + V_ * si / c.EA, V_ * co / c.GA
    return np.array([stretch * si + shear * co, M_ / c.EI, adhesion_y, (shear * si - stretch * co) * V_ + adhesion_theta])


class Equations:
    """z' = f(z), the parameter P, and the arc length."""

    def __init__(self, at, direction, scale, step):
        self.at, self.weight, self.step = at, direction / scale, step

    def slope(self, s, z, p):
        return slope(z)

    def slope_jacobian(self, s, z, p):
        return field(STRIP, z.T, 0.0)[1].transpose(1, 2, 0), np.zeros((4, 1, len(s)))

    def ends(self, a, b, p):
        along = self.weight @ (np.array([b[G], p[0]]) - self.at) - self.step
        return np.array([a[V], a[M], b[M], b[V] - p[0], along])

    def ends_jacobian(self, a, b, p):
        left, right, parameter = np.zeros((5, 4)), np.zeros((5, 4)), np.zeros((5, 1))
        left[0, V] = left[1, M] = right[2, M] = right[3, V] = 1.0
        parameter[3] = -1.0
        right[4, G], parameter[4] = self.weight
        return left, right, parameter

    def solve(self, s, z, P, tol, most):
        """None where solve_bvp does not get there."""
        try:
            with np.errstate(all="ignore"):
                found = solve_bvp(self.slope, self.ends, s, z, [P], fun_jac=self.slope_jacobian, bc_jac=self.ends_jacobian, tol=tol, max_nodes=most)
        except (ValueError, np.linalg.LinAlgError):                   # a trial step below the surface
            return None
        return found if found.success else None


class TurningPoint:
    """z and dz with dz' = J(z) dz; on the right end (du, dP) = (1, 0) at the peak, (0, 1) at the snap-off."""

    def __init__(self, du, dP):
        self.du, self.dP = du, dP

    def slope(self, s, y, p):
        f, J, _ = field(STRIP, y[:4].T, 0.0)
        return np.concatenate([f.T, np.matmul(J, y[4:].T[:, :, None])[:, :, 0].T])

    def slope_jacobian(self, s, y, p):
        z, dz = y[:4].T, y[4:].T
        h = 1e-6                                                      # a difference will do: of the Jacobian's derivative, in Newton's matrix alone
        bend = (field(STRIP, z + h * dz, 0.0)[1] - field(STRIP, z - h * dz, 0.0)[1]) / (2.0 * h)
        out = np.zeros((8, 8, len(s)))
        out[:4, :4] = out[4:, 4:] = field(STRIP, z, 0.0)[1].transpose(1, 2, 0)
        out[4:, :4] = bend.transpose(1, 2, 0)
        return out, np.zeros((8, 1, len(s)))

    def ends(self, a, b, p):
        return np.array([a[V], a[M], b[M], b[V] - p[0], a[4 + V], a[4 + M], b[4 + M], b[4 + G] - self.du, b[4 + V] - self.dP])

    def ends_jacobian(self, a, b, p):
        left, right, parameter = np.zeros((9, 8)), np.zeros((9, 8)), np.zeros((9, 1))
        for row, column in ((0, V), (1, M), (4, 4 + V), (5, 4 + M)):
            left[row, column] = 1.0
        for row, column in ((2, M), (3, V), (6, 4 + M), (7, 4 + G), (8, 4 + V)):
            right[row, column] = 1.0
        parameter[3] = -1.0
        return left, right, parameter

    def locate(self, near, before, after, tol):
        """(u, P) from three points of the path."""
        way = after.z(near.s) - before.z(near.s)
        y = np.vstack([near.z(near.s), way / way[G if self.du else V, -1]])
        found = solve_bvp(self.slope, self.ends, near.s, y, [near.uP[1]], fun_jac=self.slope_jacobian, bc_jac=self.ends_jacobian,
                          tol=tol, max_nodes=MOST_NODES)
        if not found.success:
            raise RuntimeError(f"turning point near u = {near.uP[0]:g} nm: {found.message}")
        return found.y[G, -1] - REST, found.p[0]


class Point:
    """A point of the path: mesh s, z(s), (u, P), residuals of the sub-intervals."""

    def __init__(self, s, z, u, P, residuals):
        self.s, self.z, self.uP, self.residuals = s, z, np.array([u, P]), residuals

    @classmethod
    def of(cls, found):
        return cls(found.x, found.sol, found.y[G, -1] - REST, found.p[0], found.rms_residuals)

    def mesh(self, tol):
        """A mesh of which every sub-interval has a third of the residual that is allowed; a little finer next to fine parts."""
        h = np.diff(self.s)
        density = np.maximum((np.maximum(self.residuals, 1e-4 * tol) / (tol / 3.0)) ** 0.25 / h, 20.0 / STRIP.length)
        wide = density.copy()
        wide[1:] = np.maximum(wide[1:], 0.7 * density[:-1])
        wide[:-1] = np.maximum(wide[:-1], 0.7 * density[1:])
        count = np.append(0.0, np.cumsum(wide * h))
        s = np.interp(np.linspace(0.0, count[-1], int(np.ceil(count[-1])) + 1), count, self.s)
        s[-1] = STRIP.length
        return s


class Path:
    """All points from rest to P = 0, and (u, P) of peak and snap-off."""

    def __init__(self, tol, verbose=False):
        self.tol, self.verbose = tol, verbose
        self.found, self.failures = {}, 0
        self.points = self.start()
        step = 2.0 * np.hypot(*((self.points[1].uP - self.points[0].uP) / self.scale()))
        while self.points[-1].uP[1] > 0.0:
            if len(self.points) >= MOST_POINTS:
                raise RuntimeError(f"{MOST_POINTS} points and P = {self.points[-1].uP[1]:g} nN")
            step = self.advance(step)
            self.look_for_turn()

    def scale(self):
        """What u and P are measured with at the last point."""
        return np.array([R0, ADHESION]) + np.abs(self.points[-1].uP)

    def start(self):
        """Rest, and the first point by the displacement."""
        s = np.linspace(0.0, STRIP.length, 41)
        z = np.zeros((4, len(s)))
        z[G] = REST
        self.points = [Point(s, lambda at: np.repeat(z[:, :1], len(at), axis=1), 0.0, 0.0, np.zeros(len(s) - 1))]
        found = Equations(np.array([REST, 0.0]), np.array([1.0, 0.0]), np.ones(2), FIRST).solve(s, z, 0.0, self.tol, MOST_NODES)
        if found is None:
            raise RuntimeError("no first point")
        return self.points + [Point.of(found)]

    def advance(self, step):
        """Appends a point; the next step. Where no step is short enough (the secant is off the path in a sharp bend) the last point is taken back."""
        before, last = self.points[-2:]
        scale = self.scale()
        way = (last.uP - before.uP) / scale
        length = np.hypot(*way)
        s = last.mesh(self.tol)
        z = last.z(s)
        secant = (z - before.z(s)) / length
        grip = last.uP + [REST, 0.0]                                  # as the arc length has it: g, not u
        for _ in range(HALVINGS):
            guess, P = z + step * secant, last.uP[1] + step / length * (last.uP[1] - before.uP[1])
            found = Equations(grip, way / length, scale, step).solve(s, guess, P, self.tol, max(4 * len(s), 200))
            if found is not None:
                new = Point.of(found)
                turned = angle((new.uP - last.uP) / scale, way)
                if turned < WRONG:
                    self.points.append(new)
                    gap = new.z(s)[G]
                    missed = np.max(np.abs(guess[G] - gap) / np.abs(gap))
                    self.say(f"{len(self.points):4d} u={new.uP[0]:.8g} P={new.uP[1]:.8g} step={step:.3g} missed={missed:.2g} turned={turned:.1f} "
                             f"nodes={len(new.s)}")
                    return step * float(np.clip(min(np.sqrt(MISS / max(missed, 1e-9)), TURN / max(turned, 1e-6)), 0.25, 2.0))
            step *= 0.5
            self.failures += 1
        if len(self.points) == 2 or self.failures > MOST_POINTS:
            raise RuntimeError(f"stuck at u = {last.uP[0]:g} nm")
        self.points.pop()
        self.say(f"     taken back: u={last.uP[0]:.8g}")
        return 0.5 * length

    def look_for_turn(self):
        """The first maximum of P, then the first of u."""
        before, middle, new = self.points[-3:]
        kind, column = ("peak", 1) if "peak" not in self.found else ("snap_off", 0)
        if kind not in self.found and before.uP[column] < middle.uP[column] >= new.uP[column]:
            point = TurningPoint(1.0, 0.0) if kind == "peak" else TurningPoint(0.0, 1.0)
            self.found[kind] = point.locate(middle, before, new, self.tol)
            self.say(f"  {kind} u={self.found[kind][0]:.13g} P={self.found[kind][1]:.13g}")

    def say(self, text):
        if self.verbose:
            print("   ", text, flush=True)


def angle(a, b):
    """Between two directions, in degrees."""
    return np.degrees(np.arccos(np.clip(a @ b / (np.hypot(*a) * np.hypot(*b)), -1.0, 1.0)))


def reference():
    """(u, P) of peak and snap-off in strip.csv."""
    case = {"length_nm": "100", "bending_stiffness_factor": "1", "grip_rotation": "free", "line_load": "full", "far_face": "true"}
    row, = (row for row in tables.read("strip.csv") if all(row[key] == value for key, value in case.items()))
    return {kind: (float(row[f"{name}_displacement_nm"]), float(row[f"{name}_force_nN"])) for kind, name in (("peak", "peak"), ("snap_off", "lp1"))}


def row_of(program, asked, found, seconds, points, nodes):
    errors = {kind: max(abs(a / b - 1.0) for a, b in zip(found[kind], exact)) for kind, exact in reference().items()}
    short = lambda value: float(f"{value:.2e}")
    return {"program": program, "asked": f"{asked:.0e}".replace("e-0", "e-"), "error": short(max(errors.values())), "peak_error": short(errors["peak"]),
            "snap_off_error": short(errors["snap_off"]), "seconds": float(f"{seconds:.3g}"), "points": points, "nodes": nodes}


def by_scipy(tol, runs, verbose=False):
    best, spent = np.inf, 0.0
    for _ in range(runs):
        started = time.process_time()
        path = Path(tol, verbose)
        seconds = time.process_time() - started
        best, spent = min(best, seconds), spent + seconds
        if spent > ENOUGH:
            break
    return row_of(SCIPY, tol, path.found, best, len(path.points), max(len(point.s) for point in path.points))


def by_peel(peel, relative, runs):
    scene = tables.HERE.parent / "scenes" / "strip-100nm.toml"
    command = [peel, "run", str(scene), "--set", f"accuracy.relative={relative:g}", "--json"]
    said = [json.loads(subprocess.run(command, capture_output=True, text=True, check=True, env=os.environ | {"RAYON_NUM_THREADS": "1"}).stdout)
            for _ in range(runs)]
    found = {kind: (said[0][key]["displacement_nm"], said[0][key]["force_nN"]) for kind, key in (("peak", "initiation_peak"), ("snap_off", "snap_off"))}
    path = said[0]["path"]
    return row_of(PEEL, relative, found, min(one["timing"]["solve_s"] for one in said), path["points"], path["elements"] * path["order"] + 1)


def seconds_at(rows, program, error):
    """Of the runs that no other beats in both, interpolated in logarithms; None outside of them."""
    mine = sorted((row["error"], row["seconds"]) for row in rows if row["program"] == program)
    front = [one for one in mine if not any(other[0] <= one[0] and other[1] < one[1] for other in mine)]
    errors, seconds = np.log(np.array(front)).T
    return float(np.exp(np.interp(np.log(error), errors, seconds))) if errors[0] <= np.log(error) <= errors[-1] else None


def write(peel, verbose):
    rows = []
    for tol in TOLERANCES:
        rows.append(by_scipy(tol, RUNS, verbose))
        print(*rows[-1].values(), flush=True)
    for relative in RELATIVES if peel else ():
        rows.append(by_peel(peel, relative, RUNS))
        print(*rows[-1].values(), flush=True)
    tables.write(TABLE, REMARKS, rows)
    print(f"wrote verification/{TABLE}: {len(rows)} rows")
    for error in 10.0 ** np.arange(-5, -12, -1) if peel else ():
        slow, fast = (seconds_at(rows, program, error) for program in (SCIPY, PEEL))
        if slow and fast:
            print(f"error {error:.0e}: scipy {slow:.3g} s, peel {1e3 * fast:.3g} ms, ratio {slow / fast:.3g}")


def check(verbose):
    """How many errors are larger than FACTOR times those of the table."""
    committed = {float(row["asked"]): row for row in tables.read(TABLE) if row["program"] == SCIPY}
    wrong = 0
    again = [tol for tol in TOLERANCES if tol >= CHECKED]
    for tol in again:
        now = by_scipy(tol, 1, verbose)
        for column in ("error", "peak_error", "snap_off_error"):
            was = float(committed[tol][column]) if tol in committed else float("nan")
            if not now[column] <= FACTOR * was:
                wrong += 1
                print(f"{TABLE}, tol {tol:g}, {column}: committed {was:g}, computed {now[column]:g}")
    print(f"{TABLE}: {len(again)} rows recomputed, {wrong} errors larger than {FACTOR:g} times the committed ones")
    return wrong


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--check", action="store_true", help="recompute the looser tolerances and hold their errors against the table; exit 1 on a mismatch")
    options.add_argument("--peel", metavar="PATH", help="the binary that is timed beside it; without it the table gets no rows of peel")
    options.add_argument("--verbose", action="store_true", help="print every point of every path")
    options = options.parse_args()
    if options.check:
        sys.exit(1 if check(options.verbose) else 0)
    write(options.peel, options.verbose)


if __name__ == "__main__":
    main()

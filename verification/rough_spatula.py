#!/usr/bin/env python3
"""Spatulae on ground that is not flat: where they lie without a force, and the first largest force. Writes rough_spatula.csv.

    python verification/rough_spatula.py              # minutes
    python verification/rough_spatula.py --check      # every case at a looser tolerance against the table
    python verification/rough_spatula.py --quick      # the same for the first three

The strong form of rough.py with the section and the rest curvature k0(S) of collocation/shapes.py, theta' = M/EI + k0, by scipy's
solve_bvp with nodes where the outline changes its formula. The start is reached from the one on flat ground, and that from the shape free
of stress by adhesion that grows from 1e-5 of its strength; what lies on flat ground is bent over to the other. Pulled
at the angle a, with u = dx cos a + dy sin a of the end face from the start and no force across, P = H cos a + V sin a; a grip that is
fixed holds the rotation of the start. The nearest point is the best of several by Newton's method, and its change an imaginary part.
"""
import argparse
import csv
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.integrate import solve_bvp
from scipy.optimize import minimize_scalar

from collocation.shapes import Spatula

TABLE = Path(__file__).with_name("rough_spatula.csv")
TINY = 1e-30
ROUGH, CLOSE = 1e-5, 2e-4                                             # tolerance on the way to the largest force, and how near that ends
GIVEN = 13                                                            # columns that define a case

DEFAULT = Spatula()
SMALL = Spatula(pad_length=80.0, neck_length=60.0, shaft_length=150.0, bend_length=30.0, tip_width=60.0, neck_width=20.0,
                shaft_diameter=20.0, pad_thickness=5.0)


@dataclass(frozen=True)
class Ground:
    """Height from valley to crest and wavelength of a sinusoid, or the radius of a cylinder; x of a crest or of the top."""
    shape: str
    height: float
    length: float
    offset: float

    def level(self):
        """As good as flat."""
        return replace(self, height=1e-12) if self.shape == "sinusoid" else replace(self, length=1e12)

    def line(self, distance, places):
        """The line at this distance from above x = 0: x, y, slope and curvature at these lengths along it."""
        if self.shape == "cylinder":
            far = self.length + distance
            turn = -np.arcsin(-self.offset / far) - places / far
            return self.offset - far * np.sin(turn), far * np.cos(turn) - self.length, turn, 0.0 * places - 1.0 / far
        s = np.linspace(-0.5 * self.length - distance, places[-1] + self.length, 400001)
        f0, f1, _ = self.curve(s)
        slope = np.arctan(f1)
        x, y = s - distance * np.sin(slope), f0 + distance * np.cos(slope)
        along = np.append(0.0, np.cumsum(np.hypot(np.diff(x), np.diff(y))))
        places = places + np.interp(0.0, x, along)
        return *(np.interp(places, along, v) for v in (x, y, slope)), np.interp(places, along, np.gradient(slope, along))

    def curve(self, s):
        k, a = 2.0 * np.pi / self.length, 0.5 * self.height
        p = k * (s - self.offset)
        return a * (np.cos(p) - 1.0), -a * k * np.sin(p), -a * k * k * np.cos(p)

    def step(self, s, x, y):
        """Newton's method for the nearest point."""
        f0, f1, f2 = self.curve(s)
        return s - (s - x + (f0 - y) * f1) / (1.0 + f1 * f1 + (f0 - y) * f2)

    def nearest(self, x, y):
        """Where the nearest point is, of real x and y."""
        if self.shape == "cylinder":
            return None
        high = np.abs(y) * self.height * (2.0 * np.pi / self.length) ** 2 > 1.0     # several may be near
        s = x.copy()
        if high.any():
            tried = x[high][:, None] + self.length * np.linspace(-0.6, 0.6, 97)
            f = self.curve(tried)[0]
            best = np.argmin((tried - x[high][:, None]) ** 2 + (f - y[high][:, None]) ** 2, axis=1)
            s[high] = tried[np.arange(len(best)), best]
        for _ in range(12):
            s = s + np.clip(self.step(s, x, y) - s, -0.02 * self.length, 0.02 * self.length)
        return s

    def foot(self, s, x, y):
        """Distance, and sine and cosine of the slope at the nearest point, from that of the real parts."""
        if self.shape == "cylinder":
            dx, dy = x - self.offset, y + self.length
            rho = np.sqrt(dx * dx + dy * dy)
            return (dx * dx + y * (y + 2.0 * self.length)) / (rho + self.length), -dx / rho, dy / rho
        s = self.step(s, x, y)
        f0, f1, _ = self.curve(s)
        c = 1.0 / np.sqrt(1.0 + f1 * f1)
        return (y - f0) * c - (x - s) * f1 * c, f1 * c, c


class Case:
    def __init__(self, spatula, ground, angle=90.0):
        self.strength = 1.0
        self.spatula, self.ground, self.ends = spatula, ground, np.array(spatula.ends)
        self.up, self.along = np.sin(np.radians(angle)), np.sin(np.radians(90.0 - angle))
        p = spatula
        self.words = (ground.shape, ground.height, ground.length, ground.offset, p.pad_length, p.neck_length, p.shaft_length,
                      p.bend_length, p.tip_width, p.shaft_diameter, p.pad_thickness, p.rotation, angle)

    def W(self, r):
        q = self.spatula.r0 / r
        return self.strength * self.spatula.K * (q**8 / 360.0 - q**2 / 6.0)

    def psi(self, h, s, x, y, th):
        d, sine, cosine = self.ground.foot(s, x, y)
        cosine = np.cos(th) * cosine + np.sin(th) * sine
        half = 0.5 * h * cosine
        return (self.W(d - half) - self.W(d + half)) / cosine

    def slope(self, S, z):
        x, y, th, H, V, M = z
        c = self.spatula.at(S)
        s = self.ground.nearest(x, y)
        px = np.imag(self.psi(c.height, s, x + 1j * TINY, y + 0j, th)) / TINY
        py = np.imag(self.psi(c.height, s, x + 0j, y + 1j * TINY, th)) / TINY
        pt = np.imag(self.psi(c.height, s, x, y, th + 1j * TINY)) / TINY
        co, si = np.cos(th), np.sin(th)
        N, Q = H * co + V * si, V * co - H * si
        e, g = N / c.EA, Q / c.GA
        return np.array([(1 + e) * co - g * si, (1 + e) * si + g * co, M / c.EI + c.bend, c.width * px, c.width * py,
                         N * g - Q * (1 + e) + c.width * pt])

    def energy(self, solution):
        points, weights = np.polynomial.legendre.leggauss(6)
        half = 0.5 * np.diff(solution.x)
        S = (0.5 * (solution.x[1:] + solution.x[:-1])[:, None] + half[:, None] * points).ravel()
        x, y, th, H, V, M = solution.sol(S)
        c = self.spatula.at(S)
        N, Q = H * np.cos(th) + V * np.sin(th), V * np.cos(th) - H * np.sin(th)
        density = 0.5 * (N**2 / c.EA + Q**2 / c.GA + M**2 / c.EI) + c.width * self.psi(c.height, self.ground.nearest(x, y), x, y, th)
        return float(np.sum(density.reshape(-1, 6) * weights * half[:, None]))

    def free(self, S):
        """Free of stress, on flat ground."""
        gap, slope = self.spatula.free(S)
        x, w = np.polynomial.legendre.leggauss(8)
        half = 0.5 * np.diff(S)
        inner = (S[:-1, None] + half[:, None] * (1.0 + x)).ravel()
        along = np.append(0.0, np.cumsum(half * (np.cos(self.spatula.form(inner).slope).reshape(-1, 8) @ w)))
        return np.array([along, gap + 0.5 * self.spatula.at(S).height, slope, 0.0 * S, 0.0 * S, 0.0 * S])

    def solve(self, S, z, tol, start=None, u=0.0):
        """Displaced by u from a start, or without a force and a moment."""
        if start is None:
            ends = lambda a, b: np.array([a[0], a[4], a[5], b[3], b[4], b[5]])
        else:
            x0, y0, th0 = start.y[:3, -1]
            fixed = self.spatula.rotation == "fixed"
            ends = lambda a, b: np.array([a[0], a[4], a[5], b[3] * self.up - b[4] * self.along,
                                          (b[0] - x0) * self.along + (b[1] - y0) * self.up - u, b[2] - th0 if fixed else b[5]])
        found = solve_bvp(self.slope, ends, S, z, tol=tol, max_nodes=30000 if start is None or tol < ROUGH else 4000)
        if not found.success:
            raise RuntimeError(f"{self.words}: {found.message}")
        return found

    def force(self, solution):
        return float(solution.y[3, -1] * self.along + solution.y[4, -1] * self.up)

    def bent(self, S, z):
        """What lies on flat ground, on this."""
        c = self.spatula.at(S)
        front = 1 + int(np.argmax(z[1] - 0.5 * c.height > 1.0))
        x, y, th, H, V, M = (v.copy() for v in z)
        line = np.array(self.ground.line(z[1, 0], z[0, :front]))
        above = z[1, :front] - z[1, 0]
        x[:front], y[:front] = line[0] - above * np.sin(line[2]), line[1] + above * np.cos(line[2])
        slope, last = line[2, -1], front - 1
        co, si = np.cos(slope), np.sin(slope)
        dx, dy = z[0, front:] - z[0, last], z[1, front:] - z[1, last]
        x[front:], y[front:] = x[last] + dx * co - dy * si, y[last] + dx * si + dy * co
        turns = np.append(line[2], np.full(len(S) - front, slope))
        th += turns
        M[:front] += c.EI[:front] * line[3] if np.ndim(c.EI) else c.EI * line[3]
        return np.array([x, y, th, H * np.cos(turns) - V * np.sin(turns), H * np.sin(turns) + V * np.cos(turns), M])

    def beginning(self, tol):
        pad, bend = self.spatula.pad_length, self.spatula.bend_length
        fine = lambda a, b: np.linspace(a, b, max(20, int((b - a) / (0.5 if a < pad + bend else 4.0))) + 1)
        S = np.unique(np.concatenate([fine(a, b) for a, b in zip(self.ends, self.ends[1:])]))
        z, whole = self.free(S), self.ground
        self.ground = whole.level()
        for self.strength in 10.0 ** np.linspace(-5.0, 0.0, 11):
            found = self.solve(S, z, 1e-4)
            S, z = found.x, found.y
        self.ground = whole
        return self.solve(*self.coarse(self.solve(S, self.bent(S, z), 1e-4)), tol)

    def coarse(self, found):
        """On some 800 of the nodes, and where the outline changes."""
        S = np.unique(np.concatenate([found.x[::1 + len(found.x) // 800], self.ends]))
        return S, found.sol(S)

    def run(self, tol):
        start = self.beginning(tol)
        pad = self.spatula.pad_length
        x, y = start.sol(np.array([0.0, 0.5 * pad, pad]))[:2]
        gaps = self.ground.foot(self.ground.nearest(x, y), x, y)[0] - 0.5 * self.spatula.pad_thickness
        at = lambda guess, tol, u: self.solve(*guess, tol, start, u)
        loose = at(self.coarse(start), ROUGH, 0.0)
        known, step, ahead = [(0.0, 0.0, loose)], 0.04, np.inf
        # on the way loosely, from the last two; towards the largest force of the parabola through the last three, for behind it u may turn
        while ahead > CLOSE * known[-1][0]:
            (u0, _, a), (u1, force, b) = known[-2] if len(known) > 1 else (-1.0, 0.0, loose), known[-1]
            step = min(step, 0.6 * ahead)
            S, z = self.coarse(b)
            try:
                found = at((S, z + step / (u1 - u0) * (z - a.sol(S))), ROUGH if ahead > 0.02 * u1 else 1e-7, u1 + step)
            except RuntimeError:
                found = None
            if found is not None and self.force(found) <= force and len(known) > 3:
                step = known.pop()[0] - known[-1][0]                  # that may be behind it already
            if found is None or self.force(found) <= force:
                step, ahead = 0.4 * step, np.inf
                if step < 1e-4:
                    raise RuntimeError(f"{self.words}: no way on from u = {u1}")
                continue
            known.append((u1 + step, self.force(found), found))
            step = min((1.6, 1.6, 1.6, 1.0, 0.5)[min(found.niter, 4)] * step, 0.08 * self.spatula.length)
            if len(known) > 3:
                bend, slope, _ = np.polyfit([k[0] - known[-1][0] for k in known[-3:]], [k[1] for k in known[-3:]], 2)
                ahead = -0.5 * slope / bend if bend < 0.0 and slope > 0.0 else np.inf
        near, peak, half = known[-1][2], known[-1][0] + ahead, 0.5 * ahead
        for within in (10.0 * tol, tol):
            places = peak + half * np.cos(np.pi * (np.arange(5)[::-1] + 0.5) / 5)
            forces = []
            for u in places:
                near = at(self.coarse(near), within, u)
                forces.append(self.force(near))
            line = np.polynomial.Chebyshev.fit(places, forces, 4)
            found = minimize_scalar(lambda u: -line(u), bounds=(peak - 3.0 * half, peak + 3.0 * half), method="bounded", options={"xatol": 1e-12})
            peak, force = float(found.x), float(line(found.x))
        return [self.energy(start), *gaps, *start.y[:2, -1], peak, force]


FREE = dict(rotation="free")
CASES = (
    Case(replace(SMALL, **FREE), Ground("sinusoid", 0.3, 50.0, 0.0)),
    Case(replace(SMALL, **FREE), Ground("cylinder", 0.0, 50.0, 40.0)),
    Case(SMALL, Ground("cylinder", 0.0, 200.0, 40.0), 60.0),
    Case(replace(DEFAULT, **FREE), Ground("cylinder", 0.0, 500.0, 120.0)),
    Case(DEFAULT, Ground("sinusoid", 8.0, 300.0, 0.0)),
    Case(SMALL, Ground("sinusoid", 2.0, 100.0, 0.0)),
)
SMALLS = 3
COLUMNS = (
    "shape", "height_nm", "length_of_shape_nm", "offset_nm", "pad_length_nm", "neck_length_nm", "shaft_length_nm", "bend_length_nm",
    "tip_width_nm", "shaft_diameter_nm", "pad_thickness_nm", "grip_rotation", "angle_deg",
    "start_energy_aJ", "start_gap_left_nm", "start_gap_middle_nm", "start_gap_right_nm", "start_end_x_nm", "start_end_y_nm",
    "peak_displacement_nm", "peak_force_nN",
)


def printed(values):
    """Ten digits, and of the place of the largest force seven: it is known no better."""
    *others, place, force = values
    return [*(f"{value:.10g}" for value in others), f"{place:.7g}", f"{force:.10g}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--tol", type=float, default=1e-9)
    parser.add_argument("--only", type=int, help="this case alone, printed and not written")
    args = parser.parse_args()
    if args.only is not None:
        case = CASES[args.only]
        print(*case.words, *printed(case.run(args.tol)), sep=",")
        return
    if args.check or args.quick:
        rows = list(csv.reader(line for line in open(TABLE) if not line.startswith("#")))[1:]
        worst = 0.0
        for case, row in list(zip(CASES, rows))[:SMALLS if args.quick else None]:
            found, known = case.run(1e-8), [float(cell) for cell in row[GIVEN:]]
            worst = max(worst, max(abs(a - b) / max(abs(b), 1e-3) for a, b in zip(found[:-2], known[:-2])), abs(found[-1] / known[-1] - 1))
        print(f"largest relative difference {worst:.1e} (allowed 1e-5)")
        sys.exit(int(worst > 1e-5))
    with open(TABLE, "w", newline="") as file:
        file.write("# Spatulae on ground that is not flat, by verification/rough_spatula.py (scipy's solve_bvp, no finite elements): E = 2 GPa, nu = 0.2, k = 5/6, A_H = 1e-19 J, r0 = 0.4 nm.\n")
        file.write("# Neck as wide at the pad as the shaft is thick, shaft at 45 degrees. length_of_shape_nm: wavelength or radius.\n")
        file.write("# start: without a force; gaps of the axis less h/2 at the left end, in the middle and at the right end of the pad, x and y of the end's axis. peak: the first.\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for case in CASES:
            writer.writerow([*case.words, *printed(case.run(args.tol))])
            file.flush()


if __name__ == "__main__":
    main()

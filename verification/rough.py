#!/usr/bin/env python3
"""Strips on ground that is not flat: where they lie without a force, and the first largest force. Writes rough.csv.

    python verification/rough.py              # minutes
    python verification/rough.py --check      # the first two cases at a looser tolerance against the table

The strong form on the unknowns x, y, theta, H, V, M over S (nm, rad, nN, nN nm), by scipy's solve_bvp:

    x' = (1 + e) cos - g sin,   y' = (1 + e) sin + g cos,   theta' = M/EI,   e = N/EA,   g = Q/GA,
    N = H cos + V sin,   Q = V cos - H sin,   (H', V') = b dPsi/d(x, y),   M' = N g - Q (1 + e) + b dPsi/dtheta,
    x(0) = V(0) = M(0) = 0,   H(L) = M(L) = 0,   and V(L) = 0 at the start or y(L) given behind it.

Psi = [W(d - h/2 cos a) - W(d + h/2 cos a)]/cos a with d the distance of the axis from the ground and a = theta - phi. Nothing is derived:
the nearest point is found by Newton's method in complex numbers, and the gradient of Psi is its imaginary part for x + i 1e-30 and so on,
exact to round-off. The start is reached from the line that keeps the gap of flat ground. The largest force is the maximum of the
polynomial through P at nine Chebyshev points in y(L) around it.
"""
import argparse
import csv
import sys
from pathlib import Path

import numpy as np
from scipy.integrate import solve_bvp
from scipy.optimize import minimize_scalar

TABLE = Path(__file__).with_name("rough.csv")
A_H, R0, B, E, NU, SHEAR = 0.1, 0.4, 1.0, 2.0, 0.2, 5.0 / 6.0
TINY = 1e-30
# shape, height, wavelength or radius, offset, L, h
CASES = (
    ("sinusoid", 8.0, 100.0, 0.0, 100.0, 10.0),
    ("sinusoid", 8.0, 100.0, 30.0, 80.0, 10.0),
    ("sinusoid", 2.0, 50.0, 0.0, 100.0, 10.0),
    ("sinusoid", 0.3, 30.0, 0.0, 60.0, 20.0),
    ("cylinder", 0.0, 200.0, 0.0, 60.0, 10.0),
    ("cylinder", 0.0, 50.0, 20.0, 60.0, 5.0),
)
COLUMNS = (
    "shape", "height_nm", "length_of_shape_nm", "offset_nm", "strip_length_nm", "strip_height_nm",
    "start_energy_aJ", "start_gap_left_nm", "start_gap_middle_nm", "start_gap_right_nm", "start_end_x_nm", "start_end_y_nm",
    "peak_displacement_nm", "peak_force_nN",
)


def W(r):
    q = R0 / r
    return A_H / (2.0 * np.pi * R0**2) * (q**8 / 360.0 - q**2 / 6.0)


class Ground:
    def __init__(self, shape, height, length, offset):
        self.shape, self.height, self.length, self.offset = shape, height, length, offset

    def foot(self, x, y):
        """Distance and angle of the nearest point; complex where x or y is."""
        if self.shape == "cylinder":
            dx, dy = x - self.offset, y + self.length
            rho = np.sqrt(dx * dx + dy * dy)
            return rho - self.length, -dx / rho, dy / rho
        k, a = 2.0 * np.pi / self.length, 0.5 * self.height
        f = lambda s: (a * (np.cos(k * (s - self.offset)) - 1.0), -a * k * np.sin(k * (s - self.offset)), -a * k * k * np.cos(k * (s - self.offset)))
        s = x + 0.0 * y                                               # so near the ground there is one nearest point, and Newton's method finds it
        for _ in range(8):
            f0, f1, f2 = f(s)
            s = s - (s - x + (f0 - y) * f1) / (1.0 + f1 * f1 + (f0 - y) * f2)
        f0, f1, _ = f(s)
        c = 1.0 / np.sqrt(1.0 + f1 * f1)
        return (y - f0) * c - (x - s) * f1 * c, f1 * c, c


class Case:
    def __init__(self, shape, height, length, offset, L, h):
        self.words = (shape, height, length, offset, L, h)
        self.ground, self.L, self.h = Ground(shape, height, length, offset), L, h
        self.EA, self.EI, self.GA = E * h * B, E * h**3 / 12.0 * B, SHEAR * E / (2.0 * (1.0 + NU)) * h * B

    def psi(self, x, y, th):
        d, s, c = self.ground.foot(x, y)
        cosine = np.cos(th) * c + np.sin(th) * s
        half = 0.5 * self.h * cosine
        return (W(d - half) - W(d + half)) / cosine

    def slope(self, S, z):
        x, y, th, H, V, M = z
        px = np.imag(self.psi(x + 1j * TINY, y + 0j, th + 0j)) / TINY
        py = np.imag(self.psi(x + 0j, y + 1j * TINY, th + 0j)) / TINY
        pt = np.imag(self.psi(x + 0j, y + 0j, th + 1j * TINY)) / TINY
        co, si = np.cos(th), np.sin(th)
        N, Q = H * co + V * si, V * co - H * si
        e, g = N / self.EA, Q / self.GA
        return np.array([(1 + e) * co - g * si, (1 + e) * si + g * co, M / self.EI, B * px, B * py, N * g - Q * (1 + e) + B * pt])

    def energy(self, solution):
        nodes = solution.x
        points, weights = np.polynomial.legendre.leggauss(6)
        half = 0.5 * np.diff(nodes)
        S = (0.5 * (nodes[1:] + nodes[:-1])[:, None] + half[:, None] * points).ravel()
        x, y, th, H, V, M = solution.sol(S)
        N, Q = H * np.cos(th) + V * np.sin(th), V * np.cos(th) - H * np.sin(th)
        density = 0.5 * (N**2 / self.EA + Q**2 / self.GA + M**2 / self.EI) + B * self.psi(x, y, th)
        return float(np.sum(density.reshape(-1, 6) * weights * half[:, None]))

    def guess(self, S):
        """The line at the gap of flat ground, by Euler's method in small steps."""
        d0 = 0.5 * self.h + 0.2537
        one = lambda f, x, y: [float(v[0]) for v in f(np.array([x]), np.array([y]))]
        x, y, line = 0.0, 20.0, []
        for _ in range(300):
            y -= one(self.ground.foot, x, y)[0] - d0
        here = 0.0
        for place in S:
            for _ in range(10):
                d, s, c = one(self.ground.foot, x, y)
                step = (place - here) / 10
                x, y = x + step * c, y + step * s
                d, s, c = one(self.ground.foot, x, y)
                x, y = x + (d - d0) * s, y - (d - d0) * c
            here = place
            line.append((x, y, np.arctan2(s, c), 0.0, 0.0, 0.0))
        return np.array(line).T

    def solve(self, S, z, up, tol):
        """At y(L) = up, or without a force where that is None."""
        last = (lambda b: b[4]) if up is None else (lambda b: b[1] - up)
        ends = lambda a, b: np.array([a[0], a[4], a[5], b[3], b[5], last(b)])
        for within in (1e-4, tol):
            found = solve_bvp(self.slope, ends, S, z, tol=within, max_nodes=60000)
            if not found.success:
                raise RuntimeError(f"{self.words}: {found.message}")
            S, z = found.x, found.y
        return found

    def run(self, tol):
        S = np.linspace(0.0, self.L, 400)
        start = self.solve(S, self.guess(S), None, tol)
        x, y, th = start.sol(np.array([0.0, 0.5 * self.L, self.L]))[:3]
        gaps = self.ground.foot(x, y)[0] - 0.5 * self.h
        at = lambda u, near: self.solve(near.x, near.y, y[2] + u, tol)
        known = [(0.0, 0.0, start)]
        step = 0.04
        while len(known) < 3 or known[-1][1] > known[-2][1]:
            u = known[-1][0] + step
            solution = at(u, known[-1][2])
            known.append((u, float(solution.y[4, -1]), solution))
            step *= 1.15
            if len(known) > 60:
                raise RuntimeError(f"{self.words}: no largest force")
        low, high = known[-3][0], known[-1][0]
        for width in (1.0, 0.25):
            middle, half = 0.5 * (low + high), 0.5 * (high - low) * width
            if width < 1.0:
                middle = peak
            places = middle + half * np.cos(np.pi * (np.arange(9) + 0.5) / 9)
            forces = [float(at(u, known[-2][2]).y[4, -1]) for u in places]
            line = np.polynomial.Chebyshev.fit(places, forces, 8)
            found = minimize_scalar(lambda u: -line(u), bounds=(middle - half, middle + half), method="bounded", options={"xatol": 1e-12})
            peak, force = float(found.x), float(line(found.x))
        return [self.energy(start), *gaps, x[2], y[2], peak, force]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--tol", type=float, default=1e-9)
    args = parser.parse_args()
    if args.check:
        rows = list(csv.reader(line for line in open(TABLE) if not line.startswith("#")))[1:3]
        worst = 0.0
        for case, row in zip(CASES, rows):
            found, known = Case(*case).run(1e-7), [float(cell) for cell in row[6:]]
            worst = max(worst, max(abs(a - b) / max(abs(b), 1e-3) for a, b in zip(found[:-2], known[:-2])), abs(found[-1] / known[-1] - 1))
        print(f"largest relative difference {worst:.1e} (allowed 1e-5)")
        sys.exit(int(worst > 1e-5))
    with open(TABLE, "w", newline="") as file:
        file.write("# Strips on ground that is not flat, by verification/rough.py (scipy's solve_bvp, no finite elements): E = 2 GPa, nu = 0.2, k = 5/6, b = 1 nm, A_H = 1e-19 J, r0 = 0.4 nm.\n")
        file.write("# length_of_shape_nm: wavelength of a sinusoid, radius of a cylinder. start: without a force, conformed; gaps of the axis less h/2 at S = 0, L/2 and L. peak: the first.\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for case in CASES:
            fine, coarse = Case(*case).run(args.tol), Case(*case).run(30.0 * args.tol)
            print(case, *(f"{value:.12g}" for value in fine), "| differences", *(f"{a - b:.1e}" for a, b in zip(fine, coarse)), flush=True)
            writer.writerow([*case, *(f"{value:.10g}" for value in fine)])
            file.flush()


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Steady peeling of films that yield. Writes yielding.csv.

An infinite strip, steady in the frame of its front: what a section has been through is what lies ahead of it along S. So the film is marched from its far
end, at rest, through the front into the arm, fibre by fibre over its height. Each fibre is elastic and perfectly plastic beside an elastic one: with the
strain e = epsilon + kappa y, its slip q and t = Eₜ/E,

    sigma/E = t e + (1 - t) p,   p = e - q between -e_y and e_y,   e_y = sigma_y/E;   q moves by what e - q would go beyond.

The rest is the strong form of collocation/law.py: g = y - h/2, theta, V, M with

    g' = y',   theta' = kappa,   V' = b Psi_g,   M' = -x' V + y' H + b Psi_theta,

where epsilon and kappa follow from N, M and the slips by Newton's method. Ahead, the film is at rest but for the two modes that grow along S; by which share
of either it leaves is found so that the arm runs out straight along its force: too little and it turns back, too much and it turns over. The film is pulled straight
up, so that H is zero. Steps are of Runge and Kutta, of fourth order; two meshes of steps and fibres agree to the digits given.

Nothing of what peelkit remembers of a section is in it. Checked besides: the balance of a unit of length that peels. In a straight arm that is

    P (1 + epsilon_arm) = w b + W,   W = the work of N d epsilon + M d kappa from where the film is ahead to the arm.
"""
import argparse
import sys
import time
from dataclasses import dataclass

from collocation import selfcheck  # noqa: F401  first: one thread
import numpy as np

import tables
from collocation import laws
from collocation.law import Strip, rest_gap

REMARKS = (
    "Steady peeling of strips that yield, by verification/yielding.py: an infinite strip of height 10 nm, width 1 nm, E = 2 GPa, nu = 0.2, k = 5/6, that",
    "slides along the substrate under an exponential law of the strength 0.124 GPa and work 0.0306 J/m2 of the van der Waals half space of 1e-19 J and 0.4 nm.",
    "yield_strength_GPa, tangent_modulus_GPa: of the film, pulled straight up. force_nN: the steady force. plastic_work_nN: what yielding leaves in a unit of",
    "length that has peeled. permanent_stretch: strain that stays in the arm, unloaded. Force and work are good to 2e-4, the stretch to 2e-3.",
)
COLUMNS = ("yield_strength_GPa", "tangent_modulus_GPa", "force_nN", "plastic_work_nN", "permanent_stretch")


@dataclass(frozen=True)
class Film:
    """A strip that yields."""
    strength: float = 0.1                # GPa
    tangent: float = 0.0                 # GPa

    strip = Strip(law="exponential", far_face=False)


class Section:
    """One section on its way through the front: its fibres."""

    def __init__(self, film, fibres):
        c = film.strip
        self.bound, self.t = film.strength / c.young, film.tangent / c.young
        self.EA, self.half = c.EA, 0.5 * c.height
        self.y = (2.0 * np.arange(fibres) + 1.0) / fibres - 1.0
        # of the middles of fibres, so that EI is what it is
        self.square = float(np.mean(self.y ** 2))
        self.y *= np.sqrt(1.0 / 3.0 / self.square)
        self.slip = np.zeros(fibres)
        self.yielded = False

    def forces(self, e, b):
        """N/EA and M/(EA h/2) at the strain e + b y, and their derivatives."""
        if not self.yielded and abs(e) + abs(b) <= self.bound:
            return e, b / 3.0, 1.0, 0.0, 1.0 / 3.0
        trial = e + b * self.y - self.slip
        p = np.clip(trial, -self.bound, self.bound)
        inside = p == trial
        t, s, n = self.t, 1.0 - self.t, self.y.size
        y = self.y[inside]
        return (t * e + s * p.sum() / n, t * b / 3.0 + s * (p @ self.y) / n, t + s * y.size / n, s * y.sum() / n, t / 3.0 + s * (y @ y) / n)

    def strain(self, n, m, e, b):
        """The strain under the forces n and m, from a guess."""
        for _ in range(40):
            fn, fm, ee, eb, bb = self.forces(e, b)
            rn, rm = n - fn, m - fm
            if abs(rn) + abs(rm) < 1e-15:
                break
            det = max(ee * bb - eb * eb, 1e-12)
            e, b = e + np.clip((rn * bb - rm * eb) / det, -1.0, 1.0), b + np.clip((rm * ee - rn * eb) / det, -1.0, 1.0)
        return e, b

    def go(self, e, b):
        """Takes its fibres on to a strain."""
        trial = e + b * self.y - self.slip
        over = trial - np.clip(trial, -self.bound, self.bound)
        if np.any(over):
            self.slip = self.slip + over
            self.yielded = True


@dataclass(frozen=True)
class Arm:
    """The film where it is nearest to straight: g, theta, V, M, its strain, N/EA and M/(EA h/2), and the work of both over EA on the way there."""
    state: np.ndarray
    strain: tuple
    forces: tuple
    work: float

    @property
    def force(self):
        """V, nN"""
        return self.state[2]

    def first_integral(self, c, H):
        """H x' + V y' + M kappa less the work of N, Q and M, nN: along the film it grows by the work of adhesion alone."""
        _, th, V, M = self.state
        co, si = np.cos(th), np.sin(th)
        Q = V * co - H * si
        along = (H * co + V * si) * (1.0 + self.strain[0]) + Q * Q / c.GA
        return along + M * self.strain[1] / (0.5 * c.height) - 0.5 * Q * Q / c.GA - c.EA * self.work


class March:
    """A film from its far end on, by steps of a length with a number of fibres."""

    def __init__(self, film, step, fibres):
        self.film, self.step, self.fibres = film, step, fibres
        c = film.strip
        self.rest, self.span, self.strength = rest_gap(c), laws.span(c), laws.strength(c)

    def slopes(self, z, H, section, guess):
        """z' of g, theta, V, M; the strain of the section, and its forces over EA."""
        c = self.film.strip
        g, th, V, M = z
        co, si = np.cos(th), np.sin(th)
        N, Q = H * co + V * si, V * co - H * si
        n, m = N / c.EA, M / (c.EA * section.half)
        e, b = section.strain(n, m, *guess)
        dx, dy = (1.0 + e) * co - Q / c.GA * si, (1.0 + e) * si + Q / c.GA * co
        t = (g + 0.5 * c.height * (1.0 - co) - self.rest) / self.span
        pull = c.width * self.strength * t * np.exp(1.0 - t)
        return np.array([dy, b / section.half, pull, -dx * V + dy * H + pull * 0.5 * c.height * si]), (e, b), (n, m)

    def modes(self, H):
        """The two modes that grow away from rest, for g, theta, V, M."""
        c = self.film.strip
        section, base = Section(self.film, 2), np.array([self.rest, 0.0, 0.0, 0.0])
        size = 1e-4 * np.array([c.r0, 0.1, 0.03, 0.01 * c.EI])
        at = lambda z: self.slopes(z, H, section, (H / c.EA, 0.0))[0]
        J = np.array([(at(base + d) - at(base - d)) / (2.0 * d.sum()) for d in np.diag(size)]).T
        rate, vector = np.linalg.eig(J)
        grow = [k for k in range(4) if rate[k].real > 0.0]
        fast, slow = sorted(grow, key=lambda k: -rate[k].real)
        assert abs(rate[fast].imag) < 1e-12
        return [(vector[:, k] / vector[0, k]).real for k in (fast, slow)]

    def run(self, share, H):
        """What becomes of a film that leaves rest downwards by the slower mode, with a share of the faster one: -2 it goes down and stays there; -1 it lifts,
        and bends back; 1 its arm turns over. With that, what it was where its arm was nearest to straight."""
        c, h = self.film.strip, self.step
        section, (fast, slow) = Section(self.film, self.fibres), self.modes(H)
        z = np.array([self.rest, 0.0, 0.0, 0.0]) + START * c.r0 * (share * fast - slow)
        guess, work, nearest, found, before, lifted = (H / c.EA, 0.0), 0.0, np.inf, None, None, False
        for _ in range(int(LONGEST / h)):
            k1, guess, forces = self.slopes(z, H, section, guess)
            section.go(*guess)
            if before is not None:
                work += 0.5 * sum((f + f0) * (a - a0) for f, f0, a, a0 in zip(forces, before[1], guess, before[0]))
            before, lifted = (guess, forces), lifted or z[0] > self.rest + self.span
            if guess[1] > FAR * section.bound and lifted:
                return 1, found
            away = np.arctan2(z[2], H) - z[1]
            out = z[0] > 20.0 * c.r0
            if out and abs(away) + abs(guess[1]) < nearest:
                nearest, found = abs(away) + abs(guess[1]), Arm(z, guess, forces, work)
            if out and away < 0.0:
                return 1, found
            if out and k1[1] < 0.0 or z[0] < -c.r0 or abs(guess[1]) > FAR * section.bound:
                return (-1 if lifted else -2), found
            k2 = self.slopes(z + 0.5 * h * k1, H, section, guess)[0]
            k3 = self.slopes(z + 0.5 * h * k2, H, section, guess)[0]
            k4 = self.slopes(z + h * k3, H, section, guess)[0]
            z = z + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        return -1, found

    def straight(self, H, near=None):
        """What the arm is like that runs out straight, and the share of the faster mode: with a little more of it the film lifts before it is bent enough, and
        bends back."""
        low, high, wide = (-1.0, 3.0, 0.0) if near is None else (near - NEAR, near + NEAR, NEAR)
        while wide and self.run(low, H)[0] == -1:
            wide *= 10.0
            low -= wide
        while wide and self.run(high, H)[0] != -1:
            wide *= 10.0
            high += wide
        found, force = None, 0.0
        while high - low > 1e-16:
            middle = 0.5 * (low + high)
            way, now = self.run(middle, H)
            low, high = (low, middle) if way == -1 else (middle, high)
            if now:
                found, last, force = now, force, now.force
                if abs(force - last) < 1e-10 * abs(force):
                    break
        return found, high


NEAR = 1e-7                              # how far the share is looked for from one that is known, at first
START = 1e-3                             # of r0: how far the film is from rest where it is marched from
FAR = 100.0                              # strain of the surfaces over that at which they yield, beyond which a film has bent through
LONGEST = 300.0                          # nm


CASES = Film(), Film(strength=0.06, tangent=0.2), Film(strength=0.04, tangent=0.5)
MESHES = (0.2, 200), (0.1, 200), (0.05, 400)    # steps, nm, and fibres: a row is from the last two


def compute(film, meshes):
    """Steady force, work that is left and stretch that stays, of each mesh; and what the balance misses, over the work of adhesion."""
    c, share, rows = film.strip, None, []
    for mesh in meshes:
        arm, share = March(film, *mesh).straight(0.0, share)
        P, w = arm.force, laws.work(c) * c.width
        # from where it is nearest to straight to where it is
        n, m = arm.forces
        left = c.EA * (arm.work - 0.5 * n * n - 1.5 * m * m)
        missed = arm.first_integral(c, 0.0) - w
        rows.append(((P, left, arm.strain[0] - n), missed / w))
    return rows


def main():
    ap = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    ap.add_argument("--check", action="store_true", help="recompute and compare with the committed table")
    ap.add_argument("--quick", action="store_true", help="with --check: one row, roughly")
    a = ap.parse_args()
    started, wrong, table = time.time(), 0, []
    for film in CASES[1:2] if a.quick else CASES:
        *_, (rough, _), (fine, miss) = compute(film, MESHES[:2] if a.quick else MESHES)
        apart = [abs(one - other) for one, other in zip(rough, fine)]
        share = max(apart[0] / fine[0], apart[1] / fine[0], 0.1 * apart[2] / (fine[2] + 1e-3))
        print(f"{film}: P = {fine[0]:.7g} nN, {fine[1]:.6g} nN stay, {fine[2]:.5g}; two meshes differ by {share:.1e}, the balance by {miss:.1e} of the work of adhesion", flush=True)
        wrong += not (share < 1e-3 and abs(miss) < 1e-3)
        table.append(dict(zip(COLUMNS, (film.strength, film.tangent, *(float(f"{number:.5g}") for number in fine)))))
    if a.check:
        known = {tuple(row[c] for c in COLUMNS[:2]): row for row in tables.read("yielding.csv")}
        for row in table:
            old = known[tuple(tables.text_of(row[c]) for c in COLUMNS[:2])]
            for column in COLUMNS[2:]:
                if abs(float(old[column]) - row[column]) > (2e-3 if a.quick else 1e-5) * abs(row[column]) + 1e-6:
                    print(f"{row}: {column} is {old[column]} in the table")
                    wrong += 1
    else:
        tables.write("yielding.csv", REMARKS, table)
    print(f"{len(table)} rows, {time.time() - started:.0f} s, {'all checks passed' if not wrong else f'{wrong} CHECKS FAILED'}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    np.seterr(all="ignore")
    main()

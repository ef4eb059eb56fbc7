"""Adhesive strips in space: what a case is, what its two ends hold, and how its state before the pull is reached.

The strip lies along x on the plane y = 0; its section at rest is d1 = e_x, d2 = -e_z, d3 = e_y. Pull direction, of
elevation alpha and azimuth beta: p = (cos alpha cos beta, sin alpha, cos alpha sin beta); across it in its vertical
plane v = (-sin alpha cos beta, cos alpha, -sin alpha sin beta); normal to that plane w = (-sin beta, 0, cos beta).
Displacement u = p.(r(L) - rest), force P = p.n(L).

Frame of the grip: R = Rz(theta) Ry(yaw) Rx(roll) R_rest. With g = Rz(theta) e_y, which is (-d1y, d1x, 0)/|..|:
    quantity        held                                        free
    along v         v.(r - rest) = 0                            v.n = 0
    along w         w.(r - rest) = 0                            w.n = 0
    rotation        d1y = 0                                     m_z = 0
    yaw             d1z = -sin(yaw)                             m.g = 0
    roll            sin(roll) d2z + cos(roll) d3z = 0           m.d1 = 0
At S = 0: x = z = 0, n_y = 0, m_z = 0, m.d1 = 0; and the turn about the normal is held, d1z = 0, or free, m.g = 0. Held,
it carries a moment along g(0) only. The turns of the grip are imposed at P = 0.
"""

from dataclasses import dataclass, fields
from math import atan, cos, pi, radians, sin, sqrt, tanh

import numpy as np

from . import law as laws
from .beam import SIZE, Beam, Varying, dot, frame
from .gauss import Failure, Problem, remesh, straight
from .path import row

C = sqrt(0.5)


@dataclass(frozen=True)
class Case:
    """A row of space_cases.csv; lengths in nm."""

    case: str
    section: str = "rectangle"
    length_nm: float = 100.0
    width_nm: float = 10.0
    height_nm: float = 10.0
    youngs_modulus_GPa: float = 2.0
    poissons_ratio: float = 0.2
    shear_correction: float = 5.0 / 6.0
    hamaker_constant_J: float = 1e-19
    equilibrium_distance_nm: float = 0.4
    twist_deg: float = 0.0
    pull_angle_deg: float = 90.0
    azimuth_deg: float = 0.0
    horizontal: str = "free"
    lateral: str = "free"
    rotation: str = "free"
    roll: str = "free"
    yaw: str = "free"
    left_turn: str = "fixed"
    grip_roll_deg: float = 0.0
    grip_yaw_deg: float = 0.0
    end_width_nm: str = ""
    end_height_nm: str = ""
    displacements_nm: str = ""
    lifts_nm: str = ""

    @classmethod
    def of(cls, texts):
        return cls(**{f.name: float(texts[f.name]) if f.type is float else texts[f.name] for f in fields(cls)})

    def section_turns(self):
        """Whether adhesion or the rest shape sees a roll of the section: not that of a disc."""
        return self.section != "ellipse" or self.width_nm != self.height_nm

    def leaves_its_plane(self):
        """Whether anything moves the strip out of the plane of its axis and the normal."""
        across = self.pull_angle_deg != 90.0 and self.azimuth_deg % 180.0 != 0.0
        return across or self.grip_roll_deg != 0.0 or self.grip_yaw_deg != 0.0 or self.twist_deg != 0.0

    def ends(self):
        """Width and height at the two ends, between which they are linear."""
        wide = float(self.end_width_nm or self.width_nm)
        return (self.width_nm, wide), (self.height_nm, float(self.end_height_nm or self.height_nm))

    def slope(self):
        """Direction of the axis free of stress over the flat underside: it rises by half of what the height grows."""
        _, (h0, h1) = self.ends()
        return atan(0.5 * (h1 - h0) / self.length_nm)

    def section_at(self, S):
        """The rectangle at places S."""
        (b0, b1), (h0, h1) = self.ends()
        t = S / self.length_nm
        b, h, E = b0 + (b1 - b0) * t, h0 + (h1 - h0) * t, self.youngs_modulus_GPa
        G = 0.5 * E / (1.0 + self.poissons_ratio)
        A, GA = b * h, self.shear_correction * G * b * h
        return Beam(
            self.length_nm,
            (1.0 / (E * A), 1.0 / GA, 1.0 / GA),
            (1.0 / (G * torsion_of_widths(b, h)), 12.0 / (E * b * h**3), 12.0 / (E * h * b**3)),
            laws.Rectangle(b, h, self.hamaker_constant_J * 1e18, self.equilibrium_distance_nm),
        )

    def law(self):
        kind = {"rectangle": laws.Rectangle, "ellipse": laws.Ellipse}[self.section]
        return kind(self.width_nm, self.height_nm, self.hamaker_constant_J * 1e18, self.equilibrium_distance_nm)

    def beam(self):
        b, h, E = self.width_nm, self.height_nm, self.youngs_modulus_GPa
        if self.end_width_nm or self.end_height_nm:
            return Varying(self.length_nm, self.section_at)
        G = 0.5 * E / (1.0 + self.poissons_ratio)
        if self.section == "rectangle":
            A, I2, I3, J = b * h, b * h**3 / 12.0, h * b**3 / 12.0, torsion(b, h)
        else:
            p, q = 0.5 * b, 0.5 * h
            A, I2, I3, J = pi * p * q, pi * p * q**3 / 4.0, pi * q * p**3 / 4.0, pi * (p * q) ** 3 / (p * p + q * q)
        GA = self.shear_correction * G * A
        return Beam(
            self.length_nm,
            (1.0 / (E * A), 1.0 / GA, 1.0 / GA),
            (1.0 / (G * J), 1.0 / (E * I2), 1.0 / (E * I3)),
            self.law(),
        )


def torsion_of_widths(b, h):
    """Of rectangles, one after the other."""
    return np.array([torsion(*sides) for sides in zip(np.ravel(b), np.ravel(h))])


def torsion(b, h):
    """Saint-Venant's torsion constant of a rectangle."""
    long, short = max(b, h), min(b, h)
    series = sum(tanh(n * pi * long / (2.0 * short)) / n**5 for n in range(1, 2001, 2))
    return long * short**3 * (1.0 / 3.0 - 64.0 * short / (pi**5 * long) * series)


class Peel:
    """The boundary value problem of a case. par = (P,); roll, yaw (radians) and the twist are those of the moment."""

    def __init__(self, case):
        self.case = case
        law = case.law()
        self.y0 = law.y0 if hasattr(law, "loads") else laws.rest_height(law)
        b = case.width_nm
        force, ell = 0.03 * b, 5.0
        self.problem = Problem(
            case.beam(), self.conditions, [1.0] * 3 + [0.1] * 4 + [force] * 3 + [force * ell] * 3, [force]
        )
        al, be = radians(case.pull_angle_deg), radians(case.azimuth_deg)
        upright = case.pull_angle_deg == 90.0
        ca, sa = (0.0, 1.0) if upright else (cos(al), sin(al))
        self.p = np.array([ca * cos(be), sa, ca * sin(be)])
        self.v = np.array([-sa * cos(be), ca, -sa * sin(be)])
        self.w = np.array([-sin(be), 0.0, cos(be)])
        along, up = case.length_nm * cos(case.slope()), case.length_nm * sin(case.slope())
        self.rest = np.array([along, self.y0 + up, 0.0])
        self.u = np.zeros(2 * SIZE + 1)
        self.u[SIZE : SIZE + 3] = self.p
        self.P, self.lift = row(self.problem, "par", 0), row(self.problem, "right", 1)
        self.turn(0.0)

    def turn(self, share):
        """Imposes a share of the turns of the grip and of the twist."""
        c = self.case
        self.roll_by, self.yaw_by = radians(c.grip_roll_deg) * share, radians(c.grip_yaw_deg) * share
        self.problem.beam = self.problem.beam.with_curvature((radians(c.twist_deg) * share / c.length_nm, 0.0, 0.0))

    def conditions(self, a, b, par):
        c = self.case
        e1, _, _ = frame(a[3:7])
        d1, d2, d3 = frame(b[3:7])
        r, n, m = b[0:3] - self.rest[:, None], b[7:10], b[10:13]
        n0, m0 = a[7:10], a[10:13]
        return [
            a[0],
            a[2],
            n0[1],
            m0[2],
            dot(m0, e1),
            e1[2] if c.left_turn == "fixed" else m0[1] * e1[0] - m0[0] * e1[1],
            dot(self.p, n) - par[0],
            dot(self.v, r) if c.horizontal == "fixed" else dot(self.v, n),
            dot(self.w, r) if c.lateral == "fixed" else dot(self.w, n),
            d1[1] if c.rotation == "fixed" else m[2],
            d1[2] + sin(self.yaw_by) if c.yaw == "fixed" else d1[0] * m[1] - d1[1] * m[0],
            sin(self.roll_by) * d2[2] + cos(self.roll_by) * d3[2] if c.roll == "fixed" else dot(m, d1),
        ]

    def displacement(self, st):
        return float(self.p @ (st.z[0:3, -1] - self.rest))

    def u_row(self, u):
        """The right side of u . x = ... at a displacement."""
        return u + float(self.p @ self.rest)

    def reactions(self, st):
        """What the grip carries: moments conjugate to roll, yaw and rotation, forces along v and w, and its turns."""
        z = st.z[:, -1]
        d1, d2, d3 = (np.array(d) for d in frame(z[3:7]))
        g = np.array([-d1[1], d1[0], 0.0]) / np.hypot(d1[0], d1[1])
        n, m = z[7:10], z[10:13]
        return {
            "torque": float(m @ d1),
            "yaw_moment": float(m @ g),
            "rotation_moment": float(m[2]),
            "horizontal_force": float(self.v @ n),
            "lateral_force": float(self.w @ n),
            "roll": float(np.arctan2(d3[2], -d2[2])),
            "yaw": float(np.arcsin(-d1[2])),
            "rotation": float(np.arctan2(d1[1], d1[0])),
        }

    def tangent(self):
        return cos(self.case.slope()), sin(self.case.slope()), 0.0

    def at_rest(self, N, s):
        """The level strip, on a mesh that is finer towards the grip."""
        # about z by the slope, after R_rest
        c, d = C * cos(0.5 * self.case.slope()), C * sin(0.5 * self.case.slope())
        st = straight(self.case.length_nm, N, s, (0.0, self.y0, 0.0), (c, -c, -d, d), [0.0], self.tangent())
        st.X = self.case.length_nm * (1.0 - (1.0 - np.linspace(0.0, 1.0, N + 1)) ** 1.6)
        st.z[0], st.z[1] = st.X * cos(self.case.slope()), self.y0 + st.X * sin(self.case.slope())
        return st

    def start(self, N, s, step=0.1):
        """The equilibrium at P = 0 with all turns imposed, reached in small shares of them."""
        st = self.problem.solve(self.at_rest(N, s), self.P, 0.0)
        case = self.case
        if not (case.grip_roll_deg or case.grip_yaw_deg or case.twist_deg):
            return st
        share, before = 0.0, None
        while share < 1.0:
            step = min(step, 1.0 - share)
            guess = st
            if before is not None and len(before[1].X) == len(st.X):
                old = before[1].moved(st.X)
                k = step / (share - before[0])
                guess = st.copy()
                guess.z, guess.K = st.z + k * (st.z - old.z), st.K + k * (st.K - old.K)
            try:
                self.turn(share + step)
                new = self.problem.solve(guess, self.P, 0.0)
            except Failure:
                step *= 0.5
                if step < 1e-5:
                    raise
                continue
            before = share, st
            share, st = share + step, new
            st = self.problem.solve(remesh(st, N, self.problem.scale, s), self.P, 0.0)
            step *= 1.5 if self.problem.used < 5 else 1.0
        return st

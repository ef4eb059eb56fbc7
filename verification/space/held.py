"""A cohesive law that holds a strip along the ground as well, in every direction, and the peel of such a strip.

The bonded face's point at s b d2 from the middle of its width, s from -1/2 to 1/2, has been displaced by
    d(s) = (r - r0) + (R - R0) l(s),   l = s b e2 - (h/2) e3,   r0 = (S, y0, 0),   R0 = [e_x, -e_z, e_y],
from where it was bonded. With t^2 = d_x^2 + d_z^2 its slip and d_y its opening,
    psi = W_pull(d_y) exp(-t^2/delta^2) + W_push(d_y),   W = -sigma range (1 + o) exp(1 - o),   o = d_y/range,
the exponential law with what attracts an open face and what repels a pressed one; range = w/(sigma e), and delta = (2/e)^(1/2) w/tau. So
    n' = b int grad psi ds,   m' = -r' x n + b int (R l) x grad psi ds,
by Gauss's rule on both sides of where the face just closes, at which the law has a corner. Nothing holds the end at S = 0. First integral: that of a strip that slides, less n_x.

Where slip takes a work of its own, w_t, delta = (2/e)^(1/2) w_t/tau, and in place of grad psi there is
    f = (w_t/w dpsi/dx, dpsi/dy, w_t/w dpsi/dz):
no gradient, and no first integral. With an exponent eta of Benzeggagh and Kenane what pulls is k times as large,
    k = 1 + 2 (kappa - 1) (1 - A B),  kappa = (1 - m + m w/w_t) (1 + (w_t/w - 1) m^eta),  m = w_t q/(w p + w_t q),
with A and B what is left of opening and of slip, p = -ln A = o - ln(1 + o), q = -ln B = t^2/delta^2.
"""

from dataclasses import dataclass, replace
from math import e, sqrt

import numpy as np

from .beam import Beam, cross, frame
from .grip import Case, Peel

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(14)


@dataclass(frozen=True)
class Held:
    """The law on a strip of this width and height; `places`: S of the points at which it is asked."""

    width: float
    height: float
    strength: float
    work: float
    shear_strength: float
    y0: float
    shear_work: float
    mixing: float = 0.0
    places: object = None
    r0: float = 0.0

    def at(self, places):
        return replace(self, places=np.asarray(places))

    def density(self, d):
        """psi and f, of displacements [x, y, z]."""
        span, delta = self.work / (self.strength * e), sqrt(2.0 / e) * self.shear_work / self.shear_strength
        o = d[1] / span
        whole, rise = -self.strength * span * (1.0 + o) * np.exp(1.0 - o), self.strength * o * np.exp(1.0 - o)
        is_open = np.real(o) > 0.0
        pull, by_pull = np.where(is_open, whole, -self.work), np.where(is_open, rise, 0.0)
        push, by_push = np.where(is_open, 0.0, whole + self.work), np.where(is_open, 0.0, rise)
        hold = np.exp(-(d[0] ** 2 + d[2] ** 2) / delta**2)
        factor = self.mixed(np.where(is_open, o, 0.0), (d[0] ** 2 + d[2] ** 2) / delta**2)
        along = -2.0 / delta**2 * self.shear_work / self.work * pull * hold * factor
        return pull * hold + push, (along * d[0], by_pull * hold * factor + by_push, along * d[2])

    def mixed(self, o, q):
        """k at an opening and at what is left of slip."""
        if not self.mixing:
            return 1.0
        ratio, p = self.shear_work / self.work, o - np.log1p(o)
        both = p + ratio * q
        m = np.where(both == 0.0, 0.0, ratio * q / np.where(both == 0.0, 1.0, both))
        m = np.where(m == 0.0, 1e-300, m)
        kappa = (1.0 - m + m / ratio) * (1.0 + (ratio - 1.0) * m**self.mixing)
        return 1.0 + 2.0 * (kappa - 1.0) * (1.0 - (1.0 + o) * np.exp(-o - q))

    def loads(self, z):
        """Psi, and the force and the moment per length on the ground."""
        d = frame(z[3:7])
        places = self.places.reshape((1,) * (z[0].ndim - self.places.ndim) + self.places.shape)
        axis = [z[0] - places, z[1] - self.y0, z[2]]
        energy, force, moment = 0.0, [0.0] * 3, [0.0] * 3
        rest = ((0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
        down = -0.5 * self.height
        # where the energy is continuous a corner that moves adds on one side what it takes from the other
        middle, slope = np.real(axis[1] + down * (d[2][1] - 1.0)), np.real(self.width * d[1][1])
        corner = np.clip(-middle / np.where(slope == 0.0, 1e-300, slope), -0.5, 0.5)
        for low, high in ((-0.5, corner), (corner, 0.5)):
            for point, weight in zip(POINTS, WEIGHTS):
                side = self.width * (0.5 * (low + high) + 0.5 * (high - low) * point)
                share = self.width * 0.5 * (high - low) * weight
                arm = [side * d[1][i] + down * d[2][i] for i in range(3)]
                at = [axis[i] + arm[i] - side * rest[0][i] - down * rest[1][i] for i in range(3)]
                psi, f = self.density(at)
                turn = cross(arm, f)
                energy = energy + share * psi
                for i in range(3):
                    force[i] = force[i] + share * f[i]
                    moment[i] = moment[i] + share * turn[i]
        return energy, force, moment

    def lowest(self, e2, e3):
        return -np.inf


@dataclass(frozen=True)
class HeldBeam(Beam):
    """A uniform beam under such a law."""

    def at(self, S):
        return replace(self, law=self.law.at(S))


@dataclass(frozen=True)
class HeldCase(Case):
    """A row of space_held_cases.csv; lengths in nm."""

    work_J_m2: float = 0.03
    strength_GPa: float = 0.01
    shear_strength_GPa: float = 0.01
    shear_work_J_m2: str = ""
    mixing_exponent: str = ""

    def law(self):
        y0 = 0.5 * self.height_nm
        w = float(self.shear_work_J_m2 or self.work_J_m2)
        at = (self.width_nm, self.height_nm, self.strength_GPa, self.work_J_m2, self.shear_strength_GPa, y0)
        return Held(*at, w, float(self.mixing_exponent or 0.0))

    def beam(self):
        free = super().beam()
        return HeldBeam(self.length_nm, free.soft, free.pliant, self.law())


class HeldPeel(Peel):
    """Its boundary value problem: no force and no moment at S = 0."""

    def conditions(self, a, b, par):
        return [*a[7:13], *super().conditions(a, b, par)[6:]]

#!/usr/bin/env python3
"""Closed forms behind the paper's printed numbers, with mpmath at 40 digits. Writes published.csv."""
import mpmath as mp

import tables

mp.mp.dps = 40
A_H, R0 = mp.mpf("0.1"), mp.mpf("0.4")                                # nN nm, nm
E, H, NU, KAPPA = mp.mpf(2), mp.mpf(10), mp.mpf("0.2"), mp.mpf(5) / 6  # GPa, nm
EI0, EA = E * H ** 3 / 12, E * H                                      # nN nm, nN/nm: per width
GA = KAPPA * E / (2 * (1 + NU)) * H
ANGLES = (0, 30, 45, 60, 90, 180)                                     # degrees

REMARKS = (
    "Closed forms behind the paper's printed numbers, computed with mpmath at 40 digits by verification/published.py; all digits are good.",
    "A_H = 1e-19 J, r0 = 0.4 nm, E = 2 GPa, h = 10 nm, nu = 0.2, shear correction 5/6, per unit width unless the name says otherwise.",
)


def traction(r):
    """T(r), eq. (18), nN/nm^2."""
    q = R0 / r
    return A_H / (2 * mp.pi * R0 ** 3) * (q ** 9 / 45 - q ** 3 / 3)


def potential(r):
    """W(r), the integral of T from r to infinity, nN/nm."""
    q = R0 / r
    return A_H / (2 * mp.pi * R0 ** 2) * (q ** 8 / 360 - q ** 2 / 6)


def line_potential(y, theta):
    """Psi(y, theta) of eqs. (17)-(22), both faces, nN/nm."""
    c = mp.cos(theta)
    return (potential(y - H / 2 * c) - potential(y + H / 2 * c)) / c


def kendall(work, angle, width=1):
    """The positive root of P^2/(2 E h b^2) + (P/b)(1 - cos phi) = w, by the secant method."""
    lift = 1 - mp.cos(angle)
    return mp.findroot(lambda P: (P / width) ** 2 / (2 * E * H) + P / width * lift - work, (width * work, width * mp.sqrt(2 * E * H * work)))


def rows():
    gap = mp.findroot(traction, (0.63 * R0, 0.64 * R0))
    work = mp.quad(lambda r: -traction(r), [gap, 2 * R0, 10 * R0, 100 * R0, mp.inf])
    yield "work_of_adhesion_closed_form_nN_per_nm", mp.cbrt(15) * A_H / (16 * mp.pi * R0 ** 2)
    yield "work_of_adhesion_integral_of_traction_nN_per_nm", work
    yield "largest_attraction_nN_per_nm2", -traction(R0 * 5 ** (-mp.mpf(1) / 6))
    yield "bending_stiffness_EI0_nN_nm", EI0
    for degrees in ANGLES:
        yield f"kendall_{degrees}_degrees_nN_per_nm", kendall(work, mp.radians(degrees))
    yield "kendall_45_degrees_width_3_nN", kendall(work, mp.radians(45), 3)
    y = mp.findroot(lambda y: mp.diff(lambda s: line_potential(s, 0), y), (H / 2 + gap, H / 2 + 1.001 * gap))
    strip = -line_potential(y, 0)
    yield "strip_rest_gap_nm", y - H / 2
    yield "strip_work_of_adhesion_nN_per_nm", strip
    yield "strip_steady_force_nN_per_nm", kendall(strip, mp.pi / 2)
    yield "strip_shear_bound_nN_per_nm", mp.sqrt(2 * GA * strip)
    yield "strip_end_unstable_below_EI_over_EI0", least_bending_stiffness(y) / EI0


def least_bending_stiffness(y):
    """EI below which the end of a long strip at rest lifts by itself, nN nm.

    For disturbances exp(s S) of the rest state, with k = Psi_yy and m = Psi_theta,theta < 0 (Psi_y,theta = 0 there):
    V' = k y, y' = theta + V/GA, EI theta'' = -V + m theta; so EI s^4 - (m + EI k/GA) s^2 + k (1 + m/GA) = 0. Of the two decaying
    ones M = 0 at the end makes the mixture y1 : y2 = (s2^2 - k/GA) : -(s1^2 - k/GA), and V/y there is the stiffness
    k (s1^2 + s1 s2 + s2^2 - k/GA) / (s1 s2 (s1 + s2)). With the sum and the product of the squares from the quartic it is zero
    where m = -sqrt(EI k (1 + m/GA)).
    """
    k, m = (mp.diff(line_potential, (y, 0), order) for order in ((2, 0), (0, 2)))
    return m ** 2 / (k * (1 + m / GA))


def compute():
    return [{"quantity": name, "value": value} for name, value in rows()]


if __name__ == "__main__":
    tables.run(__doc__, [("published.csv", REMARKS, compute)], relative=1e-12)

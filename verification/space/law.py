"""Energy of adhesion per length of a tilted section over a plane, and its gradient.

A law answers gradient(y, e2, e3): (Psi, dPsi/dy, dPsi/de2, dPsi/de3) for the height y of the axis and the components
e2, e3 of the directors of the width and of the height along the normal. All formulas are analytic: complex arguments
give further derivatives.

Rectangle b x h, a = b e2, c = h e3, with V = A_H/(2 pi r0) [(r0/r)^7/2520 - (r0/r)/6], the second integral of the
force on a molecule:
    Psi = b h [V(y - (a+c)/2) - V(y - (a-c)/2) - V(y + (a-c)/2) + V(y + (a+c)/2)]/(a c)
is the divided difference b h Phi[s, t] of Phi(x) = V(y - sqrt x) + V(y + sqrt x) with s = ((a+c)/2)^2, t =
((a-c)/2)^2, since s - t = a c. Phi of 1/r^n is 2 N(x) (y^2 - x)^-n with N = sum C(n, 2j) y^(n-2j) x^j. Its divided
differences are sums of positive terms.

Ellipse with semi-axes p along the width and q along the height: the integral of (r0/r)^9 and (r0/r)^3 over the
section, closed form in rho = (p e2)^2 + (q e3)^2 and w^2 = y^2 - rho.
"""

from dataclasses import dataclass
from math import comb, pi

import numpy as np
from scipy.optimize import brentq


def complete(order, values):
    """Complete homogeneous symmetric polynomials h_0 ... h_order of the values."""
    h = [1.0] + [0.0] * order
    for x in values:
        for j in range(1, order + 1):
            h[j] = h[j] + x * h[j - 1]
    return h


def differences(n, y, a, c, most):
    """Divided differences of Phi for V = r^-n, {(k, l): s taken k times, t taken l times}, for the (k, l) in `most`."""
    s, t = 0.25 * (a + c) ** 2, 0.25 * (a - c) ** 2
    A = 1.0 / ((y - 0.5 * (a + c)) * (y + 0.5 * (a + c)))
    B = 1.0 / ((y - 0.5 * (a - c)) * (y + 0.5 * (a - c)))
    top = n // 2
    out = {}
    for k, l in most:
        points = [0] * k + [1] * l
        total = 0.0
        for i in range(k + l):  # Leibniz: N[x_0 .. x_i] D[x_i .. x_m]
            left, right = points[: i + 1], points[i:]
            h = complete(max(top - i, 0), [(s, t)[p] for p in left])
            number = sum(comb(n, 2 * j) * y ** (n - 2 * j) * h[j - i] for j in range(i, top + 1))
            K, L = right.count(0), right.count(1)
            total = total + number * A**K * B**L * complete(n - 1, [(A, B)[p] for p in right])[n - 1]
        out[k, l] = 2.0 * total
    return out


@dataclass(frozen=True)
class Rectangle:
    width: float
    height: float
    hamaker: float = 0.1  # nN nm: 1e-19 J
    r0: float = 0.4

    def gradient(self, y, e2, e3):
        b, h, r0 = self.width, self.height, self.r0
        a, c = b * e2, h * e3
        scale = b * h * self.hamaker / (2.0 * pi * r0)
        V = lambda n7, n1: r0**7 / 2520.0 * n7 - r0 / 6.0 * n1
        want = ((1, 1), (2, 1), (1, 2), (2, 2))
        f7, f1 = differences(7, y, a, c, want), differences(1, y, a, c, want)
        g8, g2 = differences(8, y, a, c, want[:1]), differences(2, y, a, c, want[:1])
        psi = V(f7[1, 1], f1[1, 1])
        psi_y = V(-7.0 * g8[1, 1], -g2[1, 1])
        D, E = V(f7[2, 1] + f7[1, 2], f1[2, 1] + f1[1, 2]), V(f7[2, 2], f1[2, 2])
        return scale * psi, scale * psi_y, scale * b * 0.5 * a * (D + c * c * E), scale * h * 0.5 * c * (D + a * a * E)

    def lowest(self, e2, e3):
        """How far the lowest point lies below the axis."""
        return 0.5 * (np.abs(self.width * e2) + np.abs(self.height * e3))


@dataclass(frozen=True)
class Ellipse:
    width: float
    height: float
    hamaker: float = 0.1
    r0: float = 0.4

    def gradient(self, y, e2, e3):
        p, q, r0 = 0.5 * self.width, 0.5 * self.height, self.r0
        rho = (p * e2) ** 2 + (q * e3) ** 2
        W = y * y - rho
        C, c9, c3 = p * q * self.hamaker / (2.0 * r0**3), r0**9 / 45.0, r0**3 / 3.0
        root = W**-0.5
        k = (1.0, 27.0 / 4.0, 99.0 / 8.0, 429.0 / 64.0)
        power = [root ** (9 + 2 * j) for j in range(5)]
        psi = c9 * sum(k[j] * rho**j * power[j] for j in range(4)) - c3 * root**3
        by_W = c9 * sum(-(4.5 + j) * k[j] * rho**j * power[j + 1] for j in range(4)) + 1.5 * c3 * root**5
        by_rho = c9 * sum(j * k[j] * rho ** (j - 1) * power[j] for j in range(1, 4)) - by_W
        return C * psi, C * 2.0 * y * by_W, C * by_rho * 2.0 * p * p * e2, C * by_rho * 2.0 * q * q * e3

    def lowest(self, e2, e3):
        return 0.5 * np.sqrt((self.width * e2) ** 2 + (self.height * e3) ** 2)


def rest_height(law):
    """Height of the axis where a level section is attracted no more and not yet repelled."""
    half = 0.5 * law.height
    return brentq(
        lambda y: law.gradient(y, 0.0, 1.0)[1], half + 0.4 * law.r0, half + 0.9 * law.r0, xtol=1e-15, rtol=1e-15
    )


def with_hessian(law, y, e2, e3, tiny=1e-30):
    """Psi, its gradient (3, M) and its second derivatives (3, 3, M), by complex steps."""
    x = np.array([y, e2, e3], dtype=float)
    moved = x[:, None, :] + 1j * tiny * np.eye(3)[:, :, None]
    moved = np.concatenate([x[:, None, :] + 0j, moved], axis=1)
    psi, *g = law.gradient(*moved)
    g = np.array(g)
    return psi[0].real, g[:, 0].real, g[:, 1:].imag / tiny

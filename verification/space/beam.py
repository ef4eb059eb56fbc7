"""Strong form of the shear-flexible beam in space: 13 first-order equations.

State z = (r, q, n, m): position of the axis, quaternion (w, x, y, z) of the section, force and moment on the face of
larger S, both in fixed components. R(q) = [d1 d2 d3], divided by q.q: d1 along the axis, d2 along the width, d3 along
the height.

    r' = R (e1 + G),   G = (d1.n/EA, d2.n/GA2, d3.n/GA3)
    q' = q o (0, K)/2,  K = K0 + (d1.m/GJ, d2.m/EI2, d3.m/EI3)
    n' = Psi_y e_y
    m' = -r' x n + Psi_e2 d2 x e_y + Psi_e3 d3 x e_y

with Psi(y, e2, e3) of law.py, e2 = d2.e_y, e3 = d3.e_y. First integral of a uniform beam with a uniform K0:
n.r' + m.(R K) - stored - Psi. Also constant: n_x, n_z, m_y + (r x n)_y; without adhesion n and m + r x n.
"""

from dataclasses import dataclass, replace

import numpy as np

from . import law as laws

TINY = 1e-30
SIZE = 13


@dataclass(frozen=True)
class Beam:
    """A uniform beam: compliances 1/(EA, GA2, GA3) and 1/(GJ, EI2, EI3), zero for what does not give way."""

    length: float
    soft: tuple
    pliant: tuple
    law: object = None
    curvature: tuple = (0.0, 0.0, 0.0)

    def with_curvature(self, curvature):
        return replace(self, curvature=tuple(curvature))

    def at(self, S):
        """The beam at places S: the same everywhere."""
        return self


@dataclass(frozen=True)
class Varying:
    """A beam whose numbers change along S: section(S) gives a Beam of arrays."""

    length: float
    section: object

    def with_curvature(self, curvature):
        assert not any(curvature)
        return self

    def at(self, S):
        return self.section(np.asarray(S))


def frame(q):
    """The three directors, each a list of components."""
    w, x, y, z = q
    one = 1.0 / (w * w + x * x + y * y + z * z)
    return (
        [(w * w + x * x - y * y - z * z) * one, 2.0 * (x * y + w * z) * one, 2.0 * (x * z - w * y) * one],
        [2.0 * (x * y - w * z) * one, (w * w - x * x + y * y - z * z) * one, 2.0 * (y * z + w * x) * one],
        [2.0 * (x * z + w * y) * one, 2.0 * (y * z - w * x) * one, (w * w - x * x - y * y + z * z) * one],
    )


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def strains(beam, z):
    """Directors, G, K and r'."""
    d = frame(z[3:7])
    n, m = z[7:10], z[10:13]
    G = [beam.soft[i] * dot(d[i], n) for i in range(3)]
    K = [beam.curvature[i] + beam.pliant[i] * dot(d[i], m) for i in range(3)]
    slope = [(1.0 + G[0]) * d[0][i] + G[1] * d[1][i] + G[2] * d[2][i] for i in range(3)]
    return d, G, K, slope


def right_side(beam, z, pull):
    """z' for z of shape (13, ...); pull(y, e2, e3): the gradient of Psi."""
    d, _, K, slope = strains(beam, z)
    w, x, y, v = z[3:7]
    out = np.empty_like(z)
    out[0:3] = slope
    out[3] = 0.5 * (-x * K[0] - y * K[1] - v * K[2])
    out[4] = 0.5 * (w * K[0] + y * K[2] - v * K[1])
    out[5] = 0.5 * (w * K[1] + v * K[0] - x * K[2])
    out[6] = 0.5 * (w * K[2] + x * K[1] - y * K[0])
    out[7:10] = 0.0
    turn = cross(slope, z[7:10])
    for i in range(3):
        out[10 + i] = -turn[i]
    if pull is not None:
        g_y, g_2, g_3 = pull(z[1], d[1][1], d[2][1])
        out[8] += g_y
        # d x e_y = (-d_z, 0, d_x)
        out[10] -= g_2 * d[1][2] + g_3 * d[2][2]
        out[12] += g_2 * d[1][0] + g_3 * d[2][0]
    return out


def linearised(beam, z):
    """Right side (13, M) at real z of shape (13, M), and its Jacobian (13, 13, M): row, column, point. Complex
    steps."""
    pull, loads = None, getattr(beam.law, "loads", None)
    if beam.law is not None and loads is None:
        d = frame(z[3:7])
        at = np.array([z[1], d[1][1], d[2][1]])
        _, g, H = laws.with_hessian(beam.law, *at)

        def pull(*x):  # linear: its real part is exact, and its complex step as well
            step = np.array([x[i] - at[i] for i in range(3)])
            return g[:, None, :] + np.einsum("ijm,jkm->ikm", H, step)

    moved = z[:, None, :] + 1j * TINY * np.eye(SIZE)[:, :, None]
    f = right_side(beam, moved, pull)
    if loads is not None:
        _, force, moment = loads(moved)
        for i in range(3):
            f[7 + i] += force[i]
            f[10 + i] += moment[i]
    return f[:, 0].real, f.imag / TINY


def stored(beam, z):
    """Elastic energy per length."""
    d = frame(z[3:7])
    return 0.5 * sum(
        beam.soft[i] * dot(d[i], z[7:10]) ** 2 + beam.pliant[i] * dot(d[i], z[10:13]) ** 2 for i in range(3)
    )


def adhesion(beam, z):
    """Psi along the beam."""
    if beam.law is None:
        return np.zeros(z.shape[1:])
    if hasattr(beam.law, "loads"):
        return beam.law.loads(z)[0]
    d = frame(z[3:7])
    return beam.law.gradient(z[1], d[1][1], d[2][1])[0]


def first_integral(beam, z):
    d, _, K, slope = strains(beam, z)
    body = [dot(d[i], z[10:13]) for i in range(3)]
    whole = dot(z[7:10], slope) + dot(body, K) - stored(beam, z) - adhesion(beam, z)
    return whole - z[7] if hasattr(beam.law, "loads") else whole

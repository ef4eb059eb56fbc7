"""The strip, the potential of its adhesion, and the strong form of Reissner's planar beam.

With the potential  Pi = int [EA G1^2/2 + GA G2^2/2 + EI k^2/2 + b Psi(y, theta)] dS - H x(L) - V(L) y(L),
    G1 = x' cos + y' sin - 1,   G2 = -x' sin + y' cos,   k = theta',
    H = N cos - Q sin,  V = N sin + Q cos,  M = EI theta'   (N = EA G1, Q = GA G2; so N = H cos + V sin, Q = -H sin + V cos),
its first variation gives
    H' = 0,   V' = b dPsi/dy = -b T_c,   M' = -x' V + y' H + b dPsi/dtheta = -x' V + y' H - b M_c.
Solved for derivatives, with g = y - h/2 in place of y and w = x - S in place of x, so that nothing cancels:
    g' = (1 + N/EA) sin + (Q/GA) cos - h'/2,   theta' = M/EI + theta0',   V' = -b T_c,   M' = -x' V + y' H - b M_c,   w' = x' - 1.
Section and rest curvature theta0' may vary along S (shapes.py); those of a strip do not. Psi is that of Sauer's eqs. (17)-(22);
other laws are in laws.py.
An infinite shear_correction makes the beam rigid in shear.
"""
import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.optimize import brentq

from . import laws, sheared
from .friction import Friction


@dataclass(frozen=True, kw_only=True)
class Beam:
    """What every beam has: its grip, its adhesion, its material."""
    rotation: str = "free"               # of the grip: free | fixed
    turned: float = 0.0                  # degrees, by which a fixed grip is turned before it is pulled
    turn: float = 0.0                    # degrees/nm, by which it turns as it goes
    horizontal: str = "free"             # of the grip, across the pull: free | fixed
    pretension: float = 0.0              # nN, along the strip before it is pulled; horizontal = fixed
    angle: float = 90.0                  # of the pull to the substrate, degrees: 0 away from the strip, 180 back over it
    law: str = "body-force"           # body-force | surface-traction | exponential | bilinear | dugdale
    line_load: str = "full"              # full | force-only | axis-gap
    far_face: bool = True
    young: float = 2.0                   # GPa
    poisson: float = 0.2
    shear_correction: float = 5.0 / 6.0
    hamaker: float = 1e-19               # J
    r0: float = 0.4                      # nm
    friction: Friction | None = None
    shear_strength: float | None = None  # GPa, of a cohesive law; None: it slides
    shear_work: float | None = None      # J/m^2, of slip beside it; None: that of opening
    mixing: float | None = None          # exponent of Benzeggagh and Kenane; None: the linear criterion
    stretching: str = "linear"             # linear | neo-hookean | neo-hookean-wide

    slid, share = 0.0, 0.0               # what friction remembers: x_b - S, nm, and s

    @property
    def sticks(self):
        """Whether H changes along S."""
        return self.friction is not None or self.shear_strength is not None

    @property
    def slip_stiffness(self):
        """Along the substrate at rest, of what sticks, nN/nm^3."""
        return sheared.stiffness(self) if self.friction is None else self.friction.tau0 / self.friction.delta(self)

    @property
    def K(self):
        """A_H / (2 pi r0^2), nN/nm."""
        return self.hamaker * 1e18 / (2.0 * math.pi * self.r0 ** 2)

    @property
    def shear_modulus(self):
        """That of the section, shear correction and all, GPa."""
        return self.shear_correction * self.young / (2.0 * (1.0 + self.poisson))

    @property
    def pull(self):
        """Its direction: cosine and sine of the angle, exact at 90 degrees."""
        return math.sin(math.radians(90.0 - self.angle)), math.sin(math.radians(self.angle))

    @property
    def stretch(self):
        """How much longer a strip is under its pretension."""
        return self.pretension * self.length / self.EA if self.pretension else 0.0

    @cached_property
    def end_gap(self):
        """Of the grip at rest."""
        return float(self.free(np.array([self.length]))[0][0])


@dataclass(frozen=True, kw_only=True)
class Strip(Beam):
    length: float = 100.0                # nm
    factor: float = 1.0                  # on EI alone
    height: float = 10.0                 # nm
    width: float = 1.0                   # nm

    rise = 0.0                           # dh/dS
    bend = 0.0                           # rest curvature
    end_rotation = 0.0                   # of the grip at rest

    @property
    def ends(self):
        """Of the pieces on which the section has one formula, nm."""
        return 0.0, self.length

    def at(self, S):
        """Its section at the places S."""
        return self

    def free(self, S):
        """Gap and rotation free of stress; the gap is that of equilibrium."""
        return np.full_like(S, rest_gap(self)), np.zeros_like(S)

    @property
    def EI(self):
        return self.young * self.height ** 3 / 12.0 * self.width * self.factor

    @property
    def EA(self):
        return self.young * self.height * self.width

    @property
    def GA(self):
        return self.shear_modulus * self.height * self.width

    def __str__(self):
        turns = f"turned={self.turned:g} turn={self.turn:g} " if self.turned or self.turn else ""
        return (f"L={self.length:g} f={self.factor:g} angle={self.angle:g} rot={self.rotation} {turns}hor={self.horizontal} {self.line_load} "
                f"far={str(self.far_face).lower()} h={self.height:g} b={self.width:g} E={self.young:g} nu={self.poisson:g} "
                f"k={self.shear_correction:.4g} A_H={self.hamaker:g} r0={self.r0:g} {self.law}")


def _near(c, r):
    """W, T, T' of one half space at the gap r: W(r) = K [q^8/360 - q^2/6], T = -W'."""
    q = c.r0 / r
    q2 = q * q
    q8 = q2 ** 4
    W = c.K * (q8 / 360.0 - q2 / 6.0)
    T = c.K / c.r0 * q * (q8 / 45.0 - q2 / 3.0)
    dT = c.K / c.r0 ** 2 * q2 * (q2 - q8 / 5.0)
    return W, T, dT


def potential(c, g, th):
    """Psi with its gradient (y, theta) and Hessian (yy, yt, tt); for axis-gap the W(g) - W(g + h) of its traction.

    "force-only" has the same T_c but no M_c; its Psi is that of the full law and is no potential of it. Nor is the Psi that
    stands for the surface traction, which has none: it is that of the body forces, the same where the strip is level.
    """
    if c.law in laws.COHESIVE:
        return laws.cohesive(c, g, th)
    co, si = np.cos(th), np.sin(th)
    h, r0 = c.height, c.r0
    if c.line_load == "axis-gap":
        W, T, dT = _near(c, g)
        if c.far_face:
            W2, T2, dT2 = _near(c, g + h)
            W, T, dT = W - W2, T - T2, dT - dT2
        zero = np.zeros_like(W)
        return W, -T, zero, -dT, zero, zero
    r1 = g + h * np.sin(0.5 * th) ** 2           # = y - (h/2) cos, without the cancellation
    if not c.far_face:
        W, T, dT = _near(c, r1)
        a = 0.5 * h * si                          # d r1 / d theta
        ic = 1.0 / co
        d1 = si * ic * ic                         # (1/cos)'
        d2 = ic * (1.0 + 2.0 * si * si * ic * ic)  # (1/cos)''
        return (W * ic, -T * ic, -T * a * ic + W * d1, -dT * ic, -dT * a * ic - T * d1,
                (-dT * a * a - T * 0.5 * h * co) * ic - 2.0 * T * a * d1 + W * d2)
    # both faces: with p = r0/r1, q = r0/r2, m = p q, s = p + q = 2 (y/r0) m, the division by cos is done by hand:
    # Psi = K (h/r0) m s B,  B = (p^2 + q^2)(p^4 + q^4)/360 - 1/6.
    y = g + 0.5 * h
    r2 = y + 0.5 * h * co
    m = r0 * r0 / (r1 * r2)
    s = 2.0 * y / r0 * m
    Q = (r0 / r1) ** 2 + (r0 / r2) ** 2          # s^2 - 2m
    m2 = m * m
    B = Q * (Q * Q - 2.0 * m2) / 360.0 - 1.0 / 6.0
    BQ = (3.0 * Q * Q - 2.0 * m2) / 360.0
    BQQ = Q / 60.0
    Bs = 2.0 * s * BQ
    Bm = -2.0 * BQ - m * Q / 90.0
    Bss = 4.0 * s * s * BQQ + 2.0 * BQ
    x = -2.0 * BQQ - m / 90.0
    Bsm = 2.0 * s * x
    Bmm = -2.0 * x + (2.0 * m - Q) / 90.0
    C = c.K * h / r0
    Gm = C * s * (B + m * Bm)
    Gs = C * m * (B + s * Bs)
    Gmm = C * s * (2.0 * Bm + m * Bmm)
    Gss = C * m * (2.0 * Bs + s * Bss)
    Gms = C * (B + s * Bs + m * Bm + m * s * Bsm)
    # m = r0^2/D with D = r1 r2 = y^2 - (h cos/2)^2
    i = m / (r0 * r0)                             # 1/D
    Dy, Dt = 2.0 * y, 0.5 * h * h * si * co
    Dtt = 0.5 * h * h * (co * co - si * si)
    my, mt = -m * Dy * i, -m * Dt * i
    myy = -2.0 * my * Dy * i - 2.0 * m * i
    myt = -2.0 * my * Dt * i
    mtt = -2.0 * mt * Dt * i - m * Dtt * i
    k = 2.0 / r0
    sy, st = k * (m + y * my), k * y * mt
    syy, syt, stt = k * (2.0 * my + y * myy), k * (mt + y * myt), k * y * mtt
    return (C * m * s * B, Gm * my + Gs * sy, Gm * mt + Gs * st,
            Gmm * my * my + 2.0 * Gms * my * sy + Gss * sy * sy + Gm * myy + Gs * syy,
            Gmm * my * mt + Gms * (my * st + mt * sy) + Gss * sy * st + Gm * myt + Gs * syt,
            Gmm * mt * mt + 2.0 * Gms * mt * st + Gss * st * st + Gm * mtt + Gs * stt)


def rest_gap(c):
    """g at which T_c(y, 0) = 0."""
    if c.law in laws.COHESIVE:
        return laws.rest(c)
    f = lambda g: float(potential(c, np.float64(g), np.float64(0.0))[1])
    return brentq(f, 0.4 * c.r0, 5.0 ** (-1 / 6) * c.r0, xtol=1e-17, rtol=1e-15)


def loads(c, g, th):
    """-T_c, -M_c and their derivatives to y and theta: (Ty, Tt), (My, Mt)."""
    if c.law == "surface-traction" and c.line_load != "axis-gap":
        T, M, Ty, Tt, My, Mt = laws.traction(c, g, th, _near)
    else:
        _, T, M, Ty, Tt, Mt = potential(c, g, th)
        My = Tt
    if c.line_load == "force-only":
        M = My = Mt = np.zeros_like(T)
    return T, M, Ty, Tt, My, Mt


POWER = {"neo-hookean": 2, "neo-hookean-wide": 3}


def stretched(c, N):
    """The strain of the axis under N, its slope and the energy stored.

    With lambda = 1 + strain and n = 2, or n = 3 of a section that keeps its width, N = EA (lambda - lambda^-n)/(n + 1): the root lambda > 0 of
    lambda^(n+1) - (n + 1) N/EA lambda^n = 1, by Newton's method in the logarithm of lambda.
    """
    if c.stretching == "linear":
        return N / c.EA, 1.0 / c.EA, 0.5 * N ** 2 / c.EA
    n, pull = POWER[c.stretching], N / c.EA
    log = np.arcsinh(0.5 * pull)
    for _ in range(60):
        step = (np.exp(log) - np.exp(-n * log) - (n + 1) * pull) / (np.exp(log) + n * np.exp(-n * log))
        log = log - step
        if np.max(np.abs(step)) < 1e-15:
            break
    stored = c.EA / (n + 1) * (0.5 * np.expm1(2.0 * log) + np.expm1((1 - n) * log) / (n - 1))
    return np.expm1(log), (n + 1) / c.EA / (1.0 + n * np.exp(-(n + 1) * log)), stored


def field(c, z, H, jac=True):
    """z' and its derivatives to z and H. z[..., :] = g, theta, V, M (, w (, H)); c: the section there (Strip.at)."""
    d = z.shape[-1]
    if d == 6 and c.friction is None:
        return sheared.field(c, z, field(c, z[..., :5], z[..., 5], jac), jac)
    if d == 6:
        return rubbing(c, z, jac)
    g, th, V, M = z[..., 0], z[..., 1], z[..., 2], z[..., 3]
    co, si = np.cos(th), np.sin(th)
    Tc, Mc, Ty, Tt, My, Mt = loads(c, g, th)
    b, ga = c.width, 1.0 / c.GA
    N, Q = H * co + V * si, V * co - H * si
    long, ea, _ = stretched(c, N)
    x1 = (1.0 + long) * co - Q * ga * si
    y1 = (1.0 + long) * si + Q * ga * co
    f = np.empty_like(z)
    f[..., 0] = y1 - 0.5 * c.rise
    f[..., 1] = M / c.EI + c.bend
    f[..., 2] = b * Tc
    f[..., 3] = -x1 * V + y1 * H + b * Mc
    if d == 5:
        f[..., 4] = long * co - Q * ga * si - 2.0 * np.sin(0.5 * th) ** 2
    if not jac:
        return f
    J = np.zeros(z.shape + (d,))
    y_t = x1 + Q * si * ea - N * co * ga
    y_V = si * si * ea + co * co * ga
    xy = si * co * (ea - ga)                      # dy'/dH = dx'/dV
    x_t = -y1 + Q * co * ea + N * si * ga
    J[..., 0, 1] = y_t
    J[..., 0, 2] = y_V
    J[..., 1, 3] = 1.0 / c.EI
    J[..., 2, 0] = b * Ty
    J[..., 2, 1] = b * Tt
    J[..., 3, 0] = b * My
    J[..., 3, 1] = -x_t * V + y_t * H + b * Mt
    J[..., 3, 2] = -x1 - xy * V + y_V * H
    if d == 4:
        return f, J, None
    J[..., 4, 1] = x_t
    J[..., 4, 2] = xy
    x_H = co * co * ea + si * si * ga
    fH = np.zeros_like(z)
    fH[..., 0] = xy
    fH[..., 3] = -x_H * V + y1 + xy * H
    fH[..., 4] = x_H
    return f, J, fH


def rubbing(c, z, jac):
    """The same with friction, where H changes along S and is the last of z."""
    t, t_g, t_th, t_w = c.friction.traction(c, z, _near)
    co, si, b = np.cos(z[..., 1]), np.sin(z[..., 1]), c.width
    arm = 0.5 * c.height * co
    f = np.empty_like(z)
    smooth = field(c, z[..., :5], z[..., 5], jac)
    f[..., :5] = smooth if not jac else smooth[0]
    f[..., 3] += b * t * arm
    f[..., 5] = b * t
    if not jac:
        return f
    J = np.zeros(z.shape + (6,))
    J[..., :5, :5], J[..., :5, 5] = smooth[1], smooth[2]
    for i, slope in ((0, t_g), (1, t_th), (4, t_w)):
        J[..., 5, i] = b * slope
        J[..., 3, i] += b * slope * arm
    J[..., 3, 1] -= b * t * 0.5 * c.height * si
    return f, J, None

"""Laws of adhesion beside Sauer's body forces: his surface traction, and cohesive laws between the near face and the substrate.

"surface-traction": eqs. (10) and (11), the traction T(r) cos on the bottom face and the opposite one on the top face,
    T_c = cos (T(r1) - T(r2)),   M_c = (h/2) sin cos (T(r1) + T(r2)),   r1 = y - (h/2) cos,   r2 = y + (h/2) cos,
each with the lever of its face. Without the far face |cos| is in place of cos in T_c and r1, and there is no T(r2). As
dT_c/dtheta - dM_c/dy = -sin (T(r1) - T(r2)) it has no potential; with U = W(r1) - W(r2),  T_c dy + M_c dtheta = -cos dU.

Cohesive: traction -strength s(t), t = (r - r_eq)/range, r = g + (h/2)(1 - cos) of the bonded face, or g for axis-gap. Psi(r) = -strength
range int_t^inf s. Where cos < 0 only what attracts acts on that face; what repels acts on the other, r = g + (h/2)(1 - |cos|). The largest s is 1; strength and work strength range int_0^inf s are those of the van der Waals half space.
"exponential" is s = t exp(1 - t). The others are piecewise linear with rounded corners, s = sum a_i ramp(p_i - t): with R'' the
kernel (35/32) (1 - x^2)^3, ramp(x) = e R(x/e) within the corner's e (C4). They hold nothing behind the last corner and go on linearly
before the first.
"""
import math
from dataclasses import dataclass

import numpy as np

RHO = 0.1                                                             # where the unrounded traction ceases to rise
ROUND = 0.5 * RHO                                                     # half-width of the corner there, the narrowest
TAIL = 0.3                                                            # of the corner at the end of the bilinear law
FALL = 0.2                                                            # what the falling flank of Dugdale's takes, corners half of that
SECOND = 1.0 / 9.0                                                    # moment of the kernel: int x^2 R''


def R(x):
    """R, R' and int_-1^x R of the ramp between -1 and 1."""
    q = x * x
    return (35.0 / 256.0 + 0.5 * x + 35.0 / 32.0 * q * (0.5 - q * (0.25 - q * (0.1 - q / 56.0))),
            0.5 + 35.0 / 32.0 * x * (1.0 - q * (1.0 - q * (0.6 - q / 7.0))),
            1.0 / 36.0 + 35.0 / 256.0 * x + 0.25 * q + 35.0 / 32.0 * x * q * (1.0 / 6.0 - q * (0.05 - q * (1.0 / 70.0 - q / 504.0))))


def ramp(x, e):
    """The ramp of half-width e, its derivative, its integral."""
    value, slope, below = R(np.clip(x / e, -1.0, 1.0))
    out, left = x >= e, x <= -e
    flat = lambda inside, beyond: np.where(out, beyond, np.where(left, 0.0, inside))
    return flat(e * value, x), flat(slope, 1.0), flat(e ** 2 * below, 0.5 * (x * x + SECOND * e ** 2))


@dataclass(frozen=True)
class Exponential:
    corners = ()
    whole = math.e                                                    # int_0^inf s

    def __call__(self, t):
        """s, s' and int_t^inf s."""
        decay = np.exp(1.0 - t)
        return t * decay, (1.0 - t) * decay, (1.0 + t) * decay


@dataclass(frozen=True)
class Pieces:
    """sum a_i ramp(p_i - t)"""
    heights: tuple
    places: tuple
    halves: tuple                                                     # e of each

    @property
    def corners(self):
        """Where the formula changes."""
        return tuple(sorted({round(p + side * e, 12) for p, e in zip(self.places, self.halves) for side in (-1, 1)}))

    @property
    def whole(self):
        return float(self(np.float64(0.0))[2])

    def __call__(self, t):
        s = slope = rest = 0.0
        for a, p, e in zip(self.heights, self.places, self.halves):
            value, up, below = ramp(p - t, e)
            s, slope, rest = s + a * value, slope - a * up, rest + a * below
        return s, slope, rest


def bilinear_scale():
    """c, that makes the largest s 1: at R' = 1 - RHO, where s/c = 1 + (x - R/(1 - RHO))/2."""
    x = 0.5
    for _ in range(60):
        x -= (R(x)[1] - (1.0 - RHO)) / (35.0 / 32.0 * (1.0 - x * x) ** 3)
    return 1.0 / (1.0 + 0.5 * (x - R(x)[0] / (1.0 - RHO)))


M = RHO / (1.0 - RHO)                                                 # slope of the bilinear law beyond its peak, over that before it
C = bilinear_scale()
COHESIVE = {"exponential": Exponential(), "bilinear": Pieces((C * M / RHO, -C * (1.0 + M) / RHO), (1.0, RHO), (TAIL, ROUND)),
            "dugdale": Pieces((1.0 / FALL, -1.0 / FALL, -1.0 / RHO), (1.0, 1.0 - FALL, RHO), (0.5 * FALL, 0.5 * FALL, ROUND))}


def rest(c):
    """The gap at which the half space neither pulls nor pushes."""
    return 15.0 ** (-1.0 / 6.0) * c.r0


def strength(c):
    """Largest attraction of the half space, GPa."""
    return 2.0 * math.sqrt(5.0) / 9.0 * c.K / c.r0


def work(c):
    """Work of adhesion of the half space, nN/nm."""
    return 15.0 ** (1.0 / 3.0) / 8.0 * c.K


def span(c):
    """The length `range` of the law, nm."""
    return work(c) / (strength(c) * COHESIVE[c.law].whole)


def opening(c, g, th, face=1.0):
    """t of the bonded face, (h/2)(1 - cos) above the gap g, or with face = sign(cos) of the face that looks down; and the first two
    derivatives of r to theta."""
    if c.line_load == "axis-gap":
        return (g - rest(c)) / span(c), np.zeros_like(g), np.zeros_like(g)
    half = 0.5 * c.height
    lift = half * (1.0 - face) + 2.0 * half * face * np.sin(0.5 * th) ** 2                # (h/2)(1 - face cos)
    return (g + lift - rest(c)) / span(c), half * face * np.sin(th), half * face * np.cos(th)


def cohesive(c, g, th):
    """Psi with its gradient (y, theta) and Hessian (yy, yt, tt). Where a section has turned over, cos < 0, its bonded face is attracted
    where it is open, and the other one repelled where it is pressed."""
    law = COHESIVE[c.law]
    over = (np.cos(th) < 0.0) & (c.line_load != "axis-gap")

    def part(face, counts, left_out):
        t, a, da = opening(c, g, th, face)
        s, slope, left = law(t)
        s, slope, left = np.where(counts(t), s, 0.0), np.where(counts(t), slope, 0.0), np.where(counts(t), left, 0.0) - left_out(t)
        f, k = strength(c) * s, strength(c) / span(c) * slope
        return np.stack([-strength(c) * span(c) * left, f, f * a, k, k * a, k * a * a + f * da])

    pulled = part(1.0, lambda t: ~over | (t > 0.0), lambda t: np.where(over & (t <= 0.0), -law.whole, 0.0))
    if not np.any(over):
        return tuple(pulled)
    return tuple(pulled + part(-1.0, lambda t: over & (t < 0.0), lambda t: np.where(over & (t < 0.0), law.whole, 0.0)))


def sharpness(c, g, th):
    """1/nm: one over the length in the gap on which the traction changes."""
    t, _, _ = opening(c, g, th)
    corners = COHESIVE[c.law].corners
    if not corners:
        return 1.0 / (span(c) * (1.0 + 0.3 * np.abs(t)))
    return 1.0 / (span(c) * (ROUND + np.min([np.abs(t - p) for p in corners], axis=0)))


def traction(c, g, th, half_space):
    """The surface traction: -T_c, -M_c and their derivatives, (Ty, Tt), (My, Mt)."""
    co, si = np.cos(th), np.sin(th)
    half = 0.5 * c.height
    both = si * co * half
    if c.far_face:
        _, T1, d1 = half_space(c, g + 2.0 * half * np.sin(0.5 * th) ** 2)
        _, T2, d2 = half_space(c, g + half * (1.0 + co))
        near, side = co, 1.0
        pull, push, d_pull, d_push = T1 - T2, T1 + T2, d1 - d2, d1 + d2
    else:
        lift = np.minimum(np.sin(0.5 * th) ** 2, np.cos(0.5 * th) ** 2)
        _, T1, d1 = half_space(c, g + 2.0 * half * lift)
        near, side = np.abs(co), np.sign(co)
        pull, push, d_pull, d_push = T1, T1, d1, d1
    return (-near * pull, -both * push, -near * d_pull, side * si * pull - both * d_push,
            -both * d_push, -half * (co * co - si * si) * push - half * half * si * si * near * d_pull)

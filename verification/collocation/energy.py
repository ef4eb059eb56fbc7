"""Energy and first integral of a solution, work of the grip along a path, and the plateau of a path."""
import math

import numpy as np

from .law import field, potential, stretched
from .curve import solution
from .mesh import mesh
from .system import Rule

FLAT = 0.01                                                           # a plateau is where |d ln P / d ln u| is below this
LEVEL = 1e-6                                                          # where it is below this the place does not matter


def energy(s, st):
    """Stored energy, less that of a pretension, and change of the adhesion energy since rest, aJ; for "force-only" the potential of the full law."""
    c = s.strip.at(st.points())
    z = st.inner()
    g, th, V, M = (z[..., i] for i in range(4))
    N, Q = st.H * np.cos(th) + V * np.sin(th), V * np.cos(th) - st.H * np.sin(th)
    density = stretched(c, N)[2] + 0.5 * Q ** 2 / c.GA + 0.5 * M ** 2 / c.EI
    rest = potential(c, np.float64(s.g0), np.float64(0.0))[0]
    density = density + c.width * (potential(c, g, th)[0] - rest)
    return float(np.diff(st.X) @ (density @ Rule(st.n).w)) - 0.5 * s.strip.pretension * s.strip.stretch


def first_integral(s, st):
    """H x' + V y' + M theta' - stored - b Psi at the nodes and collocation points: of a strip the same everywhere."""
    c = s.strip
    z = np.concatenate([st.zn, st.inner().reshape(-1, s.d)])
    f = field(c, z, st.H, jac=False)
    g, th, V, M = z[:, :4].T
    N, Q = st.H * np.cos(th) + V * np.sin(th), V * np.cos(th) - st.H * np.sin(th)
    long, _, along = stretched(c, N)
    x1 = (1 + long) * np.cos(th) - Q / c.GA * np.sin(th)
    stored = along + 0.5 * Q ** 2 / c.GA + 0.5 * M ** 2 / c.EI
    return st.H * x1 + V * f[:, 0] + M * f[:, 1] - stored - c.width * potential(c, g, th)[0]


def adhesion(s):
    """Of the strip at rest, -b Psi, nN."""
    return -s.strip.width * float(potential(s.strip, np.float64(s.g0), np.float64(0.0))[0])


def work(path, nodes):
    """Integral of P du from rest to lp1, aJ; where the grip turns as it goes, of P du + M dtheta.

    On every step of the path u and P (or P + M dtheta/du) are polynomials of the path length through its ends and `nodes` solutions between; the
    last one is followed to where u turns.
    """
    last = lp1_after(path)
    total = 0.0
    for i in range(last + 1):
        u, P = step_curve(path, i, nodes)
        slope = u.deriv()
        until = 1.0
        if i == last:
            until = min((r.real for r in slope.roots() if abs(r.imag) < 1e-9 and abs(r) <= 1.0), default=1.0)
        whole = (P * slope).integ()
        total += whole(until) - whole(-1.0)
    return total


def step_curve(path, i, nodes):
    """u and P (s.power) between path points i and i + 1 as Chebyshev series on [-1, 1]."""
    s = path.s
    t = -np.cos(np.linspace(0.0, np.pi, nodes + 2))
    a, b = path.labels[i:i + 2]
    inner = [solution(path, 0.5 * (a + b) + 0.5 * (b - a) * x) for x in t[1:-1]]
    states = [path.points[i], *inner, path.points[i + 1]]
    return (np.polynomial.Chebyshev.fit(t, [get(st) for st in states], nodes + 1, domain=[-1, 1]) for get in (s.u, s.power))


def plateau(path):
    """The force (nN) where |d ln P / d ln u| is least between peak and lp1; None where it is nowhere below FLAT.

    A load limit point is level too, but only for a moment: of three successive steps of the path the steepest counts. Around
    the flattest step ln P is a polynomial of ln u through five solutions on fine meshes, in a window that shrinks.
    """
    s, last = path.s, lp1_after(path)
    first = int(np.argmax([s.P(p) for p in path.points[:last]])) + 1
    u, P = np.log([[s.u(p), s.P(p)] for p in path.points[first:last + 1]]).T
    steepness = np.diff(P) / np.diff(u)
    i = 1 + int(np.argmin([np.abs(steepness[k - 1:k + 2]).max() for k in range(1, len(steepness) - 1)]))
    if abs(steepness[i]) > FLAT:
        return None
    level = np.abs(steepness[i - 1:i + 2]).max() < LEVEL
    here, there = path.labels[first + i:first + i + 2]
    centre, half = 0.5 * (here + there), 0.5 * (there - here)
    t, dense = np.linspace(-1.0, 1.0, 5), np.linspace(-1.0, 1.0, 2001)
    for _ in range(8):
        states = [refined(path, solution(path, centre + half * x)) for x in t]
        lnu, lnP = (np.polyfit(t, [math.log(get(st)) for st in states], 4) for get in (s.u, s.P))
        steepness = np.polyval(np.polyder(lnP), dense) / np.polyval(np.polyder(lnu), dense)
        best = dense[np.argmin(np.abs(steepness))]
        inside = abs(best) < 0.9
        if level or inside and half < 0.1 * (there - here):
            break
        half_next = half * (0.3 if inside else 1.0)
        centre = min(max(centre + half * best, path.labels[first] + half_next), path.labels[last] - half_next)
        half = half_next
    return math.exp(np.polyval(lnP, best))


def lp1_after(path):
    """The index of the last path point before lp1, or before the largest u where lp1 was not found."""
    s = path.s
    top = int(np.argmax([s.u(p) for p in path.points]))
    if "lp1" not in path.found:
        return top - 1
    return top if s.P(path.found["lp1"]) < s.P(path.points[top]) else top - 1     # P falls there


def refined(path, st):
    """A solution again, at its u, on a mesh as fine as that of a turning point."""
    s = path.s
    N, n, _ = path.fine
    _, load = mesh(s, st, N, quiet=1e-8)
    X, _ = mesh(s, st, max(N, int(load.sum() / 1.6)), quiet=1e-8)
    return s.held(st.moved(s.strip, X, n), s.u(st))

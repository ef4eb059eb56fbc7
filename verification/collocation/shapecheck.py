"""Shapes against numerical derivatives, a solution of a shape against a Runge-Kutta code, work of the grip against energy."""
import numpy as np

from .curve import held
from .energy import energy
from .selfcheck import check_again
from .system import System


def check_form(shape, h=1e-3):
    """Every derivative of a shape against central differences, between its ends."""
    S = np.concatenate([np.linspace(a, b, 43)[1:-1] for a, b in zip(shape.ends, shape.ends[1:])])
    difference = lambda get: (get(shape.form(S + h)) - get(shape.form(S - h))) / (2.0 * h)
    at = shape.form(S)
    pairs = ((at.rise, difference(lambda f: f.height)), (at.curl, difference(lambda f: f.rise)),
             (at.turn, difference(lambda f: f.angle)), (at.bend, difference(lambda f: f.slope)))
    worst = max(float(np.abs(a - b).max() / (np.abs(a).max() + 1e-3)) for a, b in pairs)
    g, slope = shape.free(S)
    rise = (shape.free(S + h)[0] - shape.free(S - h)[0]) / (2.0 * h)
    worst = max(worst, float(np.abs(rise - (np.sin(slope) - 0.5 * at.rise)).max()))
    print(f"h', h'', derivatives of angle and of theta0, rest curve of {shape} against central differences: worst {worst:.1e}")
    return worst < 1e-6


def check_solution(path):
    """The solution at lp1 of a path, integrated again."""
    print(f"lp1 of {path.s.strip}:")
    return check_again(path, path.found["lp1"])


def check_work(path, us, nodes=10):
    """Integral of P du between displacements (Gauss) against the change of stored and adhesion energy."""
    s = path.s
    x, w = np.polynomial.legendre.leggauss(nodes)
    done = 0.0
    for a, b in zip(us, us[1:]):
        done += 0.5 * (b - a) * sum(q * s.P(held(path, 0.5 * (a + b) + 0.5 * (b - a) * t)) for t, q in zip(x, w))
    changed = energy(s, held(path, us[-1])) - energy(s, held(path, us[0]))
    off = abs(done / changed - 1.0)
    print(f"work of the grip from u = {us[0]:g} to {us[-1]:g} nm, {s.strip}: {done:.12g} aJ, change of energy {changed:.12g} aJ, "
          f"differs by {off:.1e}")
    return off < 1e-9


def negative_eigenvalues(s, st, pieces=700):
    """Of the second variation of the energy where the grip holds displacement and rotation: the places between the tip and the
    grip where a disturbance that the free tip allows has neither (Jacobi's conjugate points)."""
    X = np.unique(np.concatenate([np.linspace(0.0, s.strip.length, pieces), st.X]))
    A = System(s.strip, st.moved(s.strip, X, 8)).A
    scale = s.scale(1)[:4, None]
    frame, sign, count = np.eye(4, 2), 1.0, 0
    for i in range(len(X) - 1):
        frame = (-A[4 * i:4 * i + 4, 4 * i:4 * i + 4] @ (frame * scale)) / scale
        frame, R = np.linalg.qr(frame)
        frame[:, 0] *= np.sign(np.linalg.det(R))
        now = np.sign(np.linalg.det(frame[:2]))
        count, sign = count + int(now != sign), now
    return count


def check_stable(path):
    """No negative eigenvalue at the beginning of a path that ends with lp1 and half-way, one behind lp1."""
    s = path.s
    counts = [negative_eigenvalues(s, path.points[i]) for i in (0, len(path.points) // 2, -1)]
    print(f"negative eigenvalues at rest, half-way, behind lp1 of {s.strip}: {counts}")
    return counts == [0, 0, 1]

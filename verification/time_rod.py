"""A soft rod that is spun up about one end, elastic and of Kelvin and Voigt's material.

Strong form of Reissner's beam in motion, with the section forces H and V along x and y, N = H cos θ + V sin θ, Q = V cos θ - H sin θ:

  ρA x.. = H',   ρA y.. = V',   ρI θ.. = M' + x' V - y' H,   N = EA (Γ1 + τ Γ1.),   Q = GA (Γ2 + τ Γ2.),   M = EI (θ' + τ θ'.)

collocated at Chebyshev's points along S and integrated in time by the Runge-Kutta method of Dormand and Prince of order 8, or where it
is viscous by the implicit method Radau. No finite elements, no generalised-α rule. At the hub S = 0 x = y = 0 and θ = ψ(t); at the free end Γ1 = Γ2 = θ' = 0, since a viscous end that is at rest
at first stays without strain. The values at the free end follow from those inside.

  ψ(t) = (Ω/T) [t²/2 + (T/2π)² (cos(2πt/T) - 1)] up to t = T, then Ω (t - T/2);   Ω = 3, T = 3.

L = 1, EA = 1000, GA = 400, EI = 1, ρA = 1, ρI = 0.01: soft, so that an explicit method can follow it where it is elastic; τ = 0.02 where it is viscous. Columns: how far the free
end is along and across the line of the hub beyond (L, 0).
"""

import numpy as np
import tables
from scipy.integrate import solve_ivp

LENGTH, EA, GA, EI, MASS, ROTARY = 1.0, 1000.0, 400.0, 1.0, 1.0, 0.01
SPEED, RISE = 3.0, 3.0
TIMES = np.arange(0.5, 5.01, 0.5)


def angle(time):
    """ψ."""
    if time >= RISE:
        return SPEED * (time - 0.5 * RISE)
    w = 2.0 * np.pi / RISE
    return SPEED / RISE * (0.5 * time**2 + (np.cos(w * time) - 1.0) / w**2)


def rate(time):
    """dψ/dt."""
    w = 2.0 * np.pi / RISE
    return SPEED if time >= RISE else SPEED / RISE * (time - np.sin(w * time) / w)


def chebyshev(points):
    """Places on [0, L], from the hub on, and the matrix of derivatives there."""
    k = np.arange(points)
    x = np.cos(np.pi * k / (points - 1))
    c = np.where((k == 0) | (k == points - 1), 2.0, 1.0) * (-1.0) ** k
    apart = x[:, None] - x[None, :] + np.eye(points)
    slope = np.outer(c, 1.0 / c) / apart
    slope -= np.diag(slope.sum(axis=1))
    return 0.5 * LENGTH * (1.0 - x), -slope * 2.0 / LENGTH


class Spin:
    """The rod with so many points and the retardation time τ."""

    def __init__(self, points, retardation):
        self.s, self.d = chebyshev(points)
        self.inside, self.retardation = points - 2, retardation
        self.start = np.concatenate([self.s[1:-1], np.zeros(5 * self.inside)])

    def ended(self, inside, hub, end_slope):
        """Values at all points from those inside, at the hub, and with this derivative at the free end."""
        last = self.d[-1]
        end = (end_slope - last[0] * hub - last[1:-1] @ inside) / last[-1]
        return np.concatenate([[hub], inside, [end]])

    def fields(self, time, state):
        """x, y, θ at all points, and their rates."""
        x, y, turn, dx, dy, dturn = state.reshape(6, self.inside)
        turn = self.ended(turn, angle(time), 0.0)
        dturn = self.ended(dturn, rate(time), 0.0)
        sin, cos = np.sin(turn[-1]), np.cos(turn[-1])
        x, y = self.ended(x, 0.0, cos), self.ended(y, 0.0, sin)
        dx, dy = self.ended(dx, 0.0, -sin * dturn[-1]), self.ended(dy, 0.0, cos * dturn[-1])
        return x, y, turn, dx, dy, dturn

    def slopes(self, time, state):
        """d/dt of what is inside."""
        x, y, turn, dx, dy, dturn = self.fields(time, state)
        d, tau = self.d, self.retardation
        sin, cos = np.sin(turn), np.cos(turn)
        xs, ys, dxs, dys = d @ x, d @ y, d @ dx, d @ dy
        along, across = xs * cos + ys * sin, ys * cos - xs * sin
        stretch, slide, bend = along - 1.0, across, d @ turn
        dstretch = dxs * cos + dys * sin + dturn * across
        dslide = dys * cos - dxs * sin - dturn * along
        dbend = d @ dturn
        n, q, m = EA * (stretch + tau * dstretch), GA * (slide + tau * dslide), EI * (bend + tau * dbend)
        h, v = n * cos - q * sin, n * sin + q * cos
        ax, ay = d @ h / MASS, d @ v / MASS
        aturn = (d @ m + xs * v - ys * h) / ROTARY
        own = slice(1, -1)
        return np.concatenate([dx[own], dy[own], dturn[own], ax[own], ay[own], aturn[own]])

    def tip(self, time, state):
        """How far the free end is along and across the line of the hub."""
        x, y, *_ = self.fields(time, state)
        sin, cos = np.sin(angle(time)), np.cos(angle(time))
        return x[-1] * cos + y[-1] * sin - LENGTH, y[-1] * cos - x[-1] * sin

    def rows(self, case, accuracy):
        """The tip at the times of the table."""
        method = "Radau" if self.retardation > 0.0 else "DOP853"
        found = solve_ivp(
            self.slopes, (0.0, TIMES[-1]), self.start, method=method, t_eval=TIMES, rtol=accuracy, atol=accuracy
        )
        for time, state in zip(found.t, found.y.T):
            along, across = self.tip(time, state)
            yield {"case": case, "time": float(time), "along": round(along, 9), "across": round(across, 9)}


def computed():
    """The rows of the table."""
    cases = [("elastic", Spin(14, 0.0), 1e-9), ("kelvin-voigt", Spin(12, 0.02), 1e-8)]
    return [row for case, spin, accuracy in cases for row in spin.rows(case, accuracy)]


REMARKS = ["Written by verification/time_rod.py; figures to about 4e-6, by which 10 and 14 points differ."]

if __name__ == "__main__":
    tables.run(__doc__.splitlines()[0], [("time_rod.csv", REMARKS, computed)], relative=1e-5, absolute=2e-6)

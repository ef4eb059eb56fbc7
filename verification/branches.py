"""Branches of trees in space that carry dead loads at their tips, for tree.py and seta.py. No finite elements, no quaternions; tree.py has the equations."""

import numpy as np
from scipy.integrate import solve_ivp


def frame(axis, width):
    """Directors of a straight branch along an axis, as columns; the third one is normal to the width."""
    first = axis / np.linalg.norm(axis)
    third = np.cross(first, width)
    third /= np.linalg.norm(third)
    return np.column_stack([first, np.cross(third, first), third])


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


class Branch:
    """A branch: stress-free directors where it begins, length, stiffnesses EA, GA, GA, GJ, EI2, EI3, K0, what it carries, the errors of its integration."""

    def __init__(self, start, length, stiffness, carries=((), None), bent=None, errors=(1e-13, 1e-14)):
        self.start, self.length, self.stiffness = start, length, stiffness
        self.children, self.tip = carries
        self.bent = np.zeros(3) if bent is None else bent
        self.relative, self.absolute = errors

    def tips(self):
        return [self.tip] if self.tip is not None else [tip for child in self.children for tip in child.tips()]

    def go(self, place, directors, force, moment):
        """Place, directors and moment at the far end, of as many solutions side by side as the last axis has."""
        count = moment.shape[-1]

        def slopes(_, flat):
            state = flat.reshape(15, count)
            r, m = state[3:12].reshape(3, 3, count), state[12:]
            own, turn = np.einsum("ijc,ic->jc", r, force), np.einsum("ijc,ic->jc", r, m)
            along = own / self.stiffness[:3, None]
            along[0] += 1.0
            forward = np.einsum("ijc,jc->ic", r, along)
            k = self.bent[:, None] + turn / self.stiffness[3:, None]
            d1, d2, d3 = r[:, 0], r[:, 1], r[:, 2]
            turning = np.stack([k[2] * d2 - k[1] * d3, k[0] * d3 - k[2] * d1, k[1] * d1 - k[0] * d2], axis=1)
            return np.concatenate([forward, turning.reshape(9, count), -cross(forward, force)]).ravel()

        start = np.concatenate([place, directors.reshape(9, count), moment]).astype(complex)
        found = solve_ivp(
            slopes, (0.0, self.length), start.ravel(), method="DOP853", rtol=self.relative, atol=self.absolute
        )
        end = found.y[:, -1].reshape(15, count)
        return end[:3], end[3:12].reshape(3, 3, count), end[12:]

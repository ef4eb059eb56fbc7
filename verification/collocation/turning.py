"""The turning points of a path as columns of a table, each solution held against what does not change along S."""
import math

import numpy as np

from .energy import adhesion, first_integral
from .path import TURNS

VALUES = [f"{kind}_{value}" for kind in TURNS for value in ("displacement_nm", "force_nN")]
SPREAD = 1e-11                                                        # of the integral along S, over adhesion and force


def turning_points(path, integral=first_integral, reach=math.inf):
    """{column: number}; None where a point does not occur, or the strip is off there: nowhere nearer than `reach` r0."""
    out = dict.fromkeys(VALUES)
    for kind in TURNS:
        if kind in path.found:
            s, st = path.s, path.found[kind]
            spread = np.ptp(integral(s, st)) / (adhesion(s) + abs(s.P(st)))
            if spread > SPREAD:
                raise ArithmeticError(f"{s.strip}: the first integral at {kind} differs by {spread:.1e} along S")
            if s.near(st.X, st.zn).min() <= reach * s.strip.r0:
                out[f"{kind}_displacement_nm"], out[f"{kind}_force_nN"] = s.u(st), s.P(st)
    return out

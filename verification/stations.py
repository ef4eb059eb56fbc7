#!/usr/bin/env python3
"""The strip of 100 nm wherever its path passes values of u, P, the rotation of the grip and the gap of its free end. Writes stations.csv."""
from dataclasses import dataclass

import numpy as np

from collocation.curve import passings  # first: one thread
from collocation.law import Strip
from collocation.path import Path
from collocation.suite import Suite, run

REMARKS = (
    "The strip of 100 nm of strip.csv wherever its path passes a value, computed without finite elements by verification/stations.py:",
    "displacement in nm, force in nN, rotation of the grip in degrees, gap of the free end in nm. passing: 1 for the first time that the path has the value, from rest on.",
    "The path goes over the peak at u = 0.25 nm and lp1 at 48.2 nm to lp2 at 23.4 nm. As in strip_variants.csv; good to the digits printed.",
)
PATHS = {}                                                            # sub-intervals of a level -> its path


@dataclass(frozen=True)
class Station:
    quantity: str = "displacement"
    value: float = 10.0
    passing: int = 1


def free_end_gap(s, st):
    """Of the nearer edge of the section at S = 0."""
    return st.zn[0, 0] + 0.5 * s.strip.height * (1.0 - np.cos(st.zn[0, 1]))


OF = {"displacement": lambda s, st: s.u(st), "force": lambda s, st: s.P(st), "end_rotation": lambda s, st: np.degrees(st.zn[-1, 1]),
      "free_end_gap": free_end_gap}


def row(s, quantity, st):
    """The derivative of a quantity by the unknowns."""
    N = len(st.X) - 1
    if quantity in ("displacement", "force"):
        return s.row("u" if quantity == "displacement" else "P", N)
    row = np.zeros(s.d * (N + 1) + (s.d == 5))
    if quantity == "free_end_gap":
        row[:2] = 1.0, 0.5 * s.strip.height * np.sin(st.zn[0, 1])
    else:
        row[s.d * N + 1] = np.degrees(1.0)
    return row


def compute(station, level, verbose):
    if level["N"] not in PATHS:
        PATHS[level["N"]] = Path(Strip(length=100.0), verbose=verbose, **level)
    path, of = PATHS[level["N"]], OF[station.quantity]

    def corrected(s, st):
        along = row(s, station.quantity, st)
        return s.correct(st, row=along, target=station.value - of(s, st) + along @ st.flat(), tol=1e-11, most=12)

    s, st = path.s, passings(path, of, station.value, corrected)[station.passing - 1]
    return {"displacement_nm": s.u(st), "force_nN": s.P(st), "end_rotation_deg": OF["end_rotation"](s, st)}


CASES = [Station(*case) for case in (
    ("displacement", 0.1, 1), ("displacement", 5.0, 1), ("displacement", 30.0, 1), ("displacement", 30.0, 2), ("displacement", 48.0, 1),
    ("displacement", 48.0, 2), ("force", 0.3, 1), ("force", 0.3, 2), ("force", 0.04, 1), ("force", 0.04, 2), ("force", 0.02, 1),
    ("end_rotation", 10.0, 1), ("end_rotation", 30.0, 1), ("free_end_gap", 0.25, 1), ("free_end_gap", 0.22, 1))]


if __name__ == "__main__":
    columns = ("quantity", "value", "passing", "displacement_nm", "force_nN", "end_rotation_deg")
    run(__doc__, Suite("stations.csv", REMARKS, CASES, columns, compute, defining={"quantity": "quantity", "value": "value", "passing": "passing"},
                       paper=Station()))

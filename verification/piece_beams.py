#!/usr/bin/env python3
"""Beams given piece by piece: force at rest, peaks, first displacement limit point. Writes piece_beams.csv."""
from dataclasses import replace

import spatula  # first: one thread
import numpy as np

from collocation import shapecheck
from collocation.digits import LEVELS
from collocation.path import Path
from collocation.shapes import Pieces, Spatula
from collocation.suite import Suite, run

REMARKS = (
    "Beams given piece by piece, computed without finite elements by verification/piece_beams.py. Their pieces: profiles/NAME.csv, from the tip to the grip;",
    "along a piece each quantity goes from its first value to its last in proportion to S, or smoothly, with s5; bend: of the underside free of stress.",
    "Numbers and names as in spatula.csv, good to the digits printed.",
)
DEFINING = {"profile": "name", "grip_rotation": "rotation"}
COLUMNS = (*DEFINING, *spatula.VALUES)
CASES = [Pieces(name=name, rotation=rotation) for name in ("stepped", "raised", "wedge", "lobe") for rotation in ("free", "fixed")]
NECK = Spatula(neck_length=50.0)                                      # which bends where its neck is: three pieces


def check_forms():
    return all([shapecheck.check_form(shape) for shape in CASES[::2]])


def check_spatula():
    """The three pieces of profiles/neck.csv against the formulas of a spatula."""
    S = np.linspace(0.0, NECK.length, 4001)
    pieces, whole = (np.array(np.broadcast_arrays(*vars(shape.form(S)).values())) for shape in (Pieces(name="neck"), NECK))
    off = float((np.abs(pieces - whole).max(axis=1) / np.maximum(np.abs(whole).max(axis=1), 1e-3)).max())
    print(f"three pieces against the formulas of a spatula: differ by {off:.1e}")
    return off < 1e-12


def check_solutions():
    """Those with a jump of the width and with every kind of piece: solution and stability; work of the latter."""
    jump, every = (Path(replace(CASES[i], rotation="fixed"), **dict(LEVELS[1], want=("peak", "lp1"))) for i in (0, 6))
    solved = all([shapecheck.check_solution(path) and shapecheck.check_stable(path) for path in (jump, every)])
    return solved and shapecheck.check_work(every, (0, 25, 50, 75, 100, 115, 125, 135, 150, 175, 200))


if __name__ == "__main__":
    run(__doc__, Suite("piece_beams.csv", REMARKS, CASES, COLUMNS, spatula.compute, defining=DEFINING, paper=CASES[0]),
        (check_forms, check_spatula), (check_solutions,))

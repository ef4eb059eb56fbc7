"""Draws 200 scenes on which error bounds are judged, and writes bound_scenes.csv.

Logarithmically uniform in length, EI factor, height, Hamaker constant and equilibrium distance; the rotation of the grip by the
toss of a coin. numpy's PCG64 with a fixed seed gives the same scenes everywhere.
"""

import numpy as np

from tables import run

SEED = 20260731
SCENES = 200
RANGES = {
    "length_nm": (30.0, 3000.0),
    "bending_stiffness_factor": (1e-4, 1e2),
    "height_nm": (3.0, 30.0),
    "hamaker_constant_aJ": (0.01, 1.0),
    "equilibrium_distance_nm": (0.2, 1.0),
}


def scenes():
    generator = np.random.Generator(np.random.PCG64(SEED))
    rows = []
    for number in range(1, SCENES + 1):
        row = {"scene": number}
        for name, (least, most) in RANGES.items():
            value = least * (most / least) ** generator.random()
            row[name] = f"{value:.4g}"
        row["grip_rotation"] = "fixed" if generator.random() < 0.5 else "free"
        rows.append(row)
    return rows


REMARKS = [
    "Scenes drawn by verification/bound_scenes.py: E = 2 GPa, nu = 0.2, width 1 nm, full line load, grip free to slide.",
    "hamaker_constant_aJ: 0.1 aJ = 1e-19 J is the paper's.",
]

if __name__ == "__main__":
    run(__doc__.splitlines()[0], [("bound_scenes.csv", REMARKS, scenes)])

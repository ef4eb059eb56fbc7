"""A tree of beams in space under dead loads at its tips, by shooting from the root. No finite elements, no quaternions.

No load acts along a branch, so that its section force n is constant in space: the sum of the forces of the tips that it carries. With directors
R as a matrix of nine numbers and the moment m about x, y and z,

  r' = R (e1 + G),   R' = R K×,   m' = -r' × n,
  G = (d1·n/EA, d2·n/GA, d3·n/GA),   K = K0 + (d1·m/GJ, d2·m/EI2, d3·m/EI3).

At a joint every branch begins with the place of the one before and with its directors, turned by the angle of the branch, R0(branch); the moments of
what leaves the joint sum up to the one that comes. Unknowns are the moment at the root and, at each fork, that of its first branch; as many equations
say that the moment at every tip is the one that is given. Newton's method; derivatives from complex steps of 1e-40; loads grow in steps.

    python verification/tree.py             # writes tree.csv: 5 s
    python verification/tree.py --check     # against the table, to 1e-9; exit 1 on a mismatch
    python verification/tree.py --quick     # the first case alone
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy as np

from branches import Branch, frame

RELATIVE, ABSOLUTE = 1e-13, 1e-14
TINY = 1e-40
STEPS = 10
TABLE = Path(__file__).with_name("tree.csv")

# EA, GA, GJ, EI2, EI3 of the shaft, a limb and a twig
LEVELS = [
    np.array([4000.0, 1500.0, 1500.0, 300.0, 400.0, 500.0]),
    np.array([2000.0, 800.0, 800.0, 90.0, 150.0, 100.0]),
    np.array([1000.0, 400.0, 400.0, 25.0, 40.0, 30.0]),
]
BENT = np.array([0.02, 0.1, -0.05])
WIDTH = np.array([0.0, 1.0, 0.3])
TIPS = 4

# force (nN) and moment (nN nm) at each tip, in the order of the tips
CASES = {
    "tips apart": [
        [(-2.0, 1.0, 3.0), (0.0, 0.0, 0.0)],
        [(-3.0, -1.0, -2.0), (0.0, 0.0, 0.0)],
        [(4.0, 0.5, 1.0), (0.0, 0.0, 0.0)],
        [(2.0, 2.0, -3.0), (0.0, 0.0, 0.0)],
    ],
    "bent over": [
        [(4.0, 0.0, -1.0), (0.0, 0.0, 0.0)],
        [(4.0, 1.0, -1.0), (0.0, 0.0, 0.0)],
        [(3.0, 0.0, -2.0), (0.0, 0.0, 0.0)],
        [(5.0, -2.0, -1.0), (0.0, 0.0, 0.0)],
    ],
    "twisted": [
        [(0.0, 2.0, 0.0), (1.0, 0.0, 6.0)],
        [(0.0, 2.0, 1.0), (0.0, -3.0, 2.0)],
        [(0.0, -2.0, 0.0), (0.0, 0.0, 6.0)],
        [(1.0, -2.0, 0.0), (3.0, 2.0, -1.0)],
    ],
}


def branch(axis, length, level, children=(), tip=None, bent=None):
    start = frame(np.array(axis, dtype=float), WIDTH)
    return Branch(start, length, LEVELS[level], (children, tip), bent, (RELATIVE, ABSOLUTE))


def tree():
    sin, cos = np.sin(np.radians(40.0)), np.cos(np.radians(40.0))
    twigs = [
        branch([-0.5, -0.6, 1.0], 4.0, 2, tip=0),
        branch([-0.3, 0.6, 1.0], 4.0, 2, tip=1),
        branch([0.3, -0.6, 1.0], 4.0, 2, tip=2),
        branch([0.5, 0.6, 1.0], 4.0, 2, tip=3, bent=BENT),
    ]
    limbs = [branch([-sin, 0.0, cos], 6.0, 1, twigs[:2]), branch([sin, 0.0, cos], 6.0, 1, twigs[2:])]
    return branch([0.0, 0.0, 1.0], 10.0, 0, limbs)


def shoot(root, loads, unknown):
    """Places of the tips, and by how much their moments miss what is given; a column for each of the unknowns, which is moved there."""
    count = len(unknown)
    moved = unknown[:, None] + 1j * TINY * np.eye(count)
    places, misses, moments = [None] * TIPS, [None] * TIPS, list(moved.reshape(-1, 3, count))

    def follow(branch, place, directors, moment):
        force = sum(np.array(loads[tip][0]) for tip in branch.tips())
        place, directors, moment = branch.go(place, directors, np.repeat(force[:, None], count, axis=1), moment)
        if branch.tip is not None:
            places[branch.tip], misses[branch.tip] = place, moment - np.array(loads[branch.tip][1])[:, None]
            return
        first, second = branch.children
        share = moments.pop(0)
        for child, own in ((first, share), (second, moment - share)):
            # straight branches have the same directors at both ends at rest
            turned = np.einsum("ijc,jk->ikc", directors, branch.start.T @ child.start)
            follow(child, place, turned, own)

    start = np.repeat(root.start[:, :, None], count, axis=2)
    follow(root, np.zeros((3, count)), start, moments.pop(0))
    return np.array(places), np.concatenate(misses)


def solve(loads):
    """Places of the tips and the moment at the root."""
    root, unknown, before = tree(), np.zeros(12), np.zeros(12)
    for step in range(1, STEPS + 1):
        unknown, before = 2.0 * unknown - before, unknown
        share = [[tuple(step / STEPS * x for x in part) for part in tip] for tip in loads]
        for _ in range(15):
            places, miss = shoot(root, share, unknown)
            update = np.linalg.solve(miss.imag / TINY, miss[:, 0].real)
            unknown = unknown - update
            if np.abs(update).max() < (1e-11 if step == STEPS else 1e-4) * max(1.0, np.abs(unknown).max()):
                break
        else:
            raise RuntimeError(f"no solution at {step} of {STEPS} of the load")
    places, _ = shoot(root, loads, unknown)
    return places[:, :, 0].real, unknown[:3]


def rows(names):
    for name in names:
        places, moment = solve(CASES[name])
        for tip in range(TIPS):
            load = CASES[name][tip][0] + CASES[name][tip][1]
            yield [name, tip, *load, *places[tip], *moment]


HEAD = "case,tip,fx_nN,fy_nN,fz_nN,mx_nN_nm,my_nN_nm,mz_nN_nm,x_nm,y_nm,z_nm,root_mx_nN_nm,root_my_nN_nm,root_mz_nN_nm"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    names = list(CASES)[:1] if options.quick else list(CASES)
    found = list(rows(names))
    if not options.check and not options.quick:
        with open(TABLE, "w", newline="") as file:
            file.write(HEAD + "\n")
            file.writelines(
                ",".join([row[0], str(row[1])] + [f"{x:g}" for x in row[2:8]] + [f"{x:.11g}" for x in row[8:]]) + "\n"
                for row in found
            )
        return 0
    with open(TABLE) as file:
        known = list(csv.reader(file))[1:]
    worst = max(
        abs(a - float(b)) / max(1.0, abs(a)) for row, own in zip(found, known) for a, b in zip(row[2:], own[2:])
    )
    print(f"{len(found)} rows, largest difference {worst:.1e}")
    return int(not worst < 1e-9)


if __name__ == "__main__":
    sys.exit(main())

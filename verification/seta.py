"""A small seta with four tips on the ground, by shooting from the root. No finite elements, no quaternions.

The strong form is that of tree.py, with circular sections. A tip at r, whose place of adhesion is a, is pulled by the ground with

  f = -P(y - a_y) e_y - k ((x - a_x) e_x + (z - a_z) e_z),

P the curve of the tip, cubics between its points; no force on it once it is detached, and never a moment. The root is moved by u along y and does
not turn. Unknowns are the moment at the root, at each fork that of its first branch, and the forces of the tips; at the loss of stability u as well, with
the height η of the tip given that is pulled farthest: stability is lost where du/dη = 0, found by the secant method, or at the end of its curve where that comes first. Then that tip is detached with u held.
Newton's method; derivatives from complex steps of 1e-40.

    python verification/seta.py             # writes seta.csv: two minutes of CPU
    python verification/seta.py --check     # against the table, to 1e-8; exit 1 on a mismatch
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy as np

from branches import Branch, frame

RELATIVE, ABSOLUTE = 1e-12, 1e-11
TINY = 1e-40
TABLE = Path(__file__).with_name("seta.csv")

# nm, nN, GPa, rad
PITCH, SHAFT, BRUSH, RATIO, SCATTER = 600.0, 4000.0, 1500.0, 0.6, 20.0
SHAFT_ANGLE, BRUSH_ANGLE = np.radians(30.0), np.radians(20.0)
DIAMETERS = 250.0 * 0.625 ** np.arange(3)
YOUNG, POISSON, SHEAR = 2.0, 0.2, 0.9
TIPS = 4
# u, P, dP/du
CURVE = np.array([
    (-50.0, -0.4, 0.009),
    (0.0, 0.1, 0.012),
    (100.0, 2.1, 0.035),
    (200.0, 4.7, 0.007),
    (300.0, 5.8, 0.013),
    (361.0, 6.67, 0.0),
    (364.0, 6.5, -0.2),
])
SIDEWAYS = {"free": 0.0, "held": 0.5}


def pull(u):
    """P, with complex u."""
    k = min(max(np.searchsorted(CURVE[:, 0], u.real.flat[0], side="right") - 1, 0), len(CURVE) - 2)
    (u0, p0, s0), (u1, p1, s1) = CURVE[k], CURVE[k + 1]
    length = u1 - u0
    t = (u - u0) / length
    return (
        (1 + 2 * t) * (1 - t) ** 2 * p0 + t * (1 - t) ** 2 * length * s0
        + t * t * (3 - 2 * t) * p1 + t * t * (t - 1) * length * s1
    )


def stiffness(generation):
    d = DIAMETERS[generation]
    area, second = np.pi * d**2 / 4, np.pi * d**4 / 64
    shear = YOUNG / (2 * (1 + POISSON))
    return np.array([
        YOUNG * area, SHEAR * shear * area, SHEAR * shear * area, 2 * shear * second, YOUNG * second, YOUNG * second
    ])


def places():
    """Joints by generation: the root, the first fork, two forks, four tips."""
    last = RATIO**2
    heights = BRUSH * (RATIO ** np.arange(3) - last) / (1 - last)
    lean = np.tan(BRUSH_ANGLE)
    fork = np.array([heights[0] * lean, heights[0], 0.0])
    root = fork + SHAFT * np.array([np.sin(SHAFT_ANGLE), np.cos(SHAFT_ANGLE), 0.0])
    forks = [np.array([heights[1] * lean + side * PITCH / 2, heights[1], 0.0]) for side in (-1, 1)]
    tips = []
    for tip in range(TIPS):
        x, z = (-1, 1)[tip // 2] * PITCH / 2, (-1, 1)[tip % 2] * PITCH / 2
        scatter = SCATTER * (2 * ((0.618034 * tip) % 1.0) - 1)
        tips.append(np.array([x, scatter, z]))
    return root, fork, forks, tips


def branch(ends, generation, children=(), tip=None):
    axis = ends[1] - ends[0]
    start = frame(axis, [0.0, 0.0, 1.0])
    return Branch(start, np.linalg.norm(axis), stiffness(generation), (children, tip), None, (RELATIVE, ABSOLUTE))


ROOT, FORK, FORKS, TIP_PLACES = places()
FEET = [np.array([place[0], 0.0, place[2]]) for place in TIP_PLACES]


def seta():
    twigs = [branch((FORKS[tip // 2], TIP_PLACES[tip]), 2, tip=tip) for tip in range(TIPS)]
    limbs = [branch((FORK, FORKS[k]), 1, twigs[2 * k : 2 * k + 2]) for k in range(2)]
    return branch((ROOT, FORK), 0, limbs)


TREE = seta()


def shoot(unknown, sideways, attached, watched):
    """By how much the equations are missed, a column for each unknown moved, and the places of the tips.

    Unknowns: four moments, the forces on the tips, u. The last equation gives u, or the height of the watched tip.
    """
    count = len(unknown)
    moved = unknown[:, None] + 1j * TINY * np.eye(count)
    moments, forces, u = list(moved[:12].reshape(4, 3, count)), moved[12:24].reshape(TIPS, 3, count), moved[24]
    ends, misses = [None] * TIPS, []

    def follow(branch, place, directors, moment):
        force = sum(forces[tip] for tip in branch.tips())
        place, directors, moment = branch.go(place, directors, force, moment)
        if branch.tip is not None:
            ends[branch.tip] = place
            misses.append(moment)
            return
        first, second = branch.children
        share = moments.pop(0)
        for child, own in ((first, share), (second, moment - share)):
            turned = np.einsum("ijc,jk->ikc", directors, branch.start.T @ child.start)
            follow(child, place, turned, own)

    start = np.repeat(ROOT[:, None], count, axis=1).astype(complex)
    start[1] += u
    follow(TREE, start, np.repeat(TREE.start[:, :, None], count, axis=2), moments.pop(0))
    for tip in range(TIPS):
        away = ends[tip] - FEET[tip][:, None]
        law = np.array([sideways * away[0], pull(away[1]), sideways * away[2]])
        misses.append(forces[tip] + law if tip in attached else forces[tip])
    misses.append((u if watched is None else ends[watched][1])[None, :])
    return np.concatenate(misses), np.array(ends)


def solve(unknown, sideways, attached, watched, target):
    """The equilibrium; its places and du/dη."""
    for _ in range(40):
        miss, ends = shoot(unknown, sideways, attached, watched)
        residual = miss[:, 0].real.copy()
        residual[24] -= target
        jacobian = miss.imag / TINY
        update = np.linalg.solve(jacobian, residual)
        size = (np.abs(update) / np.maximum(1.0, np.abs(unknown))).max()
        unknown = unknown - min(1.0, 20.0 / np.abs(update[12:]).max()) * update
        if size < 1e-8:
            along = np.linalg.solve(jacobian, np.eye(25)[24])
            # the places behind the last update
            ends = ends[:, :, 0].real - np.einsum("tic,c->ti", ends.imag / TINY, update)
            return unknown, ends, along[24]
    raise RuntimeError(f"no solution at {target}")


def rows():
    everyone = range(TIPS)
    for name, sideways in SIDEWAYS.items():
        unknown, _, _ = solve(np.zeros(25), sideways, everyone, None, 0.0)
        for u in (100.0, 250.0):
            unknown, ends, _ = solve(unknown, sideways, everyone, None, u)
            yield from row(name, unknown, ends)
        # on to the loss of stability
        while ends[:, 1].max() < 340.0:
            watched = int(np.argmax(ends[:, 1]))
            unknown, ends, _ = solve(unknown, sideways, everyone, watched, ends[watched, 1] + 25.0)
        watched = int(np.argmax(ends[:, 1]))
        end, known = CURVE[-1, 0], unknown
        unknown, ends, slope = solve(known, sideways, everyone, watched, end)
        if slope <= 0.0:
            unknown, ends = turn(known, sideways, watched)
        yield from row(name + " loss", unknown, ends)
        rest = [tip for tip in everyone if tip != watched]
        unknown, ends, _ = solve(unknown, sideways, rest, None, unknown[24])
        yield from row(name + " after", unknown, ends)


def turn(unknown, sideways, watched):
    """Where du/dη = 0."""
    heights, slopes = [362.0, 363.0], []
    for height in heights:
        unknown, ends, slope = solve(unknown, sideways, range(TIPS), watched, height)
        slopes.append(slope)
    while abs(heights[-1] - heights[-2]) > 1e-7 and abs(slopes[-1]) > 1e-12:
        ahead = -slopes[-1] * (heights[-1] - heights[-2]) / (slopes[-1] - slopes[-2])
        heights.append(heights[-1] + ahead)
        unknown, ends, slope = solve(unknown, sideways, range(TIPS), watched, heights[-1])
        slopes.append(slope)
    return unknown, ends


def row(case, unknown, ends):
    force = -unknown[12:24].reshape(TIPS, 3).sum(axis=0)
    for tip in range(TIPS):
        yield [case, tip, unknown[24], *force, *ends[tip]]


HEAD = "case,tip,displacement_nm,root_fx_nN,root_fy_nN,root_fz_nN,x_nm,y_nm,z_nm"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    found = list(rows())
    if not options.check:
        with open(TABLE, "w", newline="") as file:
            file.write(HEAD + "\n")
            file.writelines(
                ",".join([own[0], str(own[1])] + [f"{x:.11g}" for x in own[2:]]) + "\n" for own in found
            )
        return 0
    with open(TABLE) as file:
        known = list(csv.reader(file))[1:]
    worst = max(
        abs(a - float(b)) / max(1.0, abs(a)) for own, kept in zip(found, known) for a, b in zip(own[2:], kept[2:])
    )
    print(f"{len(found)} rows, largest difference {worst:.1e}")
    return int(not (worst < 1e-8 and len(found) == len(known)))


if __name__ == "__main__":
    sys.exit(main())

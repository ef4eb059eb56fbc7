"""A tilted piece of strip made of atoms over an endless lattice, without the crate.

The piece (10 nm x 10 nm, one row of atoms to a spacing of width) and the half space below it are simple cubic with the spacing a; an atom
stands for a^3 of the continuum, whose surfaces lie half a spacing outside the first planes. The lattice half space has its planes at
y = -a/2, -3a/2, ... and atoms at x = i a, z = j a; the centre of the piece is at x = 0, its row at z = 0.

Every atom of the piece feels the whole half space by Poisson's sum over each plane (Steele 1973): planes by Hurwitz's zeta function, the
ripples by Bessel functions with -d/dz [(g/2z)^v K_v(gz)] = (g/2z)^v g K_(v+1)(gz), along the plane g sin(g x) in the place of the cosine.
"""

import numpy as np
from scipy.special import gamma, kv, zeta

import tables
from pair_to_half_space import DENSITY, DEPTH, R0

LENGTH = HEIGHT = 10.0


def atom_force(power, x, z):
    """Force (along x, away from the lattice) of a sum of r^-power on atoms at x and z above the first plane; lengths in spacings."""
    away, along = 2 * np.pi * zeta(power - 1, z), np.zeros_like(z)
    order = power / 2 - 1
    for k in range(8):
        near = z + k < 6
        if not near.any():
            break
        depth, place = z[near] + k, x[near]
        for i in range(-6, 7):
            for j in range(-6, 7):
                g = 2 * np.pi * np.hypot(i, j)
                if g == 0:
                    continue
                factor = 2 * np.pi / gamma(power / 2) * (g / (2 * depth)) ** order
                away[near] += factor * g * kv(order + 1, g * depth) * np.cos(2 * np.pi * i * place)
                along[near] += factor * kv(order, g * depth) * 2 * np.pi * i * np.sin(2 * np.pi * i * place)
    return along, away


def piece(spacing, degrees, gap):
    """Force and moment about the centre, per width."""
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    count = round(LENGTH / spacing)
    at = (np.arange(count) + 0.5) * spacing - LENGTH / 2
    S, s = (v.ravel() for v in np.meshgrid(at, at))
    x, lift = S * cos - s * sin, S * sin + s * cos
    y = gap + LENGTH / 2 * sin + HEIGHT / 2 * cos + lift
    depth = DEPTH * (DENSITY * spacing**3) ** 2  # of eq. (1), so that A_H stays
    along, away = 0.0, 0.0
    for power, factor in [(12, depth * (R0 / spacing) ** 12), (6, -2 * depth * (R0 / spacing) ** 6)]:
        fx, fy = atom_force(power, x / spacing, y / spacing + 0.5)
        along, away = along + factor * fx / spacing**2, away + factor * fy / spacing**2  # per width of one spacing
    return np.sum(away), np.sum(x * away - lift * along)


def pieces():
    rows = []
    for degrees, gap in [(20, 0.4), (70, 0.4), (20, 1.0), (5, 1.0)]:
        continuum = [r for r in tables.read("pieces.csv") if float(r["tilt_deg"]) == degrees and float(r["corner_gap_nm"]) == gap][0]
        for spacing in [0.4, 0.2, 0.1, 0.05]:
            force, moment = piece(spacing, degrees, gap)
            rows.append(
                {
                    "tilt_deg": degrees,
                    "corner_gap_nm": gap,
                    "spacing_nm": spacing,
                    "force": force,
                    "moment": moment,
                    "force_error": force / float(continuum["force"]) - 1,
                }
            )
    return rows


if __name__ == "__main__":
    tables.run(
        __doc__.splitlines()[0],
        [
            (
                "piece_of_atoms.csv",
                [
                    "A tilted piece of strip of 10 nm x 10 nm made of atoms, over an endless simple cubic lattice; A_H = 0.1 aJ, r0 = 0.4 nm.",
                    "force nN/nm, moment about the centre nN, per width. force_error: over the continuum (pieces.csv), minus 1.",
                    "Good to 9 digits: Poisson's sum, 12 reciprocal vectors each way, ripples of atoms nearer than 6 spacings (the rest below 1e-14).",
                ],
                pieces,
            )
        ],
    )

"""From the pair potential to the half space: eqs. (1)-(7), (9), (10), (18) and Hamaker's identity, without the crate.

Half space. For a power r^-n the ring integral over a plane at the distance z is 2 pi z^(2-n)/(n-2); the half space adds the planes
z > r: 2 pi r^(3-n)/((n-2)(n-3)). With eq. (1) a point at the distance r has the energy

    Phi(r) = beta eps [2 pi r0^12/(90 r^9) - 2 * 2 pi r0^6/(12 r^3)] = pi beta eps r0^3 [(r0/r)^9/45 - (r0/r)^3/3],

and b = -Phi' is eq. (9). Times the density of the other body the factors pi beta1 beta2 eps r0^2 of eq. (9) and A_H/(2 pi r0^4) are
the same: A_H = 2 pi^2 beta1 beta2 eps r0^6. The table half_space.csv does not use any of this: it integrates eq. (1) by tanh-sinh.

Lattices. Two cubes: eq. (2) by multiplicities of difference vectors, eq. (3) by the density of difference vectors. An endless simple
cubic lattice (spacing a, density 1/a^3, continuum surface a/2 outside the first plane): by Poisson's sum over each plane and
Hurwitz's zeta function over the planes (Steele 1973).
"""

import numpy as np
from mpmath import mp, mpf
from scipy.optimize import brentq, minimize_scalar
from scipy.special import gamma, kv, zeta

import tables

mp.dps = 25
R0 = 0.4  # nm
HAMAKER = 0.1  # nN nm
DENSITY = 1 / R0**3  # atoms/nm^3 of either body: simple cubic of spacing r0
DEPTH = HAMAKER / (2 * np.pi**2 * DENSITY**2 * R0**6)  # nN nm


def pair_energy(r):
    """Eq. (1)."""
    q6 = (R0 / r) ** 6
    return DEPTH * (q6 * q6 - 2 * q6)


def pair_force(r):
    """-phi'(r), positive where it pushes apart."""
    q6 = (R0 / r) ** 6
    return 12 * DEPTH / r * (q6 * q6 - q6)


# ---- the half space by quadrature


def half_space():
    rows = []
    for ratio in ["0.55", "0.65", "0.78", "0.8909", "1", "1.5", "3", "5.69", "25"]:
        r = mpf(ratio) * mpf("0.4")

        def over_planes(weight, of_distance):
            # t = r/z runs over the planes, angle over the rings of a plane
            def ring(t, angle):
                z = r / t
                distance = z / mp.cos(angle)
                area = 2 * mp.pi * z**2 * mp.tan(angle) / mp.cos(angle) ** 2
                return weight(z) * of_distance(distance, z) * area * r / t**2

            return DENSITY**2 * mp.quad(ring, [0, 1], [0, mp.pi / 2])

        rows.append(
            {
                "distance_nm": float(r),
                "body_force": over_planes(lambda z: 1, lambda d, z: pair_force(d) * z / d),
                "traction": over_planes(lambda z: 1, lambda d, z: pair_energy(d)),
                "potential": over_planes(lambda z: z - r, lambda d, z: pair_energy(d)),
            }
        )
    return rows


# ---- two cubes, eqs. (2) and (3)

SIDE = 2.0


def cube_lattice(count, gap):
    """Energy and force of two cubes of count^3 atoms each that face each other; spacing SIDE/count, same density as DENSITY."""
    a = SIDE / count
    across = np.arange(-count + 1, count)
    weight = count - np.abs(across)
    y = gap + SIDE + across * a
    x2 = (across * a) ** 2
    r = np.sqrt(x2[:, None, None] + x2[None, :, None] + (y**2)[None, None, :])
    many = weight[:, None, None] * weight[None, :, None] * weight[None, None, :]
    scale = (DENSITY * a**3) ** 2  # each atom stands for the volume a^3
    return scale * np.sum(many * pair_energy(r)), scale * np.sum(many * pair_force(r) * y / r)


def cube_continuum(gap, points):
    x, w = np.polynomial.legendre.leggauss(points)
    up, wu = 0.5 * SIDE * (x + 1), 0.5 * SIDE * w
    across, wa = up, 2 * wu * (SIDE - up)
    v = np.concatenate([up - SIDE, up])
    wv = np.concatenate([wu, wu]) * (SIDE - np.abs(v))
    y = gap + SIDE + v
    r = np.sqrt((across**2)[:, None, None] + (across**2)[None, :, None] + (y**2)[None, None, :])
    many = DENSITY**2 * wa[:, None, None] * wa[None, :, None] * wv[None, None, :]
    return np.sum(many * pair_energy(r)), np.sum(many * pair_force(r) * y / r)


def cubes():
    rows = []
    for gap in [0.4, 0.6, 1.0, 2.0]:
        energy, force = cube_continuum(gap, 70)
        assert np.allclose(cube_continuum(gap, 90), (energy, force), rtol=1e-11, atol=0)
        for count in [5, 10, 20, 40]:
            e, f = cube_lattice(count, gap)
            rows.append(
                {
                    "gap_nm": gap,
                    "atoms_along_an_edge": count,
                    "gap_over_spacing": gap * count / SIDE,
                    "lattice_energy_aJ": e,
                    "lattice_force_nN": f,
                    "continuum_energy_aJ": energy,
                    "continuum_force_nN": force,
                    "energy_error": e / energy - 1,
                    "force_error": f / force - 1,
                }
            )
    return rows


# ---- endless lattices

REGISTRIES = {"mean": None, "top": (0.0, 0.0), "hollow": (0.5, 0.5)}


def plane_ripple(power, z, registry):
    """The part of -d/dz sum r^-power over a square lattice of spacing 1 that varies along the plane, at the height z."""
    if registry is None:
        return 0.0
    order = power / 2 - 1
    total = 0.0
    for i in range(-6, 7):
        for j in range(-6, 7):
            if (i, j) == (0, 0):
                continue
            g = 2 * np.pi * np.hypot(i, j)
            phase = np.cos(2 * np.pi * (i * registry[0] + j * registry[1]))
            total += phase * (g / (2 * z)) ** order * g * kv(order + 1, g * z)
    return 2 * np.pi / gamma(power / 2) * total


def atom_ratio(power, gap, registry):
    """Force on an atom over a lattice half space against that of the continuum; lengths in spacings, atom at gap above the surface."""
    z = gap + 0.5
    planes = 2 * np.pi * zeta(power - 1, z)
    ripples = sum(plane_ripple(power, z + k, registry) for k in range(8))
    return (planes + ripples) / (2 * np.pi * gap ** (2 - power) / (power - 2))


def lattice_ratio(power, gap, registry):
    """Force between two lattice half spaces, an area, against that of the continua, their surfaces at the distance gap."""
    z = gap + 1
    planes = 2 * np.pi * (zeta(power - 2, z) - gap * zeta(power - 1, z))
    ripples = sum((k + 1) * plane_ripple(power, z + k, registry) for k in range(8))
    return (planes + ripples) / (2 * np.pi * gap ** (3 - power) / ((power - 2) * (power - 3)))


def lattices():
    rows = []
    for ratio in [0.5, 0.64, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0]:
        row = {"gap_over_spacing": ratio}
        for what, of in [("atom", atom_ratio), ("lattice", lattice_ratio)]:
            for name, registry in REGISTRIES.items():
                row[f"{what}_{name}_repulsion"] = of(12, ratio, registry)
                row[f"{what}_{name}_attraction"] = of(6, ratio, registry)
        rows.append(row)
    return rows


def contact():
    """Rest and strength of two lattices, averaged over the registry: numbers that do not depend on where the surface is drawn."""
    rows = []
    for spacing in [0.125, 0.25, 0.5, 0.75, 1.0]:  # in r0, as every length here
        shape = lambda gap: (gap / spacing, gap / spacing + 1)

        def traction(gap):
            g, z = shape(gap)
            planes = lambda n: spacing ** (3 - n) * (zeta(n - 2, z) - g * zeta(n - 1, z))
            return planes(12) - 2 * planes(6)

        def energy(gap):
            g, z = shape(gap)
            planes = lambda n: spacing ** (4 - n) * (zeta(n - 3, z) - g * zeta(n - 2, z)) / (n - 2)
            return planes(12) - 2 * planes(6)

        # the continuum in the same factor: sums become integrals
        continuum_traction = lambda gap: gap**-9 / 90 - 2 * gap**-3 / 12
        continuum_energy = lambda gap: gap**-8 / 720 - 2 * gap**-2 / 24
        rest = brentq(traction, 0.65 - 0.9 * spacing, 0.65, xtol=1e-14)
        best = minimize_scalar(traction, bracket=(rest, rest + 0.1, rest + 0.6), tol=1e-10)
        rows.append(
            {
                "spacing_over_r0": spacing,
                "rest_gap_over_r0": rest,
                "rest_gap_continuum_over_r0": 15 ** (-1 / 6),
                "work_of_adhesion_ratio": energy(rest) / continuum_energy(15 ** (-1 / 6)),
                "strength_ratio": best.fun / continuum_traction(5 ** (-1 / 6)),
            }
        )
    return rows


# ---- the range of the body force


def ranges():
    """Where |b| has fallen to a fraction of its largest attraction, at (r0/r)^6 = 2, in units of r0, and the r0 that makes it 5.7 nm."""
    size = lambda x: abs(x**-10 / 5 - x**-4)
    largest = size(mpf(2) ** (-mpf(1) / 6))
    rows = []
    for fraction in ["0.1", "0.01", "0.001"]:
        x = mp.findroot(lambda x: size(x) / largest - mpf(fraction), mpf(fraction) ** mpf(-0.25))
        rows.append(
            {"fraction": float(fraction), "distance_over_r0": x, "distance_at_r0_0.4_nm": x * mpf("0.4"), "r0_for_5.7_nm": mpf("5.7") / x}
        )
    return rows


if __name__ == "__main__":
    common = "A_H = 0.1 aJ, r0 = 0.4 nm, both densities 1/r0^3, epsilon = A_H/(2 pi^2 beta1 beta2 r0^6)"
    tables.run(
        __doc__.splitlines()[0],
        [
            (
                "half_space.csv",
                [
                    f"A point over a half space, integrated from the pair potential (tanh-sinh, two dimensions). {common}.",
                    "body_force nN/nm^3, traction nN/nm^2, potential nN/nm: what eqs. (9), (10) and W of the crate state in closed form.",
                    "Good to 12 digits; epsilon is rounded to a double.",
                ],
                half_space,
            ),
            (
                "cubes.csv",
                [
                    f"Two cubes of 2 nm, face to face, as lattices (eq. 2) and as continua (eq. 3). {common};",
                    "a lattice atom stands for the volume spacing^3. Lattice: exact sums. Continuum: Gauss, 70 and 90 points agree to 1e-11.",
                    "Errors: lattice over continuum minus 1.",
                ],
                cubes,
            ),
            (
                "lattice_half_space.csv",
                [
                    "Simple cubic half spaces against the continuum, by the power of the pair potential (r^-12 repulsion, r^-6 attraction).",
                    "atom: normal force on one atom at gap above the surface; lattice: normal force an area between two lattices in register.",
                    "Ratios lattice/continuum. The continuum ends half a spacing outside the first plane; top, hollow: registry; mean: averaged.",
                    "Good to 10 digits (Poisson's sum: 12 reciprocal vectors each way, 8 planes; the rest is below 1e-12).",
                ],
                lattices,
            ),
            (
                "lattice_contact.csv",
                [
                    "Two simple cubic half spaces, averaged over the registry, against the continuum: the gap at rest (between surfaces half",
                    "a spacing outside the first planes), work of adhesion and largest traction. Hurwitz's zeta function, good to 9 digits.",
                ],
                contact,
            ),
            (
                "body_force_range.csv",
                ["Distance beyond which |b| of eq. (9) is below a fraction of its largest attraction. All digits good."],
                ranges,
            ),
        ],
    )

"""How far a sphere or a cylinder is a half space: eq. (9) against eq. (7) over curved bodies, without the crate.

A point at the distance d from a convex body of radius R; D = R + d. Energy and normal force are integrals of eq. (1) over the body.

Sphere: rays from the point at the angle psi enter at rho1 and leave at rho2, rho = D cos(psi) -+ sqrt(R^2 - D^2 sin^2(psi)); along
a ray the powers of rho integrate in closed form, over psi by tanh-sinh.
Cylinder: along the axis r^-n becomes sqrt(pi) Gamma((n-1)/2)/Gamma(n/2) rho^(1-n), and over the disc
int rho^-m = pi R^2 D^-m 2F1(m/2, m/2; 2; R^2/D^2), summed by mpmath.

traction is the effective traction of eq. (10) in front of the curved body: the body force summed over a column that starts at d.
"""

from mpmath import mp, mpf

import tables

mp.dps = 20
R0, HAMAKER = mpf("0.4"), mpf("0.1")
# beta1 beta2 eps of Hamaker's identity, and the two powers of eq. (1) with their factors
SCALE = HAMAKER / (2 * mp.pi**2 * R0**6)
TERMS = [(12, SCALE * R0**12), (6, -2 * SCALE * R0**6)]


def sphere_power(n, radius, gap):
    """Integral of r^-n over the ball, and minus its slope with the gap."""
    D = radius + gap
    edge = mp.asin(radius / D)

    def chord(psi):
        half = mp.sqrt(max(radius**2 - (D * mp.sin(psi)) ** 2, mpf(0)))
        far = D * mp.cos(psi) + half
        return gap * (D + radius) / far, far

    def energy(psi):
        a, b = chord(psi)
        return 2 * mp.pi * mp.sin(psi) * (a ** (3 - n) - b ** (3 - n)) / (n - 3)

    def force(psi):
        a, b = chord(psi)
        return 2 * mp.pi * mp.sin(psi) * mp.cos(psi) * n * (a ** (2 - n) - b ** (2 - n)) / (n - 2)

    split = [0, edge / 8, edge / 2, edge]
    return mp.quad(energy, split), mp.quad(force, split)


def cylinder_power(n, radius, gap):
    m, D = mpf(n - 1), radius + gap
    line = mp.sqrt(mp.pi) * mp.gamma(mpf(n - 1) / 2) / mp.gamma(mpf(n) / 2)
    t = (radius / D) ** 2
    f = mp.hyp2f1(m / 2, m / 2, 2, t)
    slope = m * m / 8 * mp.hyp2f1(m / 2 + 1, m / 2 + 1, 3, t)
    energy = line * mp.pi * radius**2 * D**-m * f
    return energy, line * mp.pi * radius**2 * D ** (-m - 1) * (m * f + 2 * t * slope)


POWERS = {"sphere": sphere_power, "cylinder": cylinder_power}


def curved(shape, radius, gap):
    """traction nN/nm^2 and body force nN/nm^3 in front of the body."""
    parts = [(factor, POWERS[shape](n, radius, gap)) for n, factor in TERMS]
    return tuple(mp.fsum(factor * part[k] for factor, part in parts) for k in (0, 1))


def flat(gap):
    q = R0 / gap
    factor = HAMAKER / (2 * mp.pi * R0**3)
    return factor * (q**9 / 45 - q**3 / 3), factor / R0 * (q**10 / 5 - q**4)


STRONGEST = {"traction": R0 * mpf(5) ** (-mpf(1) / 6), "body_force": R0 * mpf(2) ** (-mpf(1) / 6)}


def bodies():
    rows = []
    for shape in POWERS:
        for radius in [1, 2, 4, 8, 16, 32, 64, 100]:
            for gap in [STRONGEST["traction"], STRONGEST["body_force"], mpf("0.4"), mpf(1), mpf("2.28")]:
                gap = mpf(tables.text_of(gap))  # the gap as it is printed
                exact, half = curved(shape, mpf(radius), gap), flat(gap)
                rows.append(
                    {
                        "shape": shape,
                        "radius_nm": radius,
                        "gap_nm": gap,
                        "traction": exact[0],
                        "body_force": exact[1],
                        "half_space_traction_error": half[0] / exact[0] - 1,
                        "half_space_body_force_error": half[1] / exact[1] - 1 if abs(half[1]) > 1e-6 else None,
                    }
                )
    return rows


def needed_radius():
    """The radius, in r0, at which the half space is wrong by a given fraction where the quantity attracts most."""
    rows = []
    for shape in POWERS:
        for k, quantity in enumerate(["traction", "body_force"]):
            gap = STRONGEST[quantity]
            for error in ["0.1", "0.05", "0.02", "0.01"]:
                off = lambda R: flat(gap)[k] / curved(shape, R, gap)[k] - 1 - mpf(error)
                radius = mp.findroot(off, (gap / mpf(error) / 5, gap / mpf(error) * 5), solver="anderson", tol=1e-26)
                rows.append({"shape": shape, "quantity": quantity, "error": error, "radius_over_r0": radius / R0, "radius_nm": radius})
    return rows


if __name__ == "__main__":
    tables.run(
        __doc__.splitlines()[0],
        [
            (
                "curved_bodies.csv",
                [
                    "A point in front of a convex sphere or cylinder; A_H = 0.1 aJ, r0 = 0.4 nm. Good to 12 digits (quadrature or series at 20 digits).",
                    "traction nN/nm^2, body_force nN/nm^3. Errors: half space over the curved body, minus 1. Gaps: where traction and body force of the",
                    "half space attract most (5^(-1/6) r0, 2^(-1/6) r0), r0, 1 nm, and 5.7 r0, where the body force has fallen to a thousandth.",
                ],
                bodies,
            ),
            (
                "curved_radius.csv",
                ["Radius at which the half space is wrong by the given fraction, at the gap where the quantity attracts most. Good to 10 digits; r0 = 0.4 nm."],
                needed_radius,
            ),
        ],
    )

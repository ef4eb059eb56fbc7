"""The inextensible, shear-rigid rod in closed form, by elliptic integrals (mpmath, 30 digits). L = 1, EI = 1.

Cantilever with an end force P across its axis at rest. With ψ the rotation of the tip, k² = (1 + sin ψ)/2 and
sin φ = 1/(k √2),

  √P = K(k) - F(φ, k),   x = √(2 sin ψ / P),   y = 1 - 2 (E(k) - E(φ, k))/√P

(Bisshopp and Drucker 1945): from θ'²/2 = P (sin ψ - sin θ), the first integral with θ'(1) = 0.

Column on two hinges, compressed beyond its Euler load π². With α the rotation of its ends and k = sin(α/2),

  P = (2 K(k))²,   shortening = 2 (1 - E(k)/K(k)),   deflection at the middle = k/K(k)

(Timoshenko and Gere 1961, Art. 2.7): from θ'²/2 = P (cos θ - cos α).
"""

import mpmath as mp
import tables

mp.mp.dps = 30


def cantilever(load):
    """x, y and ψ of the tip."""

    def modulus(tip):
        k2 = (1 + mp.sin(tip)) / 2
        return k2, mp.asin(mp.sqrt(1 / (2 * k2)))

    def mismatch(tip):
        k2, phi = modulus(tip)
        return mp.ellipk(k2) - mp.ellipf(phi, k2) - mp.sqrt(load)

    low, high = mp.mpf("1e-8"), mp.pi / 2 - mp.mpf("1e-12")
    tip = mp.findroot(mismatch, (low, high), solver="anderson", tol=mp.mpf("1e-40"))
    k2, phi = modulus(tip)
    x = mp.sqrt(2 * mp.sin(tip) / load)
    y = 1 - 2 * (mp.ellipe(k2) - mp.ellipe(phi, k2)) / mp.sqrt(load)
    return x, y, tip


def cantilevers():
    rows = []
    for load in ("0.25", "1", "2", "4", "8", "12", "16"):
        x, y, tip = cantilever(mp.mpf(load))
        rows.append({"load": load, "tip_x": float(x), "tip_y": float(y), "tip_rotation": float(tip)})
    return rows


def columns():
    rows = []
    for degrees in (1, 20, 40, 60, 90, 120, 150):
        alpha = mp.radians(degrees)
        k = mp.sin(alpha / 2)
        big_k, big_e = mp.ellipk(k * k), mp.ellipe(k * k)
        rows.append({
            "end_rotation_degrees": degrees,
            "load": float((2 * big_k) ** 2),
            "shortening": float(2 * (1 - big_e / big_k)),
            "deflection": float(k / big_k),
        })
    return rows


CANTILEVERS = [
    "Tip of an inextensible, shear-rigid cantilever under an end force, elliptic integrals (verification/elastica.py).",
    "load = P L²/EI; lengths in L. All digits printed are good: 30 are computed.",
]
COLUMNS = [
    "An inextensible, shear-rigid column on two hinges beyond its Euler load, elliptic integrals (verification/elastica.py).",
    "load = P L²/EI; lengths in L; deflection at the middle. All digits printed are good: 30 are computed.",
]

if __name__ == "__main__":
    tables.run(
        __doc__,
        [("elastica_cantilever.csv", CANTILEVERS, cantilevers), ("elastica_column.csv", COLUMNS, columns)],
        relative=1e-12,
    )

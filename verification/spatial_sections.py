"""Energy of sections of a beam in space over a flat half space, with gradient and Hessian, without the crate.

A section has its axis at the height y; from side to side it rises by a, from bottom to top by c. V'' = T, eq. (18). The
energies are taken as they are defined, at 400 digits, so that their quotients 0/0 and what they cancel do not matter; a
rise of zero is 1e-90 nm:

    rectangle   b h [V(y - a/2 - c/2) - V(y - a/2 + c/2) - V(y + a/2 - c/2) + V(y + a/2 + c/2)]/(a c)
    near-face   b h [V(r - a/2) - V(r + a/2)]/(a |c|),  r = y - |c|/2: the lower face of the rectangle alone
    ellipse     b h/2 int_-1^1 T(y + rho x) sqrt(1 - x^2) dx,  rho = sqrt(a^2 + c^2)/2,  which is for r^-n
                (pi b h/4) y^-n 2F1(n/2, (n + 1)/2; 2; rho^2/y^2); the integral itself is compared at some states
    exponential b int W(r + s a) ds over |s| <= 1/2,  r = y - c/2,  W = -sigma d (1 + t) exp(1 - t),
                t = (r - r_eq)/d, the cohesive law of the half space's strength and work of adhesion. Turned over, c < 0, it is
                W(max(r, r_eq)) + W(min(r', r_eq)) - W(r_eq): what attracts acts on this face, what repels on the other, r' = y - |c|/2

Derivatives are central differences with a step of 1e-40 nm. Each stands with its size, to which round-off is relative:
the sum of its repulsive and its attractive part without their signs; of the exponential law, its own size or that of W
at the lowest corner over the range d.
"""

import random

from mpmath import mp, mpf

import tables

mp.dps = 400
R0, HAMAKER = mpf(0.4), mpf(0.1)                       # as doubles, exactly
STEP, ZERO = mpf(10) ** -40, mpf(10) ** -90
NAMES = ["psi", "psi_y", "psi_a", "psi_c", "psi_yy", "psi_ya", "psi_yc", "psi_aa", "psi_ac", "psi_cc"]
SCALE = HAMAKER / (2 * mp.pi * R0**3)                  # of T = SCALE [(r0/r)^9/45 - (r0/r)^3/3]
R_EQ = R0 / mp.root(15, 6)


def rectangle(b, h, power):
    """Part of Psi by the power of T (9 or 3), without the sign of the attraction."""
    n = power - 2
    factor = SCALE * R0**power / (45 if power == 9 else 3) / (n * (n + 1)) * b * h
    return lambda y, a, c: factor * (
        (y - a / 2 - c / 2) ** -n - (y - a / 2 + c / 2) ** -n - (y + a / 2 - c / 2) ** -n + (y + a / 2 + c / 2) ** -n
    ) / (a * c)


def near_face(b, h, power):
    n = power - 2
    factor = SCALE * R0**power / (45 if power == 9 else 3) / (n * (n + 1)) * b * h
    return lambda y, a, c: factor * (
        (y - abs(c) / 2 - a / 2) ** -n - (y - abs(c) / 2 + a / 2) ** -n
    ) / (a * abs(c))


def ellipse(b, h, power):
    factor = SCALE * R0**power / (45 if power == 9 else 3) * mp.pi * b * h / 4
    return lambda y, a, c: factor * y**-power * mp.hyp2f1(
        mpf(power) / 2, mpf(power + 1) / 2, 2, (a * a + c * c) / (4 * y * y)
    )


def exponential(b):
    work = mp.root(15, 3) * HAMAKER / (16 * mp.pi * R0**2)
    strength = 2 * mp.sqrt(5) / 9 * SCALE
    d = work / (strength * mp.e)
    primitive = lambda r: strength * d**2 * (2 + (r - R_EQ) / d) * mp.exp(1 - (r - R_EQ) / d)   # of W
    closed, work = primitive(R_EQ), -strength * d * mp.e                                     # W of a closed face is -w
    pull = lambda r: primitive(r) if r > R_EQ else closed + work * (r - R_EQ)                # of W(max(r, r_eq))
    push = lambda r: primitive(r) - closed - work * (r - R_EQ) if r < R_EQ else 0            # of W(min(r, r_eq)) + w
    mean = lambda of, r, a: b * (of(r + a / 2) - of(r - a / 2)) / a
    return lambda y, a, c: (
        mean(primitive, y - c / 2, a) if c > 0 else mean(pull, y - c / 2, a) + mean(push, y + c / 2, a)
    )


def differences(f, y, a, c):
    """f with its first and second derivatives, in the order of NAMES."""
    e = STEP
    at = lambda dy, da, dc: f(y + dy * e, (a + da * e) or ZERO, (c + dc * e) or ZERO)
    middle = at(0, 0, 0)
    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    ends = [(at(*axis), at(*(-k for k in axis))) for axis in axes]
    first = [(up - down) / (2 * e) for up, down in ends]
    pure = [(up - 2 * middle + down) / e**2 for up, down in ends]

    def mixed(i, j):
        corner = lambda p, q: at(*(p * u + q * v for u, v in zip(axes[i], axes[j])))
        return (corner(1, 1) - corner(1, -1) - corner(-1, 1) + corner(-1, -1)) / (4 * e**2)

    return [middle, *first, pure[0], mixed(0, 1), mixed(0, 2), pure[1], mixed(1, 2), pure[2]]


def of_half_space(part, b, h, y, a, c):
    repulsive, attractive = (differences(part(b, h, power), y, a, c) for power in (9, 3))
    return [(r - t, abs(r) + abs(t)) for r, t in zip(repulsive, attractive)]


def of_exponential(b, h, y, a, c):
    values = differences(exponential(b), y, a, c)
    # gradient and Hessian, over the range of the law: W and what it varies by where the lowest corner is
    d = mp.root(15, 3) * R0 / (16 * mp.e) * 9 / mp.sqrt(5)
    lowest = (y - (abs(a) + abs(c)) / 2 - R_EQ) / d
    work = SCALE * 2 * mp.sqrt(5) / 9 * d * (1 + abs(lowest)) * mp.exp(1 - lowest)
    size = b * work * min(1, 2 * d / abs(a) if a else 1)
    orders = [0, 1, 1, 1, 2, 2, 2, 2, 2, 2]
    return [(value, max(abs(value), size / d**order)) for value, order in zip(values, orders)]


def of_near_face(b, h, y, a, c):
    """1/|c| and what it multiplies vary against one another: the size of a derivative by c is that of both."""
    found = of_half_space(near_face, b, h, y, a, c)
    size = dict(zip(NAMES, (size for _, size in found)))
    for name, other in [("psi_c", "psi"), ("psi_yc", "psi_y"), ("psi_ac", "psi_a"), ("psi_cc", "psi_c")]:
        size[name] += 2 * size[other] / abs(c)
    return [(value, size[name]) for (value, _), name in zip(found, NAMES)]


FORMS = {
    "rectangle": lambda *state: of_half_space(rectangle, *state),
    "near-face": of_near_face,
    "ellipse": lambda *state: of_half_space(ellipse, *state),
    "exponential": of_exponential,
}
DEGREES = [0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 0.1, 1, 3, 10, 30, 45, 60, 80, 89, 89.99, 90 - 1e-6, 90 - 1e-9, 90]


def decimal(value):
    """As a double that is written with 12 digits."""
    return float(f"{float(value):.12g}")


def state(form, draw):
    """b, h, y, a, c of a section that is tilted by two of DEGREES; its lowest point is 0.2 to 100 nm high."""
    b, h = (decimal(10 ** draw.uniform(0, top)) for top in (2.301, 1.7))
    if form == "ellipse" and draw.random() < 0.3:
        h = b
    roll, pitch = (mp.radians(mpf(draw.choice(DEGREES))) for _ in range(2))
    if form in ("near-face", "exponential"):
        roll, pitch = min(roll, mp.radians(80)), min(pitch, mp.radians(80))
    a = decimal(draw.choice([-1, 1]) * b * mp.cos(pitch) * mp.sin(roll))
    c = decimal(draw.choice([-1, 1]) * h * mp.cos(pitch) * mp.cos(roll))
    if abs(a) < 1e-15 * b:
        a = 0.0
    if abs(c) < 1e-15 * h:
        c = 0.0
    gap = 10 ** draw.uniform(-0.7, 0 if form == "exponential" else 2)
    half = mp.hypot(a, c) / 2 if form == "ellipse" else (abs(a) + abs(c)) / 2
    return b, h, decimal(gap + float(half)), a, c


def rows(form, count):
    draw = random.Random(form)
    for _ in range(count):
        b, h, y, a, c = state(form, draw)
        mp.dps = 250 if form == "ellipse" else 400
        found = FORMS[form](*map(mpf, (b, h, y, a, c)))
        row = {"form": form, **{key: repr(value) for key, value in zip("bhyac", (b, h, y, a, c))}}
        # what ZERO leaves of a zero
        found = [pair if pair[1] > mpf(10) ** -60 else (mpf(0), mpf(0)) for pair in found]
        row |= {name: mp.nstr(value, 17) for name, (value, _) in zip(NAMES, found)}
        row |= {name.replace("psi", "size"): mp.nstr(size, 4) for name, (_, size) in zip(NAMES, found)}
        yield row


def compare_integral():
    """The series of the ellipse with its integral."""
    mp.dps = 30
    for y, rho in [(mpf(8), mpf(5)), (mpf(30), mpf("29.5")), (mpf("5.3"), mpf(0))]:
        for power in (9, 3):
            gap = y / rho - 1 if rho else 2
            split = [-1, *(gap * mpf(4) ** k - 1 for k in range(9) if gap * 4**k < 2), 1]
            mean = 2 / mp.pi * mp.quad(lambda x: (y + rho * x) ** -power * mp.sqrt(1 - x * x), split)
            series = y**-power * mp.hyp2f1(mpf(power) / 2, mpf(power + 1) / 2, 2, (rho / y) ** 2)
            assert abs(mean / series - 1) < mpf(10) ** -20, (y, rho, power, mean / series - 1)


def table():
    compare_integral()
    counts = {"rectangle": 240, "near-face": 60, "ellipse": 80, "exponential": 60}
    return [row for form, count in counts.items() for row in rows(form, count)]


if __name__ == "__main__":
    tables.run(
        __doc__.splitlines()[0],
        [
            (
                "spatial_sections.csv",
                [
                    "Energy of sections of a beam in space per length, nN; derivatives by y, a, c, nm; their sizes.",
                    "A_H = 0.1 aJ, r0 = 0.4 nm. b, h: width, height, nm; y: height of the axis; a, c: rises of both.",
                ],
                table,
            )
        ],
        relative=1e-13,
        absolute=0.0,
    )

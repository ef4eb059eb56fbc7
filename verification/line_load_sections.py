"""Body force, surface traction and line load of a tilted section and of a tilted piece of strip, without the crate.

A section of height h at the tilt theta has its points at y + s cos(theta), |s| <= h/2, on the direction (-sin, cos) from the axis.
The body force b e_y of eq. (9) times the lever -s sin(theta) gives

    T_c = int b(y + s cos) ds,   M_c = -sin int s b(y + s cos) ds,   Psi = int T(y + s cos) ds,

which this script integrates by tanh-sinh; eqs. (17)-(22) are the same integrals in closed form.

A piece of strip of length l and height h: the same over S, with the lever x = S cos - s sin about its centre. Its surface traction,
eqs. (10)-(12), is the integral over columns along y: over all four faces, cos(alpha) negative on those that look away, it is exact
(b = -dT/dy). The paper takes the faces that look at the substrate; both are in the table, and the line load without its far face.
"""

from mpmath import mp, mpf

import tables

mp.dps = 20
R0, HAMAKER, HEIGHT, LENGTH = mpf("0.4"), mpf("0.1"), mpf(10), mpf(10)


def body_force(r):
    q = R0 / r
    return HAMAKER / (2 * mp.pi * R0**4) * (q**10 / 5 - q**4)


def traction(r):
    q = R0 / r
    return HAMAKER / (2 * mp.pi * R0**3) * (q**9 / 45 - q**3 / 3)


def potential(r):
    q = R0 / r
    return HAMAKER / (2 * mp.pi * R0**2) * (q**8 / 360 - q**2 / 6)


def graded(rate, length, gap):
    """Where to split an integral over [0, length] of what varies at the distance gap + rate x."""
    ends, x = [mpf(0)], gap / max(rate, mpf("1e-3"))
    while x < length:
        ends.append(x)
        x *= 4
    return ends + [length]


def section(tilt, gap):
    """Psi, T_c, M_c of the section whose lowest point is at gap; u runs from that edge."""
    cos, sin = mp.cos(tilt), mp.sin(tilt)
    side = 1 if cos >= 0 else -1
    rate = abs(cos)
    split = graded(rate, HEIGHT, gap)
    over = lambda f: mp.quad(f, split)
    s = lambda u: side * (u - HEIGHT / 2)
    r = lambda u: gap + u * rate
    return (
        over(lambda u: traction(r(u))),
        over(lambda u: body_force(r(u))),
        -sin * over(lambda u: s(u) * body_force(r(u))),
    )


def sections():
    rows = []
    for gap in ["0.26", "0.4", "1"]:
        for degrees in [0, 10, 20, 30, 45, 60, 75, 85, 90, 95, 105, 120]:
            tilt = mp.radians(degrees)
            energy, force, moment = section(tilt, mpf(gap))
            cos = mp.cos(tilt)
            # the bottom face alone by eq. (11), an arc length of the axis: T cos(theta); no face looks down beyond 90 degrees
            facing = traction(mpf(gap)) * cos if degrees < 90 else mpf(0)
            near = traction(mpf(gap)) / abs(cos) if degrees != 90 else None
            rows.append(
                {
                    "lowest_gap_nm": gap,
                    "tilt_deg": degrees,
                    "energy": energy,
                    "force": force,
                    "moment": moment,
                    "force_without_far_face": near,
                    "force_of_bottom_traction": facing,
                }
            )
    return rows


def over_face(start, end, facing, gap_of, x_of):
    """Force and moment of the traction on one straight face, parametrised over [start, end]."""
    low, high = (start, end) if gap_of(start) <= gap_of(end) else (end, start)
    rate = abs(gap_of(end) - gap_of(start)) / abs(end - start)
    split = [low + (1 if high > low else -1) * u for u in graded(rate, abs(end - start), gap_of(low))]
    sign = 1 if high > low else -1
    force = sign * mp.quad(lambda p: traction(gap_of(p)) * facing, split)
    moment = sign * mp.quad(lambda p: x_of(p) * traction(gap_of(p)) * facing, split)
    return force, moment


def piece(degrees, gap):
    tilt = mp.radians(degrees)
    cos, sin = mp.cos(tilt), mp.sin(tilt)
    half_l, half_h = LENGTH / 2, HEIGHT / 2
    y = gap + half_l * sin + half_h * cos
    height = lambda S, s: y + S * sin + s * cos
    x = lambda S, s: S * cos - s * sin
    faces = {
        "bottom": over_face(-half_l, half_l, cos, lambda S: height(S, -half_h), lambda S: x(S, -half_h)),
        "left": over_face(-half_h, half_h, sin, lambda s: height(-half_l, s), lambda s: x(-half_l, s)),
        "top": over_face(-half_l, half_l, -cos, lambda S: height(S, half_h), lambda S: x(S, half_h)),
        "right": over_face(-half_h, half_h, -sin, lambda s: height(half_l, s), lambda s: x(half_l, s)),
    }
    total = lambda names: tuple(mp.fsum(faces[name][k] for name in names) for k in (0, 1))
    near_line = lambda weight: mp.quad(
        lambda u: weight(u - half_l, gap + u * sin), graded(sin, LENGTH, gap)
    )
    # eqs. (17), (20) without r2: T_c = T/cos, M_c = -d/dtheta [W(r1)/cos], r1 = y - h cos/2
    t_near = lambda r: traction(r) / cos
    m_near = lambda r: traction(r) * half_h * sin / cos - potential(r) * sin / cos**2
    return {
        "tilt_deg": degrees,
        "corner_gap_nm": gap,
        "force": total(faces)[0],
        "moment": total(faces)[1],
        "near_faces_force": total(["bottom", "left"])[0],
        "near_faces_moment": total(["bottom", "left"])[1],
        "near_line_force": near_line(lambda S, r: t_near(r)),
        "near_line_moment": near_line(lambda S, r: S * cos * t_near(r) + m_near(r)),
    }


def pieces():
    rows = [piece(degrees, mpf(gap)) for gap in ("0.26", "0.4", "1") for degrees in (0, 5, 20, 45, 70)]
    # the totals over the faces once more as the integral of the body force over the area
    for row in rows:
        tilt = mp.radians(row["tilt_deg"])
        cos, sin, gap = mp.cos(tilt), mp.sin(tilt), row["corner_gap_nm"]
        mp.dps = 15
        area = lambda weight: mp.quad(
            lambda a, c: weight(a, c) * body_force(gap + a * sin + c * cos),
            graded(sin, LENGTH, gap), graded(cos, HEIGHT, gap), maxdegree=5,
        )
        force = area(lambda a, c: 1)
        moment = area(lambda a, c: (a - LENGTH / 2) * cos - (c - HEIGHT / 2) * sin)
        mp.dps = 20
        assert abs(force / row["force"] - 1) < 1e-11, (row, force)
        assert abs(moment - row["moment"]) < 1e-11 * abs(5 * row["force"]), (row, moment)
    return rows


def tidy(compute):
    """Moments that vanish by symmetry come out as 1e-22: they are written as 0."""
    number = lambda v: mpf(0) if isinstance(v, mpf) and abs(v) < mpf("1e-17") else v
    return lambda: [{key: number(value) for key, value in row.items()} for row in compute()]


if __name__ == "__main__":
    common = "A_H = 0.1 aJ, r0 = 0.4 nm, h = 10 nm; tanh-sinh quadrature, good to 12 digits."
    tables.run(
        __doc__.splitlines()[0],
        [
            (
                "sections.csv",
                [
                    f"A section of a strip over a half space: integrals of the body force, per length and width. {common}",
                    "energy nN/nm, force T_c nN/nm^2, moment M_c nN/nm. force_without_far_face: T(r1)/|cos|.",
                    "force_of_bottom_traction: eq. (11) on the bottom face, T(r1) cos, none beyond 90 degrees; it is no approximation of T_c.",
                ],
                tidy(sections),
            ),
            (
                "pieces.csv",
                [
                    f"A piece of strip, l = 10 nm, over a half space: force nN/nm and moment about its centre nN, per width. {common}",
                    "force, moment: over all four faces, equal to the area integral of the body force to 1e-11 (asserted on every run).",
                    "near_faces: the traction of the faces that look at the substrate; near_line: the line load without its far face.",
                ],
                tidy(pieces),
            ),
        ],
        relative=1e-10,
    )

"""Benchmarks without adhesion: beams of a CSV row, their end conditions and loads.

Section of the strip everywhere: d2 = -e_z, d3 = e_y at rest where d1 = e_x. EI2 bends in the plane of x and y, EI3
out of it. The 45-degree bend alone starts with d2 = e_y, d3 = e_z, as its rest curve is curved about d3.
"""

import math

import numpy as np

from .beam import SIZE, Beam, frame
from .gauss import Problem, remesh, straight
from .path import critical, held, row

C = math.sqrt(0.5)
FLAT, PLAIN = (C, -C, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)


def beam_of(case):
    """The beam of a row; "inf" is rigid."""
    soft = lambda name: 1.0 / float(case[name])
    return Beam(
        float(case["length"]),
        (soft("EA"), soft("GA"), soft("GA")),
        (soft("GJ"), soft("EI2"), soft("EI3")),
        None,
        (0.0, 0.0, float(case["curvature_3"])),
    )


def scales(beam):
    L = beam.length
    EI = 1.0 / max(beam.pliant)
    return [0.5 * L] * 3 + [1.0] * 4 + [EI / L**2] * 3 + [EI / L] * 3


def clamp(a, q0):
    """r(0) = 0 and the frame of q0: the vector part of conj(q0) o q vanishes."""
    w, x, y, z = q0
    q = a[3:7]
    return [
        a[0],
        a[1],
        a[2],
        w * q[1] - x * q[0] - y * q[3] + z * q[2],
        w * q[2] + x * q[3] - y * q[0] - z * q[1],
        w * q[3] - x * q[2] + y * q[1] - z * q[0],
    ]


def loaded(beam, q0, force, moment):
    """Clamped at S = 0; force and moment of the load `par` at S = L, in fixed components."""

    def conditions(a, b, par):
        f, m = force(par[0]), moment(par[0])
        return clamp(a, q0) + [b[7 + i] - f[i] for i in range(3)] + [b[10 + i] - m[i] for i in range(3)]

    return Problem(beam, conditions, scales(beam), [1.0])


def rest(problem, mesh, q0, tangent=(1.0, 0.0, 0.0)):
    """The beam without load: straight, or an arc about d3 that begins with d1 = e_x, d3 = e_z."""
    beam = problem.beam
    st = straight(beam.length, *mesh, (0.0, 0.0, 0.0), q0, [0.0] * len(problem.par_scale), tangent)
    k = beam.curvature[2]
    if k:
        for S, value, slope in ((st.X, st.z, None), (st.places(), None, st.K)):
            a = k * S
            if value is not None:
                value[0], value[1], value[3], value[6] = (
                    np.sin(a) / k,
                    (1.0 - np.cos(a)) / k,
                    np.cos(a / 2.0),
                    np.sin(a / 2.0),
                )
            else:
                slope[0], slope[1], slope[3], slope[6] = (
                    np.cos(a),
                    np.sin(a),
                    -0.5 * k * np.sin(a / 2.0),
                    0.5 * k * np.cos(a / 2.0),
                )
    return st


def tip(st, size):
    return {f"tip_{c}": (float(st.z[i, -1]), size) for i, c in enumerate("xyz")}


def through(problem, st, loads, steps, mesh, size):
    """Values at several loads, one after the other; each on a mesh refined for it. Also the last state."""
    control = row(problem, "par", 0)
    out = {}
    for load in loads:
        st = held(problem, st, control, load, steps=steps)
        fine = st
        for _ in range(2):
            fine = problem.solve(remesh(fine, mesh[0], problem.scale), control, load, tolerance=1e-10)
        out |= {f"{name}_at_{load:g}": value for name, value in tip(fine, size).items()}
    return out, fine


def bend(case, mesh):
    beam = beam_of(case)
    problem = loaded(beam, PLAIN, lambda p: (0.0, 0.0, p), lambda p: (0.0, 0.0, 0.0))
    problem.par_scale = np.array([100.0])
    return *through(problem, rest(problem, mesh, PLAIN), (300.0, 450.0, 600.0), 6, mesh, 100.0), problem


def helix(case, mesh):
    beam = beam_of(case)
    problem = loaded(beam, FLAT, lambda p: (0.0, 0.0, 50.0 * p), lambda p: (0.0, 0.0, 200.0 * math.pi * p))
    problem.par_scale = np.array([0.1])
    return *through(problem, rest(problem, mesh, FLAT), (0.1, 0.2, 0.5, 1.0), 40, mesh, 10.0), problem


def end_force(case, mesh):
    """Force across the axis, oblique in y and z: of EI/L^2."""
    beam = beam_of(case)
    problem = loaded(beam, FLAT, lambda p: (0.0, 0.6 * p, 0.8 * p), lambda p: (0.0, 0.0, 0.0))
    return *through(problem, rest(problem, mesh, FLAT), (1.0, 4.0, 8.0), 8, mesh, 1.0), problem


def end_moment(case, mesh):
    """Moment about (0, 0.6, 0.8) in turns: 1 closes the circle."""
    beam = beam_of(case)
    problem = loaded(beam, FLAT, lambda p: (0.0, 0.0, 0.0), lambda p: (0.0, 1.2 * math.pi * p, 1.6 * math.pi * p))
    return *through(problem, rest(problem, mesh, FLAT), (0.25, 0.5, 1.0, 2.0), 10, mesh, 1.0), problem


def end_screw(case, mesh):
    """Moment about (0.6, 0, 0.8), in turns: a helix where GJ = EI2 = EI3."""
    beam = beam_of(case)
    problem = loaded(beam, FLAT, lambda p: (0.0, 0.0, 0.0), lambda p: (1.2 * math.pi * p, 0.0, 1.6 * math.pi * p))
    return *through(problem, rest(problem, mesh, FLAT), (0.25, 0.5, 1.0, 2.0), 10, mesh, 1.0), problem


def singular(problem, st, steps, low, high, modes=1, side=None):
    """Critical load between low and high of the states reached from st by the first parameter. side: the condition
    that n_z = 0 at L; the states themselves, which lie in a plane, are held there by z(L) = 0 in its place, or they
    would be singular as well.
    """
    control = row(problem, "par", 0)
    stiff = (
        problem
        if side is None
        else Problem(problem.beam, planar(problem.conditions, side), problem.scale, problem.par_scale)
    )
    st = held(stiff, st, control, 0.5 * (low + high), steps=steps)
    state_at = lambda load: stiff.solve(st, control, load, tolerance=1e-10)
    return critical(without(problem), state_at, low, high, modes), st, control


def planar(conditions, side):
    """Conditions with number `side` replaced by z(L) = 0."""

    def changed(a, b, par):
        g = conditions(a, b, par)
        g[side] = b[2]
        return g

    return changed


def kicked(problem, st, mode, z):
    """A planar state with as much of a mode as moves the end by z out of the plane."""
    _, _, back, _, _ = problem.assemble(st)
    back[:, :, SIZE] = 0.0
    N = len(st.X) - 1
    return problem.apply(st, mode * (z / mode[SIZE * N + 2]), back)


def without(problem):
    """The same conditions, with the load given: one more condition."""
    conditions = lambda a, b, par: [*problem.conditions(a, b, par), par[0]]
    return Problem(problem.beam, conditions, problem.scale, problem.par_scale)


def twisted(case, mesh):
    """Clamped; at L it slides along x and turns about it under the moment par: y = z = 0, d1 = e_x."""
    beam = beam_of(case)

    def conditions(a, b, par):
        d1 = frame(b[3:7])[0]
        return clamp(a, FLAT) + [b[1], b[2], d1[1], d1[2], b[7], b[10] - par[0]]

    problem = Problem(beam, conditions, scales(beam), [1.0])
    (load, _, G), st, _ = singular(problem, rest(problem, mesh, FLAT), 4, 8.5, 9.3, modes=2)
    if np.abs(G).max() > 1e-12:  # all four vanish at a double root
        raise RuntimeError(f"{case['case']}: not a double root, {G}")
    return {"moment": (load, 0.0)}, st, problem


def lateral(case, mesh):
    """Clamped; a dead force along y at the end of the axis. Behind the buckling load: held by the displacement z of
    the end."""
    beam = beam_of(case)
    problem = loaded(beam, FLAT, lambda p: (0.0, p, 0.0), lambda p: (0.0, 0.0, 0.0))
    low, high = (3.9, 4.9) if float(case["EI2"]) > 5.0 else (6.5, 7.5)
    (load, V, _), st, control = singular(problem, rest(problem, mesh, FLAT), 8, low, high, side=8)
    out = {"force": (load, 0.0)}
    if case["case"].endswith("_100"):
        st = held(problem, kicked(problem, st, V[:, 0], 0.01), row(problem, "right", 2), 0.01)
        side = row(problem, "right", 2)
        for z in (0.05, 0.1, 0.2, 0.3, 0.4):
            st = held(problem, st, side, z, steps=4)
            fine = problem.solve(remesh(st, mesh[0], problem.scale), side, z, tolerance=1e-11)
            out |= {
                f"force_at_z_{z:g}": (float(fine.par[0]), 0.0),
                f"tip_x_at_z_{z:g}": (float(fine.z[0, -1]), 1.0),
                f"tip_y_at_z_{z:g}": (float(fine.z[1, -1]), 1.0),
            }
        st = fine
    return out, st, problem


def frame_half(case, mesh):
    """One leg of the right-angle frame, at 45 degrees: hinge about z on rollers along x, moment par; apex in its
    plane of symmetry."""
    beam = beam_of(case)
    half = math.pi / 8.0
    turn = (math.cos(half), 0.0, 0.0, math.sin(half))
    q0 = (turn[0] * C, -turn[0] * C, -turn[3] * C, turn[3] * C)  # turn o FLAT

    def conditions(a, b, par):
        _, d2, _ = frame(a[3:7])
        e1, _, e3 = frame(b[3:7])
        return [a[1], a[2], a[7], d2[0], d2[1], a[12] - par[0], b[0], b[8], b[9], b[10], e1[1] - e3[1], e1[2] - e3[2]]

    problem = Problem(beam, conditions, scales(beam), [100.0])
    st = straight(beam.length, *mesh, (-beam.length * C, 0.0, 0.0), q0, [0.0], (C, C, 0.0))
    out = {}
    for name, low, high in (("moment_closing", 600.0, 640.0), ("moment_opening", -640.0, -600.0)):
        (load, _, _), last, _ = singular(problem, st, 10, low, high, side=8)
        out[name] = (abs(load), 0.0)
    return out, last, problem


KINDS = {
    "bend": bend,
    "helix": helix,
    "end_force": end_force,
    "end_moment": end_moment,
    "end_screw": end_screw,
    "twisted": twisted,
    "lateral": lateral,
    "frame": frame_half,
}

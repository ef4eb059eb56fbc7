"""The path of a peel: the state at P = 0, the first peak of P, the first fold of u, and states at given displacements
and lifts.

The path is walked once on a mesh of N sub-intervals; what is sought is solved again on two finer meshes of different
orders.
"""

import numpy as np

from .beam import SIZE, first_integral
from .gauss import Failure, remesh
from .path import Walk, extremum

COARSE = (40, 6)
FINE = ((44, 7), (60, 8))
MOST, SHORT = 500, 1.0
LOOSE = 10.0  # round-off of what is not extremal at an extremum: its place is a root of a derivative


def numbers(text):
    return [float(x) for x in text.split(";") if x]


def weights(problem):
    """What measures the length of a path: position, frame and force of the grip, and P."""
    size = np.array([1.0] * 3 + [0.3] * 4 + [10.0 * problem.scale[7]] * 3 + [np.inf] * 3)
    return np.concatenate([np.zeros(SIZE), 1.0 / size**2, 1.0 / (3.0 * problem.par_scale) ** 2])


def walk(peel, short=False, extrema=("peak", "fold")):
    """The points of a path: (name, how it is found) for everything that is sought. What is sought at a displacement lies before the fold."""
    problem, case = peel.problem, peel.case
    st = peel.start(*COARSE)
    yield "start", lambda fine: refined(problem, st, peel.P, 0.0, fine)
    w = weights(problem)
    path = Walk(problem, st, peel.lift, w, 0.1, *COARSE)
    heights = {f"lift_{v:g}": (peel.lift, v + peel.y0) for v in numbers(case.lifts_nm)}
    places = {f"u_{v:g}": (peel.u, peel.u_row(v)) for v in numbers(case.displacements_nm)}
    sought = {name: f for name, f in (("peak", peel.P), ("fold", peel.u)) if name in extrema}
    while len(path.points) < MOST:
        lifted = path.points[-1].z[1, -1] - peel.y0
        all_found = not sought and not heights and ("fold" in extrema or not places)
        if short and "peak" not in sought and lifted > SHORT or all_found:
            return
        after = path.advance(largest=0.5 + lifted)
        before, tangent = path.points[-2], path.tangents[-2]
        for name in [name for name, f in sought.items() if path.turned(f)]:
            f = sought.pop(name)
            yield name, lambda fine, f=f: extremum(problem, before, after, tangent, f, w, fine)
        before_fold = "fold" in sought or "fold" not in extrema
        for known in (places, heights):
            for name, (f, value) in list(known.items()):
                a, b = path.value(f, -2), path.value(f, -1)
                if (a - value) * (b - value) <= 0.0 and (before_fold or known is heights):
                    known.pop(name)
                    near = before if abs(a - value) < abs(b - value) else after
                    yield name, lambda fine, f=f, value=value, near=near: refined(problem, near, f, value, fine)
    raise Failure(f"{case.case}: {list(sought)} not met in {MOST} points")


def refined(problem, st, control, value, fine, passes=2):
    """The state with control . x = value, on a mesh made for it."""
    st = problem.solve(st, control, value)
    for _ in range(passes):
        st = problem.solve(remesh(st, fine[0], problem.scale, fine[1]), control, value, tolerance=1e-10)
    return st


def values(peel, name, st):
    """{quantity: (value, size)} of a state: u, P and the lift, what the grip holds, and how far it turns where it is
    free."""
    case, u, lift = peel.case, peel.displacement(st), float(st.z[1, -1] - peel.y0)
    force, arm = float(np.abs(st.z[7:10, -1]).max()), float(np.abs(st.z[10:13]).max())
    length = 1.0
    out = {"displacement_nm": (u, length), "force_nN": (float(st.par[0]), force), "lift_nm": (lift, length)}
    if name.startswith("u_"):
        del out["displacement_nm"]
    if name.startswith("lift_"):
        del out["lift_nm"]
    if name == "start":
        del out["force_nN"]
    r = peel.reactions(st)
    if case.roll == "fixed" and case.section_turns():
        out["torque_nN_nm"] = (r["torque"], arm)
    for what, held in (("yaw", case.yaw), ("rotation", case.rotation)):
        if held == "fixed":
            out[f"{what}_moment_nN_nm"] = (r[f"{what}_moment"], arm)
    for what, held in (("horizontal", case.horizontal), ("lateral", case.lateral)):
        if held == "fixed":
            out[f"{what}_force_nN"] = (r[f"{what}_force"], force)
    for what in ("roll", "yaw", "rotation"):
        if getattr(case, what) == "free" and (what == "rotation" or case.leaves_its_plane()):
            out[f"{what}_deg"] = (float(np.degrees(r[what])), 1.0)
    extremal = {"peak": "force_nN", "fold": "displacement_nm"}.get(name)
    loose = {k: 1.0 if extremal in (k, None) else LOOSE for k in out}
    return {f"{name}_{k}": (v, loose[k] * max(abs(v), size)) for k, (v, size) in out.items()}


def integrals(peel, st):
    """How far the first integrals of a solution are from constant: energy, n_x and n_z, m_y + (r x n)_y; each over
    its size."""
    z = st.inner().reshape(SIZE, -1)
    uniform = peel.case.end_width_nm == "" and peel.case.end_height_nm == ""
    I = first_integral(peel.problem.beam, z) if uniform else np.zeros(1)
    r, n, m = z[0:3], z[7:10], z[10:13]
    turn = m[1] + r[2] * n[0] - r[0] * n[2]
    force, moment = np.abs(n).max() + 1e-300, np.abs(m).max() + 1e-300
    return np.ptp(I) / (np.abs(I).max() + 1e-300), max(np.ptp(n[0]), np.ptp(n[2])) / force, np.ptp(turn) / moment

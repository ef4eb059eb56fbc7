#!/usr/bin/env python3
"""Two other programs on the 45-degree bend: the error of the tip and the CPU time at several resolutions.

    python3.11 -m venv /tmp/others && /tmp/others/bin/pip install -r verification/requirements.txt pyelastica exudyn
    /tmp/others/bin/python verification/space/against_others.py

Arc of radius 100 and 45 degrees, unit square, E = 1e7, nu = 0, k = 5/6, J = 1/6; force 600 out of its plane. Error:
distance of the tip from space_benchmarks.csv. Exudyn: static, ObjectBeamGeometricallyExact with two nodes, Euler
parameters, four load steps. PyElastica: explicit in time, damped to rest, until the distance from the state at
time 80 is below a tenth of its error; the rotational inertia is raised as far as the step of the axial waves allows.
PyElastica clamps the place of the first node and the frame of the first element, whose middle stands for its place:
the rod begins half an element before the clamp, and as it comes, with the clamp at the first node, for two rows. The
collocation of this folder on uniform meshes, in three load steps, is the third.
"""

import sys
import time
import warnings
from math import cos, pi, sin, sqrt
from pathlib import Path

import elastica as ea  # before verification/elastica.py can be found
import exudyn as exu
from elastica.timestepper.symplectic_steppers import PositionVerlet
from exudyn import utilities as items

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import space  # first: one thread
import numpy as np
import tables
from space import clamped
from space.path import held, row

RADIUS, ANGLE, E, G, FORCE = 100.0, pi / 4.0, 1e7, 5e6, 600.0
NAME = "bend_k_5/6_J_1/6"


def expected():
    values = {
        row["quantity"]: float(row["value"]) for row in tables.read("space_benchmarks.csv") if row["case"] == NAME
    }
    return np.array([values[f"tip_{c}_at_600"] for c in "xyz"])


def with_exudyn(n):
    mbs = exu.SystemContainer().AddSystem()
    section = exu.BeamSection()
    section.stiffnessMatrix = np.diag([E, 5.0 / 6.0 * G, 5.0 / 6.0 * G, G / 6.0, E / 12.0, E / 12.0])
    section.massPerLength, section.inertia = 1.0, np.eye(3)
    ground = mbs.AddNode(items.NodePointGround(referenceCoordinates=[0.0, 0.0, 0.0]))
    nodes = []
    for k in range(n + 1):
        a = ANGLE * k / n
        place = [RADIUS * sin(a), RADIUS * (1.0 - cos(a)), 0.0]
        nodes.append(
            mbs.AddNode(items.NodeRigidBodyEP(referenceCoordinates=[*place, cos(a / 2.0), 0.0, 0.0, sin(a / 2.0)]))
        )
    for pair in zip(nodes, nodes[1:]):
        mbs.AddObject(
            items.ObjectBeamGeometricallyExact(
                nodeNumbers=list(pair), physicsLength=RADIUS * ANGLE / n, sectionData=section
            )
        )
    tip = mbs.AddMarker(items.MarkerNodeRigid(nodeNumber=nodes[-1]))
    mbs.AddLoad(items.Force(markerNumber=tip, loadVector=[0.0, 0.0, FORCE]))
    ends = [mbs.AddMarker(items.MarkerNodeRigid(nodeNumber=node)) for node in (ground, nodes[0])]
    mbs.AddObject(items.GenericJoint(markerNumbers=ends))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.linearSolverType = exu.LinearSolverType.EigenSparse
    settings.solutionSettings.writeSolutionToFile = False
    settings.staticSolver.numberOfLoadSteps, settings.staticSolver.verboseMode = 4, 0
    settings.staticSolver.newton.relativeTolerance = settings.staticSolver.newton.absoluteTolerance = 1e-8
    begun = time.process_time()
    mbs.SolveStatic(settings)
    return mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Position), time.process_time() - begun


def with_pyelastica(n, until, before=0.5, damping=1.0, share=0.5):
    """before: by how much of an element the rod begins before the clamp."""

    class Simulator(ea.BaseSystemCollection, ea.Constraints, ea.Forcing, ea.Damping):
        pass

    a = ANGLE * (np.arange(n + 1) - before) / (n - before)
    place = np.array([RADIUS * np.sin(a), RADIUS * (1.0 - np.cos(a)), 0.0 * a])
    chord = np.diff(place, axis=1)
    along = chord / np.linalg.norm(chord, axis=0)
    normal = np.tile(np.array([[0.0], [0.0], [1.0]]), n)
    frames = np.array([normal, np.cross(along.T, normal.T).T, along])
    rod = ea.CosseratRod.straight_rod(
        n,
        np.zeros(3),
        np.array([1.0, 0.0, 0.0]),
        np.array([0.0, 0.0, 1.0]),
        RADIUS * (a[-1] - a[0]),
        1.0 / sqrt(pi),
        1.0,
        youngs_modulus=E,
        shear_modulus=G,
        position=place,
        directors=frames,
    )
    rod.shear_matrix[:] = np.diag([5.0 / 6.0 * G, 5.0 / 6.0 * G, E])[:, :, None]
    rod.bend_matrix[:] = np.diag([E / 12.0, E / 12.0, G / 6.0])[:, :, None]
    rod.rest_kappa[:] = rod.kappa
    length = RADIUS * (a[1] - a[0])
    raised = 0.5 * length**2 * length * np.eye(3)  # rho I of the element times its length
    rod.mass_second_moment_of_inertia[:] = raised[:, :, None]
    rod.inv_mass_second_moment_of_inertia[:] = np.linalg.inv(raised)[:, :, None]
    step = share * length / sqrt(E)
    simulator = Simulator()
    simulator.append(rod)
    simulator.constrain(rod).using(ea.OneEndFixedBC, constrained_position_idx=(0,), constrained_director_idx=(0,))
    simulator.add_forcing_to(rod).using(ea.EndpointForces, np.zeros(3), np.array([0.0, 0.0, FORCE]), ramp_up_time=5.0)
    simulator.dampen(rod).using(ea.AnalyticalLinearDamper, uniform_damping_constant=damping, time_step=step)
    simulator.finalize()
    stepper, now, out = PositionVerlet(), np.float64(0.0), []
    stepper.step(simulator, now, np.float64(1e-9 * step))  # compiles
    begun = time.process_time()
    for end in until:
        while now < end:
            now = stepper.step(simulator, now, np.float64(step))
        out.append((rod.position_collection[:, -1].copy(), time.process_time() - begun))
    return out


def collocation(n, s):
    case = next(case for case in tables.read("space_benchmark_beams.csv") if case["case"] == NAME)
    problem = clamped.loaded(clamped.beam_of(case), clamped.PLAIN, lambda p: (0.0, 0.0, p), lambda p: (0.0, 0.0, 0.0))
    problem.par_scale = np.array([100.0])
    begun = time.process_time()
    st = held(problem, clamped.rest(problem, (n, s), clamped.PLAIN), row(problem, "par", 0), FORCE, steps=3)
    return st.z[0:3, -1], time.process_time() - begun


def report(program, resolution, tip, seconds):
    print(f"| {program} | {resolution} | {np.linalg.norm(tip - expected()):.1e} | {seconds:.3g} |", flush=True)


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    from importlib.metadata import version

    print(", ".join(f"{name} {version(name)}" for name in ("exudyn", "pyelastica", "numpy", "scipy", "numba")))
    print("| program | resolution | error of the tip | CPU seconds |\n|---|---|---|---|")
    for n in (4, 8, 16, 32, 64, 128, 256, 512):
        runs = [with_exudyn(n) for _ in range(3)]
        report("Exudyn", f"{n} elements", runs[0][0], min(seconds for _, seconds in runs))
    for n, before in (*((n, 0.5) for n in (8, 16, 32, 64, 128)), (32, 0.0), (64, 0.0)):
        ends = (15.0, 20.0, 25.0, 30.0, 40.0, 80.0)
        states = with_pyelastica(n, ends, before)
        last = states[-1][0]
        error = np.linalg.norm(last - expected())
        tip, seconds = next(state for state in states if np.linalg.norm(state[0] - last) <= 0.1 * error)
        report("PyElastica" + ("" if before else ", clamp as it comes"), f"{n} elements", tip, seconds)
    for n, s in ((2, 3), (2, 4), (3, 4), (4, 5), (6, 6)):
        runs = [collocation(n, s) for _ in range(3)]
        report("collocation", f"{n} sub-intervals, {s} points", runs[0][0], min(seconds for _, seconds in runs))

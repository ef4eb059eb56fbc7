"""Peeling beams without finite elements: Chebyshev collocation of the strong form, with its own path following.

Units: nm, nN, aJ; 1 GPa = 1 nN/nm^2, 1e-19 J = 0.1 nN nm. In the order in which they stand on one another:

    laws        surface traction and cohesive laws
    friction    traction between the bottom face and the substrate
    law         the strip, the potential of its adhesion, the right sides of the strong form
    shapes      beams whose section and rest curve vary: the spatula, profiles given by a table or by pieces
    system      a solution on a mesh of sub-intervals; one linearisation of the boundary value problem
    mesh, solver, path    meshes, Newton corrections, the path of equilibria from rest
    turns       where the path turns: peak (dP = 0), lp1 and lp2 (du = 0)
    sheared     cohesive laws that hold along the substrate
    slip        paths with friction: what points remember
    curve       solutions between the points of a path
    energy      energy and first integral of a solution, work of the grip, plateau of a path
    turning     the turning points of a path as columns of a table
    selfcheck   the equations against their potential, a solution against the first integral and a Runge-Kutta code
    shapecheck  shapes against their derivatives, work against energy
    digits      numbers computed twice and printed to the digits that agree
"""
import os

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

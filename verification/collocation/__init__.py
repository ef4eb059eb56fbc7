"""The peeling strip without finite elements: Chebyshev collocation of the strong form, with its own path following.

Units: nm, nN, aJ; 1 GPa = 1 nN/nm^2, 1e-19 J = 0.1 nN nm. In the order in which they stand on one another:

    law         the strip, the potential of its adhesion, the right sides of the strong form
    system      a solution on a mesh of sub-intervals; one linearisation of the boundary value problem
    tracer      meshes, Newton corrections, the path of equilibria from rest
    turns       where the path turns: peak (dP = 0), lp1 and lp2 (du = 0)
    energy      energy of a solution, work of the grip, plateau of a path
    selfcheck   the equations against their potential, a solution against the first integral and a Runge-Kutta code
    digits      numbers computed twice and printed to the digits that agree
"""
import os

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

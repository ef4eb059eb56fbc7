"""Beams in space by Gauss collocation of the strong form, without finite elements.

law.py: what attracts a tilted section; beam.py: the 13 first-order equations; gauss.py: collocation, Newton's method,
meshes; path.py: paths of equilibria, extrema, folds, critical loads; grip.py: what the two ends of an adhesive strip
hold; tables.py: rows with errors. Units nm, nN, GPa wherever there is adhesion. One thread, so that results do not
depend on the machine's number of cores.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ.setdefault("OMP_NUM_THREADS", "1")

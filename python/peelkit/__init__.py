"""How thin adhesive beams peel from a surface.

A :class:`Scene` says what is peeled from what; :meth:`Scene.run` computes the whole path of equilibria, a
:class:`Peel`, with its limit points and their error bounds. Numbers are those of the command ``peel``, bit for bit:
lengths in nm, forces in nN, works in aJ, rotations in rad.
"""

from ._native import SCHEMA, VERSION as __version__
from ._sweep import read_sweep, sweep
from .curve import Curve
from .errors import ComputationError, ComputationWarning, PeelkitError, SceneError
from .peel import Peel
from .points import LimitPoint, Peak, Plateau
from .scene import Scene

__all__ = [
    "SCHEMA",
    "ComputationError",
    "ComputationWarning",
    "Curve",
    "LimitPoint",
    "Peak",
    "Peel",
    "PeelkitError",
    "Plateau",
    "Scene",
    "SceneError",
    "__version__",
    "read_sweep",
    "sweep",
]

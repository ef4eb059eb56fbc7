"""How thin adhesive beams peel from a surface.

A :class:`Scene` says what is peeled from what; :meth:`Scene.run` computes the whole path of equilibria, a
:class:`Peel`, with its limit points and their error bounds. Numbers are those of the command ``peel``, bit for bit:
lengths in nm, forces in nN, works in aJ, rotations in rad.
"""

from ._native import SCHEMA, VERSION as __version__
from ._sweep import read_sweep, sweep
from .analyses import Fit, Optimum, Uncertainty, fit, optimise, uncertainty
from .curve import Curve
from .errors import ComputationError, ComputationWarning, PeelkitError, SceneError
from .observed import Test
from .path import Path, PathPoint
from .peel import Peel
from .points import LimitPoint, Peak, Plateau
from .scene import Scene
from .sensitivity import Sensitivity
from .state import State

__all__ = [
    "SCHEMA",
    "ComputationError",
    "ComputationWarning",
    "Curve",
    "Fit",
    "LimitPoint",
    "Optimum",
    "Path",
    "PathPoint",
    "Peak",
    "Peel",
    "PeelkitError",
    "Plateau",
    "Scene",
    "SceneError",
    "Sensitivity",
    "State",
    "Test",
    "Uncertainty",
    "__version__",
    "fit",
    "optimise",
    "read_sweep",
    "sweep",
    "uncertainty",
]

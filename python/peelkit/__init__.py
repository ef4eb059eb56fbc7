"""How thin adhesive beams peel from a surface.

A :class:`Scene` says what is peeled from what; :meth:`Scene.run` computes the whole path of equilibria, a
:class:`Peel`, with its limit points and their error bounds. Numbers are those of the command ``peel``, bit for bit:
lengths in nm, forces in nN, works in aJ, rotations in rad.
"""

from ._native import SCHEMA, VERSION as __version__
from ._sweep import read_sweep, sweep
from .analyses import Fit, Optimum, Uncertainty, fit, optimise, uncertainty
from .curve import ArrayCurve, ArrayEvents, ArrayRows, Columns, Curve, PullOffCurve, RateCurve, SolidCurve, StepCurve
from .errors import ComputationError, ComputationWarning, PeelkitError, SceneError
from .observed import Test
from .found import Found
from .out_of_plane import OutOfPlane
from .path import Path, PathPoint
from .peel import Peel
from .points import LimitPoint, Peak, Plateau, Station
from .pulls import ArrayPull, PullAtRate, PullOff, SolidPeel
from .scene import Scene
from .sensitivity import Sensitivity
from .state import State
from .tip_law import TipLaw

__all__ = [
    "SCHEMA",
    "ArrayCurve",
    "ArrayEvents",
    "ArrayPull",
    "ArrayRows",
    "ComputationError",
    "ComputationWarning",
    "Columns",
    "Curve",
    "Fit",
    "Found",
    "LimitPoint",
    "Optimum",
    "OutOfPlane",
    "Path",
    "PathPoint",
    "Peak",
    "Peel",
    "PeelkitError",
    "Plateau",
    "PullAtRate",
    "PullOff",
    "PullOffCurve",
    "RateCurve",
    "Scene",
    "SceneError",
    "Sensitivity",
    "SolidCurve",
    "SolidPeel",
    "State",
    "Station",
    "StepCurve",
    "Test",
    "TipLaw",
    "Uncertainty",
    "__version__",
    "fit",
    "optimise",
    "read_sweep",
    "sweep",
    "uncertainty",
]

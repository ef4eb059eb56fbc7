"""A path of equilibria driven point by point."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from dataclasses import dataclass

from . import _native
from .errors import ComputationWarning, cut_by

__all__ = ["Path", "PathPoint"]


@dataclass(frozen=True, slots=True)
class PathPoint:
    """One equilibrium.

    Attributes
    ----------
    displacement : float
        u of the grip, nm.
    force : float
        P, nN.
    energy : float
        Stored and adhesion energy, aJ.
    negative_eigenvalues, negative_eigenvalues_load : int
        Of the tangent with the displacement and with the force held: zero where the point is stable.
    newton_iterations : int
        What it took.
    """

    displacement: float
    force: float
    energy: float
    negative_eigenvalues: int
    negative_eigenvalues_load: int
    newton_iterations: int


class Path(Iterator[PathPoint]):
    """A path that is computed as far as it is asked for; :meth:`Scene.path` makes one.

    It ends where the path of :meth:`Scene.run` ends. Nothing is located or bounded on it; :meth:`Scene.run` does that.
    """

    def __init__(self, native: _native.Path) -> None:
        self._native = native

    @property
    def end(self) -> str | None:
        """How the path has ended, as ``Peel.end`` says it; none before that."""
        return (self._native.end() or (None,))[0]

    def __next__(self) -> PathPoint:
        """Compute the next point, with the interpreter released.

        Raises
        ------
        StopIteration
            At the end of the path.
        ComputationError
            Where a point cannot be computed; the path ends there.

        Warns
        -----
        ComputationWarning
            Where a bound of the scene cuts it.
        """
        point = self._native.advance()
        if point is None:
            if (cut := cut_by(*(self._native.end() or (None, None)))) is not None:
                warnings.warn(f"the path goes on: {cut}", ComputationWarning, stacklevel=2)
            raise StopIteration
        return PathPoint(*point)

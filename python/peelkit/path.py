"""A path of equilibria driven point by point."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from . import _native

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
    """A path that is computed as far as it is asked for: an iterator without end; :meth:`Scene.path` makes one.

    Nothing is located or bounded on it; :meth:`Scene.run` does that.
    """

    def __init__(self, native: _native.Path) -> None:
        self._native = native

    def __next__(self) -> PathPoint:
        """Compute the next point, with the interpreter released.

        Raises
        ------
        ComputationError
            Where it cannot be computed; the path ends there.
        """
        point = self._native.advance()
        if point is None:
            raise StopIteration
        return PathPoint(*point)

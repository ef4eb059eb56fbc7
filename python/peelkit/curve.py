"""The points of a path as arrays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import pandas

    from . import _native

__all__ = ["Curve"]


class Curve(Mapping[str, NDArray[Any]]):
    """The columns of ``curve.csv``: an array a column, an item a path point.

    A column is an attribute as well: ``curve.force`` is ``curve["force"]``.

    Attributes
    ----------
    displacement : ndarray of float64
        u of the grip, nm.
    force : ndarray of float64
        P, nN.
    end_rotation : ndarray of float64
        θ(L), rad.
    work : ndarray of float64
        ∫ P du from where the path begins, aJ.
    negative_eigenvalues, negative_eigenvalues_load : ndarray of int64
        Of the tangent with the displacement and with the force held: zero where the point is stable.
    front : ndarray of float64
        S of the peeling front, nm.
    newton_iterations : ndarray of int64
        What the point took.
    torque, roll, yaw, reaction_across, reaction_lateral : ndarray of float64
        Of the grip in space: nN nm, degrees, degrees, nN, nN. Absent in the plane.
    """

    displacement: NDArray[np.float64]
    force: NDArray[np.float64]
    end_rotation: NDArray[np.float64]
    work: NDArray[np.float64]
    negative_eigenvalues: NDArray[np.int64]
    negative_eigenvalues_load: NDArray[np.int64]
    front: NDArray[np.float64]
    newton_iterations: NDArray[np.int64]
    torque: NDArray[np.float64]
    roll: NDArray[np.float64]
    yaw: NDArray[np.float64]
    reaction_across: NDArray[np.float64]
    reaction_lateral: NDArray[np.float64]

    def __init__(self, columns: Mapping[str, NDArray[Any]], units: Mapping[str, str]) -> None:
        self._columns = dict(columns)
        self._units = dict(units)
        self.__dict__.update(self._columns)

    def __getitem__(self, column: str) -> NDArray[Any]:
        """A column by its name."""
        return self._columns[column]

    def __iter__(self) -> Iterator[str]:
        """The names of the columns, in the order of ``curve.csv``."""
        return iter(self._columns)

    def __len__(self) -> int:
        """How many columns."""
        return len(self._columns)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """Return a row a point and a column a name, in the order of the names.

        Raises
        ------
        ValueError
            Where no copy is allowed: the columns do not lie beside each other.
        """
        if copy is False:
            raise ValueError("the columns of a curve are arrays of their own: an array of all of them is a copy")
        return np.column_stack([np.asarray(column, dtype=dtype or np.float64) for column in self._columns.values()])

    def to_pandas(self) -> pandas.DataFrame:
        """Return a table with the columns of ``curve.csv``, units in their names; pandas has to be installed."""
        import pandas

        named = {f"{name}_{self._units[name]}".rstrip("_"): column for name, column in self.items()}
        return pandas.DataFrame(named)

    def __repr__(self) -> str:
        """Columns and length."""
        return f"<Curve of {len(self.displacement)} points: {', '.join(self)}>"


def arrays(columns: Iterable[_native.Column]) -> dict[str, NDArray[Any]]:
    """The columns of a table by their names without units: memory becomes that of an array."""
    return {
        name: np.array(memory) if kind == "str" else np.frombuffer(memory, dtype=kind)
        for name, _, kind, memory in columns
    }


def of_columns(columns: Iterable[_native.Column]) -> Curve:
    """The curve of these columns."""
    found = list(columns)
    return Curve(arrays(found), {name: unit for name, unit, _, _ in found})

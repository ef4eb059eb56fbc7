"""The points of a path or of a pull as arrays."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from .notebook import table

if TYPE_CHECKING:
    import pandas
    import xarray

    from . import _native

__all__ = ["ArrayCurve", "ArrayEvents", "ArrayRows", "Columns", "Curve", "PullOffCurve", "RateCurve", "SolidCurve", "StepCurve"]

#: Rows that a notebook shows of either end.
_SHOWN = 5


class Columns(Mapping[str, NDArray[Any]]):
    """The columns of a table: an array a column, an item a row. A column is an attribute as well."""

    def __init__(self, columns: Mapping[str, NDArray[Any]], units: Mapping[str, str]) -> None:
        self._columns = dict(columns)
        self._units = dict(units)
        self.__dict__.update(self._columns)

    def __getitem__(self, column: str) -> NDArray[Any]:
        """A column by its name."""
        return self._columns[column]

    def __iter__(self) -> Iterator[str]:
        """The names of the columns, in the order of the file."""
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
        """Return a table with the columns of the file, units in their names; pandas has to be installed."""
        import pandas

        named = {f"{name}_{self._units[name]}".rstrip("_"): column for name, column in self.items()}
        return pandas.DataFrame(named)

    def to_xarray(self) -> xarray.Dataset:
        """Return a dataset with a variable a column, with its units, along `point`; xarray has to be installed."""
        import xarray

        units = {name: {"units": self._units[name] or "1"} for name in self}
        return xarray.Dataset({name: ("point", column, units[name]) for name, column in self.items()})

    def _repr_html_(self) -> str:
        """The first and the last rows, for a notebook."""
        count = len(next(iter(self.values()), ()))
        shown = range(count) if count <= 2 * _SHOWN else [*range(_SHOWN), *range(count - _SHOWN, count)]
        rows = [[row, *(column[row].item() for column in self.values())] for row in shown]
        names = (f"{name} ({self._units[name]})" if self._units[name] else name for name in self)
        return table(f"{type(self).__name__} of {count} points", rows, ["", *names])

    def __repr__(self) -> str:
        """Columns and length."""
        return f"<{type(self).__name__} of {len(next(iter(self.values()), ()))} points: {', '.join(self)}>"


class Curve(Columns):
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


class StepCurve(Columns):
    """The columns of ``steps.csv``: an array a column, an item an equilibrium of the steps before a pull, relative to where the grip took hold.

    Attributes
    ----------
    step : ndarray of int64
        Number of the step in ``drive.steps``, from 1.
    displacement, force : ndarray of float64
        Of the grip along the pull, nm and nN; not a number where it is free there.
    x, y : ndarray of float64
        How far it has moved along the substrate and up, nm; x is not a number where it is free.
    end_rotation : ndarray of float64
        How far it has rotated, rad.
    horizontal_force, vertical_force, moment : ndarray of float64
        What it exerts, nN, nN and nN nm.
    z, roll, yaw, lateral_force, torque, yaw_moment : ndarray of float64
        The same in space: nm, degrees, degrees, nN, nN nm, nN nm. Absent in the plane.
    """

    step: NDArray[np.int64]
    displacement: NDArray[np.float64]
    force: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    end_rotation: NDArray[np.float64]
    horizontal_force: NDArray[np.float64]
    vertical_force: NDArray[np.float64]
    moment: NDArray[np.float64]
    z: NDArray[np.float64]
    roll: NDArray[np.float64]
    yaw: NDArray[np.float64]
    lateral_force: NDArray[np.float64]
    torque: NDArray[np.float64]
    yaw_moment: NDArray[np.float64]


class PullOffCurve(Columns):
    """The columns of ``curve.csv`` of the pull-off of a seta: an array a column, an item a stable equilibrium.

    Attributes
    ----------
    step : ndarray of int64
        Number of the step, from 1.
    displacement, travel : ndarray of float64
        How far the root has moved in the step, and over all steps, nm.
    force : ndarray of float64
        On the root along the step, nN: positive where it is pulled.
    tips_attached : ndarray of int64
        Tips that adhere.
    root_x, root_y, root_z : ndarray of float64
        Where the root is, nm.
    force_x, force_y, force_z, moment_x, moment_y, moment_z : ndarray of float64
        On the root, nN and nN nm.
    energy, work, released : ndarray of float64
        Stored and of adhesion; of the root from the start; at events, aJ.
    """

    step: NDArray[np.int64]
    displacement: NDArray[np.float64]
    travel: NDArray[np.float64]
    force: NDArray[np.float64]
    tips_attached: NDArray[np.int64]
    root_x: NDArray[np.float64]
    root_y: NDArray[np.float64]
    root_z: NDArray[np.float64]
    force_x: NDArray[np.float64]
    force_y: NDArray[np.float64]
    force_z: NDArray[np.float64]
    moment_x: NDArray[np.float64]
    moment_y: NDArray[np.float64]
    moment_z: NDArray[np.float64]
    energy: NDArray[np.float64]
    work: NDArray[np.float64]
    released: NDArray[np.float64]


class SolidCurve(Columns):
    """The columns of ``curve.csv`` of the peel of a solid: an array a column, an item a point of the path.

    Attributes
    ----------
    displacement, force : ndarray of float64
        u and P of the grip, nm and nN.
    end_rotation : ndarray of float64
        Rotation of the chord of the end face, rad.
    work : ndarray of float64
        Of the grip from the beginning of the path, aJ; NaN for a load without a potential, as the next two.
    negative_eigenvalues, negative_eigenvalues_load : ndarray
        Unstable directions with the displacement held, and with the force.
    detached : ndarray of float64
        Length that has come off, nm.
    """

    displacement: NDArray[np.float64]
    force: NDArray[np.float64]
    end_rotation: NDArray[np.float64]
    work: NDArray[np.float64]
    negative_eigenvalues: NDArray[Any]
    negative_eigenvalues_load: NDArray[Any]
    detached: NDArray[np.float64]


class ArrayCurve(Columns):
    """The columns of ``curve.csv`` of an array of setae: an array a column, an item an end of a jump.

    Attributes
    ----------
    lift : ndarray of float64
        It only grows: nm, of a moment rad.
    load : ndarray of float64
        Force, nN, or moment, nN nm.
    """

    lift: NDArray[np.float64]
    load: NDArray[np.float64]


class ArrayEvents(Columns):
    """The columns of ``events.csv`` of an array of setae: an array a column, an item an event.

    Attributes
    ----------
    event, row, setae, first_seta : ndarray of int64
        Numbers of the event, of its row and of the first of its setae, from 1; how many setae change.
    from_sheet, to_sheet : ndarray of int64
        The sheets that they leave and reach.
    lift, load, load_after : ndarray of float64
        Before the event, and behind it at the same lift.
    released, work : ndarray of float64
        Released by it, and work of the load up to it, aJ.
    adhering : ndarray of int64
        Setae that adhere behind it.
    starts_jump : ndarray of bool
        Whether it comes at a lift above all before.
    """

    event: NDArray[np.int64]
    row: NDArray[np.int64]
    setae: NDArray[np.int64]
    first_seta: NDArray[np.int64]
    from_sheet: NDArray[np.int64]
    to_sheet: NDArray[np.int64]
    lift: NDArray[np.float64]
    load: NDArray[np.float64]
    load_after: NDArray[np.float64]
    released: NDArray[np.float64]
    work: NDArray[np.float64]
    adhering: NDArray[np.int64]
    starts_jump: NDArray[np.bool_]


class ArrayRows(Columns):
    """The columns of ``rows.csv`` of an array of setae: an array a column, an item a row just before the peak.

    Attributes
    ----------
    row, adhering : ndarray of int64
        Its number, from 1, and how many of its setae adhere.
    shear, normal : ndarray of float64
        Its force along the ground and off it, nN.
    """

    row: NDArray[np.int64]
    adhering: NDArray[np.int64]
    shear: NDArray[np.float64]
    normal: NDArray[np.float64]


class RateCurve(Columns):
    """The columns of ``curve.csv`` of a pull at a rate: an array a column, an item a step in time.

    Attributes
    ----------
    time : ndarray of float64
        Since the pull began, s.
    displacement, force : ndarray of float64
        Of what pulls, nm and nN.
    front : ndarray of float64
        S of the peeling front of a beam, nm. Absent of a seta.
    tips_attached : ndarray of int64
        Tips of a seta that adhere. Absent of a beam, as the next two.
    tip_forces, released : ndarray of float64
        Sum of the forces of the tips along the pull, nN, and what events have released, aJ.
    work, stored, adhesion, spring, kinetic, dissipated : ndarray of float64
        Work of what pulls, and what becomes of it, aJ.
    """

    time: NDArray[np.float64]
    displacement: NDArray[np.float64]
    force: NDArray[np.float64]
    front: NDArray[np.float64]
    tips_attached: NDArray[np.int64]
    tip_forces: NDArray[np.float64]
    released: NDArray[np.float64]
    work: NDArray[np.float64]
    stored: NDArray[np.float64]
    adhesion: NDArray[np.float64]
    spring: NDArray[np.float64]
    kinetic: NDArray[np.float64]
    dissipated: NDArray[np.float64]


_Kind = TypeVar("_Kind", bound=Columns)


def arrays(columns: Iterable[_native._Column]) -> dict[str, NDArray[Any]]:
    """The columns of a table by their names without units: memory becomes that of an array."""
    return {
        name: np.array(memory) if kind == "str" else np.frombuffer(memory, dtype=kind)
        for name, _, kind, memory in columns
    }


def of_columns(kind: type[_Kind], columns: Iterable[_native._Column]) -> _Kind:
    """The table of this kind with these columns."""
    found = list(columns)
    return kind(arrays(found), {name: unit for name, unit, _, _ in found})

"""The results as an `xarray.Dataset`: a dimension a key, a variable a column."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _native
from .batch import Table
from .columns import Column
from .grid import Grid

if TYPE_CHECKING:
    import xarray

__all__ = ["dataset"]


def dataset(grid: Grid, results: Table, scene: str, columns: tuple[Column, ...]) -> xarray.Dataset:
    """The dataset of all cases in their order.

    Parameters
    ----------
    grid : Grid
        The keys and their values: the dimensions and their coordinates.
    results : dict of arrays
        A column each, a case after the other.
    scene : str
        The scene before the sweep, a TOML text: an attribute of the dataset.
    columns : tuple of Column
        What was kept of each case.
    """
    import xarray

    keys = grid.keys
    coordinates = {axis.key: (axis.key, axis.values, _attributes(axis.unit, axis.key)) for axis in grid.axes}
    variables: dict[str, Any] = {}
    for column in columns:
        values = results[column.name].reshape(grid.shape)
        variables[column.name] = (keys, values, _attributes(column.units, column.long_name))
    attributes = {"program": f"peelkit {_native.VERSION}", "scene": scene}
    return xarray.Dataset(variables, coordinates, attributes)


def _attributes(units: str, long_name: str) -> dict[str, str]:
    # a plain number has the unit 1
    return {"units": units or "1", "long_name": long_name}

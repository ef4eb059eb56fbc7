"""A group of Zarr arrays along the dimension `case`, a chunk a batch: ``xarray.open_zarr`` reads it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ..errors import PeelkitError
from .batch import Table
from .store import Plan, refuse_other

__all__ = ["ZarrStore"]

#: One for each batch that is there, written behind its results.
DONE = "batch_done"


class ZarrStore:
    """An array a key and a column; a batch is one chunk of each."""

    def __init__(self, group: Any, plan: Plan) -> None:
        self._group = group
        self._arrays = {name: array for name, array in group.arrays()}
        self.plan = plan

    @classmethod
    def open(cls, path: Path, plan: Plan | None) -> ZarrStore:
        """The store that is there, or a new one of this plan."""
        import zarr

        if path.exists() and any(path.iterdir()):
            try:
                group = zarr.open_group(str(path), mode="r+")
                kept = Plan.from_json(str(group.attrs["plan"]))
            except (FileNotFoundError, KeyError, ValueError) as error:
                remedy = "Give a store that peelkit.sweep has begun, or remove one that was killed as it began."
                raise PeelkitError(f"{path} is no store of a sweep: {error!r}", remedy) from None
            if plan is not None:
                refuse_other(path, kept, plan)
            return cls(group, kept)
        if plan is None:
            raise PeelkitError(f"{path} is no store of a sweep", "Give a store that peelkit.sweep has begun.")
        # Zarr 2 has texts of fixed length
        group = zarr.open_group(str(path), mode="w", zarr_format=2)
        for axis in plan.grid.axes:
            _array(group, plan, axis.key, axis.values.dtype, {"units": axis.unit or "1"})
        for column in plan.columns:
            attributes = {"units": column.units or "1", "long_name": column.long_name}
            _array(group, plan, column.name, np.dtype(column.dtype), attributes, column.missing)
        done = group.create_array(DONE, shape=(plan.batches,), chunks=(1,), dtype="u1", fill_value=0)
        done.attrs["_ARRAY_DIMENSIONS"] = ["batch"]
        # what says that this is a store comes last
        group.attrs["plan"] = plan.to_json()
        # one file says of all arrays what they are
        zarr.consolidate_metadata(group.store)
        return cls(group, plan)

    def done(self) -> set[int]:
        """The batches that are there."""
        return set(np.flatnonzero(self._arrays[DONE][:]).tolist())

    def keep(self, index: int, results: Table) -> None:
        """Writes the chunks of a batch, and then that they are there."""
        start, stop = self.plan.span(index)
        for name, values in {**self.plan.grid.columns(start, stop), **results}.items():
            self._arrays[name][start:stop] = values
        self._arrays[DONE][index] = 1

    def read(self) -> Table:
        """All results in the order of the cases."""
        results = {column.name: self._arrays[column.name][:] for column in self.plan.columns}
        for index in set(range(self.plan.batches)) - self.done():
            start, stop = self.plan.span(index)
            for column in self.plan.columns:
                # what a kill may have left of it
                results[column.name][start:stop] = column.missing
        return results


def _array(group: Any, plan: Plan, name: str, dtype: Any, attributes: dict[str, str], missing: Any = None) -> None:
    array = group.create_array(name, shape=(plan.grid.size,), chunks=(plan.batch,), dtype=dtype, fill_value=missing)
    array.attrs.update({"_ARRAY_DIMENSIONS": ["case"], **attributes})

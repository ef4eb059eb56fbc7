"""A folder of Parquet files, a file a batch: ``pandas.read_parquet`` reads them all as one table."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from ..errors import PeelkitError
from .batch import Table
from .store import Plan, refuse_other

__all__ = ["ParquetStore"]

#: Readers of Parquet pass over names that begin like this.
PLAN = "_sweep.json"


class ParquetStore:
    """The columns `case` (the number of the case), the keys, and the results."""

    def __init__(self, path: Path, plan: Plan) -> None:
        self.path = path
        self.plan = plan

    @classmethod
    def open(cls, path: Path, plan: Plan | None) -> ParquetStore:
        """The store that is there, or a new one of this plan."""
        place = path / PLAN
        if place.is_file():
            kept = Plan.from_json(place.read_text("utf-8"))
            if plan is not None:
                refuse_other(path, kept, plan)
            return cls(path, kept)
        if plan is None or path.exists() and any(path.iterdir()):
            raise PeelkitError(f"{path} is no store of a sweep", "Give a store that peelkit.sweep has begun.")
        path.mkdir(parents=True, exist_ok=True)
        _write(place, plan.to_json().encode())
        return cls(path, plan)

    def _file(self, index: int) -> Path:
        return self.path / f"batch-{index:09d}.parquet"

    def done(self) -> set[int]:
        """The batches whose files are there: a file appears whole."""
        return {int(file.stem.removeprefix("batch-")) for file in self.path.glob("batch-*.parquet")}

    def keep(self, index: int, results: Table) -> None:
        """Writes the file of a batch beside its place, and renames it."""
        import pyarrow
        import pyarrow.parquet

        start, stop = self.plan.span(index)
        columns = {"case": np.arange(start, stop), **self.plan.grid.columns(start, stop), **results}
        sink = pyarrow.BufferOutputStream()
        arrays = {
            name: pyarrow.array(values.tolist() if values.dtype.kind == "U" else values)
            for name, values in columns.items()
        }
        pyarrow.parquet.write_table(pyarrow.table(arrays), sink)
        _write(self._file(index), sink.getvalue().to_pybytes())

    def read(self) -> Table:
        """All results in the order of the cases."""
        import pyarrow.parquet

        size = self.plan.grid.size
        results = {column.name: np.full(size, column.missing, column.dtype) for column in self.plan.columns}
        for index in self.done():
            start, stop = self.plan.span(index)
            table = pyarrow.parquet.read_table(self._file(index))
            for column in self.plan.columns:
                results[column.name][start:stop] = table[column.name].to_numpy()
        return results


def _write(place: Path, content: bytes) -> None:
    """A file that nobody finds half-written."""
    part = place.with_name(f".{place.name}.{os.getpid()}.part")
    part.write_bytes(content)
    part.replace(place)

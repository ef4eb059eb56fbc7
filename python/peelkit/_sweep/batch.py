"""A batch of neighbouring cases: what travels to a worker, and what comes back."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import _native
from ..errors import SceneError
from ..scene import Scene
from .columns import Column, Row, columns_of, refused_row, row_of

__all__ = ["Batch", "Cases", "Table", "cases_of", "compute", "table"]

#: Results of neighbouring cases: an array a column.
Table = dict[str, NDArray[Any]]


@dataclass(frozen=True)
class Batch:
    """Cases to compute.

    Attributes
    ----------
    start : int
        The number of the first case.
    scene : str
        The scene, a TOML text.
    name : str
        Where it was read from.
    keys : tuple of str
        What is varied.
    values : tuple of tuples
        Of each case the values of the keys.
    """

    start: int
    scene: str
    name: str
    keys: tuple[str, ...]
    values: tuple[tuple[Any, ...], ...]


def compute(batch: Batch) -> Table:
    """Compute the cases of a batch, one after the other; a worker calls this."""
    cases = cases_of(batch.scene, batch.name)
    return table([cases.row(batch.keys, values) for values in batch.values], cases.columns)


class Cases:
    """The cases of a sweep of a scene: its setae share the law of their tips."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._rows = _native.Rows(scene._native)
        self.columns = columns_of(scene._native.subject)

    def row(self, keys: tuple[str, ...], values: tuple[Any, ...]) -> Row:
        """The row of one case. Values that make no such scene together have the end ``"refused"``."""
        try:
            case = self._scene.with_(dict(zip(keys, values)))
        except SceneError:
            return refused_row(self.columns)
        if case._native.subject != self._scene._native.subject:
            return refused_row(self.columns)
        # what stopped short says so in its row, and not in a warning as of `run()`
        return row_of(self._rows.row(case._native), self.columns)


@lru_cache(maxsize=4)
def cases_of(scene: str, name: str) -> Cases:
    """The cases of a scene, the same ones for all batches of a worker."""
    return Cases(Scene.from_toml(scene, name))


def table(rows: list[Row], columns: tuple[Column, ...]) -> Table:
    """Rows as arrays."""
    return {column.name: np.array([row[column.name] for row in rows], dtype=column.dtype) for column in columns}

"""A batch of neighbouring cases: what travels to a worker, and what comes back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import SceneError
from ..scene import Scene
from .columns import COLUMNS, Row, refused_row, row_of

__all__ = ["Batch", "Table", "compute", "compute_case", "table"]

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
    scene = Scene.from_toml(batch.scene, batch.name)
    return table([compute_case(scene, batch.keys, values) for values in batch.values])


def compute_case(scene: Scene, keys: tuple[str, ...], values: tuple[Any, ...]) -> Row:
    """The row of one case. Values that make no scene together have the end ``"refused"``."""
    try:
        case = scene.with_(dict(zip(keys, values)))
    except SceneError:
        return refused_row()
    # what stopped short says so in its row, and not in a warning as of `run()`
    return row_of(case._native.run())


def table(rows: list[Row]) -> Table:
    """Rows as arrays."""
    return {column.name: np.array([row[column.name] for row in rows], dtype=column.dtype) for column in COLUMNS}

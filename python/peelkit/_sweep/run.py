"""A sweep from its scene to its dataset."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..scene import Scene
from .batch import Batch, Table, cases_of, compute
from .clients import computed, workers
from .columns import Column
from .dataset import dataset
from .grid import Grid
from .store import Plan, Store, open_store

if TYPE_CHECKING:
    import xarray
    from distributed import Client

__all__ = ["read_sweep", "sweep"]

#: What a batch should take, s: a hundred times what it costs to hand it to a worker and to keep it.
BATCH_SECONDS = 1.0
#: Batches for each core at least, so that all end at about the same time.
BATCHES_PER_CORE = 16


def sweep(
    scene: Scene,
    varied: Mapping[str, Any],
    client: Executor | Client | None = None,
    *,
    store: str | os.PathLike[str] | None = None,
    batch: int | None = None,
) -> xarray.Dataset:
    """Compute a scene with every combination of values of some keys: its peel, the pull-off of its seta, or its pull at a rate.

    Parameters
    ----------
    scene : Scene
        What the keys are replaced in.
    varied : mapping
        Keys with their values: numbers in the unit that ``peel keys`` lists, texts with a unit, or a quantity of pint.
    client : executor of concurrent.futures or dask.distributed.Client, optional
        What computes the batches; the cores of this machine, by threads, when absent. Workers may join and leave a
        cluster of dask meanwhile.
    store : path, optional
        A folder whose name ends with ``.zarr`` or ``.parquet``, to which batches are added as they are done. The same
        call goes on where it stopped. The store of another sweep is refused.
    batch : int, optional
        Cases that one worker computes one after the other. When absent, as many as take about a second, by the time
        that the first case takes. A store keeps the number with which it was begun.

    Returns
    -------
    xarray.Dataset
        With a dimension for each key; variables and coordinates have `units`, and error bounds are variables of their
        own: ``peak_force`` and ``peak_force_error``. Results do not depend on the client, but for ``solve_time``. Values
        that could not be computed have their `end`, ``"failed"`` or ``"refused"``, and NaN.

    Raises
    ------
    SceneError
        Where a key or value is refused.
    PeelkitError
        Where the client has lost its workers, or the store is that of another sweep.

    Examples
    --------
    >>> import peelkit
    >>> scene = peelkit.Scene.read("scenes/strip-100nm.toml")  # doctest: +SKIP
    >>> found = peelkit.sweep(scene, {"strip.youngs_modulus": [1, 2, 4], "drive.angle": [60, 90]})  # doctest: +SKIP
    >>> found.peak_force.sel({"drive.angle": 90})  # doctest: +SKIP
    """
    scene = scene._with_law()
    grid = Grid.of(scene, varied)
    text, name = scene.to_toml(), scene.name
    kept = _opened(store, Plan(text, name, grid, 1)) if store is not None else None
    if kept is not None:
        plan = kept.plan
    else:
        plan = Plan(text, name, grid, batch or _batch(scene, grid, workers(client)))
    if store is not None and kept is None:
        kept = open_store(Path(store), plan)
    results = _empty(grid, plan.columns) if kept is None else None
    done = set() if kept is None else kept.done()
    for part, found in computed(client, compute, _missing(plan, done)):
        if kept is not None:
            kept.keep(part.start // plan.batch, found)
        elif results is not None:
            _put(results, part.start, found)
    return dataset(grid, kept.read() if results is None and kept is not None else results or {}, text, plan.columns)


def read_sweep(store: str | os.PathLike[str]) -> xarray.Dataset:
    """Read the store of a sweep, finished or not: cases that are missing have NaN and no `end`.

    Parameters
    ----------
    store : path
        A folder that :func:`sweep` has written.

    Raises
    ------
    PeelkitError
        Where it is no store of a sweep.
    """
    kept = open_store(Path(store), None)
    return dataset(kept.plan.grid, kept.read(), kept.plan.scene, kept.plan.columns)


def _opened(store: str | os.PathLike[str], plan: Plan) -> Store | None:
    """The store that is there already."""
    path = Path(store)
    return open_store(path, plan) if path.exists() and any(path.iterdir()) else None


def _batch(scene: Scene, grid: Grid, cores: int) -> int:
    """So many cases that a batch takes long enough, by the time of the first one, and that there are enough batches."""
    started = time.perf_counter()
    cases_of(scene.to_toml(), scene.name).row(grid.keys, grid.values(0))
    seconds = time.perf_counter() - started
    enough = max(1, grid.size // (BATCHES_PER_CORE * cores))
    return min(enough, max(1, math.ceil(BATCH_SECONDS / seconds)))


def _missing(plan: Plan, done: set[int]) -> Iterator[Batch]:
    """The batches that are not there, made as they are asked for."""
    for index in range(plan.batches):
        if index not in done:
            start, stop = plan.span(index)
            values = tuple(plan.grid.values(case) for case in range(start, stop))
            yield Batch(start, plan.scene, plan.name, plan.grid.keys, values)


def _empty(grid: Grid, columns: tuple[Column, ...]) -> Table:
    return {column.name: np.full(grid.size, column.missing, column.dtype) for column in columns}


def _put(results: Table, start: int, found: Table) -> None:
    for name, values in found.items():
        results[name][start : start + len(values)] = values

"""Stores: where finished batches are kept, and what makes a store that of one sweep."""

from __future__ import annotations

import json
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from .. import _native
from ..errors import PeelkitError
from .batch import Table
from .columns import Column, columns_of
from .grid import Axis, Grid

__all__ = ["Plan", "Store", "open_store", "refuse_other"]


class Plan:
    """What is computed, and in which batches.

    Parameters
    ----------
    scene, name : str
        The scene as a TOML text, and where it was read from.
    grid : Grid
        What is varied.
    batch : int
        The number of cases of a batch; the last one may be smaller.
    """

    def __init__(self, scene: str, name: str, grid: Grid, batch: int) -> None:
        self.scene = scene
        self.name = name
        self.grid = grid
        self.batch = batch

    @cached_property
    def columns(self) -> tuple[Column, ...]:
        """What is kept of a case, by what the scene describes."""
        return columns_of(_native.Scene(self.name, self.scene, []).subject)

    @property
    def batches(self) -> int:
        """The number of batches."""
        return -(-self.grid.size // self.batch)

    def span(self, index: int) -> tuple[int, int]:
        """The first case of a batch, and that behind its last one."""
        start = index * self.batch
        return start, min(start + self.batch, self.grid.size)

    def to_json(self) -> str:
        """All of it, as the store keeps it."""
        return json.dumps({**self.identity(), "name": self.name, "batch": self.batch})

    @classmethod
    def from_json(cls, text: str) -> Plan:
        """What a store keeps."""
        kept = json.loads(text)
        axes = (Axis(axis["key"], axis["unit"], np.array(axis["values"])) for axis in kept["vary"])
        plan = cls(kept["scene"], kept["name"], Grid(tuple(axes)), kept["batch"])
        plan._version = kept["peelkit"]
        return plan

    _version: str = _native.VERSION

    def identity(self) -> dict[str, Any]:
        """Two sweeps are the same where these are: one program, one scene with its defaults, the same keys and values."""
        return {"peelkit": self._version, "scene": self.scene, "vary": self.grid.identity()}


class Store(Protocol):
    """Where batches are kept, each whole or not at all."""

    plan: Plan

    def done(self) -> set[int]:
        """The batches that are there."""

    def keep(self, index: int, results: Table) -> None:
        """Adds a batch."""

    def read(self) -> Table:
        """All results in the order of the cases; what is not there is missing."""


def open_store(path: Path, plan: Plan | None) -> Store:
    """The store at this place; with a plan it is begun where there is none.

    Raises
    ------
    PeelkitError
        Where the name says nothing of the format, or nothing is there and there is no plan.
    """
    if path.suffix == ".zarr":
        from .zarr_store import ZarrStore

        return ZarrStore.open(path, plan)
    if path.suffix == ".parquet":
        from .parquet_store import ParquetStore

        return ParquetStore.open(path, plan)
    raise PeelkitError(
        f"store is {str(path)!r}, whose name says neither Zarr nor Parquet",
        'Give a folder whose name ends with .zarr or .parquet: store="sweep.zarr".',
    )


def refuse_other(path: Path, kept: Plan, plan: Plan) -> None:
    """Refuses the store of another sweep, with the first difference.

    Raises
    ------
    PeelkitError
        With what differs.
    """
    mine, theirs = plan.identity(), kept.identity()
    if mine == theirs:
        return
    if theirs["peelkit"] != mine["peelkit"]:
        why = f"it was computed by peelkit {theirs['peelkit']}, and this is {mine['peelkit']}"
    elif kept.grid.keys != plan.grid.keys:
        why = f"it varies {' and '.join(kept.grid.keys)}, and this sweep {' and '.join(plan.grid.keys)}"
    elif theirs["vary"] != mine["vary"]:
        pairs = zip(kept.grid.axes, plan.grid.axes)
        key, old, new = next((a.key, a.values, b.values) for a, b in pairs if a.values.tolist() != b.values.tolist())
        why = f"{key} has {_shown(old, new)}"
    else:
        lines = zip(theirs["scene"].splitlines(), mine["scene"].splitlines())
        why = next((f"its scene has `{a}`, and this one `{b}`" for a, b in lines if a != b), "its scene is another one")
    raise PeelkitError(
        f"{path} is the store of another sweep: {why}",
        "Give another store, or remove this one if its results are not wanted any more.",
    )


def _shown(old: Any, new: Any) -> str:
    if len(old) != len(new):
        return f"{len(old)} values in it, and {len(new)} in this sweep"
    at = next(at for at, (a, b) in enumerate(zip(old, new)) if a != b)
    return f"as value {at + 1} {old[at]} in it, and {new[at]} in this sweep"

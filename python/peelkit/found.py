"""What an analysis has found, and the files of it."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import _native
from .errors import PeelkitError
from .notebook import numbers_of, table

__all__ = ["Found"]


class Found:
    """What an analysis has found: the object of its ``summary.json``."""

    def __init__(self, native: _native.Found | None, summary: Mapping[str, Any]) -> None:
        self._native = native
        self._found = dict(summary)

    @staticmethod
    def _read(native: _native.Found) -> dict[str, Any]:
        summary: dict[str, Any] = json.loads(native.summary)
        return summary

    def summary(self) -> dict[str, Any]:
        """Return the object that the command prints with ``--json``, units in its names."""
        return copy.deepcopy(self._found)

    def save(self, folder: str | os.PathLike[str], replace: bool = False) -> list[Path]:
        """Write the files of the command to a folder: all of them, or none.

        Parameters
        ----------
        folder : str or path
            Made if it is missing.
        replace : bool, optional
            Whether files of the same names are replaced; else a folder that holds something is refused.

        Returns
        -------
        list of Path
            The files.
        """
        if self._native is None:
            raise PeelkitError(
                "a result that was pickled has its numbers alone", "Save it before, or compute it again."
            )
        command = f"peelkit: {type(self).__name__}.save()"
        return [Path(file) for file in self._native.save(os.fspath(folder), command, replace)]

    def _repr_html_(self) -> str:
        """The numbers of a notebook: those of `summary()`, but for its lists."""
        return table(str(self._found.get("title", type(self).__name__)), numbers_of(self._found))

    def __reduce__(self) -> tuple[Any, ...]:
        """Every number; what is read again cannot be saved."""
        return type(self), (None, self._found)

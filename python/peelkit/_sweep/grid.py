"""The cases of a sweep: every combination of the values of its keys, numbered with the last key fastest."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import _native
from .._toml import units, value_text
from ..errors import SceneError
from ..scene import Scene

__all__ = ["Axis", "Grid"]


@dataclass(frozen=True)
class Axis:
    """A key and its values: numbers in `unit`, or texts of a key that takes words."""

    key: str
    unit: str
    values: NDArray[Any]


@dataclass(frozen=True)
class Grid:
    """The axes of a sweep."""

    axes: tuple[Axis, ...]

    @classmethod
    def of(cls, scene: Scene, varied: Mapping[str, Any]) -> Grid:
        """The axes of these keys; every value is one that its key takes.

        Raises
        ------
        SceneError
            Where there is no key, no value, or a value that the scene refuses.
        """
        if not varied:
            raise SceneError("a sweep varies no key", 'Give keys with their values: {"strip.length": [90, 100]}.')
        return cls(tuple(_axis(scene, key, values, len(varied) == 1) for key, values in varied.items()))

    @property
    def keys(self) -> tuple[str, ...]:
        """What is varied."""
        return tuple(axis.key for axis in self.axes)

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of values of each key."""
        return tuple(len(axis.values) for axis in self.axes)

    @property
    def size(self) -> int:
        """The number of cases."""
        return math.prod(self.shape)

    def values(self, case: int) -> tuple[Any, ...]:
        """The values of a case."""
        places = np.unravel_index(case, self.shape)
        return tuple(axis.values[place].item() for axis, place in zip(self.axes, places))

    def columns(self, start: int, stop: int) -> dict[str, NDArray[Any]]:
        """The values of the cases from `start` to `stop`, an array a key."""
        places = np.unravel_index(np.arange(start, stop), self.shape)
        return {axis.key: axis.values[place] for axis, place in zip(self.axes, places)}

    def identity(self) -> list[dict[str, Any]]:
        """What makes it this grid, as JSON takes it; numbers with all of their bits."""
        return [{"key": axis.key, "unit": axis.unit, "values": axis.values.tolist()} for axis in self.axes]


def _axis(scene: Scene, key: str, values: Any, alone: bool) -> Axis:
    if key not in units():
        # the message of the scene names near keys
        scene.with_(key, 1.0)
    unit = units()[key]
    if hasattr(values, "magnitude") and hasattr(values, "units"):
        values = [magnitude * values.units for magnitude in np.atleast_1d(values.magnitude)]
    elif isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise SceneError(
            f"`{key}` is varied over {values!r}, which is no list of values", f"Give a list: [{values!r}].", key
        )
    items = [_value(key, value, unit) for value in values]
    if not items:
        raise SceneError(f"`{key}` is varied over no value", "Give at least one.", key)
    if len(set(map(type, items))) > 1:
        items = [float(item) for item in items]
    if alone:
        # of several keys a value may be right only beside another
        for item in items:
            scene.with_(key, item)
    return Axis(key, unit, np.array(items))


def _value(key: str, value: Any, unit: str) -> Any:
    """A number in the unit of the key, or a word."""
    text = value_text(key, value)
    if not text.startswith('"'):
        return text == "true" if text in ("true", "false") else float(text) if "." in text or "e" in text else int(text)
    text = text[1:-1]
    if not unit:
        return text
    number = _native.usual(key, text)
    if number is None:
        raise SceneError(f"`{key}` is {value!r}, not a number with its unit", f"Give it in {unit}.", key, str(value))
    return number

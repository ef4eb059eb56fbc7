"""Values of Python as values of a scene in TOML."""

from __future__ import annotations

import math
import numbers
import os
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from . import _native
from .errors import SceneError

__all__ = ["table_text", "value_text"]

_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}


@cache
def units() -> dict[str, str]:
    """The unit in which the number of a key is taken, by key; empty where it has none."""
    return dict(_native.keys())


def value_text(key: str, value: Any) -> str:
    """A value of a key as TOML.

    Parameters
    ----------
    key : str
        ``"strip.length"``.
    value : str, bool, number, quantity of pint, path, sequence or mapping
        A bare number of a key with a unit is in the unit that ``peel keys`` lists.
    """
    unit = units().get(key, "")
    if _is_quantity(value):
        written = _written(value)
        # the unit of the quantity itself rounds nothing
        if unit and _native.usual(key, written) is not None:
            return _quoted(written)
    number = _number(key, value, unit)
    if number is None:
        return _nested(key, value)
    if not unit or isinstance(number, bool):
        return _plain(key, number)
    _finite(key, number)
    return _quoted(f"{number!r} {unit}")


def table_text(tables: Mapping[str, Any]) -> str:
    """A whole scene: keys of its top, and tables of keys."""
    top = [f"{key} = {value_text(key, value)}\n" for key, value in tables.items() if not isinstance(value, Mapping)]
    text = "".join(top)
    for table, entries in tables.items():
        if isinstance(entries, Mapping):
            text += f"\n[{_bare(table)}]\n"
            text += "".join(f"{_bare(key)} = {value_text(f'{table}.{key}', value)}\n" for key, value in entries.items())
    return text


def _number(key: str, value: Any, unit: str) -> bool | int | float | None:
    """The number that a value is, in the unit of its key; None where it is no number."""
    if _is_quantity(value):
        return _in_unit(key, value, unit)
    if type(value).__module__ == "numpy" and getattr(value, "ndim", 1) == 0:
        value = value.item()
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, numbers.Real):
        return float(value)
    return None


def _is_quantity(value: Any) -> bool:
    """Whether it is a quantity of pint."""
    return hasattr(value, "magnitude") and hasattr(value, "units")


def _written(quantity: Any) -> str:
    """A quantity in its own unit."""
    return f"{float(quantity.magnitude)!r} {quantity.units:~P}"


def _in_unit(key: str, quantity: Any, unit: str) -> float:
    """The magnitude of a quantity of pint in the unit of a key."""
    try:
        return float(quantity.to(unit).magnitude)
    except Exception as error:
        wanted = f"a quantity in {unit}" if unit else "a number without a unit"
        raise SceneError(
            f"`{key}` is {quantity}, which cannot be converted: {error}", f"Give {wanted}.", key, str(quantity)
        ) from None


def _nested(key: str, value: Any) -> str:
    """A value without a unit of its own: a text, a list, a table."""
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, os.PathLike):
        return _quoted(os.fspath(value))
    if isinstance(value, Mapping):
        entries = (f"{_bare(name)} = {_item(key, item)}" for name, item in value.items())
        return "{ " + ", ".join(entries) + " }"
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, Sequence):
        return "[" + ", ".join(_item(key, item) for item in value) + "]"
    raise SceneError(
        f"`{key}` is {value!r}, of the type {type(value).__name__}",
        "Give a text with its unit, a number, a quantity of pint, true or false, a list or a dictionary.",
        key,
        repr(value),
    )


def _item(key: str, value: Any) -> str:
    """A value inside a list or a table: what it measures stands in its text."""
    if _is_quantity(value):
        return _quoted(_written(value))
    number = _number(key, value, "")
    return _nested(key, value) if number is None else _plain(key, number)


def _plain(key: str, number: bool | int | float) -> str:
    if isinstance(number, bool):
        return "true" if number else "false"
    _finite(key, number)
    return repr(number)


def _finite(key: str, number: int | float) -> None:
    """Refuses what TOML could write and no key takes."""
    if isinstance(number, float) and not math.isfinite(number):
        raise SceneError(f"`{key}` is {number}, which is not finite", "Give a finite number.", key, str(number))


def _quoted(text: str) -> str:
    def escaped(c: str) -> str:
        if c in _ESCAPES:
            return _ESCAPES[c]
        return f"\\u{ord(c):04x}" if ord(c) < 0x20 or ord(c) == 0x7F else c

    return '"' + "".join(map(escaped, text)) + '"'


def _bare(name: str) -> str:
    plain = name.isascii() and name.replace("_", "a").replace("-", "a").isalnum()
    return name if plain else _quoted(name)

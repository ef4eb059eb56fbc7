"""What a notebook shows of a result: tables of HTML."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape
from typing import Any

__all__ = ["numbers_of", "table"]

#: Parts of a summary that are no result.
_ASIDE = ("version", "schema", "command", "scene", "title", "parameters", "timing")


def table(caption: str, rows: Iterable[Iterable[object]], head: Iterable[str] = ()) -> str:
    """A table: every cell as text."""
    names = "".join(f"<th>{escape(name)}</th>" for name in head)
    lines = "".join("<tr>" + "".join(f"<td>{escape(_text(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    above = f"<thead><tr>{names}</tr></thead>" if names else ""
    return f"<table><caption>{escape(caption)}</caption>{above}<tbody>{lines}</tbody></table>"


def numbers_of(summary: Mapping[str, Any]) -> list[tuple[str, object]]:
    """The numbers and words of a summary by their names, with those of the objects in it: ``peak.force_nN``."""
    found: list[tuple[str, object]] = []
    for name, value in summary.items():
        if name in _ASIDE or value is None or isinstance(value, list):
            continue
        if isinstance(value, Mapping):
            inner = value.items()
            found += [(f"{name}.{own}", of) for own, of in inner if of is not None and not isinstance(of, (list, dict))]
        else:
            found.append((name, value))
    return found


def _text(cell: object) -> str:
    return f"{cell:.6g}" if isinstance(cell, float) else str(cell)

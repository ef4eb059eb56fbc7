"""What a sweep keeps of a peel: the columns of sweep.csv, units apart from the names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..peel import Peel

__all__ = ["COLUMNS", "TEXT", "Column", "Row", "refused_row", "row_of"]

#: The type of a text in arrays and stores: long enough for every end.
TEXT = "<U24"

Row = dict[str, Any]


@dataclass(frozen=True)
class Column:
    """A variable of the dataset.

    Attributes
    ----------
    name : str
        ``"peak_force"``
    units : str
        ``"nN"``; empty for a plain number, a count or a text.
    long_name : str
        What it is, in words.
    is_text : bool
        Whether it holds texts.
    """

    name: str
    units: str
    long_name: str
    is_text: bool = False

    @property
    def dtype(self) -> str:
        """Of its arrays; a number that is missing is NaN."""
        return TEXT if self.is_text else "<f8"

    @property
    def missing(self) -> Any:
        """What stands where there is nothing."""
        return "" if self.is_text else float("nan")


#: Places on the path: the key of the summary, the name of the columns, and what it is.
_PLACES = (
    ("peak", "peak", "peak"),
    ("initiation_peak", "initiation_peak", "initiation peak"),
    ("plateau", "plateau", "plateau"),
    ("snap_off", "snap_off", "snap-off"),
    ("pad_detachment", "pad_detachment", "detachment of the pad"),
    ("detachment", "detachment", "detachment"),
)
_MEASURES = (("force", "nN", "force"), ("displacement", "nm", "displacement"))
#: Places whose work is a column of its own.
_WITH_WORK = ("pad_detachment", "detachment")


def _columns() -> tuple[Column, ...]:
    columns = []
    for _, name, words in _PLACES:
        measures = _MEASURES + ((("work", "aJ", "work"),) if name in _WITH_WORK else ())
        for measure, units, what in measures:
            columns.append(Column(f"{name}_{measure}", units, f"{what} at the {words}"))
            columns.append(Column(f"{name}_{measure}_error", units, f"error bound of the {what} at the {words}"))
    return (
        *columns,
        Column("work", "aJ", "work up to the snap-off, or to the end of a path without one"),
        Column("work_error", "aJ", "error bound of the work up to the snap-off"),
        Column("work_to", "", "up to where the work goes", is_text=True),
        Column("largest_computed_force", "nN", "largest force of a path without a peak; no error bound"),
        Column("end", "", "how the path ends", is_text=True),
        Column("accuracy_reached", "", "largest relative error bound"),
        Column("points", "", "path points"),
        Column("newton_iterations", "", "Newton iterations"),
        Column("elements", "", "elements"),
        Column("order", "", "order of the elements"),
        Column("solve_time", "s", "wall clock of the computation"),
    )


COLUMNS: tuple[Column, ...] = _columns()


def row_of(peel: Peel) -> Row:
    """The row of a peel; of one that failed the numbers that it has not are NaN."""
    # not the copy that `summary()` makes
    summary = peel._summary
    row = _empty(peel.end)
    for key, name, _ in _PLACES:
        found = summary[key]
        if found is not None:
            _fill(row, name, found)
    jump = summary["snap_off"]
    if jump is not None:
        row["work"], row["work_error"], row["work_to"] = (
            _number(jump, "work_aJ"),
            _number(jump, "error_aJ"),
            "first jump",
        )
    elif len(peel.curve.work):
        row["work"], row["work_to"] = float(peel.curve.work[-1]), "end of path"
    if summary["largest_computed_force"] is not None:
        row["largest_computed_force"] = _number(summary["largest_computed_force"], "force_nN")
    row["accuracy_reached"] = _number(summary["accuracy"], "reached")
    for count in ("points", "newton_iterations", "elements", "order"):
        row[count] = _number(summary["path"], count)
    row["solve_time"] = _number(summary["timing"], "solve_s")
    return row


def refused_row() -> Row:
    """The row of values that make no scene together."""
    return _empty("refused")


def _empty(end: str) -> Row:
    row: Row = {column.name: column.missing for column in COLUMNS}
    row["end"] = end
    return row


def _fill(row: Row, name: str, found: Mapping[str, Any]) -> None:
    """The columns of a place from its object in the summary."""
    for measure, units in (("force", "nN"), ("displacement", "nm"), ("work", "aJ")):
        if f"{name}_{measure}" in row:
            row[f"{name}_{measure}"] = _number(found, f"{measure}_{units}")
            row[f"{name}_{measure}_error"] = _number(found, f"error_{units}")


def _number(found: Mapping[str, Any], key: str) -> float:
    value = found.get(key)
    return float("nan") if value is None else float(value)

"""What a sweep keeps of a peel: the columns of sweep.csv, units apart from the names."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from .. import _native

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
    source : str
        The column of sweep.csv: ``"peak_force_nN"``.
    is_text : bool
        Whether it holds texts.
    """

    name: str
    units: str
    long_name: str
    source: str
    is_text: bool = False

    @property
    def dtype(self) -> str:
        """Of its arrays; a number that is missing is NaN."""
        return TEXT if self.is_text else "<f8"

    @property
    def missing(self) -> Any:
        """What stands where there is nothing."""
        return "" if self.is_text else float("nan")


#: Places on the path: the name of the columns, what it is, and its force in sweep.csv.
_PLACES = (
    ("peak", "peak", "peak_force_nN"),
    ("initiation_peak", "initiation peak", "initiation_peak_nN"),
    ("plateau", "plateau", "plateau_force_nN"),
    ("snap_off", "snap-off", "snap_off_force_nN"),
    ("pad_detachment", "detachment of the pad", "pad_detachment_force_nN"),
    ("detachment", "detachment", "detachment_force_nN"),
)
#: Places whose work is a column of its own.
_WITH_WORK = ("pad_detachment", "detachment")


def _with_error(name: str, units: str, what: str, source: str, error: str) -> tuple[Column, Column]:
    bound = Column(f"{name}_error", units, f"error bound of the {what}", error)
    return Column(name, units, what, source), bound


def _columns() -> tuple[Column, ...]:
    columns: list[Column] = []
    for name, words, force in _PLACES:
        columns += _with_error(f"{name}_force", "nN", f"force at the {words}", force, f"{name}_error_nN")
        displacement = f"{name}_displacement"
        what = f"displacement at the {words}"
        columns += _with_error(displacement, "nm", what, f"{displacement}_nm", f"{name}_error_nm")
        if name in _WITH_WORK:
            work = f"{name}_work"
            columns += _with_error(work, "aJ", f"work at the {words}", f"{work}_aJ", f"{work}_error_aJ")
    largest = "largest force of a path without a peak; no error bound"
    return (
        *columns,
        Column("work", "aJ", "work up to the snap-off, or to the end of a path without one", "work_aJ"),
        Column("work_error", "aJ", "error bound of the work up to the snap-off", "work_error_aJ"),
        Column("work_to", "", "up to where the work goes", "work_to", is_text=True),
        Column("largest_computed_force", "nN", largest, "largest_computed_force_nN"),
        Column("end", "", "how the path ends", "end", is_text=True),
        Column("accuracy_reached", "", "largest relative error bound", "accuracy_reached"),
        Column("points", "", "path points", "points"),
        Column("newton_iterations", "", "Newton iterations", "newton_iterations"),
        Column("elements", "", "elements", "elements"),
        Column("order", "", "order of the elements", "order"),
        Column("solve_time", "s", "wall clock of the computation", "solve_s"),
    )


COLUMNS: tuple[Column, ...] = _columns()


def row_of(peel: _native.Peel) -> Row:
    """The row of a peel; of one that failed the numbers that it has not are NaN."""
    found = json.loads(peel.row())
    return {column.name: column.missing if found[column.source] is None else found[column.source] for column in COLUMNS}


def refused_row() -> Row:
    """The row of values that make no scene together."""
    return {column.name: "refused" if column.name == "end" else column.missing for column in COLUMNS}

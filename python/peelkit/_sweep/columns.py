"""What a sweep keeps of a peel, a seta or a pull at a rate: the columns of sweep.csv, units apart from the names."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

__all__ = ["COLUMNS", "TEXT", "Column", "Row", "columns_of", "refused_row", "row_of"]

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


#: Those of a peel.
COLUMNS: tuple[Column, ...] = _columns()

_END = Column("end", "", "how the pull ends", "end", is_text=True)
_ITERATIONS = Column("newton_iterations", "", "Newton iterations", "newton_iterations")
_ELEMENTS = Column("elements", "", "elements", "elements")
_TIME = Column("solve_time", "s", "wall clock of the computation", "solve_s")
_IMBALANCE = Column("imbalance", "", "largest defect of the balance of energies", "imbalance")

_OF_SETA = (
    *_with_error("peak_force", "nN", "largest force on the root along the pull", "peak_force_nN", "mesh_error_nN"),
    Column("peak_displacement", "nm", "way of the root at the peak", "peak_displacement_nm"),
    Column("peak_tips_attached", "", "tips that adhere at the peak", "peak_tips_attached"),
    Column("first_detachment_force", "nN", "force before the first detachment", "first_detachment_force_nN"),
    Column("first_detachment_displacement", "nm", "way of the root there", "first_detachment_displacement_nm"),
    Column("last_detachment_force", "nN", "force before the last detachment", "last_detachment_force_nN"),
    Column("last_detachment_displacement", "nm", "way of the root there", "last_detachment_displacement_nm"),
    Column("events", "", "events at which tips or beams change", "events"),
    Column("most_tips_at_once", "", "changes of tips in the largest event", "most_tips_at_once"),
    Column("work", "aJ", "work of the root over all steps", "work_aJ"),
    Column("released", "aJ", "energy released in events", "released_aJ"),
    _IMBALANCE,
    _END,
    Column("points", "", "equilibria", "points"),
    _ITERATIONS,
    _ELEMENTS,
    _TIME,
)

_AT_RATE = (
    Column("largest_force", "nN", "largest force of the pull", "largest_force_nN"),
    Column("displacement", "nm", "displacement there", "displacement_nm"),
    Column("time", "s", "time there, since the pull began", "time_s"),
    Column("kinetic", "aJ", "kinetic energy at the step next to it", "kinetic_aJ"),
    Column("dissipated", "aJ", "energy dissipated up to that step", "dissipated_aJ"),
    Column("contact_lost", "s", "when nothing adheres any more", "contact_lost_s"),
    Column("work", "aJ", "work of what pulls, to the end", "work_aJ"),
    _IMBALANCE,
    _END,
    Column("steps", "", "steps in time", "steps"),
    _ITERATIONS,
    _ELEMENTS,
    _TIME,
)


_OF_SOLID = (
    *_with_error("peak_force", "nN", "largest force up to the first jump", "peak_force_nN", "peak_error_nN"),
    Column("peak_displacement", "nm", "displacement at the peak", "peak_displacement_nm"),
    Column("first_jump_displacement", "nm", "displacement at the first jump", "first_jump_displacement_nm"),
    Column("first_jump_force", "nN", "force at the first jump", "first_jump_force_nN"),
    _END,
    Column("points", "", "path points", "points"),
    _ITERATIONS,
    Column("unknowns", "", "unknowns of the solid", "unknowns"),
    _TIME,
)


_OF_ARRAY = (
    Column("peak_load", "", "load at the event with the largest one, nN or nN nm", "peak_load"),
    Column("peak_lift", "", "its lift there, nm or rad", "peak_lift"),
    Column("largest_load", "", "largest load, between events as well", "largest_load"),
    Column("first_load", "", "load at the first event", "first_load"),
    Column("work", "aJ", "work of the load up to the last event", "work_aJ"),
    Column("released", "aJ", "energy released in events", "released_aJ"),
    Column("setae", "", "setae of the array", "setae"),
    Column("detached", "", "setae that detach", "detached"),
    Column("events", "", "changes of setae", "events"),
    _END,
    _TIME,
)


def columns_of(subject: str) -> tuple[Column, ...]:
    """Those of what a scene describes: ``"peel"``, ``"solid"``, ``"array"``, ``"seta"`` or ``"rate"``."""
    return {"peel": COLUMNS, "solid": _OF_SOLID, "array": _OF_ARRAY, "seta": _OF_SETA, "rate": _AT_RATE}[subject]


def row_of(row: str, columns: tuple[Column, ...]) -> Row:
    """The row of an object; of a computation that failed the numbers that it has not are NaN."""
    found = json.loads(row)
    return {column.name: column.missing if found[column.source] is None else found[column.source] for column in columns}


def refused_row(columns: tuple[Column, ...]) -> Row:
    """The row of values that make no scene together."""
    return {column.name: "refused" if column.name == "end" else column.missing for column in columns}

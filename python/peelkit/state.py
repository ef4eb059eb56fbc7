"""The beam at one equilibrium of a path."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native

__all__ = ["State"]


class State(Mapping[str, NDArray[np.float64]]):
    """The fields along the beam at one equilibrium: the columns of ``states.csv``, from S = 0 to S = L.

    A field is an item by its name with its unit, ``state["x_nm"]``; ``list(state)`` has the names.

    Attributes
    ----------
    displacement : float
        u of the grip, nm.
    force : float
        P, nN.
    limit_point : str or None
        ``"displacement"`` or ``"load"`` where it is a limit point.
    path_position : float
        How far along the path, from 0 to 1.
    """

    displacement: float
    force: float
    limit_point: str | None
    path_position: float

    def __init__(
        self,
        displacement: float,
        force: float,
        limit_point: str | None,
        path_position: float,
        fields: Mapping[str, NDArray[np.float64]],
    ) -> None:
        self.displacement = displacement
        self.force = force
        self.limit_point = limit_point
        self.path_position = path_position
        self._fields = dict(fields)

    @classmethod
    def _of(cls, state: _native.State) -> State:
        fields: dict[str, NDArray[np.float64]] = {name: np.frombuffer(at) for name, at in state.fields.items()}
        return cls(state.displacement, state.force, state.limit_point, state.path_position, fields)

    @property
    def x(self) -> NDArray[np.float64]:
        """Of the axis along the ground, nm."""
        return self["x_nm"]

    @property
    def y(self) -> NDArray[np.float64]:
        """Of the axis above the ground, nm."""
        return self["y_nm"]

    def __getitem__(self, field: str) -> NDArray[np.float64]:
        """A field by its name with its unit."""
        return self._fields[field]

    def __iter__(self) -> Iterator[str]:
        """The names of the fields."""
        return iter(self._fields)

    def __len__(self) -> int:
        """How many fields."""
        return len(self._fields)

    def __reduce__(self) -> tuple[Any, ...]:
        """All that it holds."""
        return State, (self.displacement, self.force, self.limit_point, self.path_position, self._fields)

    def __repr__(self) -> str:
        """Place on the path."""
        kind = f", {self.limit_point} limit point" if self.limit_point else ""
        return f"<State at u = {self.displacement:.6g} nm, P = {self.force:.6g} nN{kind}>"

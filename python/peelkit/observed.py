"""What a machine that holds the displacement would record."""

from __future__ import annotations

import copy
import json
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from .curve import arrays
from .notebook import numbers_of, table

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Test"]


class Test:
    """A displacement-controlled test: the machine retreats until the beam is off, and returns.

    Attributes
    ----------
    machine_displacement, displacement : ndarray of float64
        Of the machine and of the grip, nm.
    force : ndarray of float64
        P, nN.
    work : ndarray of float64
        Of the machine, aJ.
    front : ndarray of float64
        S of the peeling front, nm.
    jump : ndarray of bool
        Whether the point lies behind a jump.
    branch, adheres : ndarray of str
        ``"retreat"`` or ``"approach"``, and what adheres.
    """

    __test__ = False  # of pytest

    machine_displacement: NDArray[np.float64]
    displacement: NDArray[np.float64]
    force: NDArray[np.float64]
    work: NDArray[np.float64]
    front: NDArray[np.float64]
    jump: NDArray[np.bool_]
    branch: NDArray[np.str_]
    adheres: NDArray[np.str_]

    def __init__(self, summary: Mapping[str, Any], columns: Mapping[str, NDArray[Any]]) -> None:
        self._found = dict(summary)
        self._columns = dict(columns)
        self.__dict__.update(self._columns)

    @classmethod
    def _of(cls, test: _native.Test) -> Test:
        return cls(json.loads(test.summary), arrays(test.columns))

    def summary(self) -> dict[str, Any]:
        """Return the object ``observed`` that ``peel run --observed --json`` prints."""
        return copy.deepcopy(self._found)

    @property
    def end(self) -> str:
        """How it ended."""
        end: str = self._found["end"]
        return end

    @property
    def pull_off_force(self) -> float | None:
        """The largest force that the machine records, nN; None where there is none."""
        force: float | None = self._found["pull_off_force_nN"]
        return force

    @property
    def hysteresis(self) -> float | None:
        """The work that the cycle loses, aJ; None where it was not closed."""
        work: float | None = self._found["hysteresis_aJ"]
        return work

    @property
    def jumps(self) -> list[dict[str, Any]]:
        """The jumps, with the energy that they release: objects of ``summary.json``."""
        return copy.deepcopy(list(self._found["jumps"]))

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Plot the recorded force against the displacement of the machine: retreat solid, approach dotted.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Where to plot; the current axes of pyplot when absent.
        **style
            Of the lines, as for `Axes.plot`.
        """
        from . import plotting

        return plotting.test(self, ax, style)

    def _repr_html_(self) -> str:
        """The numbers of a notebook: those of `summary()`, but for its lists."""
        return table("displacement-controlled test", numbers_of(self._found))

    def __reduce__(self) -> tuple[Any, ...]:
        """All that it holds."""
        return Test, (self._found, self._columns)

    def __repr__(self) -> str:
        """End and largest force."""
        return f"<Test: {self.end}, pull-off force {self.pull_off_force} nN, {len(self._found['jumps'])} jumps>"

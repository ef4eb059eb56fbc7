"""The result of a run."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _native, curve
from .curve import Curve, StepCurve
from .errors import ComputationError, PeelkitError
from .notebook import numbers_of, table
from .points import LimitPoint, Peak, Plateau, Station
from .sensitivity import Sensitivity, of_peel
from .state import State

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .scene import Scene

__all__ = ["Peel"]

# of a number without a unit
_UNITS = {"displacement": "nm", "force": "nN", "front": "nm", "end_rotation": "rad"}


class Peel:
    """The whole path of a scene with what was located on it; :meth:`Scene.run` makes one.

    Every number with an error bound is the located one, not the nearest path point.
    """

    def __init__(self, native: _native.Peel, scene: Scene) -> None:
        self._native = native
        self._scene = scene

    @property
    def scene(self) -> Scene:
        """The scene that was run."""
        return self._scene

    @cached_property
    def _summary(self) -> dict[str, Any]:
        summary: dict[str, Any] = json.loads(self._native.summary())
        return summary

    def summary(self) -> dict[str, Any]:
        """Return the object that ``peel run --json`` prints and ``summary.json`` holds, units in its names."""
        return copy.deepcopy(self._summary)

    @cached_property
    def curve(self) -> Curve:
        """The path points as arrays: the columns of ``curve.csv``."""
        return curve.of_columns(Curve, self._native.curve())

    @cached_property
    def steps(self) -> StepCurve:
        """The equilibria of the steps before the pull as arrays: the columns of ``steps.csv``, without rows where there are no steps."""
        return curve.of_columns(StepCurve, self._native.steps())

    @property
    def end(self) -> str:
        """How the path ends: ``"detached"``, ``"pivoting"``, ``"bound"``, ``"failed"`` and others, as `summary()` has it."""
        return self._native.end

    @property
    def reason(self) -> str | None:
        """Why it ends, of the ends ``"bound"`` and ``"failed"``."""
        return self._native.reason

    def raise_for_failure(self) -> None:
        """Raise where the computation stopped short.

        Raises
        ------
        ComputationError
            With the reason, and what to try.
        """
        if self.end in ("failed", "refused"):
            raise ComputationError(f"the computation stopped short: {self.reason}")

    def _peak(self, name: str) -> Peak | None:
        found = self._summary[name]
        return None if found is None else Peak.of(found)

    def _jump(self, name: str) -> LimitPoint | None:
        found = self._summary[name]
        return None if found is None else LimitPoint.of(found)

    @property
    def peak(self) -> Peak | None:
        """The largest force up to the first jump; None where no limit point has it."""
        return self._peak("peak")

    @property
    def initiation_peak(self) -> Peak | None:
        """The first local maximum of the force; None where there is none."""
        return self._peak("initiation_peak")

    @property
    def plateau(self) -> Plateau | None:
        """The steady force; None where there is none."""
        found = self._summary["plateau"]
        return None if found is None else Plateau.of(found)

    @property
    def first_jump(self) -> LimitPoint | None:
        """The first displacement limit point: a displacement-controlled test jumps here."""
        return self._jump("first_jump")

    @property
    def pad_detachment(self) -> LimitPoint | None:
        """The limit point behind which the pad does not adhere any more."""
        return self._jump("pad_detachment")

    @property
    def detachment(self) -> LimitPoint | None:
        """The limit point behind which nothing adheres any more."""
        return self._jump("detachment")

    @cached_property
    def limit_points(self) -> tuple[LimitPoint, ...]:
        """All limit points, in the order of the path."""
        return tuple(LimitPoint.of(found) for found in self._summary["limit_points"])

    @property
    def warnings(self) -> list[str]:
        """Where the model is not to be trusted, in words; `summary()` has the codes and numbers."""
        return [warning["meaning"] for warning in self._summary["warnings"]]

    def states(self, count: int = 0) -> list[State]:
        """Return the fields along the beam at every limit point and at places evenly along the path.

        Parameters
        ----------
        count : int, optional
            How many places, the two ends of the path among them.

        Returns
        -------
        list of State
            In the order of the path: what ``peel run --states`` writes. A result that was pickled runs its scene again
            for it, once.
        """
        if not 0 <= count <= 1000:
            raise PeelkitError(f"`count` is {count}, which is out of range", "Give 0 to 1000 places.")
        return [State._of(state) for state in self._native.states(count)]

    def at(self, **value: float | str) -> list[Station]:
        """Return the equilibria of the path at an exact value, wherever the path passes it.

        Parameters
        ----------
        **value : float or str
            One of ``displacement`` (nm), ``force`` (nN), ``front`` (nm), ``end_rotation`` (rad) and ``free_end_gap`` (nm), or a
            text with another unit: ``end_rotation="30 deg"``.

        Returns
        -------
        list of Station
            In the order of the path, each solved to the accuracy of the scene; empty where the path does not pass the value.

        Raises
        ------
        PeelkitError
            Where the quantity or the unit is not known, and where an equilibrium could not be computed.
        """
        if len(value) != 1:
            raise PeelkitError(f"`at` is given {len(value)} values", "Give one: peel.at(displacement=10.0).")
        [(quantity, asked)] = value.items()
        text = asked if isinstance(asked, str) else f"{float(asked)!r} {_UNITS.get(quantity, 'nm')}"
        return self._located(self._native.stations(f"{quantity}={text}"))

    def where(self, number: Callable[[State], float], value: float = 0.0, passing: str = "=") -> list[Station]:
        """Return the equilibria at which a number of the fields passes a value, wherever the path passes it.

        Parameters
        ----------
        number : callable
            Takes a :class:`State` of the path, as :meth:`states` returns them, and returns a float.
        value : float, optional
            What it passes.
        passing : str, optional
            ``">"`` where it rises past the value alone, ``"<"`` where it falls, ``"="`` both.

        Returns
        -------
        list of Station
            In the order of the path, each solved to the accuracy of the scene.

        Raises
        ------
        PeelkitError
            Where `passing` is not known, where the number is not finite, and where an equilibrium could not be computed. What
            `number` raises is raised.

        Examples
        --------
        >>> import peelkit
        >>> peel = peelkit.Scene.read("scenes/strip-100nm.toml").run()
        >>> [round(at.displacement, 6) for at in peel.where(lambda state: 2.0 * state.displacement, 60.0)]
        [30.0, 30.0, 30.0]
        """
        return self._located(self._native.passed(lambda state: float(number(State._of(state))), value, passing))

    @staticmethod
    def _located(text: str) -> list[Station]:
        """The equilibria of an object of ``summary.json`` that says where a path passes a value."""
        found = json.loads(text)
        if found["missed"]:
            raise ComputationError(found["missed"][0])
        return [Station.of(station) for station in found["found"]]

    def sensitivities(self) -> list[Sensitivity]:
        """Return by which power of each number of the scene the results change, as ``peel run --sensitivities`` does.

        Raises
        ------
        SceneError
            Where there are none: with friction, and where terms were left out.
        ComputationError
            Where they could not be computed.
        """
        return of_peel(self._native)

    def save(self, folder: str | os.PathLike[str], replace: bool = False) -> list[Path]:
        """Write the files of ``peel run`` to a folder: all of them, or none.

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
        return [Path(file) for file in self._native.save(os.fspath(folder), "peelkit: Scene.run()", replace)]

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Plot the force against the displacement; what is unstable under displacement control is dashed.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Where to plot; the current axes of pyplot when absent.
        **style
            Of the lines, as for `Axes.plot`: ``color``, ``label``, ``linewidth``, ...

        Returns
        -------
        matplotlib axes
            With labelled axes, nm and nN.
        """
        from . import plotting

        return plotting.curve(self, ax, style)

    def _repr_svg_(self) -> str | None:
        """The picture of a notebook: the curve with its limit points, as ``peel run`` draws it."""
        return self._native.svg() if len(self.curve.displacement) > 1 else None

    def _repr_html_(self) -> str:
        """The same with the numbers of `summary()`, but for its lists."""
        return (self._repr_svg_() or "") + table(self._scene.title, numbers_of(self.summary()))

    def __reduce__(self) -> tuple[Any, ...]:
        """The scene and every bit of the result."""
        return _restored, (self._scene, self._native.kept())

    def __repr__(self) -> str:
        """Title, end and peak."""
        peak = self.peak
        force = "no peak" if peak is None else f"peak {peak.force:.6g} nN at {peak.displacement:.6g} nm"
        return f"<Peel of {self._scene.title!r}: {self.end}, {force}>"


def _restored(scene: Scene, kept: bytes) -> Peel:
    return Peel(_native.Peel(scene._native, kept), scene)

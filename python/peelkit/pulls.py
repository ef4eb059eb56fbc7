"""The pull-off of a seta, pulls of arrays of setae, pulls at a rate, and peels of solids."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from . import _native
from .curve import ArrayCurve, ArrayEvents, ArrayRows, Columns, PullOffCurve, RateCurve, SolidCurve, of_columns
from .errors import ComputationError
from .found import Found
from .points import Peak

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

__all__ = ["ArrayPull", "PullAtRate", "PullOff", "SolidPeel"]


class _Pull(Found):
    """A pull, as far as it went."""

    def __init__(self, native: _native.Found | None, summary: dict[str, Any], curve: Columns) -> None:
        super().__init__(native, summary)
        self._curve = curve

    @property
    def end(self) -> str:
        """How it ended: ``"detached"``, ``"bound"``, ``"failed"`` and others, as `summary()` has it."""
        end: str = self._found["end"]
        return end

    @property
    def reason(self) -> str | None:
        """Why it ended, where it stopped short."""
        reason: str | None = self._found["reason"]
        return reason

    def raise_for_failure(self) -> None:
        """Raise where the computation stopped short.

        Raises
        ------
        ComputationError
            With the reason.
        """
        if self.end == "failed":
            raise ComputationError(f"the computation stopped short: {self.reason}")

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Plot the force against the displacement.

        Parameters
        ----------
        ax : matplotlib axes, optional
            Where to plot; the current axes of pyplot when absent.
        **style
            Of the line, as for `Axes.plot`.
        """
        from . import plotting

        return plotting.pull(self._curve, ax, style)

    def __reduce__(self) -> tuple[Any, ...]:
        """Every number; what is read again cannot be saved."""
        return type(self), (None, self._found, self._curve)


class PullOff(_Pull):
    """The pull-off of a seta, event by event; :meth:`Scene.run` of a scene with a seta makes one."""

    @classmethod
    def _of(cls, native: _native.Found) -> PullOff:
        return cls(native, cls._read(native), of_columns(PullOffCurve, native.columns()))

    @property
    def curve(self) -> PullOffCurve:
        """The stable equilibria as arrays: the columns of ``curve.csv``."""
        assert isinstance(self._curve, PullOffCurve)
        return self._curve

    @property
    def tips(self) -> int:
        """How many tips the seta has."""
        tips: int = self._found["tips"]
        return tips

    @property
    def peak(self) -> dict[str, Any] | None:
        """The largest force along the last step, an object of ``summary.json``: None where there is none."""
        peak: dict[str, Any] | None = self.summary()["peak"]
        return peak

    @property
    def peak_force(self) -> float | None:
        """The largest force along the last step, nN."""
        return None if self.peak is None else float(self.peak["force_nN"])

    @property
    def events(self) -> dict[str, int]:
        """How many events there are, and how many tips take part: an object of ``summary.json``."""
        events: dict[str, int] = self.summary()["events"]
        return events

    def __repr__(self) -> str:
        """Title, end and peak."""
        force = "no peak" if self.peak_force is None else f"peak {self.peak_force:.6g} nN"
        return f"<PullOff of {self._found['title']!r}: {self.end}, {force}, {self.tips} tips>"


class SolidPeel(_Pull):
    """The peel of a strip as a solid; :meth:`Scene.run` of a scene with a table ``solid`` makes one."""

    @classmethod
    def _of(cls, native: _native.Found) -> SolidPeel:
        return cls(native, cls._read(native), of_columns(SolidCurve, native.columns()))

    @property
    def curve(self) -> SolidCurve:
        """The points of the path as arrays: the columns of ``curve.csv``."""
        assert isinstance(self._curve, SolidCurve)
        return self._curve

    @property
    def peak(self) -> dict[str, Any] | None:
        """The largest force up to the first jump, an object of ``summary.json``: None where there is none."""
        peak: dict[str, Any] | None = self.summary()["peak"]
        return peak

    @property
    def limit_points(self) -> list[dict[str, Any]]:
        """All limit points, in path order: objects of ``summary.json``."""
        points: list[dict[str, Any]] = self.summary()["limit_points"]
        return points

    def __repr__(self) -> str:
        """Title, end and peak."""
        force = "no peak" if self.peak is None else f"peak {self.peak['force_nN']:.6g} nN"
        return f"<SolidPeel of {self._found['title']!r}: {self.end}, {force}>"


class ArrayPull(_Pull):
    """The pull of an array of setae, event by event; :meth:`Scene.run` of a scene with a table ``setae`` makes one."""

    def __init__(
        self,
        native: _native.Found | None,
        summary: dict[str, Any],
        curve: Columns,
        events: ArrayEvents,
        rows: ArrayRows,
    ) -> None:
        super().__init__(native, summary, curve)
        self._events = events
        self._rows = rows

    @classmethod
    def _of_array(cls, scene: _native.Scene) -> ArrayPull:
        native, events, rows = _native.pull_array(scene.with_law())
        curve = of_columns(ArrayCurve, native.columns())
        return cls(native, cls._read(native), curve, of_columns(ArrayEvents, events), of_columns(ArrayRows, rows))

    @property
    def curve(self) -> ArrayCurve:
        """Lift and load under a lift that only grows: the columns of ``curve.csv``."""
        assert isinstance(self._curve, ArrayCurve)
        return self._curve

    @property
    def lift(self) -> NDArray[np.float64]:
        """Of the curve, nm; of a moment rad."""
        return self.curve.lift

    @property
    def force(self) -> NDArray[np.float64]:
        """Load of the curve, nN; of a moment nN nm."""
        return self.curve.load

    @property
    def events(self) -> ArrayEvents:
        """Every change of setae as arrays: the columns of ``events.csv``."""
        return self._events

    @property
    def rows(self) -> ArrayRows:
        """The rows just before the peak as arrays: the columns of ``rows.csv``."""
        return self._rows

    @property
    def peak(self) -> dict[str, Any]:
        """The event with the largest load, an object of ``summary.json``."""
        peak: dict[str, Any] = self.summary()["peak"]
        return peak

    @property
    def peak_force(self) -> float | None:
        """Its load, nN; of a moment nN nm."""
        force: float | None = self._found["peak"]["load"]
        return force

    @property
    def closed_forms(self) -> dict[str, Any]:
        """What the computed is held against, an object of ``summary.json``."""
        forms: dict[str, Any] = self.summary()["closed_forms"]
        return forms

    def __repr__(self) -> str:
        """Title, end and peak."""
        unit = "nN" if self._found["load"] == "force" else "nN nm"
        load = "no peak" if self.peak_force is None else f"peak {self.peak_force:.6g} {unit}"
        return f"<ArrayPull of {self._found['title']!r}: {self.end}, {load}, {self._found['setae']} setae>"

    def __reduce__(self) -> tuple[Any, ...]:
        """Every number; what is read again cannot be saved."""
        return type(self), (None, self._found, self._curve, self._events, self._rows)


class PullAtRate(_Pull):
    """The pull of a beam or of a seta at its rate; :meth:`Scene.run` of a scene with a table ``time`` makes one."""

    @classmethod
    def _of(cls, native: _native.Found) -> PullAtRate:
        return cls(native, cls._read(native), of_columns(RateCurve, native.columns()))

    @property
    def curve(self) -> RateCurve:
        """The steps in time as arrays: the columns of ``curve.csv``."""
        assert isinstance(self._curve, RateCurve)
        return self._curve

    @property
    def largest_force(self) -> float:
        """nN."""
        force: float = self._found["largest_force"]["force_nN"]
        return force

    @property
    def contact_lost(self) -> float | None:
        """When nothing adhered any more, s; None where something did to the end."""
        time: float | None = self._found["contact_lost_s"]
        return time

    @property
    def over_equilibria(self) -> float | None:
        """The largest force over that of the equilibria beside it; None where these have none."""
        ratio: float | None = self._found["force_over_equilibria"]
        return ratio

    def __repr__(self) -> str:
        """Title, end and largest force."""
        return f"<PullAtRate of {self._found['title']!r}: {self.end}, largest force {self.largest_force:.6g} nN>"

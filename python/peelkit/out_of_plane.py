"""The stability of a planar path against leaving its plane."""

from __future__ import annotations

from typing import Any

from .found import Found

__all__ = ["OutOfPlane"]


class OutOfPlane(Found):
    """Where a planar path loses its stability out of the plane; :meth:`Scene.out_of_plane` makes one."""

    @property
    def end(self) -> str:
        """How the path ended, as of a :class:`Peel`."""
        end: str = self._found["end"]
        return end

    @property
    def reason(self) -> str | None:
        """Why the path ended, where it stopped short."""
        reason: str | None = self._found["reason"]
        return reason

    @property
    def stability(self) -> dict[str, Any] | None:
        """What was found, the object ``out_of_plane`` of ``summary.json``; None where no path was computed."""
        stability: dict[str, Any] | None = self.summary()["out_of_plane"]
        return stability

    @property
    def branch(self) -> dict[str, Any] | None:
        """The branch that leaves the plane; None where it was not asked for, or there is none."""
        stability = self.stability
        return None if stability is None else stability.get("branch")

    def __repr__(self) -> str:
        """Title and end."""
        followed = "" if self.branch is None else ", with its branch"
        return f"<OutOfPlane of {self._found['title']!r}: {self.end}{followed}>"

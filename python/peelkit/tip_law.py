"""The law of a tip of a seta."""

from __future__ import annotations

from .found import Found

__all__ = ["TipLaw"]


class TipLaw(Found):
    """Force and moment of a tip as a table, from its spatula; :meth:`Scene.coarsen` makes one.

    :meth:`save` writes the table, which a scene with a seta names in ``seta.tip_table``.
    """

    @property
    def relative_error(self) -> float:
        """The largest error of the table, relative to the largest force and moment."""
        error: float = self._found["relative_error"]
        return error

    def __repr__(self) -> str:
        """Title and error."""
        return f"<TipLaw of {self._found['title']!r}: relative error {self.relative_error:.1e}>"

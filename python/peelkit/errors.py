"""What the package raises and warns of."""

from __future__ import annotations

__all__ = ["ComputationError", "ComputationWarning", "PeelkitError", "SceneError"]


class PeelkitError(Exception):
    """What cannot be done, and what to try.

    Attributes
    ----------
    found : str
        What is wrong, where, with its numbers.
    remedy : str
        What to try: a sentence of its own.
    """

    found: str
    remedy: str

    def __init__(self, found: str, remedy: str = "") -> None:
        super().__init__(found, remedy)
        self.found = found
        self.remedy = remedy

    def __str__(self) -> str:
        """Both on two lines."""
        return f"{self.found}\n{self.remedy}" if self.remedy else self.found


class SceneError(PeelkitError, ValueError):
    """A scene that cannot be used.

    Attributes
    ----------
    found : str
        What is wrong: "`strip.height` is "10", a number without a unit".
    remedy : str
        What would be right.
    key : str or None
        The key that it is about, ``"strip.height"``, or the table; None where it is about the text as a whole.
    value : str or None
        The value of that key as it was written; None where it has none, as where the key is unknown.
    place : str or None
        Where it stands: ``"strip.toml, line 4"``; None where no file was read.
    """

    key: str | None
    value: str | None
    place: str | None

    def __init__(
        self,
        found: str,
        remedy: str = "",
        key: str | None = None,
        value: str | None = None,
        place: str | None = None,
    ) -> None:
        super().__init__(found, remedy)
        self.args = (found, remedy, key, value, place)
        self.key = key
        self.value = value
        self.place = place

    def __str__(self) -> str:
        """The place before what is wrong."""
        text = super().__str__()
        return f"{self.place}: {text}" if self.place else text


class ComputationError(PeelkitError):
    """A computation that stopped short of its end."""


class ComputationWarning(UserWarning):
    """A path stopped short of its end: what was reached of it is returned."""


def cut_by(end: str | None, reason: str | None) -> str | None:
    """Return the bound of the scene that cut a path; none where it was followed as far as ``path.until`` asks for."""
    return reason if end == "bound" and reason is not None and not reason.startswith("path.until") else None

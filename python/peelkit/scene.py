"""Scenes: what is peeled, from what, and how."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import _native
from ._native import Scene as NativeScene
from ._toml import table_text, value_text
from .errors import ComputationWarning, SceneError, cut_by
from .observed import Test
from .path import Path as EquilibriumPath
from .peel import Peel
from .sensitivity import Sensitivity

__all__ = ["Scene"]


class Scene:
    """A body, its adhesion, its grip and how that is moved: every value checked.

    A scene does not change; :meth:`with_` makes another one.

    Parameters
    ----------
    **tables
        The tables of the scene as dictionaries, and keys of its top such as `title`. A value is a text with its unit
        (``"100 nm"``), a quantity of pint, or a number in the unit that ``peel keys`` lists: lengths in nm, moduli in
        GPa, forces in nN, energies in aJ, works per area in J/m², angles in degrees, times in s.

    Raises
    ------
    SceneError
        Where a key is unknown, a value out of its range, or two do not fit each other.

    Examples
    --------
    >>> import peelkit
    >>> scene = peelkit.Scene(
    ...     strip=dict(length="100 nm", height=10.0, youngs_modulus="2 GPa"),
    ...     adhesion=dict(hamaker_constant="1e-19 J", equilibrium_distance="0.4 nm"),
    ... )
    >>> scene.with_("strip.length", "50 nm") == scene
    False
    """

    __slots__ = ("_native",)

    _native: NativeScene

    def __init__(self, **tables: Any) -> None:
        text = table_text(tables)
        try:
            self._native = _native.Scene("scene", text, [])
        except SceneError as error:
            # nobody has written the lines of this text
            raise SceneError(error.found, error.remedy, error.key, error.value) from None

    @classmethod
    def _of(cls, native: NativeScene) -> Scene:
        scene = cls.__new__(cls)
        scene._native = native
        return scene

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Scene:
        """Read a scene from a TOML file, as ``peel run`` does.

        Parameters
        ----------
        path : str or path
            Files that the scene names are looked for beside it.

        Raises
        ------
        OSError
            Where the file cannot be read.
        SceneError
            Where it is no scene: with the line, the key, the value and the remedy.
        """
        name = os.fspath(path)
        try:
            # the line ends stay as they are
            text = Path(name).read_bytes().decode("utf-8")
        except UnicodeDecodeError as error:
            line = 1 + error.object[: error.start].count(b"\n")
            remedy = "A scene is a TOML file, saved as UTF-8."
            raise SceneError("this is not text in UTF-8", remedy, place=f"{name}, line {line}") from None
        return cls.from_toml(text, name)

    @classmethod
    def from_toml(cls, text: str, name: str = "scene") -> Scene:
        """Read a scene from a text in TOML.

        Parameters
        ----------
        text : str
            As a file of a scene holds it.
        name : str, optional
            Of the file: it stands in messages, and files that the scene names are looked for beside it.

        Raises
        ------
        SceneError
            As :meth:`read`.
        """
        return cls._of(_native.Scene(name, text, []))

    def with_(self, key: str | Mapping[str, Any], value: Any = None) -> Scene:
        """Return the same scene with other values, as ``--set`` gives them to the command.

        Parameters
        ----------
        key : str or mapping
            ``"strip.length"``, or several keys with their values.
        value : str, number, quantity of pint, bool, list or dict
            As for the constructor.

        Raises
        ------
        SceneError
            Where a value is refused, alone or beside the others.
        """
        values = key if isinstance(key, Mapping) else {key: value}
        return self._of(self._native.with_values([(name, value_text(name, item)) for name, item in values.items()]))

    @property
    def name(self) -> str:
        """Where it was read from: the path of a file, or ``"scene"``."""
        return self._native.name

    @property
    def title(self) -> str:
        """What it is called."""
        return self._native.title

    def to_toml(self) -> str:
        """Return every key with its value as a text that reads as the same scene, to the last bit."""
        return self._native.to_toml()

    def run(self) -> Peel:
        """Compute the whole path of equilibria, with its limit points and their error bounds, as ``peel run`` does.

        The interpreter is released meanwhile, so that other threads run. Ctrl-C stops the computation.

        Returns
        -------
        Peel
            What was reached, also where the computation stopped short: then its `end` is ``"failed"``, and where the model
            has no stable state at rest ``"refused"``.

        Warns
        -----
        ComputationWarning
            Where it stopped short, and where a bound of the scene cut the path. A path that was followed as far as
            ``path.until`` asks for is whole.
        """
        peel = Peel(self._native.run(), self)
        if (cut := cut_by(peel.end, peel.reason)) is not None:
            warnings.warn(f"the path goes on: {cut}", ComputationWarning, stacklevel=2)
        if peel.end in ("failed", "refused"):
            warnings.warn(f"the computation stopped short: {peel.reason}", ComputationWarning, stacklevel=2)
        return peel

    def test(self) -> Test:
        """Compute what a machine that holds the displacement would record, as ``peel run --observed`` does.

        Raises
        ------
        SceneError
            Where the scene has no such test: with friction, say.

        Warns
        -----
        ComputationWarning
            Where it stopped short.
        """
        test = Test._of(_native.test(self._native))
        if test.end == "failed":
            reason = test.summary()["reason"]
            warnings.warn(f"the test stopped short: {reason}", ComputationWarning, stacklevel=2)
        return test

    def sensitivities(self) -> list[Sensitivity]:
        """Run the scene, and return by which power of each of its numbers the results change.

        The same as ``scene.run().sensitivities()``.
        """
        return self.run().sensitivities()

    def path(self, elements: int = 16, step_tolerance: float = 1.2e-2) -> EquilibriumPath:
        """Return the path of equilibria as an iterator that computes a point when it is asked for one.

        Parameters
        ----------
        elements : int, optional
            Of the mesh.
        step_tolerance : float, optional
            Error wanted of the prediction of a step, over the equilibrium gap: the smaller, the shorter the steps.

        Returns
        -------
        Path
            To the end of the path; leave the loop where enough is known.

        Examples
        --------
        >>> import itertools, peelkit
        >>> scene = peelkit.Scene(
        ...     strip=dict(length="100 nm", height="10 nm", youngs_modulus="2 GPa"),
        ...     adhesion=dict(hamaker_constant="1e-19 J", equilibrium_distance="0.4 nm"),
        ... )
        >>> lifted = itertools.takewhile(lambda at: at.displacement < 1.0, scene.path())
        >>> max(at.force for at in lifted) > 0.3
        True
        """
        if not 1 <= elements <= 100_000:
            raise SceneError(f"`elements` is {elements}, which is out of range", "Give 1 to 100000 elements.")
        if not 0.0 < step_tolerance <= 1.0:
            raise SceneError(f"`step_tolerance` is {step_tolerance}, which is out of range", "Give above 0 to 1.")
        return EquilibriumPath(_native.path(self._native, elements, step_tolerance))

    def __eq__(self, other: object) -> bool:
        """Whether every value is the same, wherever the two were read from."""
        if not isinstance(other, Scene):
            return NotImplemented
        return self._native is other._native or self.to_toml() == other.to_toml()

    def __hash__(self) -> int:
        """Of all values."""
        return hash(self.to_toml())

    def __reduce__(self) -> tuple[Any, ...]:
        """Name, text and replaced values."""
        return _restored, self._native.parts()

    def __repr__(self) -> str:
        """Name and title."""
        return f"<Scene {self.title!r} from {self.name!r}>"


def _restored(name: str, text: str, overrides: list[tuple[str, str]]) -> Scene:
    return Scene._of(_native.Scene(name, text, overrides))

"""Scenes: what is peeled, from what, and how."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from . import _native
from ._native import Scene as NativeScene
from ._toml import table_text, value_text
from .errors import ComputationWarning, PeelkitError, SceneError, cut_by
from .notebook import table
from .observed import Test
from .out_of_plane import OutOfPlane
from .path import Path as EquilibriumPath
from .peel import Peel
from .pulls import ArrayPull, PullAtRate, PullOff, SolidPeel
from .sensitivity import Sensitivity
from .state import State
from .tip_law import TipLaw

__all__ = ["Scene"]

_Run = TypeVar("_Run", Peel, PullOff, PullAtRate, SolidPeel, ArrayPull, OutOfPlane)


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

    def _with_law(self) -> Scene:
        """The same; the law of its setae is made where it names a folder without one."""
        return self._of(self._native.with_law())

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

    def to_dict(self) -> dict[str, Any]:
        """Return every key with its value: its tables as dictionaries, quantities as texts with their unit.

        Returns
        -------
        dict
            ``Scene(**scene.to_dict())`` is the same scene, to the last bit.
        """
        found: dict[str, Any] = {}
        for of, name, value in self._native.entries():
            (found.setdefault(of, {}) if of else found)[name] = value
        return found

    def __getitem__(self, key: str) -> Any:
        """The value of a key: ``scene["strip.length"]``; a number is in the unit that ``peel keys`` lists.

        Raises
        ------
        KeyError
            Where there is no such key, or the scene has no value of it.
        """
        value = dict(self._keys())[key]
        number = self._native.number(key) if isinstance(value, str) else None
        return value if number is None else number

    def run(self, stop_where: Callable[[State], float] | None = None) -> Peel | Any:
        """Compute what the scene describes, as ``peel run`` does.

        Of a beam that is the whole path of equilibria, with its limit points and their error bounds. Of a scene with a table
        ``seta`` it is :meth:`pull_off`, with ``time`` :meth:`pull_at_rate`, with ``solid`` :meth:`peel_solid`, with ``setae``
        :meth:`pull_array`: call these where types are checked. A law of the setae that is missing in the folder ``setae.law`` is
        made there first, of the scene ``setae.seta``. The interpreter is released meanwhile, so that other threads run. Ctrl-C stops the computation.

        Parameters
        ----------
        stop_where : callable, optional
            Of a beam: takes a :class:`State` of the path and returns a float; the path ends where that passes zero.

        Returns
        -------
        Peel, PullOff, PullAtRate, SolidPeel or ArrayPull
            What was reached, also where the computation stopped short: then its `end` is ``"failed"``, and where the model
            has no stable state at rest ``"refused"``.

        Warns
        -----
        ComputationWarning
            Where it stopped short, and where a bound of the scene cut the path. A path that was followed as far as
            ``path.until`` asks for is whole.
        """
        if stop_where is not None and self._native.subject != "peel":
            found = f"`stop_where` is given, and the scene describes a {self._native.subject}"
            raise PeelkitError(found, "Give it for a beam alone, or `output.events` in the scene.")
        if self._native.subject == "seta":
            return self._warned(PullOff._of(_native.pull_off(self._native)))
        if self._native.subject == "solid":
            return self._warned(SolidPeel._of(_native.peel_solid(self._native)))
        if self._native.subject == "rate":
            return self._warned(PullAtRate._of(_native.pull_at_rate(self._native)))
        if self._native.subject == "array":
            return self._warned(ArrayPull._of_array(self._native))
        ends = None if stop_where is None else lambda state: float(stop_where(State._of(state)))
        return self._warned(Peel(self._native.run(ends), self))

    @staticmethod
    def _warned(found: _Run) -> _Run:
        """The result, with a warning where it stopped short of its end."""
        if (cut := cut_by(found.end, found.reason)) is not None:
            warnings.warn(f"the path goes on: {cut}", ComputationWarning, stacklevel=3)
        if found.end in ("failed", "refused"):
            warnings.warn(f"the computation stopped short: {found.reason}", ComputationWarning, stacklevel=3)
        return found

    def pull_off(self) -> PullOff:
        """Compute the pull-off of the seta of the scene, as ``peel run`` does: see :meth:`run`.

        Raises
        ------
        SceneError
            Where the scene has no seta, or is pulled at a rate.
        ComputationError
            Where nothing could be computed: no law of the tips, say.
        """
        if self._native.subject != "seta":
            raise SceneError("the scene has no seta in equilibrium", "Give it a table `seta`, and none `time`.")
        return self._warned(PullOff._of(_native.pull_off(self._native)))

    def peel_solid(self) -> SolidPeel:
        """Compute the peel of the strip of the scene as a solid, as ``peel run`` does: see :meth:`run`.

        Raises
        ------
        SceneError
            Where the scene has no table ``solid``.
        """
        if self._native.subject != "solid":
            raise SceneError("the scene is not computed as a solid", "Give it a table `solid`.")
        return self._warned(SolidPeel._of(_native.peel_solid(self._native)))

    def pull_array(self) -> ArrayPull:
        """Compute the pull of the array of setae of the scene, as ``peel run`` does: see :meth:`run`.

        Raises
        ------
        SceneError
            Where the scene has no table ``setae``.
        """
        if self._native.subject != "array":
            raise SceneError("the scene has no array of setae", "Give it a table `setae`, and `patch` or `lamella`.")
        return self._warned(ArrayPull._of_array(self._native))

    def pull_at_rate(self) -> PullAtRate:
        """Compute the pull of the scene at its rate, of a beam or of a seta, as ``peel run`` does: see :meth:`run`.

        Raises
        ------
        SceneError
            Where the scene has no rate, or cannot be pulled at it.
        ComputationError
            Where the pull has no beginning.
        """
        if self._native.subject != "rate":
            raise SceneError("the scene is not pulled at a rate", "Give it a table `time`.")
        return self._warned(PullAtRate._of(_native.pull_at_rate(self._native)))

    def coarsen(
        self,
        tolerance: float = 1e-3,
        press: float | None = None,
        lateral: tuple[float, float] | None = None,
        rotation: tuple[float, float] | None = None,
    ) -> TipLaw:
        """Compute the law of a tip of a seta from the spatula of the scene, as ``peel coarsen`` does.

        Parameters
        ----------
        tolerance : float, optional
            Error wanted of forces and moment, relative to the largest.
        press : float, optional
            How far the tip is pressed, nm; 50 nm when absent, and 5 nm where the pad is held.
        lateral, rotation : pair of floats, optional
            Ranges of v, nm, of a pad that is held, and of θ, rad.

        Returns
        -------
        TipLaw
            The table; its `save` writes it for ``seta.tip_table``.

        Warns
        -----
        ComputationWarning
            Where the table is not as accurate as asked.

        Raises
        ------
        SceneError
            Where the scene has no such law.
        """
        native = _native.coarsen(self._native, tolerance, press, lateral, rotation)
        if native.short is not None:
            warnings.warn(native.short, ComputationWarning, stacklevel=2)
        return TipLaw(native, TipLaw._read(native))

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

    def out_of_plane(self, branch: bool = False) -> OutOfPlane:
        """Compute where the planar path can be left out of its plane, as ``peel run --out-of-plane`` does.

        Parameters
        ----------
        branch : bool, optional
            Whether the branch that leaves the plane is followed as well, as with ``--branch``.

        Raises
        ------
        SceneError
            Where the scene has no such stability: with friction, say.

        Warns
        -----
        ComputationWarning
            Where the path or the branch stopped short, and where a bound of the scene cut the path.
        """
        native = _native.out_of_plane(self._native, branch)
        found = self._warned(OutOfPlane(native, OutOfPlane._read(native)))
        if native.short is not None and found.end not in ("failed", "refused"):
            warnings.warn(f"the computation stopped short: {native.short}", ComputationWarning, stacklevel=2)
        return found

    def sensitivities(self) -> list[Sensitivity]:
        """Run the scene, and return by which power of each of its numbers the results change.

        The same as ``scene.run().sensitivities()``.
        """
        return self._warned(Peel(self._native.run(), self)).sensitivities()

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

    def _repr_html_(self) -> str:
        """Every key with its value, for a notebook; quantities as `to_dict()` has them."""
        return table(self.title, self._keys(), ("key", "value"))

    def _keys(self) -> list[tuple[str, Any]]:
        """Every key that has a value, with it."""
        entries = self._native.entries()
        return [(f"{of}.{name}" if of else name, value) for of, name, value in entries]

    def __repr__(self) -> str:
        """Name and title."""
        return f"<Scene {self.title!r} from {self.name!r}>"


def _restored(name: str, text: str, overrides: list[tuple[str, str]]) -> Scene:
    return Scene._of(_native.Scene(name, text, overrides))

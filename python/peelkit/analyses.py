"""Analyses of a scene that says what is free, fitted or uncertain."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from .errors import ComputationWarning, SceneError
from .found import Found
from .scene import Scene

__all__ = ["Fit", "Optimum", "Uncertainty", "fit", "optimise", "uncertainty"]


class Optimum(Found):
    """The best design that was found; :func:`optimise` makes one.

    Attributes
    ----------
    scene : Scene or None
        The best design as a scene of its own.
    """

    def __init__(self, native: _native.Found | None, summary: Mapping[str, Any], scene: Scene | None) -> None:
        super().__init__(native, summary)
        self.scene = scene

    def __reduce__(self) -> tuple[Any, ...]:
        """Every number; what is read again cannot be saved."""
        return type(self), (None, self._found, self.scene)

    @property
    def objective(self) -> float:
        """The objective of the best design, in its unit."""
        objective: float = self._found["after"]["objective"]
        return objective

    @property
    def error(self) -> float | None:
        """Bound on the error of the objective; None where there is none."""
        error: float | None = self._found["after"]["error"]
        return error

    @property
    def gain(self) -> float:
        """The objective over that of the design that was given."""
        gain: float = self._found["gain"]
        return gain

    @property
    def values(self) -> dict[str, float]:
        """The variables of the best design by name, in the units that `summary()` has."""
        return {variable["name"]: variable["after"] for variable in self._found["variables"]}

    def __repr__(self) -> str:
        """Objective and gain."""
        return f"<Optimum: {self._found['of']} = {self.objective:.6g}, {self.gain:.4g} times that of the start>"


class Fit(Found):
    """The parameters of a measured curve; :func:`fit` makes one.

    Attributes
    ----------
    scene : Scene
        The scene with the parameters that were found.
    """

    def __init__(self, native: _native.Found | None, summary: Mapping[str, Any], scene: Scene) -> None:
        super().__init__(native, summary)
        self.scene = scene

    def __reduce__(self) -> tuple[Any, ...]:
        """Every number; what is read again cannot be saved."""
        return type(self), (None, self._found, self.scene)

    @property
    def end(self) -> str:
        """``"converged"``, or why not."""
        end: str = self._found["end"]
        return end

    @property
    def parameters(self) -> dict[str, float]:
        """The values by key, in nm, GPa, aJ, J/m², rad: the units that `summary()` has."""
        return {fitted["key"]: fitted["value"] for fitted in self._found["fitted"]}

    @property
    def standard_errors(self) -> dict[str, float | None]:
        """The standard errors by key, likewise; None where the curve does not determine them."""
        return {fitted["key"]: fitted["standard_error"] for fitted in self._found["fitted"]}

    def __repr__(self) -> str:
        """End and parameters."""
        values = ", ".join(f"{key} = {value:.6g}" for key, value in self.parameters.items())
        return f"<Fit: {self.end}, {values}>"


class Uncertainty(Found):
    """What distributions of keys make of the results; :func:`uncertainty` makes one."""

    def __repr__(self) -> str:
        """Title."""
        return f"<Uncertainty of {self._found['title']!r}>"


def optimise(scene: Scene) -> Optimum:
    """Find the best design of a scene that has a table ``optimise``, as ``peel optimise`` does.

    Parameters
    ----------
    scene : Scene
        Says in its table ``optimise`` what is free and what is best.

    Returns
    -------
    Optimum
        With the design that is best, its bounds and why it is an optimum.

    Raises
    ------
    SceneError
        Where the scene does not say what is free, or what it says cannot be optimised.
    ComputationError
        Where no design could be computed.
    """
    found = _native.optimise(scene._native.with_law())
    best = None if found.scene is None else Scene.from_toml(found.scene, scene.name)
    return Optimum(found, Optimum._read(found), best)


def fit(
    scene: Scene,
    data: str | os.PathLike[str] | ArrayLike | None = None,
    force: ArrayLike | None = None,
    error: ArrayLike | None = None,
) -> Fit:
    """Determine parameters of a scene from a measured curve, as ``peel fit`` does.

    Parameters
    ----------
    scene : Scene
        Says in its table ``fit`` which parameters, and how.
    data : path, or array of displacements, optional
        Absent where the scene names its curves, as ``fit.curves``. A CSV with displacement, force and, if known, its standard error, with units in its header; or the displacements
        in nm, in the order in which they were measured.
    force : array, optional
        Of the displacements, nN. Absent where `data` is a file.
    error : array or float, optional
        Standard error of the forces, nN; estimated when absent.

    Returns
    -------
    Fit
        With the parameters and their intervals.

    Warns
    -----
    ComputationWarning
        Where the search has not converged.

    Raises
    ------
    SceneError
        Where scene and curve cannot be fitted.
    """
    if data is None:
        if force is not None or error is not None:
            raise TypeError("`data` is missing: give displacements with the forces")
        native = _native.fit(scene._native, None, None)
    elif isinstance(data, (str, os.PathLike)):
        if force is not None or error is not None:
            raise TypeError(
                "`force` and `error` are columns of the file; give arrays in place of the file, or the file alone"
            )
        native = _native.fit(scene._native, os.fspath(data), None)
    else:
        if force is None:
            raise TypeError("`force` is missing: give displacements and forces, or the path of a file with both")
        native = _native.fit(scene._native, "data", _points(data, force, error))
    found = Fit(native, Fit._read(native), Scene.from_toml(native.scene or "", scene.name))
    if found.end != "converged":
        reason = found.summary()["reason"]
        warnings.warn(f"the search for the best parameters stopped short: {reason}", ComputationWarning, stacklevel=2)
    return found


def _points(
    displacement: ArrayLike, force: ArrayLike, error: ArrayLike | None
) -> list[tuple[float, float, float | None]]:
    u, p = _column("data", displacement), _column("force", force)
    if len(u) != len(p):
        raise SceneError(
            f"{len(u)} displacements and {len(p)} forces were given", "Give a force for each displacement."
        )
    if error is None:
        return [(a, b, None) for a, b in zip(u.tolist(), p.tolist())]
    sigma = np.broadcast_to(np.asarray(error, dtype=np.float64), p.shape)
    if not (sigma > 0).all():
        raise SceneError(
            "a standard error of the forces is not above zero", "Give standard errors above zero, or none."
        )
    return list(zip(u.tolist(), p.tolist(), sigma.tolist()))


def _column(name: str, values: ArrayLike) -> NDArray[np.float64]:
    column = np.asarray(values, dtype=np.float64)
    if column.ndim != 1 or not np.isfinite(column).all():
        raise SceneError(f"`{name}` is no list of finite numbers", "Give an array of one dimension without NaN.")
    return column


def uncertainty(scene: Scene) -> Uncertainty:
    """Sample the uncertain keys of a scene that has a table ``uncertainty``, as ``peel uncertainty`` does.

    Parameters
    ----------
    scene : Scene
        Says in its table ``uncertainty`` which keys have which distributions.

    Returns
    -------
    Uncertainty
        Mean, quantiles and sensitivity indices in its `summary()`.

    Warns
    -----
    ComputationWarning
        Where samples stopped short.

    Raises
    ------
    SceneError
        Where the scene does not say what is uncertain.
    """
    native = _native.uncertainty(scene._native.with_law())
    if native.short is not None:
        samples = native.short.splitlines()[0]
        warnings.warn(f"{samples} stopped short; `summary()` says why", ComputationWarning, stacklevel=2)
    return Uncertainty(native, Uncertainty._read(native))

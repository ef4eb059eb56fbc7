"""Derivatives of results by the numbers of a scene."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

from . import _native
from .errors import ComputationWarning

__all__ = ["Sensitivity"]


@dataclass(frozen=True, slots=True)
class Sensitivity:
    """By which power of a parameter a result changes.

    Attributes
    ----------
    of : str
        The result, ``"peak.force_nN"``.
    key : str
        The parameter, ``"strip.height"``.
    value, error : float
        d ln Q/d ln p and the bound on its error.
    """

    of: str
    key: str
    value: float
    error: float


def of_peel(peel: _native.Peel) -> list[Sensitivity]:
    """All that could be computed; of the others a warning says why not."""
    found, refused = _native.sensitivities(peel)
    for key, why in refused:
        warnings.warn(f"no sensitivities by `{key}`: {why}", ComputationWarning, stacklevel=4)
    return [Sensitivity(*one) for one in found]

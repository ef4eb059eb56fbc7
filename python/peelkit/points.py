"""What was located on a path."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

__all__ = ["LimitPoint", "Peak", "Plateau", "Station"]


@dataclass(frozen=True, slots=True)
class Peak:
    """A largest force: a limit point of the path, located.

    Attributes
    ----------
    force, force_error : float
        P and the bound on its error, nN.
    displacement, displacement_error : float
        u of the grip and the bound on its error, nm.
    end_rotation : float
        θ(L), rad.
    """

    force: float
    displacement: float
    end_rotation: float
    force_error: float
    displacement_error: float

    @property
    def error(self) -> float:
        """Bound on the error of the force, nN."""
        return self.force_error

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> Peak:
        """From an object of ``summary.json``."""
        return cls(
            found["force_nN"],
            found["displacement_nm"],
            found["end_rotation_rad"],
            found["error_nN"],
            found["error_nm"],
        )


@dataclass(frozen=True, slots=True)
class Plateau:
    """The steady force, at which the front advances and nothing else changes.

    Attributes
    ----------
    force, force_error : float
        P and the bound on its error, nN; None where there is no bound.
    displacement, displacement_error : float
        u and how far from there the force changes as little, nm; None likewise.
    stable : bool
        Whether the beam is stable under displacement control there.
    """

    force: float
    displacement: float
    force_error: float | None
    displacement_error: float | None
    stable: bool

    @property
    def error(self) -> float | None:
        """Bound on the error of the force, nN."""
        return self.force_error

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> Plateau:
        """From an object of ``summary.json``."""
        return cls(
            found["force_nN"],
            found["displacement_nm"],
            found["error_nN"],
            found["error_nm"],
            found["stable"],
        )


@dataclass(frozen=True, slots=True)
class LimitPoint:
    """A turning point of the path, located.

    Attributes
    ----------
    kind : str
        ``"displacement"`` where u turns, ``"load"`` where P does.
    displacement, displacement_error : float
        u of the grip and the bound on its error, nm.
    force, force_error : float
        P and the bound on its error, nN.
    work, work_error : float
        ∫ P du from where the path begins and the bound on its error, aJ; no bound is None.
    end_rotation : float or None
        θ(L), rad; None of a jump, whose kind is displacement.
    flat : bool
        Whether the force is so level around it that its place cannot be determined and does not matter.
    """

    kind: str
    displacement: float
    force: float
    work: float
    displacement_error: float
    force_error: float
    work_error: float | None
    end_rotation: float | None = None
    flat: bool = False

    @property
    def error(self) -> float:
        """Bound on the error of the force, nN."""
        return self.force_error

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> LimitPoint:
        """From an object of ``summary.json``."""
        return cls(
            found.get("kind", "displacement"),
            found["displacement_nm"],
            found["force_nN"],
            found["work_aJ"],
            found["error_nm"],
            found["error_nN"],
            found["error_aJ"],
            found.get("end_rotation_rad"),
            found.get("flat", False),
        )


@dataclass(frozen=True, slots=True)
class Station:
    """An equilibrium of the path at which a quantity has exactly the value that was asked for.

    Attributes
    ----------
    displacement, displacement_error : float
        u of the grip and the bound on its error, nm.
    force, force_error : float
        P and the bound on its error, nN.
    end_rotation, end_rotation_error : float
        θ(L) and the bound on its error, rad.
    front, front_error : float
        The length that still adheres and the bound on its error, nm.
    work : float
        ∫ P du from where the path begins, aJ.
    stable : bool
        Whether the beam is stable under displacement control there.
    free_end_gap, free_end_gap_error : float
        Distance of the free end's nearer edge from the ground and the bound on its error, nm.

    A bound is None where there is none: with friction, where a term of the model was left out, and next to a limit
    point that a finer mesh has elsewhere.
    """

    displacement: float
    force: float
    end_rotation: float
    front: float
    work: float
    stable: bool
    displacement_error: float | None
    force_error: float | None
    end_rotation_error: float | None
    front_error: float | None
    free_end_gap: float
    free_end_gap_error: float | None

    @property
    def error(self) -> float | None:
        """Bound on the error of the force, nN."""
        return self.force_error

    @classmethod
    def of(cls, found: Mapping[str, Any]) -> Station:
        """From an object of ``summary.json``."""
        return cls(
            found["displacement_nm"],
            found["force_nN"],
            found["end_rotation_rad"],
            found["front_nm"],
            found["work_aJ"],
            found["negative_eigenvalues"] == 0,
            found["error_nm"],
            found["error_nN"],
            found["error_rad"],
            found["error_front_nm"],
            found["free_end_gap_nm"],
            found["error_gap_nm"],
        )

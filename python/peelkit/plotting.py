"""Pictures with matplotlib, which has to be installed: ``pip install peelkit[plot]``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .curve import Columns
    from .observed import Test
    from .peel import Peel

__all__ = ["curve", "pull", "test"]

# intervals between two path points
_INTERVALS = 8


def _axes(ax: Axes | None) -> Axes:
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.gca()
    return ax


def test(test: Test, ax: Axes | None, style: dict[str, Any]) -> Axes:
    """The force against the displacement of the machine."""
    ax = _axes(ax)
    style = dict(style)
    for branch, dash in [("retreat", "-"), ("approach", ":")]:
        on = test.branch == branch
        (line,) = ax.plot(test.machine_displacement[on], test.force[on], **{"linestyle": dash, **style})
        style = {**style, "color": line.get_color(), "label": "_nolegend_"}
    ax.set_xlabel("displacement of the machine (nm)")
    ax.set_ylabel("force P (nN)")
    return ax


def pull(columns: Columns, ax: Axes | None, style: dict[str, Any]) -> Axes:
    """The force against how far the root, or what pulls, has come."""
    ax = _axes(ax)
    if "lift" in columns:
        ax.plot(columns["lift"], columns["load"], **style)
        ax.set_xlabel("lift (nm; of a moment rad)")
        ax.set_ylabel("load (nN; of a moment nN nm)")
        return ax
    ax.plot(columns["travel"] if "travel" in columns else columns["displacement"], columns["force"], **style)
    ax.set_xlabel("displacement (nm)")
    ax.set_ylabel("force P (nN)")
    return ax


def curve(peel: Peel, ax: Axes | None, style: dict[str, Any]) -> Axes:
    """The force against the displacement, stable parts solid and unstable ones dashed."""
    ax = _axes(ax)
    displacement, force, negative = peel._native.dense_curve(_INTERVALS)
    u, p = np.frombuffer(displacement), np.frombuffer(force)
    unstable = np.frombuffer(negative, dtype=np.int64) > 0
    ax.set_xlabel("displacement u (nm)")
    ax.set_ylabel("force P (nN)")
    if not len(u):
        return ax
    # a part ends at the point where the next one begins
    ends = np.flatnonzero(np.diff(unstable)) + 1
    begins = np.concatenate(([0], ends))
    style = dict(style)
    for begin, end in zip(begins, np.concatenate((ends + 1, [len(u)]))):
        dash = "--" if unstable[begin] else "-"
        (line,) = ax.plot(u[begin:end], p[begin:end], **{"linestyle": dash, **style})
        # one colour and one entry of the legend
        style = {**style, "color": line.get_color(), "label": "_nolegend_"}
    return ax

"""Sweeps over any number of keys, on the cores of a machine or on a cluster."""

from .run import read_sweep, sweep

__all__ = ["read_sweep", "sweep"]

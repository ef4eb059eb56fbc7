#!/usr/bin/env python3
"""The scenes of scenes/hard: initiation peak and the first two displacement limit points. Writes hard_scenes.csv."""
import tomllib
from pathlib import Path as File

from collocation.suite import Suite, run  # first: one thread
from collocation.law import Strip
from collocation.path import TURNS, Path as Equilibria

REMARKS = (
    "The strips of scenes/hard, computed without finite elements by verification/hard_scenes.py. As in strip_variants.csv; good to the digits printed.",
    "Empty: there is no such point, or the collocation did not reach it on two levels of discretisation, or it was not asked for (PEAK_ONLY).",
)
# the collocation finds nothing that its levels agree on
LOST = ("hamaker-1e3", "toe")
# scenes whose whole paths take the collocation more than ten minutes
PEAK_ONLY = ("guided", "incompressible", "inextensible", "long", "r0-small", "unshearable")
FOLDER = File(__file__).parent.parent / "scenes" / "hard"
UNITS = {"nm": 1.0, "um": 1e3, "mm": 1e6, "cm": 1e7, "GPa": 1.0, "MPa": 1e-3, "J": 1.0}
NAMES = {"length": "length", "height": "height", "width": "width", "youngs_modulus": "young", "poissons_ratio": "poisson",
         "shear_correction": "shear_correction", "bending_stiffness_factor": "factor", "hamaker_constant": "hamaker",
         "equilibrium_distance": "r0", "line_load": "line_load", "far_face": "far_face", "rotation": "rotation",
         "horizontal": "horizontal"}
COLUMNS = ("length_nm", "height_nm", "width_nm", "youngs_modulus_GPa", "poissons_ratio", "shear_correction", "bending_stiffness_factor",
           "hamaker_constant_J", "equilibrium_distance_nm", "grip_rotation", "grip_horizontal",
           "peak_displacement_nm", "peak_force_nN", "lp1_displacement_nm", "lp1_force_nN", "lp2_displacement_nm", "lp2_force_nN")


def value(text):
    """A number in nm, GPa or J; other words as they are."""
    if not isinstance(text, str) or " " not in text:
        return text
    number, unit = text.split()
    return float(number) * UNITS[unit]


def strip(file):
    scene = tomllib.loads(file.read_text())
    keys = {key: text for table in ("strip", "adhesion", "grip") for key, text in scene.get(table, {}).items()}
    return Strip(**{NAMES[key]: value(text) for key, text in keys.items()})


def compute(strip, level, verbose):
    path = Equilibria(strip, verbose=verbose, **dict(level, want=("peak",) if strip in SHORT else TURNS))
    found = {kind: path.found.get(kind) for kind in TURNS}
    number = {"displacement_nm": path.s.u, "force_nN": path.s.P}
    return {f"{kind}_{what}": at and get(at) for kind, at in found.items() for what, get in number.items()}


if __name__ == "__main__":
    files = sorted(file for file in FOLDER.glob("*.toml") if file.stem not in LOST)
    SHORT = [strip(FOLDER / f"{name}.toml") for name in PEAK_ONLY]
    quick = [strip(FOLDER / f"{name}.toml") for name in ("bending-1e6", "long", "on-edge")]
    run(__doc__, Suite("hard_scenes.csv", REMARKS, [strip(file) for file in files], COLUMNS, compute, quick=quick))

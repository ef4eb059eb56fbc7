"""Beams whose section and rest curve vary along S: the spatula, and profiles given by a table or by pieces.

The rest curve has the slope theta0 = angle + atan(h'/2), angle that of the underside; y0' = sin theta0, and the tip's axis lies at
the flat equilibrium height. With the roundness q from rectangle (0) to circle (1) the area is b h [1 + (pi/4 - 1) q], the second
moment (b h^3/12) [1 + (12 pi/64 - 1) q]; the adhering width is b.
"""
import csv
import math
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path

import numpy as np
from scipy.interpolate import PchipInterpolator

from .law import Beam, rest_gap

PROFILES = Path(__file__).parent.parent / "profiles"
PANELS, DEGREE = 200, 20                                              # of the quadrature of y0


@dataclass(frozen=True)
class Section:
    """What the law and the strong form want of a beam at places S: numbers or arrays."""
    beam: Beam
    height: float
    rise: float                          # dh/dS
    width: float
    EA: float
    GA: float
    EI: float
    bend: float                          # d theta0/dS

    def __getattr__(self, name):
        return getattr(self.beam, name)


@dataclass(frozen=True)
class Form:
    """The shape at places S; angles in radians."""
    width: float
    height: float
    rise: float                          # dh/dS
    curl: float                          # d2h/dS2
    angle: float                         # of the underside
    turn: float                          # d angle/dS
    roundness: float

    @property
    def slope(self):
        return self.angle + np.arctan(0.5 * self.rise)

    @property
    def bend(self):
        return self.turn + 0.5 * self.curl / (1.0 + 0.25 * self.rise ** 2)


@dataclass(frozen=True, kw_only=True)
class Shape(Beam):
    """A beam with a form(S) of its own between its ends."""

    def __str__(self):
        """What differs from the paper's material and the first choice of a shape."""
        own = ((f, getattr(self, f.name)) for f in fields(self))
        return " ".join(f"{f.name}={value}" for f, value in own if value != f.default).replace(".0 ", " ").removesuffix(".0") or "default"

    case = property(__str__)

    def at(self, S):
        form = self.form(S)
        area = form.width * form.height * (1.0 + (math.pi / 4.0 - 1.0) * form.roundness)
        second = form.width * form.height ** 3 / 12.0 * (1.0 + (12.0 * math.pi / 64.0 - 1.0) * form.roundness)
        return Section(self, form.height, form.rise, form.width, self.young * area, self.shear_modulus * area, self.young * second,
                       form.bend)

    def free(self, S):
        """Gap and slope free of stress at the places S."""
        edges = np.unique(np.concatenate([S, self.ends, np.linspace(0.0, self.length, PANELS + 1)]))
        x, w = np.polynomial.legendre.leggauss(DEGREE)
        inner = edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (x + 1.0)
        rises = 0.5 * np.diff(edges) * (np.sin(self.form(inner).slope) @ w)
        y = self.tip_height + np.append(0.0, np.cumsum(rises))
        form = self.form(S)
        return y[np.searchsorted(edges, S)] - 0.5 * form.height, form.slope

    @cached_property
    def tip_height(self):
        """Of the axis at S = 0: the flat section there is in equilibrium."""
        tip = self.at(0.0)
        return rest_gap(tip) + 0.5 * float(tip.height)

    @cached_property
    def end_rotation(self):
        return float(self.form(self.length).slope)


def step(t):
    """s5(t) = t^3 (10 - 15 t + 6 t^2) on [0, 1], level outside, with its first two derivatives."""
    t = np.clip(t, 0.0, 1.0)
    return t ** 3 * (10.0 - 15.0 * t + 6.0 * t * t), 30.0 * (t * (1.0 - t)) ** 2, 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t)


@dataclass(frozen=True, kw_only=True)
class Spatula(Shape):
    """A flat pad whose neck turns up into a round shaft. S = 0 is the tip; lengths in nm, angles in degrees."""
    rotation: str = "fixed"
    pad_length: float = 240.0
    neck_length: float = 150.0
    shaft_length: float = 600.0
    bend_length: float = 50.0
    tip_width: float = 200.0
    neck_width: float = 50.0
    shaft_diameter: float = 50.0
    pad_thickness: float = 10.0
    shaft_angle: float = 45.0
    tip_rounding_length: float = 0.0
    tip_rounding_width: float = 100.0

    @property
    def length(self):
        return self.pad_length + self.neck_length + self.shaft_length

    @cached_property
    def ends(self):
        """Of the pieces on which every formula is one polynomial."""
        pad = self.pad_length
        return tuple(sorted({0.0, self.tip_rounding_length, pad, pad + self.bend_length, pad + self.neck_length, self.length}))

    def form(self, S):
        q, q1, q2 = step((S - self.pad_length) / self.neck_length)
        turned, turned1, _ = step((S - self.pad_length) / self.bend_length)
        thicker, upright = self.shaft_diameter - self.pad_thickness, math.radians(self.shaft_angle)
        width = self.tip_width + (self.neck_width - self.tip_width) * np.minimum(S / self.pad_length, 1.0)
        width = self.rounding(S) * (width + (self.shaft_diameter - self.neck_width) * q)
        return Form(width, self.pad_thickness + thicker * q, thicker * q1 / self.neck_length, thicker * q2 / self.neck_length ** 2,
                    upright * turned, upright * turned1 / self.bend_length, q)

    def rounding(self, S):
        """What is left of the width towards a rounded tip."""
        if self.tip_rounding_length == 0.0:
            return 1.0
        w = self.tip_rounding_width / self.tip_width
        t = np.minimum(S / self.tip_rounding_length, 1.0)
        return w + (1.0 - w) * (1.0 - (1.0 - t) ** 4)


@dataclass(frozen=True, kw_only=True)
class Profile(Shape):
    """A beam given at knots by profiles/NAME.csv, monotone cubics (PCHIP) between them."""
    name: str

    @cached_property
    def columns(self):
        with open(PROFILES / f"{self.name}.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return {key: np.array([float(row[key]) for row in rows]) for key in rows[0]}

    @property
    def ends(self):
        return tuple(float(s) for s in self.columns["s_nm"])

    @property
    def length(self):
        return self.ends[-1]

    @cached_property
    def curves(self):
        c = self.columns
        s = c["s_nm"]
        return [PchipInterpolator(s, y) for y in (c["height_nm"], c["width_nm"], np.radians(c["angle_deg"]), c["roundness"])]

    def form(self, S):
        height, width, angle, roundness = self.curves
        return Form(width(S), height(S), height(S, 1), height(S, 2), angle(S), angle(S, 1), roundness(S))


@dataclass(frozen=True, kw_only=True)
class Pieces(Shape):
    """A beam given piece by piece, from the tip on, by profiles/NAME.csv: a row a piece.

    Along a piece width, roundness and the angle of the underside go from their first value to their last with t = (S - beginning)/length, or
    with s5(t) where the course is smooth, and so does the height with the course of its own. The angle begins with 0.
    """
    name: str

    @cached_property
    def columns(self):
        with open(PROFILES / f"{self.name}.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        words = ("course", "height_course")
        return {key: np.array([row[key] == "smooth" if key in words else float(row[key]) for row in rows]) for key in rows[0]}

    @cached_property
    def ends(self):
        return (0.0, *(float(s) for s in np.cumsum(self.columns["length_nm"])))

    @property
    def length(self):
        return self.ends[-1]

    def form(self, S):
        c = self.columns
        i = np.clip(np.searchsorted(self.ends, S, side="right") - 1, 0, len(c["length_nm"]) - 1)
        length, turns = c["length_nm"][i], np.radians(c["bend_deg"])
        t = (S - np.array(self.ends)[i]) / length
        gone, lifted = (np.where(c[course][i], step(t), (t, np.ones_like(t), np.zeros_like(t))) for course in ("course", "height_course"))
        width, height, roundness = ((c[name][i], (c[name.replace("_nm", "") + "_end" + "_nm" * name.endswith("_nm")] - c[name])[i])
                                    for name in ("width_nm", "height_nm", "roundness"))
        return Form(width[0] + width[1] * gone[0], height[0] + height[1] * lifted[0], height[1] * lifted[1] / length,
                    height[1] * lifted[2] / length ** 2, (np.cumsum(turns) - turns)[i] + turns[i] * gone[0], turns[i] * gone[1] / length,
                    roundness[0] + roundness[1] * gone[0])

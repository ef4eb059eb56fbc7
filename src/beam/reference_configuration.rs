//! The stress-free configuration of a beam.

use super::varying::Varying;
use crate::number::gauss::Rule;
use serde::{Deserialize, Serialize};
use std::num::NonZeroUsize;
use std::sync::LazyLock;

/// The stress-free configuration of a beam.
#[derive(Clone, Debug)]
pub enum ReferenceConfiguration {
    /// Along a curve of its own; what is called y is that of the axis or of a gap below it, as the density has it.
    Curve(ReferenceCurve),
    /// As its outline says; y is the gap below its underside.
    Varying(Box<VaryingReference>),
}

impl ReferenceConfiguration {
    /// x0, y0 and θ0 at S.
    pub fn at(&self, place: f64) -> [f64; 3] {
        match self {
            Self::Curve(curve) => curve.at(place),
            Self::Varying(rest) => rest.at(place),
        }
    }
}

/// The axis at rest: it starts at a place in a direction and bends as its curvature says. The sections stand square to it.
///
/// θ0(S) = θ0(0) + k0 S + k1 S²/2 + k2 S³/3 with the curvature κ0(S) = k0 + k1 S + k2 S²; x0' = cos θ0, y0' = sin θ0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ReferenceCurve {
    /// x0, y0 in nm and θ0 in rad at S = 0.
    pub start: [f64; 3],
    /// k0, k1, k2: 1/nm, 1/nm², 1/nm³.
    pub curvature: [f64; 3],
}

/// Eight points integrate a piece of [`PIECE`] radians to round-off.
static RULE: LazyLock<Rule> = LazyLock::new(|| Rule::new(const { NonZeroUsize::new(8).expect("eight is not zero") }));

/// Largest turn of a piece that is integrated at once, rad.
const PIECE: f64 = 0.5;

impl ReferenceCurve {
    /// A straight line from `(x, y)` in the direction `rotation`.
    pub fn straight(x: f64, y: f64, rotation: f64) -> Self {
        Self { start: [x, y, rotation], curvature: [0.0; 3] }
    }

    /// An arc of a circle from the origin in the direction `rotation`; a positive `curvature` turns it to the left.
    pub fn arc(rotation: f64, curvature: f64) -> Self {
        Self { start: [0.0, 0.0, rotation], curvature: [curvature, 0.0, 0.0] }
    }

    /// κ0 at S, 1/nm.
    pub(crate) fn curvature_at(&self, place: f64) -> f64 {
        let [k0, k1, k2] = self.curvature;
        k0 + place * (k1 + place * k2)
    }

    /// θ0 at S, rad.
    pub(crate) fn rotation_at(&self, place: f64) -> f64 {
        let [k0, k1, k2] = self.curvature;
        self.start[2] + place * (k0 + place * (k1 / 2.0 + place * k2 / 3.0))
    }

    /// x0, y0 and θ0 at S.
    pub fn at(&self, place: f64) -> [f64; 3] {
        let [x, y, rotation] = self.start;
        let [k0, k1, k2] = self.curvature;
        if k1 == 0.0 && k2 == 0.0 {
            // the chord of an arc, which for k0 = 0 is the straight line without round-off
            let half = 0.5 * k0 * place;
            let chord = if half == 0.0 { place } else { place * half.sin() / half };
            let (sin, cos) = (rotation + half).sin_cos();
            return [x + chord * cos, y + chord * sin, self.rotation_at(place)];
        }
        let turn = place.abs() * (k0.abs() + place.abs() * (k1.abs() + place.abs() * k2.abs()));
        let pieces = (turn / PIECE).ceil().clamp(1.0, 1e4) as usize;
        let step = place / pieces as f64;
        let (mut along, mut up) = (x, y);
        for piece in 0..pieces {
            for (point, weight) in RULE.over(0.0, 1.0) {
                let (sin, cos) = self.rotation_at((piece as f64 + point) * step).sin_cos();
                along += step * weight * cos;
                up += step * weight * sin;
            }
        }
        [along, up, self.rotation_at(place)]
    }
}

/// Panels of a beam of varying outline over which its direction is integrated: so many in all, and in each piece of the outline
/// at least so many.
const PANELS: f64 = 128.0;
const PANELS_A_PIECE: usize = 8;

/// The stress-free configuration of a beam of varying outline: x0' = cos θ0, y0' = sin θ0.
#[derive(Clone, Debug)]
pub struct VaryingReference {
    beam: Varying,
    /// S, x0 and y0 of the axis at the ends of the panels.
    knots: Vec<[f64; 3]>,
}

impl VaryingReference {
    /// Of a beam whose underside is `gap` above the substrate at S = 0, nm.
    pub fn new(beam: Varying, gap: f64) -> Self {
        let length = beam.contour().length();
        let mut ends = beam.contour().breaks();
        ends.push(length);
        let mut knots = vec![[0.0, 0.0, gap + 0.5 * beam.contour().at(0.0).height[0]]];
        let mut rest = Self { beam, knots: Vec::new() };
        let mut from = 0.0;
        for to in ends {
            let panels = ((to - from) / length * PANELS).ceil().max(PANELS_A_PIECE as f64);
            for panel in 1..=panels as usize {
                let last = knots[knots.len() - 1];
                knots.push(rest.beyond(last, from + (to - from) * panel as f64 / panels));
            }
            from = to;
        }
        rest.knots = knots;
        rest
    }

    /// S, x0 and y0 of the axis at a place not far from one that is known.
    fn beyond(&self, [place, x, y]: [f64; 3], to: f64) -> [f64; 3] {
        let step = to - place;
        let (mut along, mut up) = (x, y);
        for (point, weight) in RULE.over(0.0, 1.0) {
            let (sin, cos) = self.beam.rotation(place + point * step).sin_cos();
            along += step * weight * cos;
            up += step * weight * sin;
        }
        [to, along, up]
    }

    /// x0, the gap below the underside, and θ0 at S.
    pub fn at(&self, place: f64) -> [f64; 3] {
        let before = self.knots.partition_point(|knot| knot[0] < place).saturating_sub(1);
        let known = self.knots.get(before + 1).filter(|knot| knot[0] == place);
        let [_, x, y] = known.copied().unwrap_or_else(|| self.beyond(self.knots[before], place));
        [x, y - 0.5 * self.height(place), self.beam.rotation(place)]
    }

    /// Height of the section at S, nm.
    pub fn height(&self, place: f64) -> f64 {
        self.beam.contour().at(place).height[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    #[test]
    fn a_line_is_exact_and_an_arc_is_a_circle() {
        assert_eq!(ReferenceCurve::straight(0.0, 0.3, 0.0).at(7.1), [7.1, 0.3, 0.0]);
        let (radius, turn) = (50.0, 4.0f64);
        let [x, y, rotation] = ReferenceCurve::arc(0.0, 1.0 / radius).at(radius * turn);
        assert_abs_diff_eq!(x, radius * turn.sin(), epsilon = 1e-12);
        assert_abs_diff_eq!(y, radius * (1.0 - turn.cos()), epsilon = 1e-12);
        assert_abs_diff_eq!(rotation, turn, epsilon = 1e-14);
    }

    /// Fresnel's integrals C(1.5) and S(1.5), from tables: κ0 = π S, θ0 = π S²/2.
    #[test]
    fn a_linear_curvature_is_a_clothoid() {
        let clothoid = ReferenceCurve { start: [0.0; 3], curvature: [0.0, std::f64::consts::PI, 0.0] };
        let [x, y, _] = clothoid.at(1.5);
        assert_abs_diff_eq!(x, 0.445_261_176_039_822, epsilon = 1e-13);
        assert_abs_diff_eq!(y, 0.697_504_960_082_093, epsilon = 1e-13);
    }

    /// The quadrature and the chord of an arc agree.
    #[test]
    fn quadrature_of_an_arc_is_the_arc() {
        let arc = ReferenceCurve::arc(0.3, 0.02);
        let nearly = ReferenceCurve { curvature: [0.02, 0.0, 1e-300], ..arc };
        for (a, b) in arc.at(200.0).iter().zip(nearly.at(200.0)) {
            assert_abs_diff_eq!(*a, b, epsilon = 1e-11);
        }
    }
}

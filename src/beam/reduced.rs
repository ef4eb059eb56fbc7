//! Reissner's planar beam with x' minimised out: two unknowns a node, the gap and the rotation.
//!
//! On a flat substrate without friction nothing acts along x, so the horizontal section force H is one number for the
//! whole chain: zero where the grip is free to slide, the multiplier of x(L) - x(0) = L where it is held. Minimising
//! ½EA Γ1² + ½GA_s Γ2² - H x' over x' leaves, with B = cos²θ/EA + sin²θ/GA_s, C = sin²θ/EA + cos²θ/GA_s,
//! D = sin θ cos θ (1/EA - 1/GA_s) and V = (y' - sin θ - H D)/C,
//!
//!   φ(y', θ; H) = ½ C V² - ½ B H² - H cos θ,   ∂φ/∂H = -x' = -(cos θ + H B + V D),
//!
//! to which ½EI θ'² and the adhesion bΨ(y, θ) are added. Nothing is neglected.

use super::{Coupling, Density, PointResponse, Section, SectionState};
use crate::adhesion::LineLaw;
use crate::number::Real;

/// The two-field form of the planar Reissner beam on a flat half space. Fields: gap η = y - h/2 (nm), rotation θ.
/// The border is H where `HELD`, and counts nothing otherwise.
#[derive(Clone, Copy, Debug)]
pub struct ReducedBeam<const HELD: bool> {
    pub section: Section,
    pub law: LineLaw,
    /// Adhering width b, nm
    pub width: f64,
}

/// B, C and D of the module's head at one rotation.
struct Compliance<T> {
    along: T,
    across: T,
    mixed: T,
}

impl<const HELD: bool> ReducedBeam<HELD> {
    #[inline(always)]
    fn compliance<T: Real>(&self, sin: T, cos: T) -> Compliance<T> {
        let (axial, shear) = (1.0 / self.section.axial, 1.0 / self.section.shear);
        Compliance {
            along: cos * cos * axial + sin * sin * shear,
            across: sin * sin * axial + cos * cos * shear,
            mixed: sin * cos * (axial - shear),
        }
    }

    #[inline(always)]
    fn state(&self, sin: f64, cos: f64, vertical_force: f64, moment: f64, border: f64) -> SectionState {
        let h = if HELD { border } else { 0.0 };
        let c = self.compliance(sin, cos);
        let v = vertical_force;
        SectionState {
            horizontal_slope: cos + h * c.along + v * c.mixed,
            vertical_slope: sin + v * c.across + h * c.mixed,
            horizontal_force: h,
            vertical_force: v,
            moment,
            curvature: moment / self.section.bending,
            stored: 0.5 * (c.along * h * h + 2.0 * c.mixed * h * v + c.across * v * v)
                + 0.5 * moment * moment / self.section.bending,
        }
    }
}

impl<const HELD: bool> Density<2> for ReducedBeam<HELD> {
    const COUPLING: Coupling<2> = Coupling {
        value_value: [[true; 2]; 2],
        value_slope: [[false, false], [true, false]],
        slope_slope: [[true, false], [false, true]],
    };
    const BORDER: bool = HELD;

    #[inline(always)]
    fn response<T: Real>(
        &self,
        _: T,
        [gap, rotation]: [T; 2],
        [rise, curvature]: [T; 2],
        border: f64,
    ) -> PointResponse<T, 2> {
        let (sin, cos) = rotation.sin_cos();
        let adhesion = self.law.response(gap, sin, cos);
        let b = self.width;
        let ei = self.section.bending;
        // g sin 2θ and g cos 2θ with g = 1/GA_s - 1/EA: C' = -g sin 2θ, D' = -g cos 2θ
        let g = 1.0 / self.section.shear - 1.0 / self.section.axial;
        let (g_sin, g_cos) = (sin * cos * (2.0 * g), (cos - sin) * (cos + sin) * g);
        let c = self.compliance(sin, cos);
        let inverse = c.across.recip();
        let mut response = PointResponse::zero();

        let h = if HELD { border } else { 0.0 };
        let v = if HELD { (rise - sin - c.mixed * h) * inverse } else { (rise - sin) * inverse };
        // what cos θ becomes under the horizontal force
        let lever = if HELD { cos - g_cos * h } else { cos };
        let v_t = (g_sin * v - lever) * inverse;
        let mut by_rotation = g_sin * v * v * 0.5 - v * lever;
        let mut by_rotation2 = g_cos * v * v + v * sin;
        let mut energy = c.across * v * v * 0.5;
        if HELD {
            by_rotation = by_rotation + sin * h - g_sin * (0.5 * h * h);
            by_rotation2 = by_rotation2 + cos * h - g_cos * (h * h) - v * g_sin * (2.0 * h);
            energy = energy - c.along * (0.5 * h * h) - cos * h;
            let v_h = -c.mixed * inverse;
            response.by_border = -(cos + c.along * h + v * c.mixed);
            response.border_border = -(c.along + v_h * c.mixed);
            response.border_slope[0] = v_h;
            response.border_value[1] = sin - g_sin * h - v_t * c.mixed + v * g_cos;
        }
        response.energy = energy + curvature * curvature * (0.5 * ei) + adhesion.energy * b;
        response.adhesion = adhesion.energy * b;
        response.by_value = [adhesion.by_gap * b, by_rotation + adhesion.by_rotation * b];
        response.by_slope = [v, curvature * ei];
        response.value_value = [
            [adhesion.gap_gap * b, adhesion.gap_rotation * b],
            [adhesion.rotation_gap * b, by_rotation2 + v_t * v_t * c.across + adhesion.rotation_rotation * b],
        ];
        response.value_slope[1][0] = v_t;
        response.slope_value[0][1] = v_t;
        response.slope_slope[0][0] = inverse;
        response.slope_slope[1][1] = T::splat(ei);
        response.adhesion_by_value = [adhesion.by_gap * b, adhesion.energy_by_rotation * b];
        response
    }

    fn is_symmetric(&self) -> bool {
        self.law.has_potential()
    }

    fn section_state(&self, _: f64, [_, rotation]: [f64; 2], [rise, curvature]: [f64; 2], border: f64) -> SectionState {
        let (sin, cos) = rotation.sin_cos();
        let c = self.compliance(sin, cos);
        let h = if HELD { border } else { 0.0 };
        let v = (rise - sin - h * c.mixed) / c.across;
        self.state(sin, cos, v, self.section.bending * curvature, border)
    }

    fn section_state_from_forces(
        &self,
        _: f64,
        [_, rotation]: [f64; 2],
        [v, moment]: [f64; 2],
        border: f64,
    ) -> SectionState {
        let (sin, cos) = rotation.sin_cos();
        self.state(sin, cos, v, moment, border)
    }
}

//! Reissner's geometrically exact planar beam, three unknowns a node: x, gap, rotation.
//!
//! Γ1 = x' cos θ + y' sin θ - 1, Γ2 = -x' sin θ + y' cos θ, κ = θ'; stored energy ½EA Γ1² + ½GA_s Γ2² + ½EI κ² per
//! length, and the adhesion bΨ(y, θ).

use super::{Density, PointResponse, Section, SectionState};
use crate::adhesion::LineLaw;
use crate::number::Real;

/// The three-field form of the planar Reissner beam on a flat half space. Fields: x (nm), gap η = y - h/2 (nm), rotation
/// θ. It has no border.
#[derive(Clone, Copy, Debug)]
pub struct ReissnerBeam {
    pub section: Section,
    pub law: LineLaw,
    /// Adhering width b, nm
    pub width: f64,
}

impl Density<3> for ReissnerBeam {
    #[inline(always)]
    fn response<T: Real>(
        &self,
        [_, gap, rotation]: [T; 3],
        [dx, dy, curvature]: [T; 3],
        _: f64,
    ) -> PointResponse<T, 3> {
        let (sin, cos) = rotation.sin_cos();
        let adhesion = self.law.response(gap, sin, cos);
        let b = self.width;
        let Section { axial, shear, bending } = self.section;
        let (stretch, slide) = (dx * cos + dy * sin - 1.0, dy * cos - dx * sin);
        let (n, q) = (stretch * axial, slide * shear);
        // ∂Γ1/∂θ = Γ2 and ∂Γ2/∂θ = -(1 + Γ1)
        let (stretch_t, slide_t) = (slide, -(stretch + 1.0));
        let (horizontal, vertical) = (n * cos - q * sin, n * sin + q * cos);
        let horizontal_t = stretch_t * cos * axial - slide_t * sin * shear - vertical;
        let vertical_t = stretch_t * sin * axial + slide_t * cos * shear + horizontal;
        let rotation_rotation = stretch_t * stretch_t * axial + slide_t * slide_t * shear + n * slide_t - q * stretch_t;

        let mut response = PointResponse::zero();
        response.energy = (n * stretch + q * slide + curvature * curvature * bending) * 0.5 + adhesion.energy * b;
        response.adhesion = adhesion.energy * b;
        response.by_value[1] = adhesion.by_gap * b;
        response.by_value[2] = n * stretch_t + q * slide_t + adhesion.by_rotation * b;
        response.by_slope = [horizontal, vertical, curvature * bending];
        response.value_value[1][1] = adhesion.gap_gap * b;
        response.value_value[1][2] = adhesion.gap_rotation * b;
        response.value_value[2][1] = adhesion.rotation_gap * b;
        response.value_value[2][2] = rotation_rotation + adhesion.rotation_rotation * b;
        response.value_slope[2][0] = horizontal_t;
        response.value_slope[2][1] = vertical_t;
        response.slope_value[0][2] = horizontal_t;
        response.slope_value[1][2] = vertical_t;
        let mixed = sin * cos * (axial - shear);
        response.slope_slope[0][0] = cos * cos * axial + sin * sin * shear;
        response.slope_slope[0][1] = mixed;
        response.slope_slope[1][0] = mixed;
        response.slope_slope[1][1] = sin * sin * axial + cos * cos * shear;
        response.slope_slope[2][2] = T::splat(bending);
        response.adhesion_by_value[1] = adhesion.by_gap * b;
        response.adhesion_by_value[2] = adhesion.energy_by_rotation * b;
        response
    }

    fn section_state(&self, [_, _, rotation]: [f64; 3], [dx, dy, curvature]: [f64; 3], _: f64) -> SectionState {
        let (sin, cos) = rotation.sin_cos();
        let Section { axial, shear, bending } = self.section;
        let (n, q) = (axial * (dx * cos + dy * sin - 1.0), shear * (dy * cos - dx * sin));
        SectionState {
            horizontal_slope: dx,
            vertical_slope: dy,
            horizontal_force: n * cos - q * sin,
            vertical_force: n * sin + q * cos,
            moment: bending * curvature,
            curvature,
            stored: 0.5 * (n * n / axial + q * q / shear + bending * curvature * curvature),
        }
    }

    fn section_state_from_forces(
        &self,
        [_, _, rotation]: [f64; 3],
        [horizontal, vertical, moment]: [f64; 3],
        _: f64,
    ) -> SectionState {
        let (sin, cos) = rotation.sin_cos();
        let Section { axial, shear, bending } = self.section;
        let (n, q) = (horizontal * cos + vertical * sin, vertical * cos - horizontal * sin);
        let (stretch, slide) = (n / axial, q / shear);
        SectionState {
            horizontal_slope: (1.0 + stretch) * cos - slide * sin,
            vertical_slope: (1.0 + stretch) * sin + slide * cos,
            horizontal_force: horizontal,
            vertical_force: vertical,
            moment,
            curvature: moment / bending,
            stored: 0.5 * (n * stretch + q * slide + moment * moment / bending),
        }
    }
}

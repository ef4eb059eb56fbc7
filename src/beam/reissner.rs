//! Reissner's geometrically exact planar beam, three unknowns a node: x, gap, rotation.
//!
//! Γ1 = x' cos θ + y' sin θ - 1, Γ2 = -x' sin θ + y' cos θ, κ = θ'; stored energy ½EA Γ1² + ½GA_s Γ2² + ½EI κ² per
//! length, and the adhesion bΨ(y, θ).

use super::{Density, PointResponse, Section, SectionState};
use crate::adhesion::LineLaw;

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
    fn response(&self, [_, gap, rotation]: [f64; 3], [dx, dy, curvature]: [f64; 3], _: f64) -> PointResponse<3> {
        let (sin, cos) = rotation.sin_cos();
        let adhesion = self.law.response(gap, sin, cos);
        let b = self.width;
        let Section { axial, shear, bending } = self.section;
        let (stretch, slide) = (dx * cos + dy * sin - 1.0, dy * cos - dx * sin);
        let (n, q) = (axial * stretch, shear * slide);
        // ∂Γ1/∂θ = Γ2 and ∂Γ2/∂θ = -(1 + Γ1)
        let (stretch_t, slide_t) = (slide, -(1.0 + stretch));
        let (horizontal, vertical) = (n * cos - q * sin, n * sin + q * cos);
        let horizontal_t = axial * stretch_t * cos - shear * slide_t * sin - vertical;
        let vertical_t = axial * stretch_t * sin + shear * slide_t * cos + horizontal;
        let rotation_rotation = axial * stretch_t * stretch_t + shear * slide_t * slide_t + n * slide_t - q * stretch_t;

        let mut response = PointResponse::ZERO;
        response.energy = 0.5 * (axial * stretch * stretch + shear * slide * slide + bending * curvature * curvature)
            + b * adhesion.energy;
        response.adhesion = b * adhesion.energy;
        response.by_value = [0.0, b * adhesion.by_gap, n * stretch_t + q * slide_t + b * adhesion.by_rotation];
        response.by_slope = [horizontal, vertical, bending * curvature];
        response.value_value[1] = [0.0, b * adhesion.gap_gap, b * adhesion.gap_rotation];
        response.value_value[2] = [0.0, b * adhesion.rotation_gap, rotation_rotation + b * adhesion.rotation_rotation];
        response.value_slope[2] = [horizontal_t, vertical_t, 0.0];
        response.slope_value[0][2] = horizontal_t;
        response.slope_value[1][2] = vertical_t;
        let mixed = (axial - shear) * sin * cos;
        response.slope_slope = [
            [axial * cos * cos + shear * sin * sin, mixed, 0.0],
            [mixed, axial * sin * sin + shear * cos * cos, 0.0],
            [0.0, 0.0, bending],
        ];
        response.adhesion_by_value = [0.0, b * adhesion.by_gap, b * adhesion.energy_by_rotation];
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

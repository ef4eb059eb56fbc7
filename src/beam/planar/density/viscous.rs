//! A beam of viscous material: what its strains since before a step in time add to its energy.
//!
//! With the strains ε = (Γ1, Γ2, θ') and C = diag(EA, GA_s, EI), a rule that replaces dε/dt by c (ε - ε_k), with a rate c and known strains
//! ε_k from the steps before, makes of a viscous section force τ C dε/dt the derivative of
//!
//!   ½ f (ε - ε_k) · C (ε - ε_k),   f = τ c,
//!
//! an energy of the step. So its tangent is symmetric. The same holds with another factor f for a spring and a dashpot in series.
//! Source: M. Ortiz, L. Stainier, The variational formulation of viscoplastic constitutive updates, Comput. Methods Appl. Mech. Eng. 171 (1999).

use super::reissner::{ReissnerBeam, ReissnerRod, of_axis, stored_from};
use crate::adhesion::section::line_load::RateLaw;
use crate::beam::element::energy_density::{Coupling, EnergyDensity, MEMORY, Point, PointResponse, SectionState};
use crate::beam::material::stretch_law::StretchLaw;
use crate::beam::section::Section;
use crate::number::Real;

/// A density of three fields that knows the elastic stiffness of its sections.
pub(crate) trait ElasticSections: EnergyDensity<3> {
    /// EA, GA_s and EI at S, nm, and h'/2, by how much the axis rises faster than the height field.
    fn stiffness_at<T: Real>(&self, place: T) -> (Section<T>, T);

    /// h and b at S, nm.
    fn outline_at<T: Real>(&self, place: T) -> [T; 2];
}

impl ElasticSections for ReissnerBeam {
    #[inline(always)]
    fn stiffness_at<T: Real>(&self, place: T) -> (Section<T>, T) {
        let station = self.profile.at(place);
        (station.section, station.rise)
    }

    #[inline(always)]
    fn outline_at<T: Real>(&self, place: T) -> [T; 2] {
        let station = self.profile.at(place);
        [station.height, station.width]
    }
}

impl ElasticSections for ReissnerRod {
    #[inline(always)]
    fn stiffness_at<T: Real>(&self, _: T) -> (Section<T>, T) {
        (self.section.splat(), T::splat(0.0))
    }

    #[inline(always)]
    fn outline_at<T: Real>(&self, _: T) -> [T; 2] {
        [T::splat(0.0); 2]
    }
}

/// A density whose material is viscous besides, and whose adhesive may resist its opening. [`Point::memory`] has the known strains and the factor f,
/// the known distance of the face, and c.
#[derive(Clone, Debug)]
pub(crate) struct Viscous<D> {
    /// Without either
    pub density: D,
    /// An adhesive that resists its opening
    pub adhesive: Option<RateLaw>,
}

impl<D> Viscous<D> {
    /// Of a viscous material alone.
    pub(crate) const fn material(density: D) -> Self {
        Self { density, adhesive: None }
    }
}

impl<D: ElasticSections> EnergyDensity<3> for Viscous<D> {
    const COUPLING: Coupling<3> = D::COUPLING;
    const HAS_HISTORY: bool = true;

    fn knots(&self) -> &'static [f64] {
        self.density.knots()
    }

    fn opening(&self, place: f64, value: [f64; 3], memory: [f64; MEMORY]) -> f64 {
        self.density.opening(place, value, memory)
    }

    fn adhesion_response(&self, place: f64, value: [f64; 3], memory: [f64; MEMORY]) -> PointResponse<f64, 3> {
        self.density.adhesion_response(place, value, memory)
    }

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], slope: [T; 3], border: f64) -> PointResponse<T, 3> {
        self.density.response(place, value, slope, border)
    }

    #[inline(always)]
    fn add_remembered<T: Real>(&self, point: &Point<T, 3>, response: &mut PointResponse<T, 3>) {
        let &Point { place, value, slope, memory } = point;
        let [stretch, slide, bend, factor, distance, per_time, ..] = memory;
        let (Section { axial, shear, bending }, rise) = self.density.stiffness_at(place);
        let section = Section { axial: axial * factor, shear: shear * factor, bending: bending * factor };
        let viscous = stored_from(&section, StretchLaw::Linear, value[2], of_axis(slope, rise), [stretch, slide, bend]);
        response.energy = response.energy + viscous.energy;
        for f in 0..3 {
            response.by_value[f] = response.by_value[f] + viscous.by_value[f];
            response.by_slope[f] = response.by_slope[f] + viscous.by_slope[f];
            for g in 0..3 {
                response.value_value[f][g] = response.value_value[f][g] + viscous.value_value[f][g];
                response.value_slope[f][g] = response.value_slope[f][g] + viscous.value_slope[f][g];
                response.slope_value[f][g] = response.slope_value[f][g] + viscous.slope_value[f][g];
                response.slope_slope[f][g] = response.slope_slope[f][g] + viscous.slope_slope[f][g];
            }
        }
        if let Some(adhesive) = &self.adhesive {
            let ([height, width], (sin, cos)) = (self.density.outline_at(place), value[2].sin_cos());
            let opening = adhesive.response(height, value[1], sin, cos, [distance, per_time]);
            response.energy = response.energy + opening.energy * width;
            response.by_value[1] = response.by_value[1] + opening.by_gap * width;
            response.by_value[2] = response.by_value[2] + opening.by_rotation * width;
            let second = &mut response.value_value;
            second[1][1] = second[1][1] + opening.gap_gap * width;
            second[1][2] = second[1][2] + opening.gap_rotation * width;
            second[2][1] = second[2][1] + opening.rotation_gap * width;
            second[2][2] = second[2][2] + opening.rotation_rotation * width;
        }
    }

    fn is_symmetric(&self) -> bool {
        self.density.is_symmetric()
    }

    fn section_state(&self, point: &Point<f64, 3>, border: f64) -> SectionState {
        self.density.section_state(point, border)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], border: f64) -> SectionState {
        self.density.section_state_from_forces(place, value, forces, border)
    }
}

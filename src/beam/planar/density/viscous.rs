//! A beam of viscous material: what its strains since before a step in time add to its energy.
//!
//! With the strains ε = (Γ1, Γ2, θ') and C = diag(EA, GA_s, EI), a rule that replaces dε/dt by c (ε - ε_k), with a rate c and known strains
//! ε_k from the steps before, makes of a viscous section force τ C dε/dt the derivative of
//!
//!   ½ f (ε - ε_k) · C (ε - ε_k),   f = τ c,
//!
//! an energy of the step. So its tangent is symmetric. The same holds with another factor f for a spring and a dashpot in series.
//! Source: M. Ortiz, L. Stainier, The variational formulation of viscoplastic constitutive updates, Comput. Methods Appl. Mech. Eng. 171 (1999).

use super::reissner::{ReissnerBeam, ReissnerRod, stored_from};
use crate::beam::element::energy_density::{Coupling, EnergyDensity, Point, PointResponse, SectionState};
use crate::beam::section::Section;
use crate::beam::stretch_law::StretchLaw;
use crate::number::Real;

/// A density of three fields that knows the elastic stiffness of its sections.
pub trait ElasticSections: EnergyDensity<3> {
    /// EA, GA_s and EI at S, nm, and h'/2, by how much the axis rises faster than the height field.
    fn stiffness_at<T: Real>(&self, place: T) -> (Section<T>, T);
}

impl ElasticSections for ReissnerBeam {
    #[inline(always)]
    fn stiffness_at<T: Real>(&self, place: T) -> (Section<T>, T) {
        let station = self.profile.at(place);
        (station.section, station.rise)
    }
}

impl ElasticSections for ReissnerRod {
    #[inline(always)]
    fn stiffness_at<T: Real>(&self, _: T) -> (Section<T>, T) {
        (self.section.splat(), T::splat(0.0))
    }
}

/// A density whose material is viscous besides; [`Point::memory`] has the known strains and the factor f.
#[derive(Clone, Debug)]
pub struct Viscous<D>(pub D);

impl<D: ElasticSections> EnergyDensity<3> for Viscous<D> {
    const COUPLING: Coupling<3> = D::COUPLING;
    const HAS_HISTORY: bool = true;

    fn knots(&self) -> &'static [f64] {
        self.0.knots()
    }

    fn opening(&self, place: f64, value: [f64; 3]) -> f64 {
        self.0.opening(place, value)
    }

    fn adhesion_response(&self, place: f64, value: [f64; 3]) -> PointResponse<f64, 3> {
        self.0.adhesion_response(place, value)
    }

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], slope: [T; 3], border: f64) -> PointResponse<T, 3> {
        self.0.response(place, value, slope, border)
    }

    #[inline(always)]
    fn add_remembered<T: Real>(&self, point: &Point<T, 3>, response: &mut PointResponse<T, 3>) {
        let &Point { place, value, slope: [dx, dy, turn], memory: [stretch, slide, bend, factor, ..] } = point;
        let (Section { axial, shear, bending }, rise) = self.0.stiffness_at(place);
        let section = Section { axial: axial * factor, shear: shear * factor, bending: bending * factor };
        let viscous =
            stored_from(&section, StretchLaw::Linear, value[2], [dx, dy + rise, turn], [stretch, slide, bend]);
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
    }

    fn is_symmetric(&self) -> bool {
        self.0.is_symmetric()
    }

    fn section_state(&self, place: f64, value: [f64; 3], slopes: [f64; 3], border: f64) -> SectionState {
        self.0.section_state(place, value, slopes, border)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], border: f64) -> SectionState {
        self.0.section_state_from_forces(place, value, forces, border)
    }
}

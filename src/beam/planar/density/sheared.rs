//! The three-field Reissner beam on level ground, to which it is bonded along the ground as well.

use super::reissner::{ReissnerBeam, stored};
use crate::adhesion::section::line_load::LineLaw;
use crate::adhesion::section::sheared::{ShearedLaw, ShearedResponse};
use crate::beam::element::energy_density::{Coupling, EnergyDensity, PointResponse, SectionState};
use crate::beam::varying::Profile;
use crate::number::Real;

/// The planar Reissner beam of a strip under a cohesive law with a shear strength, b times the adhesion of [`ShearedLaw`]. Fields: x (nm), gap
/// η = y - h/2 (nm), rotation θ. It has no border. At rest x = S. Stored energy as of [`crate::beam::ReissnerBeam`].
#[derive(Clone, Debug)]
pub struct ShearedBeam {
    /// The beam from place to place
    pub profile: Profile,
    /// What adheres it to the flat ground
    pub law: LineLaw,
    /// The same with its shear strength
    pub sheared: ShearedLaw,
}

impl ShearedBeam {
    fn adhesion<T: Real>(&self, place: T, [x, gap, rotation]: [T; 3], height: T) -> ShearedResponse<T> {
        let (sin, cos) = rotation.sin_cos();
        self.sheared.response(height, [x - place, gap], [sin, cos])
    }
}

/// Adds the adhesion of an adhering width to a response.
#[inline(always)]
fn add<T: Real>(response: &mut PointResponse<T, 3>, adhesion: &ShearedResponse<T>, b: T) {
    response.adhesion = adhesion.energy * b;
    response.energy = response.energy + response.adhesion;
    response.coverage = response.adhesion;
    for f in 0..3 {
        response.by_value[f] = response.by_value[f] + adhesion.gradient[f] * b;
        response.coverage_by_value[f] = adhesion.energy_change[f] * b;
        for g in 0..3 {
            response.value_value[f][g] = response.value_value[f][g] + adhesion.tangent[f][g] * b;
        }
    }
}

impl EnergyDensity<3> for ShearedBeam {
    const COUPLING: Coupling<3> =
        Coupling { value_value: [[true; 3]; 3], ..<ReissnerBeam as EnergyDensity<3>>::COUPLING };

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], [dx, gap_slope, turn]: [T; 3], _: f64) -> PointResponse<T, 3> {
        let station = self.profile.at(place);
        let slopes = [dx, gap_slope + station.rise, turn];
        let mut response = stored(&station, value[2], slopes);
        add(&mut response, &self.adhesion(place, value, station.height), station.width);
        response
    }

    fn is_symmetric(&self) -> bool {
        self.sheared.has_potential()
    }

    fn knots(&self) -> &'static [f64] {
        self.sheared.cohesive.shape.knots_of_parts()
    }

    fn opening(&self, place: f64, [_, gap, rotation]: [f64; 3]) -> f64 {
        self.law.opening(self.profile.at(place).height, gap, rotation)
    }

    fn adhesion_response(&self, place: f64, value: [f64; 3]) -> PointResponse<f64, 3> {
        let station = self.profile.at(place);
        let mut response = PointResponse::zero();
        add(&mut response, &self.adhesion(place, value, station.height), station.width);
        response
    }

    fn section_state(&self, place: f64, value: [f64; 3], slopes: [f64; 3], _: f64) -> SectionState {
        self.profile.section_state(place, value[2], slopes)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        self.profile.section_state_from_forces(place, value[2], forces)
    }
}

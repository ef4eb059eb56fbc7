//! The three-field Reissner beam on ground of any shape.

use super::reissner::{section_from_forces, section_of, stored};
use super::{Coupling, Density, PointResponse, Profile, SectionState};
use crate::adhesion::GroundLaw;
use crate::number::Real;

/// The planar Reissner beam on ground that is not flat, with the adhesion bΨ of [`GroundLaw`]. Fields: x (nm), y - h/2 of the
/// axis (nm), which above level ground is the gap, rotation θ. It has no border. Stored energy as of [`super::ReissnerBeam`].
#[derive(Clone, Debug)]
pub struct BeamOnGround {
    pub profile: Profile,
    pub ground: GroundLaw,
}

impl Density<3> for BeamOnGround {
    const COUPLING: Coupling<3> =
        Coupling { value_value: [[true; 3]; 3], ..<super::ReissnerBeam as Density<3>>::COUPLING };

    #[inline(always)]
    fn response<T: Real>(
        &self,
        place: T,
        [x, gap, rotation]: [T; 3],
        [dx, gap_slope, turn]: [T; 3],
        _: f64,
    ) -> PointResponse<T, 3> {
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let adhesion = self.ground.response(station.height, [x, gap], [sin, cos]);
        let b = station.width;
        let slopes = [dx, gap_slope + station.rise, turn];
        let mut response = stored(&station.section, rotation, slopes, station.curvature);
        response.adhesion = adhesion.energy * b;
        response.energy = response.energy + response.adhesion;
        for f in 0..3 {
            response.by_value[f] = response.by_value[f] + adhesion.gradient[f] * b;
            response.adhesion_by_value[f] = adhesion.energy_gradient[f] * b;
            for g in 0..3 {
                response.value_value[f][g] = response.value_value[f][g] + adhesion.tangent[f][g] * b;
            }
        }
        response
    }

    fn is_symmetric(&self) -> bool {
        self.ground.law.has_potential()
    }

    fn section_state(&self, place: f64, value: [f64; 3], [dx, gap_slope, turn]: [f64; 3], _: f64) -> SectionState {
        let station = self.profile.at(place);
        let slopes = [dx, gap_slope + station.rise, turn];
        section_of(&stored(&station.section, value[2], slopes, station.curvature), slopes)
    }

    fn section_state_from_forces(
        &self,
        place: f64,
        [_, _, rotation]: [f64; 3],
        forces: [f64; 3],
        _: f64,
    ) -> SectionState {
        let station = self.profile.at(place);
        section_from_forces(&station.section, rotation, forces, station.curvature)
    }
}

//! The three-field Reissner beam on ground of any shape.

use super::reissner::{ReissnerBeam, of_axis, stored};
use crate::adhesion::friction::dahl::{FrictionLaw, FrictionState};
use crate::adhesion::substrate_response::GroundLaw;
use crate::beam::element::energy_density::{Coupling, EnergyDensity, Point, PointResponse, SectionState, StepEnd};
use crate::beam::varying::Profile;
use crate::number::Real;

/// The planar Reissner beam on ground that is not flat, with the adhesion bΨ of [`GroundLaw`]. Fields: ξ = x - S (nm), y - h/2 of the
/// axis (nm), which above level ground is the gap, rotation θ. It has no border. Stored energy as of [`crate::beam::ReissnerBeam`].
#[derive(Clone, Debug)]
pub struct BeamOnGround {
    /// The beam from place to place
    pub profile: Profile,
    /// What it adheres to
    pub ground: GroundLaw,
    /// Of the face that looks down, on level ground
    pub friction: Option<FrictionLaw>,
}

impl BeamOnGround {
    /// Place along the ground and gap of the face below the axis, with half the height times the sine and the cosine of its rotation:
    /// x_b = x + (h/2) sin θ,  d = y - (h/2) cos θ.
    fn face<T: Real>(&self, place: T, height: T, [along, gap, rotation]: [T; 3]) -> ([T; 2], [T; 2]) {
        let half = height * 0.5;
        let (sin, cos) = rotation.sin_cos();
        let lever = [half * sin, half * cos];
        ([place + along + lever[0], gap + (half - lever[1])], lever)
    }
}

impl EnergyDensity<3> for BeamOnGround {
    const COUPLING: Coupling<3> =
        Coupling { value_value: [[true; 3]; 3], ..<ReissnerBeam as EnergyDensity<3>>::COUPLING };

    #[inline(always)]
    fn response<T: Real>(
        &self,
        place: T,
        [along, gap, rotation]: [T; 3],
        slope: [T; 3],
        _: f64,
    ) -> PointResponse<T, 3> {
        let (sin, cos) = rotation.sin_cos();
        let station = self.profile.at(place);
        let adhesion = self.ground.response(station.height, [place + along, gap], [sin, cos]);
        let b = station.width;
        let mut response = stored(&station, rotation, of_axis(slope, station.rise));
        response.adhesion = adhesion.energy * b;
        response.energy = response.energy + response.adhesion;
        for f in 0..3 {
            response.by_value[f] = response.by_value[f] + adhesion.gradient[f] * b;
            for g in 0..3 {
                response.value_value[f][g] = response.value_value[f][g] + adhesion.tangent[f][g] * b;
            }
        }
        // on a slope cos θ is not the tilt against the ground
        response.coverage = response.adhesion;
        response.coverage_by_value = adhesion.energy_gradient.map(|by| by * b);
        response
    }

    const HAS_HISTORY: bool = true;

    /// The virtual work of friction is b t δx_b, of a traction t(x_b, d).
    #[inline(always)]
    fn add_remembered<T: Real>(&self, point: &Point<T, 3>, response: &mut PointResponse<T, 3>) {
        let &Point { place, value, memory: [from, mobilisation, ..], .. } = point;
        let Some(friction) = &self.friction else { return };
        let station = self.profile.at(place);
        let ([x, gap], [sine, cosine]) = self.face(place, station.height, value);
        let traction = friction.traction(x - from, gap, mobilisation);
        let b = station.width;
        let (force, by_place, by_gap) = (traction.value * b, traction.by_place * b, traction.by_gap * b);
        // by x, gap and θ
        let change = [by_place, by_gap, by_place * cosine + by_gap * sine];
        response.energy = response.energy + traction.energy * b;
        response.by_value[0] = response.by_value[0] + force;
        response.by_value[2] = response.by_value[2] + force * cosine;
        for f in 0..3 {
            response.value_value[0][f] = response.value_value[0][f] + change[f];
            response.value_value[2][f] = response.value_value[2][f] + change[f] * cosine;
        }
        response.value_value[2][2] = response.value_value[2][2] - force * sine;
    }

    /// Place, mobilisation and limit of the face: `FrictionState`.
    fn remember(&self, &StepEnd { place, value, .. }: &StepEnd<3>, known: &mut [f64]) -> f64 {
        let Some(friction) = &self.friction else { return 0.0 };
        let before = FrictionState { place: known[0], mobilisation: known[1], limit: known[2] };
        let station = self.profile.at(place);
        let ([x, gap], _) = self.face(place, station.height, value);
        let (slip, dissipated) = friction.remembered(x, gap, before);
        known.copy_from_slice(&[slip.place, slip.mobilisation, slip.limit]);
        station.width * dissipated
    }

    fn is_symmetric(&self) -> bool {
        self.friction.is_none() && self.ground.law.has_potential()
    }

    fn section_state(&self, point: &Point<f64, 3>, _: f64) -> SectionState {
        self.profile.section_state(point.place, point.value[2], point.slope)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        self.profile.section_state_from_forces(place, value[2], forces)
    }
}

//! The three-field Reissner beam on level ground, to which it is bonded along the ground as well, or off which it does not heal.

use super::reissner::{ReissnerBeam, of_axis, stored};
use crate::adhesion::section::calibrated::Cohesive;
use crate::adhesion::section::line_load::LineLaw;
use crate::adhesion::section::sheared::{Farthest, ShearedLaw, ShearedResponse};
use crate::beam::element::energy_density::{
    Coupling, EnergyDensity, FACE, MEMORY, Point, PointResponse, SectionState, StepEnd,
};
use crate::beam::varying::Profile;
use crate::number::Real;

/// The planar Reissner beam of a strip under a cohesive law with a shear strength, b times the adhesion of [`ShearedLaw`]. Fields: ξ = x - S (nm), gap
/// η = y - h/2 (nm), rotation θ. It has no border. At rest ξ = 0. Stored energy as of [`crate::beam::ReissnerBeam`]. Where it `REMEMBERS`,
/// [`Point::memory`] has how far its face has been.
#[derive(Clone, Debug)]
pub(crate) struct ShearedBeam<const REMEMBERS: bool> {
    /// The beam from place to place
    pub profile: Profile,
    /// What adheres it to the flat ground
    pub law: LineLaw,
    /// The same with its shear strength
    pub sheared: ShearedLaw,
    /// Whether the face is as new where it comes back
    pub heals: bool,
}

impl<const REMEMBERS: bool> ShearedBeam<REMEMBERS> {
    fn adhesion<T: Real>(
        &self,
        [along, gap, rotation]: [T; 3],
        height: T,
        [distance, slip]: [T; 2],
    ) -> ShearedResponse<T> {
        let (sin, cos) = rotation.sin_cos();
        self.sheared.response_after(height, [along, gap], [sin, cos], Farthest { distance, slip })
    }

    /// Turns what its face remembered into what it does, with the energy: see [`EnergyDensity::remember`].
    fn remember_face(&self, place: f64, value: [f64; 3], known: &mut [f64; FACE]) -> f64 {
        let [known_distance, known_slip, distance, slip] = *known;
        let station = self.profile.at(place);
        let [along, gap, rotation] = value;
        let farthest = self.sheared.farthest(station.height, [along, gap], rotation, Farthest { distance, slip });
        *known = [known_distance, known_slip, farthest.distance, farthest.slip];
        // what is as far as ever has its law, and so has what goes by as far as it has been
        let is_out = farthest.distance > distance && (farthest.slip > slip || self.sheared.is_sliding());
        if is_out || farthest.distance == known_distance && farthest.slip == known_slip {
            return 0.0;
        }
        let energy = |farthest: [f64; 2]| self.adhesion(value, station.height, farthest).energy;
        station.width * (energy([farthest.distance, farthest.slip]) - energy([known_distance, known_slip]))
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

impl<const REMEMBERS: bool> EnergyDensity<3> for ShearedBeam<REMEMBERS> {
    const COUPLING: Coupling<3> =
        Coupling { value_value: [[true; 3]; 3], ..<ReissnerBeam as EnergyDensity<3>>::COUPLING };

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], slope: [T; 3], _: f64) -> PointResponse<T, 3> {
        let station = self.profile.at(place);
        let mut response = stored(&station, value[2], of_axis(slope, station.rise));
        if !REMEMBERS {
            let nowhere = [T::splat(0.0); 2];
            add(&mut response, &self.adhesion(value, station.height, nowhere), station.width);
        }
        response
    }

    const HAS_HISTORY: bool = REMEMBERS;

    #[inline(always)]
    fn add_remembered<T: Real>(
        &self,
        &Point { place, value, memory, .. }: &Point<T, 3>,
        response: &mut PointResponse<T, 3>,
    ) {
        let station = self.profile.at(place);
        let [distance, slip, ..] = memory;
        add(response, &self.adhesion(value, station.height, [distance, slip]), station.width);
    }

    /// How far the face has been at most: up to where it began to close, by which its law goes, and up to now. The energy is what the law by which
    /// it goes wins as if the face had healed since.
    fn remember(&self, &StepEnd { place, value, .. }: &StepEnd<3>, known: &mut [f64]) -> f64 {
        let Some((face, _)) = known.split_first_chunk_mut::<FACE>() else { return 0.0 };
        if self.heals { 0.0 } else { self.remember_face(place, value, face) }
    }

    fn is_symmetric(&self) -> bool {
        self.sheared.has_potential()
    }

    fn knots(&self) -> &'static [f64] {
        self.sheared.cohesive.shape.knots_of_parts()
    }

    /// Of a face that has been farther away that is what its traction goes by.
    fn opening(&self, place: f64, [_, gap, rotation]: [f64; 3], [farthest, ..]: [f64; MEMORY]) -> f64 {
        let opening = self.law.opening(self.profile.at(place).height, gap, rotation);
        let Cohesive { closed, range, .. } = self.sheared.cohesive;
        if opening > 0.0 { opening.max((farthest - closed) / range) } else { opening }
    }

    fn adhesion_response(
        &self,
        place: f64,
        value: [f64; 3],
        [distance, slip, ..]: [f64; MEMORY],
    ) -> PointResponse<f64, 3> {
        let station = self.profile.at(place);
        let mut response = PointResponse::zero();
        add(&mut response, &self.adhesion(value, station.height, [distance, slip]), station.width);
        response
    }

    fn section_state(&self, point: &Point<f64, 3>, _: f64) -> SectionState {
        self.profile.section_state(point.place, point.value[2], point.slope)
    }

    fn remembers_face(&self) -> bool {
        !self.heals
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        self.profile.section_state_from_forces(place, value[2], forces)
    }
}

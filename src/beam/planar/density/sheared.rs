//! The three-field Reissner beam on level ground, to which it is bonded along the ground as well, off which it does not heal, or whose film yields.

use super::reissner::{ReissnerBeam, stored};
use crate::adhesion::section::calibrated::Cohesive;
use crate::adhesion::section::line_load::LineLaw;
use crate::adhesion::section::sheared::{Farthest, ShearedLaw, ShearedResponse};
use crate::beam::element::energy_density::{
    Coupling, EnergyDensity, FACE, MEMORY, Point, PointResponse, SectionState, StepEnd,
};
use crate::beam::material::yielding::{BendingLaw, BendingMemory};
use crate::beam::varying::Profile;
use crate::number::Real;

/// The planar Reissner beam of a strip under a cohesive law with a shear strength, b times the adhesion of [`ShearedLaw`]. Fields: x (nm), gap
/// η = y - h/2 (nm), rotation θ. It has no border. At rest x = S. Stored energy as of [`crate::beam::ReissnerBeam`]. Where it `REMEMBERS`,
/// [`Point::memory`] has how far a face has been that does not heal, and the turns of a film that yields.
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
    /// Of a film that yields
    pub yielding: Option<BendingLaw>,
}

impl<const REMEMBERS: bool> ShearedBeam<REMEMBERS> {
    fn adhesion<T: Real>(
        &self,
        place: T,
        [x, gap, rotation]: [T; 3],
        height: T,
        [distance, slip]: [T; 2],
    ) -> ShearedResponse<T> {
        let (sin, cos) = rotation.sin_cos();
        self.sheared.response_after(height, [x - place, gap], [sin, cos], Farthest { distance, slip })
    }

    /// Turns what its face remembered into what it does, with the energy: see [`EnergyDensity::remember`].
    fn remember_face(&self, place: f64, value: [f64; 3], known: &mut [f64; FACE]) -> f64 {
        let [known_distance, known_slip, distance, slip] = *known;
        let station = self.profile.at(place);
        let [x, gap, rotation] = value;
        let farthest = self.sheared.farthest(station.height, [x - place, gap], rotation, Farthest { distance, slip });
        *known = [known_distance, known_slip, farthest.distance, farthest.slip];
        // what is as far as ever has its law, and so has what goes by as far as it has been
        let is_out = farthest.distance > distance && (farthest.slip > slip || self.sheared.is_sliding());
        if is_out || farthest.distance == known_distance && farthest.slip == known_slip {
            return 0.0;
        }
        let energy = |farthest: [f64; 2]| self.adhesion(place, value, station.height, farthest).energy;
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
    fn response<T: Real>(&self, place: T, value: [T; 3], [dx, gap_slope, turn]: [T; 3], _: f64) -> PointResponse<T, 3> {
        let station = self.profile.at(place);
        let slopes = [dx, gap_slope + station.rise, turn];
        let mut response = stored(&station, value[2], slopes);
        if !REMEMBERS {
            let nowhere = [T::splat(0.0); 2];
            add(&mut response, &self.adhesion(place, value, station.height, nowhere), station.width);
        }
        response
    }

    const HAS_HISTORY: bool = REMEMBERS;

    #[inline(always)]
    fn add_remembered<T: Real>(
        &self,
        &Point { place, value, slope: [_, _, turn], memory }: &Point<T, 3>,
        response: &mut PointResponse<T, 3>,
    ) {
        let station = self.profile.at(place);
        let [distance, slip, ..] = memory;
        add(response, &self.adhesion(place, value, station.height, [distance, slip]), station.width);
        if let Some(law) = &self.yielding {
            // in place of a section that is elastic
            let [.., outer, back, inner] = memory;
            let (curvature, bending) = (turn - station.curvature, station.section.bending);
            let [energy, moment, stiffness] =
                T::each_of([outer, back, inner, curvature], |[outer, back, inner, at]| {
                    let bent = law.at([outer, back, inner], at);
                    [bent.energy - 0.5 * at * at, bent.moment - at, bent.stiffness - 1.0]
                });
            response.energy = response.energy + energy * bending;
            response.by_slope[2] = response.by_slope[2] + moment * bending;
            response.slope_slope[2][2] = response.slope_slope[2][2] + stiffness * bending;
        }
    }

    /// How far the face has been at most: up to where it began to close, by which its law goes, and up to now. The energy is what the law by which
    /// it goes wins as if the face had healed since. Behind it: [`BendingMemory`].
    fn remember(&self, &StepEnd { place, value, slope, before }: &StepEnd<3>, known: &mut [f64]) -> f64 {
        let Some((face, bending)) = known.split_first_chunk_mut::<FACE>() else { return 0.0 };
        if let Some(law) = &self.yielding {
            let mut known = BendingMemory::read(bending);
            law.advance(&mut known, slope[2] - self.profile.at(place).curvature, before);
            known.write(bending);
        }
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
        add(&mut response, &self.adhesion(place, value, station.height, [distance, slip]), station.width);
        response
    }

    fn section_state(&self, &Point { place, value, slope, memory }: &Point<f64, 3>, _: f64) -> SectionState {
        let elastic = self.profile.section_state(place, value[2], slope);
        let Some(law) = &self.yielding else { return elastic };
        let [.., outer, back, inner] = memory;
        let station = self.profile.at(place);
        let bent = law.at([outer, back, inner], elastic.curvature - station.curvature);
        let moment = station.section.bending * bent.moment;
        let released = |moment: f64| 0.5 * moment * moment / station.section.bending;
        SectionState { moment, stored: elastic.stored - released(elastic.moment) + released(moment), ..elastic }
    }

    fn remembers_face(&self) -> bool {
        !self.heals
    }

    fn yields(&self) -> bool {
        self.yielding.is_some()
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        self.profile.section_state_from_forces(place, value[2], forces)
    }
}

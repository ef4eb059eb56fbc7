//! Reissner's beam on its own: nothing adheres, and it may be curved at rest.

use super::reissner::{COUPLING, section_from_forces, section_of, stored};
use crate::beam::element::energy_density::{Coupling, EnergyDensity, PointResponse, SectionState};
use crate::beam::reference_configuration::ReferenceCurve;
use crate::beam::section::Section;
use crate::number::Real;

/// A planar Reissner beam that is stress-free along a given curve. Fields: x, y (nm), rotation θ. It has no border.
///
/// Γ1 and Γ2 as in [`crate::beam::ReissnerBeam`], the change of curvature θ' - κ0(S); stored energy per length
/// ½EA Γ1² + ½GA_s Γ2² + ½EI (θ' - κ0)².
#[derive(Clone, Copy, Debug)]
pub struct ReissnerRod {
    /// EA, GA_s and EI, the same everywhere
    pub section: Section,
    /// Its stress-free axis
    pub rest: ReferenceCurve,
}

impl EnergyDensity<3> for ReissnerRod {
    const COUPLING: Coupling<3> = COUPLING;

    #[inline(always)]
    fn response<T: Real>(&self, place: T, value: [T; 3], slope: [T; 3], _: f64) -> PointResponse<T, 3> {
        let [k0, k1, k2] = self.rest.curvature;
        stored(&self.section.splat(), value[2], slope, place * (place * k2 + k1) + k0)
    }

    fn section_state(&self, place: f64, value: [f64; 3], slope: [f64; 3], _: f64) -> SectionState {
        section_of(&self.response(place, value, slope, 0.0), slope)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; 3], forces: [f64; 3], _: f64) -> SectionState {
        section_from_forces(&self.section, value[2], forces, self.rest.curvature_at(place))
    }
}

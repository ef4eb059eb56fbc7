//! What a density asks of a beam at one place: stiffness, outline, and the stress-free configuration.

use super::energy_density::SectionState;
use super::reissner::{section_from_forces, section_of, stored};
use crate::beam::section::Section;
use crate::beam::varying::Varying;
use crate::number::Real;

/// A beam at one place, or at four side by side.
#[derive(Clone, Copy, Debug)]
pub struct SectionAt<T> {
    /// EA, GA_s and EI: nN, nN, nN nm²
    pub section: Section<T>,
    /// 1/EA and 1/GA_s, 1/nN
    pub compliance: [T; 2],
    /// Adhering width b, nm
    pub width: T,
    /// Height h of the section, nm
    pub height: T,
    /// h'/2: how much faster the axis rises than the gap below the underside
    pub rise: T,
    /// κ0, the curvature of the stress-free axis, 1/nm
    pub curvature: T,
}

/// A beam from place to place: one type, so that the elements are compiled once.
#[derive(Clone, Debug)]
pub enum Profile {
    /// Straight, and the same everywhere.
    Uniform(SectionAt<f64>),
    /// Of varying outline.
    Varying(Varying),
}

impl Profile {
    /// A straight beam of this section, adhering width and height, nm.
    pub fn uniform(section: Section, width: f64, height: f64) -> Self {
        let compliance = [section.axial.recip(), section.shear.recip()];
        Self::Uniform(SectionAt { section, compliance, width, height, rise: 0.0, curvature: 0.0 })
    }

    /// The beam at S, nm.
    #[inline(always)]
    pub fn at<T: Real>(&self, place: T) -> SectionAt<T> {
        match self {
            Self::Uniform(station) => SectionAt {
                section: station.section.splat(),
                compliance: station.compliance.map(T::splat),
                width: T::splat(station.width),
                height: T::splat(station.height),
                rise: T::splat(0.0),
                curvature: T::splat(0.0),
            },
            Self::Varying(beam) => beam.at(place),
        }
    }

    /// The section at S, turned by θ, under the slopes x', η' of the gap below it, and θ'.
    pub(super) fn section_state(&self, place: f64, rotation: f64, [dx, gap_slope, turn]: [f64; 3]) -> SectionState {
        let station = self.at(place);
        let slopes = [dx, gap_slope + station.rise, turn];
        section_of(&stored(&station.section, rotation, slopes, station.curvature), slopes)
    }

    /// The same section under the forces H, V and the moment M.
    pub(super) fn section_state_from_forces(&self, place: f64, rotation: f64, forces: [f64; 3]) -> SectionState {
        let station = self.at(place);
        section_from_forces(&station.section, rotation, forces, station.curvature)
    }
}

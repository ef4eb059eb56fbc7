//! The sections of a beam in space, from place to place.

use super::stiffness::SpatialStiffness;
use crate::beam::lateral_stiffness::LateralStiffness;
use crate::beam::planar::density::profile::SectionAt;
use crate::beam::varying::Varying;
use crate::number::Real;

/// What a section is at one place.
#[derive(Clone, Copy, Debug)]
pub struct Station<T = f64> {
    /// C, as in [`SpatialStiffness`]
    pub stiffness: [[T; 6]; 6],
    /// K0: twist and curvatures of the stress-free beam in the axes of its directors, 1/nm
    pub rest_curvature: [T; 3],
    /// b along d2, nm
    pub width: T,
    /// h along d3, nm
    pub height: T,
}

/// What sections are along S.
#[derive(Clone, Debug)]
pub enum SpatialProfile {
    /// The same everywhere
    Uniform(Box<Station>),
    /// Of an outline that varies along S, with its width along z at rest
    Varying(Varying),
}

/// Numbers of a section that varies: its diagonal stiffness, κ0, b and h.
const VARYING: usize = 9;

impl SpatialProfile {
    /// Of a straight beam that is the same everywhere; `width` and `height` matter where it adheres, nm.
    pub fn uniform(SpatialStiffness(stiffness): SpatialStiffness, width: f64, height: f64) -> Self {
        Self::Uniform(Box::new(Station { stiffness, rest_curvature: [0.0; 3], width, height }))
    }

    /// b and h at one place alone, nm.
    pub fn outline(&self, place: f64) -> [f64; 2] {
        match self {
            Self::Uniform(station) => [station.width, station.height],
            Self::Varying(beam) => {
                let outline = beam.contour().at(place);
                [outline.width, outline.height[0]]
            }
        }
    }

    /// The section at one place, or at several side by side.
    #[inline(always)]
    pub fn at<T: Real>(&self, place: T) -> Station<T> {
        match self {
            Self::Uniform(station) => Station {
                stiffness: station.stiffness.map(|row| row.map(T::splat)),
                rest_curvature: station.rest_curvature.map(T::splat),
                width: T::splat(station.width),
                height: T::splat(station.height),
            },
            Self::Varying(beam) => {
                let [diagonal @ .., curvature, width, height] = place.each(|place| varying(beam, place));
                let zero = T::splat(0.0);
                let mut stiffness = [[zero; 6]; 6];
                for (k, entry) in diagonal.into_iter().enumerate() {
                    stiffness[k][k] = entry;
                }
                Station { stiffness, rest_curvature: [zero, curvature, zero], width, height }
            }
        }
    }
}

/// EA, GA twice, GJ, EI2 and EI3 of a section, its curvature about d2, b and h. Turning up, a section turns about -d2.
#[inline(never)]
fn varying(beam: &Varying, place: f64) -> [f64; VARYING] {
    let outline = beam.contour().at(place);
    let SectionAt { section, curvature, width, height, .. } = beam.section_of(&outline);
    let lateral = LateralStiffness::of(beam.material(), width, height, outline.roundness);
    let shear = section.shear;
    let (axial, bending) = (section.axial, section.bending);
    [axial, shear, shear, lateral.torsion, bending, lateral.bending, -curvature, width, height]
}

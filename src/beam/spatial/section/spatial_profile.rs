//! The sections of a beam in space, from place to place, and their stiffness.

use crate::beam::section::{Material, SectionAt};
use crate::beam::torsion::LateralStiffness;
use crate::beam::varying::Varying;
use crate::number::Real;

/// Stiffness of a section: section forces and moments are C (Γ, K - K0), in the axes of the directors.
///
/// Order: Γ1 along the axis, Γ2 along the width, Γ3 along the height, the twist K1, and the curvatures K2 about the width and K3 about the
/// height. Symmetric and positive definite; entries beside the diagonal couple, as in a section that bends when it is twisted. Units: nN of
/// Γ by Γ, nN·nm between Γ and K, nN·nm² of K by K.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialStiffness(pub [[f64; 6]; 6]);

impl SpatialStiffness {
    /// Without coupling: axial EA, shear GA2 and GA3 (nN), torsion GJ, bending EI2 and EI3 (nN·nm²).
    pub fn diagonal(axial: f64, shear: [f64; 2], torsion: f64, bending: [f64; 2]) -> Self {
        let mut c = [[0.0; 6]; 6];
        for (k, entry) in [axial, shear[0], shear[1], torsion, bending[0], bending[1]].into_iter().enumerate() {
            c[k][k] = entry;
        }
        Self(c)
    }

    /// Of a section of area A (nm²) with the second moments I2 = ∫ (height)² dA and I3 = ∫ (width)² dA and the torsion constant J (nm⁴), of one
    /// isotropic material.
    pub fn isotropic(material: &Material, area: f64, [second, third]: [f64; 2], torsion_constant: f64) -> Self {
        let Material { youngs_modulus: e, poissons_ratio, shear_correction, bending_stiffness_factor, .. } = *material;
        let g = e / (2.0 * (1.0 + poissons_ratio));
        let shear = shear_correction * g * area;
        let bending = [e * second * bending_stiffness_factor, e * third];
        Self::diagonal(e * area, [shear; 2], g * torsion_constant, bending)
    }
}

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
    pub(crate) fn outline(&self, place: f64) -> [f64; 2] {
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

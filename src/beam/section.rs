//! Stiffness of a beam section.

use super::material::stretch_law::StretchLaw;
use super::material::yielding::FilmLaw;
use crate::number::Real;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Section stiffnesses of a planar beam, at one place or at four side by side.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Section<T = f64> {
    /// EA, nN
    pub axial: T,
    /// GA_s, nN
    pub shear: T,
    /// EI, nN·nm²
    pub bending: T,
}

impl Section {
    /// The same everywhere.
    #[inline(always)]
    pub(crate) fn splat<T: Real>(&self) -> Section<T> {
        Section { axial: T::splat(self.axial), shear: T::splat(self.shear), bending: T::splat(self.bending) }
    }
}

/// What a beam is made of, and how its section takes shear and bending.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// E, GPa = nN/nm²
    pub youngs_modulus: f64,
    /// ν, without a unit
    pub poissons_ratio: f64,
    /// k_s, without a unit: G k_s A is the shear stiffness
    pub shear_correction: f64,
    /// Multiplies EI alone.
    pub bending_stiffness_factor: f64,
    /// How the force along the axis follows its stretch
    #[serde(default)]
    pub stretch: StretchLaw,
    /// σ₀, GPa, of one that yields
    #[serde(default)]
    pub yield_strength: Option<f64>,
    /// Eₜ, GPa: dσ/dε beyond; zero where none is given
    #[serde(default)]
    pub tangent_modulus: Option<f64>,
}

/// The shear correction of a rectangle: what a section has unless another is given.
pub(crate) const SHEAR_CORRECTION: f64 = 5.0 / 6.0;

impl Material {
    /// Young's modulus in GPa and Poisson's ratio, in a rectangular section: k_s = 5/6, and EI as it is.
    pub const fn of(youngs_modulus: f64, poissons_ratio: f64) -> Self {
        Self {
            youngs_modulus,
            poissons_ratio,
            shear_correction: SHEAR_CORRECTION,
            bending_stiffness_factor: 1.0,
            stretch: StretchLaw::Linear,
            yield_strength: None,
            tangent_modulus: None,
        }
    }

    /// How a section with these stiffnesses yields: as a rectangle with h/2 = √(3 EI/EA).
    pub(crate) fn film_law(&self, section: &Section) -> Option<FilmLaw> {
        let (modulus, hardened) = (self.youngs_modulus, self.tangent_modulus.unwrap_or(0.0));
        let half_height = (3.0 * section.bending / section.axial).sqrt();
        let law = |strength| FilmLaw { yield_strain: strength / modulus, hardening: hardened / modulus, half_height };
        self.yield_strength.map(law)
    }

    /// Stiffness of a section between a rectangle (`roundness` 0) and an ellipse (1) of this width and height, nm:
    /// A = bh (1 + (π/4 - 1) q), I = (bh³/12)(1 + (12π/64 - 1) q).
    pub(crate) fn section(&self, width: f64, height: f64, roundness: f64) -> Section {
        let area = height * width * (1.0 + (PI / 4.0 - 1.0) * roundness);
        let second_moment = rectangle_second_moment(height, width) * (1.0 + (12.0 * PI / 64.0 - 1.0) * roundness);
        Section {
            axial: self.youngs_modulus * area,
            shear: self.shear_correction * self.youngs_modulus / (2.0 * (1.0 + self.poissons_ratio)) * area,
            bending: self.youngs_modulus * second_moment * self.bending_stiffness_factor,
        }
    }
}

/// Second moment of area of a rectangle about its middle, width h³/12, nm⁴.
pub fn rectangle_second_moment(height: f64, width: f64) -> f64 {
    width * height.powi(3) / 12.0
}

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
    /// How N follows Γ1; forms without x take it to be linear
    pub stretch: StretchLaw,
}

//! A density at all Gauss points of four elements side by side, behind one call.
//!
//! What an element asks of its density does not depend on its order: so each density is compiled once, and the elements of
//! each order once for all densities.

use super::{Coupling, Density, PointResponse, SectionState};
use crate::adhesion::Slip;
use crate::number::{Four, Real};

/// What is known at a point of the axis, or at four side by side.
#[derive(Clone, Copy, Debug)]
pub struct Point<T, const F: usize> {
    /// S, nm
    pub place: T,
    /// The fields.
    pub value: [T; F],
    /// Their derivatives with respect to S.
    pub slope: [T; F],
    /// Where the face was (nm) and what share of its limit it carried at the end of the last step, of a density that
    /// remembers.
    pub slip: [T; 2],
}

impl<T: Real, const F: usize> Point<T, F> {
    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = T::splat(0.0);
        Self { place: zero, value: [zero; F], slope: [zero; F], slip: [zero; 2] }
    }
}

/// The energies at a point, per length.
#[derive(Clone, Copy, Debug)]
pub struct PointEnergy<T, const F: usize> {
    /// Energy density φ, nN
    pub energy: T,
    /// Its share from adhesion, nN
    pub adhesion: T,
    /// ∂(adhesion)/∂field
    pub adhesion_by_value: [T; F],
}

/// The first derivatives of the energies at a point, per length.
#[derive(Clone, Copy, Debug)]
pub struct PointGradient<const F: usize> {
    /// ∂φ/∂field
    pub by_value: [f64; F],
    /// ∂φ/∂field'
    pub by_slope: [f64; F],
    /// ∂(adhesion)/∂field
    pub adhesion_by_value: [f64; F],
    /// ∂φ/∂border
    pub by_border: f64,
}

/// A [`Density`] without its type: every density is one.
pub trait Integrand<const F: usize>: Send + Sync {
    /// [`Density::COUPLING`]
    fn coupling(&self) -> Coupling<F>;
    /// [`Density::BORDER`]
    fn has_border(&self) -> bool;
    /// [`Density::REMEMBERS`]
    fn remembers(&self) -> bool;
    /// [`Density::is_symmetric`]
    fn is_symmetric(&self) -> bool;
    /// The responses at some points, with the traction that remembers; as many of them as there are points.
    fn respond(&self, points: &[Point<Four, F>], border: f64, responses: &mut [PointResponse<Four, F>]);
    /// The energies alone, at one point.
    fn energy_at(&self, point: &Point<Four, F>, border: f64) -> PointEnergy<Four, F>;
    /// The first derivatives at one point, with the traction that remembers.
    fn gradient_at(&self, point: &Point<f64, F>, border: f64) -> PointGradient<F>;
    /// Adhesion energy per length with these fields, nN
    fn adhesion_at(&self, place: f64, value: [f64; F], border: f64) -> f64;
    /// [`Density::remembered`]
    fn remembered(&self, place: f64, value: [f64; F], before: Slip) -> (Slip, f64);
    /// [`Density::section_state`]
    fn section_state(&self, place: f64, value: [f64; F], slope: [f64; F], border: f64) -> SectionState;
    /// [`Density::section_state_from_forces`]
    fn section_state_from_forces(&self, place: f64, value: [f64; F], forces: [f64; F], border: f64) -> SectionState;
}

impl<D: Density<F>, const F: usize> Integrand<F> for D {
    fn coupling(&self) -> Coupling<F> {
        D::COUPLING
    }

    fn has_border(&self) -> bool {
        D::BORDER
    }

    fn remembers(&self) -> bool {
        D::REMEMBERS
    }

    fn is_symmetric(&self) -> bool {
        Density::is_symmetric(self)
    }

    fn respond(&self, points: &[Point<Four, F>], border: f64, responses: &mut [PointResponse<Four, F>]) {
        respond(self, points, border, responses);
    }

    fn energy_at(&self, point: &Point<Four, F>, border: f64) -> PointEnergy<Four, F> {
        energy_at(self, point, border)
    }

    fn gradient_at(&self, point: &Point<f64, F>, border: f64) -> PointGradient<F> {
        let PointResponse { by_value, by_slope, adhesion_by_value, by_border, .. } = response(self, point, border);
        PointGradient { by_value, by_slope, adhesion_by_value, by_border }
    }

    fn adhesion_at(&self, place: f64, value: [f64; F], border: f64) -> f64 {
        self.response(place, value, [0.0; F], border).adhesion
    }

    fn remembered(&self, place: f64, value: [f64; F], before: Slip) -> (Slip, f64) {
        Density::remembered(self, place, value, before)
    }

    fn section_state(&self, place: f64, value: [f64; F], slope: [f64; F], border: f64) -> SectionState {
        Density::section_state(self, place, value, slope, border)
    }

    fn section_state_from_forces(&self, place: f64, value: [f64; F], forces: [f64; F], border: f64) -> SectionState {
        Density::section_state_from_forces(self, place, value, forces, border)
    }
}

/// The response at a point, with the traction that remembers.
#[inline(always)]
fn response<T: Real, D: Density<F>, const F: usize>(
    density: &D,
    point: &Point<T, F>,
    border: f64,
) -> PointResponse<T, F> {
    let mut response = density.response(point.place, point.value, point.slope, border);
    if D::REMEMBERS {
        density.hold(point.place, point.value, point.slip, &mut response);
    }
    response
}

/// [`Integrand::respond`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
fn respond<D: Density<F>, const F: usize>(
    density: &D,
    points: &[Point<Four, F>],
    border: f64,
    responses: &mut [PointResponse<Four, F>],
) {
    for (point, out) in points.iter().zip(responses) {
        *out = response(density, point, border);
    }
}

/// [`Integrand::energy_at`], likewise.
#[cfg_attr(not(any(feature = "portable", debug_assertions)), multiversion::multiversion(targets("x86_64+avx2+fma")))]
fn energy_at<D: Density<F>, const F: usize>(density: &D, point: &Point<Four, F>, border: f64) -> PointEnergy<Four, F> {
    let PointResponse { energy, adhesion, adhesion_by_value, .. } = response(density, point, border);
    PointEnergy { energy, adhesion, adhesion_by_value }
}

//! A density at all Gauss points of four elements side by side, behind one call.
//!
//! What an element asks of its density does not depend on its order: so each density is compiled once, and the elements of
//! each order once for all densities.

use super::energy_density::{Coupling, EnergyDensity, MEMORY, Point, PointResponse, SectionState, StepEnd};
use crate::number::{F64x4, Real};

/// The energies at a point, per length.
#[derive(Clone, Copy, Debug)]
pub struct PointEnergy<T, const F: usize> {
    /// Energy density φ, nN
    pub energy: T,
    /// [`PointResponse::coverage`], nN
    pub coverage: T,
    /// ∂(coverage)/∂field
    pub coverage_by_value: [T; F],
}

/// The first derivatives of the energies at a point, per length.
#[derive(Clone, Copy, Debug)]
pub struct PointGradient<const F: usize> {
    /// ∂φ/∂field
    pub by_value: [f64; F],
    /// ∂φ/∂field'
    pub by_slope: [f64; F],
    /// ∂(coverage)/∂field
    pub coverage_by_value: [f64; F],
    /// ∂φ/∂border
    pub by_border: f64,
}

/// What an element integrates: an energy density of F fields without its type.
pub trait Integrand<const F: usize>: Send + Sync {
    /// [`EnergyDensity::COUPLING`]
    fn coupling(&self) -> Coupling<F>;
    /// [`EnergyDensity::BORDER`]
    fn has_border(&self) -> bool;
    /// [`EnergyDensity::is_symmetric`]
    fn is_symmetric(&self) -> bool;
    /// [`EnergyDensity::HAS_HISTORY`]; without, what points remember is not asked
    fn remembers(&self) -> bool;
    /// The responses at some points, with what remembers; as many of them as there are points.
    fn respond(&self, points: &[Point<F64x4, F>], axial_multiplier: f64, responses: &mut [PointResponse<F64x4, F>]);
    /// The energies alone, at one point.
    fn energy_at(&self, point: &Point<F64x4, F>, axial_multiplier: f64) -> PointEnergy<F64x4, F>;
    /// The first derivatives at one point, with what remembers.
    fn gradient_at(&self, point: &Point<f64, F>, axial_multiplier: f64) -> PointGradient<F>;
    /// [`EnergyDensity::FOLLOWS_FORCE`]; otherwise the next is not asked.
    fn follows_force(&self) -> bool {
        false
    }
    /// [`EnergyDensity::slope_beyond_step`] at some points, for the changes at them; as many of them as there are points.
    fn slopes_beyond_step(
        &self,
        _points: &[Point<F64x4, F>],
        _changes: &[Point<F64x4, F>],
        _axial: [f64; 2],
        _out: &mut [F64x4],
    ) {
    }
    /// [`EnergyDensity::knots`]; without any, neither of the next three is asked.
    fn knots(&self) -> &'static [f64] {
        &[]
    }
    /// Places across a section whose openings are looked at: of one that is tilted across its width both edges
    fn edges(&self) -> usize {
        1
    }
    /// [`EnergyDensity::opening`], at one of the edges
    fn opening(&self, _place: f64, _value: [f64; F], _memory: [f64; MEMORY], _edge: usize) -> f64 {
        0.0
    }
    /// [`EnergyDensity::adhesion_response`]
    fn adhesion_response(&self, _place: f64, _value: [f64; F], _memory: [f64; MEMORY]) -> PointResponse<f64, F> {
        PointResponse::zero()
    }
}

/// An [`EnergyDensity`] of a planar beam without its type: every one is one.
pub(crate) trait PlanarIntegrand<const F: usize>: Integrand<F> {
    /// Adhesion energy per length, nN, with these fields and what is remembered
    fn adhesion_at(&self, place: f64, value: [f64; F], memory: [f64; MEMORY], axial_multiplier: f64) -> f64;
    /// [`EnergyDensity::remember`]
    fn remember(&self, end: &StepEnd<F>, known: &mut [f64]) -> f64;
    /// [`EnergyDensity::remembers_face`]
    fn remembers_face(&self) -> bool;
    /// [`EnergyDensity::yields`]
    fn yields(&self) -> bool;
    /// [`EnergyDensity::section_state`]
    fn section_state(&self, point: &Point<f64, F>, axial_multiplier: f64) -> SectionState;
    /// [`EnergyDensity::section_state_from_forces`]
    fn section_state_from_forces(
        &self,
        place: f64,
        value: [f64; F],
        forces: [f64; F],
        axial_multiplier: f64,
    ) -> SectionState;
}

impl<D: EnergyDensity<F>, const F: usize> Integrand<F> for D {
    fn coupling(&self) -> Coupling<F> {
        D::COUPLING
    }

    fn has_border(&self) -> bool {
        D::BORDER
    }

    fn is_symmetric(&self) -> bool {
        EnergyDensity::is_symmetric(self)
    }

    fn remembers(&self) -> bool {
        D::HAS_HISTORY
    }

    fn respond(&self, points: &[Point<F64x4, F>], axial_multiplier: f64, responses: &mut [PointResponse<F64x4, F>]) {
        respond(self, points, axial_multiplier, responses);
    }

    fn energy_at(&self, point: &Point<F64x4, F>, axial_multiplier: f64) -> PointEnergy<F64x4, F> {
        energy_at(self, point, axial_multiplier)
    }

    fn gradient_at(&self, point: &Point<f64, F>, axial_multiplier: f64) -> PointGradient<F> {
        let PointResponse { by_value, by_slope, coverage_by_value, by_border, .. } =
            response(self, point, axial_multiplier);
        PointGradient { by_value, by_slope, coverage_by_value, by_border }
    }

    fn follows_force(&self) -> bool {
        D::FOLLOWS_FORCE
    }

    fn slopes_beyond_step(
        &self,
        points: &[Point<F64x4, F>],
        changes: &[Point<F64x4, F>],
        axial: [f64; 2],
        out: &mut [F64x4],
    ) {
        slopes_beyond_step(self, points, changes, axial, out);
    }

    fn knots(&self) -> &'static [f64] {
        EnergyDensity::knots(self)
    }

    fn opening(&self, place: f64, value: [f64; F], memory: [f64; MEMORY], _edge: usize) -> f64 {
        EnergyDensity::opening(self, place, value, memory)
    }

    fn adhesion_response(&self, place: f64, value: [f64; F], memory: [f64; MEMORY]) -> PointResponse<f64, F> {
        EnergyDensity::adhesion_response(self, place, value, memory)
    }
}

impl<D: EnergyDensity<F>, const F: usize> PlanarIntegrand<F> for D {
    fn adhesion_at(&self, place: f64, value: [f64; F], memory: [f64; MEMORY], axial_multiplier: f64) -> f64 {
        response(self, &Point { place, value, slope: [0.0; F], memory }, axial_multiplier).adhesion
    }

    fn remember(&self, end: &StepEnd<F>, known: &mut [f64]) -> f64 {
        EnergyDensity::remember(self, end, known)
    }

    fn remembers_face(&self) -> bool {
        EnergyDensity::remembers_face(self)
    }

    fn yields(&self) -> bool {
        EnergyDensity::yields(self)
    }

    fn section_state(&self, point: &Point<f64, F>, axial_multiplier: f64) -> SectionState {
        EnergyDensity::section_state(self, point, axial_multiplier)
    }

    fn section_state_from_forces(
        &self,
        place: f64,
        value: [f64; F],
        forces: [f64; F],
        axial_multiplier: f64,
    ) -> SectionState {
        EnergyDensity::section_state_from_forces(self, place, value, forces, axial_multiplier)
    }
}

/// The response at a point, with what remembers.
#[inline(always)]
fn response<T: Real, D: EnergyDensity<F>, const F: usize>(
    density: &D,
    point: &Point<T, F>,
    axial_multiplier: f64,
) -> PointResponse<T, F> {
    let mut response = density.response(point.place, point.value, point.slope, axial_multiplier);
    if D::HAS_HISTORY {
        density.add_remembered(point, &mut response);
    }
    response
}

/// [`Integrand::respond`] compiled for the vector units that the machine may have, chosen when it runs.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn respond<D: EnergyDensity<F>, const F: usize>(
    density: &D,
    points: &[Point<F64x4, F>],
    axial_multiplier: f64,
    responses: &mut [PointResponse<F64x4, F>],
) {
    for (point, out) in points.iter().zip(responses) {
        *out = response(density, point, axial_multiplier);
    }
}

/// [`Integrand::slopes_beyond_step`], likewise.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn slopes_beyond_step<D: EnergyDensity<F>, const F: usize>(
    density: &D,
    points: &[Point<F64x4, F>],
    changes: &[Point<F64x4, F>],
    axial: [f64; 2],
    out: &mut [F64x4],
) {
    for ((point, change), out) in points.iter().zip(changes).zip(out) {
        let (from, by) = ([point.value, point.slope], [change.value, change.slope]);
        *out = density.slope_beyond_step(point.place, from, by, axial);
    }
}

/// [`Integrand::energy_at`], likewise.
#[cfg_attr(
    not(any(test, feature = "portable", debug_assertions)),
    multiversion::multiversion(targets("x86_64+avx2+fma"))
)]
fn energy_at<D: EnergyDensity<F>, const F: usize>(
    density: &D,
    point: &Point<F64x4, F>,
    axial_multiplier: f64,
) -> PointEnergy<F64x4, F> {
    let PointResponse { energy, coverage, coverage_by_value, .. } = response(density, point, axial_multiplier);
    PointEnergy { energy, coverage, coverage_by_value }
}

//! The adhesion of laws with corners, integrated piece by piece.
//!
//! Chains of three long elements that rise from closed to far beyond the range of the law, so that every corner lies
//! inside of one of
//! them: two and three fields a node, each shape, orders 5 and 7, loads with and without a potential.
//!
//! Expected: the coverage is that of a rule of a thousand panels an element on the same fields, to 1e-8; the residual
//! is the gradient of the
//! energy, the gradient of the coverage that of the coverage, and the tangent, by way of the elimination, the
//! derivative of the residual,
//! by central differences, to 1e-6 of their sizes. Why: a missing share of the pieces in one of these costs Newton's
//! method its convergence,
//! and in all of them the accuracy.

use super::elements::UniformChain;
use crate::adhesion::levels::half_space::HalfSpace;
use crate::adhesion::section::calibrated::Cohesive;
use crate::adhesion::section::cohesive::CohesiveShape;
use crate::adhesion::section::coverage::TiltCount;
use crate::adhesion::section::law::Law;
use crate::adhesion::section::line_load::{LineLaw, LineLoad};
use crate::beam::element::energy_density::{EnergyDensity, MEMORY};
use crate::beam::planar::chain::{Chain, ChainFactors, Configuration, ConstraintGradient};
use crate::beam::planar::density::reduced::ReducedBeam;
use crate::beam::planar::density::reissner::ReissnerBeam;
use crate::beam::section::Section;
use crate::beam::varying::Profile;
use nalgebra::{DMatrix, DVector};

const PAPER: HalfSpace = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
const ENDS: [f64; 4] = [0.0, 4.0, 7.0, 12.0];
const STEP: f64 = 1e-6;

fn law(shape: CohesiveShape, line_load: LineLoad) -> LineLaw {
    let law = Law::Cohesive(Cohesive::calibrated(shape, 0.08, 0.03, &PAPER));
    LineLaw { half_space: PAPER, height: 10.0, law, line_load, far_face: false }
}

/// Gap and rotation of a beam that rises.
fn fields(s: f64) -> [f64; 2] {
    [0.25 + 6e-3 * s * s + 4e-5 * s.powi(3), 1.2e-2 * s + 1e-3 * (0.7 * s).sin()]
}

/// A number an unknown, not all alike.
fn direction(unknowns: usize) -> Vec<f64> {
    (0..unknowns).map(|k| (1.3 * k as f64 + 0.4).sin()).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

fn agree<const F: usize>(density: impl EnergyDensity<F> + Clone + 'static, order: usize, conservative: bool) {
    let pinned = std::array::from_fn(|_| Some(0.1));
    let chain = UniformChain::<F>::new::<false>(Box::new(density.clone()), order, pinned);
    let mut state = Vec::new();
    for node in 0..=3 * order {
        let e = (node / order).min(2);
        let s = ENDS[e] + (ENDS[e + 1] - ENDS[e]) * chain.node_fraction(node - e * order);
        state.extend_from_slice(&[s, fields(s)[0], fields(s)[1]][3 - F..]);
    }
    let along = direction(state.len());
    let at = |state| Configuration { ends: &ENDS, state, axial_multiplier: 0.0, history: None, strains: None };
    let moved = |by: f64| -> Vec<f64> { state.iter().zip(&along).map(|(value, d)| value + by * STEP * d).collect() };
    let ahead = [moved(1.0), moved(-1.0)];
    let energies = ahead.each_ref().map(|state| chain.energy(at(state), &along).0);
    let per_step = |ahead: f64, behind: f64| (ahead - behind) / (2.0 * STEP);

    let (energy, turned) = chain.energy(at(&state), &along);
    let panels = 1000;
    let mut coverage = 0.0;
    for e in 0..3 {
        let length = ENDS[e + 1] - ENDS[e];
        for k in 0..panels {
            for (point, weight) in [(-(0.6f64.sqrt()), 5.0 / 18.0), (0.0, 8.0 / 18.0), (0.6f64.sqrt(), 5.0 / 18.0)] {
                let local = -1.0 + (2.0 * f64::from(k) + 1.0 + point) / f64::from(panels);
                let (all, _) = chain.sample(at(&state), e, local);
                let value = std::array::from_fn(|f| all[f]);
                let response = density.adhesion_response(ENDS[e] + 0.5 * (1.0 + local) * length, value, [0.0; MEMORY]);
                coverage += response.coverage * weight * length / f64::from(panels);
            }
        }
    }
    assert!((energy.coverage / coverage - 1.0).abs() < 1e-8, "order {order}: {} {coverage}", energy.coverage);

    let dot = |gradient: &[f64]| gradient.iter().zip(&along).map(|(g, d)| g * d).sum::<f64>();
    let by_coverage = per_step(energies[0].coverage, energies[1].coverage);
    let gradient = chain.coverage_gradient(at(&state));
    assert!((dot(&gradient) - by_coverage).abs() < 1e-6 * largest(&gradient), "order {order}");
    assert!((turned - dot(&gradient)).abs() < 1e-12 * largest(&gradient), "order {order}");
    if conservative {
        let (mut residual, _) = chain.residual(at(&state));
        // the equations of what is held say how far it is from there
        let free = UniformChain::<F>::new::<false>(Box::new(density), order, [None; F]);
        residual[..F].copy_from_slice(&free.residual(at(&state)).0[..F]);
        let by_energy = per_step(energies[0].total, energies[1].total);
        assert!((dot(&residual) - by_energy).abs() < 1e-6 * largest(&residual), "order {order}");
    }

    let mut eliminated = ChainFactors::default();
    let row = ConstraintGradient { coverage: 1.0, ..ConstraintGradient::default() };
    let root = chain.eliminate(at(&state), &row, &mut eliminated).unwrap();
    assert!((root.energy.coverage - energy.coverage).abs() < 1e-12 * energy.coverage.abs());
    assert!((root.energy.total - energy.total).abs() < 1e-12 * energy.total.abs());
    let residuals = ahead.each_ref().map(|state| chain.residual(at(state)).0);
    let mut x: Vec<f64> = residuals[0].iter().zip(&residuals[1]).map(|(a, b)| per_step(*a, *b)).collect();
    let left = chain.reduce(&eliminated, &mut x, false);
    let block = DMatrix::from_fn(F, F, |i, j| root.matrix[i][j]);
    let last = block.lu().solve(&DVector::from_column_slice(&left[..F])).unwrap();
    chain.substitute(&eliminated, last.as_slice(), &mut x, false);
    let missed = x.iter().zip(&along).map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max);
    assert!(missed < 1e-6, "order {order}: {missed:e}");
}

fn of_shape(shape: CohesiveShape) {
    for line_load in [LineLoad::Full, LineLoad::ForceOnly, LineLoad::AxisGap] {
        let (law, profile) = (law(shape, line_load), || {
            Profile::uniform(Section { axial: 20.0, shear: 7.0, bending: 160.0 }, 1.0, 10.0)
        });
        for order in [5, 7] {
            agree::<2>(
                ReducedBeam::<false> { profile: profile(), law, count: TiltCount::Coarse },
                order,
                law.has_potential(),
            );
            agree::<3>(ReissnerBeam { profile: profile(), law, count: TiltCount::Coarse }, order, law.has_potential());
        }
    }
}

#[test]
fn bilinear() {
    of_shape(CohesiveShape::Bilinear);
}

#[test]
fn dugdale() {
    of_shape(CohesiveShape::Dugdale);
}

#[test]
fn trapezoidal() {
    of_shape(CohesiveShape::Trapezoidal);
}

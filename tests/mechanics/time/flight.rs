//! A beam that flies freely in space, turning about a tilted axis and bending as it goes.
//!
//! References: energy, momentum and angular momentum of a body that nothing acts on; the same spin in the plane and in space. Parameters: those of the
//! flying beam of J. C. Simo, L. Vu-Quoc, Comput. Methods Appl. Mech. Eng. 66 (1988), EA = GA = 1e4, GJ = EI = 500 and 400, ρA = 1, ρJ = 20, 10, 8.
//! Expected: conservation to the error of the steps, which falls with the square of their length. Why: rotations in space, gyroscopic forces.

use crate::beam::spatial::setup::{NO_LOAD, PLAIN, Rod, XYZ};
use peelkit::beam::{
    EndRotation, SpatialBeam, SpatialChain, SpatialDensity, SpatialEnd, SpatialInertia, SpatialProfile,
    SpatialRestCurve, SpatialStiffness, Viscosity,
};
use peelkit::solve::time::{Drive, DynamicProblem, DynamicSystem, Motion, StepControl, TimeIntegrator, TimeOptions};
use peelkit::solve::{EndConditions, InitialState, MeasuredBeside, PathMeasure, Problem, State, System, Workspace};
use std::f64::consts::PI;
use std::sync::Arc;

const LENGTH: f64 = 10.0;
const END: f64 = 4.0;

/// Free at both ends.
fn beam() -> SpatialBeam {
    let rest = SpatialRestCurve { start: [0.0; 3], directors: PLAIN, curvature: [0.0; 3] };
    let stiffness = SpatialStiffness::diagonal(1e4, [1e4; 2], 500.0, [500.0, 400.0]);
    let end = || SpatialEnd { axes: XYZ, rotation: EndRotation::Free, rest: PLAIN, dead_load: NO_LOAD };
    let density = SpatialDensity { profile: SpatialProfile::uniform(stiffness, 1.0, 1.0), adhesion: None, held: None };
    SpatialBeam {
        chain: SpatialChain::new(density, 5, [end(), end()], [None; 6]),
        inertia: Some(SpatialInertia::uniform(1.0, [20.0, 10.0, 8.0], Viscosity::Elastic)),
        ..Rod::clamped(stiffness, rest, LENGTH).beam()
    }
}

/// Turning about a tilted axis, and bending across it.
fn let_go(beam: &SpatialBeam) -> (State, Vec<f64>, Vec<f64>) {
    let at = beam.stress_free(3);
    let [wx, wy, wz] = [0.3, 0.5, 1.0];
    let velocity: Vec<f64> = at.values[..beam.unknowns(&at) / 6 * 7]
        .chunks_exact(7)
        .flat_map(|node| {
            let x = node[0] - 0.5 * LENGTH;
            let phase = 2.0 * PI * x / LENGTH;
            let (wave, slope) = (0.5 * phase.cos(), -PI / LENGTH * phase.sin());
            [0.0, wz * x, -wy * x + wave, wx, wy - slope, wz]
        })
        .collect();
    let masses = beam.masses(&at);
    let gyroscopic = beam.inertia_forces(&at, &masses, &velocity, &vec![0.0; velocity.len()]);
    let stress = beam.residual(&at);
    let acceleration = (0..masses.len()).map(|k| -(gyroscopic[k] + stress[k]) / masses[k]).collect();
    (at, velocity, acceleration)
}

/// Errors of the energy and of the angular momentum, over these, and of the momentum, at the end.
fn errors(h: f64, spectral_radius: f64) -> [f64; 3] {
    let beam = Arc::new(beam());
    let (at, velocity, acceleration) = let_go(&beam);
    let measure = PathMeasure { monitors: [f64::INFINITY; 2], force: 1.0, beside: MeasuredBeside::Force };
    let grip = EndConditions::drive(1);
    let problem = Problem { system: beam.clone(), grip, measure, start: InitialState::StressFree };
    let problem = DynamicProblem::new(problem, beam.clone());
    let before = beam.momenta(&at, &velocity);
    let options = TimeOptions { spectral_radius, ..TimeOptions::new(StepControl::Fixed(h)) };
    let free = Drive::Force(Arc::new(|_| 0.0));
    let motion = Motion::new(0.0, at, velocity, acceleration, Vec::new());
    let mut run = TimeIntegrator::new(&problem, free, motion, options, Workspace::default());
    while run.motion().time < END - 1e-9 {
        run.advance(END).unwrap();
    }
    let after = beam.momenta(&run.motion().at, &run.motion().velocity);
    let apart = |k: usize| (0..3).map(|i| (after[k][i] - before[k][i]).abs()).fold(0.0, f64::max);
    assert!(run.balance().stored > 0.01, "it does not bend: {:?}", run.balance());
    let spin = before[1].iter().map(|l| l * l).sum::<f64>().sqrt();
    [run.balance().defect(run.start()).abs() / run.start().total(), apart(1) / spin, apart(0)]
}

/// With steps that the fastest vibrations of its mesh need, the error of the angular momentum is of second order.
#[test]
fn energy_and_momenta_are_kept() {
    let [coarse, fine] = [0.005, 0.0025].map(|h| errors(h, 0.8));
    assert!(fine[0] < 1e-6, "energy: {:.2e}", fine[0]);
    assert!(fine[1] < 5e-7, "angular momentum: {:.2e}", fine[1]);
    assert!(fine[2] < 1e-9, "momentum: {:.2e}", fine[2]);
    let order = (coarse[1] / fine[1]).log2();
    assert!((order - 2.0).abs() < 0.3, "order {order:.2}");
}

/// The forces of inertia are those that the kinetic energy and the momenta ask for: their power is its rate.
#[test]
fn power_of_inertia_is_the_rate_of_kinetic_energy() {
    let beam = beam();
    let (at, velocity, acceleration) = let_go(&beam);
    let masses = beam.masses(&at);
    assert!(acceleration.iter().all(|a| a.is_finite()));
    let acceleration: Vec<f64> = (0..velocity.len()).map(|k| (1.7 * k as f64).sin()).collect();
    let forces = beam.inertia_forces(&at, &masses, &velocity, &acceleration);
    let power: f64 = forces.iter().zip(&velocity).map(|(f, v)| f * v).sum();
    let kinetic = |dt: f64| {
        let ahead: Vec<f64> = velocity.iter().zip(&acceleration).map(|(v, a)| v + dt * a).collect();
        beam.kinetic_energy(&at, &masses, &ahead)
    };
    let rate = (kinetic(1e-4) - kinetic(-1e-4)) / 2e-4;
    approx::assert_relative_eq!(power, rate, max_relative = 1e-7);
}

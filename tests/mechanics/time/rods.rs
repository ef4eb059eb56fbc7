//! Small vibrations of rods against closed forms.
//!
//!     /|===============  let go from its first mode        /|==>==>==  a rod of viscous material, let go from a stretch
//!
//! References: the clamped-free beam of Euler and Bernoulli, ω = (1.875104)² (EI/(ρA L⁴))^(1/2); the fixed-free bar, ω = (π/2L)(EA/ρA)^(1/2), and
//! of Kelvin and Voigt's material its decay exp(-½ τ ω² t). Parameters: slender, shear and rotary inertia next to nothing.
//! Expected: the time of a quarter of a period and the decay to the error of the steps. Why: mass, stiffness and viscosity each in
//! their right size; nodes in elements are eliminated with their mass.

use approx::assert_relative_eq;
use peelkit::beam::{BeamInertia, ReferenceCurve, Section, Viscosity};
use peelkit::model::{Drive as Driven, RodModel, Support};
use peelkit::solve::Workspace;
use peelkit::solve::time::{Drive, Motion, StepControl, TimeIntegrator, TimeOptions};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

const LENGTH: f64 = 10.0;
const AXIAL: f64 = 1e4;
const BENDING: f64 = 1.0;
const MASS: f64 = 0.7;

/// The displacement of the free right end of a rod that is let go with the velocities `velocity` of x and y at S, after a time.
fn let_go(viscosity: Viscosity, along: bool, velocity: impl Fn(f64) -> [f64; 2], time: f64, steps: usize) -> f64 {
    let rod = RodModel {
        length: LENGTH,
        section: Section { axial: AXIAL, shear: 1e6, bending: BENDING },
        rest: ReferenceCurve::default(),
        left: Support::CLAMPED,
        right: Support::FREE,
        drive: if along { Driven::X } else { Driven::Y },
    };
    let (order, elements) = (6, 3);
    let beam = rod.in_time(order, BeamInertia::uniform(MASS, 1e-7, viscosity)).unwrap();
    let at = beam.statics.initial(elements);
    let mut start = vec![0.0; at.values.len()];
    let places = beam.statics.beam.planar().unwrap().places(&at.mesh.boundaries);
    for (s, own) in places.into_iter().zip(start.chunks_exact_mut(3)) {
        let [vx, vy] = velocity(s);
        // the section stays normal to the axis
        let slope = (velocity(s + 1e-5)[1] - velocity(s - 1e-5)[1]) / 2e-5;
        own.copy_from_slice(&[vx, vy, slope]);
    }
    start[..3].fill(0.0);
    let last = at.values.len() - 3 + usize::from(!along);
    let from = at.values[last];
    let memory = beam.dynamics.system.relaxed_memory(&at);
    let still = vec![0.0; start.len()];
    let motion = Motion::new(0.0, at, start, still, memory);
    let options = TimeOptions { spectral_radius: 0.6, ..TimeOptions::new(StepControl::Fixed(time / steps as f64)) };
    let free = Drive::Force(Arc::new(|_| 0.0));
    let mut run = TimeIntegrator::new(&beam.dynamics, free, motion, options, Workspace::default());
    while run.motion().time < time * (1.0 - 1e-9) {
        run.advance(time).unwrap();
    }
    run.motion().at.values[last] - from
}

/// The first mode of a cantilever with the size 1 at its end.
fn first_mode(s: f64) -> f64 {
    let k = 1.875_104_068_711_961 / LENGTH;
    let kl = k * LENGTH;
    let ratio = (kl.cosh() + kl.cos()) / (kl.sinh() + kl.sin());
    let mode = |s: f64| (k * s).cosh() - (k * s).cos() - ratio * ((k * s).sinh() - (k * s).sin());
    mode(s) / mode(LENGTH)
}

/// A cantilever is at v/ω sin ωt.
#[test]
fn the_first_mode_of_a_cantilever() {
    let frequency = (1.875_104_068_711_961 / LENGTH).powi(2) * (BENDING / MASS).sqrt();
    let velocity = 1e-4 * frequency;
    let quarter = FRAC_PI_2 / frequency;
    for (periods, expected) in [(1.0, 1.0), (3.0, -1.0)] {
        let found = let_go(Viscosity::Elastic, false, |s| [0.0, velocity * first_mode(s)], periods * quarter, 600);
        assert_relative_eq!(found, 1e-4 * expected, max_relative = 1e-3);
    }
    // where it passes through rest after half a period, a frequency that is wrong shows
    let half = let_go(Viscosity::Elastic, false, |s| [0.0, velocity * first_mode(s)], 2.0 * quarter, 800);
    assert!(half.abs() < 1e-4 * 2e-3, "{half:e}");
}

/// A bar is at v/ω_d exp(-δt) sin ω_d t, δ = ½ τ ω².
#[test]
fn a_viscous_bar_decays() {
    let frequency = PI / (2.0 * LENGTH) * (AXIAL / MASS).sqrt();
    let retardation_time = 0.1 / frequency;
    let decay = 0.5 * retardation_time * frequency * frequency;
    let damped = (frequency * frequency - decay * decay).sqrt();
    let size = 1e-5;
    let bar = |s: f64| [size * frequency * (FRAC_PI_2 * s / LENGTH).sin(), 0.0];
    for quarters in [1.0, 3.0, 9.0] {
        let time = quarters * FRAC_PI_2 / damped;
        let found = let_go(Viscosity::KelvinVoigt { retardation_time }, true, bar, time, 500 * quarters as usize);
        let expected = size * frequency / damped * (-decay * time).exp() * (damped * time).sin();
        assert_relative_eq!(found, expected, max_relative = 2e-3);
    }
}

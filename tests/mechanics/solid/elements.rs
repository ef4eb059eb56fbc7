//! Elements of a solid: tangents, symmetry, patches, rotations.

use super::{all_small, model, strip};
use approx::assert_abs_diff_eq;
use peelkit::solve::{Coefficients, INTERFACE, State, System, Workspace};

/// A state that is no equilibrium: every unknown moved by something of its own.
fn moved(system: &dyn System) -> State {
    let mut at = system.stress_free(1);
    for (k, value) in at.values.iter_mut().enumerate() {
        *value = 0.02 * ((37 * k + 5) as f64).sin();
    }
    let last = at.values.len() - 1;
    at.values[last] += 0.1;
    at
}

/// A direction that leaves the held corner where it is.
fn direction(n: usize) -> Vec<f64> {
    (0..n).map(|k| if k == 0 { 0.0 } else { ((17 * k + 3) as f64).cos() }).collect()
}

fn largest(vector: &[f64]) -> f64 {
    vector.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// What is factorised is the derivative of the residual: of the change of the residual along a direction, it finds that direction again.
#[test]
fn tangents_are_derivatives_of_residuals() {
    let model = model(6.0, 4.0);
    let step = 1e-6;
    for (name, settings) in all_small() {
        let system = strip(&settings, &model);
        let (system, at) = (&*system as &dyn System, moved(&*system));
        let n = system.unknowns(&at);
        let along = direction(n);
        let by = |factor: f64| {
            let mut beside = at.clone();
            system.retract(&mut beside, &along, factor * step);
            system.residual(&beside)
        };
        let [before, after, far_before, far_after] = [-1.0, 1.0, -2.0, 2.0].map(by);
        let mut right: Vec<f64> =
            (0..n).map(|k| (8.0 * (after[k] - before[k]) - (far_after[k] - far_before[k])) / (12.0 * step)).collect();
        let mut ws = Workspace::default();
        let condensed = system.factorise(&at, Coefficients::STATIC, [0.0; 2], &mut ws).unwrap();
        let reduced = system.reduce(&ws, &mut right, false);
        let slots = system.interface().len();
        let first = system.place_of(0, &at);
        let mut interface = [0.0; INTERFACE];
        interface[..slots].copy_from_slice(&along[first..first + slots]);
        for i in 0..slots {
            let found: f64 = (0..slots).map(|j| condensed.matrix[i][j] * interface[j]).sum();
            let scale = largest(&reduced).max(largest(&condensed.matrix[i]));
            assert_abs_diff_eq!(found / scale, reduced[i] / scale, epsilon = 1e-8);
        }
        system.substitute(&ws, &interface, &mut right, false);
        let missed: Vec<f64> = right.iter().zip(&along).map(|(found, along)| found - along).collect();
        assert!(largest(&missed) < 1e-8, "{name}: {:.2e}", largest(&missed));
    }
}

/// With a potential the residual is its gradient; without one the transposed solution is that of another matrix.
#[test]
fn residuals_are_gradients_of_the_energy_where_there_is_one() {
    let model = model(6.0, 4.0);
    let step = 1e-5;
    for (name, settings) in all_small() {
        let system = strip(&settings, &model);
        let (system, at) = (&*system as &dyn System, moved(&*system));
        let n = system.unknowns(&at);
        let along = direction(n);
        let mut ws = Workspace::default();
        system.factorise(&at, Coefficients::STATIC, [0.0; 2], &mut ws).unwrap();
        let solved = |transposed: bool| {
            let mut right = along.clone();
            system.reduce(&ws, &mut right, transposed);
            system.substitute(&ws, &[0.0; INTERFACE], &mut right, transposed);
            right
        };
        let (own, transposed) = (solved(false), solved(true));
        let apart: Vec<f64> = own.iter().zip(&transposed).map(|(a, b)| a - b).collect();
        let apart = largest(&apart) / largest(&own);
        if settings.contact.has_potential() {
            assert!(apart < 1e-12, "{name}: {apart:.2e}");
            let energy = |factor: f64| {
                let mut beside = at.clone();
                system.retract(&mut beside, &along, factor * step);
                system.evaluate(&beside, &along).0.energy
            };
            let slope = (8.0 * (energy(1.0) - energy(-1.0)) - (energy(2.0) - energy(-2.0))) / (12.0 * step);
            let expected: f64 = system.residual(&at).iter().zip(&along).map(|(r, d)| r * d).sum();
            let scale = largest(&system.residual(&at));
            assert!((slope - expected).abs() < 1e-8 * scale, "{name}: {slope} {expected}");
        } else {
            assert!(apart > 1e-4, "{name}: {apart:.2e}");
        }
    }
}

/// The front position and its gradient, which elimination carries along.
#[test]
fn monitors_have_their_gradient() {
    let model = model(6.0, 4.0);
    for (name, settings) in all_small().into_iter().step_by(7) {
        let system = strip(&settings, &model);
        let (system, at) = (&*system as &dyn System, moved(&*system));
        let along = direction(system.unknowns(&at));
        let of = |factor: f64| {
            let mut beside = at.clone();
            system.retract(&mut beside, &along, factor * 1e-6);
            system.evaluate(&beside, &along).0.monitors[0]
        };
        let rate = system.evaluate(&at, &along).1.monitors[0];
        assert_abs_diff_eq!(rate, (of(1.0) - of(-1.0)) / 2e-6, epsilon = 1e-7);
        // c K⁻¹ R of the whole by the condensed numbers, and directly
        let mut ws = Workspace::default();
        let condensed = system.factorise(&at, Coefficients::STATIC, [1.0, 0.0], &mut ws).unwrap();
        let mut right = system.residual(&at);
        system.reduce(&ws, &mut right, false);
        let interface = [0.3, -0.2, 0.1, 0.0, 0.0, 0.0];
        system.substitute(&ws, &interface, &mut right, false);
        let gradient = system.gradient(&at, [1.0, 0.0]);
        let whole: f64 = gradient.iter().zip(&right).map(|(g, q)| g * q).sum();
        let slots = system.interface().len();
        let condensed: f64 =
            (0..slots).map(|k| condensed.gradient[k] * interface[k]).sum::<f64>() - condensed.gradient_residual;
        assert!((whole - condensed).abs() < 1e-9 * whole.abs().max(1.0), "{name}: {whole} {condensed}");
    }
}

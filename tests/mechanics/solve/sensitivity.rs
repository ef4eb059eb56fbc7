//! The planar beam's derivatives by parameters of its model: one transposed solve against differences of whole solutions.
//!
//! The paper's strip (L = 100 nm, h = 10 nm, E = 2 GPa), lifted by a displacement u that is held; the derivative of the force,
//! dP/d ln p = -λ·∂R/∂ln p with the multipliers λ of the force, and the residuals R of beams with another p at the same state. Forms: x
//! condensed, with the axial force as a multiplier (held across), x at every node, a load without a potential (unsymmetric tangent), and a
//! pull at 60 degrees.
//! Expected: to 2e-8 of P.

use crate::common::{paper_strip, with_grip, with_load};
use approx::assert_abs_diff_eq;
use peelkit::adhesion::LineLoad;
use peelkit::model::{Body, Form, Hold, PeelModel, Pull, Strip};
use peelkit::solve::{
    Bordered, Observables, PathConstraint, Problem, Solution, State, Tangents, Workspace, controlled,
};

const LIFT: f64 = 0.3;
const ELEMENTS: usize = 18;

fn solved(model: &PeelModel, form: Form, start: Option<State>) -> (impl std::ops::Deref<Target = Problem>, Solution) {
    let problem = model.problem(form, 5).unwrap();
    let start = start.unwrap_or_else(|| problem.initial(ELEMENTS));
    let found = controlled(&problem, start, Observables::DISPLACEMENT, &[LIFT], 1e-13).unwrap().remove(0);
    (problem, found)
}

fn check(name: &str, model: PeelModel, form: Form) {
    let (problem, solution) = solved(&model, form, None);
    let constraint = PathConstraint { weights: Observables::DISPLACEMENT, target: LIFT };
    let mut ws = Workspace::default();
    let tangents = Tangents::new(&problem, &solution.at, &constraint, &mut ws).unwrap();
    let unknowns = problem.system.unknowns(&solution.at);
    let functional = Bordered { direction: vec![0.0; unknowns], last: 1.0 };
    let multipliers = tangents.solve_transposed(&functional, &ws).unwrap().direction;
    for (key, number) in NUMBERS {
        let varied = |change: f64| {
            let mut varied = model.clone();
            *number(&mut varied) *= change.exp();
            varied
        };
        let residual = |change: f64| varied(change).problem(form, 5).unwrap().system.residual(&solution.at);
        let by_parameter = central(1e-3, residual);
        let adjoint: f64 = -multipliers.iter().zip(&by_parameter).map(|(m, r)| m * r).sum::<f64>();
        let force = |change: f64| vec![solved(&varied(change), form, Some(solution.at.clone())).1.observables.force];
        let difference = central(1e-3, force)[0];
        let scale = solution.observables.force.abs();
        assert!((adjoint - difference).abs() < 2e-8 * scale, "{name}, {key}: {adjoint:e} against {difference:e}");
    }
}

/// A number of a strip that does not move where it rests.
type Number = fn(&mut PeelModel) -> &mut f64;

const NUMBERS: [(&str, Number); 4] = [
    ("youngs_modulus", |model| &mut strip_of(model).material.youngs_modulus),
    ("shear_correction", |model| &mut strip_of(model).material.shear_correction),
    ("bending_stiffness_factor", |model| &mut strip_of(model).material.bending_stiffness_factor),
    ("hamaker_constant", |model| &mut model.adhesion.hamaker_constant),
];

fn strip_of(model: &mut PeelModel) -> &mut Strip {
    let Body::Strip(strip) = &mut model.body else { panic!("a strip") };
    strip
}

/// The derivative at zero, by a central difference of the fourth order.
fn central(step: f64, of: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let [one, other, far, farther] = [step, -step, 2.0 * step, -2.0 * step].map(of);
    let difference = |k: usize| (8.0 * (one[k] - other[k]) - (far[k] - farther[k])) / (12.0 * step);
    (0..one.len()).map(difference).collect()
}

#[test]
fn the_force_of_strips_by_material_and_adhesion() {
    let strip = paper_strip(100.0, 1.0);
    check("x condensed", (&strip).into(), Form::TwoField);
    check("x at every node", (&strip).into(), Form::ThreeField);
    check("held across", (&with_grip(strip, Hold::Fixed, Hold::Fixed)).into(), Form::TwoField);
    check("without a potential", (&with_load(strip, LineLoad::ForceOnly)).into(), Form::TwoField);
    let pull = Pull { angle: 60f64.to_radians(), ..Pull::UP };
    check("at 60 degrees", PeelModel { pull, ..(&strip).into() }, Form::TwoField);
    check("at 60 degrees, x at every node", PeelModel { pull, ..(&strip).into() }, Form::ThreeField);
}

/// The gradient of the monitors against differences, which the transposed solve with a path constraint needs.
#[test]
fn gradients_of_front_and_rotation() {
    let strip: PeelModel = (&paper_strip(100.0, 1.0)).into();
    for form in [Form::TwoField, Form::ThreeField] {
        let (problem, solution) = solved(&strip, form, None);
        let at = &solution.at;
        for weights in [[1.0, 0.0], [0.0, 1.0], [0.3, -2.0]] {
            let gradient = problem.system.gradient(at, weights);
            let direction: Vec<f64> = (0..gradient.len()).map(|k| (0.7 * k as f64).sin()).collect();
            let rates = problem.system.evaluate(at, &direction).1.monitors;
            let along: f64 = gradient.iter().zip(&direction).map(|(g, d)| g * d).sum();
            assert_abs_diff_eq!(
                along,
                weights[0] * rates[0] + weights[1] * rates[1],
                epsilon = 1e-10 * along.abs().max(1.0)
            );
        }
    }
}

#[test]
fn in_equilibrium_only_the_grip_has_a_residual() {
    let strip = paper_strip(100.0, 1.0);
    for model in [(&strip).into(), (&with_grip(strip, Hold::Fixed, Hold::Free)).into()] {
        let (problem, solution) = solved(&model, Form::TwoField, None);
        let residual = problem.system.residual(&solution.at);
        let (inside, end) = residual.split_at(residual.len() - 2);
        let force = solution.observables.force;
        let most = inside.iter().fold(0.0f64, |most, r| most.max(r.abs()));
        assert!(most < 1e-8 * force.abs(), "{most:e}");
        assert_abs_diff_eq!(end[0], force, epsilon = 1e-8 * force.abs());
    }
}

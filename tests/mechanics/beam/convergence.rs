//! Order of convergence of the elements, p = 1 to 8.
//!
//! Reference: the same strip on 40 elements of order 8; 60 of order 8 and 50 of order 7 agree with it to 4e-14.
//!
//!     |----- L = 10 nm -----|
//!      _____________________ ^ u = 0.2 nm, P
//!     |___|___|___|___|___|_|     n elements of order p, all of one length
//!     =======================
//!
//! Parameters: the paper's section, L = 10 nm; n = 2, 4, … 128.
//!
//! Expected: with p Gauss points for every term the nodes are as accurate as in Gauss collocation, order 2p: the error of the
//! force falls by 2^(2p) when n doubles, until it is round-off. Orders up to 3 show their order before that; for the others
//! only the error is compared, and `peel verify --only orders` extrapolates the rate. Why: a quadrature that is short of a
//! point, or a locking element, shows here and nowhere else: its results still converge.

use crate::common::paper_strip;
use peelkit::model::Form;
use peelkit::solve::{Mesh, NewtonOptions, Observables, PathConstraint, Workspace, solve};

/// Relative error of the force, order p = 1 to 8 (rows) on n = 2, 4, 8, 16, 32, 64, 128 elements. Round-off below 1e-13.
#[rustfmt::skip]
const ERRORS: [[f64; 7]; 8] = [
    [2.868e-2, 3.464e-2, 9.263e-3, 2.314e-3, 5.783e-4, 1.445e-4, 3.613e-5],
    [4.623e-2, 3.204e-3, 8.582e-6, 2.648e-6, 2.188e-7, 1.476e-8, 9.407e-10],
    [9.965e-3, 3.250e-4, 3.888e-6, 1.010e-7, 2.056e-9, 3.481e-11, 5.348e-13],
    [2.357e-3, 4.649e-6, 1.157e-7, 1.486e-9, 8.468e-12, 1e-13, 1e-13],
    [4.200e-4, 5.224e-7, 6.653e-9, 1.837e-11, 1e-13, 1e-13, 1e-13],
    [9.089e-5, 9.131e-8, 1.726e-10, 1.923e-13, 1e-13, 1e-13, 1e-13],
    [1.450e-5, 2.078e-9, 6.319e-12, 1e-13, 1e-13, 1e-13, 1e-13],
    [2.786e-6, 4.507e-10, 1.660e-13, 1e-13, 1e-13, 1e-13, 1e-13],
];

/// Force at u = 0.2 nm, and the Newton iterations of the four steps to it.
fn force(form: Form, order: usize, elements: usize) -> (f64, usize) {
    let problem = paper_strip(10.0, 1.0).problem(form, order).unwrap();
    let weights = Observables::DISPLACEMENT;
    let options = NewtonOptions { tolerance: 1e-13, largest_update: 5.0, most_iterations: 30, exact_slope: false };
    let mut work = Workspace::default();
    let mut at = problem.initial(elements);
    let boundaries = (0..=elements).map(|k| problem.beam.length() * k as f64 / elements as f64).collect();
    at = problem.beam.resampled(&at, Mesh { boundaries, ..at.mesh.clone() });
    let (mut force, mut iterations) = (0.0, 0);
    for target in [0.0, 0.05, 0.1, 0.15, 0.2] {
        let solution = solve(&problem, at, &PathConstraint { weights, target }, &options, &mut work)
            .unwrap_or_else(|error| panic!("order {order}, {elements} elements, u = {target} nm: {error}"));
        at = solution.moved(&problem, 0.05);
        (force, iterations) = (solution.observables.force, iterations + solution.iterations);
    }
    (force, iterations)
}

/// Relative errors in the layout of [`ERRORS`].
fn errors(form: Form) -> Vec<Vec<f64>> {
    let (exact, _) = force(Form::TwoField, 8, 40);
    let row = |p: usize| (1..=7).map(|k| (force(form, p, 1 << k).0 / exact - 1.0).abs()).collect();
    (1..=8).map(row).collect()
}

#[test]
fn references_agree() {
    let (exact, _) = force(Form::TwoField, 8, 40);
    for (order, elements) in [(8, 60), (7, 50)] {
        let (other, _) = force(Form::TwoField, order, elements);
        assert!((other / exact - 1.0).abs() < 1e-13, "order {order}: {other} and {exact}");
    }
}

#[test]
fn errors_are_those_of_the_table() {
    for form in [Form::TwoField, Form::ThreeField] {
        for (p, (row, table)) in errors(form).iter().zip(&ERRORS).enumerate() {
            for (k, (&error, &stored)) in row.iter().zip(table).enumerate() {
                let case = format!("{form:?}, order {}, {} elements: {error:.3e}, was {stored:.3e}", p + 1, 2 << k);
                assert!(error < 1.25 * stored + 1e-13, "{case}");
                assert!(error > 0.8 * stored - 2e-13, "{case}: better than it can be");
            }
        }
    }
}

/// The last doubling before round-off.
#[test]
fn order_is_twice_the_degree() {
    for (p, row) in (1..=3).zip(errors(Form::TwoField)) {
        let last = row.windows(2).rfind(|pair| pair[1] > 1e-12).expect("some errors are above round-off");
        let order = (last[0] / last[1]).log2();
        let wanted = 2.0 * f64::from(p);
        assert!((order - wanted).abs() < 0.05 * wanted, "degree {p}: order {order:.3}");
    }
}

/// Effort: five equilibria, 16 or 17 iterations when written.
#[test]
fn newton_iterations_do_not_depend_on_the_mesh() {
    for order in 3..=8 {
        for elements in [4, 16, 64] {
            let (_, iterations) = force(Form::TwoField, order, elements);
            assert!(iterations <= 21, "order {order}, {elements} elements: {iterations}");
        }
    }
}

//! Order of convergence of the elements, p = 1 to 8.
//!
//! Reference: the same strip on 40 elements of order 8; 60 of order 8 and 50 of order 7 agree with it to 4e-14.
//!
//!     |----- L = 10 nm -----|
//!      _____________________ ^ u = 0.2 nm, P
//!     |_____|____|___|__|_|_|     n elements of order p, graded to the grip and to the free end
//!     =======================
//!
//! Parameters: the paper's section, L = 10 nm; n = 2, 4, … 128, all on one map, so that twice as many are half as long.
//!
//! Expected: with p Gauss points for every term the nodes are as accurate as in Gauss collocation, order 2p: the error of the
//! force falls by 2^(2p) when n doubles, until it is round-off. Orders up to 4 show their order before that; for the others
//! only the error is compared. Why: a quadrature that is short of a point, or a locking element, shows here and nowhere
//! else: its results still converge.

mod common;

use common::paper_strip;
use peelkit::model::Form;
use peelkit::solve::{Condition, NewtonOptions, Observables, Workspace, solve};

/// Relative error of the force, order p = 1 to 8 (rows) on n = 2, 4, 8, 16, 32, 64, 128 elements. Round-off below 1e-13.
#[rustfmt::skip]
const ERRORS: [[f64; 7]; 8] = [
    [1.923e-1, 7.998e-2,  1.848e-2, 4.502e-3,  1.123e-3, 2.805e-4,  7.012e-5],
    [6.172e-2, 1.390e-2,  1.816e-4, 2.201e-5,  1.396e-6, 8.761e-8,  5.481e-9],
    [1.083e-2, 8.795e-4,  8.523e-6, 5.621e-8,  9.834e-10, 1.559e-11, 2.611e-13],
    [1.767e-3, 2.575e-5,  2.239e-7, 6.280e-10, 1.941e-12, 1e-13, 1e-13],
    [1.954e-4, 1.242e-5,  1.260e-8, 9.813e-13, 1e-13, 1e-13, 1e-13],
    [1.926e-5, 1.492e-6,  4.745e-10, 1e-13, 1e-13, 1e-13, 1e-13],
    [2.193e-8, 1.411e-7,  5.763e-12, 1e-13, 1e-13, 1e-13, 1e-13],
    [6.979e-7, 2.930e-9,  1.321e-13, 1e-13, 1e-13, 1e-13, 1e-13],
];

/// Force at u = 0.2 nm, and the Newton iterations of the four steps to it.
fn force(form: Form, order: usize, elements: usize) -> (f64, usize) {
    let problem = paper_strip(10.0, 1.0).problem(form, order);
    let weights = Observables { displacement: 1.0, ..Observables::default() };
    let options = NewtonOptions { tolerance: 1e-13, largest_update: 5.0, most_iterations: 30, exact_slope: false };
    let mut work = Workspace::default();
    let mut at = problem.at_rest(elements);
    let (mut force, mut iterations) = (0.0, 0);
    for target in [0.0, 0.05, 0.1, 0.15, 0.2] {
        let solution = solve(&problem, at, &Condition { weights, target }, &options, &mut work)
            .unwrap_or_else(|error| panic!("order {order}, {elements} elements, u = {target} nm: {error}"));
        at = solution.moved(0.05);
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
    for (p, row) in (1..=4).zip(errors(Form::TwoField)) {
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

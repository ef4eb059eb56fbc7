//! Orders of convergence, and slender rods.
//!
//! Reference: the 45-degree bend under 600 on 24 elements of order 8, and by collocation (`bend`); a cantilever in a
//! closed form of small deflections.
//!
//!     o--o--o--o--o    n elements of order p, p Gauss points for every term
//!
//! Parameters: n = 2, 4, 8, 16, 32; slenderness L/h from 5 to 1e5.
//!
//! Expected: the error of the tip falls by 2^(2p) when n doubles, until it is round-off: orders up to 4 show that, of
//! the others the error is compared. The relative error on a mesh does not grow with the slenderness. Why: as in the
//! plane, a quadrature that is short of a point or an element that locks shows nowhere else.

use super::bend;
use super::setup::{PLAIN, Rod, tip};
use peelkit::beam::{SpatialRestCurve, SpatialStiffness};
use peelkit::solve::{Observables, controlled};

fn tip_of_bend(order: usize, elements: usize) -> [f64; 3] {
    let rod = Rod { order, ..bend::rod(5.0 / 6.0, 1.0 / 6.0, 1.0) };
    let (problem, _) = rod.problem(2, &[]);
    let found = controlled(&problem, problem.initial(elements), Observables::FORCE, &[300.0, 600.0], 1e-12).unwrap();
    tip(&found[1].at)
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    (0..3).map(|i| (one[i] - other[i]).powi(2)).sum::<f64>().sqrt()
}

/// Distance of the tip from where it belongs over the radius, order p = 1 to 8 (rows) on n = 2, 4, 8, 16, 32 elements.
/// Round-off below 1e-13.
#[rustfmt::skip]
const ERRORS: [[f64; 5]; 8] = [
    [3.706e-2, 1.069e-2, 2.797e-3, 7.078e-4, 1.775e-4],
    [3.603e-3, 2.957e-4, 1.979e-5, 1.258e-6, 7.897e-8],
    [1.288e-4, 2.454e-6, 4.059e-8, 6.444e-10, 1.011e-11],
    [2.268e-6, 1.482e-8, 6.929e-11, 2.881e-13, 1e-13],
    [7.428e-8, 1.518e-10, 1.754e-13, 1e-13, 1e-13],
    [2.236e-9, 9.399e-13, 1e-13, 1e-13, 1e-13],
    [3.837e-11, 1e-13, 1e-13, 1e-13, 1e-13],
    [7.000e-13, 1e-13, 1e-13, 1e-13, 1e-13],
];

fn errors() -> Vec<Vec<f64>> {
    let exact = tip_of_bend(8, 24);
    (1..=8).map(|p| (1..=5).map(|k| apart(tip_of_bend(p, 1 << k), exact) / 100.0).collect()).collect()
}

#[test]
fn errors_are_those_of_the_table_and_fall_with_twice_the_order() {
    let errors = errors();
    for (p, (row, table)) in errors.iter().zip(&ERRORS).enumerate() {
        for (k, (&error, &stored)) in row.iter().zip(table).enumerate() {
            let case = format!("order {}, {} elements: {error:.3e}, was {stored:.3e}", p + 1, 2 << k);
            assert!(error < 1.25 * stored + 1e-13, "{case}");
            assert!(error > 0.8 * stored - 2e-13, "{case}: better than it can be");
        }
    }
    for (p, row) in (1..=4).zip(&errors) {
        let last = row.windows(2).rfind(|pair| pair[1] > 5e-12).expect("some errors are above round-off");
        let order = (last[0] / last[1]).log2();
        let wanted = 2.0 * f64::from(p);
        assert!((order - wanted).abs() < 0.06 * wanted, "degree {p}: order {order:.3}");
    }
}

/// The error of the tip of an arc of 60 degrees under a force across and in its plane, over the deflection, on four
/// elements.
fn of_an_arc(order: usize, slenderness: f64) -> f64 {
    let height = 1.0 / slenderness;
    let second = height.powi(4) / 12.0;
    // E = 1/I, so that bending is as stiff at every slenderness
    let (e, g) = (1.0 / second, 0.4 / second);
    let area = height * height;
    let stiffness =
        SpatialStiffness::diagonal(e * area, [g * area * 5.0 / 6.0; 2], 0.1406 * height.powi(4) * g, [1.0; 2]);
    let rest = SpatialRestCurve { start: [0.0; 3], directors: PLAIN, curvature: [0.0, 0.0, 1.0] };
    let moved = |order: usize, elements: usize| {
        let rod = Rod { order, ..Rod::clamped(stiffness, rest, 1.0) };
        let load = |share: f64| [[0.0, 0.5 * share, 0.7 * share], [0.0; 3]];
        tip(&rod.under(elements, load, 1.0, &[1.0])[0].0)
    };
    let exact = moved(8, 8);
    apart(moved(order, 4), exact) / apart(exact, rest.at(1.0).0)
}

#[test]
fn slender_rods_do_not_lock() {
    for order in 1..=4 {
        let thick = of_an_arc(order, 20.0);
        for slenderness in [5.0, 100.0, 1e3, 1e4, 1e5] {
            let error = of_an_arc(order, slenderness);
            // round-off grows with the ratio of the stiffnesses, 12 (L/h)²
            let most = 1.3 * thick + f64::EPSILON * slenderness * slenderness;
            assert!(error < most, "order {order}, L/h = {slenderness}: {error:.2e}, at 20 {thick:.2e}");
        }
    }
}

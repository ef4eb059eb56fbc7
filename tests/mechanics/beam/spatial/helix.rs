//! A straight rod wound up into ten windings by a moment, with a force that pulls them apart.
//!
//! Reference: A. Ibrahimbegović, Comput. Methods Appl. Mech. Eng. 149 (1997), for the case; digits:
//! verification/space_benchmarks.csv.
//!
//!     ///o=========================o) m(L) = 200 π l e_z, n(L) = 50 l e_z: both keep their directions
//!          L = 10, EI = GJ = 100, EA = GA = 1e4                          l from 0 to 1
//!
//! Expected: the tip to 2e-10 at l = 0.1, 0.2, 0.5 and 1, 24 elements of order 7. Why: rotations far beyond a turn,
//! and a moment without a potential: its tangent is not symmetric, and what is left off there shows in the number of
//! iterations.

use super::setup::{Rod, assert_close, tabulated_tip, tip};
use peelkit::beam::{SpatialRestCurve, SpatialStiffness};
use std::f64::consts::PI;

#[test]
fn ten_windings() {
    let stiffness = SpatialStiffness::diagonal(1e4, [1e4; 2], 100.0, [100.0; 2]);
    let rod = Rod::clamped(stiffness, SpatialRestCurve::along_x(0.0), 10.0);
    let targets = [0.1, 0.2, 0.5, 1.0];
    let load = |l: f64| [[0.0, 0.0, 50.0 * l], [0.0, 0.0, 200.0 * PI * l]];
    for ((at, iterations), target) in rod.under(24, load, 1e-3, &targets).into_iter().zip(targets) {
        assert_close(&tip(&at), &tabulated_tip("helix", target), 2e-10, &format!("l = {target}"));
        assert!(iterations < 1200, "l = {target}: {iterations} iterations");
    }
}

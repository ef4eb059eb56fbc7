//! The 45-degree bend: an eighth of a circle, clamped, with a force across its plane at the end.
//!
//! Reference: K.-J. Bathe, S. Bolourchi, Int. J. Numer. Methods Eng. 14 (1979); J. C. Simo, L. Vu-Quoc, Comput.
//! Methods Appl. Mech. Eng. 58 (1986): the tip at (15.79, 47.23, 53.37) with eight straight elements, axes y, x, z
//! here. Digits: verification/space_benchmarks.csv.
//!
//!        z  /| 600          radius 100, section 1 × 1, E = 1e7, G = 5e6
//!        | / o tip
//!        |/ .               shear correction k and torsion constant J as in the name of the case
//!     ///o'---- x
//!
//! Expected: the tip to 2e-10, the error of the table, under 300, 450 and 600, whatever k and J, on eight elements of
//! order 7. Why: bending, torsion and shear of a beam that is curved at rest, all at once; an exact J of the square
//! moves the tip by 0.26, and the published one is 1/6.

use super::setup::{PLAIN, Rod, assert_close, rigid, tabulated_tip, tip};
use peelkit::beam::{SpatialRestCurve, SpatialStiffness};
use peelkit::solve::{Observables, controlled};
use std::f64::consts::FRAC_PI_4;

pub const REST: SpatialRestCurve = SpatialRestCurve { start: [0.0; 3], directors: PLAIN, curvature: [0.0, 0.0, 0.01] };
pub const LOADS: [f64; 3] = [300.0, 450.0, 600.0];
const EXACT: f64 = 0.140_577_014_956_174_7;

/// The bend, with stretching and shear so much more compliant.
pub fn rod(shear_correction: f64, torsion: f64, compliance: f64) -> Rod {
    let (e, g) = (1e7, 5e6);
    let shear = shear_correction * g / compliance;
    let stiffness = SpatialStiffness::diagonal(e / compliance, [shear; 2], g * torsion, [e / 12.0; 2]);
    Rod::clamped(stiffness, REST, 100.0 * FRAC_PI_4)
}

/// The tip under the three loads, and the iterations of all steps to each.
fn tips(rod: &Rod, elements: usize) -> Vec<([f64; 3], usize)> {
    let (problem, _) = rod.problem(2, &[]);
    let found = controlled(&problem, problem.initial(elements), Observables::FORCE, &LOADS, 1e-12).unwrap();
    found.iter().map(|solution| (tip(&solution.at), solution.iterations)).collect()
}

#[test]
fn every_variant_under_every_load() {
    for (case, shear_correction, torsion) in [
        ("bend_k_5/6_J_1/6", 5.0 / 6.0, 1.0 / 6.0),
        ("bend_k_5/6_J_exact", 5.0 / 6.0, EXACT),
        ("bend_k_1_J_1/6", 1.0, 1.0 / 6.0),
        ("bend_k_1_J_exact", 1.0, EXACT),
    ] {
        for (load, (found, iterations)) in LOADS.into_iter().zip(tips(&rod(shear_correction, torsion, 1.0), 8)) {
            assert_close(&found, &tabulated_tip(case, load), 2e-10, &format!("{case} under {load}"));
            assert!(iterations <= 9, "{case} under {load}: {iterations} iterations");
        }
    }
}

#[test]
fn rigid_in_stretching_and_shear() {
    for (k, load) in LOADS.into_iter().enumerate() {
        let found = rigid(1e-2, |compliance| tips(&rod(1.0, 1.0 / 6.0, compliance), 8)[k].0);
        assert_close(&found, &tabulated_tip("bend_rigid_J_1/6", load), 1e-8, &format!("rigid under {load}"));
    }
}

/// What was published came from coarse meshes: within half a per cent of the radius.
#[test]
fn published_values_are_near() {
    let (found, _) = tips(&rod(1.0, 1.0 / 6.0, 1.0), 8)[2];
    for published in [[47.23, 15.79, 53.37], [47.04, 15.55, 53.50]] {
        assert_close(&found, &published, 0.5, "published");
    }
}

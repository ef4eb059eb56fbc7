//! Rods whose strains are the same everywhere: their shapes are known in closed form.
//!
//! Reference: a rod with uniform strains Γ and K has the directors R0 exp(K s) and the axis r0 + R0 ∫ exp(K s)(e1 + Γ)
//! ds. Its section force N and moment M, in the axes of the directors, are in equilibrium where K × N = 0 and K × M +
//! (e1 + Γ) × N = 0. With K0 = (τ0, 0, κ0), K = (τ, 0, κ), N = λ K the second one is linear in λ but for the
//! compliance of stretching and shear.
//!
//!     ///o  .-.  .-.  .-.        n(L) along the axis of the helix, and the moment that carries it there
//!         '-'  '-'  '-'  o ->
//!
//! Parameters: a spring of three windings, radius 1, pitch angle 0.2, wire of diameter 0.2; changed by up to a half in
//! twist and curvature.
//!
//! Expected: the end of the wire to 1e-10; the compliance for small forces to 1e-9 that of Castigliano's theorem, L
//! (R² (cos²α/GJ + sin²α/EI) + sin²α/EA + cos²α/GA); in the limit of a flat, thin spring 8 D³ n/(G d⁴). Why: rest
//! curvature and rest twist, and all six strains at once.

use super::setup::{NO_LOAD, PLAIN, Rod, assert_close, tip, tip_directors};
use peelkit::beam::rotation::{apply, conjugate, cross, dot, logarithm, matrix, product};
use peelkit::beam::{SpatialRestCurve, SpatialStiffness};
use std::f64::consts::PI;

const E: f64 = 2.0e5;
const G: f64 = 0.8e5;
const ANGLE: f64 = 0.2;
const DIAMETER: f64 = 0.2;
const WINDINGS: f64 = 3.0;

/// EA, GA and EI = GJ E/(2G) of the wire.
fn wire(diameter: f64) -> [f64; 4] {
    let area = PI * diameter * diameter / 4.0;
    let second = area * diameter * diameter / 16.0;
    [E * area, 0.9 * G * area, 2.0 * G * second, E * second]
}

/// A spring of radius 1.
fn spring(angle: f64, diameter: f64) -> Rod {
    let [axial, shear, torsion, bending] = wire(diameter);
    let curvature = [angle.sin() * angle.cos(), 0.0, angle.cos().powi(2)];
    let rest = SpatialRestCurve { start: [0.3, -0.2, 0.1], directors: PLAIN, curvature };
    let length = 2.0 * PI * WINDINGS / angle.cos();
    Rod::clamped(SpatialStiffness::diagonal(axial, [shear; 2], torsion, [bending; 2]), rest, length)
}

/// λ, Γ and M of a helix with this K.
fn helix(rod: &Rod, k: [f64; 3]) -> (f64, [f64; 3], [f64; 3]) {
    let c = rod.stiffness.0;
    let rest = rod.rest.curvature;
    let moment = [c[3][3] * (k[0] - rest[0]), 0.0, c[5][5] * (k[2] - rest[2])];
    let strain = |force: f64| [force * k[0] / c[0][0], 0.0, force * k[2] / c[2][2]];
    let mut force = 0.0;
    for _ in 0..50 {
        // the middle component: κ m1 - τ m3 + λ (Γ3 τ - (1 + Γ1) κ) = 0
        let [stretch, _, slide] = strain(force);
        force = (k[2] * moment[0] - k[0] * moment[2]) / ((1.0 + stretch) * k[2] - slide * k[0]);
    }
    (force, strain(force), moment)
}

/// The end of a rod with these uniform strains.
fn end(rod: &Rod, k: [f64; 3], strain: [f64; 3]) -> [f64; 3] {
    let square = dot(k, k);
    let (rate, along) = (square.sqrt(), [1.0 + strain[0], strain[1], strain[2]]);
    let (angle, length) = (rate * rod.length, rod.length);
    let (once, twice) = (cross(k, along), cross(k, cross(k, along)));
    let (first, second) = ((1.0 - angle.cos()) / square, (angle - angle.sin()) / (square * rate));
    let local: [f64; 3] = std::array::from_fn(|i| length * along[i] + first * once[i] + second * twice[i]);
    let turned = apply(&matrix(rod.rest.directors), &local);
    std::array::from_fn(|i| rod.rest.start[i] + turned[i])
}

#[test]
fn a_helix_stays_a_helix() {
    let rod = spring(ANGLE, DIAMETER);
    let rest = rod.rest.curvature;
    for change in [[0.1, 0.05], [-0.1, 0.2], [0.3, -0.4]] {
        let strained = |share: f64| [rest[0] + share * change[0], 0.0, rest[2] + share * change[1]];
        let load = |share: f64| {
            let (k, rest_end) = (strained(share), rod.rest.directors);
            let (force, _, moment) = helix(&rod, k);
            let at = matrix(product(rest_end, peelkit::beam::rotation::exponential(k.map(|k| k * rod.length))));
            [apply(&at, &k.map(|k| k * force)), apply(&at, &moment)]
        };
        let (at, iterations) = rod.under(20, load, 0.02, &[1.0]).remove(0);
        let (_, strain, _) = helix(&rod, strained(1.0));
        let wanted = end(&rod, strained(1.0), strain);
        assert_close(&tip(&at), &wanted, 1e-10 * rod.length, "end");
        assert!(iterations < 320, "{iterations} iterations");
    }
}

/// The work of a wrench on the axis over its force: the compliance.
fn compliance(rod: &Rod) -> f64 {
    let axis = {
        let k = rod.rest.curvature;
        let rate = dot(k, k).sqrt();
        k.map(|k| k / rate)
    };
    let (rest_end, rest_directors) = rod.rest.at(rod.length);
    // from the end of the wire to the axis, on the side of its normal
    let normal = apply(&matrix(rest_directors), &[0.0, 1.0, 0.0]);
    let moved = |force: f64| {
        let pull = axis.map(|a| force * a);
        let rod = Rod { load: [pull, cross(normal, pull)], ..rod.clone() };
        let (at, _) = rod.under(24, |share| if share == 0.0 { NO_LOAD } else { rod.load }, 1.0, &[1.0]).remove(0);
        let turn = logarithm(product(tip_directors(&at), conjugate(rest_directors)));
        let carried = cross(turn, normal);
        let place = tip(&at);
        (0..3).map(|i| axis[i] * (place[i] - rest_end[i] + carried[i])).sum::<f64>()
    };
    let slope = |force: f64| (moved(force) - moved(-force)) / (2.0 * force);
    let force = 1e-4 * rod.stiffness.0[5][5];
    (4.0 * slope(0.5 * force) - slope(force)) / 3.0
}

#[test]
fn the_compliance_for_small_forces() {
    let rod = spring(ANGLE, DIAMETER);
    let [axial, shear, torsion, bending] = wire(DIAMETER);
    let (cos, sin) = (ANGLE.cos().powi(2), ANGLE.sin().powi(2));
    let wanted = rod.length * (cos / torsion + sin / bending + sin / axial + cos / shear);
    let found = compliance(&rod);
    assert!((found / wanted - 1.0).abs() < 1e-9, "{found} and {wanted}");
}

/// A flat spring of thin wire: what the pitch and the thickness add falls with their squares.
#[test]
fn the_limit_of_a_flat_thin_spring() {
    let off = |share: f64| {
        let (angle, diameter) = (share * ANGLE, share * DIAMETER);
        let textbook = 8.0 * 2f64.powi(3) * WINDINGS / (G * diameter.powi(4));
        compliance(&spring(angle, diameter)) / textbook - 1.0
    };
    let (coarse, fine) = (off(0.2), off(0.1));
    assert!(fine.abs() < 1e-3 && (coarse / fine - 4.0).abs() < 0.02, "{coarse:e} and {fine:e}");
}

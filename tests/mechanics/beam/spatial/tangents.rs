//! The residual, the tangent and the solves with it, of every order.
//!
//! Reference: differences of the energy and of the residual along directions, of the eighth order in the step. A
//! node's turn is a vector φ in the axes of its directors, q(φ) = q ∘ exp(φ/2), and the tangent the second derivative
//! along it. The residual g of a state that is turned by φ is that by turns from there; so K φ = dg + ½ φ × g, but for
//! angles, which are numbers that add up.
//!
//!     |=====|=====|=====|   three elements, curved and twisted at rest, far from rest
//!     held or free          free, or with angles; a force and a moment that keep their directions
//!
//! Parameters: stiffnesses that couple all strains, rest curves, states and right-hand sides at random (a fixed seed);
//! orders 1 to 8.
//!
//! Expected: to 1e-9 of the largest number. Solves with the transposed tangent are those whose products with the
//! others agree, c·K⁻¹b = b·K⁻ᵀc. Why: Newton's method forgives a tangent that is a little wrong, and then its updates
//! fall linearly; branching points do not.

use super::setup::{NO_LOAD, Numbers, Rod, block_solved};
use peelkit::adhesion::{HalfSpace, Law, LineLaw, LineLoad, SectionShape, SpatialSection};
use peelkit::beam::rotation::cross;
use peelkit::beam::{EndRotation, SpatialBeam, SpatialProfile, SpatialRestCurve, SpatialStiffness};
use peelkit::solve::{Coefficients, State, System, Workspace};

const WEIGHTS: [f64; 2] = [0.7, 0.3];
const MOST_OFF: f64 = 1e-9;

/// The derivative at zero of a function of one number.
fn derivative(step: f64, of: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = vec![0.0; of(0.0).len()];
    for (k, weight) in weights.into_iter().enumerate() {
        let (ahead, behind) = (of((k + 1) as f64 * step), of(-((k + 1) as f64) * step));
        for i in 0..sum.len() {
            sum[i] += weight * (ahead[i] - behind[i]) / step;
        }
    }
    sum
}

/// What a place and an angle are moved by: where it adheres, little.
fn step(beam: &SpatialBeam) -> f64 {
    if beam.adheres() { 2e-3 } else { 0.02 }
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, number| number.abs().max(most))
}

#[track_caller]
fn assert_equal(found: &[f64], wanted: &[f64], what: &str) {
    let size = largest(wanted);
    for (k, (found, wanted)) in found.iter().zip(wanted).enumerate() {
        assert!((found - wanted).abs() <= MOST_OFF * size, "{what}, number {k}: {found} and {wanted}, of {size}");
    }
}

fn moved(beam: &SpatialBeam, at: &State, direction: &[f64], by: f64) -> State {
    let mut at = at.clone();
    beam.retract(&mut at, direction, by);
    at
}

/// K times a direction, by differences of the residual.
fn tangent_times(beam: &SpatialBeam, at: &State, direction: &[f64]) -> Vec<f64> {
    let mut product = derivative(step(beam), |s| beam.residual(&moved(beam, at, direction, s)));
    let residual = beam.residual(at);
    let nodes = direction.len() / 6;
    for node in 0..nodes {
        let end = if node == 0 { Some(0) } else { (node + 1 == nodes).then_some(1) };
        if end.is_some_and(|end| beam.chain.ends[end].rotation == EndRotation::Angles) {
            continue;
        }
        let part = |of: &[f64]| [of[6 * node + 3], of[6 * node + 4], of[6 * node + 5]];
        let turned = cross(part(direction), part(&residual));
        (0..3).for_each(|i| product[6 * node + 3 + i] += 0.5 * turned[i]);
    }
    product
}

/// A direction whose largest number is one.
fn unit(numbers: &mut Numbers, count: usize) -> Vec<f64> {
    let direction = numbers.several(count);
    let size = largest(&direction);
    direction.iter().map(|number| number / size).collect()
}

fn agrees(beam: &SpatialBeam, amount: f64, seed: u64) {
    let mut numbers = Numbers(seed);
    let rest = beam.stress_free(3);
    let count = beam.unknowns(&rest);
    let direction: Vec<f64> = numbers.several(count).iter().map(|number| amount * number).collect();
    let at = moved(beam, &rest, &direction, 1.0);
    first_derivatives(beam, &at, &mut numbers);
    // what does not adhere moves for nothing along an axis on which nothing holds it: its tangent is singular
    let held = beam.chain.held_left[..3].iter().all(Option::is_some);
    if held || beam.chain.density.adhesion.is_some() {
        solves(beam, &at, &mut numbers);
    }
}

/// Of the energy, less the work of the dead load, and of what is monitored.
fn first_derivatives(beam: &SpatialBeam, at: &State, numbers: &mut Numbers) {
    let count = beam.unknowns(at);
    let still = vec![0.0; count];
    let residual = beam.residual(at);
    let gradient = beam.gradient(at, WEIGHTS);
    let [force, moment] = beam.chain.ends[1].dead_load;
    for _ in 0..3 {
        let mut along = unit(numbers, count);
        // rows of what is held say how far it is off
        (0..6).filter(|&f| beam.chain.held_left[f].is_some()).for_each(|f| along[f] = 0.0);
        let rates = derivative(step(beam), |s| {
            let there = moved(beam, at, &along, s);
            let evaluation = beam.evaluate(&there, &still).0;
            let from = there.values.len() - 13;
            let work: f64 = (0..3).map(|i| force[i] * there.values[from + i]).sum();
            let [front, tip] = evaluation.monitors;
            let roll = beam.roll(&there).map_or(f64::NAN, |roll| roll.angle);
            vec![evaluation.energy - work, front, tip, evaluation.recorded, roll]
        });
        let product = |of: &[f64]| of.iter().zip(&along).map(|(a, b)| a * b).sum::<f64>();
        if moment == [0.0; 3] {
            assert_equal(&[product(&residual)], &[rates[0]], "the residual along a direction");
        }
        let (_, told) = beam.evaluate(at, &along);
        let at_end = std::array::from_fn(|slot| along[count - 6 + slot]);
        let roll = beam.roll(at).map_or(f64::NAN, |roll| roll.along(&at_end));
        let told = [told.monitors[0], told.monitors[1], told.recorded, roll];
        let size = largest(&rates[1..]).max(0.1);
        for (told, rate) in told.iter().zip(&rates[1..]) {
            assert!((told - rate).abs() <= MOST_OFF * size, "rates {told} and {rate}");
        }
        let weighed = WEIGHTS[0] * rates[1] + WEIGHTS[1] * rates[2];
        assert!((product(&gradient) - weighed).abs() <= MOST_OFF * size, "{} and {weighed}", product(&gradient));
    }
}

fn solves(beam: &SpatialBeam, at: &State, numbers: &mut Numbers) {
    let count = beam.unknowns(at);
    let mut ws = Workspace::default();
    let condensed = beam.factorise(at, Coefficients::STATIC, WEIGHTS, &mut ws).unwrap();
    // plain and transposed
    let mut solved = |transposed: bool| {
        let right = numbers.several(count);
        let mut x = right.clone();
        let left = beam.reduce(&ws, &mut x, transposed);
        beam.substitute(&ws, &block_solved(&condensed.matrix, &left, transposed), &mut x, transposed);
        (right, x)
    };
    let (b, x) = solved(false);
    let size = largest(&x);
    let unit: Vec<f64> = x.iter().map(|number| number / size).collect();
    let back: Vec<f64> = tangent_times(beam, at, &unit).iter().map(|number| size * number).collect();
    let scale = largest(&tangent_times(beam, at, &unit)).max(1.0) * size.max(1.0);
    for (k, (back, b)) in back.iter().zip(&b).enumerate() {
        assert!((back - b).abs() <= MOST_OFF * scale, "K x, number {k}: {back} and {b}, of {scale}");
    }
    let (c, y) = solved(true);
    let (one, other): (f64, f64) = (dot(&c, &x), dot(&b, &y));
    let size = largest(&x).max(largest(&y)) * count as f64;
    assert!((one - other).abs() <= 1e-11 * size, "c·K⁻¹b {one} and b·K⁻ᵀc {other}, of {size}");
    // the way back with what elimination took along, and what it left of the functional
    let interface = [0.1, -0.2, 0.05, 0.02, -0.01, 0.03];
    let mut along = vec![0.0; count];
    beam.recover(&ws, &interface, -1.0, &mut along);
    let (product, residual) = (tangent_times(beam, at, &along), beam.residual(at));
    let last = count - 6;
    let mut wanted: Vec<f64> = residual.iter().map(|number| -number).collect();
    for i in 0..6 {
        let taken: f64 = (0..6).map(|j| condensed.matrix[i][j] * interface[j]).sum();
        wanted[last + i] += taken + condensed.residual[i];
    }
    assert_equal(&product, &wanted, "K times the way back");
    let change = dot(&beam.gradient(at, WEIGHTS), &along);
    let told = dot(&condensed.gradient, &interface) + condensed.gradient_residual;
    assert!((change - told).abs() <= 1e-11 * largest(&along) * count as f64, "{change} and {told}");
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn a_coupled_rod_that_is_curved_and_twisted_at_rest() {
    let mut numbers = Numbers(7);
    let rest =
        SpatialRestCurve { start: [0.1, 0.2, -0.3], directors: [0.5, 0.5, -0.5, 0.5], curvature: [0.3, -0.2, 0.5] };
    let force = [[0.3, -0.2, 0.5], [0.0; 3]];
    let both = [force[0], [-0.4, 0.7, 0.2]];
    let free = [false; 6];
    let (mixed, sliding) = ([true, true, true, true, false, true], [true, false, true, true, false, true]);
    for order in 1..=8 {
        let amount = if order < 5 { 0.2 } else { 0.05 };
        for rotation in [EndRotation::Free, EndRotation::Angles] {
            for (held_left, load) in
                [([true; 6], NO_LOAD), (mixed, force), (free, both), (mixed, both), (sliding, both)]
            {
                let stiffness = numbers.stiffness();
                let rod = Rod { order, held_left, rotation, load, ..Rod::clamped(stiffness, rest, 3.0) };
                agrees(&rod.beam(), amount, 3 + order as u64);
            }
        }
    }
}

/// A strip that is tilted both ways near the ground.
#[test]
fn a_strip_that_adheres() {
    let half_space = HalfSpace { hamaker_constant: 0.1, equilibrium_distance: 0.4 };
    let law = LineLaw { half_space, height: 10.0, law: Law::BodyForce, line_load: LineLoad::Full, far_face: true };
    let rest = SpatialRestCurve::along_x(6.5);
    let stiffness = SpatialStiffness::diagonal(1.0, [0.5, 0.4], 3.0, [2.0, 4.0]);
    for (shape, width) in [(SectionShape::Rectangle, 4.0), (SectionShape::Ellipse, 6.0)] {
        let section = SpatialSection::new(shape, width, law).unwrap();
        for order in 1..=8 {
            for rotation in [EndRotation::Free, EndRotation::Angles] {
                let held_left = [true, false, true, false, true, false];
                let rod = Rod { order, held_left, rotation, ..Rod::clamped(stiffness, rest, 12.0) };
                let mut beam = rod.beam();
                beam.chain.density.profile = SpatialProfile::uniform(stiffness, width, 10.0);
                beam.chain.density.adhesion = Some(section);
                beam.rest_adhesion = -1.0;
                agrees(&beam, 0.02, 5 + order as u64);
            }
        }
    }
}
